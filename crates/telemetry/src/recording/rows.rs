use crate::KeyBlock;

/// One tick of a key; see [`KeyBlock`] for the fields.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Row<'a> {
    pub tick: u64,
    /// Displacement of the key's front (m).
    pub position: f64,
    pub age: u32,
    /// Ticks since the sample was taken, less the usual transport time.
    pub taken: f64,
    /// Force of the voice (N).
    pub force: f64,
    /// Force sent to the board (N).
    pub sent: f64,
    /// Mode after the tick.
    pub mode: u8,
    /// Bits as in `KeyBlock.flags`.
    pub flags: u8,
    pub fault: u8,
    /// Revision of the voice that computed it.
    pub revision: u32,
    /// The model's signals after the tick.
    pub signals: &'a [f32],
}

/// Returns the rows of `block`; `width` returns the number of signals of a revision's voice. A
/// missing value reads as NaN or 0: blocks come from files and from networks.
pub fn rows<W: FnMut(u32) -> usize>(
    block: &KeyBlock,
    mut width: W,
) -> impl Iterator<Item = Row<'_>> + use<'_, W> {
    let mut signals = block.signals.as_slice();
    block.after.iter().enumerate().map(move |(row, after)| {
        let revision = at(&block.revision, row).unwrap_or(0);
        let (own, rest) = signals.split_at(width(revision).min(signals.len()));
        signals = rest;
        let real = |column: &[f64]| at(column, row).unwrap_or(f64::NAN);
        Row {
            tick: block.tick.saturating_add(u64::from(*after)),
            position: real(&block.position),
            age: at(&block.age, row).unwrap_or(0),
            taken: real(&block.taken),
            force: real(&block.force),
            sent: real(&block.sent),
            mode: at(&block.mode, row).unwrap_or(u8::MAX),
            flags: at(&block.flags, row).unwrap_or(0),
            fault: at(&block.fault, row).unwrap_or(0),
            revision,
            signals: own,
        }
    })
}

fn at<T: Copy>(column: &[T], row: usize) -> Option<T> {
    column.get(row).copied()
}
