//! Limits of a model's lists.

use pode::contacts::{
    ContactGuard, ContactIndices, ContactSpec, ContactSystem, CoupledFrictions, FrictionSpec,
    FrictionalContacts, GuardedContacts, MAX_FRICTIONS, TooManyGuards, WithContacts,
};
use pode::{GuardId, GuardSpec, GuardValue, Guarded as _, MAX_GUARDS};

struct Lists {
    contacts: Vec<ContactSpec>,
    structure: Vec<GuardSpec>,
}

impl ContactSystem for Lists {
    type Structure = bool;
    type State = [f64; 1];
    type Input = ();
    const COORDS: usize = 1;

    fn contacts(&self) -> &[ContactSpec] {
        &self.contacts
    }

    fn gap(&self, _: bool, _: usize, x: &[f64; 1], (): &()) -> GuardValue {
        GuardValue::new(x[0], 0.0)
    }

    fn derivative(&self, _: bool, _: ContactIndices, _: &[f64; 1], (): &()) -> [f64; 1] {
        [0.0]
    }
}

impl CoupledFrictions for Lists {}

impl FrictionalContacts for Lists {}

impl GuardedContacts for Lists {
    fn structure_guards(&self) -> &[GuardSpec] {
        &self.structure
    }

    fn is_watched(&self, structure: bool, guard: GuardId) -> bool {
        structure == (guard == GuardId(0))
    }
}

fn error(contacts: usize, frictions: usize, structure: u8) -> Option<TooManyGuards> {
    let friction = FrictionSpec::new("f", 1.0, 1.0);
    let mut list = vec![ContactSpec::new("c", 1.0); contacts];
    list.extend(vec![ContactSpec::bearing("f", friction); frictions]);
    let structure = (0..structure).map(|id| GuardSpec::new(id, "s")).collect();
    WithContacts::new(Lists { contacts: list, structure }).err()
}

#[test]
fn more_parts_than_fit_are_refused() {
    assert_eq!(error(MAX_GUARDS - 3, 2, 1), None);
    assert_eq!(error(MAX_GUARDS - 3, 2, 2), Some(TooManyGuards::Guards));
    assert_eq!(error(65, 0, 0), Some(TooManyGuards::Contacts(65)));
    assert_eq!(error(0, MAX_FRICTIONS, 0), None);
    assert_eq!(error(0, MAX_FRICTIONS + 1, 0), Some(TooManyGuards::Frictions));
    let far = Lists { contacts: vec![], structure: vec![GuardSpec::new(128, "s")] };
    assert_eq!(WithContacts::new(far).err(), Some(TooManyGuards::Id(GuardId(128))));
}

#[test]
fn a_guard_tells_what_it_belongs_to_and_where_it_is_watched() {
    let friction = FrictionSpec::new("f", 1.0, 1.0);
    let contacts = vec![ContactSpec::new("c", 1.0), ContactSpec::bearing("f", friction)];
    let structure = vec![GuardSpec::new(0, "s"), GuardSpec::new(1, "t")];
    let model = WithContacts::new(Lists { contacts, structure }).unwrap();
    for structure in [true, false] {
        let (mode, _) = model.start(structure, &[1.0], &());
        let watched = model.guards(mode).iter().filter(|spec| model.is_watched(mode, spec.id));
        let watched: Vec<_> = watched.map(|spec| ContactGuard::of(spec.id)).collect();
        let own = ContactGuard::Structure(GuardId(u8::from(!structure)));
        assert_eq!(watched, [ContactGuard::Gap(0), ContactGuard::Friction(1), own]);
    }
}
