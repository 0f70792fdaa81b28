//! Volume, area and their moments below a plane, summed over triangles and sides.

use crate::kernel::calc::Calc;

/// What lies below the plane: volume (m³) with its first moments, and the part of the plane inside, as seen from above, with
/// its first and second moments (xx, xy, yy).
#[derive(Clone, Copy, Debug)]
pub struct Cut<C> {
    pub volume: C,
    pub moment: [C; 3],
    pub area: C,
    pub first: [C; 2],
    pub second: [C; 3],
}

impl<C: Calc> Cut<C> {
    /// Nothing yet.
    #[must_use]
    pub fn nothing() -> Cut<C> {
        let none = C::constant(0.0);
        Cut {
            volume: none,
            moment: [none; 3],
            area: none,
            first: [none; 2],
            second: [none; 3],
        }
    }

    /// Six times the tetrahedron of a triangle and a point of the plane, from which z counts.
    #[inline]
    pub fn piece(&mut self, [p, q, r]: [[C; 3]; 3]) {
        let six = p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        self.volume += six;
        for (i, sum) in self.moment.iter_mut().enumerate() {
            *sum += six * (p[i] + q[i] + r[i]);
        }
    }

    /// A side of the area in the plane, counter-clockwise, seen from above.
    #[inline]
    pub fn side(&mut self, [x, y, _]: [C; 3], [u, v, _]: [C; 3]) {
        let twice = x * v - u * y;
        self.area += twice;
        self.first[0] += twice * (x + u);
        self.first[1] += twice * (y + v);
        self.second[0] += twice * (x * x + x * u + u * u);
        self.second[1] += twice * (x * v + (x * y + u * v).scaled(2.0) + u * y);
        self.second[2] += twice * (y * y + y * v + v * v);
    }

    /// The sums with their factors; z counts from below.
    #[must_use]
    pub fn done(mut self, [t, a, b]: [C; 3]) -> Cut<C> {
        self.volume = self.volume.scaled(1.0 / 6.0);
        self.moment = self.moment.map(|sum| sum.scaled(1.0 / 24.0));
        self.moment[2] += t * self.volume + a * self.moment[0] + b * self.moment[1];
        self.area = self.area.scaled(0.5);
        self.first = self.first.map(|sum| sum.scaled(1.0 / 6.0));
        let [xx, xy, yy] = self.second;
        self.second = [xx.scaled(1.0 / 12.0), xy.scaled(1.0 / 24.0), yy.scaled(1.0 / 12.0)];
        self
    }

    /// Without a share of another body below the same plane, which lies within it.
    pub fn less(&mut self, other: &Cut<C>, share: C) {
        self.volume -= share * other.volume;
        self.area -= share * other.area;
        let own = self.moment.iter_mut().chain(&mut self.first).chain(&mut self.second);
        let taken = other.moment.iter().chain(&other.first).chain(&other.second);
        own.zip(taken).for_each(|(own, taken)| *own -= share * *taken);
    }

    /// Second moments of the area about its own centre.
    pub fn central(&self) -> [C; 3] {
        let ([x, y], [xx, xy, yy]) = (self.first, self.second);
        [xx - x * x / self.area, xy - x * y / self.area, yy - y * y / self.area]
    }
}
