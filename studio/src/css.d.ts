declare module '*.css';
declare module '*.ron' {
  const text: string;
  export default text;
}
