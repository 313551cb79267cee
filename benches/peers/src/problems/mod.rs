mod ball;
mod block;
mod cradle;
mod model_b;

pub(crate) use ball::Ball;
pub(crate) use block::{Block, Mode as BlockMode};
pub(crate) use cradle::Cradle;
#[cfg(test)]
pub(crate) use model_b::Mode as ModelBMode;
pub(crate) use model_b::ModelB;
