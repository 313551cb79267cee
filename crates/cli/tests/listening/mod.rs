//! The clients of a stream: `--listen`, `--tokens`, `--tls`, `--origin` and `--insecure`.

mod roles;

use std::fs::{File, Permissions};
use std::io::{ErrorKind, Read as _, Write as _};
use std::os::unix::fs::PermissionsExt as _;
use std::os::unix::net::{UnixListener, UnixStream};
use std::os::unix::process::CommandExt as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};

use host::control::{ControlError, Reply, Request, STARTING, send};
use rustix::process::{Pid, Signal, getuid, kill_process};
use telemetry::request::Change;
use telemetry::stream::{Client, Dial, Fingerprint};
use telemetry::{Arrival, ConnectionState, Source as _};

use crate::stranger::Stranger;
use crate::typed::{Folder, cable, eventually};

/// Secrets of the minimum length.
const VIEWER: &str = "see-0123456789abcdef";
const TUNER: &str = "tune-0123456789abcdef";
const OWNER: &str = "own-0123456789abcdef";

/// An idle host on simulated keys, until it is dropped.
struct Host<'a> {
    folder: &'a Folder,
    child: Child,
    /// Address of its stream, with the fingerprint.
    address: String,
    /// Secret for its own user.
    token: Option<String>,
}

impl<'a> Host<'a> {
    /// Starts a host with `arguments`, and waits until it answers.
    fn start(folder: &'a Folder, arguments: &[&str]) -> Self {
        let silent = ["run", "springs", "--performance", "none", "--midi", "none"];
        Self::run(folder, &[&silent[..], &["--black-box", "none"], arguments].concat())
    }

    fn run(folder: &'a Folder, arguments: &[&str]) -> Self {
        let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
        let mut command = folder.command(letoff, arguments);
        command.stdout(File::create(folder.join("report")).expect("a file"));
        command.stderr(File::create(folder.join("complaints")).expect("a file"));
        let mut child = command.spawn().expect("a process");
        let (address, token) = eventually("a host", || {
            let ended = child.try_wait().expect("a process");
            assert!(ended.is_none(), "it ended: {}", folder.read("complaints"));
            match send(&folder.socket(), &Request::Where {}).ok()? {
                Ok(Reply::Where { address, token }) => Some((address, token)),
                Err(why) if why == STARTING => None,
                other => unreachable!("{other:?}"),
            }
        });
        Self { folder, child, address, token }
    }

    fn complaints(&self) -> String {
        self.folder.read("complaints")
    }

    /// Returns the scene as it sounds now.
    fn scene(&self) -> String {
        match send(&self.folder.socket(), &Request::Scene {}) {
            Ok(Ok(Reply::Scene { toml })) => toml,
            other => unreachable!("{other:?}"),
        }
    }

    fn dial(&self, token: Option<&str>) -> Dial {
        let (address, _pin) = self.address.split_once('#').unwrap_or((&self.address, ""));
        let token = token.map(str::to_owned);
        Dial { address: address.to_owned(), token, ..Dial::default() }
    }
}

impl Drop for Host<'_> {
    fn drop(&mut self) {
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        let _gone = id.map(|id| kill_process(id, Signal::INT));
        let _ended = self.child.wait();
    }
}

/// Writes a file of tokens that only this user can read.
fn tokens(folder: &Folder, text: &str) {
    let file = folder.write("tokens", text);
    std::fs::set_permissions(file, Permissions::from_mode(0o600)).expect("a file");
}

/// Waits for the state of an accepted or rejected client.
fn standing(client: &Client) -> ConnectionState {
    eventually("a standing", || {
        Some(client.standing()).filter(|it| *it != ConnectionState::Connecting)
    })
}

fn refusal(dial: Dial) -> String {
    let standing = standing(&Client::connect(dial, None));
    let ConnectionState::Refused(why) = standing else { unreachable!("{standing:?}") };
    why
}

fn connected(dial: Dial) -> Client {
    let mut client = Client::connect(dial, None);
    eventually("a connection", || (client.next() == Some(Arrival::Anew)).then_some(()));
    client
}

/// Returns the reply to `request`, once the host runs.
fn asked(client: &mut Client, request: &Request) -> Result<Reply, String> {
    let mut ticket = client.ask(request.clone());
    eventually("an answer", || match client.next()? {
        Arrival::Reply { ticket: of, result } if of == ticket => {
            let is_early = result.as_ref().is_err_and(|why| why.contains("not running yet"));
            if is_early {
                ticket = client.ask(request.clone());
            }
            (!is_early).then_some(result)
        }
        Arrival::Reply { .. } | Arrival::Update { .. } | Arrival::Anew => None,
    })
}

/// Sets a value of key 39, once the host runs.
fn set(dial: Dial) -> Result<(), String> {
    let changes = vec![Change { key: 39, parameter: "k2".into(), value: 900.0 }];
    asked(&mut connected(dial), &Request::Set { changes }).map(drop)
}

const LOOPBACK: [&str; 2] = ["--listen", "127.0.0.1:0"];

#[test]
fn beyond_this_machine_only_with_tokens_and_tls() {
    let folder = Folder::new("beyond");
    tokens(&folder, &format!("owner {OWNER}\n"));
    let refused = |options: &[&str], words: &[&str]| {
        // Not even a recording is started.
        let run = ["run", "springs", "--record", "a.mcap", "--duration", "1"];
        folder.refuses(&[&run[..], options].concat(), 2, words);
        assert!(!folder.join("a.mcap").exists(), "{options:?}");
    };
    for everywhere in ["0.0.0.0:0", "[::]:0"] {
        let listen = ["--listen", everywhere];
        let both = [everywhere, "without tokens and TLS", "--tokens and --tls", "127.0.0.1"];
        refused(&listen, &both);
        refused(&[&listen[..], &["--tokens", "tokens"]].concat(), &["without TLS"]);
        refused(&[&listen[..], &["--tls", "self-made"]].concat(), &["without tokens"]);
    }
    for nowhere in ["here", "8765", "localhost:8765", "127.0.0.1:99999"] {
        refused(&["--listen", nowhere], &[nowhere, "no address and port", "or none"]);
    }
}

#[test]
fn on_a_network_that_is_trusted_anybody_may_come() {
    let folder = Folder::new("insecure");
    let host = Host::start(&folder, &["--listen", "0.0.0.0:0", "--insecure"]);
    assert!(host.address.starts_with("ws://0.0.0.0:"), "{}", host.address);
    assert_eq!(set(host.dial(None)), Ok(()));
}

#[test]
fn all_mistakes_of_a_file_of_tokens_are_told_at_once() {
    let folder = Folder::new("tokens-bad");
    let run = ["run", "springs", "--virtual-time", "--duration", "0.1", "--tokens", "tokens"];
    tokens(
        &folder,
        &format!(
            "viewer {OWNER}\nadmin aaaa\nowner\n# ours\ntuner bb&bb\nowner {OWNER}\nowner own\n"
        ),
    );
    let words =
        ["tokens: ", "line 2 is not", "line 3 is not", "line 5 has", "line 6 has", "line 7 has"];
    folder.refuses(&run, 2, &words);
    let (_code, _out, err) = folder.letoff(&run);
    assert!(!err.contains("aaaa") && !err.contains("bb&bb"), "a secret is shown: {err}");
    // Otherwise every client would be an owner.
    tokens(&folder, "# nobody yet\n");
    folder.refuses(&run, 2, &["tokens: nobody is named", "`owner SECRET`"]);
    tokens(&folder, &"owner x\n".repeat(10_000));
    folder.refuses(&run, 2, &["tokens: ", "longer than 64 KiB"]);
    folder.refuses(&[&run[..6], &["nothing"]].concat(), 2, &["nothing: "]);
}

#[test]
fn a_file_of_tokens_that_others_read_is_pointed_out() {
    let folder = Folder::new("tokens-mode");
    let run = ["run", "springs", "--virtual-time", "--duration", "0.1", "--tokens", "tokens"];
    tokens(&folder, &format!("owner {OWNER}\n"));
    let (code, _out, err) = folder.letoff(&run);
    assert_eq!((code, err.as_str()), (Some(0), ""));
    for mode in [0o644, 0o602] {
        std::fs::set_permissions(folder.join("tokens"), Permissions::from_mode(mode))
            .expect("a file");
        let (code, _out, err) = folder.letoff(&run);
        assert_eq!(code, Some(0), "{err}");
        assert!(err.contains("`chmod 600 tokens`") && err.lines().count() == 1, "{err}");
    }
}

#[test]
fn a_missing_and_a_wrong_token_are_refused_in_different_words() {
    let folder = Folder::new("roles");
    tokens(&folder, &format!("viewer {VIEWER}\ntuner {TUNER}\nowner {OWNER}\n"));
    let host = Host::start(&folder, &[&LOOPBACK[..], &["--tokens", "tokens"]].concat());
    assert!(refusal(host.dial(None)).contains("asks for a token"));
    assert!(refusal(host.dial(Some("see"))).contains("does not know the given token"));
    let refused = set(host.dial(Some(VIEWER))).expect_err("a viewer only watches");
    assert!(refused.contains("a viewer may not"), "{refused}");
}

#[test]
fn only_pages_that_are_named_may_connect() {
    let folder = Folder::new("origin");
    let ours = "https://app.example";
    let host = Host::start(&folder, &[&LOOPBACK[..], &["--origin", ours]].concat());
    let bearer = format!("Bearer {}", host.token.as_deref().expect("a secret of this run"));
    let knock = |headers: &[(&str, &str)]| {
        let headers = [&[("Authorization", bearer.as_str())], headers].concat();
        Stranger::knock(&host.address, &headers).err()
    };
    assert_eq!(knock(&[]), None, "a program, which is of no page");
    assert_eq!(knock(&[("Origin", ours)]), None);
    for foreign in ["https://evil.example", "http://app.example", "null"] {
        assert_eq!(knock(&[("Origin", foreign)]), Some(403), "{foreign}");
    }
    for none in ["null", "app.example", "https://app.example/", "*"] {
        folder.refuses(&["run", "springs", "--origin", none], 2, &[none, "as https://app.example"]);
    }
}

fn printed(complaints: &str) -> Fingerprint {
    let rest = complaints.split("certificate is ").nth(1).expect("a certificate");
    let text: String = rest.chars().take_while(|it| it.is_ascii_hexdigit() || *it == ':').collect();
    text.trim_end_matches(':').parse().expect("a fingerprint")
}

#[test]
fn the_fingerprint_that_is_printed_is_the_certificate_s() {
    let folder = Folder::new("tls");
    tokens(&folder, &format!("owner {OWNER}\n"));
    let everywhere = ["--listen", "0.0.0.0:0", "--tokens", "tokens", "--tls", "self-made"];
    let first = {
        let host = Host::start(&folder, &everywhere);
        let pin = printed(&host.complaints());
        assert!(host.address.ends_with(&format!("#{pin}")), "{}", host.address);
        let dial = |pin| Dial { pin, ..host.dial(Some(OWNER)) };
        assert_eq!(set(dial(Some(pin))), Ok(()));
        let text = refusal(dial(Some(Fingerprint([7; 32]))));
        assert!(text.contains("another certificate"), "{text}");
        assert!(refusal(dial(None)).contains("needs the fingerprint"));
        pin
    };
    // The fingerprint survives a restart.
    let host = Host::start(&folder, &everywhere);
    assert_eq!(printed(&host.complaints()), first);
}

#[test]
fn a_certificate_that_cannot_be_had_is_refused_in_a_sentence() {
    let folder = Folder::new("tls-bad");
    folder.write("cert.pem", "no certificate");
    folder.write("key.pem", "no key");
    let refused = |tls: &str, words: &[&str]| {
        let run = ["run", "springs", "--performance", "none", "--midi", "none", "--duration", "1"];
        folder.refuses(&[&run[..], &LOOPBACK, &["--tls", tls]].concat(), 2, words);
    };
    refused("cert.pem", &["--tls cert.pem", "CHAIN.pem,KEY.pem", "self-made"]);
    refused("nothing.pem,key.pem", &["nothing.pem cannot be read"]);
    refused("cert.pem,key.pem", &["certificate"]);
    // The folder for the certificate cannot be created.
    folder.write(".local", "a file");
    refused("self-made", &["cannot be kept in", ".local/state/letoff"]);
}

#[test]
fn a_client_names_files_in_its_folders_only_and_reads_no_others() {
    let folder = Folder::new("files");
    std::fs::create_dir(folder.join("instruments")).expect("a folder");
    folder.write("instruments/broken.toml", "model = \"no-such-model\"\n");
    folder.write("secret", "passphrase = \"open sesame\"\n");
    let folders = ["--recordings", "takes", "--instruments", "instruments"];
    let host = Host::start(&folder, &[&LOOPBACK[..], &folders].concat());
    let mut client = connected(host.dial(host.token.as_deref()));
    let mut ask = |request| asked(&mut client, &request);
    let uses =
        |instrument: &str| Request::UseInstrument { instrument: instrument.into(), keys: None };
    let secret = folder.join("secret").display().to_string();
    for foreign in [secret.as_str(), "secret", "../secret", "/etc/passwd"] {
        let refused = ask(uses(foreign)).expect_err(foreign);
        assert!(
            refused.contains("no instrument") && refused.contains("in instruments"),
            "{refused}"
        );
        assert!(!refused.contains("sesame") && !refused.contains("root"), "{refused}");
    }
    assert!(ask(uses("broken")).expect_err("no good file").contains("no-such-model"));
    assert!(ask(uses("spring-wall")).is_ok());
    let records = |file: &str| Request::Record { file: Some(file.into()) };
    let elsewhere = folder.join("elsewhere.mcap").display().to_string();
    for foreign in [elsewhere.as_str(), "../elsewhere.mcap", "a/elsewhere.mcap", "authorized_keys"]
    {
        let refused = ask(records(foreign)).expect_err(foreign);
        assert!(refused.contains("recordings go into takes"), "{refused}");
    }
    assert!(ask(records("one.mcap")).is_ok());
    assert!(ask(Request::Record { file: None }).is_ok());
    assert!(folder.join("takes/one.mcap").exists() && !folder.join("elsewhere.mcap").exists());
}

#[test]
fn whoever_watches_may_stop_and_hears_what_was_done_before_the_stream_ends() {
    let folder = Folder::new("stop-stream");
    tokens(&folder, &format!("viewer {VIEWER}\nowner {OWNER}\n"));
    let mut host = Host::start(&folder, &[&LOOPBACK[..], &["--tokens", "tokens"]].concat());
    let mut viewer = connected(host.dial(Some(VIEWER)));
    let other = connected(host.dial(Some(OWNER)));
    let reply = asked(&mut viewer, &Request::Stop {});
    let Ok(Reply::Stopped { told, boards, .. }) = reply else { unreachable!("{reply:?}") };
    // Both ways report the number; before the first tick no board was armed.
    assert!(told == boards && (boards == 8 || boards == 0), "{told} of {boards}");
    for client in [&viewer, &other] {
        let why = eventually("the end", || {
            if let ConnectionState::Lost(why) = client.standing() { Some(why) } else { None }
        });
        assert!(why.contains("the host was stopped"), "{why}");
    }
    assert!(host.child.wait().expect("it ends").success());
}

#[test]
fn a_stop_while_a_piece_is_rehearsed_is_heard_at_once_and_nothing_is_played() {
    let folder = Folder::new("stop-early");
    let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
    let run = ["run", "bach", "--midi", "none", "--listen", "none", "--json"];
    let mut host = folder.command(letoff, &run);
    host.stdout(Stdio::piped()).stderr(Stdio::piped());
    let host = host.spawn().expect("a process");
    eventually("a socket", || folder.socket().exists().then_some(()));
    let (code, out, err) = folder.letoff(&["stop"]);
    assert_eq!(code, Some(0), "{err}");
    assert_eq!(out, "stopped before any board was armed: nothing will play\n");
    let ended = host.wait_with_output().expect("it ends");
    assert_eq!(ended.status.code(), Some(0));
    assert_eq!(String::from_utf8_lossy(&ended.stdout), "");
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert_eq!(said, "letoff: stopped before it began to play\n");
    assert!(!folder.socket().exists());
}

#[test]
fn a_stop_is_heard_while_keys_are_tried() {
    let folder = Folder::new("stop-earlier");
    // The default scene's keys are tried for longer than a request takes.
    let run = ["run", "--listen", "none"];
    let mut host = folder.command(Path::new(env!("CARGO_BIN_EXE_letoff")), &run);
    host.stdout(Stdio::piped()).stderr(Stdio::piped());
    let host = host.spawn().expect("a process");
    eventually("a socket", || folder.socket().exists().then_some(()));
    let (code, out, _err) = folder.letoff(&["stop"]);
    assert_eq!((code, out.contains("nothing will play")), (Some(0), true), "{out}");
    let ended = host.wait_with_output().expect("it ends");
    let said = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert_eq!(ended.status.code(), Some(0), "{said}");
    assert_eq!(said, "letoff: stopped before it began to play\n");
}

#[test]
fn an_address_that_is_taken_may_be_free_later() {
    let folder = Folder::new("taken");
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = taken.local_addr().expect("an address").to_string();
    let run = ["run", "springs", "--performance", "none", "--midi", "none", "--listen", &address];
    folder.refuses(&run, 1, &["cannot listen", &address]);
    // An explicit default address must be free; it may be taken already.
    let _taken = std::net::TcpListener::bind("127.0.0.1:8765");
    let usual = [&run[..6], &["--listen", "127.0.0.1:8765"]].concat();
    folder.refuses(&usual, 1, &["cannot listen", "127.0.0.1:8765"]);
}

/// Unix user id of the account `nobody`.
const NOBODY: u32 = 65_534;

/// Variable with the host that the process of [`the_other_user`] attacks.
const VICTIM: &str = "LETOFF_TEST_VICTIM";

/// Acts as another user of the machine in a separate process; does nothing in other processes.
#[test]
fn the_other_user() {
    let Ok(victims) = std::env::var(VICTIM) else { return };
    let [tmp, rehearsing, playing]: [&str; 3] =
        victims.lines().collect::<Vec<_>>().try_into().expect("a folder and two hosts");
    for victim in [rehearsing, playing] {
        let (address, socket) = victim.split_once(' ').expect("an address and a socket");
        try_to_get_at(address, Path::new(socket));
    }
    // The folder where root's host would listen without a runtime folder.
    let folder = Path::new(tmp).join("letoff-0");
    std::fs::create_dir(&folder).expect("the sticky folder is everybody's");
    std::fs::set_permissions(&folder, Permissions::from_mode(0o777)).expect("a folder");
    let listen = |name: &str| {
        let path = folder.join(name);
        let listener = UnixListener::bind(&path).expect("a socket");
        std::fs::set_permissions(&path, Permissions::from_mode(0o777)).expect("a socket");
        listener
    };
    let (host, _guardian) = (listen("letoff.sock"), listen("letoff.sock.midi"));
    // The folder where it would keep its state, with its certificate's key.
    std::fs::create_dir(Path::new(tmp).join("letoff")).expect("a folder");
    std::fs::write(Path::new(tmp).join("tried"), "").expect("a file");
    for stream in host.incoming() {
        let mut stream = stream.expect("a client");
        let _sent = stream.write_all(b"{\"Ok\":{\"reply\":\"done\",\"text\":\"stopped\"}}\n");
        let mut heard = String::new();
        let _ended = stream.read_to_string(&mut heard);
        std::fs::write(Path::new(tmp).join("heard"), heard).expect("a file");
    }
}

/// Asserts that the `socket`, the stream at `address` and the socket of the MIDI guardian let
/// nothing be read, recorded, changed or stopped.
fn try_to_get_at(address: &str, socket: &Path) {
    for request in [Request::Where {}, Request::Stop {}, Request::Record { file: None }] {
        let refused = send(socket, &request).expect_err("another user's host");
        assert!(matches!(refused, ControlError::NotYours { .. }), "{refused}");
    }
    let mut guardian = socket.as_os_str().to_owned();
    guardian.push(".midi");
    let refused = UnixStream::connect(guardian).expect_err("another user's guardian").kind();
    // A host that rehearses has no guardian yet.
    assert!(matches!(refused, ErrorKind::PermissionDenied | ErrorKind::NotFound), "{refused}");
    for token in [None, Some(""), Some("owner"), Some(OWNER)] {
        let token = token.map(str::to_owned);
        let dial = Dial { address: address.into(), token, ..Dial::default() };
        assert!(refusal(dial.clone()).contains(" token"), "{dial:?}");
    }
}

#[test]
fn another_user_of_this_machine_reads_writes_changes_and_stops_nothing() {
    if !getuid().is_root() {
        println!("SKIPPED: only root can try it as another user");
        return;
    }
    let (folder, other_folder) = (Folder::shared("other-user"), Folder::shared("rehearsing"));
    let tmp = folder.join("tmp");
    std::fs::create_dir(&tmp).expect("a folder");
    std::fs::set_permissions(&tmp, Permissions::from_mode(0o1777)).expect("a folder");
    let own = std::env::current_exe().expect("this test");
    std::fs::copy(own, folder.join("test")).expect("a copy that others may run");
    let cables = [folder.join("cable"), other_folder.join("cable"), folder.join("third")];
    let _ends = cables.each_ref().map(|path| cable(path));
    let midi = cables.each_ref().map(|path| format!("raw:{}", path.display()));
    let silent = |performance, midi| {
        ["run", "springs", "--performance", performance, "--midi", midi, "--black-box", "none"]
    };
    let mut host = Host::run(&folder, &[&silent("none", &midi[0])[..], &LOOPBACK].concat());
    eventually("a guardian", || folder.join("socket.midi").exists().then_some(()));
    let rehearsing =
        Host::run(&other_folder, &[&silent("bach-bwv-846", &midi[1])[..], &LOOPBACK].concat());
    let victim = |host: &Host<'_>| format!("{} {}", host.address, host.folder.socket().display());
    let victims = format!("{}\n{}\n{}", tmp.display(), victim(&rehearsing), victim(&host));
    let mut other = Command::new(folder.join("test"));
    other.args(["--exact", "listening::the_other_user", "--nocapture"]).env(VICTIM, victims);
    other.current_dir(&tmp).uid(NOBODY).gid(NOBODY).stdin(Stdio::null());
    other.stdout(Stdio::null()).stderr(File::create(folder.join("tried")).expect("a file"));
    // The copy is busy while another test starts a process.
    let mut other = eventually("another user", || other.spawn().ok());
    eventually("all is tried", || {
        let ended = other.try_wait().expect("a process");
        assert!(ended.is_none(), "it got through: {}", folder.read("tried"));
        tmp.join("tried").exists().then_some(())
    });
    // Root does not trust these folders, and listens nowhere where they could answer.
    let letoff = |arguments: &[&str]| {
        let mut command = folder.command(Path::new(env!("CARGO_BIN_EXE_letoff")), arguments);
        command.env_remove("LETOFF_SOCKET").env_remove("XDG_RUNTIME_DIR").env("TMPDIR", &tmp);
        command.env_remove("HOME");
        let output = command.output().expect("a process");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (output.status.code(), text(&output.stdout), text(&output.stderr))
    };
    let (code, _out, err) = letoff(&["status"]);
    assert!(code == Some(1) && err.contains("user 65534's and no host of yours"), "{err}");
    let options = ["--duration", "0.1", "--tls", "self-made"];
    let run = [&silent("none", &midi[2])[..], &options, &LOOPBACK].concat();
    let (_code, out, err) = letoff(&run);
    assert!(err.contains("belongs to user 65534"), "{err}");
    assert!(out.contains("unguarded") && out.contains("belongs to user 65534"), "{out}");
    let kept = |folder: &str| std::fs::read_dir(tmp.join(folder)).expect("a folder").count();
    assert_eq!((kept("letoff"), kept("letoff-0")), (0, 2), "the sockets only");
    other.kill().and_then(|()| other.wait()).expect("it ends");
    let heard = std::fs::read_to_string(tmp.join("heard")).unwrap_or_default();
    assert_eq!(heard, "", "not even a request was told to them");
    // Both hosts are unchanged, and their own user may do everything.
    assert!(send(&rehearsing.folder.socket(), &Request::Stop {}).is_ok_and(|it| it.is_ok()));
    let mut owner = connected(host.dial(host.token.as_deref()));
    let changes = vec![Change { key: 39, parameter: "k2".into(), value: 901.0 }];
    assert!(asked(&mut owner, &Request::Set { changes }).is_ok());
    assert!(asked(&mut owner, &Request::Stop {}).is_ok());
    assert!(host.child.wait().expect("it ends").success());
}
