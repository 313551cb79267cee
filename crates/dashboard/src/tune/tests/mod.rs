use telemetry::{Catalogue, Voice};

use super::*;

const KEY: u8 = 39;
const ALL_KEYS: RangeInclusive<u8> = 0..=87;

const fn following(link: LinkedKeys) -> FollowingKeys {
    FollowingKeys { link, range: ALL_KEYS, fade: 0 }
}

fn voice(key: u8, revision: u32, model: &str, values: &[f64]) -> Update {
    Update::Voice(Voice {
        key: key.into(),
        revision,
        model: model.into(),
        values: values.to_vec(),
        ..Voice::default()
    })
}

/// Creates three keys of a model with k in 0..100 and d in 0..1, each k = 10, d = 0.5.
fn tuner() -> Tuner {
    let parameter = |name: &str, max| Parameter { name: name.into(), max, ..Parameter::default() };
    let parameters = vec![parameter("k", 100.0), parameter("d", 1.0)];
    let model = |name: &str| Model {
        name: name.into(),
        parameters: parameters.clone(),
        ..Model::default()
    };
    let mut tuner = Tuner::default();
    let models = vec![model("spring"), model("other")];
    tuner.take(&Update::Catalogue(Catalogue { models, ..Catalogue::default() }));
    for key in [KEY - 1, KEY, KEY + 1] {
        tuner.take(&voice(key, 1, "spring", &[10.0, 0.5]));
    }
    tuner
}

fn edit(tuner: &mut Tuner, value: f64) {
    tuner.edit((KEY, "k"), value, &following(LinkedKeys::Alone), None);
}

#[track_caller]
fn shows(tuner: &Tuner, value: f64) {
    let shown = tuner.value(KEY, "k").expect("a value");
    assert!((shown - value).abs() < 1e-12, "shows {shown}, not {value}");
}

fn send(tuner: &mut Tuner, ticket: u64) -> Vec<f64> {
    let Some(Request::Set { changes }) = tuner.outgoing() else { panic!("no values to send") };
    tuner.sent(Ticket(ticket));
    changes.iter().map(|change| change.value).collect()
}

#[test]
fn a_value_is_shown_before_it_is_answered() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    shows(&tuner, 20.0);
    assert!(tuner.is_asked(KEY, "k"));
    assert_eq!(send(&mut tuner, 1), [20.0]);
    assert_eq!(tuner.outgoing(), None);
}

#[test]
fn a_slider_does_not_jump_back_to_its_own_echo() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    send(&mut tuner, 1);
    edit(&mut tuner, 30.0);
    tuner.take(&voice(KEY, 2, "spring", &[20.0, 0.5]));
    shows(&tuner, 30.0);
    tuner.answered(Ticket(1), Ok(()));
    shows(&tuner, 30.0);
    assert_eq!(send(&mut tuner, 2), [30.0]);
    tuner.answered(Ticket(2), Ok(()));
    shows(&tuner, 30.0);
    tuner.take(&voice(KEY, 3, "spring", &[30.0, 0.5]));
    shows(&tuner, 30.0);
    assert!(!tuner.is_asked(KEY, "k"));
}

#[test]
fn somebody_else_s_change_is_shown() {
    let mut tuner = tuner();
    tuner.take(&voice(KEY, 2, "spring", &[77.0, 0.5]));
    shows(&tuner, 77.0);
    assert!(tuner.history().last().is_none());
}

#[test]
fn a_value_that_the_host_changed_on_the_way_is_the_host_s() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    send(&mut tuner, 1);
    tuner.take(&voice(KEY, 2, "spring", &[19.0, 0.5]));
    shows(&tuner, 20.0);
    tuner.answered(Ticket(1), Ok(()));
    shows(&tuner, 19.0);
}

#[test]
fn a_refused_value_goes_back_and_is_no_step() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    send(&mut tuner, 1);
    tuner.answered(Ticket(1), Err("not now"));
    shows(&tuner, 10.0);
    assert_eq!(tuner.refusal(), Some("not now"));
    assert!(tuner.history().last().is_none());
}

#[test]
fn an_answer_to_somebody_else_changes_nothing() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    send(&mut tuner, 1);
    tuner.answered(Ticket(9), Err("not now"));
    shows(&tuner, 20.0);
}

#[test]
fn values_stay_within_their_limits() {
    let mut tuner = tuner();
    edit(&mut tuner, 1e9);
    shows(&tuner, 100.0);
    edit(&mut tuner, -1.0);
    shows(&tuner, 0.0);
    edit(&mut tuner, f64::NAN);
    shows(&tuner, 0.0);
    tuner.edit((KEY, "nothing"), 1.0, &following(LinkedKeys::Alone), None);
    tuner.edit((87, "k"), 1.0, &following(LinkedKeys::Alone), None);
    assert_eq!(tuner.history().steps().len(), 2);
}

#[test]
fn a_range_is_taken_back_as_one() {
    let mut tuner = tuner();
    tuner.edit((KEY, "k"), 40.0, &following(LinkedKeys::Same), Some(1));
    tuner.edit((KEY, "k"), 50.0, &following(LinkedKeys::Same), Some(1));
    assert_eq!(tuner.value(KEY + 1, "k"), Some(50.0));
    assert_eq!(send(&mut tuner, 1), [50.0; 3]);
    tuner.undo();
    for key in [KEY - 1, KEY, KEY + 1] {
        assert_eq!(tuner.value(key, "k"), Some(10.0));
    }
}

#[test]
fn a_key_of_another_model_does_not_follow() {
    let mut tuner = tuner();
    tuner.take(&voice(KEY + 1, 2, "other", &[10.0, 0.5]));
    tuner.edit((KEY, "k"), 40.0, &following(LinkedKeys::Same), None);
    assert_eq!(tuner.value(KEY - 1, "k"), Some(40.0));
    assert_eq!(tuner.value(KEY + 1, "k"), Some(10.0));
}

#[test]
fn what_is_locked_stays() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    tuner.toggle_lock("k");
    edit(&mut tuner, 30.0);
    shows(&tuner, 20.0);
    tuner.undo();
    shows(&tuner, 20.0);
    tuner.toggle_lock("k");
    edit(&mut tuner, 30.0);
    shows(&tuner, 30.0);
}

#[test]
fn a_voice_of_another_model_is_not_tuned_as_the_one_before() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    tuner.take(&voice(KEY, 2, "other", &[3.0, 0.5]));
    shows(&tuner, 3.0);
    assert_eq!(tuner.outgoing(), None);
}

#[test]
fn a_lost_host_leaves_nothing_on_its_way() {
    let mut tuner = tuner();
    edit(&mut tuner, 20.0);
    send(&mut tuner, 1);
    tuner.forget();
    shows(&tuner, 10.0);
    edit(&mut tuner, 30.0);
    assert_eq!(send(&mut tuner, 2), [30.0]);
}

fn with_instruments(run: &str) -> [Update; 2] {
    let parameters =
        vec![Parameter { name: "k".into(), unit: "N/m".into(), max: 1e4, ..Parameter::default() }];
    let model = Model { name: "spring".into(), parameters, ..Model::default() };
    let instrument = |name: &str, factor: f64| telemetry::Instrument {
        name: name.into(),
        model: "spring".into(),
        values: (0..88).map(|key| factor * 1.1_f64.powi(key)).collect(),
        ..telemetry::Instrument::default()
    };
    let catalogue = Catalogue {
        run: run.into(),
        models: vec![model],
        instruments: vec![instrument("stiff", 2.0), instrument("soft", 1.0)],
        ..Catalogue::default()
    };
    [Update::Catalogue(catalogue), plays("stiff", 1, 2.0 * 1.1_f64.powi(KEY.into()))]
}

fn take_all(tuner: &mut Tuner, run: &str) {
    for update in with_instruments(run) {
        tuner.take(&update);
    }
}

fn plays(instrument: &str, revision: u32, value: f64) -> Update {
    Update::Voice(Voice {
        key: KEY.into(),
        revision,
        model: "spring".into(),
        instrument: instrument.into(),
        values: vec![value],
        ..Voice::default()
    })
}

#[test]
fn an_instrument_is_a_step_that_undo_takes_back_with_its_values() {
    let mut tuner = Tuner::default();
    take_all(&mut tuner, "1");
    edit(&mut tuner, 100.0);
    assert_eq!(send(&mut tuner, 1), [100.0]);
    tuner.answered(Ticket(1), Ok(()));
    tuner.take(&plays("stiff", 2, 100.0));
    tuner.use_instrument("soft", &ALL_KEYS, BaseValues::Saved);
    let used = |name: &str, keys: Option<&str>| {
        let keys = keys.map(str::to_owned);
        Some(Request::UseInstrument { instrument: name.into(), keys })
    };
    assert_eq!(tuner.outgoing(), used("soft", None));
    tuner.sent(Ticket(2));
    tuner.answered(Ticket(2), Ok(()));
    tuner.take(&plays("soft", 3, 1.1_f64.powi(KEY.into())));
    shows(&tuner, 1.1_f64.powi(KEY.into()));
    assert_eq!(tuner.undo(), Some(KEY..=KEY));
    assert_eq!(tuner.outgoing(), used("stiff", Some("C4")));
    tuner.sent(Ticket(3));
    tuner.answered(Ticket(3), Ok(()));
    assert_eq!(tuner.outgoing(), None);
    tuner.take(&plays("stiff", 4, 2.0 * 1.1_f64.powi(KEY.into())));
    assert_eq!(send(&mut tuner, 4), [100.0]);
    shows(&tuner, 100.0);
}

#[test]
fn changes_are_offered_to_the_next_run_and_not_to_the_same() {
    let mut tuner = Tuner::default();
    take_all(&mut tuner, "1");
    edit(&mut tuner, 100.0);
    send(&mut tuner, 1);
    tuner.answered(Ticket(1), Ok(()));
    tuner.forget();
    let [catalogue, _] = with_instruments("1");
    tuner.take(&catalogue);
    tuner.take(&plays("stiff", 2, 100.0));
    assert!(tuner.offer().is_none() && tuner.history().last().is_some());
    shows(&tuner, 100.0);
    tuner.forget();
    take_all(&mut tuner, "2");
    assert_eq!(tuner.offer().map(Snapshot::changes), Some(1));
    assert!(tuner.history().last().is_none());
    tuner.put_back();
    assert_eq!(send(&mut tuner, 2), [100.0]);
    assert!(tuner.offer().is_none());
}

#[test]
fn a_fading_change_keeps_the_curve_of_the_instrument() {
    let mut tuner = Tuner::default();
    let [catalogue, _] = with_instruments("1");
    tuner.take(&catalogue);
    let base = |key: u8| 2.0 * 1.1_f64.powi(key.into());
    for key in 0..88 {
        let Update::Voice(voice) = plays("stiff", 1, base(key)) else { panic!("a voice") };
        tuner.take(&Update::Voice(Voice { key: key.into(), ..voice }));
    }
    tuner.edit((0, "k"), 1.2 * base(0), &following(LinkedKeys::Graded), Some(1));
    tuner.edit((0, "k"), 1.1 * base(0), &following(LinkedKeys::Graded), Some(1));
    for key in 0..88 {
        let factor = 1.0 + 0.1 * (87.0 - f64::from(key)) / 87.0;
        let value = tuner.value(key, "k").expect("a value");
        // Rounding of the factor and of the product.
        assert!((value / (factor * base(key)) - 1.0).abs() < 1e-14, "{key}: {value}");
    }
    let Some(Request::SaveInstrument { differences, base, .. }) = tuner.saving(3, "mine", &[])
    else {
        panic!("something to save");
    };
    assert_eq!((base.as_str(), differences.len(), differences[0].keys.len()), ("stiff", 1, 87));
}
