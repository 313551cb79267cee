//! No crate holds too much, and no import circle is in any: modules beside each other know each
//! other in one direction at most.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};
use syn::{ItemUse, Path, UseTree};

use crate::sources::{self, Source};

/// Of all lines, the share that one crate may hold: an eighth.
const LARGEST_SHARE: usize = 8;

#[test]
fn no_crate_holds_more_than_an_eighth_of_the_code() {
    let mut lines = BTreeMap::<String, usize>::new();
    for source in sources::all() {
        *lines.entry(source.room).or_default() += source.lines;
    }
    let all: usize = lines.values().sum();
    for (room, lines) in lines {
        assert!(
            lines * LARGEST_SHARE <= all,
            "{room} holds {lines} of {all} lines: split it along a wall that stands"
        );
    }
}

#[test]
fn modules_beside_each_other_have_no_import_circle() {
    let mut rooms = BTreeMap::<String, Vec<Source>>::new();
    for source in sources::all() {
        rooms.entry(source.room.clone()).or_default().push(source);
    }
    let circles: Vec<String> = rooms.iter().flat_map(|(room, all)| circles(room, all)).collect();
    assert!(circles.is_empty(), "import circles:\n{}", circles.join("\n"));
}

#[test]
fn a_circle_of_three_is_found_and_a_parent_with_its_part_is_none() {
    let edge = |from: &str, to: &str| (from.to_owned(), to.to_owned());
    let graph = [edge("a", "b"), edge("b", "c"), edge("c", "a"), edge("c", "d")].into();
    assert_eq!(in_circles(&graph), ["a", "b", "c"].map(str::to_owned).into());
    assert!(in_circles(&[edge("a", "b"), edge("b", "d")].into()).is_empty());
    let shared = siblings(&["x".into(), "a".into()], &["x".into(), "b".into(), "c".into()]);
    assert_eq!(shared, Some((vec!["x".to_owned()], edge("a", "b"))));
    assert_eq!(siblings(&["x".into()], &["x".into(), "b".into()]), None);
}

type Edges = BTreeSet<(String, String)>;

/// Each circle of a crate, as a sentence.
fn circles(room: &str, all: &[Source]) -> Vec<String> {
    let modules: BTreeSet<&[String]> = all.iter().map(|it| it.module.as_slice()).collect();
    let mut levels = BTreeMap::<Vec<String>, Edges>::new();
    for source in all {
        let mut paths = Paths { found: Vec::new() };
        paths.visit_file(&source.syntax);
        for path in paths.found {
            let edge = resolve(&modules, &source.module, &path)
                .and_then(|known| siblings(&source.module, &known));
            if let Some((parent, edge)) = edge {
                levels.entry(parent).or_default().insert(edge);
            }
        }
    }
    let told = |(parent, edges): (&Vec<String>, &Edges)| {
        let circle: Vec<String> = in_circles(edges).into_iter().collect();
        let place = parent.join("::");
        (!circle.is_empty()).then(|| format!("{room}, in {place:?}: {}", circle.join(", ")))
    };
    levels.iter().filter_map(told).collect()
}

/// The parent that both modules have, and the children of it in which they lie; none if one
/// holds the other.
fn siblings(one: &[String], other: &[String]) -> Option<(Vec<String>, (String, String))> {
    let shared = one.iter().zip(other).take_while(|(a, b)| a == b).count();
    let edge = (one.get(shared)?.clone(), other.get(shared)?.clone());
    Some((one[..shared].to_vec(), edge))
}

/// The nodes from which a way leads back to themselves.
fn in_circles(edges: &Edges) -> BTreeSet<String> {
    let nodes = edges.iter().map(|(from, _)| from);
    nodes.filter(|node| reachable(edges, node).contains(*node)).cloned().collect()
}

fn reachable(edges: &Edges, start: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut open = vec![start.to_owned()];
    while let Some(node) = open.pop() {
        for (_, to) in edges.iter().filter(|(from, _)| *from == node) {
            if found.insert(to.clone()) {
                open.push(to.clone());
            }
        }
    }
    found
}

/// The module that a path of `module` leads to; none if it leads out of the crate.
fn resolve(
    modules: &BTreeSet<&[String]>,
    module: &[String],
    path: &[String],
) -> Option<Vec<String>> {
    let up = path.iter().take_while(|it| *it == "super").count();
    let (mut known, rest) = match path.first()?.as_str() {
        "crate" => (Vec::new(), &path[1..]),
        "self" => (module.to_vec(), &path[1..]),
        "super" => (module[..module.len().checked_sub(up)?].to_vec(), &path[up..]),
        first => {
            let child = [module, &[first.to_owned()]].concat();
            (modules.contains(child.as_slice()).then(|| module.to_vec())?, path)
        }
    };
    for part in rest {
        known.push(part.clone());
        if !modules.contains(known.as_slice()) {
            known.pop();
            break;
        }
    }
    Some(known)
}

/// Collects all paths of a file, those of `use` with their trees expanded.
struct Paths {
    found: Vec<Vec<String>>,
}

impl<'a> Visit<'a> for Paths {
    fn visit_item_use(&mut self, item: &'a ItemUse) {
        self.expand(&item.tree, &mut Vec::new());
    }

    fn visit_path(&mut self, path: &'a Path) {
        self.found.push(path.segments.iter().map(|it| it.ident.to_string()).collect());
        visit::visit_path(self, path);
    }
}

impl Paths {
    fn expand(&mut self, tree: &UseTree, prefix: &mut Vec<String>) {
        match tree {
            UseTree::Path(it) => {
                prefix.push(it.ident.to_string());
                self.expand(&it.tree, prefix);
                prefix.pop();
            }
            UseTree::Group(it) => it.items.iter().for_each(|tree| self.expand(tree, prefix)),
            UseTree::Name(it) => self.end(prefix, it.ident.to_string()),
            UseTree::Rename(it) => self.end(prefix, it.ident.to_string()),
            UseTree::Glob(_) => self.found.push(prefix.clone()),
        }
    }

    fn end(&mut self, prefix: &[String], name: String) {
        self.found.push([prefix, &[name]].concat());
    }
}
