// Tabs, of which the arrow keys choose one.

export class Tabs {
  constructor(list, changed) {
    this.tabs = [...list.querySelectorAll("[role=tab]")];
    this.changed = changed;
    for (const tab of this.tabs) tab.addEventListener("click", () => this.select(tab.getAttribute("aria-controls")));
    list.addEventListener("keydown", (event) => {
      const way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!way) return;
      const place = this.tabs.indexOf(document.activeElement);
      const next = this.tabs.at((place + way) % this.tabs.length);
      next.focus();
      next.click();
    });
  }

  select(id) {
    this.current = id;
    for (const tab of this.tabs) {
      const own = tab.getAttribute("aria-controls");
      tab.setAttribute("aria-selected", own === id);
      tab.tabIndex = own === id ? 0 : -1;
      document.getElementById(own).hidden = own !== id;
    }
    this.changed();
  }
}
