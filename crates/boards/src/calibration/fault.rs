use crate::untaken::UntakenForces;

/// Reason why a key could not be measured, with the remedy.
#[derive(Clone, Copy, PartialEq, Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the sentences say it")]
pub enum CalibrationFault {
    #[error("it was stopped")]
    Stopped,
    #[error("no samples came for {seconds} s; see its board's cable")]
    Silent { seconds: f64 },
    #[error(
        "frames were late or lost in the middle; calibrate again while the machine does nothing else"
    )]
    Interrupted,
    #[error(
        "its readings spread over {:.0} um at rest, and {:.0} um is the most; see its sensor, \
         and let nobody touch it", 1e6 * spread, 1e6 * most
    )]
    Noisy { spread: f64, most: f64 },
    #[error(
        "it does not move under {push:.1} N; see whether its motor's wires are exchanged, whether it \
         is connected and has power, whether the key jams, and whether its sensor is stuck"
    )]
    Stuck { push: f64 },
    #[error("it does not move, since its board takes no force{forces}")]
    Untaken { forces: UntakenForces },
    #[error(
        "it moves up when it is pushed down, to a reading of {:.1} mm; exchange its motor's \
         wires, or turn its sensor", 1e3 * position
    )]
    Backwards { position: f64 },
    #[error(
        "its readings run away to {:.1} mm, and a key goes {:.0} mm at most; see its sensor",
        1e3 * position, 1e3 * most
    )]
    RunsAway { position: f64, most: f64 },
    #[error("its reading jumps by {:.1} mm at once; see its sensor's cable", 1e3 * by)]
    Jumps { by: f64 },
    #[error(
        "it goes down {:.1} mm only, and a key goes {:.0} mm at least; see what is in its way",
        1e3 * travel, 1e3 * least
    )]
    Short { travel: f64, least: f64 },
    #[error(
        "it does not come back from {:.1} mm when it is pushed up with {push:.1} N; see whether \
         it jams", 1e3 * position
    )]
    Stays { position: f64, push: f64 },
    #[error(
        "the weight does not press it down: it stands at {:.1} mm; take a heavier one",
        1e3 * position
    )]
    Floats { position: f64 },
    #[error(
        "its motor would have a gain of {gain:.2}, and {least} to {most} is possible; see whether \
         the weight is the one that was given"
    )]
    Gain { gain: f64, least: f64, most: f64 },
    #[error("it still moves after {seconds} s; see whether anything shakes or touches it")]
    Restless { seconds: f64 },
}
