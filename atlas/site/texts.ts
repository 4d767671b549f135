// Files of the atlas that pages read as text. Each is loaded once, when it is wanted.

const texts = new Map<string, Promise<string>>();

async function load(address: string): Promise<string> {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${address} cannot be loaded (${response.status})`);
    return response.text();
}

export function textAt(address: string): Promise<string> {
    const text = texts.get(address) ?? load(address);
    texts.set(address, text);
    text.catch(() => texts.delete(address)); // so that the next call tries again
    return text;
}
