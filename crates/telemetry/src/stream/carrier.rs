//! What carries a connection: bytes both ways, encrypted or not.

use tokio::io::{AsyncRead, AsyncWrite};

/// Bytes both ways.
pub(crate) trait Carrier: AsyncRead + AsyncWrite + Send + Unpin {}

impl<T: AsyncRead + AsyncWrite + Send + Unpin> Carrier for T {}

/// Any carrier.
pub(crate) type Boxed = Box<dyn Carrier>;
