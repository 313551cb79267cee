use std::fs;
use std::path::Path;
use std::sync::Arc;

use mechanism::{Library, MissingModel, contents_now, description, rendered};

fn ball(comment: &str) -> String {
    format!("{}# {comment}\n", description("bouncing-ball").unwrap())
}

#[test]
fn a_file_is_one_model_until_it_changes() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let path = folder.path().join("my-ball.toml");
    fs::write(&path, ball("one")).unwrap();
    let first = library.load(&path).unwrap();
    assert!(library.load(&path).unwrap().is(&first), "read once");
    let found = library.find("my-ball.toml", folder.path());
    assert!(found.is_ok_and(|model| model.is(&first)), "below the folder");
    assert!(first.file().is_some_and(|file| file.ends_with("my-ball.toml")), "{:?}", first.file());
    fs::write(&path, ball("another")).unwrap();
    let second = library.load(&path).unwrap();
    assert!(!second.is(&first), "a new version");
    assert_eq!((first.version(), second.version()), (1, 2));
    assert!(library.load(&path).unwrap().is(&second));
    fs::write(&path, ball("one")).unwrap();
    assert!(library.load(&path).unwrap().is(&first), "a version that is in use");
    drop(first);
    assert_eq!(library.load(&path).unwrap().version(), 3, "nobody uses it any more");
}

#[test]
fn a_version_is_read_again_without_the_disk() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let path = folder.path().join("kept-ball.toml");
    fs::write(&path, ball("kept")).unwrap();
    let (contents, first) = library.try_load(&path, &Arc::default());
    let first = first.unwrap();
    assert_eq!(contents, contents_now(&contents));
    fs::write(&path, "no ball").unwrap();
    let now = contents_now(&contents);
    assert!(now != contents && !now.lacks_one_of(&contents));
    let (wrong, mistakes) = library.try_load(&path, &Arc::default());
    assert_eq!(wrong, now);
    let shown = rendered(&mistakes.unwrap_err());
    assert!(shown.contains("no ball\n") && shown.ends_with('^'), "{shown}");
    fs::remove_file(&path).unwrap();
    assert!(contents_now(&contents).lacks_one_of(&contents));
    assert!(library.load(&path).is_err());
    let elsewhere = Library::default();
    for (path, text) in first.source.as_ref().unwrap().contents.texts() {
        elsewhere.keep_file(&path, &text);
    }
    assert!(elsewhere.load(&path).is_ok_and(|model| model.name == "bouncing-ball"));
}

#[test]
fn bytes_that_are_no_description_are_refused() {
    let (library, folder) = (Library::default(), tempfile::tempdir().unwrap());
    let path = folder.path().join("bytes.toml");
    fs::write(&path, b"[modes]\xff").unwrap();
    let wrong = library.load(&path).unwrap_err().to_string();
    assert!(wrong.contains("byte 7 is not UTF-8"), "{wrong}");
    fs::write(&path, vec![b' '; (1 << 18) + 1]).unwrap();
    assert!(library.load(&path).unwrap_err().to_string().contains("longer than 256 KiB"));
    let none = library.load(&folder.path().join("none.toml")).unwrap_err().to_string();
    assert!(none.contains("there is no such file; correct the path"), "{none}");
}

#[test]
fn a_name_is_a_model_of_the_program() {
    let library = Library::default();
    let wall = library.find("spring-wall", Path::new("/nowhere")).unwrap();
    assert!(library.find("spring-wall", Path::new("")).is_ok_and(|it| it.is(&wall)), "once");
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("same.toml"), description("spring-wall").unwrap()).unwrap();
    let same = library.load(&folder.path().join("same.toml")).unwrap();
    let [one, other] = [&same, &wall].map(|it| format!("{:?}{:?}", it.modes, it.parameters));
    assert_eq!(one, other, "the program's own, read from a file");
    let Err(MissingModel::Unknown { message, help }) = library.find("spring-wal", Path::new(""))
    else {
        panic!("a model of another name");
    };
    assert_eq!(message, "there is no model \"spring-wal\"");
    assert!(help.contains("spring-wall") && help.contains("a path"), "{help}");
}
