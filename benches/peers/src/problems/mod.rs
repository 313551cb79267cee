//! One file per problem.

mod ball;
mod model_b;

pub(crate) use ball::Ball;
pub(crate) use model_b::ModelB;
