//! Straight and Hertz pieces side by side in lock step: each lane is on one of them.

use super::power::DraggedHertz;
use super::straight::DraggedStraight;
use super::{Field, Motion, Quad};
use crate::integrate::lanes::Lane;

/// Without drag: g = −(a + b y + c y⁴). A term that the piece of a lane lacks has the coefficient zero. The result has the
/// same bits as with [`super::straight::Straight`] and [`super::power::Power`].
#[derive(Debug, Clone, Copy)]
pub struct Mixed<T> {
    pub a: T,
    pub b: T,
    pub c: T,
    /// 1 on a straight piece, 0 on a Hertz piece.
    pub is_straight: T,
}

impl<T: Lane> Field<T> for Mixed<T> {
    // of some lanes: see `duration`
    const IS_TIME: bool = false;
    #[inline(always)]
    fn scaled(self, factor: T) -> Self {
        Self { a: self.a * factor, b: self.b * factor, c: self.c * factor, ..self }
    }
    #[inline(always)]
    fn g(self, y: T) -> T {
        let square = y * y;
        -((self.a + self.b * y) + self.c * (square * square))
    }
    #[inline(always)]
    fn derivatives(self, y: T) -> (T, T) {
        let second = self.c * (y * y) * -12.0;
        (second * y * (1.0 / 3.0) - self.b, second)
    }
    #[inline(always)]
    fn duration(self, h: T, mean: T) -> T {
        let zero = h.all(0.0);
        zero.if_less(self.is_straight, h, mean * 2.0 * h)
    }
}

/// With drag.
#[derive(Debug, Clone, Copy)]
pub struct DraggedMixed<const M: u8, T> {
    pub straight: DraggedStraight<T>,
    pub hertz: DraggedHertz<M, T>,
    /// 1 on a straight piece, 0 on a Hertz piece.
    pub is_straight: T,
}

impl<const M: u8, T: Lane> DraggedMixed<M, T> {
    /// As [`super::Dragged::contact`], of whichever piece a lane is on.
    #[inline(always)]
    pub fn contact(&self, node: &Quad<T>, rates: &Quad<T>) -> (T, T) {
        let (straight, hertz) = (self.straight.contact_force(node, rates), self.hertz.contact_force(node, rates));
        let zero = node[0].all(0.0);
        (zero.if_less(self.is_straight, straight.0, hertz.0), zero.if_less(self.is_straight, straight.1, hertz.1))
    }
}

impl<const M: u8, T: Lane> Motion<T> for DraggedMixed<M, T> {
    #[inline(always)]
    fn rates(&self, y: T, u: T) -> Quad<T> {
        let (straight, mut rates) = (self.straight.rates(y, u), self.hertz.rates(y, u));
        let zero = y.all(0.0);
        for part in 1..4 {
            rates[part] = zero.if_less(self.is_straight, straight[part], rates[part]);
        }
        rates
    }
}
