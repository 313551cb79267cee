//! To whom a host streams: `--listen`, `--tokens`, `--tls`, `--origin` and `--insecure`, as they
//! are typed.

#![expect(clippy::expect_used, reason = "helpers of tests")]

mod stranger;
mod typed;

use std::fs::{File, Permissions};
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;
use std::process::Child;

use host::control::{Reply, Request, send};
use rustix::process::{Pid, Signal, kill_process};
use stranger::Stranger;
use telemetry::request::Change;
use telemetry::stream::{Client, Dial, Fingerprint};
use telemetry::{Arrival, Source as _, Standing};
use typed::{Folder, eventually};

/// A host on simulated keys that nobody plays, until it is dropped.
struct Host<'a> {
    folder: &'a Folder,
    child: Child,
    /// Where it streams, with what stands behind the address.
    address: String,
    /// The secret that it tells its own user.
    token: Option<String>,
}

impl<'a> Host<'a> {
    /// Starts one with `arguments`, and waits until it answers.
    fn start(folder: &'a Folder, arguments: &[&str]) -> Self {
        let silent = ["run", "--performance", "none", "--midi", "none", "--black-box", "none"];
        let letoff = Path::new(env!("CARGO_BIN_EXE_letoff"));
        let mut command = folder.command(letoff, &[&silent[..], arguments].concat());
        command.stdout(File::create(folder.join("report")).expect("a file"));
        command.stderr(File::create(folder.join("complaints")).expect("a file"));
        let mut child = command.spawn().expect("a process");
        let (address, token) = eventually("a host", || {
            let ended = child.try_wait().expect("a process");
            assert!(ended.is_none(), "it ended: {}", folder.read("complaints"));
            match send(&folder.socket(), &Request::Where {}).ok()? {
                Ok(Reply::Where { address, token }) => Some((address, token)),
                other => unreachable!("{other:?}"),
            }
        });
        Self { folder, child, address, token }
    }

    /// What it has complained of so far.
    fn complaints(&self) -> String {
        self.folder.read("complaints")
    }

    fn dial(&self, token: Option<&str>) -> Dial {
        let (address, _pin) = self.address.split_once('#').unwrap_or((&self.address, ""));
        Dial { address: address.to_owned(), token: token.map(str::to_owned), pin: None }
    }
}

impl Drop for Host<'_> {
    fn drop(&mut self) {
        let id = i32::try_from(self.child.id()).ok().and_then(Pid::from_raw);
        let _gone = id.map(|id| kill_process(id, Signal::INT));
        let _ended = self.child.wait();
    }
}

/// A file of tokens that only this user reads.
fn tokens(folder: &Folder, text: &str) {
    let file = folder.write("tokens", text);
    std::fs::set_permissions(file, Permissions::from_mode(0o600)).expect("a file");
}

/// How a client stands when it is in or turned away.
fn standing(client: &Client) -> Standing {
    eventually("a standing", || Some(client.standing()).filter(|it| *it != Standing::Connecting))
}

/// Why somebody is not let in.
fn refusal(dial: Dial) -> String {
    let standing = standing(&Client::connect(dial, None));
    let Standing::Refused(why) = standing else { unreachable!("{standing:?}") };
    why
}

/// What becomes of setting a value of key 39, once the host runs.
fn set(dial: Dial) -> Result<(), String> {
    let mut client = Client::connect(dial, None);
    eventually("a connection", || (client.next() == Some(Arrival::Anew)).then_some(()));
    let changes = vec![Change { key: 39, parameter: "k2".into(), value: 900.0 }];
    let mut ticket = client.ask(Request::Set { changes: changes.clone() });
    eventually("an answer", || match client.next()? {
        Arrival::Reply { ticket: of, result } if of == ticket => {
            // It listens before its first tick.
            let is_early = result.as_ref().is_err_and(|why| why.contains("not running yet"));
            if is_early {
                ticket = client.ask(Request::Set { changes: changes.clone() });
            }
            (!is_early).then(|| result.map(drop))
        }
        Arrival::Reply { .. } | Arrival::Update { .. } | Arrival::Anew => None,
    })
}

const LOOPBACK: [&str; 2] = ["--listen", "127.0.0.1:0"];

#[test]
fn beyond_this_machine_only_with_tokens_and_tls() {
    let folder = Folder::new("beyond");
    tokens(&folder, "owner own\n");
    let refused = |options: &[&str], words: &[&str]| {
        // Not even a recording is begun.
        let run = ["run", "--record", "a.mcap", "--duration", "1"];
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
    let run = ["run", "--virtual-time", "--duration", "0.1", "--tokens", "tokens"];
    tokens(&folder, "viewer see\nadmin aaaa\nowner\n# ours\ntuner bb&bb\nowner see\n");
    let words = ["tokens: ", "line 2 is not", "line 3 is not", "line 5 has", "line 6 has"];
    folder.refuses(&run, 2, &words);
    let (_code, _out, err) = folder.letoff(&run);
    assert!(!err.contains("aaaa") && !err.contains("bb&bb"), "a secret is shown: {err}");
    // Or everybody would be an owner.
    tokens(&folder, "# nobody yet\n");
    folder.refuses(&run, 2, &["tokens: nobody is named", "`owner SECRET`"]);
    tokens(&folder, &"owner x\n".repeat(10_000));
    folder.refuses(&run, 2, &["tokens: ", "longer than 64 KiB"]);
    folder.refuses(&[&run[..5], &["nothing"]].concat(), 2, &["nothing: "]);
}

#[test]
fn a_file_of_tokens_that_others_read_is_pointed_out() {
    let folder = Folder::new("tokens-mode");
    let run = ["run", "--virtual-time", "--duration", "0.1", "--tokens", "tokens"];
    tokens(&folder, "owner own\n");
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
fn a_token_says_what_somebody_may_do() {
    let folder = Folder::new("roles");
    tokens(&folder, "viewer see\ntuner tune\nowner own\n");
    let host = Host::start(&folder, &[&LOOPBACK[..], &["--tokens", "tokens"]].concat());
    for wrong in [None, Some("sea"), Some("")] {
        assert!(refusal(host.dial(wrong)).contains("asks for a token"), "{wrong:?}");
    }
    let refused = set(host.dial(Some("see"))).expect_err("a viewer only watches");
    assert!(refused.contains("a viewer may not"), "{refused}");
    assert_eq!(set(host.dial(Some("tune"))), Ok(()));
    // Whoever may use the socket is the owner.
    assert_eq!(host.token.as_deref(), Some("own"));
    assert_eq!(set(host.dial(host.token.as_deref())), Ok(()));
}

#[test]
fn only_pages_that_are_named_may_connect() {
    let folder = Folder::new("origin");
    let ours = "https://app.example";
    let host = Host::start(&folder, &[&LOOPBACK[..], &["--origin", ours]].concat());
    let knock = |headers: &[(&str, &str)]| Stranger::knock(&host.address, headers).err();
    assert_eq!(knock(&[]), None, "a program, which is of no page");
    assert_eq!(knock(&[("Origin", ours)]), None);
    for foreign in ["https://evil.example", "http://app.example", "null"] {
        assert_eq!(knock(&[("Origin", foreign)]), Some(403), "{foreign}");
    }
    for none in ["null", "app.example", "https://app.example/", "*"] {
        folder.refuses(&["run", "--origin", none], 2, &[none, "as https://app.example"]);
    }
}

/// The fingerprint that a host has printed.
fn printed(complaints: &str) -> Fingerprint {
    let rest = complaints.split("certificate is ").nth(1).expect("a certificate");
    let text: String = rest.chars().take_while(|it| it.is_ascii_hexdigit() || *it == ':').collect();
    text.trim_end_matches(':').parse().expect("a fingerprint")
}

#[test]
fn the_fingerprint_that_is_printed_is_the_certificate_s() {
    let folder = Folder::new("tls");
    tokens(&folder, "owner own\n");
    let everywhere = ["--listen", "0.0.0.0:0", "--tokens", "tokens", "--tls", "self-made"];
    let first = {
        let host = Host::start(&folder, &everywhere);
        let pin = printed(&host.complaints());
        assert!(host.address.ends_with(&format!("#{pin}")), "{}", host.address);
        let dial = |pin| Dial { pin, ..host.dial(Some("own")) };
        assert_eq!(set(dial(Some(pin))), Ok(()));
        let text = refusal(dial(Some(Fingerprint([7; 32]))));
        assert!(text.contains("another certificate"), "{text}");
        assert!(refusal(dial(None)).contains("needs the fingerprint"));
        pin
    };
    // Tomorrow it is the same.
    let host = Host::start(&folder, &everywhere);
    assert_eq!(printed(&host.complaints()), first);
}

#[test]
fn a_certificate_that_cannot_be_had_is_refused_in_a_sentence() {
    let folder = Folder::new("tls-bad");
    folder.write("cert.pem", "no certificate");
    folder.write("key.pem", "no key");
    let refused = |tls: &str, words: &[&str]| {
        let run = ["run", "--performance", "none", "--midi", "none", "--duration", "1"];
        folder.refuses(&[&run[..], &LOOPBACK, &["--tls", tls]].concat(), 2, words);
    };
    refused("cert.pem", &["--tls cert.pem", "CHAIN.pem,KEY.pem", "self-made"]);
    refused("nothing.pem,key.pem", &["nothing.pem cannot be read"]);
    refused("cert.pem,key.pem", &["certificate"]);
    // Its folder cannot be made.
    folder.write(".local", "a file");
    refused("self-made", &["cannot be kept in", ".local/state/letoff"]);
}
