// Which designs the reader has chosen, by a name or by ranges of numbers: one choice for the table and all charts.
const listeners = [];
const state = { name: "", ranges: new Map() }; // of a range: key -> { of, from, to, words }

export const isChosen = (design) =>
  design.name.toLowerCase().includes(state.name)
  && [...state.ranges.values()].every(({ of, from, to }) => {
    const value = of(design);
    return typeof value === "number" && value >= from && value <= to;
  });

export const isChoosing = () => state.name !== "" || state.ranges.size > 0;
export const rangesInWords = () => [...state.ranges.values()].map((range) => range.words);
export const onChoice = (listener) => { listeners.push(listener); };

function tell() { listeners.forEach((listener) => listener()); }

export function chooseName(text) { state.name = text.trim().toLowerCase(); tell(); }

export function chooseRange(key, range) {
  if (range) state.ranges.set(key, range); else state.ranges.delete(key);
  tell();
}

export function chooseAll() { state.name = ""; state.ranges.clear(); tell(); }
