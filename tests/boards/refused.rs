//! Rejections before the first force, in a sentence that names link and board. Exit code 1, since
//! a board may still get power; 2 for a wrong scene.

use crate::letoff;
use crate::machine_time::with_time;
use crate::rig::{Boards, arguments, machine, part_of_machine, run_watched, side_by_side};

/// What a number of boards says wrongly, and the words of the refusal.
type Lie = (usize, [&'static str; 2], &'static [&'static str]);

const LIES: [Lie; 5] = [
    // Another generation of the protocol.
    (
        1,
        ["--say-major", "9"],
        &["board 0 on", "links/board0", "speaks protocol 9, this host 2", "update the host"],
    ),
    (1, ["--say-schema", "1"], &["board 0 on", "other cyclic layouts"]),
    // One board behind two ports.
    (2, ["--say-uid", "7"], &["are both board 070707070707"]),
    (2, ["--say-keys", "0,11"], &["both carry A0"]),
    (1, ["--say-keys", "80,12"], &["a board carries 1 to 12 keys"]),
];

#[test]
fn boards_that_cannot_be_what_they_say_get_no_force() {
    let _machine = part_of_machine();
    side_by_side(&letoff::folder("refused-lies"), LIES.len(), &LIES, |folder, lie| {
        let (count, boards, words) = lie;
        let boards = Boards::start(folder, *count, boards);
        let links = boards.links();
        let said = letoff::run(folder, &arguments(&links, &["--performance", "none"]));
        assert_eq!(said.code, Some(1), "{said:?}");
        letoff::check_words(&said, words);
        for board in boards.stop() {
            assert_eq!(board["counts"]["forces"], 0, "{board}");
            assert_eq!(board["counts"]["armings"], 0, "{board}");
        }
    });
}

#[test]
fn a_board_that_lies_about_what_the_scene_knows() {
    let _machine = part_of_machine();
    let folder = letoff::folder("refused-lie");
    let boards = Boards::start(&folder, 1, &[]);
    let port = folder.join("links/board0");
    let scene = format!(
        "[[keys]]\nrange = \"A0..C8\"\ninstrument = \"grand-springs\"\n\n[links]\nkind = \"boards\"\n\n\
         [[links.bus]]\nserial = \"{}\"\n\n[[links.bus.board]]\nnumber = 0\nkeys = \"C4..A#4\"\n",
        port.display()
    );
    std::fs::write(folder.join("lie.toml"), scene).expect("a file");
    let words = ["board 0 on", "says that it carries A0..G1, the scene says C4..A#4"];
    letoff::check(&folder, &["run", "lie.toml"], 1, &words);
    assert_eq!(boards.stop()[0]["counts"]["armings"], 0);
}

#[test]
fn a_port_behind_which_nobody_speaks_the_protocol() {
    let _machine = part_of_machine();
    let folder = letoff::folder("refused-printer");
    // Every byte of the board is damaged, so no frame arrives.
    let boards = Boards::start(&folder, 1, &["--flip", "1"]);
    let links = boards.links();
    let said = letoff::run(&folder, &arguments(&links, &["--performance", "none"]));
    assert_eq!(said.code, Some(1), "{said:?}");
    letoff::check_words(&said, &["nothing on", "links/board0", "answers as a board does"]);
}

#[test]
fn a_board_that_comes_a_moment_later_is_waited_for() {
    let _machine = part_of_machine();
    let folder = letoff::folder("refused-later");
    let _none = std::fs::remove_dir_all(folder.join("links"));
    let link = format!("serial:{}", folder.join("links/board0").display());
    let run = ["run", "springs", "--performance", "none", "--duration", "0.5", "--link", &link];
    let host = letoff::start(&folder, &run);
    std::thread::sleep(std::time::Duration::from_millis(500));
    let boards = Boards::start(&folder, 1, &[]);
    let said = letoff::end(host);
    assert_eq!(said.code, Some(0), "{said:?}");
    assert!(0 < boards.stop()[0]["counts"]["armings"].as_u64().unwrap_or_default());
}

#[test]
fn time_that_is_not_real() {
    let _machine = part_of_machine();
    let folder = letoff::folder("refused-virtual");
    let boards = Boards::start(&folder, 1, &[]);
    let links = boards.links();
    let all = arguments(&links, &["--virtual-time", "--duration", "1"]);
    letoff::check(&folder, &all, 2, &["boards go by their own time"]);
    let all = arguments(&links, &["--set", "tick_hz=3000", "--performance", "none"]);
    letoff::check(&folder, &all, 2, &["3000 Hz"]);
    drop(boards);
}

#[test]
fn a_loop_that_is_too_late_for_its_instrument() {
    let _machine = machine();
    let folder = letoff::folder("refused-late");
    with_time("the refusal of a loop that is too late", |watch| {
        let play = |instrument: &[&str]| {
            let boards = Boards::watched(watch, &folder, 1, &["--late", "3"]);
            let links = boards.links();
            let run = ["run", "--json", "--performance", "none", "--duration", "1"];
            let links = links.iter().map(String::as_str);
            let all: Vec<_> =
                run.into_iter().chain(links).chain(instrument.iter().copied()).collect();
            let said = run_watched(watch, &folder, &all);
            (said, boards.stop()[0]["counts"]["armings"].as_u64().unwrap_or_default())
        };
        let (said, armings) = play(&[]);
        assert_eq!((said.code, armings), (Some(1), 0), "{said:?}");
        letoff::check_words(&said, &["with the delay of these links", "with grand", "ms of delay"]);
        // 3 ms in each direction, and half a tick in which samples wait.
        let delay = said.err.split("1000 Hz and ").nth(1).and_then(|it| it.split(' ').next());
        assert!(delay.and_then(|it| it.parse().ok()).is_some_and(|ms: f64| 6.5 <= ms), "{said:?}");
        // An instrument that bears the delay is accepted. Several short waits for a processor
        // can add up to an expiry, after which the board is armed again.
        let (said, armings) = play(&["--set", "keys.0.instrument=spring"]);
        assert_eq!(said.code, Some(0), "{said:?}");
        assert!(0 < armings);
    });
}
