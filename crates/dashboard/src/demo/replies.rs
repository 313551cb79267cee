//! How the demonstration answers.

use telemetry::request::Change;
use telemetry::{Event, Reply, Request, Update, event};

use super::{Demo, catalogue};
use crate::names;

impl Demo {
    pub(super) fn answer(&mut self, request: Request) -> Result<Reply, String> {
        match request {
            Request::Set { changes } => self.set(&changes),
            Request::UseInstrument { instrument, keys } => {
                self.use_instrument(&instrument, keys.as_deref())
            }
            Request::Render { settings } => {
                Ok(done(&format!("{} settings changed.", settings.len())))
            }
            Request::Load { description, .. } => Err(format!("There is no {description} here.")),
            Request::Stop {} => {
                self.is_stopped = true;
                let text = "No force on any key.".to_owned();
                Ok(Reply::Stopped { text, told: 8, boards: 8 })
            }
            Request::Press { key, newtons } => self.press(key, newtons),
            Request::Margin { .. } => Ok(done("C4 is stable, up to 2 times its force")),
            // A hand of 400 N/m on a key of 10 mm.
            Request::Grip { key, depth } => {
                self.press(key, 4.0 * depth.unwrap_or_default().max(0.0))
            }
            Request::Identify { line, board } => {
                self.send_board(&format!("board {board} of line {line} shows its light"));
                Ok(done("It shows its light."))
            }
            Request::Where {} | Request::Status {} => Err("The demonstration is nowhere.".into()),
            Request::Scene {} => Ok(Reply::Scene { toml: catalogue::scene_text() }),
            Request::Record { file: Some(file) } => Ok(done(&format!("Records to {file}."))),
            Request::Record { file: None } => Ok(done("Records no more.")),
        }
    }

    fn send_board(&mut self, text: &str) {
        let kind = event::Kind::Board.into();
        let (tick, text) = (self.tick, text.to_owned());
        self.send(Update::Event(Event { kind, tick, key: 255, text, ..Event::default() }));
    }

    /// Sets all values or none.
    fn set(&mut self, changes: &[Change]) -> Result<Reply, String> {
        let check = |change: &Change| {
            let Some((_, parameter)) = catalogue::parameter(&change.parameter) else {
                return Err(format!("No parameter is called {}.", change.parameter));
            };
            if self.keys.len() <= usize::from(change.key) {
                return Err(format!("{} is no key.", change.key));
            }
            if (parameter.min..=parameter.max).contains(&change.value) {
                return Ok(());
            }
            Err(format!("{} goes from {} to {}.", parameter.name, parameter.min, parameter.max))
        };
        changes.iter().try_for_each(check)?;
        for change in changes {
            if let Some((i, _)) = catalogue::parameter(&change.parameter) {
                let played = &mut self.keys[usize::from(change.key)];
                played.values[i] = change.value;
                played.revision += 88;
                self.send_voice(change.key);
            }
        }
        Ok(done(&format!("{} values changed.", changes.len())))
    }

    fn use_instrument(&mut self, instrument: &str, keys: Option<&str>) -> Result<Reply, String> {
        let range = names::range(keys.unwrap_or("all"));
        let range = range.ok_or("That is no range of keys: write C4..B5.")?;
        for key in range {
            let played = &mut self.keys[usize::from(key)];
            instrument.clone_into(&mut played.instrument);
            played.values = catalogue::values(instrument, key);
            played.revision += 88;
            self.send_voice(key);
        }
        Ok(done("Another instrument."))
    }

    fn press(&mut self, key: u8, newtons: f64) -> Result<Reply, String> {
        let played = self.keys.get_mut(usize::from(key)).ok_or("That is no key.")?;
        played.pressed = newtons;
        Ok(done("Pressed."))
    }
}

fn done(text: &str) -> Reply {
    Reply::Done { text: text.to_owned() }
}
