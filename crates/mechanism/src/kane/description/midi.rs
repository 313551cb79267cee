//! MIDI settings of strikes and of the key's force.

use documents::toml::{self, KeyReader};
use documents::{choice, quoted};
use instruments::equations::table::{MidiTable, PressureKind, PressureTable};

use super::reader::MechanismReader;
use crate::kane::text::Dimension;

const PRESSURES: [(&str, PressureKind); 2] =
    [("channel", PressureKind::Channel), ("key", PressureKind::Key)];

impl MechanismReader {
    pub(super) fn midi(&mut self, root: &mut KeyReader<'_>) {
        let Some(entry) = root.take("midi") else { return };
        let Some(mut keys) = KeyReader::new(&mut self.report, entry) else { return };
        let velocity = self.velocity(&mut keys);
        let has_speeds = keys.take("speeds").is_some();
        let speeds =
            if has_speeds { self.rising(&mut keys, "speeds", Dimension::SPEED) } else { None };
        let pressure = self.pressure(&mut keys);
        keys.finish(&mut self.report);
        self.mechanism.instrument.midi = MidiTable { speeds, velocity, pressure };
    }

    fn velocity(&mut self, keys: &mut KeyReader<'_>) -> Option<u8> {
        let entry = keys.take("velocity")?;
        let value = self.constant("velocity", &entry.node, Dimension::NONE)?;
        if !(1.0..=127.0).contains(&value) || value.fract() > 0.0 {
            let message = format!("the velocity is {value}, which no note has");
            self.report.say(entry.place, message, "write a whole number from 1 to 127");
            return None;
        }
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 127")]
        Some(value as u8)
    }

    /// Reads a range above 0.
    fn rising(
        &mut self,
        keys: &mut KeyReader<'_>,
        name: &'static str,
        dimension: Dimension,
    ) -> Option<(f64, f64)> {
        let place = keys.place;
        let (low, high) = self.range(keys, name, "midi", dimension)?;
        if low > 0.0 && low < high {
            return Some((low, high));
        }
        let message = format!("{} does not rise from above 0", quoted(name));
        self.report.say(place, message, "write the smaller value first");
        None
    }

    fn pressure(&mut self, keys: &mut KeyReader<'_>) -> Option<PressureTable> {
        let entry = keys.take("pressure")?;
        let (wanted, _place) = toml::text(&mut self.report, "pressure", &entry.node)?;
        let Some((_, kind)) = PRESSURES.into_iter().find(|(name, _)| *name == wanted) else {
            let message = format!("there is no pressure {}", quoted(wanted));
            self.report.say(entry.place, message, choice(wanted, PRESSURES.map(|it| it.0)));
            return None;
        };
        let range = self.rising(keys, "pressure_range", Dimension::FORCE)?;
        Some(PressureTable { kind, range })
    }
}
