// Cards open when a link leads to them; those of the later ranks are filled when they open. Pictures enlarge.
let bodies = {};

// The inside of a design's card, whether it stands in the page yet or not.
export function bodyOf(id) {
  return bodies[id] ?? document.getElementById(id)?.querySelector(".card-body")?.innerHTML ?? "";
}

function fill(card) {
  const body = card.querySelector(".card-body");
  if (!bodies[card.id] || body.childElementCount > 0) return;
  body.innerHTML = bodies[card.id];
}

function openTarget() {
  const target = location.hash.startsWith("#design-") && document.querySelector(location.hash);
  if (target && "open" in target) { fill(target); target.open = true; target.scrollIntoView(); }
}

// One listener for all pictures, those that come into the page later too.
function setUpLightbox() {
  const box = document.getElementById("lightbox");
  const [image, text] = [box.querySelector("img"), box.querySelector("p")];
  document.addEventListener("click", (event) => {
    const button = event.target.closest("button.zoom");
    if (!button) return;
    const small = button.querySelector("img");
    image.src = small.src;
    image.alt = small.alt;
    text.textContent = `${small.alt}, ${button.parentElement.querySelector("figcaption").textContent}`;
    box.showModal();
  });
  box.addEventListener("click", (event) => { if (event.target !== image) box.close(); });
}

// The cards of the later ranks are deflated in the page.
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"))).json();
}

export async function setUpCards(resize) {
  bodies = await unpacked(document.getElementById("icebow-cards").textContent);
  openTarget();
  addEventListener("hashchange", openTarget);
  addEventListener("resize", resize);
  const cards = [...document.querySelectorAll("details.card")];
  for (const card of cards) card.addEventListener("toggle", () => { if (card.open) fill(card); });
  const button = document.getElementById("open-all");
  button?.addEventListener("click", () => {
    const open = cards.some((card) => !card.open);
    cards.forEach((card) => { if (open) fill(card); card.open = open; });
    button.textContent = open ? "Close all" : "Open all";
  });
  setUpLightbox();
}
