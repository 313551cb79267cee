use std::{collections::BTreeSet, fs};

use telemetry::recording::{Recording, Selection, export_csv};
use telemetry::{Event, KeyBlock, Update, event::Kind};

use crate::common::{
    BLOCK, at, block, catalogue, event, performance, record, recorded, unrecorded, voice,
};

#[test]
fn a_table_has_every_row_and_every_signal() {
    let (folder, path) = recorded(&performance(2000));
    let recording = Recording::open(&path).expect("a recording");
    let selection = Selection { keys: BTreeSet::from([39]), ..Selection::default() };
    let exported = export_csv(&recording, folder.path(), &selection).expect("exported");
    assert_eq!((exported.rows, exported.events), (2000, 20));
    let [events, key] = &exported.files[..] else { panic!("{:?}", exported.files) };
    let mut table = csv::Reader::from_path(key).expect("a table");
    let header = table.headers().expect("a header").iter().collect::<Vec<_>>().join(",");
    let expected = "t [s],tick,position [m],force [N],sent [N],mode,flags,fault,hammer [m],\
                    speed [m/s],gap";
    assert_eq!(header, expected);
    let rows: Vec<csv::StringRecord> = table.records().map(|row| row.expect("a row")).collect();
    let Update::Block(first) = block(39, 0) else { unreachable!() };
    for (index, row) in rows.iter().take(usize::try_from(BLOCK).expect("few")).enumerate() {
        let number = |column: usize| row[column].parse::<f64>().expect("a number").to_bits();
        assert_eq!(number(0), (index as f64 / 1000.0).to_bits());
        assert_eq!(number(2), first.position[index].to_bits());
        assert_eq!(number(4), first.sent[index].to_bits());
        assert_eq!((&row[5], &row[6], &row[7]), ("in contact", "asleep+fresh", ""));
        let speed = row[9].parse::<f32>().expect("a number");
        assert_eq!(speed.to_bits(), first.signals[3 * index + 1].to_bits());
    }
    assert_eq!(&rows[1999][1], "1999");
    let mut table = csv::Reader::from_path(events).expect("a table");
    let row = table.records().nth(1).expect("a second").expect("a row");
    // 100 ticks and 0.1 + 0.2 of one, which is not 0.3.
    assert_eq!(
        (&row[0], &row[2], &row[4]),
        ("1.0030000000000000e-1", "3.0000000000000004e-1", "strike")
    );
    assert_eq!(row[2].parse::<f64>().expect("theta").to_bits(), (0.1_f64 + 0.2).to_bits());
}

#[test]
fn a_key_whose_model_changes_has_two_tables() {
    let (folder, path) = unrecorded();
    // The block in which it changes has rows of both.
    let Update::Block(both) = block(39, 0) else { unreachable!() };
    let revision = (0..BLOCK).map(|row| if row < 5 { 39 } else { 40 }).collect();
    let signals = both.signals[..15].to_vec();
    let both = Update::Block(KeyBlock { revision, signals, ..both });
    let switch = Event {
        kind: Kind::Switch.into(),
        key: 39,
        to: 1,
        guard: "meet".into(),
        ..Event::default()
    };
    let told = [
        (at(0), catalogue()),
        (at(0), voice(39, 39, "springs", "grand")),
        (at(1), Update::Event(switch)),
        (at(20), both),
        (at(21), voice(39, 40, "wall", "brick")),
        (at(22), event(Kind::Fault, 21, 0.0, 39)),
    ];
    record(&path, &told);
    let recording = Recording::open(&path).expect("a recording");
    let exported = export_csv(&recording, folder.path(), &Selection::default()).expect("exported");
    let lines = |name: &str| -> Vec<String> {
        let text = fs::read_to_string(folder.path().join(name)).expect("a table");
        text.lines().map(str::to_owned).collect()
    };
    assert_eq!((lines("key-39.csv").len(), lines("key-39-2.csv").len()), (6, 16));
    assert_eq!(
        lines("key-39-2.csv")[0],
        "t [s],tick,position [m],force [N],sent [N],mode,flags,fault"
    );
    assert!(lines("events.csv")[1].ends_with(",39,switch,free,in contact,meet,0,"));
    assert!(lines("events.csv")[2].ends_with(",39,fault,,,,1.25,it panicked"));
    assert_eq!(exported.files.len(), 3);
    let error = export_csv(&recording, folder.path(), &Selection::default()).expect_err("there");
    assert!(error.to_string().contains("events.csv is there already"), "{error}");
}

#[test]
fn a_recording_without_a_catalogue_has_no_times() {
    let (folder, path) = recorded(&[(at(0), block(39, 0))]);
    let recording = Recording::open(&path).expect("a recording");
    let error = export_csv(&recording, folder.path(), &Selection::default()).expect_err("none");
    assert!(error.to_string().contains(" has no catalogue, which says how long a tick is"));
}
