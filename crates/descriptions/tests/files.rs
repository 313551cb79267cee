//! Models by the paths of their files.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use descriptions::{
    MissingModel, find_model, install, keep_file, load_model, rendered, try_load, version_of,
};
use models::catalogue;

use crate::ball::BallReader;

#[test]
fn a_file_is_one_model_until_it_changes() {
    install(&BallReader);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("my-ball.toml");
    fs::write(&path, "[modes]").unwrap();
    let first = load_model(&path).unwrap();
    assert!(load_model(&path).unwrap().is(first), "read once");
    let found = find_model("my-ball.toml", folder.path());
    assert!(found.is_ok_and(|entry| entry.is(first)), "below the folder");
    assert!(first.file.is_some_and(|file| file.ends_with("my-ball.toml")), "{:?}", first.file);
    fs::write(&path, "[modes] # another").unwrap();
    let second = load_model(&path).unwrap();
    assert!(!second.is(first), "a new version");
    assert!(load_model(&path).unwrap().is(second));
    fs::write(&path, "nothing").unwrap();
    let wrong = load_model(&path).unwrap_err().to_string();
    assert!(wrong.ends_with("my-ball.toml:1:1: this is no ball; begin with [modes]"), "{wrong}");
}

#[test]
fn versions_keep_what_stood_in_their_files_and_are_read_again_without_the_disk() {
    install(&BallReader);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("kept-ball.toml");
    fs::write(&path, "[modes]").unwrap();
    let (contents, first) = try_load(&path, &Arc::default());
    let first = first.unwrap();
    assert!(contents.is_current());
    fs::write(&path, "no ball").unwrap();
    assert!(!contents.is_current() && !contents.now().lacks_one_of(&contents));
    let (wrong, mistakes) = try_load(&path, &Arc::default());
    assert!(wrong.is_current() && wrong == contents.now());
    let shown = rendered(&mistakes.unwrap_err());
    assert!(shown.ends_with("begin with [modes]\n  no ball\n  ^"), "{shown}");
    fs::write(&path, "[modes]").unwrap();
    assert!(load_model(&path).unwrap().is(first), "the version that it was");
    fs::remove_file(&path).unwrap();
    assert!(contents.now().lacks_one_of(&contents));
    assert!(load_model(&path).is_err());
    let version = version_of(first).unwrap();
    for (path, text) in version.contents.texts() {
        keep_file(&path, &text);
    }
    assert!(load_model(&path).is_ok());
    assert!(version_of(catalogue::built_in("spring-wall").unwrap()).is_none());
}

#[test]
fn what_is_no_description_is_refused() {
    install(&BallReader);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bytes.toml");
    fs::write(&path, b"[modes]\xff").unwrap();
    let wrong = load_model(&path).unwrap_err().to_string();
    assert!(wrong.contains("byte 7 is not UTF-8"), "{wrong}");
    fs::write(&path, vec![b' '; (1 << 18) + 1]).unwrap();
    assert!(load_model(&path).unwrap_err().to_string().contains("longer than 256 KiB"));
    let none = load_model(&folder.path().join("none.toml")).unwrap_err().to_string();
    assert!(none.contains("there is no such file; correct the path"), "{none}");
}

#[test]
fn a_name_is_a_model_of_the_program() {
    let wall = find_model("spring-wall", Path::new("/nowhere"));
    assert!(wall.is_ok_and(|it| it.is(catalogue::built_in("spring-wall").unwrap())));
    let Err(MissingModel::Unknown { message, help }) = find_model("spring-wal", Path::new(""))
    else {
        panic!("a model of another name");
    };
    assert_eq!(message, "there is no model \"spring-wal\"");
    assert!(help.contains("spring-wall") && help.contains("a path"), "{help}");
}
