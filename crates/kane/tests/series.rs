//! The Taylor series of described models.

use kane::derive_model;

use crate::shipped::{Folder, files};

#[test]
fn sizes() {
    for file in files() {
        let text = std::fs::read_to_string(&file).unwrap();
        let model = derive_model(&file.display().to_string(), &text, &Folder).unwrap();
        for mode in model.program.table.modes {
            println!("{} {}: {:?}", model.program.table.name, mode.name, mode.series);
            if let Some(s) = mode.series {
                let t = model.program.tapes();
                println!("  start {} step {} derivative {}", t[s.start as usize].instructions.len(), t[s.step as usize].instructions.len(), t[mode.derivative as usize].instructions.len());
            }
        }
    }
}
