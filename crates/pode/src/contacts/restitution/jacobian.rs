//! Maps between bodies and contacts: speeds to rates of gaps, and impulses to speeds.

use super::Contacts;

/// N contacts between bodies with D generalized speeds.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ContactJacobian<const N: usize, const D: usize> {
    /// Row i gives the rate of gap i from the generalized speeds.
    pub rows: [[f64; D]; N],
    /// Inverse of the mass matrix (1/kg).
    pub inverse_mass: [[f64; D]; D],
}

impl<const N: usize, const D: usize> ContactJacobian<N, D> {
    pub fn contacts(&self, speeds: &[f64; D], restitution: [f64; N]) -> Contacts<N> {
        let gains: [[f64; D]; N] = self.rows.map(|row| self.gained_per(&row));
        Contacts {
            delassus: core::array::from_fn(|i| {
                core::array::from_fn(|j| dot(&self.rows[i], &gains[j]))
            }),
            velocities: self.rows.map(|row| dot(&row, speeds)),
            restitution,
        }
    }

    /// Returns the generalized speeds after `impulses` (N s) at the contacts: u + M⁻¹ Jᵀ p.
    pub fn speeds_after(&self, speeds: &[f64; D], impulses: &[f64; N]) -> [f64; D] {
        let mut after = *speeds;
        for (row, impulse) in self.rows.iter().zip(impulses).filter(|(_, p)| **p != 0.0) {
            for (speed, gain) in after.iter_mut().zip(self.gained_per(row)) {
                *speed += impulse * gain;
            }
        }
        after
    }

    fn gained_per(&self, row: &[f64; D]) -> [f64; D] {
        self.inverse_mass.map(|inverse| dot(&inverse, row))
    }
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
