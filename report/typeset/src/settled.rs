//! A document laid out until page numbers and links agree with it. Typst begins with a document of which nothing is
//! known and needs three passes; this begins with what is known of an earlier document, and where pages and links are
//! the same one pass is enough.

use std::cell::RefCell;
use std::sync::Arc;

use typst::World;
use typst::comemo::{self, Constraint, Track};
use typst::diag::{SourceResult, Warned, bail};
use typst::engine::{Engine, Route, Sink};
use typst::foundations::{Content, Output, StyleChain, Target};
use typst::introspection::{EmptyIntrospector, Introspector, MAX_ITERS};
use typst::syntax::Span;
use typst::utils::Protected;
use typst_layout::{PagedDocument, PagedIntrospector};

/// Where the elements of a document stand.
pub type Places = Arc<PagedIntrospector>;

thread_local! {
    /// From [`typeset`] to the layout within.
    static EARLIER: RefCell<Option<Places>> = const { RefCell::new(None) };
}

/// Typesets a document, beginning with the places of an earlier one.
pub fn typeset(world: &dyn World, earlier: Option<Places>) -> Warned<SourceResult<PagedDocument>> {
    EARLIER.set(earlier);
    let Warned { output, warnings } = typst::compile::<Settled>(world);
    let output = output.map(|Settled(document)| document);
    Warned { output, warnings }
}

/// What is asked for, on this thread, and on one of its own what nobody waits for.
pub fn beside<T>(other: impl FnOnce() + Send, asked: impl FnOnce() -> T) -> T {
    std::thread::scope(|scope| {
        scope.spawn(other);
        asked()
    })
}

/// A document that no further pass would change.
struct Settled(PagedDocument);

impl Settled {
    /// One pass, with what is known; the document, whether it bears that out, and what was found.
    fn pass(
        engine: &Engine<'_>,
        content: &Content,
        styles: StyleChain<'_>,
        known: &dyn Introspector,
    ) -> SourceResult<(PagedDocument, bool, Sink)> {
        let (constraint, mut sink) = (Constraint::new(), Sink::new());
        let mut pass = Engine {
            library: engine.library,
            world: engine.world,
            introspector: Protected::new(known.track_with(&constraint)),
            traced: engine.traced,
            sink: sink.track_mut(),
            route: Route::default(),
        };
        let document = PagedDocument::create(&mut pass, content, styles)?;
        let settled = constraint.validate(Output::introspector(&document));
        Ok((document, settled, sink))
    }
}

impl Output for Settled {
    fn target() -> Target {
        PagedDocument::target()
    }

    fn create(engine: &mut Engine<'_>, content: &Content, styles: StyleChain<'_>) -> SourceResult<Settled> {
        let earlier = EARLIER.take();
        // What an earlier document knew may be wrong here: then Typst's own beginning.
        let first = earlier.and_then(|known| Settled::pass(engine, content, styles, &*known).ok());
        let mut made = match first {
            Some(made) => made,
            None => Settled::pass(engine, content, styles, &EmptyIntrospector)?,
        };
        for _ in 0..MAX_ITERS {
            let (document, settled, mut found) = made;
            if settled {
                engine.sink.delayed_errors(found.delayed());
                for warning in found.warnings() {
                    engine.sink.warn(warning);
                }
                return Ok(Settled(document));
            }
            // A first document takes several passes; what none but the last but one needed would be its greatest memory.
            let known = document.introspector().clone();
            drop(document);
            made = beside(|| comemo::evict(1), || Settled::pass(engine, content, styles, &*known))?;
        }
        bail!(
            Span::detached(),
            "the pages do not come to rest: their numbers depend on themselves"
        );
    }

    fn introspector(&self) -> &dyn Introspector {
        Output::introspector(&self.0)
    }
}
