//! Files attached to a PDF.

use hayro_syntax::Pdf;
use hayro_syntax::object::{Array, Dict, Stream, String};

/// The first file attached to a PDF whose name ends with `suffix`; `None` where
/// there is none, or where this is no PDF.
#[must_use]
pub fn attached(pdf: Vec<u8>, suffix: &str) -> Option<Vec<u8>> {
    let pdf = Pdf::new(pdf).ok()?;
    let catalog: Dict<'_> = pdf.xref().get(pdf.xref().root_id())?;
    let names: Dict<'_> = catalog.get("Names")?;
    let files: Dict<'_> = names.get("EmbeddedFiles")?;
    let files: Array<'_> = files.get("Names")?;
    // Names and files by turns.
    let mut files = files.flex_iter();
    while let Some(known) = files.next::<String<'_>>() {
        let file: Dict<'_> = files.next()?;
        if known.as_bytes().ends_with(suffix.as_bytes()) {
            let versions: Dict<'_> = file.get("EF")?;
            let stream: Stream<'_> = versions.get("F")?;
            return Some(stream.decoded().ok()?.to_vec());
        }
    }
    None
}
