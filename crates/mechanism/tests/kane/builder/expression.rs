//! Expressions as text, for tests.

use std::collections::HashMap;

use mechanism::kane::graph::{BinaryFunction, Graph, Node, UnaryFunction};

pub(super) fn read(graph: &mut Graph, names: &HashMap<String, Node>, text: &str) -> Node {
    let mut reader = Reader { graph, names, text, left: text };
    let node = reader.sum();
    assert!(reader.left.trim().is_empty(), "{text}: {}", reader.left);
    node
}

struct Reader<'a> {
    graph: &'a mut Graph,
    names: &'a HashMap<String, Node>,
    text: &'a str,
    left: &'a str,
}

impl Reader<'_> {
    fn take(&mut self, symbol: &str) -> bool {
        self.left = self.left.trim_start();
        let rest = self.left.strip_prefix(symbol);
        self.left = rest.unwrap_or(self.left);
        rest.is_some()
    }

    fn sum(&mut self) -> Node {
        let mut sum = self.product();
        loop {
            if self.take("+") {
                let other = self.product();
                sum = self.graph.add(sum, other);
            } else if self.take("-") {
                let other = self.product();
                sum = self.graph.subtract(sum, other);
            } else {
                return sum;
            }
        }
    }

    fn product(&mut self) -> Node {
        let mut product = self.factor();
        loop {
            if self.take("*") {
                let other = self.factor();
                product = self.graph.multiply(product, other);
            } else if self.take("/") {
                let other = self.factor();
                product = self.graph.divide(product, other);
            } else {
                return product;
            }
        }
    }

    fn factor(&mut self) -> Node {
        if self.take("-") {
            let node = self.factor();
            return self.graph.negate(node);
        }
        let base = self.atom();
        if !self.take("^") {
            return base;
        }
        let exponent = self.factor();
        self.graph.binary(BinaryFunction::Power, base, exponent)
    }

    fn atom(&mut self) -> Node {
        if self.take("(") {
            let node = self.sum();
            assert!(self.take(")"), "{}: ) before {}", self.text, self.left);
            return node;
        }
        let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '\'' || c == '.';
        let end = self.left.find(|c| !is_part(c)).unwrap_or(self.left.len());
        let (word, rest) = self.left.split_at(end);
        self.left = rest;
        if let Ok(number) = word.parse::<f64>() {
            return self.graph.constant(number);
        }
        if self.take("(") {
            return self.call(word);
        }
        *self.names.get(word).unwrap_or_else(|| panic!("{}: what is {word:?}?", self.text))
    }

    fn call(&mut self, function: &str) -> Node {
        let mut arguments = vec![self.sum()];
        while self.take(",") {
            arguments.push(self.sum());
        }
        assert!(self.take(")"), "{}: ) before {}", self.text, self.left);
        let unary = match function {
            "sin" => UnaryFunction::Sin,
            "cos" => UnaryFunction::Cos,
            "sqrt" => UnaryFunction::Sqrt,
            "exp" => UnaryFunction::Exp,
            "tanh" => UnaryFunction::Tanh,
            "atan2" => return self.graph.binary(BinaryFunction::Atan2, arguments[0], arguments[1]),
            "hypot" => return self.graph.binary(BinaryFunction::Hypot, arguments[0], arguments[1]),
            "max" => return self.graph.binary(BinaryFunction::Max, arguments[0], arguments[1]),
            _ => panic!("{}: what is {function}()?", self.text),
        };
        self.graph.unary(unary, arguments[0])
    }
}
