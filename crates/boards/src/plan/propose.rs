//! The richest packing that a bus can carry at the wanted rates, or the rates that it can carry.

use super::{BusPlan, BusVerdict, ForcePacking, SamplePacking, verdict::WARN};

/// All valid packings (slopes need velocities), by their information on each key. Of two equals,
/// one whose force depends on the key's own position is first, then one for a single board.
const RICHEST_FIRST: [(SamplePacking, ForcePacking); 10] = [
    (SamplePacking::Position24Velocity, ForcePacking::Force16Slope),
    (SamplePacking::Position16Velocity, ForcePacking::Force16Slope),
    (SamplePacking::Position24Velocity, ForcePacking::Force16),
    (SamplePacking::Position24Velocity, ForcePacking::Multicast16),
    (SamplePacking::Position16Velocity, ForcePacking::Force16),
    (SamplePacking::Position16Velocity, ForcePacking::Multicast16),
    (SamplePacking::Position24, ForcePacking::Force16),
    (SamplePacking::Position24, ForcePacking::Multicast16),
    (SamplePacking::Position16, ForcePacking::Force16),
    (SamplePacking::Position16, ForcePacking::Multicast16),
];

/// Capacity of a bus for a plan.
#[derive(Clone, PartialEq, Debug)]
pub enum Proposal {
    /// The wanted rates, with the richest packing for them.
    AsWanted(BusPlan),
    /// The leanest packing, at the highest rates for it.
    Slower {
        plan: BusPlan,
        /// Number of such buses for the wanted rates; `None` if one board is too much for one bus.
        buses: Option<usize>,
    },
}

impl BusPlan {
    /// Returns the capacity of this bus for the plan, with any packing.
    ///
    /// The richest packing with room to spare, else the leanest, if necessary at lower rates.
    pub fn propose(&self) -> Proposal {
        let roomy = self.candidates().find(|it| it.verdict() == BusVerdict::Fits);
        roomy.map_or_else(|| self.leanest(), Proposal::AsWanted)
    }

    fn leanest(&self) -> Proposal {
        let by_load = |one: &Self, other: &Self| one.load().total_cmp(&other.load());
        let plan = self.candidates().min_by(by_load).unwrap_or_else(|| self.clone());
        if plan.verdict() == BusVerdict::Refused {
            let buses = plan.buses_needed();
            Proposal::Slower { plan: plan.slowed(), buses }
        } else {
            Proposal::AsWanted(plan)
        }
    }

    /// Returns the plan at the highest whole rates with room to spare; below 1 Hz, not whole.
    fn slowed(self) -> Self {
        let factor = self.stretch(WARN);
        let slowed = |rate: f64| {
            let rate = rate * factor;
            if rate < 1.0 { rate } else { rate.floor() }
        };
        Self { sample_rate: slowed(self.sample_rate), force_rate: slowed(self.force_rate), ..self }
    }

    fn candidates(&self) -> impl Iterator<Item = Self> {
        let all = self.medium.reaches_all();
        RICHEST_FIRST
            .into_iter()
            .filter(move |(_, forces)| all || *forces != ForcePacking::Multicast16)
            .map(|(samples, forces)| Self { samples, forces, ..self.clone() })
    }

    /// Returns the fewest such buses with room to spare; `None` if one board is too much for one.
    pub fn buses_needed(&self) -> Option<usize> {
        (1..=self.boards.len()).find(|buses| {
            let most = self.boards.len().div_ceil(*buses);
            self.boards.chunks(most).all(|boards| {
                let part = Self { boards: boards.to_vec(), ..self.clone() };
                part.verdict() == BusVerdict::Fits
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{Extras, Medium, standard};

    fn wanted(rate: f64) -> BusPlan {
        BusPlan {
            name: "can0".to_owned(),
            medium: Medium::CanFd { nominal: 1_000_000, data: 5_000_000 },
            boards: standard(0..8),
            samples: SamplePacking::Position16,
            forces: ForcePacking::Force16,
            sample_rate: rate,
            force_rate: rate,
            extras: Extras::default(),
        }
    }

    #[track_caller]
    fn check(rate: f64, samples: SamplePacking, forces: ForcePacking) {
        let Proposal::AsWanted(plan) = wanted(rate).propose() else {
            panic!("{rate} Hz is too much");
        };
        assert_eq!((plan.samples, plan.forces), (samples, forces), "{rate} Hz");
    }

    #[test]
    fn the_higher_the_rate_the_leaner_the_packing() {
        check(250.0, SamplePacking::Position24Velocity, ForcePacking::Force16Slope);
        check(310.0, SamplePacking::Position16Velocity, ForcePacking::Force16Slope);
        check(360.0, SamplePacking::Position24Velocity, ForcePacking::Multicast16);
        check(500.0, SamplePacking::Position16, ForcePacking::Multicast16);
    }

    #[test]
    fn too_much_becomes_slower_and_says_how_many_buses_it_takes() {
        let Proposal::Slower { plan, buses } = wanted(1_000.0).propose() else {
            panic!("1000 Hz fit");
        };
        assert_eq!(
            (plan.samples, plan.forces),
            (SamplePacking::Position16, ForcePacking::Multicast16)
        );
        assert_eq!((plan.verdict(), buses), (BusVerdict::Fits, Some(3)));
        let faster = BusPlan { sample_rate: plan.sample_rate + 5.0, ..plan };
        assert_eq!(faster.verdict(), BusVerdict::Tight);
    }

    #[test]
    fn what_one_board_is_too_much_for_no_number_of_buses_carries() {
        let Proposal::Slower { buses, .. } = wanted(10_000.0).propose() else {
            panic!("10 kHz fit");
        };
        assert_eq!(buses, None);
    }

    #[test]
    fn a_link_to_one_board_is_not_offered_frames_for_all() {
        let usb = BusPlan { medium: Medium::UsbFullSpeed, ..wanted(1_000.0) };
        assert!(usb.candidates().all(|it| it.forces != ForcePacking::Multicast16));
    }
}
