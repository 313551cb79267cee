//! A model as a type of its own does what it does behind calls, to the last bit.

use std::any::type_name;

use models::catalogue::Visitor;
use models::{Playable, built_in};
use pode::State as _;

use crate::stroke::{presses, run, tuned};

/// A stroke and its release, to what is felt tick by tick and the last state, with the name of the
/// model's type.
struct Stroke;

impl Visitor for Stroke {
    type Output = (&'static str, Vec<u64>);

    fn visit<M: Playable>(self, model: M) -> Self::Output {
        let model = tuned(&model, "playable", 39, &[]);
        let depth = 0.01 * model.input_per_metre();
        let input = |t: f64| presses(&[[depth, 0.1, 0.02], [-depth, 0.4, 0.03]], t);
        let (books, simulator) = run(model, model.at_rest(&input(0.0)), (1e-3, 1.0), input);
        assert!(books.events.iter().any(|event| event.name == "string"), "it strikes");
        let felt = books.ticks.iter().flat_map(|tick| [tick.mean_readout, tick.end_readout]);
        let last = simulator.state().entries().iter().copied();
        (type_name::<M>(), felt.chain(last).map(f64::to_bits).collect())
    }
}

#[test]
fn a_type_of_its_own_gives_the_same_bits() {
    for name in ["key-hammer-springs", "key-hammer-rigid"] {
        let model = built_in::small(name).expect("a small model");
        let (called, expected) = Stroke.visit(model);
        let (own, found) = built_in::visit_by_type(model, Stroke);
        assert_ne!(own, called, "{name} has a type of its own");
        assert_eq!(found, expected, "{name}");
    }
}
