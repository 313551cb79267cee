//! A board's log: short lines, the oldest first.

record! {
    /// Asks for a line of the log.
    ReadLog {
        /// Number of the line, from 0.
        line: u16,
    }
}

record! {
    /// A line of the log.
    LogLine {
        /// Number of lines that there are now.
        lines: u16,
        /// Time at which the line was written (us).
        board_us: u32,
        /// UTF-8, filled with zeros.
        text: [u8; 48],
    }
}
