"""Makes the fonts of this folder from Noto Serif SC (SIL Open Font License), as the npm package
@expo-google-fonts/noto-serif-sc 0.4.3 has it, with fontTools 4.

    npm pack @expo-google-fonts/noto-serif-sc@0.4.3
    tar -xzf expo-google-fonts-noto-serif-sc-0.4.3.tgz
    pip install fonttools
    python subset.py package

Kept are the 3,755 characters of GB 2312's first level, its punctuation and its
full-width forms: what Chinese books of engineering are written in; and the
characters of cited authors' names. A font of a single character outside of
them is for the tests.
"""

import sys
from pathlib import Path

from fontTools import subset

ROWS = [0xA1, 0xA3, *range(0xB0, 0xD8)]
NAMES = "鑫"


def characters():
    for row in ROWS:
        for cell in range(0xA1, 0xFF):
            try:
                yield bytes([row, cell]).decode("gb2312")
            except UnicodeDecodeError:
                pass  # not assigned


def make(source, text, name):
    options = subset.Options(layout_features=["kern"], hinting=False, notdef_outline=True)
    font = subset.load_font(str(source), options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=text)
    subsetter.subset(font)
    subset.save_font(font, str(Path(__file__).with_name(name)), options)


def main(package):
    text = "".join(characters()) + NAMES
    for weight, name in [("400Regular", "Regular"), ("700Bold", "Bold")]:
        make(package / weight / f"NotoSerifSC_{weight}.ttf", text, f"NotoSerifSC-{name}.ttf")
    make(package / "400Regular/NotoSerifSC_400Regular.ttf", "龘", "one_character.ttf")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
