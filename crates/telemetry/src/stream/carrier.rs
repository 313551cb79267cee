//! What carries a connection: bytes both ways, encrypted or not.

use tokio::io::{AsyncRead, AsyncWrite};

/// Bytes both ways.
pub(crate) trait ByteStream: AsyncRead + AsyncWrite + Send + Unpin {}

impl<T: AsyncRead + AsyncWrite + Send + Unpin> ByteStream for T {}

/// Any carrier.
pub(crate) type Boxed = Box<dyn ByteStream>;
