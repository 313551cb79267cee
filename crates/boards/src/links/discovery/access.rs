//! Rights of the user on a device, checked without opening it.

use std::path::Path;

use super::Obstacle;

#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(super) struct User {
    id: Option<u32>,
    groups: Vec<u32>,
}

impl User {
    pub(super) fn current() -> Self {
        std::fs::read_to_string("/proc/self/status")
            .map(|text| Self::parse(&text))
            .unwrap_or_default()
    }

    fn parse(status: &str) -> Self {
        let numbers = |name: &str| -> Vec<u32> {
            let line = status.lines().find_map(|line| line.strip_prefix(name));
            line.unwrap_or_default().split_whitespace().flat_map(str::parse).collect()
        };
        // The four are real, effective, saved, file system.
        let effective = |ids: Vec<u32>| ids.get(1).copied();
        let mut groups = numbers("Groups:");
        groups.extend(effective(numbers("Gid:")));
        Self { id: effective(numbers("Uid:")), groups }
    }

    #[cfg(unix)]
    pub(super) fn obstacle(&self, path: &Path) -> Option<Obstacle> {
        use std::os::unix::fs::MetadataExt as _;

        let device = std::fs::metadata(path).ok()?;
        let rights = Rights { owner: device.uid(), group: device.gid(), mode: device.mode() };
        if self.may_use(&rights)? {
            return None;
        }
        let names = std::fs::read_to_string("/etc/group").unwrap_or_default();
        let group = rights.group_may().then(|| group_name(&names, rights.group));
        Some(Obstacle::Forbidden { path: path.to_owned(), group })
    }

    /// Returns `None`: outside Unix, rights are unknown before a port is opened.
    #[cfg(not(unix))]
    pub(super) fn obstacle(&self, _path: &Path) -> Option<Obstacle> {
        None
    }

    /// Returns `true` if this user may read and write; `None` if the user is unknown.
    #[cfg(unix)]
    fn may_use(&self, rights: &Rights) -> Option<bool> {
        let id = self.id?;
        Some(if id == 0 {
            true
        } else if id == rights.owner {
            rights.mode & 0o600 == 0o600
        } else if self.groups.contains(&rights.group) {
            rights.group_may()
        } else {
            rights.mode & 0o006 == 0o006
        })
    }
}

#[cfg(unix)]
struct Rights {
    owner: u32,
    group: u32,
    mode: u32,
}

#[cfg(unix)]
impl Rights {
    const fn group_may(&self) -> bool {
        self.mode & 0o060 == 0o060
    }
}

#[cfg(unix)]
fn group_name(names: &str, group: u32) -> String {
    let number = group.to_string();
    let fields = |line: &str| {
        let mut fields = line.split(':');
        let name = fields.next()?.to_owned();
        (fields.nth(1)? == number).then_some(name)
    };
    names.lines().find_map(fields).unwrap_or(number)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;

    const STATUS: &str = "Name:\tletoff\nUid:\t1000\t1000\t1000\t1000\n\
                          Gid:\t1000\t1000\t1000\t1000\nGroups:\t27 44 1000 \n";
    const DIALOUT: u32 = 20;

    fn port(mode: u32) -> Rights {
        Rights { owner: 0, group: DIALOUT, mode }
    }

    #[test]
    fn a_port_of_dialout_is_for_its_members() {
        let mut user = User::parse(STATUS);
        assert_eq!(user.may_use(&port(0o020_660)), Some(false));
        user.groups.push(DIALOUT);
        assert_eq!(user.may_use(&port(0o020_660)), Some(true));
    }

    #[test]
    fn root_and_everybody_may_what_they_may() {
        assert_eq!(User::parse(STATUS).may_use(&port(0o020_666)), Some(true));
        let root = User { id: Some(0), groups: Vec::new() };
        assert_eq!(root.may_use(&port(0o020_600)), Some(true));
        assert_eq!(User::default().may_use(&port(0o020_600)), None);
    }

    #[test]
    fn the_obstacle_names_the_group_and_what_to_do() {
        let group = group_name("root:x:0:\ndialout:x:20:anna\n", DIALOUT);
        let obstacle = Obstacle::Forbidden { path: "/dev/ttyACM0".into(), group: Some(group) };
        assert_eq!(
            obstacle.to_string(),
            "you may not read and write /dev/ttyACM0; join the group dialout: \
             sudo usermod -aG dialout $USER, then log in again"
        );
        assert_eq!(group_name("", 7), "7");
    }
}
