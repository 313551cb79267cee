//! No crate has an import circle: sibling modules use each other in one direction at most, also
//! through a parent's re-exports.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};
use syn::{Ident, ItemUse, Path, UseTree};

use crate::sources::{self, Source};

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

fn circles(room: &str, all: &[Source]) -> Vec<String> {
    let names = Names::new(all);
    let mut levels = BTreeMap::<Vec<String>, Edges>::new();
    for source in all {
        for path in paths_of(source).found {
            let known = names.resolve(&source.module, &path, DEEPEST_USE);
            if let Some((parent, edge)) = known.and_then(|it| siblings(&source.module, &it)) {
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

/// Returns the common parent of both modules, and its children with them; `None` if nested.
fn siblings(one: &[String], other: &[String]) -> Option<(Vec<String>, (String, String))> {
    let shared = one.iter().zip(other).take_while(|(a, b)| a == b).count();
    let edge = (one.get(shared)?.clone(), other.get(shared)?.clone());
    Some((one[..shared].to_vec(), edge))
}

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

/// Maximum of re-exports followed for one name.
const DEEPEST_USE: usize = 8;

struct Names<'a> {
    modules: BTreeSet<&'a [String]>,
    used: BTreeMap<(&'a [String], String), Vec<String>>,
}

impl<'a> Names<'a> {
    fn new(all: &'a [Source]) -> Self {
        let mut used = BTreeMap::new();
        for source in all {
            for (name, path) in paths_of(source).used {
                used.insert((source.module.as_slice(), name), path);
            }
        }
        Self { modules: all.iter().map(|it| it.module.as_slice()).collect(), used }
    }

    fn resolve(&self, module: &[String], path: &[String], deepest: usize) -> Option<Vec<String>> {
        let up = path.iter().take_while(|it| *it == "super").count();
        let (mut known, rest) = match path.first()?.as_str() {
            "crate" => (Vec::new(), &path[1..]),
            "self" => (module.to_vec(), &path[1..]),
            "super" => (module[..module.len().checked_sub(up)?].to_vec(), &path[up..]),
            first => {
                let child = [module, &[first.to_owned()]].concat();
                (self.modules.contains(child.as_slice()).then(|| module.to_vec())?, path)
            }
        };
        for part in rest {
            known.push(part.clone());
            if !self.modules.contains(known.as_slice()) {
                known.pop();
                return Some(self.behind_use(&known, part, deepest).unwrap_or(known));
            }
        }
        Some(known)
    }

    fn behind_use(&self, module: &[String], name: &str, deepest: usize) -> Option<Vec<String>> {
        let path = self.used.get(&(module, name.to_owned()))?;
        self.resolve(module, path, deepest.checked_sub(1)?)
    }
}

fn paths_of(source: &Source) -> Paths {
    let mut paths = Paths { found: Vec::new(), used: Vec::new() };
    paths.visit_file(&source.syntax);
    paths
}

struct Paths {
    found: Vec<Vec<String>>,
    used: Vec<(String, Vec<String>)>,
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
            UseTree::Name(it) => self.end(prefix, &it.ident, &it.ident),
            UseTree::Rename(it) => self.end(prefix, &it.ident, &it.rename),
            UseTree::Glob(_) => self.found.push(prefix.clone()),
        }
    }

    fn end(&mut self, prefix: &[String], name: &Ident, known_as: &Ident) {
        let path = [prefix, &[name.to_string()]].concat();
        self.used.push((known_as.to_string(), path.clone()));
        self.found.push(path);
    }
}
