//! Places in a text: scenes count bytes, browsers and language servers code units of UTF-16, people lines and characters.

use std::ops::Range;

use serde::Serialize;

/// A part of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Place {
    /// Its first byte, and the first beyond it.
    pub bytes: [usize; 2],
    /// The same in code units of UTF-16.
    pub utf16: [usize; 2],
    /// Line and character of its beginning, both counted from 1.
    pub line: usize,
    pub column: usize,
}

/// The places of a text.
pub struct Places<'a>(&'a str);

impl<'a> Places<'a> {
    #[must_use]
    pub fn new(text: &'a str) -> Places<'a> {
        Places(text)
    }

    /// Of bytes of the text; what is no place of it is that before.
    #[must_use]
    pub fn of(&self, bytes: &Range<usize>) -> Place {
        let [from, to] = [bytes.start, bytes.end].map(|byte| self.0.floor_char_boundary(byte));
        let before = &self.0[..from];
        let line = before.rsplit('\n').next().unwrap_or_default();
        let start = before.encode_utf16().count();
        Place {
            bytes: [from, to.max(from)],
            utf16: [start, start + self.0[from..to.max(from)].encode_utf16().count()],
            line: 1 + before.matches('\n').count(),
            column: 1 + line.chars().count(),
        }
    }

    /// The byte at a code unit of UTF-16; within a character that character's, beyond the text its end.
    #[must_use]
    pub fn byte(&self, utf16: usize) -> usize {
        let mut units = 0;
        for (byte, c) in self.0.char_indices() {
            units += c.len_utf16();
            if units > utf16 {
                return byte;
            }
        }
        self.0.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_counted_in_bytes_in_units_and_in_characters() {
        // Three, two and four bytes; one, one and two units.
        let text = "# 起重机 °\n𝛼 = 1";
        let places = Places::new(text);
        let place = |what: &str| {
            let at = text.find(what).expect("there");
            places.of(&(at..at + what.len()))
        };
        let [crane, degree, one] = [place("重机"), place("°"), place("1")];
        assert_eq!(
            (crane.bytes, crane.utf16, crane.line, crane.column),
            ([5, 11], [3, 5], 1, 4)
        );
        assert_eq!((degree.bytes, degree.utf16, degree.column), ([12, 14], [6, 7], 7));
        assert_eq!((one.utf16, one.line, one.column), ([13, 14], 2, 5));
        for (byte, _) in text.char_indices() {
            assert_eq!(places.byte(places.of(&(byte..byte)).utf16[0]), byte);
        }
        assert_eq!(
            (places.byte(9), places.byte(100)),
            (text.find('𝛼').expect("there"), text.len())
        );
        assert_eq!(places.of(&(4..7)).bytes, [2, 5], "no place within a character");
    }
}
