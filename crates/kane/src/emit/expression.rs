//! Expressions with as few brackets as their order of evaluation needs.

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The text of an expression.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct RustExpression {
    pub(super) text: String,
    pub(super) binding: Binding,
}

impl RustExpression {
    /// Returns an expression that needs no brackets anywhere.
    pub(super) const fn atom(text: String) -> Self {
        Self { text, binding: Binding::Atom }
    }

    /// Returns a number's literal.
    pub(super) fn number(text: String) -> Self {
        let binding = if text.starts_with('-') { Binding::Sign } else { Binding::Atom };
        Self { text, binding }
    }

    /// Returns `x operator y`, computed in this order.
    pub(super) fn infix(x: &Self, operator: &str, y: &Self) -> Self {
        let (binding, right) = match operator {
            "+" | "-" => (Binding::Sum, Binding::Product),
            _ => (Binding::Product, Binding::Sign),
        };
        let text = format!("{} {operator} {}", x.within(binding), y.within(right));
        Self { text, binding }
    }

    /// Returns the expression with the other sign.
    pub(super) fn negated(x: &Self) -> Self {
        Self { text: format!("-{}", x.within(Binding::Atom)), binding: Binding::Sign }
    }

    /// Returns a call of a function.
    pub(super) fn call(function: &str, arguments: &[&Self]) -> Self {
        let arguments: Vec<_> = arguments.iter().map(|it| it.text.as_str()).collect();
        Self::atom(format!("{function}({})", arguments.join(", ")))
    }

    /// The text, in brackets where it holds together less than `binding`.
    pub(super) fn within(&self, binding: Binding) -> String {
        if self.binding < binding { format!("({})", self.text) } else { self.text.clone() }
    }
}
