"""Makes the fonts of this folder from Noto Sans CJK (Debian's fonts-noto-cjk, SIL Open Font License).

    pip install fonttools
    python subset.py /usr/share/fonts/opentype/noto

Kept are the 3,755 characters of GB 2312's first level, its punctuation and its
full-width forms: what Chinese books of engineering are written in; and the
characters of cited authors' names. A font of a single character outside of
them is for the tests.
"""

import sys
from pathlib import Path

from fontTools import subset

SIMPLIFIED_CHINESE = 2  # place in the collection
ROWS = [0xA1, 0xA3, *range(0xB0, 0xD8)]
NAMES = "鑫"


def characters():
    for row in ROWS:
        for cell in range(0xA1, 0xFF):
            try:
                yield bytes([row, cell]).decode("gb2312")
            except UnicodeDecodeError:
                pass  # not assigned


def make(collection, text, name):
    options = subset.Options(font_number=SIMPLIFIED_CHINESE, layout_features=["kern"], hinting=False, notdef_outline=True)
    font = subset.load_font(str(collection), options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=text)
    subsetter.subset(font)
    subset.save_font(font, str(Path(__file__).with_name(name)), options)


def main(folder):
    text = "".join(characters()) + NAMES
    for weight in ["Regular", "Bold"]:
        make(folder / f"NotoSansCJK-{weight}.ttc", text, f"NotoSansCJKsc-{weight}.otf")
    make(folder / "NotoSansCJK-Regular.ttc", "龘", "one_character.otf")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
