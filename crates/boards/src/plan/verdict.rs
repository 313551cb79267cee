//! Verdict on a plan, in one sentence.

use super::BusPlan;

/// Load above which a bus has little left for repeats.
pub const WARN: f64 = 0.70;
/// Load above which a bus is not used.
pub const REFUSE: f64 = 0.80;

/// Verdict on the load of a bus.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BusVerdict {
    Fits,
    /// Above 70 %: repeats after an error delay what comes next.
    Tight,
    /// Above 80 %: forces stay off.
    Refused,
}

impl BusVerdict {
    /// Returns the verdict on a load; NaN is refused.
    pub fn of(load: f64) -> Self {
        if load <= WARN {
            Self::Fits
        } else if load <= REFUSE {
            Self::Tight
        } else {
            Self::Refused
        }
    }
}

impl BusPlan {
    /// Returns the highest rate for samples and forces of all keys (Hz); infinite without boards.
    pub fn max_rate(&self) -> f64 {
        let one = Self { sample_rate: 1.0, force_rate: 1.0, ..self.clone() };
        one.stretch(REFUSE)
    }

    pub fn verdict(&self) -> BusVerdict {
        BusVerdict::of(self.load())
    }

    pub fn sentence(&self) -> String {
        let (what, load) = (self.what(), 100.0 * self.load());
        match self.verdict() {
            BusVerdict::Fits => format!("{what} take {load:.1} % of its time{}", self.arrival()),
            BusVerdict::Tight => format!(
                "{what} take {load:.1} % of its time{}; above {:.0} % a repeated frame delays \
                 others: {}",
                self.arrival(),
                100.0 * WARN,
                self.way_out(WARN)
            ),
            BusVerdict::Refused => format!(
                "{what} would take {load:.1} % of its time, and {:.0} % is the most: {}",
                100.0 * REFUSE,
                self.way_out(REFUSE)
            ),
        }
    }

    fn what(&self) -> String {
        let keys: usize = self.boards.iter().map(|it| it.numbers().len()).sum();
        format!(
            "{} ({}): samples of {keys} keys on {} at {} Hz and forces at {} Hz",
            self.name,
            self.medium,
            count(self.boards.len(), "board", "boards"),
            self.sample_rate,
            self.force_rate
        )
    }

    fn arrival(&self) -> String {
        self.force_response().map_or_else(String::new, |response| {
            format!(", and a force arrives within {:.2} ms", response / 1e3)
        })
    }

    fn way_out(&self, limit: f64) -> String {
        let factor = self.stretch(limit);
        let rate = |rate: f64| (rate * factor).floor();
        let buses = self.buses_needed().filter(|buses| 1 < *buses).map_or_else(
            || "use a faster bus".to_owned(),
            |buses| format!("divide the boards among {buses} buses"),
        );
        format!(
            "lower the rates to {} Hz and {} Hz, choose a leaner packing, or {buses}",
            rate(self.sample_rate),
            rate(self.force_rate)
        )
    }
}

fn count(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::{Extras, ForcePacking, Medium, SamplePacking, standard};

    fn plan(sample_rate: f64, force_rate: f64) -> BusPlan {
        BusPlan {
            name: "can0".to_owned(),
            medium: Medium::CanFd { nominal: 1_000_000, data: 5_000_000 },
            boards: standard(0..8),
            samples: SamplePacking::Position16,
            forces: ForcePacking::Force16,
            sample_rate,
            force_rate,
            extras: Extras::NONE,
        }
    }

    #[test]
    fn seventy_percent_fits_and_eighty_is_tight() {
        use BusVerdict::{Fits, Refused, Tight};
        for (load, verdict) in [(0.7, Fits), (0.701, Tight), (0.8, Tight), (0.801, Refused)] {
            assert_eq!(BusVerdict::of(load), verdict, "{load}");
        }
        assert_eq!(BusVerdict::of(f64::NAN), Refused);
    }

    #[test]
    fn a_plan_that_fits_says_how_full_the_bus_is() {
        assert_eq!(
            plan(500.0, 250.0).sentence(),
            "can0 (CAN FD at 1/5 Mbit/s): samples of 88 keys on 8 boards at 500 Hz and forces \
             at 250 Hz take 62.9 % of its time, and a force arrives within 0.94 ms"
        );
    }

    #[test]
    fn a_tight_plan_says_what_would_make_room() {
        let sentence = plan(450.0, 450.0).sentence();
        assert!(sentence.contains("take 75.5 % of its time"), "{sentence}");
        assert!(sentence.contains("lower the rates to 417 Hz and 417 Hz"), "{sentence}");
    }

    #[test]
    fn a_refused_plan_names_the_bus_the_numbers_and_what_to_do() {
        assert_eq!(
            plan(1_000.0, 1_000.0).sentence(),
            "can0 (CAN FD at 1/5 Mbit/s): samples of 88 keys on 8 boards at 1000 Hz and forces \
             at 1000 Hz would take 167.7 % of its time, and 80 % is the most: lower the rates \
             to 477 Hz and 477 Hz, choose a leaner packing, or divide the boards among 3 buses"
        );
    }
}
