//! A board's log: short lines, the oldest first.

record! {
    /// Asks for a line of the log.
    ReadLog {
        /// Its number, from 0.
        line: u16,
    }
}

record! {
    /// A line of the log.
    LogLine {
        /// How many lines there are by now.
        lines: u16,
        /// When it was written (us).
        board_us: u32,
        /// UTF-8, filled with zeros.
        text: [u8; 48],
    }
}
