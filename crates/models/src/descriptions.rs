//! The descriptions of the models of the program, by their names.

/// Name and text of each description, in the order of the catalogue.
pub const DESCRIPTIONS: [(&str, &str); 6] = [
    ("key-hammer-springs", include_str!("key_hammer_springs/model.toml")),
    ("key-hammer-rigid", include_str!("key_hammer_rigid/model.toml")),
    ("reduced-grand", include_str!("reduced_grand/model.toml")),
    ("bouncing-ball", include_str!("bouncing_ball/model.toml")),
    ("cart-pendulum", include_str!("cart_pendulum/model.toml")),
    ("spring-wall", include_str!("spring_wall/model.toml")),
];

/// Returns the description of the model called `name`, if the program has one.
pub fn description(name: &str) -> Option<&'static str> {
    DESCRIPTIONS.iter().find(|(known, _text)| *known == name).map(|(_name, text)| *text)
}
