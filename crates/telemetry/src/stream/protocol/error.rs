/// Reason why a text or some bytes are no message of the protocol.
#[derive(Debug, thiserror::Error)]
pub enum ProtocolError {
    /// A text that is not JSON, or not a message's.
    #[error("what came is no message of the protocol: {0}")]
    Json(#[from] serde_json::Error),
    #[error("an empty message came, which says nothing")]
    Empty,
    #[error("a binary message came with opcode {0}, which nobody here reads")]
    Opcode(u8),
    #[error("a binary message with opcode {opcode} came with {bytes} bytes, which is too short")]
    Short { opcode: u8, bytes: usize },
    #[error("a binary message came whose encoding is no text")]
    Encoding,
}
