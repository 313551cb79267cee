use instruments::{DoesNotLoad, LARGEST, MAX_CODED_CONTACTS};

pub(crate) fn message(why: DoesNotLoad) -> String {
    let (states, constants) = LARGEST;
    match why {
        DoesNotLoad::States(found) => format!("the model has {found} states, more than {states}"),
        DoesNotLoad::Constants(found) => format!(
            "the model has {found} parameters and numbers that follow from them, more than \
             {constants}"
        ),
        DoesNotLoad::Modes(found) => format!("the model has {found} modes, too many"),
        DoesNotLoad::Contacts(found) => {
            format!("the model has {found} contacts, more than {MAX_CODED_CONTACTS}")
        }
        DoesNotLoad::Guards => "the model has too many contacts and guards".to_owned(),
    }
}
