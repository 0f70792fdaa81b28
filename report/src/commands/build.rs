//! `lemnis build`: both FMUs, with the book inside, and the book.

use clap::Args;
use lemnis::results::Results;

use crate::commands::book::Making;
use crate::commands::fmu::{Pack, documentation, fmus};
use crate::decision::to_build;
use crate::failure::Failure;
use crate::output::{say, write};

#[derive(Args)]
pub struct Build {
    #[command(flatten)]
    pack: Pack,
    #[command(flatten)]
    making: Making,
}

impl Build {
    pub fn run(&self) -> Result<(), Failure> {
        self.making.prepare();
        let Pack { make, platforms } = &self.pack;
        let scene = to_build(make.scene.as_deref())?.announced()?;
        let results = Results::new(&scene).map_err(Failure::of_scene)?;
        let pdf = self.making.pdf(&scene, &results.sheet)?;
        let documentation = documentation(&scene, Some(&pdf))?;
        let mut outputs = fmus(&scene, platforms.as_deref(), &documentation)?;
        outputs.push(pdf);
        say(format_args!("{}\n{}", scene.title(), results.summary()))?;
        write(&make.output, &outputs)
    }
}
