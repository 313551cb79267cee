//! Why something that came is not understood.

/// Why a text or some bytes are no message of the protocol.
#[derive(Debug, thiserror::Error)]
pub enum ProtocolError {
    /// A text that is no JSON, or no message's.
    #[error("what came is no message of the protocol: {0}")]
    Json(#[from] serde_json::Error),
    #[error("an empty message came, which says nothing")]
    Empty,
    /// A binary message of another kind.
    #[error("a binary message came with opcode {0}, which nobody here reads")]
    Opcode(u8),
    /// A binary message that ends too soon.
    #[error("a binary message with opcode {opcode} came with {bytes} bytes, which is too short")]
    Short {
        /// What it says that it is.
        opcode: u8,
        bytes: usize,
    },
    /// A binary message whose encoding has no readable name.
    #[error("a binary message came whose encoding is no text")]
    Encoding,
}
