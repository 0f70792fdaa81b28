// Questions to the program.

const token = new URLSearchParams(location.search).get("token") ?? "";

export class Refused extends Error {
  constructor(status, words) {
    super(words);
    this.status = status;
  }
}

export async function ask(what, body = {}, signal = undefined) {
  const headers = { "content-type": "application/json", "x-token": token };
  const reply = await fetch(`/api/${what}`, { method: "POST", headers, body: JSON.stringify(body), signal });
  if (!reply.ok) throw new Refused(reply.status, await reply.text());
  return reply;
}

export const told = async (...asked) => (await ask(...asked)).json();

export const pageOfBook = (hash) => `/book/${hash}.svg?token=${token}`;

// Of many wishes one is carried out at a time; of those that wait, the newest.
export function newest(carryOut) {
  let waiting;
  let busy = false;
  return async (wish) => {
    waiting = [wish];
    if (busy) return;
    busy = true;
    while (waiting) {
      const [next] = waiting;
      waiting = undefined;
      await carryOut(next);
    }
    busy = false;
  };
}
