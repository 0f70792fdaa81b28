//! Greatest values over the working range, each with its exact derivatives: what the end of a search needs to know of
//! anything that it searches.

/// Halvings that bring a peak from a part of the grid to its last bit.
const HALVINGS: usize = 64;

/// How a result of the range is made of the greatest values of others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// The one.
    Greatest,
    /// The negative of the one.
    Least,
    /// The sum of two.
    Swing,
    /// The sum of two over the sum of two.
    Ratio,
    /// The one, of which there are no peaks.
    Direct,
}

impl Shape {
    /// Value and derivatives by the parts.
    #[must_use]
    pub fn of(self, parts: &[f64]) -> (f64, Vec<f64>) {
        match (self, parts) {
            (Shape::Least, [a]) => (-a, vec![-1.0]),
            (Shape::Swing, [a, b]) => (a + b, vec![1.0; 2]),
            (Shape::Ratio, [a, b, c, d]) => {
                let (value, over) = ((a + b) / (c + d), 1.0 / (c + d));
                (value, vec![over, over, -value * over, -value * over])
            }
            (_, parts) => (parts[0], vec![1.0]),
        }
    }

    /// Whether the value grows with a part, falls, or follows it without peaks.
    #[must_use]
    pub fn grows(self, part: usize) -> Option<bool> {
        match self {
            Shape::Greatest | Shape::Swing => Some(true),
            Shape::Least => Some(false),
            Shape::Ratio => Some(part < 2),
            Shape::Direct => None,
        }
    }
}

/// A peak over the working range at some values.
#[derive(Clone, Debug)]
pub struct Peak {
    /// Of which of those that the greatest is sought among.
    pub of: usize,
    /// Places between which it lies.
    pub between: [f64; 2],
    pub value: f64,
    /// By each quantity that varies.
    pub slope: Vec<f64>,
}

/// Of each result, of each of its parts the peaks.
pub type Peaks = Vec<Vec<Vec<Peak>>>;

/// Results of the working range at values of what varies.
pub trait Peaked {
    /// How a result is made of its peaks.
    fn shape(&self, of: usize) -> Shape;

    /// All peaks at some values, with their derivatives; `None` where something does not exist.
    fn peaks(&mut self, values: &[f64]) -> Option<Peaks>;

    /// The same peaks at values nearby.
    fn moved(&mut self, values: &[f64], before: &Peaks) -> Option<Peaks>;
}

/// Neighbours of each place of a grid where no neighbour is greater.
pub fn tops(grid: &[f64]) -> impl Iterator<Item = [usize; 2]> {
    let last = grid.len() - 1;
    (0..=last).filter_map(move |i| {
        let ends = [i.saturating_sub(1), (i + 1).min(last)];
        ((i == 0 || grid[i] > grid[ends[0]]) && grid[i] >= grid[ends[1]]).then_some(ends)
    })
}

/// The place of a peak between two others: where the derivative changes its sign, or one of them.
pub fn place(between: [f64; 2], slope: &mut dyn FnMut(f64) -> Option<f64>) -> Option<f64> {
    let [mut low, mut high] = between;
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        let rises = slope(middle)? > 0.0;
        if rises { low = middle } else { high = middle }
    }
    // Without a change of sign the end itself is greatest.
    Some(if low == between[0] { low } else { high })
}
