// Chooses among the entries of a list by the form above it, without a server.
// An entry's data-* attributes are its facets; several values are divided by "|".
document.querySelectorAll("form[data-filter]").forEach((form) => {
  const list = document.querySelector(form.dataset.filter);
  const entries = [...list.children];
  const words = (entry) => `${entry.textContent} ${Object.values(entry.dataset).join(" ")}`.toLowerCase();
  const texts = new Map(entries.map((entry) => [entry, words(entry)]));
  const show = () => {
    const { words: typed = "", order = "", ...facets } = Object.fromEntries(new FormData(form));
    const asked = typed.toLowerCase().split(/\s+/).filter(Boolean);
    let count = 0;
    for (const entry of entries) {
      const fits = asked.every((word) => texts.get(entry).includes(word)) && Object.entries(facets).every(
        ([name, value]) => value === "" || (entry.dataset[name] ?? "").split("|").includes(value));
      entry.hidden = !fits;
      count += fits ? 1 : 0;
    }
    const key = (entry) => entry.dataset[order] ?? "";
    const sorted = order === "" ? entries : [...entries].sort((a, b) => key(a).localeCompare(key(b)));
    list.append(...sorted);
    form.querySelector("output").textContent = `${count} of ${entries.length}`;
    const chosen = new URLSearchParams([...new FormData(form)].filter(([, value]) => value !== ""));
    try { history.replaceState(null, "", `${location.pathname}${chosen.size ? `?${chosen}` : ""}${location.hash}`); } catch { /* a page from a file */ }
  };
  for (const [name, value] of new URLSearchParams(location.search)) {
    if (form.elements[name] !== undefined) form.elements[name].value = value;
  }
  form.addEventListener("input", show);
  form.addEventListener("submit", (event) => event.preventDefault());
  show();
});
