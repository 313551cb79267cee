//! Does one check with every model by hand.

/// Calls the generic function `check` with each model, which has the values of its default preset.
macro_rules! with_all {
    ($check:ident) => {{
        $check(hand_written::KeyHammerSprings::default());
        $check(hand_written::KeyHammerRigid::default());
        $check(hand_written::ReducedGrand::default());
        $check(hand_written::BouncingBall::default());
        $check(hand_written::CartPendulum::default());
        $check(hand_written::SpringWall::default());
    }};
}

pub(crate) use with_all;
