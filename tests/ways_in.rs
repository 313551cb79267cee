//! Every public type of a library has a way in: an item that another crate names leads to it.
//!
//! A type is reached if product code of another crate names it, or an example of `pode`, or a
//! reached item of its own crate. The compiler cannot check it: it counts a public item as used.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use syn::visit::{self, Visit};
use syn::{Attribute, Ident, Item, Macro, Type, Visibility};

use crate::sources::{self, Source};

struct NamedItem {
    /// Name of a function or type; for an `impl`, its type's.
    name: String,
    is_public_type: bool,
    names: BTreeSet<String>,
    module: Vec<String>,
}

#[test]
fn every_public_type_of_a_library_has_a_way_in() {
    let mut crates = BTreeMap::<String, Vec<NamedItem>>::new();
    let mut programs = BTreeSet::new();
    for source in sources::all() {
        if source.path.ends_with("src/main.rs") {
            programs.insert(source.room.clone());
        }
        crates.entry(source.room.clone()).or_default().extend(items(&source));
    }
    let examples = sources::examples(Path::new("crates/pode/examples"));
    let of_examples: BTreeSet<String> = examples.iter().flat_map(names_of_all).collect();
    let mut found = Vec::new();
    for (name, own) in crates.iter().filter(|(name, _)| !programs.contains(*name)) {
        let others = crates.iter().filter(|(other, _)| *other != name);
        let mut named: BTreeSet<&str> =
            others.flat_map(|(_, items)| items).flat_map(|it| &it.names).map(|it| &**it).collect();
        if name == "pode" {
            named.extend(of_examples.iter().map(|it| &**it));
        }
        found.extend(unreached(own, named).map(|it| format!("{name}::{it}")));
    }
    assert!(found.is_empty(), "no way leads to\n{}", found.join("\n"));
}

fn unreached<'a>(
    items: &'a [NamedItem],
    named: BTreeSet<&'a str>,
) -> impl Iterator<Item = String> + 'a {
    let mut reached = named.clone();
    let mut waiting: Vec<&str> = named.into_iter().collect();
    while let Some(name) = waiting.pop() {
        for item in items.iter().filter(|it| it.name == name) {
            waiting.extend(item.names.iter().map(|it| &**it).filter(|it| reached.insert(it)));
        }
    }
    let lost = items.iter().filter(move |it| it.is_public_type && !reached.contains(&*it.name));
    lost.map(|it| format!("{}::{}", it.module.join("::"), it.name))
}

fn items(source: &Source) -> Vec<NamedItem> {
    let mut all = Vec::new();
    collect(&source.syntax.items, &source.module, &mut all);
    all
}

#[expect(clippy::wildcard_enum_match_arm, reason = "an enum of syn that may grow")]
fn collect(items: &[Item], module: &[String], all: &mut Vec<NamedItem>) {
    for item in items {
        let (name, is_public_type) = match item {
            Item::Mod(inner) => {
                collect(inner.content.as_ref().map_or(&[][..], |it| &it.1), module, all);
                continue;
            }
            Item::Use(_) | Item::ExternCrate(_) => continue,
            Item::Struct(it) => (it.ident.to_string(), is_public(&it.vis)),
            Item::Enum(it) => (it.ident.to_string(), is_public(&it.vis)),
            Item::Trait(it) => (it.ident.to_string(), is_public(&it.vis)),
            Item::Type(it) => (it.ident.to_string(), is_public(&it.vis)),
            Item::Fn(it) => (it.sig.ident.to_string(), false),
            Item::Const(it) => (it.ident.to_string(), false),
            Item::Static(it) => (it.ident.to_string(), false),
            Item::Impl(it) => (type_name(&it.self_ty), false),
            Item::Macro(it) => (it.ident.as_ref().map_or(String::new(), Ident::to_string), false),
            _ => (String::new(), false),
        };
        let mut names = IdentifierSet::default();
        names.visit_item(item);
        all.push(NamedItem { name, is_public_type, names: names.0, module: module.to_vec() });
    }
}

fn names_of_all(source: &Source) -> BTreeSet<String> {
    items(source).into_iter().flat_map(|it| it.names).collect()
}

const fn is_public(visibility: &Visibility) -> bool {
    matches!(visibility, Visibility::Public(_))
}

#[expect(clippy::wildcard_enum_match_arm, reason = "an enum of syn that may grow")]
fn type_name(of: &Type) -> String {
    match of {
        Type::Path(it) => it.path.segments.last().map_or(String::new(), |it| it.ident.to_string()),
        Type::Reference(it) => type_name(&it.elem),
        _ => String::new(),
    }
}

#[derive(Default)]
struct IdentifierSet(BTreeSet<String>);

impl IdentifierSet {
    fn add_words(&mut self, text: &str) {
        let words = text.split(|it: char| !it.is_alphanumeric() && it != '_');
        self.0.extend(words.map(str::to_owned));
    }
}

impl<'ast> Visit<'ast> for IdentifierSet {
    fn visit_ident(&mut self, ident: &'ast Ident) {
        self.0.insert(ident.to_string());
    }

    fn visit_macro(&mut self, it: &'ast Macro) {
        self.add_words(&it.tokens.to_string());
        visit::visit_macro(self, it);
    }

    fn visit_attribute(&mut self, it: &'ast Attribute) {
        if let syn::Meta::List(list) = &it.meta {
            self.add_words(&list.tokens.to_string());
        }
    }
}
