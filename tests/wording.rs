//! One word for one thing, and comments that say something.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};
use syn::{
    Attribute, Expr, Field, ImplItemFn, Item, ItemConst, ItemEnum, ItemFn, ItemImpl, ItemStruct,
    ItemTrait, ItemType, Lit, Meta, TraitItemFn, Variant, Visibility,
};

use crate::sources::{self, Source};

/// Names of types that may stand in more than one crate, with the reason.
const SHARED: &[(&str, &str)] = &[
    ("Epoch", "an interval in which one mode holds, drawn by the window and by plots"),
    ("Error", "the errors of a crate"),
    ("Mode", "the contact configurations of a model"),
];

/// Words of a comment from which on it may say something.
const FEWEST_WORDS: usize = 4;

#[test]
fn a_type_s_name_stands_for_one_thing_in_the_whole_workspace() {
    let mut rooms = BTreeMap::<String, BTreeSet<String>>::new();
    for source in sources::all() {
        for name in source.syntax.items.iter().filter_map(type_name) {
            rooms.entry(name).or_default().insert(source.room.clone());
        }
    }
    let shared: BTreeMap<_, _> = rooms.iter().filter(|(_, rooms)| 1 < rooms.len()).collect();
    let may = |name: &str| SHARED.iter().any(|(may, _)| *may == name);
    let double = shared.iter().filter(|(name, _)| !may(name));
    let double: Vec<_> = double.map(|(name, rooms)| format!("{name}: {rooms:?}")).collect();
    assert!(double.is_empty(), "one word for one thing:\n{}", double.join("\n"));
    for (name, _) in SHARED {
        assert!(shared.contains_key(&(*name).to_owned()), "{name} is not shared any more");
    }
}

#[test]
fn comments_say_something() {
    let mut empty = Vec::new();
    for source in sources::all() {
        let mut comments = Comments { source: &source, empty: &mut empty };
        comments.visit_file(&source.syntax);
    }
    assert!(empty.is_empty(), "{} comments say nothing:\n{}", empty.len(), empty.join("\n"));
}

/// Folders of what prints paths of its own making, of devices, or on a developer's terminal.
const PRINT_RAW: [&str; 3] = ["dashboard/src", "boards/src/links", "xtask/src"];

#[test]
fn names_of_files_are_escaped_wherever_they_are_printed() {
    let is_raw = |source: &Source| {
        let text = std::fs::read_to_string(&source.path).unwrap_or_default();
        let prints_raw = PRINT_RAW.iter().any(|it| source.path.to_string_lossy().contains(it));
        !prints_raw && text.contains(".display()")
    };
    let raw: Vec<_> = sources::all().into_iter().filter(is_raw).map(|it| it.path).collect();
    assert!(raw.is_empty(), "use documents::shown instead of display(): {raw:?}");
}

#[expect(clippy::wildcard_enum_match_arm, reason = "the enum of items is open")]
fn type_name(item: &Item) -> Option<String> {
    match item {
        Item::Enum(it) => Some(it.ident.to_string()),
        Item::Struct(it) => Some(it.ident.to_string()),
        Item::Trait(it) => Some(it.ident.to_string()),
        Item::Type(it) => Some(it.ident.to_string()),
        _ => None,
    }
}

/// Looks at every comment of a file, and for one at each public type and function.
struct Comments<'s, 'e> {
    source: &'s Source,
    empty: &'e mut Vec<String>,
}

impl Comments<'_, '_> {
    fn public(&mut self, visibility: &Visibility, attributes: &[Attribute], name: &str) {
        let is_public = matches!(visibility, Visibility::Public(_));
        if is_public && text(attributes).is_empty() {
            self.empty.push(format!("{}: {name} has none", self.source.path.display()));
        }
        self.any(attributes, name);
    }

    fn any(&mut self, attributes: &[Attribute], name: &str) {
        let text = text(attributes);
        let words = text.split_whitespace().count();
        if (1..FEWEST_WORDS).contains(&words) && !has_formula(&text) {
            let path = self.source.path.display();
            self.empty.push(format!("{path}: {name}: {}", text.trim()));
        }
    }
}

/// Whether a comment gives a unit, a symbol or a link, which are worth a comment of few words.
fn has_formula(text: &str) -> bool {
    text.contains(['(', '[', '`', '\'', '+']) || !text.is_ascii()
}

/// What the documentation comments say.
fn text(attributes: &[Attribute]) -> String {
    let line = |it: &Attribute| {
        let Meta::NameValue(pair) = &it.meta else { return None };
        let Expr::Lit(value) = &pair.value else { return None };
        let Lit::Str(text) = &value.lit else { return None };
        pair.path.is_ident("doc").then(|| text.value())
    };
    attributes.iter().filter_map(line).collect::<Vec<_>>().join("\n")
}

impl<'a> Visit<'a> for Comments<'_, '_> {
    fn visit_item_struct(&mut self, it: &'a ItemStruct) {
        self.public(&it.vis, &it.attrs, &it.ident.to_string());
        visit::visit_item_struct(self, it);
    }

    fn visit_item_enum(&mut self, it: &'a ItemEnum) {
        self.public(&it.vis, &it.attrs, &it.ident.to_string());
        visit::visit_item_enum(self, it);
    }

    fn visit_item_trait(&mut self, it: &'a ItemTrait) {
        self.public(&it.vis, &it.attrs, &it.ident.to_string());
        visit::visit_item_trait(self, it);
    }

    fn visit_item_type(&mut self, it: &'a ItemType) {
        self.public(&it.vis, &it.attrs, &it.ident.to_string());
    }

    fn visit_item_const(&mut self, it: &'a ItemConst) {
        self.any(&it.attrs, &it.ident.to_string());
    }

    fn visit_item_fn(&mut self, it: &'a ItemFn) {
        self.public(&it.vis, &it.attrs, &it.sig.ident.to_string());
    }

    fn visit_item_impl(&mut self, it: &'a ItemImpl) {
        self.any(&it.attrs, "impl");
        visit::visit_item_impl(self, it);
    }

    fn visit_impl_item_fn(&mut self, it: &'a ImplItemFn) {
        self.public(&it.vis, &it.attrs, &it.sig.ident.to_string());
    }

    fn visit_trait_item_fn(&mut self, it: &'a TraitItemFn) {
        self.public(
            &Visibility::Public(syn::token::Pub::default()),
            &it.attrs,
            &it.sig.ident.to_string(),
        );
    }

    fn visit_field(&mut self, it: &'a Field) {
        self.any(&it.attrs, &it.ident.as_ref().map(ToString::to_string).unwrap_or_default());
    }

    fn visit_variant(&mut self, it: &'a Variant) {
        self.any(&it.attrs, &it.ident.to_string());
        visit::visit_variant(self, it);
    }
}
