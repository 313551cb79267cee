//! The bytes of a connection, encrypted or not.

use tokio::io::{AsyncRead, AsyncWrite};

pub(crate) trait ByteStream: AsyncRead + AsyncWrite + Send + Unpin {}

impl<T: AsyncRead + AsyncWrite + Send + Unpin> ByteStream for T {}

pub(crate) type BoxedStream = Box<dyn ByteStream>;
