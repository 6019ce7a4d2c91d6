"use strict";var ChaplyginLab=(()=>{var dd=Object.defineProperty;var Cv=Object.getOwnPropertyDescriptor;var Rv=Object.getOwnPropertyNames;var Pv=Object.prototype.hasOwnProperty;var Iv=(n,e)=>{for(var t in e)dd(n,t,{get:e[t],enumerable:!0})},Lv=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of Rv(e))!Pv.call(n,r)&&r!==t&&dd(n,r,{get:()=>e[r],enumerable:!(i=Cv(e,r))||i.enumerable});return n};var Fv=n=>Lv(dd({},"__esModule",{value:!0}),n);var RP={};Iv(RP,{mount:()=>mv});function rc(n,e){let t=n.length-1;if(t<=0||!(e>(n[0]??0)))return{index:0,share:0};if(e>=(n[t]??0))return{index:t,share:0};let i=0,r=t;for(;r-i>1;){let o=i+r>>1;(n[o]??0)<=e?i=o:r=o}let s=n[i]??0;return{index:i,share:(e-s)/((n[r]??0)-s)}}function mi(n,e,t,i){let r=n.columns[e];if(r===void 0)return null;let{index:s,share:o}=rc(n.times,i),a=(l,c)=>r[l*t+c]??NaN;return Array.from({length:t},(l,c)=>o===0?a(s,c):(1-o)*a(s,c)+o*a(s+1,c))}function Nv(n,e,t){let i=n[0]*e[0]+n[1]*e[1]+n[2]*e[2]+n[3]*e[3],r=i<0?-1:1;i=Math.min(1,Math.abs(i));let s=Math.acos(i),o=Math.sin(s),a=o>1e-9?Math.sin((1-t)*s)/o:1-t,l=(o>1e-9?Math.sin(t*s)/o:t)*r;return Bv([a*n[0]+l*e[0],a*n[1]+l*e[1],a*n[2]+l*e[2],a*n[3]+l*e[3]])}function Bv(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function yo(n,e){let[t,i,r,s]=n,o=2*(r*e[2]-s*e[1]),a=2*(s*e[0]-i*e[2]),l=2*(i*e[1]-r*e[0]);return[e[0]+t*o+r*l-s*a,e[1]+t*a+s*o-i*l,e[2]+t*l+i*a-r*o]}function Nm(n,e){return yo([n[0],-n[1],-n[2],-n[3]],e)}function _o(n,e){let t=n.columns.attitude,{index:i,share:r}=rc(n.times,e),s=c=>[0,1,2,3].map(u=>t?.[4*c+u]??(u===0?1:0)),o=r===0?s(i):Nv(s(i),s(i+1),r),a=c=>mi(n,c,3,e),l=a("centre")??[0,0,0];return{t:Dv(n,e),attitude:o,centre:l,contact:a("contact")??l}}function Dv(n,e){let{times:t}=n;return Math.min(Math.max(e,t[0]??0),t[t.length-1]??0)}function os(n,e,t){let i=n.columns[e];if(i===void 0)return 0;for(let r=0;r<n.times.length;r++)for(let s=0;s<t;s++)if(!Number.isFinite(i[r*t+s]))return r;return n.times.length}function Da(n){let{start:e}=n.wanted.value;if("inputs"in e)return{...e.inputs};let{motion:t}=n.shown.value,i={};for(let{name:r}of n.model.start_inputs){let s=n.model.state.findIndex(a=>a.name===r),o=s>=0?e.state[s]:kv(n,r,t.times[0]??0);o!==void 0&&Number.isFinite(o)&&(i[r]=o)}return i}function kv(n,e,t){let i=e.lastIndexOf("_"),r=n.model.columns.find(o=>o.name===e||o.name===e.slice(0,i));if(r===void 0)return;let s=r.name===e?0:Number(e.slice(i+1))-1;return mi(n.shown.value.motion,r.name,r.width,t)?.[s]}function sc(n){let e=n.start_inputs.filter(({name:t})=>t.startsWith("attitude_"));return e.length<=4?n.start_inputs:n.start_inputs.filter(t=>!e.includes(t))}function X(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s===null||s===!1||i.setAttribute(r,s===!0?"":String(s));return i.append(...t.filter(r=>r!==null)),i}function Is(n,e,t,i){let r=X("button",{type:"button","aria-label":e,title:e,"aria-pressed":String(t)},n);return r.addEventListener("click",()=>{let s=r.getAttribute("aria-pressed")!=="true";r.setAttribute("aria-pressed",String(s)),i(s)}),r}function Ei(n,e,t,i){let r=X("select",{"aria-label":n});for(let{value:s,text:o}of e){let a=X("option",{value:s},o);a.selected=s===t,r.append(a)}return r.addEventListener("change",()=>i(r.value)),X("label",{class:"lab-choice"},X("span",{},n),r)}function Ls(n,e){let t=URL.createObjectURL(e),i=X("a",{href:t,download:n});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function fd(n){let e=Math.min(window.devicePixelRatio||1,2),t=Math.max(1,Math.round(n.clientWidth*e)),i=Math.max(1,Math.round(n.clientHeight*e));return(n.width!==t||n.height!==i)&&(n.width=t,n.height=i),{width:t,height:i,ratio:e}}var Ov="http://www.w3.org/1998/Math/MathML";function zi(n){let t=new DOMParser().parseFromString(n,"text/html").querySelector("math");return t===null?document.createTextNode(n):(Om(t),document.importNode(t,!0))}function si(n){let e=new DOMParser().parseFromString(n,"text/html");return km(e.querySelector("math")??e.body).trim()||n}function km(n){let e=[...n.children].map(km),[t="",i="",r=""]=e;switch(n.localName){case"msub":return t+oc(i,Bm);case"msup":return t+oc(i,Dm);case"msubsup":return t+oc(i,Bm)+oc(r,Dm);case"mfrac":return`${t}/${i}`;case"mover":return t+(i==="˙"?"̇":i==="¨"?"̈":i);default:return e.length>0?e.join(""):n.textContent??""}}var Uv="0123456789",Bm="₀₁₂₃₄₅₆₇₈₉",Dm="⁰¹²³⁴⁵⁶⁷⁸⁹";function oc(n,e){return[...n].map(t=>e[Uv.indexOf(t)]??t).join("")}function Om(n){for(let{name:e}of[...n.attributes])(e.startsWith("on")||e==="href")&&n.removeAttribute(e);for(let e of[...n.children])e.namespaceURI===Ov?Om(e):e.remove()}var Um={dark:!1,ink:"#1f2730",quiet:"#66727d",line:"#d9dfe4",paper:"#ffffff",alarm:"#bb5566",time:["#f6c667","#ec8f4d","#cf4f5b","#8a2a75","#3b1a68"],body:["#f4f1ea","#5b86ad"],shell:["#f0ece2","#a9bfd3"],seam:"#3d5a76",ground:["#f4f7fa","#b3bfcb"],grid:"#aab6c2",lines:"#aab6c2",shadow:.34,components:["#004488","#bb5566","#d9a521"],series:["#332288","#cc6677","#117733","#ddaa33","#88ccee","#aa4499","#999933","#44aa99"]},zv={dark:!0,ink:"#dde3e8",quiet:"#97a4af",line:"#36414b",paper:"#151a1f",alarm:"#e58a99",time:["#f8d98c","#f2a65a","#e66f79","#b873d6","#8fa8ff"],body:["#f4f1ea","#5b86ad"],shell:["#dcd9d0","#8fa9c2"],seam:"#25394d",ground:["#5b6773","#2c353e"],grid:"#56636f",lines:"#94a3b1",shadow:.6,components:["#6ea8e6","#e58a99","#e6bd52"],series:["#a497f3","#e58a99","#58b97b","#e6bd52","#88ccee","#d582c8","#c3c35c","#5cc4b2"]},zm=()=>typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function nn(){return zm()?.matches?zv:Um}var bn=Um;function bo(n){zm()?.addEventListener("change",n)}function ac(n){let e=Number.parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function lc(n,e){let t=n.length-1,i=Math.min(Math.max(e,0),1)*t,r=Math.min(Math.floor(i),t-1),[s,o]=[ac(n[r]??"#000000"),ac(n[r+1]??"#000000")],a=i-r;return[0,1,2].map(l=>Math.round((s[l]??0)+a*((o[l]??0)-(s[l]??0))))}function Fs(){return nn().dark?Vv:Hv}var Vv=["#4f7cc4","#6a7fae","#7f8592","#93907f","#a99d74","#c3b369","#e1cc55","#fee838"],Hv=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"];function Vm(n,e,t,i){let r=n,s=[],o=(a,l,c)=>{for(let u of a){let h=qv(r,u,c);if(h!==null){r=h;return}}s.push(`# ${l} = ${c} was set in the page; this file has no such entry`)};for(let{name:a,value:l}of e)o(Gv(a),a,l);for(let{name:a,value:l}of t)o(Wv(a),a,l);return i!==null&&o([{table:"run",key:"until",indices:[[]]}],"until",i),s.length>0?`${s.join(`
`)}

${r}`:r}function Gv(n){let e=[{table:"system.parameters",key:n,indices:[[]]},{table:"parameters",key:n,indices:[[]]}],t=(s,o,...a)=>[...e,{table:s,key:o,indices:a}],i=/^I_(\d)(\d)$/.exec(n);if(i){let[s,o]=[Number(i[1])-1,Number(i[2])-1];return t("body","inertia",[s,o],...s===o?[]:[[o,s]])}let r=/^I_(\d)$/.exec(n);return r?t("body","inertia",[Number(r[1])-1]):n==="m"?t("body","mass",[]):n==="g"?t("field","gravity",[]):n==="R"?t("body.shape","radius",[]):e}function Wv(n){let e=/^(.+)_(\d)$/.exec(n),t={table:"start",key:n,indices:[[]]};return e?[{table:"start",key:e[1]??n,indices:[[Number(e[2])-1]]},t]:[t]}function qv(n,{table:e,key:t,indices:i},r){let s=n.split(`
`),o=s.findIndex(a=>a.trim()===`[${e}]`);if(o<0)return null;for(let a=o+1;a<s.length&&!(s[a]??"").trim().startsWith("[");a++){let l=/^(\s*(?:"[^"]*"|[\w.]+)\s*=\s*)(.*)$/.exec(s[a]??"");if(l===null||(l[1]??"").replace(/[\s="]/g,"")!==t)continue;let c=l[2]??"";for(let u of i)c=c===null?null:Xv(c,u,r);return c===null?null:(s[a]=(l[1]??"")+c,s.join(`
`))}return null}var pd=/[-+]?(?:\d[\d_]*\.?\d*(?:[eE][-+]?\d+)?|inf|nan)/;function Xv(n,e,t){if(e.length===0){let o=/^(\{.*?\bvalue\s*=\s*)([-+\d.eE_]+)(.*)$/.exec(n);return o?(o[1]??"")+String(t)+(o[3]??""):new RegExp(`^${pd.source}`).test(n)?n.replace(pd,String(t)):null}let i=e.length,r=new Array(i+1).fill(0),s=0;for(let o=0;o<n.length;o++){let a=n[o];if(a==="[")r[++s]=0;else if(a==="]")s-=1;else if(a===",")r[s]=(r[s]??0)+1;else if(s===i&&e.every((l,c)=>r[c+1]===l)){let l=pd.exec(n.slice(o));if(l===null||l.index!==0)continue;return n.slice(0,o)+String(t)+n.slice(o+l[0].length)}}return null}function _e(n){if(!n)throw new Error("Assertion failed.")}var $v=Math.PI/180,OP=180/Math.PI;var md=[1,0,0,0,1,0,0,0,1],Gm=(n,e,t)=>{let[i,r,,s,o]=n,a=Math.abs(i)*e+Math.abs(s)*t,l=Math.abs(r)*e+Math.abs(o)*t;return cc(cc(Hm(-e/2,-t/2),n),Hm(a/2,l/2))};var Wm=n=>{let e=n*$v,t=Math.round(Math.cos(e)),i=Math.round(Math.sin(e));return[t,i,0,-i,t,0,0,0,1]},Hm=(n,e)=>[1,0,0,0,1,0,n,e,1],qm=(n,e)=>[n,0,0,0,e,0,0,0,1],cc=(n,e)=>{let t=new Array(9);for(let i=0;i<3;i++)for(let r=0;r<3;r++)t[3*i+r]=n[3*i]*e[r]+n[3*i+1]*e[3+r]+n[3*i+2]*e[6+r];return t};var cr=n=>n&&n[n.length-1],ur=n=>n>=0&&n<2**32,Xm=n=>n>=-(2**31)&&n<2**31,Re=n=>{let e=0;for(;n.readBits(1)===0&&e<32;)e++;if(e>=32)throw new Error("Invalid exponential-Golomb code.");return(1<<e)-1+n.readBits(e)};var hr=n=>{let e=Re(n);return(e&1)===0?-(e>>1):e+1>>1};var ls=n=>n.constructor===Uint8Array?n:ArrayBuffer.isView(n)?new Uint8Array(n.buffer,n.byteOffset,n.byteLength):new Uint8Array(n),Ns=n=>n.constructor===DataView?n:ArrayBuffer.isView(n)?new DataView(n.buffer,n.byteOffset,n.byteLength):new DataView(n),Yv=typeof globalThis.TextEncoder<"u"?globalThis.TextEncoder:class{constructor(){this.encoding="utf-8"}encode(e=""){let t=new Uint8Array(3*e.length),i=0;for(let r=0;r<e.length;r++){let s=e.charCodeAt(r);if(s<128)t[i++]=s;else if(s<2048)t[i++]=192|s>>6,t[i++]=128|s&63;else if(s<55296||s>57343)t[i++]=224|s>>12,t[i++]=128|s>>6&63,t[i++]=128|s&63;else{let o=r+1<e.length?e.charCodeAt(r+1):0;s<56320&&o>=56320&&o<=57343?(s=65536+(s-55296<<10)+(o-56320),r++,t[i++]=240|s>>18,t[i++]=128|s>>12&63,t[i++]=128|s>>6&63,t[i++]=128|s&63):(t[i++]=239,t[i++]=191,t[i++]=189)}}return t.slice(0,i)}},zP=typeof globalThis.TextDecoder<"u"?globalThis.TextDecoder:class{constructor(e="utf-8"){let t=e.trim().toLowerCase();if(t==="utf-8"||t==="utf8"||t==="unicode-1-1-utf-8")this.encoding="utf-8";else if(t==="utf-16le"||t==="utf-16")this.encoding="utf-16le";else if(t==="utf-16be")this.encoding="utf-16be";else throw new RangeError(`The encoding label provided ('${e}') is invalid.`)}decode(e){let t=e?ls(e):new Uint8Array(0),i=[];if(this.encoding==="utf-8"){let s=t.length>=3&&t[0]===239&&t[1]===187&&t[2]===191?3:0;for(;s<t.length;){let o=t[s];if(o<128){i.push(o),s++;continue}let a,l;if(o>=194&&o<224)a=1,l=o&31;else if(o>=224&&o<240)a=2,l=o&15;else if(o>=240&&o<245)a=3,l=o&7;else{i.push(65533),s++;continue}let c=o===224?160:o===240?144:128,u=o===237?159:o===244?143:191,h=1;for(;h<=a;h++){let d=s+h<t.length?t[s+h]:0;if(d<c||d>u)break;l=l<<6|d&63,c=128,u=191}s+=h,h<=a?i.push(65533):l>=65536?(l-=65536,i.push(55296|l>>10,56320|l&1023)):i.push(l)}}else{let s=this.encoding==="utf-16le",o=s?255:254,a=s?254:255,l=t.length>=2&&t[0]===o&&t[1]===a?2:0;for(;l+1<t.length;){let c=s?t[l]|t[l+1]<<8:t[l]<<8|t[l+1];if(l+=2,c>=55296&&c<=56319){let u=l+1<t.length?s?t[l]|t[l+1]<<8:t[l]<<8|t[l+1]:-1;u>=56320&&u<=57343?(i.push(c,u),l+=2):i.push(65533)}else c>=56320&&c<=57343?i.push(65533):i.push(c)}l<t.length&&i.push(65533)}let r="";for(let s=0;s<i.length;s+=8192)r+=String.fromCharCode(...i.slice(s,s+8192));return r}};var Ci=new Yv;var ka={bt709:1,bt470bg:5,smpte170m:6,bt2020:9,smpte432:12};var Oa={bt709:1,smpte170m:6,linear:8,"iec61966-2-1":13,pq:16,hlg:18};var Ua={rgb:0,bt709:1,bt470bg:5,smpte170m:6,"bt2020-ncl":9};var $m=n=>!n||n.primaries==null&&n.transfer==null&&n.matrix==null&&n.fullRange==null;var gd=n=>n instanceof ArrayBuffer||typeof SharedArrayBuffer<"u"&&n instanceof SharedArrayBuffer||ArrayBuffer.isView(n),vo=class{constructor(){this.currentPromise=Promise.resolve(),this.pending=0}async acquire(){let e,t=new Promise(r=>{let s=!1;e=()=>{s||(r(),this.pending--,s=!0)}}),i=this.currentPromise;return this.currentPromise=t,this.pending++,await i,e}};var Ym=()=>{let n,e;return{promise:new Promise((i,r)=>{n=i,e=r}),resolve:n,reject:e}};var wo=n=>{throw new Error(`Unexpected value: ${n}`)};var Zm=(n,e,t,i)=>{t=t>>>0,t=t&16777215,i?(n.setUint8(e,t&255),n.setUint8(e+1,t>>>8&255),n.setUint8(e+2,t>>>16&255)):(n.setUint8(e,t>>>16&255),n.setUint8(e+1,t>>>8&255),n.setUint8(e+2,t&255))};var Km="und";var Jm=n=>{let e=0;for(;n!==0;)n&=n-1,e++;return e},Zv=/^[a-z]{3}$/,jm=n=>Zv.test(n),xd=1e6*(1+Number.EPSILON);var Qm=(n,e)=>{let t=n<0?-1:1;n=Math.abs(n);let i=0,r=1,s=1,o=0,a=n;for(;;){let l=Math.floor(a),c=l*s+i,u=l*o+r;if(u>e)return{num:t*s,den:o};if(i=s,r=o,s=c,o=u,a=1/(a-l),!isFinite(a))break}return{num:t*s,den:o}};var Kv=(async()=>{})().constructor,za=n=>n instanceof Kv||n instanceof Promise?!0:typeof n?.then=="function";var uc=function*(n){for(let e in n){let t=n[e];t!==void 0&&(yield{key:e,value:t})}};var eg=n=>typeof n=="number"&&!Number.isNaN(n);var tg=n=>{_e(Number.isInteger(n.num)),_e(Number.isInteger(n.den)),_e(n.den!==0);let e=Math.abs(n.num),t=Math.abs(n.den);for(;t!==0;){let r=e%t;e=t,t=r}let i=e||1;return{num:n.num/i,den:n.den/i}};var hc=n=>Array.isArray(n)?n:[n],as=class{constructor(){this._listeners=new Map}on(e,t,i){this._listeners.has(e)||this._listeners.set(e,new Set);let r={fn:t,once:i?.once??!1};return this._listeners.get(e).add(r),()=>{this._listeners.get(e)?.delete(r)}}_emit(...e){let[t,i]=e,r=this._listeners.get(t);if(r)for(let s of r){try{s.fn(i)}catch(o){console.error(o)}s.once&&r.delete(s)}}};var ng=n=>n!==null&&typeof n=="object"&&Object.getPrototypeOf(n)===Object.prototype&&Object.values(n).every(e=>typeof e=="string");var dr;(function(n){n[n.Silent=0]="Silent",n[n.Errors=1]="Errors",n[n.Warnings=2]="Warnings",n[n.Info=3]="Info"})(dr||(dr={}));var ei=class n{constructor(){}static get level(){return n._level}static set level(e){if(e!==dr.Silent&&e!==dr.Errors&&e!==dr.Warnings&&e!==dr.Info)throw new TypeError("Invalid log level. Use one of the values of the LogLevel enum.");n._level=e}static get _emitter(){return n._emitterInstance??=new as}static on(e,t,i){return n._emitter.on(e,t,i)}static _error(...e){n._emitter._emit("error",e),n._level>=dr.Errors&&console.error(...e)}static _warn(...e){n._emitter._emit("warn",e),n._level>=dr.Warnings&&console.warn(...e)}static _info(...e){n._emitter._emit("info",e),n._level>=dr.Info&&console.info(...e)}};ei._level=dr.Info;ei._emitterInstance=null;var Va=class{constructor(e,t){if(this.data=e,this.mimeType=t,!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(typeof t!="string")throw new TypeError("mimeType must be a string.")}},yd=class{constructor(e,t,i,r){if(this.data=e,this.mimeType=t,this.name=i,this.description=r,!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(t!==void 0&&typeof t!="string")throw new TypeError("mimeType, when provided, must be a string.");if(i!==void 0&&typeof i!="string")throw new TypeError("name, when provided, must be a string.");if(r!==void 0&&typeof r!="string")throw new TypeError("description, when provided, must be a string.")}},ig=n=>{if(!n||typeof n!="object")throw new TypeError("tags must be an object.");if(n.title!==void 0&&typeof n.title!="string")throw new TypeError("tags.title, when provided, must be a string.");if(n.description!==void 0&&typeof n.description!="string")throw new TypeError("tags.description, when provided, must be a string.");if(n.artist!==void 0&&typeof n.artist!="string")throw new TypeError("tags.artist, when provided, must be a string.");if(n.album!==void 0&&typeof n.album!="string")throw new TypeError("tags.album, when provided, must be a string.");if(n.albumArtist!==void 0&&typeof n.albumArtist!="string")throw new TypeError("tags.albumArtist, when provided, must be a string.");if(n.trackNumber!==void 0&&(!Number.isInteger(n.trackNumber)||n.trackNumber<=0))throw new TypeError("tags.trackNumber, when provided, must be a positive integer.");if(n.tracksTotal!==void 0&&(!Number.isInteger(n.tracksTotal)||n.tracksTotal<=0))throw new TypeError("tags.tracksTotal, when provided, must be a positive integer.");if(n.discNumber!==void 0&&(!Number.isInteger(n.discNumber)||n.discNumber<=0))throw new TypeError("tags.discNumber, when provided, must be a positive integer.");if(n.discsTotal!==void 0&&(!Number.isInteger(n.discsTotal)||n.discsTotal<=0))throw new TypeError("tags.discsTotal, when provided, must be a positive integer.");if(n.genre!==void 0&&typeof n.genre!="string")throw new TypeError("tags.genre, when provided, must be a string.");if(n.date!==void 0&&(!(n.date instanceof Date)||Number.isNaN(n.date.getTime())))throw new TypeError("tags.date, when provided, must be a valid Date.");if(n.beatsPerMinute!==void 0&&(!Number.isInteger(n.beatsPerMinute)||n.beatsPerMinute<=0))throw new TypeError("tags.beatsPerMinute, when provided, must be a positive integer.");if(n.lyrics!==void 0&&typeof n.lyrics!="string")throw new TypeError("tags.lyrics, when provided, must be a string.");if(n.images!==void 0){if(!Array.isArray(n.images))throw new TypeError("tags.images, when provided, must be an array.");for(let e of n.images){if(!e||typeof e!="object")throw new TypeError("Each image in tags.images must be an object.");if(!(e.data instanceof Uint8Array))throw new TypeError("Each image.data must be a Uint8Array.");if(typeof e.mimeType!="string")throw new TypeError("Each image.mimeType must be a string.");if(!["coverFront","coverBack","unknown"].includes(e.kind))throw new TypeError("Each image.kind must be 'coverFront', 'coverBack', or 'unknown'.")}}if(n.comment!==void 0&&typeof n.comment!="string")throw new TypeError("tags.comment, when provided, must be a string.");if(n.raw!==void 0){if(!n.raw||typeof n.raw!="object")throw new TypeError("tags.raw, when provided, must be an object.");for(let e of Object.values(n.raw))if(e!==null&&typeof e!="string"&&!(Array.isArray(e)&&e.every(t=>typeof t=="string"))&&!(e instanceof Uint8Array)&&!(e instanceof Va)&&!(e instanceof yd)&&!ng(e))throw new TypeError("Each value in tags.raw must be a string, string array, Uint8Array, RichImageData, AttachedFile, Record<string, string>, or null.")}};var rg=n=>{if(!n||typeof n!="object")throw new TypeError("disposition must be an object.");if(n.default!==void 0&&typeof n.default!="boolean")throw new TypeError("disposition.default must be a boolean.");if(n.primary!==void 0&&typeof n.primary!="boolean")throw new TypeError("disposition.primary must be a boolean.");if(n.forced!==void 0&&typeof n.forced!="boolean")throw new TypeError("disposition.forced must be a boolean.");if(n.original!==void 0&&typeof n.original!="boolean")throw new TypeError("disposition.original must be a boolean.");if(n.commentary!==void 0&&typeof n.commentary!="boolean")throw new TypeError("disposition.commentary must be a boolean.");if(n.hearingImpaired!==void 0&&typeof n.hearingImpaired!="boolean")throw new TypeError("disposition.hearingImpaired must be a boolean.");if(n.visuallyImpaired!==void 0&&typeof n.visuallyImpaired!="boolean")throw new TypeError("disposition.visuallyImpaired must be a boolean.")};var Bn=class n{constructor(e){this.bytes=e,this.pos=0}seekToByte(e){this.pos=8*e}readBit(){let e=Math.floor(this.pos/8),t=this.bytes[e]??0,i=7-(this.pos&7),r=(t&1<<i)>>i;return this.pos++,r}readBits(e){if(e===1)return this.readBit();let t=0;for(let i=0;i<e;i++)t<<=1,t|=this.readBit();return t}writeBits(e,t){let i=this.pos+e;for(let r=this.pos;r<i;r++){let s=Math.floor(r/8),o=this.bytes[s],a=7-(r&7);o&=~(1<<a),o|=(t&1<<i-r-1)>>i-r-1<<a,this.bytes[s]=o}this.pos=i}copyBits(e,t){let i=0;for(i;i<e-7;i+=8)this.writeBits(8,t.readBits(8));let r=e-i;r>0&&this.writeBits(r,t.readBits(r))}readAlignedByte(){if(this.pos%8!==0)throw new Error("Bitstream is not byte-aligned.");let e=this.pos/8,t=this.bytes[e]??0;return this.pos+=8,t}skipBits(e){this.pos+=e}getBitsLeft(){return this.bytes.length*8-this.pos}clone(){let e=new n(this.bytes);return e.pos=this.pos,e}};var bd=[96e3,88200,64e3,48e3,44100,32e3,24e3,22050,16e3,12e3,11025,8e3,7350],vd=[-1,1,2,3,4,5,6,8];var ag=n=>{let e=n.objectType===5||n.objectType===29,t=n.objectType===29,i=e?n.outputSampleRate/2:n.outputSampleRate,r=t?1:n.outputNumberOfChannels,s=vd.indexOf(r);if(s===-1)throw new TypeError(`Unsupported number of channels: ${n.outputNumberOfChannels}`);let o=16;n.objectType>=32&&(o+=6),_d(i)===15&&(o+=24),e&&(o+=9,_d(n.outputSampleRate)===15&&(o+=24));let a=Math.ceil(o/8),l=new Uint8Array(a),c=new Bn(l);return sg(c,n.objectType),og(c,i),c.writeBits(4,s),e&&(og(c,n.outputSampleRate),sg(c,2)),c.writeBits(3,0),l},sg=(n,e)=>{e<32?n.writeBits(5,e):(n.writeBits(5,31),n.writeBits(6,e-32))},og=(n,e)=>{let t=_d(e);n.writeBits(4,t),t===15&&n.writeBits(24,e)},_d=n=>{let e=bd.indexOf(n);return e===-1?15:e};var lg=[48e3,44100,32e3],cg=[24e3,22050,16e3];var Jv="1.61.0",dc=`Mediabunny v${Jv}`;var Ha;(function(n){n[n.NON_IDR_SLICE=1]="NON_IDR_SLICE",n[n.SLICE_DPA=2]="SLICE_DPA",n[n.SLICE_DPB=3]="SLICE_DPB",n[n.SLICE_DPC=4]="SLICE_DPC",n[n.IDR=5]="IDR",n[n.SEI=6]="SEI",n[n.SPS=7]="SPS",n[n.PPS=8]="PPS",n[n.AUD=9]="AUD",n[n.SPS_EXT=13]="SPS_EXT"})(Ha||(Ha={}));var fr;(function(n){n[n.RASL_N=8]="RASL_N",n[n.RASL_R=9]="RASL_R",n[n.BLA_W_LP=16]="BLA_W_LP",n[n.RSV_IRAP_VCL23=23]="RSV_IRAP_VCL23",n[n.VPS_NUT=32]="VPS_NUT",n[n.SPS_NUT=33]="SPS_NUT",n[n.PPS_NUT=34]="PPS_NUT",n[n.AUD_NUT=35]="AUD_NUT",n[n.PREFIX_SEI_NUT=39]="PREFIX_SEI_NUT",n[n.SUFFIX_SEI_NUT=40]="SUFFIX_SEI_NUT"})(fr||(fr={}));var fc=function*(n){let e=0,t=-1;for(;e<n.length-2;){let i=n.indexOf(0,e);if(i===-1||i>=n.length-2)break;e=i;let r=0;if(e+3<n.length&&n[e+1]===0&&n[e+2]===0&&n[e+3]===1?r=4:n[e+1]===0&&n[e+2]===1&&(r=3),r===0){e++;continue}t!==-1&&e>t&&(yield{offset:t,length:e-t}),t=e+r,e=t}t!==-1&&t<n.length&&(yield{offset:t,length:n.length-t})};var tw=n=>n&31,Sd=n=>{let e=[],t=n.length;for(let i=0;i<t;i++)i+2<t&&n[i]===0&&n[i+1]===0&&n[i+2]===3?(e.push(0,0),i+=2):e.push(n[i]);return new Uint8Array(e)};var oI=new Uint8Array([0,0,0,1]);var xg=(n,e)=>{let t=n.reduce((s,o)=>s+e+o.byteLength,0),i=new Uint8Array(t),r=0;for(let s of n){let o=new DataView(i.buffer,i.byteOffset,i.byteLength);switch(e){case 1:o.setUint8(r,s.byteLength);break;case 2:o.setUint16(r,s.byteLength,!1);break;case 3:Zm(o,r,s.byteLength,!1);break;case 4:o.setUint32(r,s.byteLength,!1);break}r+=e,i.set(s,r),r+=s.byteLength}return i};var yg=n=>{try{let e=[],t=[],i=[];for(let a of fc(n)){let l=n.subarray(a.offset,a.offset+a.length),c=tw(l[0]);c===Ha.SPS?e.push(l):c===Ha.PPS?t.push(l):c===Ha.SPS_EXT&&i.push(l)}if(e.length===0||t.length===0)return null;let r=e[0],s=nw(r);_e(s!==null);let o=s.profileIdc===100||s.profileIdc===110||s.profileIdc===122||s.profileIdc===144;return{configurationVersion:1,avcProfileIndication:s.profileIdc,profileCompatibility:s.constraintFlags,avcLevelIndication:s.levelIdc,lengthSizeMinusOne:3,sequenceParameterSets:e,pictureParameterSets:t,chromaFormat:o?s.chromaFormatIdc:null,bitDepthLumaMinus8:o?s.bitDepthLumaMinus8:null,bitDepthChromaMinus8:o?s.bitDepthChromaMinus8:null,sequenceParameterSetExt:o?i:null}}catch(e){return ei._error("Error building AVC Decoder Configuration Record:",e),null}},_g=n=>{let e=[];e.push(n.configurationVersion),e.push(n.avcProfileIndication),e.push(n.profileCompatibility),e.push(n.avcLevelIndication),e.push(252|n.lengthSizeMinusOne&3),e.push(224|n.sequenceParameterSets.length&31);for(let t of n.sequenceParameterSets){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}e.push(n.pictureParameterSets.length);for(let t of n.pictureParameterSets){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}if((n.avcProfileIndication===100||n.avcProfileIndication===110||n.avcProfileIndication===122||n.avcProfileIndication===144)&&n.chromaFormat!==null){_e(n.bitDepthLumaMinus8!==null),_e(n.bitDepthChromaMinus8!==null),_e(n.sequenceParameterSetExt!==null),e.push(252|n.chromaFormat&3),e.push(248|n.bitDepthLumaMinus8&7),e.push(248|n.bitDepthChromaMinus8&7),e.push(n.sequenceParameterSetExt.length);for(let t of n.sequenceParameterSetExt){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}}return new Uint8Array(e)};var bg={1:{num:1,den:1},2:{num:12,den:11},3:{num:10,den:11},4:{num:16,den:11},5:{num:40,den:33},6:{num:24,den:11},7:{num:20,den:11},8:{num:32,den:11},9:{num:80,den:33},10:{num:18,den:11},11:{num:15,den:11},12:{num:64,den:33},13:{num:160,den:99},14:{num:4,den:3},15:{num:3,den:2},16:{num:2,den:1}},nw=n=>{try{let e=Sd(n),t=new Bn(e);if(t.skipBits(1),t.skipBits(2),t.readBits(5)!==7)return null;let r=t.readAlignedByte(),s=t.readAlignedByte(),o=t.readAlignedByte();Re(t);let a=1,l=0,c=0,u=0;if((r===100||r===110||r===122||r===244||r===44||r===83||r===86||r===118||r===128)&&(a=Re(t),a===3&&(u=t.readBits(1)),l=Re(t),c=Re(t),t.skipBits(1),t.readBits(1))){for(let W=0;W<(a!==3?8:12);W++)if(t.readBits(1)){let ae=W<6?16:64,$=8,j=8;for(let te=0;te<ae;te++){if(j!==0){let ue=hr(t);j=($+ue+256)%256}$=j===0?$:j}}}Re(t);let h=Re(t);if(h===0)Re(t);else if(h===1){t.skipBits(1),hr(t),hr(t);let H=Re(t);for(let W=0;W<H;W++)hr(t)}Re(t),t.skipBits(1);let d=Re(t),f=Re(t),m=16*(d+1),x=16*(f+1),g=m,p=x,b=t.readBits(1);if(b||t.skipBits(1),t.skipBits(1),t.readBits(1)){let H=Re(t),W=Re(t),V=Re(t),ae=Re(t),$,j;if((u===0?a:0)===0)$=1,j=2-b;else{let ue=a===3?1:2,he=a===1?2:1;$=ue,j=he*(2-b)}g-=$*(H+W),p-=j*(V+ae)}let v=2,C=2,T=2,y=0,M={num:1,den:1},B=null,L=null,I=null,D=null,U=t.pos;if(t.readBits(1)){if(t.readBits(1)){let ue=t.readBits(8);if(ue===255)M={num:t.readBits(16),den:t.readBits(16)};else{let he=bg[ue];he&&(M=he)}}t.readBits(1)&&t.skipBits(1),t.readBits(1)&&(t.skipBits(3),y=t.readBits(1),t.readBits(1)&&(v=t.readBits(8),C=t.readBits(8),T=t.readBits(8))),t.readBits(1)&&(Re(t),Re(t)),t.readBits(1)&&(t.skipBits(32),t.skipBits(32),t.skipBits(1));let j=t.readBits(1);j&&ug(t);let te=t.readBits(1);te&&ug(t),(j||te)&&t.skipBits(1),t.skipBits(1),I=t.pos,D=t.readBits(1),D&&(t.skipBits(1),Re(t),Re(t),Re(t),Re(t),B=Re(t),L=Re(t))}if(B===null){_e(L===null);let H=s&16;if((r===44||r===86||r===100||r===110||r===122||r===244)&&H)B=0,L=0;else{let W=d+1,V=f+1,ae=(2-b)*V,$=wd.find(te=>te.level>=o)??cr(wd),j=Math.min(Math.floor($.maxDpbMbs/(W*ae)),16);B=j,L=j}}return _e(L!==null),{emulationUnpreventedBytes:e,profileIdc:r,constraintFlags:s,levelIdc:o,frameMbsOnlyFlag:b,chromaFormatIdc:a,bitDepthLumaMinus8:l,bitDepthChromaMinus8:c,codedWidth:m,codedHeight:x,displayWidth:g,displayHeight:p,pixelAspectRatio:M,colourPrimaries:v,matrixCoefficients:T,transferCharacteristics:C,fullRangeFlag:y,numReorderFrames:B,maxDecFrameBuffering:L,vuiParametersFlagBitOffset:U,bitstreamRestrictionFlagBitOffset:I,bitstreamRestrictionFlag:D}}catch(e){return ei._error("Error parsing AVC SPS:",e),null}},ug=n=>{let e=Re(n);n.skipBits(4),n.skipBits(4);for(let t=0;t<=e;t++)Re(n),Re(n),n.skipBits(1);n.skipBits(5),n.skipBits(5),n.skipBits(5),n.skipBits(5)};var hg=n=>n>>1&63,iw=n=>{try{let e=new Bn(Sd(n));e.skipBits(16),e.readBits(4);let t=e.readBits(3),i=e.readBits(1),{general_profile_space:r,general_tier_flag:s,general_profile_idc:o,general_profile_compatibility_flags:a,general_constraint_indicator_flags:l,general_level_idc:c}=rw(e,t);Re(e);let u=Re(e),h=0;u===3&&(h=e.readBits(1));let d=Re(e),f=Re(e),m=d,x=f;if(e.readBits(1)){let D=Re(e),U=Re(e),F=Re(e),H=Re(e),W=1,V=1,ae=h===0?u:0;ae===1?(W=2,V=2):ae===2&&(W=2,V=1),m-=(D+U)*W,x-=(F+H)*V}let g=Re(e),p=Re(e);Re(e);let E=e.readBits(1)?0:t,v=0;for(let D=E;D<=t;D++)Re(e),v=Re(e),Re(e);Re(e),Re(e),Re(e),Re(e),Re(e),Re(e),e.readBits(1)&&e.readBits(1)&&sw(e),e.skipBits(1),e.skipBits(1),e.readBits(1)&&(e.skipBits(4),e.skipBits(4),Re(e),Re(e),e.skipBits(1));let C=Re(e);if(ow(e,C),e.readBits(1)){let D=Re(e);for(let U=0;U<D;U++)Re(e),e.skipBits(1)}e.skipBits(1),e.skipBits(1);let T=2,y=2,M=2,B=0,L=0,I={num:1,den:1};if(e.readBits(1)){let D=lw(e,t);I=D.pixelAspectRatio,T=D.colourPrimaries,y=D.transferCharacteristics,M=D.matrixCoefficients,B=D.fullRangeFlag,L=D.minSpatialSegmentationIdc}return{displayWidth:m,displayHeight:x,pixelAspectRatio:I,colourPrimaries:T,transferCharacteristics:y,matrixCoefficients:M,fullRangeFlag:B,maxDecFrameBuffering:v+1,spsMaxSubLayersMinus1:t,spsTemporalIdNestingFlag:i,generalProfileSpace:r,generalTierFlag:s,generalProfileIdc:o,generalProfileCompatibilityFlags:a,generalConstraintIndicatorFlags:l,generalLevelIdc:c,chromaFormatIdc:u,bitDepthLumaMinus8:g,bitDepthChromaMinus8:p,minSpatialSegmentationIdc:L}}catch(e){return ei._error("Error parsing HEVC SPS:",e),null}},vg=n=>{try{let e=[],t=[],i=[],r=[];for(let c of fc(n)){let u=n.subarray(c.offset,c.offset+c.length),h=hg(u[0]);h===fr.VPS_NUT?e.push(u):h===fr.SPS_NUT?t.push(u):h===fr.PPS_NUT?i.push(u):(h===fr.PREFIX_SEI_NUT||h===fr.SUFFIX_SEI_NUT)&&r.push(u)}if(t.length===0||i.length===0)return null;let s=iw(t[0]);if(!s)return null;let o=0;if(i.length>0){let c=i[0],u=new Bn(Sd(c));u.skipBits(16),Re(u),Re(u),u.skipBits(1),u.skipBits(1),u.skipBits(3),u.skipBits(1),u.skipBits(1),Re(u),Re(u),hr(u),u.skipBits(1),u.skipBits(1),u.readBits(1)&&Re(u),hr(u),hr(u),u.skipBits(1),u.skipBits(1),u.skipBits(1),u.skipBits(1);let h=u.readBits(1),d=u.readBits(1);!h&&!d?o=0:h&&!d?o=2:!h&&d?o=3:o=0}let a=[...e.length?[{arrayCompleteness:1,nalUnitType:fr.VPS_NUT,nalUnits:e}]:[],...t.length?[{arrayCompleteness:1,nalUnitType:fr.SPS_NUT,nalUnits:t}]:[],...i.length?[{arrayCompleteness:1,nalUnitType:fr.PPS_NUT,nalUnits:i}]:[],...r.length?[{arrayCompleteness:1,nalUnitType:hg(r[0][0]),nalUnits:r}]:[]];return{configurationVersion:1,generalProfileSpace:s.generalProfileSpace,generalTierFlag:s.generalTierFlag,generalProfileIdc:s.generalProfileIdc,generalProfileCompatibilityFlags:s.generalProfileCompatibilityFlags,generalConstraintIndicatorFlags:s.generalConstraintIndicatorFlags,generalLevelIdc:s.generalLevelIdc,minSpatialSegmentationIdc:s.minSpatialSegmentationIdc,parallelismType:o,chromaFormatIdc:s.chromaFormatIdc,bitDepthLumaMinus8:s.bitDepthLumaMinus8,bitDepthChromaMinus8:s.bitDepthChromaMinus8,avgFrameRate:0,constantFrameRate:0,numTemporalLayers:s.spsMaxSubLayersMinus1+1,temporalIdNested:s.spsTemporalIdNestingFlag,lengthSizeMinusOne:3,arrays:a}}catch(e){return ei._error("Error building HEVC Decoder Configuration Record:",e),null}},rw=(n,e)=>{let t=n.readBits(2),i=n.readBits(1),r=n.readBits(5),s=0;for(let u=0;u<32;u++)s=s<<1|n.readBits(1);let o=new Uint8Array(6);for(let u=0;u<6;u++)o[u]=n.readBits(8);let a=n.readBits(8),l=[],c=[];for(let u=0;u<e;u++)l.push(n.readBits(1)),c.push(n.readBits(1));if(e>0)for(let u=e;u<8;u++)n.skipBits(2);for(let u=0;u<e;u++)l[u]&&n.skipBits(88),c[u]&&n.skipBits(8);return{general_profile_space:t,general_tier_flag:i,general_profile_idc:r,general_profile_compatibility_flags:s,general_constraint_indicator_flags:o,general_level_idc:a}},sw=n=>{for(let e=0;e<4;e++)for(let t=0;t<(e===3?2:6);t++)if(!n.readBits(1))Re(n);else{let r=Math.min(64,1<<4+(e<<1));e>1&&hr(n);for(let s=0;s<r;s++)hr(n)}},ow=(n,e)=>{let t=[];for(let i=0;i<e;i++)t[i]=aw(n,i,e,t)},aw=(n,e,t,i)=>{let r=0,s=0,o=0;if(e!==0&&(s=n.readBits(1)),s){if(e===t){let l=Re(n);o=e-(l+1)}else o=e-1;n.readBits(1),Re(n);let a=i[o]??0;for(let l=0;l<=a;l++)n.readBits(1)||n.readBits(1);r=i[o]}else{let a=Re(n),l=Re(n);for(let c=0;c<a;c++)Re(n),n.readBits(1);for(let c=0;c<l;c++)Re(n),n.readBits(1);r=a+l}return r},lw=(n,e)=>{let t=2,i=2,r=2,s=0,o=0,a={num:1,den:1};if(n.readBits(1)){let l=n.readBits(8);if(l===255)a={num:n.readBits(16),den:n.readBits(16)};else{let c=bg[l];c&&(a=c)}}return n.readBits(1)&&n.readBits(1),n.readBits(1)&&(n.readBits(3),s=n.readBits(1),n.readBits(1)&&(t=n.readBits(8),i=n.readBits(8),r=n.readBits(8))),n.readBits(1)&&(Re(n),Re(n)),n.readBits(1),n.readBits(1),n.readBits(1),n.readBits(1)&&(Re(n),Re(n),Re(n),Re(n)),n.readBits(1)&&(n.readBits(32),n.readBits(32),n.readBits(1)&&Re(n),n.readBits(1)&&cw(n,!0,e)),n.readBits(1)&&(n.readBits(1),n.readBits(1),n.readBits(1),o=Re(n),Re(n),Re(n),Re(n),Re(n)),{pixelAspectRatio:a,colourPrimaries:t,transferCharacteristics:i,matrixCoefficients:r,fullRangeFlag:s,minSpatialSegmentationIdc:o}},cw=(n,e,t)=>{let i=!1,r=!1,s=!1;e&&(i=n.readBits(1)===1,r=n.readBits(1)===1,(i||r)&&(s=n.readBits(1)===1,s&&(n.readBits(8),n.readBits(5),n.readBits(1),n.readBits(5)),n.readBits(4),n.readBits(4),s&&n.readBits(4),n.readBits(5),n.readBits(5),n.readBits(5)));for(let o=0;o<=t;o++){let a=n.readBits(1)===1,l=!0;a||(l=n.readBits(1)===1);let c=!1;l?Re(n):c=n.readBits(1)===1;let u=1;c||(u=Re(n)+1),i&&dg(n,u,s),r&&dg(n,u,s)}},dg=(n,e,t)=>{for(let i=0;i<e;i++)Re(n),Re(n),t&&(Re(n),Re(n)),n.readBits(1)},wg=n=>{let e=[];e.push(n.configurationVersion),e.push((n.generalProfileSpace&3)<<6|(n.generalTierFlag&1)<<5|n.generalProfileIdc&31),e.push(n.generalProfileCompatibilityFlags>>>24&255),e.push(n.generalProfileCompatibilityFlags>>>16&255),e.push(n.generalProfileCompatibilityFlags>>>8&255),e.push(n.generalProfileCompatibilityFlags&255),e.push(...n.generalConstraintIndicatorFlags),e.push(n.generalLevelIdc&255),e.push(240|n.minSpatialSegmentationIdc>>8&15),e.push(n.minSpatialSegmentationIdc&255),e.push(252|n.parallelismType&3),e.push(252|n.chromaFormatIdc&3),e.push(248|n.bitDepthLumaMinus8&7),e.push(248|n.bitDepthChromaMinus8&7),e.push(n.avgFrameRate>>8&255),e.push(n.avgFrameRate&255),e.push((n.constantFrameRate&3)<<6|(n.numTemporalLayers&7)<<3|(n.temporalIdNested&1)<<2|n.lengthSizeMinusOne&3),e.push(n.arrays.length&255);for(let t of n.arrays){e.push((t.arrayCompleteness&1)<<7|0|t.nalUnitType&63),e.push(t.nalUnits.length>>8&255),e.push(t.nalUnits.length&255);for(let i of t.nalUnits){e.push(i.length>>8&255),e.push(i.length&255);for(let r=0;r<i.length;r++)e.push(i[r])}}return new Uint8Array(e)};var fg;(function(n){n[n.audAllowed=0]="audAllowed",n[n.beforeFirstVcl=1]="beforeFirstVcl",n[n.afterFirstVcl=2]="afterFirstVcl",n[n.eoBitstreamAllowed=3]="eoBitstreamAllowed",n[n.noMoreDataAllowed=4]="noMoreDataAllowed"})(fg||(fg={}));var Sg=n=>{let e=Ns(n),t=e.getUint8(9),i=e.getUint16(10,!0),r=e.getUint32(12,!0),s=e.getInt16(16,!0),o=e.getUint8(18),a=null;return o&&(a=n.subarray(19,21+t)),{outputChannelCount:t,preSkip:i,inputSampleRate:r,outputGain:s,channelMappingFamily:o,channelMappingTable:a}};var pg;(function(n){n[n.STREAMINFO=0]="STREAMINFO",n[n.VORBIS_COMMENT=4]="VORBIS_COMMENT",n[n.PICTURE=6]="PICTURE"})(pg||(pg={}));var Ag=n=>{if(n.length<7||n[0]!==11||n[1]!==119)return null;let e=new Bn(n);e.skipBits(16),e.skipBits(16);let t=e.readBits(2);if(t===3)return null;let i=e.readBits(6),r=e.readBits(5);if(r>8)return null;let s=e.readBits(3),o=e.readBits(3);(o&1)!==0&&o!==1&&e.skipBits(2),(o&4)!==0&&e.skipBits(2),o===2&&e.skipBits(2);let a=e.readBits(1),l=Math.floor(i/2);return{fscod:t,bsid:r,bsmod:s,acmod:o,lfeon:a,bitRateCode:l}},aI=[128,138,192,128,140,192,160,174,240,160,176,240,192,208,288,192,210,288,224,242,336,224,244,336,256,278,384,256,280,384,320,348,480,320,350,480,384,416,288*2,384,418,288*2,448,486,336*2,448,488,336*2,256*2,278*2,384*2,256*2,279*2,384*2,320*2,348*2,480*2,320*2,349*2,480*2,384*2,417*2,576*2,384*2,418*2,576*2,448*2,487*2,672*2,448*2,488*2,672*2,512*2,557*2,768*2,512*2,558*2,768*2,640*2,696*2,960*2,640*2,697*2,960*2,768*2,835*2,1152*2,768*2,836*2,1152*2,896*2,975*2,1344*2,896*2,976*2,1344*2,1024*2,1114*2,1536*2,1024*2,1115*2,1536*2,1152*2,1253*2,1728*2,1152*2,1254*2,1728*2,1280*2,1393*2,1920*2,1280*2,1394*2,1920*2];var lI=new Uint8Array([5,4,65,67,45,51]),cI=new Uint8Array([5,4,69,65,67,51]),uw=[1,2,3,6],Mg=n=>{if(n.length<6||n[0]!==11||n[1]!==119)return null;let e=new Bn(n);e.skipBits(16);let t=e.readBits(2);if(e.skipBits(3),t!==0&&t!==2)return null;let i=e.readBits(11),r=e.readBits(2),s=0,o;r===3?(s=e.readBits(2),o=3):o=e.readBits(2);let a=e.readBits(3),l=e.readBits(1),c=e.readBits(5);if(c<11||c>16)return null;let u=uw[o],h;return r<3?h=lg[r]/1e3:h=cg[s]/1e3,{dataRate:Math.round((i+1)*h/(u*16)),substreams:[{fscod:r,fscod2:s,bsid:c,bsmod:0,acmod:a,lfeon:l,numDepSub:0,chanLoc:0}]}};var hw=1683496997,dw=18,fw=10;var mg=32,pw=20,mw=8,gw=[0,8e3,16e3,32e3,0,0,11025,22050,44100,0,0,12e3,24e3,48e3,96e3,192e3],xw=[32e3,56e3,64e3,96e3,112e3,128e3,192e3,224e3,256e3,32e4,384e3,448e3,512e3,576e3,64e4,768e3,96e4,1024e3,1152e3,128e4,1344e3,1408e3,1411200,1472e3,1536e3,192e4,2048e3,3072e3,384e4,0,0,0],yw=[16,16,20,20,0,24,24,0],gg=[1,2,2,2,2,3,3,4,4,5,6,6,6,7,8,8],_w=[1,2,2,2,2,3,18,19,6,7,518,323,83,519,582,535],bw=8;var vw=[32e3,44100,48e3,0],ww=[8e3,16e3,32e3,64e3,128e3,22050,44100,88200,176400,352800,12e3,24e3,48e3,96e3,192e3,384e3],Sw=[512,1024,2048,4096],Tg=n=>{let e=Aw(n),t=Ns(n),i=e?Math.ceil(e.frameSize/4)*4:0,r=null;for(;i+4<=n.length&&t.getUint32(i)===hw;){let o=Mw(n.subarray(i));if(!o)break;r??=o,i+=o.frameSize}if(e)return{frameSize:r?i:e.frameSize,sampleRate:e.sampleRate,numberOfChannels:e.numberOfChannels,sampleCount:e.sampleCount,channelLayout:e.channelLayout,pcmResolution:e.pcmResolution,bitRate:e.bitRate,core:e,hasExtensions:r!==null};if(!r?.asset)return null;let{asset:s}=r;return{frameSize:i,sampleRate:s.sampleRate,numberOfChannels:s.numberOfChannels,sampleCount:s.sampleCount,channelLayout:s.channelLayout,pcmResolution:s.pcmResolution,bitRate:0,core:null,hasExtensions:!0}};var Aw=n=>{if(n.length<dw||n[0]!==127||n[1]!==254||n[2]!==128||n[3]!==1)return null;let e=new Bn(n);if(e.skipBits(32),e.skipBits(1),e.readBits(5)!==mg-1)return null;let t=e.readBits(1),i=e.readBits(7)+1;if(i%mw!==0)return null;let r=e.readBits(14)+1;if(r<96)return null;let s=e.readBits(6);if(s>=gg.length)return null;let o=gw[e.readBits(4)];if(o===0)return null;let a=xw[e.readBits(5)];if(e.readBits(1)!==0)return null;e.skipBits(4),e.skipBits(5);let l=e.readBits(2);if(l===3)return null;e.skipBits(1),t&&e.skipBits(16),e.skipBits(7);let c=yw[e.readBits(3)];if(c===0)return null;let u=l!==0;return{frameSize:r,sampleRate:o,numberOfChannels:gg[s]+(u?1:0),sampleCount:i*mg,channelLayout:_w[s]|(u?bw:0),amode:s,lfePresent:u,bitRate:a,pcmResolution:c}},Mw=n=>{if(n.length<fw||n[0]!==100||n[1]!==88||n[2]!==32||n[3]!==37)return null;let e=new Bn(n);e.skipBits(32),e.skipBits(8);let t=e.readBits(2),i=e.readBits(1),r=8+4*i,s=16+4*i;e.skipBits(r);let o=e.readBits(s)+1,a={frameSize:o,asset:null};if(!e.readBits(1))return a;let l=vw[e.readBits(2)],c=512*(e.readBits(3)+1);e.readBits(1)&&e.skipBits(36);let u=e.readBits(3)+1,h=e.readBits(3)+1,d=[];for(let p=0;p<u;p++)d.push(e.readBits(t+1));for(let p of d)e.skipBits(8*Jm(p));if(e.readBits(1)){e.skipBits(2);let p=e.readBits(2)+1<<2,b=e.readBits(2)+1;e.skipBits(b*p)}for(let p=0;p<h;p++)e.skipBits(s);e.skipBits(9),e.skipBits(3),e.readBits(1)&&e.skipBits(4),e.readBits(1)&&e.skipBits(24),e.readBits(1)&&e.skipBits(8*(e.readBits(10)+1));let f=e.readBits(5)+1,m=ww[e.readBits(4)],x=e.readBits(8)+1,g=0;if(e.readBits(1)&&(x>2&&e.skipBits(1),x>6&&e.skipBits(1),e.readBits(1))){let p=e.readBits(2)+1<<2;g=e.readBits(p)}return l===0||e.getBitsLeft()<0?a:{frameSize:o,asset:{sampleRate:m,numberOfChannels:x,sampleCount:Math.round(c*m/l),channelLayout:g,pcmResolution:f}}};var Eg=n=>{let e=new Uint8Array(pw),t=Ns(e);t.setUint32(0,n.sampleRate),t.setUint32(4,n.bitRate),t.setUint32(8,n.bitRate),e[12]=n.pcmResolution;let i=n.core&&!n.hasExtensions?1:0,r=new Bn(e);return r.seekToByte(13),r.writeBits(2,Math.max(Sw.indexOf(n.sampleCount),0)),r.writeBits(5,i),r.writeBits(1,n.core?.lfePresent?1:0),r.writeBits(6,n.core?.amode??0),r.writeBits(14,n.core?n.core.frameSize-1:0),r.writeBits(1,0),r.writeBits(3,0),r.writeBits(16,n.channelLayout),r.writeBits(1,0),r.writeBits(1,0),r.writeBits(1,0),r.writeBits(5,0),e};var cs=["avc","hevc","vp9","av1","vp8","prores"],pr=["pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be","pcm-u8","pcm-s8","ulaw","alaw"],pc=["aac","opus","mp3","vorbis","flac","ac3","eac3","dts"],So=[...pc,...pr],Bs=["webvtt"],wd=[{maxMacroblocks:99,maxBitrate:64e3,maxDpbMbs:396,level:10},{maxMacroblocks:396,maxBitrate:192e3,maxDpbMbs:900,level:11},{maxMacroblocks:396,maxBitrate:384e3,maxDpbMbs:2376,level:12},{maxMacroblocks:396,maxBitrate:768e3,maxDpbMbs:2376,level:13},{maxMacroblocks:396,maxBitrate:2e6,maxDpbMbs:2376,level:20},{maxMacroblocks:792,maxBitrate:4e6,maxDpbMbs:4752,level:21},{maxMacroblocks:1620,maxBitrate:4e6,maxDpbMbs:8100,level:22},{maxMacroblocks:1620,maxBitrate:1e7,maxDpbMbs:8100,level:30},{maxMacroblocks:3600,maxBitrate:14e6,maxDpbMbs:18e3,level:31},{maxMacroblocks:5120,maxBitrate:2e7,maxDpbMbs:20480,level:32},{maxMacroblocks:8192,maxBitrate:2e7,maxDpbMbs:32768,level:40},{maxMacroblocks:8192,maxBitrate:5e7,maxDpbMbs:32768,level:41},{maxMacroblocks:8704,maxBitrate:5e7,maxDpbMbs:34816,level:42},{maxMacroblocks:22080,maxBitrate:135e6,maxDpbMbs:110400,level:50},{maxMacroblocks:36864,maxBitrate:24e7,maxDpbMbs:184320,level:51},{maxMacroblocks:36864,maxBitrate:24e7,maxDpbMbs:184320,level:52},{maxMacroblocks:139264,maxBitrate:24e7,maxDpbMbs:696320,level:60},{maxMacroblocks:139264,maxBitrate:48e7,maxDpbMbs:696320,level:61},{maxMacroblocks:139264,maxBitrate:8e8,maxDpbMbs:696320,level:62}];var Ga=["ap4x","ap4h","apch","apcn","apcs","apco"],Ad=["dtsc","dtsh","dtsl","dtse"];var Cg=n=>{let e=n.split("."),r=(1<<7)+1,s=Number(e[1]),o=e[2],a=Number(o.slice(0,-1)),l=(s<<5)+a,c=o.slice(-1)==="H"?1:0,u=Number(e[3]),h=u===8?0:1,d=u===12?1:0,f=e[4]?Number(e[4]):0,m=e[5]?Number(e[5][0]):1,x=e[5]?Number(e[5][1]):1,g=e[5]?Number(e[5][2]):0,p=(c<<7)+(h<<6)+(d<<5)+(f<<4)+(m<<3)+(x<<2)+g;return[r,l,p,0]};var Rg=/^pcm-([usf])(\d+)(be)?$/,Nr=n=>{if(_e(pr.includes(n)),n==="ulaw")return{dataType:"ulaw",sampleSize:1,littleEndian:!0,silentValue:255};if(n==="alaw")return{dataType:"alaw",sampleSize:1,littleEndian:!0,silentValue:213};let e=Rg.exec(n);_e(e);let t;e[1]==="u"?t="unsigned":e[1]==="s"?t="signed":t="float";let i=Number(e[2])/8,r=e[3]!=="be",s=n==="pcm-u8"?2**7:0;return{dataType:t,sampleSize:i,littleEndian:r,silentValue:s}},Pg=n=>n.startsWith("avc1")||n.startsWith("avc3")?"avc":n.startsWith("hev1")||n.startsWith("hvc1")?"hevc":n==="vp8"?"vp8":n.startsWith("vp09")?"vp9":n.startsWith("av01")?"av1":Ga.includes(n)?"prores":n==="mp3"||n==="mp4a.69"||n==="mp4a.6B"||n==="mp4a.6b"||n==="mp4a.40.34"?"mp3":n.startsWith("mp4a.40.")||n==="mp4a.67"?"aac":n==="opus"||n==="Opus"?"opus":n==="vorbis"?"vorbis":n==="flac"?"flac":n==="ac-3"||n==="ac3"?"ac3":n==="ec-3"||n==="eac3"?"eac3":Ad.includes(n)?"dts":n==="ulaw"?"ulaw":n==="alaw"?"alaw":Rg.test(n)?n:n==="webvtt"?"webvtt":null;var Tw=["avc1","avc3","hev1","hvc1","vp8","vp09","av01",...Ga],Ew=/^(avc1|avc3)\.[0-9a-fA-F]{6}$/,Cw=/^(hev1|hvc1)\.(?:[ABC]?\d+)\.[0-9a-fA-F]{1,8}\.[LH]\d+(?:\.[0-9a-fA-F]{1,2}){0,6}$/,Rw=/^vp09(?:\.\d{2}){3}(?:(?:\.\d{2}){5})?$/,Pw=/^av01\.\d\.\d{2}[MH]\.\d{2}(?:\.\d\.\d{3}\.\d{2}\.\d{2}\.\d{2}\.\d)?$/,mc=(n,e)=>{if(!n)throw new TypeError("Video chunk metadata must be provided.");if(typeof n!="object")throw new TypeError("Video chunk metadata must be an object.");if(!n.decoderConfig)throw new TypeError("Video chunk metadata must include a decoder configuration.");if(typeof n.decoderConfig!="object")throw new TypeError("Video chunk metadata decoder configuration must be an object.");if(typeof n.decoderConfig.codec!="string")throw new TypeError("Video chunk metadata decoder configuration must specify a codec string.");if(!Tw.some(t=>n.decoderConfig.codec.startsWith(t)))throw new TypeError("Video chunk metadata decoder configuration codec string must be a valid video codec string as specified in the Mediabunny Codec Registry.");if(!Number.isInteger(n.decoderConfig.codedWidth)||n.decoderConfig.codedWidth<=0)throw new TypeError("Video chunk metadata decoder configuration must specify a valid codedWidth (positive integer).");if(!Number.isInteger(n.decoderConfig.codedHeight)||n.decoderConfig.codedHeight<=0)throw new TypeError("Video chunk metadata decoder configuration must specify a valid codedHeight (positive integer).");if(n.decoderConfig.displayAspectWidth!==void 0&&(!Number.isInteger(n.decoderConfig.displayAspectWidth)||n.decoderConfig.displayAspectWidth<=0))throw new TypeError("Video chunk metadata decoder configuration displayAspectWidth, when defined, must be a positive integer.");if(n.decoderConfig.displayAspectHeight!==void 0&&(!Number.isInteger(n.decoderConfig.displayAspectHeight)||n.decoderConfig.displayAspectHeight<=0))throw new TypeError("Video chunk metadata decoder configuration displayAspectHeight, when defined, must be a positive integer.");if(n.decoderConfig.displayAspectWidth!==void 0!=(n.decoderConfig.displayAspectHeight!==void 0))throw new TypeError("Video chunk metadata decoder configuration must specify both displayAspectWidth and displayAspectHeight, or neither.");if(n.decoderConfig.description!==void 0&&!gd(n.decoderConfig.description))throw new TypeError("Video chunk metadata decoder configuration description, when defined, must be an ArrayBuffer or an ArrayBuffer view.");if(n.decoderConfig.colorSpace!==void 0){let{colorSpace:t}=n.decoderConfig;if(typeof t!="object")throw new TypeError("Video chunk metadata decoder configuration colorSpace, when provided, must be an object.");let i=Object.keys(ka);if(t.primaries!=null&&!i.includes(t.primaries))throw new TypeError(`Video chunk metadata decoder configuration colorSpace primaries, when defined, must be one of ${i.join(", ")}.`);let r=Object.keys(Oa);if(t.transfer!=null&&!r.includes(t.transfer))throw new TypeError(`Video chunk metadata decoder configuration colorSpace transfer, when defined, must be one of ${r.join(", ")}.`);let s=Object.keys(Ua);if(t.matrix!=null&&!s.includes(t.matrix))throw new TypeError(`Video chunk metadata decoder configuration colorSpace matrix, when defined, must be one of ${s.join(", ")}.`);if(t.fullRange!=null&&typeof t.fullRange!="boolean")throw new TypeError("Video chunk metadata decoder configuration colorSpace fullRange, when defined, must be a boolean.")}if(n.decoderConfig.codec.startsWith("avc1")||n.decoderConfig.codec.startsWith("avc3")){if(!Ew.test(n.decoderConfig.codec))throw new TypeError("Video chunk metadata decoder configuration codec string for AVC must be a valid AVC codec string as specified in Section 3.4 of RFC 6381.")}else if(n.decoderConfig.codec.startsWith("hev1")||n.decoderConfig.codec.startsWith("hvc1")){if(!Cw.test(n.decoderConfig.codec))throw new TypeError("Video chunk metadata decoder configuration codec string for HEVC must be a valid HEVC codec string as specified in Section E.3 of ISO 14496-15.")}else if(n.decoderConfig.codec.startsWith("vp8")){if(n.decoderConfig.codec!=="vp8")throw new TypeError('Video chunk metadata decoder configuration codec string for VP8 must be "vp8".')}else if(n.decoderConfig.codec.startsWith("vp09")){if(!Rw.test(n.decoderConfig.codec))throw new TypeError('Video chunk metadata decoder configuration codec string for VP9 must be a valid VP9 codec string as specified in Section "Codecs Parameter String" of https://www.webmproject.org/vp9/mp4/.')}else if(n.decoderConfig.codec.startsWith("av01")){if(!Pw.test(n.decoderConfig.codec))throw new TypeError('Video chunk metadata decoder configuration codec string for AV1 must be a valid AV1 codec string as specified in Section "Codecs Parameter String" of https://aomediacodec.github.io/av1-isobmff/.')}else if(Ga.some(t=>n.decoderConfig.codec.startsWith(t))&&!Ga.some(t=>n.decoderConfig.codec===t))throw new TypeError(`Video chunk metadata decoder configuration codec string for ProRes must be one of the valid ProRes four-character codes: ${Ga.join(", ")}.`);if(e!==null&&Pg(n.decoderConfig.codec)!==e)throw new TypeError(`Video chunk metadata decoder configuration codec string '${n.decoderConfig.codec}' does not fit to the track codec '${e}'.`)},Iw=["mp4a","mp3","opus","vorbis","flac","ulaw","alaw","pcm","ac-3","ec-3","dts"],gc=(n,e)=>{if(!n)throw new TypeError("Audio chunk metadata must be provided.");if(typeof n!="object")throw new TypeError("Audio chunk metadata must be an object.");if(!n.decoderConfig)throw new TypeError("Audio chunk metadata must include a decoder configuration.");if(typeof n.decoderConfig!="object")throw new TypeError("Audio chunk metadata decoder configuration must be an object.");if(typeof n.decoderConfig.codec!="string")throw new TypeError("Audio chunk metadata decoder configuration must specify a codec string.");if(!Iw.some(t=>n.decoderConfig.codec.startsWith(t)))throw new TypeError("Audio chunk metadata decoder configuration codec string must be a valid audio codec string as specified in the Mediabunny Codec Registry.");if(!Number.isInteger(n.decoderConfig.sampleRate)||n.decoderConfig.sampleRate<=0)throw new TypeError("Audio chunk metadata decoder configuration must specify a valid sampleRate (positive integer).");if(!Number.isInteger(n.decoderConfig.numberOfChannels)||n.decoderConfig.numberOfChannels<=0)throw new TypeError("Audio chunk metadata decoder configuration must specify a valid numberOfChannels (positive integer).");if(n.decoderConfig.description!==void 0&&!gd(n.decoderConfig.description))throw new TypeError("Audio chunk metadata decoder configuration description, when defined, must be an ArrayBuffer or an ArrayBuffer view.");if(n.decoderConfig.codec.startsWith("mp4a")&&n.decoderConfig.codec!=="mp4a.69"&&n.decoderConfig.codec!=="mp4a.6B"&&n.decoderConfig.codec!=="mp4a.6b"){if(!["mp4a.40.2","mp4a.40.02","mp4a.40.5","mp4a.40.05","mp4a.40.29","mp4a.67"].includes(n.decoderConfig.codec))throw new TypeError("Audio chunk metadata decoder configuration codec string for AAC must be a valid AAC codec string as specified in https://www.w3.org/TR/webcodecs-aac-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("mp3")||n.decoderConfig.codec.startsWith("mp4a")){if(n.decoderConfig.codec!=="mp3"&&n.decoderConfig.codec!=="mp4a.69"&&n.decoderConfig.codec!=="mp4a.6B"&&n.decoderConfig.codec!=="mp4a.6b")throw new TypeError('Audio chunk metadata decoder configuration codec string for MP3 must be "mp3", "mp4a.69" or "mp4a.6B".')}else if(n.decoderConfig.codec.startsWith("opus")){if(n.decoderConfig.codec!=="opus")throw new TypeError('Audio chunk metadata decoder configuration codec string for Opus must be "opus".');if(n.decoderConfig.description&&n.decoderConfig.description.byteLength<18)throw new TypeError("Audio chunk metadata decoder configuration description, when specified, is expected to be an Identification Header as specified in Section 5.1 of RFC 7845.")}else if(n.decoderConfig.codec.startsWith("vorbis")){if(n.decoderConfig.codec!=="vorbis")throw new TypeError('Audio chunk metadata decoder configuration codec string for Vorbis must be "vorbis".');if(!n.decoderConfig.description)throw new TypeError("Audio chunk metadata decoder configuration for Vorbis must include a description, which is expected to adhere to the format described in https://www.w3.org/TR/webcodecs-vorbis-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("flac")){if(n.decoderConfig.codec!=="flac")throw new TypeError('Audio chunk metadata decoder configuration codec string for FLAC must be "flac".');if(!n.decoderConfig.description||n.decoderConfig.description.byteLength<42)throw new TypeError("Audio chunk metadata decoder configuration for FLAC must include a description, which is expected to adhere to the format described in https://www.w3.org/TR/webcodecs-flac-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("ac-3")||n.decoderConfig.codec.startsWith("ac3")){if(n.decoderConfig.codec!=="ac-3")throw new TypeError('Audio chunk metadata decoder configuration codec string for AC-3 must be "ac-3".')}else if(n.decoderConfig.codec.startsWith("ec-3")||n.decoderConfig.codec.startsWith("eac3")){if(n.decoderConfig.codec!=="ec-3")throw new TypeError('Audio chunk metadata decoder configuration codec string for EC-3 must be "ec-3".')}else if(n.decoderConfig.codec.startsWith("dts")){if(!Ad.includes(n.decoderConfig.codec))throw new TypeError(`Audio chunk metadata decoder configuration codec string for DTS must be one of the following four-character codes: ${Ad.join(", ")}.`)}else if((n.decoderConfig.codec.startsWith("pcm")||n.decoderConfig.codec.startsWith("ulaw")||n.decoderConfig.codec.startsWith("alaw"))&&!pr.includes(n.decoderConfig.codec))throw new TypeError(`Audio chunk metadata decoder configuration codec string for PCM must be one of the supported PCM codecs (${pr.join(", ")}).`);if(e!==null&&Pg(n.decoderConfig.codec)!==e)throw new TypeError(`Audio chunk metadata decoder configuration codec string '${n.decoderConfig.codec}' does not fit to the track codec '${e}'.`)},Ig=n=>{if(!n)throw new TypeError("Subtitle metadata must be provided.");if(typeof n!="object")throw new TypeError("Subtitle metadata must be an object.");if(!n.config)throw new TypeError("Subtitle metadata must include a config object.");if(typeof n.config!="object")throw new TypeError("Subtitle metadata config must be an object.");if(typeof n.config.description!="string")throw new TypeError("Subtitle metadata config description must be a string.")};var Lg=new Uint8Array(0),mr=class n{constructor(e,t,i,r,s=-1,o,a){if(this.data=e,this.type=t,this.timestamp=i,this.duration=r,this.sequenceNumber=s,e===Lg&&o===void 0)throw new Error("Internal error: byteLength must be explicitly provided when constructing metadata-only packets.");if(o===void 0&&(o=e.byteLength),!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(t!=="key"&&t!=="delta")throw new TypeError('type must be either "key" or "delta".');if(!Number.isFinite(i))throw new TypeError("timestamp must be a number.");if(!Number.isFinite(r)||r<0)throw new TypeError("duration must be a non-negative number.");if(!Number.isFinite(s))throw new TypeError("sequenceNumber must be a number.");if(!Number.isInteger(o)||o<0)throw new TypeError("byteLength must be a non-negative integer.");if(a!==void 0&&(typeof a!="object"||!a))throw new TypeError("sideData, when provided, must be an object.");if(a?.alpha!==void 0&&!(a.alpha instanceof Uint8Array))throw new TypeError("sideData.alpha, when provided, must be a Uint8Array.");if(a?.alphaByteLength!==void 0&&(!Number.isInteger(a.alphaByteLength)||a.alphaByteLength<0))throw new TypeError("sideData.alphaByteLength, when provided, must be a non-negative integer.");this.byteLength=o,this.sideData=a??{},this.sideData.alpha&&this.sideData.alphaByteLength===void 0&&(this.sideData.alphaByteLength=this.sideData.alpha.byteLength)}get isMetadataOnly(){return this.data===Lg}get microsecondTimestamp(){return Math.trunc(xd*this.timestamp)}get microsecondDuration(){return Math.trunc(xd*this.duration)}toEncodedVideoChunk(){if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to a video chunk.");if(typeof EncodedVideoChunk>"u")throw new Error("EncodedVideoChunk is not available in this environment.");return new EncodedVideoChunk({data:this.data,type:this.type,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}alphaToEncodedVideoChunk(e=this.type){if(!this.sideData.alpha)throw new TypeError("This packet does not contain alpha side data.");if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to a video chunk.");if(typeof EncodedVideoChunk>"u")throw new Error("EncodedVideoChunk is not available in this environment.");return new EncodedVideoChunk({data:this.sideData.alpha,type:e,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}toEncodedAudioChunk(){if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to an audio chunk.");if(typeof EncodedAudioChunk>"u")throw new Error("EncodedAudioChunk is not available in this environment.");return new EncodedAudioChunk({data:this.data,type:this.type,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}static fromEncodedChunk(e,t){if(!(e instanceof EncodedVideoChunk||e instanceof EncodedAudioChunk))throw new TypeError("chunk must be an EncodedVideoChunk or EncodedAudioChunk.");let i=new Uint8Array(e.byteLength);return e.copyTo(i),new n(i,e.type,e.timestamp/1e6,(e.duration??0)/1e6,void 0,void 0,t)}clone(e){if(e!==void 0&&(typeof e!="object"||e===null))throw new TypeError("options, when provided, must be an object.");if(e?.data!==void 0&&!(e.data instanceof Uint8Array))throw new TypeError("options.data, when provided, must be a Uint8Array.");if(e?.type!==void 0&&e.type!=="key"&&e.type!=="delta")throw new TypeError('options.type, when provided, must be either "key" or "delta".');if(e?.timestamp!==void 0&&!Number.isFinite(e.timestamp))throw new TypeError("options.timestamp, when provided, must be a number.");if(e?.duration!==void 0&&!Number.isFinite(e.duration))throw new TypeError("options.duration, when provided, must be a number.");if(e?.sequenceNumber!==void 0&&!Number.isFinite(e.sequenceNumber))throw new TypeError("options.sequenceNumber, when provided, must be a number.");if(e?.sideData!==void 0&&(typeof e.sideData!="object"||e.sideData===null))throw new TypeError("options.sideData, when provided, must be an object.");return new n(e?.data??this.data,e?.type??this.type,e?.timestamp??this.timestamp,e?.duration??this.duration,e?.sequenceNumber??this.sequenceNumber,this.byteLength,e?.sideData??this.sideData)}};var Fg=n=>{let t=(n.hasVideo?"video/":n.hasAudio?"audio/":"application/")+(n.isQuickTime?"quicktime":"mp4");if(n.codecStrings.length>0){let i=[...new Set(n.codecStrings)];t+=`; codecs="${i.join(", ")}"`}return t};var xc=8,Md=16;var Ng=7,Bg=9,Td=n=>{let e=n.filePos,t=Dg(n,9),i=new Bn(t);if(i.readBits(12)!==4095||(i.skipBits(1),i.readBits(2)!==0))return null;let o=i.readBits(1),a=i.readBits(2)+1,l=i.readBits(4);if(l===15)return null;i.skipBits(1);let c=i.readBits(3);if(c===0)throw new Error("ADTS frames with channel configuration 0 are not supported.");i.skipBits(1),i.skipBits(1),i.skipBits(1),i.skipBits(1);let u=i.readBits(13);i.skipBits(11);let h=i.readBits(2)+1;if(h!==1)throw new Error("ADTS frames with more than one AAC frame are not supported.");let d=null;return o===1?n.filePos-=2:d=i.readBits(16),{objectType:a,samplingFrequencyIndex:l,channelConfiguration:c,frameLength:u,numberOfAacFrames:h,crcCheck:d,startPos:e}};var Wa=class n{constructor(e,t,i,r,s){this.bytes=e,this.view=t,this.offset=i,this.start=r,this.end=s,this.bufferPos=r-i}static tempFromBytes(e){return new n(e,Ns(e),0,0,e.length)}get length(){return this.end-this.start}get filePos(){return this.offset+this.bufferPos}set filePos(e){this.bufferPos=e-this.offset}get remainingLength(){return Math.max(this.end-this.filePos,0)}skip(e){this.bufferPos+=e}slice(e,t=this.end-e){if(e<this.start||e+t>this.end)throw new RangeError("Slicing outside of original slice.");return new n(this.bytes,this.view,this.offset,e,e+t)}},Lw=(n,e)=>{if(n.filePos<n.start||n.filePos+e>n.end)throw new RangeError(`Tried reading [${n.filePos}, ${n.filePos+e}), but slice is [${n.start}, ${n.end}). This is likely an internal error, please report it alongside the file that caused it.`)},Dg=(n,e)=>{Lw(n,e);let t=n.bytes.subarray(n.bufferPos,n.bufferPos+e);return n.bufferPos+=e,t};var yc=class{constructor(e){this.mutex=new vo,this.trackTimestampInfo=new WeakMap,this.output=e}onTrackClose(e){}validateTimestamp(e,t,i){let r=this.trackTimestampInfo.get(e);if(r){if(i&&(r.maxTimestampBeforeLastKeyPacket=r.maxTimestamp),r.maxTimestampBeforeLastKeyPacket!==null&&t<r.maxTimestampBeforeLastKeyPacket)throw new Error(`Timestamps cannot be smaller than the largest timestamp of the previous GOP (a GOP begins with a key packet and ends right before the next key packet). Got ${t}s, but largest timestamp is ${r.maxTimestampBeforeLastKeyPacket}s.`);r.maxTimestamp=Math.max(r.maxTimestamp,t)}else{if(!i)throw new Error("First packet must be a key packet.");r={maxTimestamp:t,maxTimestampBeforeLastKeyPacket:null},this.trackTimestampInfo.set(e,r)}}};var Ed=/<(?:(\d{2}):)?(\d{2}):(\d{2}).(\d{3})>/g;var kg=n=>{let e=Math.floor(n/36e5),t=Math.floor(n%(3600*1e3)/(60*1e3)),i=Math.floor(n%(60*1e3)/1e3),r=n%1e3;return e.toString().padStart(2,"0")+":"+t.toString().padStart(2,"0")+":"+i.toString().padStart(2,"0")+"."+r.toString().padStart(3,"0")};var Ds=class{constructor(e){this.writer=e,this.helper=new Uint8Array(8),this.helperView=new DataView(this.helper.buffer),this.offsets=new WeakMap}writeU32(e){this.helperView.setUint32(0,e,!1),this.writer.write(this.helper.subarray(0,4))}writeU64(e){this.helperView.setUint32(0,Math.floor(e/2**32),!1),this.helperView.setUint32(4,e,!1),this.writer.write(this.helper.subarray(0,8))}writeAscii(e){for(let t=0;t<e.length;t++)this.helperView.setUint8(t%8,e.charCodeAt(t)),t%8===7&&this.writer.write(this.helper);e.length%8!==0&&this.writer.write(this.helper.subarray(0,e.length%8))}writeBox(e){if(this.offsets.set(e,this.writer.getPos()),e.contents&&!e.children)this.writeBoxHeader(e,e.size??e.contents.byteLength+8),this.writer.write(e.contents);else{let t=this.writer.getPos();if(this.writeBoxHeader(e,0),e.contents&&this.writer.write(e.contents),e.children)for(let s of e.children)s&&this.writeBox(s);let i=this.writer.getPos(),r=e.size??i-t;this.writer.seek(t),this.writeBoxHeader(e,r),this.writer.seek(i)}}writeBoxHeader(e,t){this.writeU32(e.largeSize?1:t),this.writeAscii(e.type),e.largeSize&&this.writeU64(t)}measureBoxHeader(e){return 8+(e.largeSize?8:0)}patchBox(e){let t=this.offsets.get(e);_e(t!==void 0);let i=this.writer.getPos();this.writer.seek(t),this.writeBox(e),this.writer.seek(i)}measureBox(e){if(e.contents&&!e.children)return this.measureBoxHeader(e)+e.contents.byteLength;{let t=this.measureBoxHeader(e);if(e.contents&&(t+=e.contents.byteLength),e.children)for(let i of e.children)i&&(t+=this.measureBox(i));return t}}},ht=new Uint8Array(8),Pi=new DataView(ht.buffer),rn=n=>[(n%256+256)%256],Ze=n=>(Pi.setUint16(0,n,!1),[ht[0],ht[1]]),Id=n=>(Pi.setInt16(0,n,!1),[ht[0],ht[1]]),Vg=n=>(Pi.setUint32(0,n,!1),[ht[1],ht[2],ht[3]]),fe=n=>(Pi.setUint32(0,n,!1),[ht[0],ht[1],ht[2],ht[3]]),yr=n=>(Pi.setInt32(0,n,!1),[ht[0],ht[1],ht[2],ht[3]]),Hi=n=>(Pi.setUint32(0,Math.floor(n/2**32),!1),Pi.setUint32(4,n,!1),[ht[0],ht[1],ht[2],ht[3],ht[4],ht[5],ht[6],ht[7]]),Og=n=>(Pi.setInt32(0,Math.floor(n/2**32),!1),Pi.setUint32(4,n,!1),[ht[0],ht[1],ht[2],ht[3],ht[4],ht[5],ht[6],ht[7]]),Hg=n=>(Pi.setInt16(0,2**8*n,!1),[ht[0],ht[1]]),Ri=n=>(Pi.setInt32(0,2**16*n,!1),[ht[0],ht[1],ht[2],ht[3]]),Cd=n=>(Pi.setInt32(0,2**30*n,!1),[ht[0],ht[1],ht[2],ht[3]]),Rd=(n,e)=>{let t=[],i=n;do{let r=i&127;i>>=7,t.length>0&&(r|=128),t.push(r),e!==void 0&&e--}while(i>0||e);return t.reverse()},kt=(n,e=!1)=>{let t=Array(n.length).fill(null).map((i,r)=>n.charCodeAt(r));return e&&t.push(0),t},Gg=n=>[Ri(n[0]),Ri(n[1]),Cd(n[2]),Ri(n[3]),Ri(n[4]),Cd(n[5]),Ri(n[6]),Ri(n[7]),Cd(n[8])],We=(n,e,t)=>({type:n,contents:e&&new Uint8Array(e.flat(10)),children:t}),At=(n,e,t,i,r)=>We(n,[rn(e),Vg(t),i??[]],r),Wg=n=>n.isQuickTime?We("ftyp",[kt("qt  "),fe(512),kt("qt  ")]):n.fragmented?n.cmaf?We("ftyp",[kt("iso5"),fe(512),kt("iso5"),kt("iso6"),kt("mp41"),kt("cmfc"),kt("dash")]):We("ftyp",[kt("iso5"),fe(512),kt("iso5"),kt("iso6"),kt("mp41")]):We("ftyp",[kt("isom"),fe(512),kt("isom"),n.holdsAvc?kt("avc1"):[],kt("mp41")]),Ld=()=>We("styp",[kt("iso5"),fe(0),kt("iso5"),kt("iso6"),kt("mp41"),kt("cmfc"),kt("dash")]),Fd=(n,e)=>{let t=Math.max(0,n.minWrittenTimestamp),i=Math.max(0,n.maxWrittenEndTimestamp-t);return Number.isFinite(i)||(i=0),At("sidx",1,0,[fe(1),fe(oi),Hi(zt(t,oi)),Hi(0),Ze(0),Ze(1),fe(e&2147483647),fe(zt(i,oi)),fe(0)])},qa=n=>({type:"mdat",largeSize:n}),qg=n=>({type:"free",size:n}),Ao=n=>We("moov",void 0,[Fw(n.creationTime,n.trackDatas),...n.trackDatas.map(e=>Nw(e,n.creationTime)),n.isFragmented?bS(n.trackDatas):null,RS(n)]),Fw=(n,e)=>{let t=Math.max(0,...e.map(o=>Math.max(0,zt(ks(o),oi)+zt(o.startTimestampOffset??0,oi)))),i=Math.max(0,...e.map(o=>o.track.id))+1,r=!ur(n)||!ur(t),s=r?Hi:fe;return At("mvhd",+r,0,[s(n),s(n),fe(oi),s(t),Ri(1),Hg(1),Array(10).fill(0),Gg(md),Array(24).fill(0),fe(i)])},Nw=(n,e)=>{let t=e0(n),i=n.startTimestampOffset!==null&&n.startTimestampOffset!==0;return We("trak",void 0,[Bw(n,e),i?Dw(n):null,kw(n,e),t.name!==void 0?We("udta",void 0,[We("name",[...Ci.encode(t.name)])]):null])},Bw=(n,e)=>{let t=Math.max(0,zt(ks(n),oi)+zt(n.startTimestampOffset??0,oi)),i=!ur(e)||!ur(t),r=i?Hi:fe,s;if(n.type==="video"&&n.track.metadata.transformationMatrix)s=n.track.metadata.transformationMatrix;else if(n.type==="video"){let{rotation:l,flip:c}=n.track.metadata,u=cc(Wm(l??0),qm(c?-1:1,1));s=Gm(u,n.info.width,n.info.height)}else s=md;let o=2;n.track.metadata.disposition?.default!==!1&&(o|=1);let a=n.type==="video"?0:n.type==="audio"?1:n.type==="subtitle"?2:wo(n);return At("tkhd",+i,o,[r(e),r(e),fe(n.track.id),fe(0),r(t),Array(8).fill(0),Ze(0),Ze(a),Hg(n.type==="audio"?1:0),Ze(0),Gg(s),Ri(n.type==="video"?n.info.width:0),Ri(n.type==="video"?n.info.height:0)])},Dw=n=>{let e=n.startTimestampOffset;if(_e(e!==null),e>0){let t=zt(e,oi),i=zt(ks(n),oi),r=!ur(t)||!ur(i),s=r?Hi:fe,o=r?Og:yr;return We("edts",void 0,[At("elst",r?1:0,0,[fe(2),s(t),o(-1),Ri(1),s(i),o(0),Ri(1)])])}else{let t=zt(-e,n.timescale),i=Math.max(0,zt(ks(n),oi)+zt(e,oi)),r=!Xm(t)||!ur(i),s=r?Hi:fe,o=r?Og:yr;return We("edts",void 0,[At("elst",r?1:0,0,[fe(1),s(i),o(t),Ri(1)])])}},kw=(n,e)=>We("mdia",void 0,[Ow(n,e),Nd(!0,Uw[n.type],zw[n.type]),Vw(n)]),Ow=(n,e)=>{let t=zt(ks(n),n.timescale),i=!ur(e)||!ur(t),r=i?Hi:fe;return At("mdhd",+i,0,[r(e),r(e),fe(n.timescale),r(t),Ze(Qg(n.track.metadata.languageCode??Km)),Ze(0)])},Uw={video:"vide",audio:"soun",subtitle:"text"},zw={video:"MediabunnyVideoHandler",audio:"MediabunnySoundHandler",subtitle:"MediabunnyTextHandler"},Nd=(n,e,t,i="\0\0\0\0")=>At("hdlr",0,0,[n?kt("mhlr"):fe(0),kt(e),kt(i),fe(0),fe(0),kt(t,!0)]),Vw=n=>We("minf",void 0,[qw[n.type](),Xw(),Zw(n)]),Hw=()=>At("vmhd",0,1,[Ze(0),Ze(0),Ze(0),Ze(0)]),Gw=()=>At("smhd",0,0,[Ze(0),Ze(0)]),Ww=()=>At("nmhd",0,0),qw={video:Hw,audio:Gw,subtitle:Ww},Xw=()=>We("dinf",void 0,[$w()]),$w=()=>At("dref",0,0,[fe(1)],[Yw()]),Yw=()=>At("url ",0,1),Zw=n=>{let e=n.compositionTimeOffsetTable.length>1||n.compositionTimeOffsetTable.some(t=>t.sampleCompositionTimeOffset!==0);return We("stbl",void 0,[Kw(n),fS(n),e?yS(n):null,e?_S(n):null,mS(n),gS(n),xS(n),pS(n)])},Kw=n=>{let e;if(n.type==="video")e=Jw(FS(n.track.source._codec,n.info.decoderConfig.codec),n);else if(n.type==="audio"){let t=jg(n.track.source._codec,n.info.decoderConfig.codec,n.muxer.isQuickTime);_e(t),e=iS(t,n)}else n.type==="subtitle"&&(e=hS(DS[n.track.source._codec],n));return _e(e),At("stsd",0,0,[fe(1)],[e])},Jw=(n,e)=>We(n,[Array(6).fill(0),Ze(1),Ze(0),Ze(0),Array(12).fill(0),Ze(e.info.width),Ze(e.info.height),fe(4718592),fe(4718592),fe(0),Ze(1),rn(dc.length),kt(dc),Array(31-dc.length).fill(0),Ze(e.info.hasAlphaChannel?32:24),Id(65535)],[NS[e.track.source._codec]?.(e)??null,jw(e),$m(e.info.decoderConfig.colorSpace)?null:Qw(e),Bd(e)]),Bd=n=>n.avgBitrate===0&&n.maxBitrate===0?null:We("btrt",[fe(0),fe(n.maxBitrate),fe(n.avgBitrate)]),jw=n=>n.info.pixelAspectRatio.num===n.info.pixelAspectRatio.den?null:We("pasp",[fe(n.info.pixelAspectRatio.num),fe(n.info.pixelAspectRatio.den)]),Qw=n=>{let e=n.info.decoderConfig.colorSpace;return We("colr",[kt(n.muxer.isQuickTime?"nclc":"nclx"),Ze(e?.primaries!=null?ka[e.primaries]:2),Ze(e?.transfer!=null?Oa[e.transfer]:2),Ze(e?.matrix!=null?Ua[e.matrix]:2),n.muxer.isQuickTime?[]:rn((e?.fullRange?1:0)<<7)])},eS=n=>n.info.decoderConfig&&We("avcC",[...ls(n.info.decoderConfig.description)]),tS=n=>n.info.decoderConfig&&We("hvcC",[...ls(n.info.decoderConfig.description)]),Ug=n=>{if(!n.info.decoderConfig)return null;let e=n.info.decoderConfig,t=e.codec.split("."),i=Number(t[1]),r=Number(t[2]),s=Number(t[3]),o=t[4]?Number(t[4]):1,a=t[8]?Number(t[8]):Number(e.colorSpace?.fullRange??0),l=(s<<4)+(o<<1)+a,c=t[5]?Number(t[5]):e.colorSpace?.primaries?ka[e.colorSpace.primaries]:1,u=t[6]?Number(t[6]):e.colorSpace?.transfer?Oa[e.colorSpace.transfer]:1,h=t[7]?Number(t[7]):e.colorSpace?.matrix?Ua[e.colorSpace.matrix]:1;return At("vpcC",1,0,[rn(i),rn(r),rn(l),rn(c),rn(u),rn(h),Ze(0)])},nS=n=>We("av1C",Cg(n.info.decoderConfig.codec)),iS=(n,e)=>{let t=0,i,r=16,s=pr.includes(e.track.source._codec);if(s){let o=e.track.source._codec,{sampleSize:a}=Nr(o);r=8*a,r>16&&(t=1)}if(e.muxer.isQuickTime&&(t=1),t===0)i=[Array(6).fill(0),Ze(1),Ze(t),Ze(0),fe(0),Ze(e.info.numberOfChannels),Ze(r),Ze(0),Ze(0),Ze(e.info.sampleRate<2**16?e.info.sampleRate:0),Ze(0)];else{let o=s?0:-2;i=[Array(6).fill(0),Ze(1),Ze(t),Ze(0),fe(0),Ze(e.info.numberOfChannels),Ze(Math.min(r,16)),Id(o),Ze(0),Ze(e.info.sampleRate<2**16?e.info.sampleRate:0),Ze(0),s?[fe(1),fe(r/8),fe(e.info.numberOfChannels*r/8)]:[fe(0),fe(0),fe(0)],fe(2)]}return We(n,i,[BS(e.track.source._codec,e.muxer.isQuickTime)?.(e)??null,Bd(e)])},Pd=n=>{let e;switch(n.track.source._codec){case"aac":e=64;break;case"mp3":e=107;break;case"vorbis":e=221;break;default:throw new Error(`Unhandled audio codec: ${n.track.source._codec}`)}let t=[...rn(e),...rn(21),...Vg(0),...fe(n.maxBitrate),...fe(n.avgBitrate)];if(n.info.decoderConfig.description){let i=ls(n.info.decoderConfig.description);t=[...t,...rn(5),...Rd(i.byteLength),...i]}return t=[...Ze(1),...rn(0),...rn(4),...Rd(t.length),...t,...rn(6),...rn(1),...rn(2)],t=[...rn(3),...Rd(t.length),...t],At("esds",0,0,t)},us=n=>We("wave",void 0,[rS(n),sS(n),We("\0\0\0\0")]),rS=n=>We("frma",[kt(jg(n.track.source._codec,n.info.decoderConfig.codec,n.muxer.isQuickTime))]),sS=n=>{let{littleEndian:e}=Nr(n.track.source._codec);return We("enda",[Ze(+e)])},oS=n=>{let e=n.info.numberOfChannels,t=3840,i=n.info.sampleRate,r=0,s=0,o=new Uint8Array(0),a=n.info.decoderConfig?.description;if(a){_e(a.byteLength>=18);let l=ls(a),c=Sg(l);e=c.outputChannelCount,t=c.preSkip,i=c.inputSampleRate,r=c.outputGain,s=c.channelMappingFamily,c.channelMappingTable&&(o=c.channelMappingTable)}return We("dOps",[rn(0),rn(e),Ze(t),fe(i),Id(r),rn(s),...o])},aS=n=>{let e=n.info.decoderConfig?.description;_e(e);let t=ls(e);return At("dfLa",0,0,[...t.subarray(4)])},gr=n=>{let{littleEndian:e,sampleSize:t}=Nr(n.track.source._codec),i=+e;return At("pcmC",0,0,[rn(i),rn(8*t)])},lS=n=>{_e(n.info.primingPacket);let e=Ag(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract AC-3 frame info from the audio packet. Ensure the packets contain valid AC-3 sync frames (as specified in ETSI TS 102 366).");let t=new Uint8Array(3),i=new Bn(t);return i.writeBits(2,e.fscod),i.writeBits(5,e.bsid),i.writeBits(3,e.bsmod),i.writeBits(3,e.acmod),i.writeBits(1,e.lfeon),i.writeBits(5,e.bitRateCode),i.writeBits(5,0),We("dac3",[...t])},cS=n=>{_e(n.info.primingPacket);let e=Mg(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract E-AC-3 frame info from the audio packet. Ensure the packets contain valid E-AC-3 sync frames (as specified in ETSI TS 102 366).");let t=16;for(let o of e.substreams)t+=23,o.numDepSub>0?t+=9:t+=1;let i=Math.ceil(t/8),r=new Uint8Array(i),s=new Bn(r);s.writeBits(13,e.dataRate),s.writeBits(3,e.substreams.length-1);for(let o of e.substreams)s.writeBits(2,o.fscod),s.writeBits(5,o.bsid),s.writeBits(1,0),s.writeBits(1,0),s.writeBits(3,o.bsmod),s.writeBits(3,o.acmod),s.writeBits(1,o.lfeon),s.writeBits(3,0),s.writeBits(4,o.numDepSub),o.numDepSub>0?s.writeBits(9,o.chanLoc):s.writeBits(1,0);return We("dec3",[...r])},uS=n=>{_e(n.info.primingPacket);let e=Tg(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract DTS frame info from the audio packet. Ensure the packets contain valid DTS frames as specified in ETSI TS 102 114.");return We("ddts",[...Eg(e)])},hS=(n,e)=>We(n,[Array(6).fill(0),Ze(1)],[kS[e.track.source._codec](e),Bd(e)]),dS=n=>We("vttC",[...Ci.encode(n.info.config.description)]);var fS=n=>At("stts",0,0,[fe(n.timeToSampleTable.length),n.timeToSampleTable.map(e=>[fe(e.sampleCount),fe(e.sampleDelta)])]),pS=n=>{if(n.samples.every(t=>t.type==="key"))return null;let e=[...n.samples.entries()].filter(([,t])=>t.type==="key");return At("stss",0,0,[fe(e.length),e.map(([t])=>fe(t+1))])},mS=n=>At("stsc",0,0,[fe(n.compactlyCodedChunkTable.length),n.compactlyCodedChunkTable.map(e=>[fe(e.firstChunk),fe(e.samplesPerChunk),fe(1)])]),gS=n=>{if(n.type==="audio"&&n.info.requiresPcmTransformation){let{sampleSize:e}=Nr(n.track.source._codec);return At("stsz",0,0,[fe(e*n.info.numberOfChannels),fe(n.samples.reduce((t,i)=>t+zt(i.duration,n.timescale),0))])}return At("stsz",0,0,[fe(0),fe(n.samples.length),n.samples.map(e=>fe(e.size))])},xS=n=>n.finalizedChunks.length>0&&cr(n.finalizedChunks).offset>=2**32?At("co64",0,0,[fe(n.finalizedChunks.length),n.finalizedChunks.map(e=>Hi(e.offset))]):At("stco",0,0,[fe(n.finalizedChunks.length),n.finalizedChunks.map(e=>fe(e.offset))]),yS=n=>At("ctts",1,0,[fe(n.compositionTimeOffsetTable.length),n.compositionTimeOffsetTable.map(e=>[fe(e.sampleCount),yr(e.sampleCompositionTimeOffset)])]),_S=n=>{let e=1/0,t=-1/0,i=1/0,r=-1/0;_e(n.compositionTimeOffsetTable.length>0),_e(n.samples.length>0);for(let o=0;o<n.compositionTimeOffsetTable.length;o++){let a=n.compositionTimeOffsetTable[o];e=Math.min(e,a.sampleCompositionTimeOffset),t=Math.max(t,a.sampleCompositionTimeOffset)}for(let o=0;o<n.samples.length;o++){let a=n.samples[o];i=Math.min(i,zt(a.timestamp,n.timescale)),r=Math.max(r,zt(a.timestamp+a.duration,n.timescale))}let s=Math.max(-e,0);return r>=2**31?null:At("cslg",0,0,[yr(s),yr(e),yr(t),yr(i),yr(r)])},bS=n=>We("mvex",void 0,n.map(vS)),vS=n=>At("trex",0,0,[fe(n.track.id),fe(1),fe(0),fe(0),fe(0)]),Dd=(n,e)=>We("moof",void 0,[wS(n),...e.map(SS)]),wS=n=>At("mfhd",0,0,[fe(n)]),Xg=n=>{let e=0,t=0,i=0,r=0,s=n.type==="delta";return t|=+s,s?e|=1:e|=2,e<<24|t<<16|i<<8|r},SS=n=>We("traf",void 0,[AS(n),MS(n),TS(n)]),AS=n=>{_e(n.currentChunk);let e=0;e|=8,e|=16,e|=32,e|=131072;let t=n.currentChunk.samples[1]??n.currentChunk.samples[0],i={duration:t.timescaleUnitsToNextSample,size:t.size,flags:Xg(t)};return At("tfhd",0,e,[fe(n.track.id),fe(i.duration),fe(i.size),fe(i.flags)])},MS=n=>(_e(n.currentChunk),At("tfdt",1,0,[Hi(zt(n.currentChunk.startTimestamp,n.timescale))])),TS=n=>{_e(n.currentChunk);let e=n.currentChunk.samples.map(x=>x.timescaleUnitsToNextSample),t=n.currentChunk.samples.map(x=>x.size),i=n.currentChunk.samples.map(Xg),r=n.currentChunk.samples.map(x=>zt(x.timestamp-x.decodeTimestamp,n.timescale)),s=new Set(e),o=new Set(t),a=new Set(i),l=new Set(r),c=a.size===2&&i[0]!==i[1],u=s.size>1,h=o.size>1,d=!c&&a.size>1,f=l.size>1||[...l].some(x=>x!==0),m=0;return m|=1,m|=4*+c,m|=256*+u,m|=512*+h,m|=1024*+d,m|=2048*+f,At("trun",1,m,[fe(n.currentChunk.samples.length),fe(n.currentChunk.offset-n.currentChunk.moofOffset||0),c?fe(i[0]):[],n.currentChunk.samples.map((x,g)=>[u?fe(e[g]):[],h?fe(t[g]):[],d?fe(i[g]):[],f?yr(r[g]):[]])])},$g=n=>We("mfra",void 0,[...n.map(ES),CS()]),ES=n=>At("tfra",1,0,[fe(n.track.id),fe(63),fe(n.finalizedChunks.length),n.finalizedChunks.map(t=>[Hi(zt(t.samples[0].timestamp,n.timescale)),Hi(t.moofOffset),fe(t.trafIndex+1),fe(1),fe(1)])]),CS=()=>At("mfro",0,0,[fe(0)]),Yg=()=>We("vtte"),Zg=(n,e,t,i,r)=>We("vttc",void 0,[r!==null?We("vsid",[yr(r)]):null,t!==null?We("iden",[...Ci.encode(t)]):null,e!==null?We("ctim",[...Ci.encode(kg(e))]):null,i!==null?We("sttg",[...Ci.encode(i)]):null,We("payl",[...Ci.encode(n)])]),Kg=n=>We("vtta",[...Ci.encode(n)]),RS=n=>{let e=[],t=n.format._options.metadataFormat??"auto",i=n.output._metadataTags;if(t==="mdir"||t==="auto"&&!n.isQuickTime){let r=IS(i);r&&e.push(r)}else if(t==="mdta"){let r=LS(i);r&&e.push(r)}else(t==="udta"||t==="auto"&&n.isQuickTime)&&PS(e,n.output._metadataTags);return e.length===0?null:We("udta",void 0,e)},PS=(n,e)=>{for(let{key:t,value:i}of uc(e))switch(t){case"title":n.push(xr("©nam",i));break;case"description":n.push(xr("©des",i));break;case"artist":n.push(xr("©ART",i));break;case"album":n.push(xr("©alb",i));break;case"albumArtist":n.push(xr("albr",i));break;case"genre":n.push(xr("©gen",i));break;case"date":n.push(xr("©day",i.toISOString().slice(0,10)));break;case"comment":n.push(xr("©cmt",i));break;case"lyrics":n.push(xr("©lyr",i));break;case"raw":break;case"discNumber":case"discsTotal":case"trackNumber":case"tracksTotal":case"beatsPerMinute":case"images":break;default:wo(t)}if(e.raw)for(let t in e.raw){let i=e.raw[t];i==null||t.length!==4||n.some(r=>r.type===t)||(typeof i=="string"?n.push(xr(t,i)):i instanceof Uint8Array&&n.push(We(t,Array.from(i))))}},xr=(n,e)=>{let t=Ci.encode(e);return We(n,[Ze(t.length),Ze(Qg("und")),Array.from(t)])},zg={"image/jpeg":13,"image/png":14,"image/bmp":27},Jg=(n,e)=>{let t=[];for(let{key:i,value:r}of uc(n))switch(i){case"title":t.push({key:e?"title":"©nam",value:Vi(r)});break;case"description":t.push({key:e?"description":"©des",value:Vi(r)});break;case"artist":t.push({key:e?"artist":"©ART",value:Vi(r)});break;case"album":t.push({key:e?"album":"©alb",value:Vi(r)});break;case"albumArtist":t.push({key:e?"album_artist":"aART",value:Vi(r)});break;case"comment":t.push({key:e?"comment":"©cmt",value:Vi(r)});break;case"genre":t.push({key:e?"genre":"©gen",value:Vi(r)});break;case"beatsPerMinute":e||t.push({key:"tmpo",value:We("data",[fe(21),fe(0),Ze(r)])});break;case"lyrics":t.push({key:e?"lyrics":"©lyr",value:Vi(r)});break;case"date":t.push({key:e?"date":"©day",value:Vi(r.toISOString().slice(0,10))});break;case"images":for(let s of r)s.kind==="coverFront"&&t.push({key:"covr",value:We("data",[fe(zg[s.mimeType]??0),fe(0),Array.from(s.data)])});break;case"trackNumber":if(e){let s=n.tracksTotal!==void 0?`${r}/${n.tracksTotal}`:r.toString();t.push({key:"track",value:Vi(s)})}else t.push({key:"trkn",value:We("data",[fe(0),fe(0),Ze(0),Ze(r),Ze(n.tracksTotal??0),Ze(0)])});break;case"discNumber":e||t.push({key:"disc",value:We("data",[fe(0),fe(0),Ze(0),Ze(r),Ze(n.discsTotal??0),Ze(0)])});break;case"tracksTotal":case"discsTotal":break;case"raw":break;default:wo(i)}if(n.raw)for(let i in n.raw){let r=n.raw[i];r==null||!e&&i.length!==4||t.some(s=>s.key===i)||(typeof r=="string"?t.push({key:i,value:Vi(r)}):r instanceof Uint8Array?t.push({key:i,value:We("data",[fe(0),fe(0),Array.from(r)])}):r instanceof Va&&t.push({key:i,value:We("data",[fe(zg[r.mimeType]??0),fe(0),Array.from(r.data)])}))}return t},IS=n=>{let e=Jg(n,!1);return e.length===0?null:At("meta",0,0,void 0,[Nd(!1,"mdir","","appl"),We("ilst",void 0,e.map(t=>We(t.key,void 0,[t.value])))])},LS=n=>{let e=Jg(n,!0);return e.length===0?null:We("meta",void 0,[Nd(!1,"mdta",""),At("keys",0,0,[fe(e.length)],e.map(t=>We("mdta",[...Ci.encode(t.key)]))),We("ilst",void 0,e.map((t,i)=>{let r=String.fromCharCode(...fe(i+1));return We(r,void 0,[t.value])}))])},Vi=n=>We("data",[fe(1),fe(0),...Ci.encode(n)]),FS=(n,e)=>{switch(n){case"avc":return e.startsWith("avc3")?"avc3":"avc1";case"hevc":return"hvc1";case"vp8":return"vp08";case"vp9":return"vp09";case"av1":return"av01";case"prores":return e}},NS={avc:eS,hevc:tS,vp8:Ug,vp9:Ug,av1:nS,prores:null},jg=(n,e,t)=>{switch(n){case"aac":return"mp4a";case"mp3":return"mp4a";case"opus":return"Opus";case"vorbis":return"mp4a";case"flac":return"fLaC";case"ulaw":return"ulaw";case"alaw":return"alaw";case"pcm-u8":return"raw ";case"pcm-s8":return"sowt";case"ac3":return"ac-3";case"eac3":return"ec-3";case"dts":return e}if(t)switch(n){case"pcm-s16":return"sowt";case"pcm-s16be":return"twos";case"pcm-s24":return"in24";case"pcm-s24be":return"in24";case"pcm-s32":return"in32";case"pcm-s32be":return"in32";case"pcm-f32":return"fl32";case"pcm-f32be":return"fl32";case"pcm-f64":return"fl64";case"pcm-f64be":return"fl64"}else switch(n){case"pcm-s16":return"ipcm";case"pcm-s16be":return"ipcm";case"pcm-s24":return"ipcm";case"pcm-s24be":return"ipcm";case"pcm-s32":return"ipcm";case"pcm-s32be":return"ipcm";case"pcm-f32":return"fpcm";case"pcm-f32be":return"fpcm";case"pcm-f64":return"fpcm";case"pcm-f64be":return"fpcm"}},BS=(n,e)=>{switch(n){case"aac":return Pd;case"mp3":return Pd;case"opus":return oS;case"vorbis":return Pd;case"flac":return aS;case"ac3":return lS;case"eac3":return cS;case"dts":return uS}if(e)switch(n){case"pcm-s24":return us;case"pcm-s24be":return us;case"pcm-s32":return us;case"pcm-s32be":return us;case"pcm-f32":return us;case"pcm-f32be":return us;case"pcm-f64":return us;case"pcm-f64be":return us}else switch(n){case"pcm-s16":return gr;case"pcm-s16be":return gr;case"pcm-s24":return gr;case"pcm-s24be":return gr;case"pcm-s32":return gr;case"pcm-s32be":return gr;case"pcm-f32":return gr;case"pcm-f32be":return gr;case"pcm-f64":return gr;case"pcm-f64be":return gr}return null},DS={webvtt:"wvtt"},kS={webvtt:dS},Qg=n=>{_e(n.length===3);let e=0;for(let t=0;t<3;t++)e<<=5,e+=n.charCodeAt(t)-96;return e};var Os=class{constructor(e,t){if(this.finalized=!1,this.started=!1,this.pos=0,this.trackedWrites=null,this.trackedStart=-1,this.trackedEnd=-1,e._writerAcquired)throw new Error("Can't have multiple Writers for the same Target.");this.target=e,e._setMonotonicity(t),e._writerAcquired=!0}start(){_e(!this.started),this.target._start(),this.started=!0}write(e){_e(this.started&&!this.finalized),this.maybeTrackWrites(e),this.target._write(e,this.pos),this.pos+=e.byteLength}seek(e){this.pos=e}getPos(){return this.pos}async flush(){return _e(this.started&&!this.finalized),this.target._flush()}async finalize(){_e(this.started&&!this.finalized),await this.target._finalize(),this.finalized=!0}maybeTrackWrites(e){if(!this.trackedWrites)return;let t=this.getPos();if(t<this.trackedStart){if(t+e.byteLength<=this.trackedStart)return;e=e.subarray(this.trackedStart-t),t=0}let i=t+e.byteLength-this.trackedStart,r=this.trackedWrites.byteLength;for(;r<i;)r*=2;if(r!==this.trackedWrites.byteLength){let s=new Uint8Array(r);s.set(this.trackedWrites,0),this.trackedWrites=s}this.trackedWrites.set(e,t-this.trackedStart),this.trackedEnd=Math.max(this.trackedEnd,t+e.byteLength)}startTrackingWrites(){this.trackedWrites=new Uint8Array(2**10),this.trackedStart=this.getPos(),this.trackedEnd=this.trackedStart}stopTrackingWrites(){if(!this.trackedWrites)throw new Error("Internal error: Can't get tracked writes since nothing was tracked.");let t={data:this.trackedWrites.subarray(0,this.trackedEnd-this.trackedStart),start:this.trackedStart,end:this.trackedEnd};return this.trackedWrites=null,t}};var gi=class extends as{constructor(){super(...arguments),this._writerAcquired=!1,this._monotonicity=null,this.onwrite=null}_setMonotonicity(e){this._monotonicity!==!1&&(this._monotonicity=e)}_dispatchWrite(e,t){this.onwrite?.(e,t),this._emit("write",{start:e,end:t})}slice(e){if(!Number.isInteger(e)||e<0)throw new TypeError("offset must be a non-negative integer.");return new _c(this,e)}},kd=2**16,Od=2**32,Br=class extends gi{constructor(e={}){if(super(),this.buffer=null,this._maxPos=0,!e||typeof e!="object")throw new TypeError("BufferTarget options, when provided, must be an object.");if(e.onFinalize!==void 0&&typeof e.onFinalize!="function")throw new TypeError("options.onFinalize, when provided, must be a function.");if(this._options=e,this._supportsResize="resize"in new ArrayBuffer(0),this._supportsResize)try{this._buffer=new ArrayBuffer(kd,{maxByteLength:Od})}catch{this._buffer=new ArrayBuffer(kd),this._supportsResize=!1}else this._buffer=new ArrayBuffer(kd);this._bytes=new Uint8Array(this._buffer)}_ensureSize(e){let t=this._buffer.byteLength;for(;t<e;)t*=2;if(t!==this._buffer.byteLength){if(t>Od)throw new Error(`ArrayBuffer exceeded maximum size of ${Od} bytes. Please consider using another target.`);if(this._supportsResize)this._buffer.resize(t);else{let i=new ArrayBuffer(t),r=new Uint8Array(i);r.set(this._bytes,0),this._buffer=i,this._bytes=r}}}_start(){}_write(e,t){this._ensureSize(t+e.byteLength),this._bytes.set(e,t),this._maxPos=Math.max(this._maxPos,t+e.byteLength),this._dispatchWrite(t,t+e.byteLength)}async _flush(){}async _finalize(){this.buffer=this._buffer.slice(0,this._maxPos),this._options.onFinalize&&await this._options.onFinalize(this.buffer),this._emit("finalized")}async _close(){}_getSlice(e,t){return this._bytes.slice(e,t)}},qI=2**24;var _c=class extends gi{constructor(e,t){super(),this._baseTarget=e,this._offset=t}_start(){}_write(e,t){this._baseTarget._write(e,this._offset+t),this._dispatchWrite(t,t+e.byteLength)}_flush(){return this._baseTarget._flush()}async _finalize(){this._emit("finalized")}async _close(){}_setMonotonicity(e){super._setMonotonicity(e),this._baseTarget._setMonotonicity(e)}},Us=class{constructor(e,t){if(this.rootPath=e,this.getTarget=t,typeof e!="string")throw new TypeError("rootPath must be a string.");if(typeof t!="function")throw new TypeError("getTarget must be a function.")}};var oi=57600,OS=2082844800,e0=n=>{let e={},t=n.track;return t.metadata.name!==void 0&&(e.name=t.metadata.name),e},zt=(n,e,t=!0)=>{let i=n*e;return t?Math.round(i):i},ks=n=>{if(n.samples.length===0)return 0;let e=1/0,t=-1/0;for(let i=0;i<n.samples.length;i++){let r=n.samples[i];r.timestamp<e&&(e=r.timestamp),r.timestamp+r.duration>t&&(t=r.timestamp+r.duration)}return e===1/0?0:t-e},bc=class extends yc{constructor(e,t){super(e),this.writer=null,this.boxWriter=null,this.initWriter=null,this.initBoxWriter=null,this.auxTarget=new Br,this.auxWriter=new Os(this.auxTarget,!1),this.auxBoxWriter=new Ds(this.auxWriter),this.mdat=null,this.ftypSize=null,this.trackDatas=[],this.allTracksKnown=Ym(),this.creationTime=Math.floor(Date.now()/1e3)+OS,this.finalizedChunks=[],this.wroteFragmentedHeader=!1,this.nextFragmentNumber=1,this.maxWrittenTimestamp=-1/0,this.minWrittenTimestamp=1/0,this.maxWrittenEndTimestamp=-1/0,this.segmentHeaderSize=null,this.format=t,this.formatOptions={...t._options},this.isQuickTime=t instanceof To,this.isCmaf=t instanceof Mo,this.minimumFragmentDuration=this.formatOptions.minimumFragmentDuration??(t instanceof Mo?1/0:1),this.auxWriter.start()}async start(){let e=await this.mutex.acquire();if(this.isCmaf?(this.fastStart="fragmented",this.isFragmented=!0):(this.writer=await this.output._getRootWriter(i=>this.formatOptions.fastStart!==void 0?this.formatOptions.fastStart==="fragmented":i instanceof Br),this.boxWriter=new Ds(this.writer),this.fastStart=this.formatOptions.fastStart??(this.writer.target instanceof Br?"in-memory":!1),this.isFragmented=this.fastStart==="fragmented"),this.isCmaf){if(!this.output._hasInitTarget())throw new Error("CMAF outputs require the initTarget field in OutputOptions to be set; the init segment will be written to it.");let i=await this.output._getInitTarget(),r=new Os(i,!0);r.start(),this.initWriter=r,this.initBoxWriter=new Ds(r)}let t=this.output.tracks.some(i=>i.isVideoTrack()&&i.source._codec==="avc");{let i=this.initBoxWriter??this.boxWriter;if(_e(i),this.formatOptions.onFtyp&&i.writer.startTrackingWrites(),i.writeBox(Wg({isQuickTime:this.isQuickTime,holdsAvc:t,fragmented:this.isFragmented,cmaf:this.isCmaf})),this.formatOptions.onFtyp){let{data:r,start:s}=i.writer.stopTrackingWrites();this.formatOptions.onFtyp(r,s)}this.ftypSize=i.writer.getPos(),this.isCmaf&&await this.initWriter.flush()}if(this.fastStart!=="in-memory")if(this.fastStart==="reserve"){for(let i of this.output.tracks)if(i.metadata.maximumPacketCount===void 0)throw new Error("All tracks must specify maximumPacketCount in their metadata when using fastStart: 'reserve'.")}else this.isFragmented||(_e(this.writer),_e(this.boxWriter),this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat=qa(!0),this.boxWriter.writeBox(this.mdat));await this.writer?.flush();for(let i of this.output.tracks)i.isVideoTrack()&&i.metadata.decoderConfig?this.getVideoTrackData(i,i.metadata.primingPacket??null,{decoderConfig:i.metadata.decoderConfig}):i.isAudioTrack()&&i.metadata.decoderConfig&&this.getAudioTrackData(i,i.metadata.primingPacket??null,{decoderConfig:i.metadata.decoderConfig});e()}allTracksAreKnown(){for(let e of this.output.tracks)if(!e.source._closed&&!this.trackDatas.some(t=>t.track===e))return!1;return!0}async getMimeType(){await this.allTracksKnown.promise;let e=this.trackDatas.map(t=>t.type==="video"||t.type==="audio"?t.info.decoderConfig.codec:{webvtt:"wvtt"}[t.track.source._codec]);return Fg({isQuickTime:this.isQuickTime,hasVideo:this.trackDatas.some(t=>t.type==="video"),hasAudio:this.trackDatas.some(t=>t.type==="audio"),codecStrings:e})}getVideoTrackData(e,t,i){let r=this.trackDatas.find(f=>f.track===e);if(r)return r;mc(i,e.source._codec),_e(i),_e(i.decoderConfig);let s={...i.decoderConfig};_e(s.codedWidth!==void 0),_e(s.codedHeight!==void 0);let o=!1;if(e.source._codec==="avc"&&!s.description){if(!t)throw new Error("No AVC description provided; you must therefore provide a priming packet.");let f=yg(t.data);if(!f)throw new Error("Couldn't extract an AVCDecoderConfigurationRecord from the AVC packet. Make sure the packets are in Annex B format (as specified in ITU-T-REC-H.264) when not providing a description, or provide a description (must be an AVCDecoderConfigurationRecord as specified in ISO 14496-15) and ensure the packets are in AVCC format.");s.description=_g(f),o=!0}else if(e.source._codec==="hevc"&&!s.description){if(!t)throw new Error("No HEVC description provided; you must therefore provide a priming packet.");let f=vg(t.data);if(!f)throw new Error("Couldn't extract an HEVCDecoderConfigurationRecord from the HEVC packet. Make sure the packets are in Annex B format (as specified in ITU-T-REC-H.265) when not providing a description, or provide a description (must be an HEVCDecoderConfigurationRecord as specified in ISO 14496-15) and ensure the packets are in HEVC format.");s.description=wg(f),o=!0}let a=Qm(1/(e.metadata.frameRate??oi),1e6).den,l=s.displayAspectWidth,c=s.displayAspectHeight,u=l===void 0||c===void 0?{num:1,den:1}:tg({num:l*s.codedHeight,den:c*s.codedWidth}),h=s.codec==="ap4h"||s.codec==="ap4x",d={muxer:this,track:e,type:"video",info:{width:s.codedWidth,height:s.codedHeight,pixelAspectRatio:u,decoderConfig:s,requiresAnnexBTransformation:o,hasAlphaChannel:h},timescale:a,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0};return this.trackDatas.push(d),this.trackDatas.sort((f,m)=>f.track.id-m.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),d}getAudioTrackData(e,t,i){let r=this.trackDatas.find(l=>l.track===e);if(r)return r;gc(i,e.source._codec),_e(i),_e(i.decoderConfig);let s={...i.decoderConfig},o=!1;if(e.source._codec==="aac"&&!s.description){if(!t)throw new Error("No AAC description provided; you must therefore provide a priming packet.");let l=Td(Wa.tempFromBytes(t.data));if(!l)throw new Error("Couldn't parse ADTS header from the AAC packet. Make sure the packets are in ADTS format (as specified in ISO 13818-7) when not providing a description, or provide a description (must be an AudioSpecificConfig as specified in ISO 14496-3) and ensure the packets are raw AAC data.");let c=bd[l.samplingFrequencyIndex],u=vd[l.channelConfiguration];if(c===void 0||u===void 0)throw new Error("Invalid ADTS frame header.");s.description=ag({objectType:l.objectType,outputSampleRate:c,outputNumberOfChannels:u}),o=!0}if(!t){if(e.source._codec==="ac3"||e.source._codec==="eac3")throw new Error("AC-3/E-AC-3 require a priming packet.");if(e.source._codec==="dts")throw new Error("DTS requires a priming packet.")}let a={muxer:this,track:e,type:"audio",info:{numberOfChannels:i.decoderConfig.numberOfChannels,sampleRate:i.decoderConfig.sampleRate,decoderConfig:s,requiresPcmTransformation:!this.isFragmented&&pr.includes(e.source._codec),expectedNextPcmPacketTimestamp:null,requiresAdtsStripping:o,primingPacket:t},timescale:s.sampleRate,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0};return this.trackDatas.push(a),this.trackDatas.sort((l,c)=>l.track.id-c.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),a}getSubtitleTrackData(e,t){let i=this.trackDatas.find(s=>s.track===e);if(i)return i;Ig(t),_e(t),_e(t.config);let r={muxer:this,track:e,type:"subtitle",info:{config:t.config},timescale:1e3,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0,lastCueEndTimestamp:null,cueQueue:[],nextSourceId:0,cueToSourceId:new WeakMap};return this.trackDatas.push(r),this.trackDatas.sort((s,o)=>s.track.id-o.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),r}async addEncodedVideoPacket(e,t,i){let r=await this.mutex.acquire();try{let s=this.getVideoTrackData(e,t,i),o=t.data;if(s.info.requiresAnnexBTransformation){let l=[...fc(o)].map(c=>o.subarray(c.offset,c.offset+c.length));if(l.length===0)throw new Error("Failed to transform packet data. Make sure all packets are provided in Annex B format, as specified in ITU-T-REC-H.264 and ITU-T-REC-H.265.");o=xg(l,4)}this.validateTimestamp(s.track,t.timestamp,t.type==="key");let a=this.createSampleForTrack(s,o,t.timestamp,t.duration,t.type);await this.registerSample(s,a)}finally{r()}}async addEncodedAudioPacket(e,t,i){let r=await this.mutex.acquire();try{let s=this.getAudioTrackData(e,t,i),o=t.data;if(s.info.requiresAdtsStripping){let u=Td(Wa.tempFromBytes(o));if(!u)throw new Error("Expected ADTS frame, didn't get one.");let h=u.crcCheck===null?Ng:Bg;o=o.subarray(h)}this.validateTimestamp(s.track,t.timestamp,t.type==="key");let a=t.timestamp,l=t.duration;if(s.info.requiresPcmTransformation){let h=Nr(s.info.decoderConfig.codec).sampleSize*s.info.numberOfChannels;if(l=o.byteLength/h/s.info.sampleRate,s.info.expectedNextPcmPacketTimestamp!==null){let d=a-s.info.expectedNextPcmPacketTimestamp;if(d<.01)a=s.info.expectedNextPcmPacketTimestamp;else{let f=await this.padWithSilence(s,s.info.expectedNextPcmPacketTimestamp,d);a=s.info.expectedNextPcmPacketTimestamp+f}}s.info.expectedNextPcmPacketTimestamp=a+l}let c=this.createSampleForTrack(s,o,a,l,t.type);await this.registerSample(s,c)}finally{r()}}async padWithSilence(e,t,i){let r=zt(i,e.timescale);if(i=r/e.timescale,r>0){let{sampleSize:s,silentValue:o}=Nr(e.info.decoderConfig.codec),a=r*e.info.numberOfChannels,l=new Uint8Array(s*a).fill(o),c=this.createSampleForTrack(e,new Uint8Array(l.buffer),t,i,"key");await this.registerSample(e,c)}return i}async addSubtitleCue(e,t,i){let r=await this.mutex.acquire();try{let s=this.getSubtitleTrackData(e,i);this.validateTimestamp(s.track,t.timestamp,!0),e.source._codec==="webvtt"&&(s.cueQueue.push(t),await this.processWebVTTCues(s,t.timestamp))}finally{r()}}async processWebVTTCues(e,t){for(;e.cueQueue.length>0;){e.lastCueEndTimestamp??=Math.min(0,e.cueQueue[0].timestamp);let i=new Set([]);for(let c of e.cueQueue)_e(c.timestamp<=t),_e(e.lastCueEndTimestamp<=c.timestamp+c.duration),i.add(Math.max(c.timestamp,e.lastCueEndTimestamp)),i.add(c.timestamp+c.duration);let r=[...i].sort((c,u)=>c-u),s=r[0],o=r[1]??s;if(t<o)break;if(e.lastCueEndTimestamp<s){this.auxWriter.seek(0);let c=Yg();this.auxBoxWriter.writeBox(c);let u=this.auxTarget._getSlice(0,this.auxWriter.getPos()),h=this.createSampleForTrack(e,u,e.lastCueEndTimestamp,s-e.lastCueEndTimestamp,"key");await this.registerSample(e,h),e.lastCueEndTimestamp=s}this.auxWriter.seek(0);for(let c=0;c<e.cueQueue.length;c++){let u=e.cueQueue[c];if(u.timestamp>=o)break;Ed.lastIndex=0;let h=Ed.test(u.text),d=u.timestamp+u.duration,f=e.cueToSourceId.get(u);if(f===void 0&&o<d&&(f=e.nextSourceId++,e.cueToSourceId.set(u,f)),u.notes){let x=Kg(u.notes);this.auxBoxWriter.writeBox(x)}let m=Zg(u.text,h?s:null,u.identifier??null,u.settings??null,f??null);this.auxBoxWriter.writeBox(m),d===o&&e.cueQueue.splice(c--,1)}let a=this.auxTarget._getSlice(0,this.auxWriter.getPos()),l=this.createSampleForTrack(e,a,s,o-s,"key");await this.registerSample(e,l),e.lastCueEndTimestamp=o}}createSampleForTrack(e,t,i,r,s){return{timestamp:i,decodeTimestamp:i,duration:r,data:t,size:t.byteLength,type:s,timescaleUnitsToNextSample:zt(r,e.timescale)}}processTimestamps(e,t){if(e.timestampProcessingQueue.length===0)return;if(e.type==="audio"&&e.info.requiresPcmTransformation){_e(!this.isFragmented),e.startTimestampOffset??=e.timestampProcessingQueue[0].timestamp;let r=0;for(let s=0;s<e.timestampProcessingQueue.length;s++){let o=e.timestampProcessingQueue[s],a=zt(o.duration,e.timescale);r+=a}if(e.timeToSampleTable.length===0)e.timeToSampleTable.push({sampleCount:r,sampleDelta:1});else{let s=cr(e.timeToSampleTable);s.sampleCount+=r}e.timestampProcessingQueue.length=0;return}let i=e.timestampProcessingQueue.map(r=>r.timestamp).sort((r,s)=>r-s);this.isFragmented?e.startTimestampOffset??=Math.min(i[0],0):e.startTimestampOffset??=i[0];for(let r=0;r<e.timestampProcessingQueue.length;r++){let s=e.timestampProcessingQueue[r];s.decodeTimestamp=i[r];let o=zt(s.timestamp-s.decodeTimestamp,e.timescale),a=zt(s.duration,e.timescale);if(e.lastTimescaleUnits!==null){_e(e.lastSample);let l=zt(s.decodeTimestamp,e.timescale,!1),c=Math.round(l-e.lastTimescaleUnits);if(_e(c>=0),e.lastTimescaleUnits+=c,e.lastSample.timescaleUnitsToNextSample=c,!this.isFragmented){let u=cr(e.timeToSampleTable);if(_e(u),u.sampleCount===1){u.sampleDelta=c;let d=e.timeToSampleTable[e.timeToSampleTable.length-2];d&&d.sampleDelta===c&&(d.sampleCount++,e.timeToSampleTable.pop(),u=d)}else u.sampleDelta!==c&&(u.sampleCount--,e.timeToSampleTable.push(u={sampleCount:1,sampleDelta:c}));u.sampleDelta===a?u.sampleCount++:e.timeToSampleTable.push({sampleCount:1,sampleDelta:a});let h=cr(e.compositionTimeOffsetTable);_e(h),h.sampleCompositionTimeOffset===o?h.sampleCount++:e.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:o})}}else e.lastTimescaleUnits=zt(s.decodeTimestamp,e.timescale,!1),this.isFragmented||(e.timeToSampleTable.push({sampleCount:1,sampleDelta:a}),e.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:o}));e.lastSample=s}if(e.timestampProcessingQueue.length=0,_e(e.lastSample),_e(e.lastTimescaleUnits!==null),t!==void 0&&e.lastSample.timescaleUnitsToNextSample===0){_e(t.type==="key");let r=zt(t.timestamp,e.timescale,!1),s=Math.round(r-e.lastTimescaleUnits);e.lastSample.timescaleUnitsToNextSample=s}}async registerSample(e,t){t.type==="key"&&this.processTimestamps(e,t),e.timestampProcessingQueue.push(t),this.isFragmented?(e.sampleQueue.push(t),await this.interleaveSamples()):this.fastStart==="reserve"?await this.registerSampleFastStartReserve(e,t):await this.addSampleToTrack(e,t)}async addSampleToTrack(e,t){if(!this.isFragmented&&(e.samples.push(t),this.fastStart==="reserve")){let r=e.track.metadata.maximumPacketCount;if(_e(r!==void 0),e.samples.length>r)throw new Error(`Track #${e.track.id} has already reached the maximum packet count (${r}). Either add less packets or increase the maximum packet count.`)}let i=!1;if(!e.currentChunk)i=!0;else{e.currentChunk.startTimestamp=Math.min(e.currentChunk.startTimestamp,t.timestamp);let r=t.timestamp-e.currentChunk.startTimestamp;if(this.isFragmented){let s=this.trackDatas.every(o=>{if(e===o)return t.type==="key";let a=o.sampleQueue[0];return a?a.type==="key":o.closed});r>=this.minimumFragmentDuration&&s&&t.timestamp>this.maxWrittenTimestamp&&(i=!0,await this.finalizeFragment())}else i=r>=.5}i&&(e.currentChunk&&await this.finalizeCurrentChunk(e),e.currentChunk={startTimestamp:t.timestamp,samples:[],offset:null,moofOffset:null,trafIndex:null}),_e(e.currentChunk),e.currentChunk.samples.push(t),this.isFragmented&&(this.maxWrittenTimestamp=Math.max(this.maxWrittenTimestamp,t.timestamp),this.maxWrittenEndTimestamp=Math.max(this.maxWrittenEndTimestamp,t.timestamp+t.duration),this.minWrittenTimestamp=Math.min(this.minWrittenTimestamp,t.timestamp))}async finalizeCurrentChunk(e){if(_e(!this.isFragmented),_e(this.writer),!e.currentChunk)return;e.finalizedChunks.push(e.currentChunk),this.finalizedChunks.push(e.currentChunk);let t=e.currentChunk.samples.length;if(e.type==="audio"&&e.info.requiresPcmTransformation&&(t=e.currentChunk.samples.reduce((i,r)=>i+zt(r.duration,e.timescale),0)),(e.compactlyCodedChunkTable.length===0||cr(e.compactlyCodedChunkTable).samplesPerChunk!==t)&&e.compactlyCodedChunkTable.push({firstChunk:e.finalizedChunks.length,samplesPerChunk:t}),this.fastStart==="in-memory"){e.currentChunk.offset=0;return}e.currentChunk.offset=this.writer.getPos();for(let i of e.currentChunk.samples)_e(i.data),this.writer.write(i.data),i.data=null;await this.writer.flush()}async interleaveSamples(e=!1){if(_e(this.isFragmented),!(!e&&!this.allTracksAreKnown()))e:for(;;){let t=null,i=1/0;for(let s of this.trackDatas){if(!e&&s.sampleQueue.length===0&&!s.closed)break e;s.sampleQueue.length>0&&s.sampleQueue[0].timestamp<i&&(t=s,i=s.sampleQueue[0].timestamp)}if(!t)break;let r=t.sampleQueue.shift();await this.addSampleToTrack(t,r)}}async finalizeFragment(e=!this.isCmaf){if(_e(this.isFragmented),!this.wroteFragmentedHeader){this.wroteFragmentedHeader=!0;let f=this.initBoxWriter??this.boxWriter;_e(f),this.formatOptions.onMoov&&f.writer.startTrackingWrites(),this.ensureOneEnabledTrack();let m=Ao(this);if(f.writeBox(m),this.formatOptions.onMoov){let{data:x,start:g}=f.writer.stopTrackingWrites();this.formatOptions.onMoov(x,g)}if(this.isCmaf){_e(this.initWriter),await this.initWriter.flush(),await this.initWriter.finalize(),this.writer=await this.output._getRootWriter(!0),this.boxWriter=new Ds(this.writer);let x=this.boxWriter.measureBox(Ld()),g=this.boxWriter.measureBox(Fd(this,0));this.segmentHeaderSize=x+g,this.writer.seek(this.segmentHeaderSize)}}_e(this.writer),_e(this.boxWriter);let t=this.trackDatas.filter(f=>f.currentChunk);if(t.length===0){e&&await this.writer.flush();return}let i=this.nextFragmentNumber++,r=Dd(i,t),s=this.writer.getPos(),o=s+this.boxWriter.measureBox(r),a=o+xc,l=1/0;for(let f=0;f<t.length;f++){let m=t[f];_e(m.currentChunk),_e(m.startTimestampOffset!==null),m.currentChunk.offset=a,m.currentChunk.moofOffset=s,m.currentChunk.trafIndex=f,m.currentChunk.startTimestamp-=m.startTimestampOffset;for(let x of m.currentChunk.samples)a+=x.size,x.timestamp-=m.startTimestampOffset,x.decodeTimestamp-=m.startTimestampOffset;l=Math.min(l,m.currentChunk.startTimestamp)}let c=a-o,u=c>=2**32;if(u)for(let f of t)f.currentChunk.offset+=Md-xc;this.formatOptions.onMoof&&this.writer.startTrackingWrites();let h=Dd(i,t);if(this.boxWriter.writeBox(h),this.formatOptions.onMoof){let{data:f,start:m}=this.writer.stopTrackingWrites();this.formatOptions.onMoof(f,m,l)}_e(this.writer.getPos()===o),this.formatOptions.onMdat&&this.writer.startTrackingWrites();let d=qa(u);d.size=c,this.boxWriter.writeBox(d),this.writer.seek(o+(u?Md:xc));for(let f of t)for(let m of f.currentChunk.samples)this.writer.write(m.data),m.data=null;if(this.formatOptions.onMdat){let{data:f,start:m}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(f,m)}for(let f of t)f.finalizedChunks.push(f.currentChunk),this.finalizedChunks.push(f.currentChunk),f.currentChunk=null;e&&await this.writer.flush()}async registerSampleFastStartReserve(e,t){this.allTracksAreKnown()?(this.mdat||await this.createFastStartReserveMdat(),await this.addSampleToTrack(e,t)):e.sampleQueue.push(t)}async createFastStartReserveMdat(){_e(this.writer),_e(this.boxWriter),this.ensureOneEnabledTrack();let e=Ao(this),i=this.boxWriter.measureBox(e)+this.computeSampleTableSizeUpperBound()+4096;_e(this.ftypSize!==null),this.writer.seek(this.ftypSize+i),this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat=qa(!0),this.boxWriter.writeBox(this.mdat);for(let r of this.trackDatas){for(let s of r.sampleQueue)await this.addSampleToTrack(r,s);r.sampleQueue.length=0}}computeSampleTableSizeUpperBound(){_e(this.fastStart==="reserve");let e=0;for(let t of this.trackDatas){let i=t.track.metadata.maximumPacketCount;_e(i!==void 0),e+=8*Math.ceil(2/3*i),e+=4*i,e+=8*Math.ceil(2/3*i),e+=12*Math.ceil(2/3*i),e+=4*i,e+=8*i}return e}async onTrackClose(e){let t=await this.mutex.acquire(),i=this.trackDatas.find(r=>r.track===e);i&&(i.closed=!0,i.type==="subtitle"&&e.source._codec==="webvtt"&&await this.processWebVTTCues(i,1/0),this.processTimestamps(i)),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),this.isFragmented&&await this.interleaveSamples(),t()}ensureOneEnabledTrack(){for(let e of["video","audio","subtitle"]){let t=this.trackDatas.filter(r=>r.type===e);if(t.length===0)continue;if(!t.some(r=>r.track.metadata.disposition?.default!==!1)){let r=t[0];r.track.metadata.disposition={...r.track.metadata.disposition,default:!0}}}}async forceFragmentFinalization(){_e(this.isFragmented);let e=await this.mutex.acquire();try{for(let t of this.trackDatas)t.type==="subtitle"&&t.track.source._codec==="webvtt"&&await this.processWebVTTCues(t,1/0),this.processTimestamps(t);await this.interleaveSamples(!0),await this.finalizeFragment()}finally{e()}}async finalize(){let e=await this.mutex.acquire();this.allTracksKnown.resolve(),this.ensureOneEnabledTrack(),!this.mdat&&this.fastStart==="reserve"&&await this.createFastStartReserveMdat();for(let t of this.trackDatas)t.closed=!0,t.type==="subtitle"&&t.track.source._codec==="webvtt"&&await this.processWebVTTCues(t,1/0),this.processTimestamps(t);if(this.isFragmented)await this.interleaveSamples(!0),await this.finalizeFragment(!1);else for(let t of this.trackDatas){await this.finalizeCurrentChunk(t);let i=ks(t);if(i>0){let a=0;for(let l of t.samples)a+=l.size;t.avgBitrate=Math.round(8*a/i)}else t.avgBitrate=0;let r=0,s=0,o=0;for(let a=0;a<t.samples.length;a++){let l=t.samples[a];for(s+=l.size;l.decodeTimestamp-t.samples[r].decodeTimestamp>=1;)s-=t.samples[r].size,r++;o=Math.max(o,s)}if(t.maxBitrate=8*o,t.startTimestampOffset!==null)for(let a=0;a<t.samples.length;a++){let l=t.samples[a];l.timestamp-=t.startTimestampOffset,l.decodeTimestamp-=t.startTimestampOffset}}if(_e(this.writer),_e(this.boxWriter),this.fastStart==="in-memory"){this.mdat=qa(!1);let t;for(let r=0;r<2;r++){let s=Ao(this),o=this.boxWriter.measureBox(s);t=this.boxWriter.measureBox(this.mdat);let a=this.writer.getPos()+o+t;for(let l of this.finalizedChunks){l.offset=a;for(let{data:c}of l.samples)_e(c),a+=c.byteLength,t+=c.byteLength}if(a<2**32)break;t>=2**32&&(this.mdat.largeSize=!0)}this.formatOptions.onMoov&&this.writer.startTrackingWrites();let i=Ao(this);if(this.boxWriter.writeBox(i),this.formatOptions.onMoov){let{data:r,start:s}=this.writer.stopTrackingWrites();this.formatOptions.onMoov(r,s)}this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat.size=t,this.boxWriter.writeBox(this.mdat);for(let r of this.finalizedChunks)for(let s of r.samples)_e(s.data),this.writer.write(s.data),s.data=null;if(this.formatOptions.onMdat){let{data:r,start:s}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(r,s)}}else if(this.isFragmented)if(this.isCmaf){let t=this.segmentHeaderSize!==null?this.writer.getPos()-this.segmentHeaderSize:0;this.writer.seek(0),this.boxWriter.writeBox(Ld()),this.boxWriter.writeBox(Fd(this,t))}else{let t=this.writer.getPos(),i=$g(this.trackDatas);this.boxWriter.writeBox(i);let r=this.writer.getPos()-t;this.writer.seek(this.writer.getPos()-4),this.boxWriter.writeU32(r)}else{_e(this.mdat);let t=this.boxWriter.offsets.get(this.mdat);_e(t!==void 0);let i=this.writer.getPos()-t;if(this.mdat.size=i,this.mdat.largeSize=i>=2**32,this.boxWriter.patchBox(this.mdat),this.formatOptions.onMdat){let{data:s,start:o}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(s,o)}let r=Ao(this);if(this.fastStart==="reserve"){_e(this.ftypSize!==null),this.writer.seek(this.ftypSize),this.formatOptions.onMoov&&this.writer.startTrackingWrites(),this.boxWriter.writeBox(r);let s=this.boxWriter.offsets.get(this.mdat)-this.writer.getPos();this.boxWriter.writeBox(qg(s))}else this.formatOptions.onMoov&&this.writer.startTrackingWrites(),this.boxWriter.writeBox(r);if(this.formatOptions.onMoov){let{data:s,start:o}=this.writer.stopTrackingWrites();this.formatOptions.onMoov(s,o)}}e()}};var Eo=class{constructor(){this._connectedTrack=null,this._closingPromise=null,this._closed=!1,this._nominalBitrate=null}_ensureValidAdd(){if(!this._connectedTrack)throw new Error("Source is not connected to an output track.");if(this._connectedTrack.output.state==="canceled")throw new Error("Output has been canceled.");if(this._connectedTrack.output.state==="finalizing"||this._connectedTrack.output.state==="finalized")throw new Error("Output has been finalized.");if(this._connectedTrack.output.state==="pending")throw new Error("Output has not started.");if(this._closed)throw new Error("Source is closed.")}async _start(){}async _flushAndClose(e){}close(){if(this._closingPromise)return;let e=this._connectedTrack;if(!e)throw new Error("Cannot call close without connecting the source to an output track.");if(e.output.state==="pending")throw new Error("Cannot call close before output has been started.");this._closingPromise=(async()=>{await this._flushAndClose(!1),this._closed=!0,!(e.output.state==="finalizing"||e.output.state==="finalized")&&e.output._muxer.onTrackClose(e)})()}async _flushOrWaitForOngoingClose(e){return this._closingPromise??=(async()=>{await this._flushAndClose(e),this._closed=!0})()}},Co=class extends Eo{constructor(e){if(super(),!cs.includes(e))throw new TypeError(`Invalid video codec '${e}'. Must be one of: ${cs.join(", ")}.`);this._codec=e}},US=(n,e)=>{if(n.metadata.hasOnlyKeyPackets&&e.type!=="key")throw new Error("Cannot add non-key packets to a hasOnlyKeyPackets video track.")},Xa=class extends Co{constructor(e){super(e)}add(e,t){if(!(e instanceof mr))throw new TypeError("packet must be an EncodedPacket.");if(e.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be added.");if(t!==void 0&&(!t||typeof t!="object"))throw new TypeError("meta, when provided, must be an object.");return this._ensureValidAdd(),US(this._connectedTrack,e),this._connectedTrack.output._muxer.addEncodedVideoPacket(this._connectedTrack,e,t)}};var $a=class extends Eo{constructor(e){if(super(),!So.includes(e))throw new TypeError(`Invalid audio codec '${e}'. Must be one of: ${So.join(", ")}.`);this._codec=e}};var Ya=class extends Eo{constructor(e){if(super(),!Bs.includes(e))throw new TypeError(`Invalid subtitle codec '${e}'. Must be one of: ${Bs.join(", ")}.`);this._codec=e}};var Ro=class{get supportsVideoRotationMetadata(){return this.supportsVideoTransformationMetadata}getSupportedVideoCodecs(){return this.getSupportedCodecs().filter(e=>cs.includes(e))}getSupportedAudioCodecs(){return this.getSupportedCodecs().filter(e=>So.includes(e))}getSupportedSubtitleCodecs(){return this.getSupportedCodecs().filter(e=>Bs.includes(e))}_codecUnsupportedHint(e){return""}_isFragmentedIsobmff(){return!1}},Po=class extends Ro{constructor(e={}){if(!e||typeof e!="object")throw new TypeError("options must be an object.");if(e.fastStart!==void 0&&![!1,"in-memory","reserve","fragmented"].includes(e.fastStart))throw new TypeError("options.fastStart, when provided, must be false, 'in-memory', 'reserve', or 'fragmented'.");if(e.minimumFragmentDuration!==void 0&&(!eg(e.minimumFragmentDuration)||e.minimumFragmentDuration<0))throw new TypeError("options.minimumFragmentDuration, when provided, must be a non-negative number.");if(e.onFtyp!==void 0&&typeof e.onFtyp!="function")throw new TypeError("options.onFtyp, when provided, must be a function.");if(e.onMoov!==void 0&&typeof e.onMoov!="function")throw new TypeError("options.onMoov, when provided, must be a function.");if(e.onMdat!==void 0&&typeof e.onMdat!="function")throw new TypeError("options.onMdat, when provided, must be a function.");if(e.onMoof!==void 0&&typeof e.onMoof!="function")throw new TypeError("options.onMoof, when provided, must be a function.");if(e.metadataFormat!==void 0&&!["mdir","mdta","udta","auto"].includes(e.metadataFormat))throw new TypeError("options.metadataFormat, when provided, must be either 'auto', 'mdir', 'mdta', or 'udta'.");super(),this._options=e}getSupportedTrackCounts(){return{video:{min:0,max:4294967295},audio:{min:0,max:4294967295},subtitle:{min:0,max:4294967295},total:{min:0,max:4294967295}}}get supportsVideoTransformationMetadata(){return!0}get supportsTimestampedMediaData(){return!0}get negativeTimestampSupport(){return"full"}_createMuxer(e){return new bc(e,this)}_isFragmentedIsobmff(){return this._options.fastStart==="fragmented"}},Io=class extends Po{constructor(e){super(e)}get _name(){return"MP4"}get fileExtension(){return".mp4"}get mimeType(){return"video/mp4"}getSupportedCodecs(){return[...cs,...pc,"pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be",...Bs]}_codecUnsupportedHint(e){return new To().getSupportedCodecs().includes(e)?" Switching to MOV will grant support for this codec.":""}},Mo=class extends Po{constructor(e){super(e)}get _name(){return"CMAF"}get fileExtension(){return".m4s"}get mimeType(){return"video/mp4"}getSupportedCodecs(){return[...cs,...pc,"pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be",...Bs]}},To=class extends Po{constructor(e){super(e)}get _name(){return"MOV"}get fileExtension(){return".mov"}get mimeType(){return"video/quicktime"}getSupportedCodecs(){return[...cs,...So]}_codecUnsupportedHint(e){return new Io().getSupportedCodecs().includes(e)?" Switching to MP4 will grant support for this codec.":""}};var t0=["video","audio","subtitle"],Lo=class n{constructor(e,t,i,r,s){this.id=e,this.output=t,this.type=i,this.source=r,this.metadata=s}isVideoTrack(){return this.type==="video"}isAudioTrack(){return this.type==="audio"}isSubtitleTrack(){return this.type==="subtitle"}canBePairedWith(e){if(!(e instanceof n))throw new TypeError("other must be an OutputTrack.");if(this===e)return!1;let t=hc(this.metadata.group),i=hc(e.metadata.group);for(let r of t)if(this.type!==e.type&&i.some(a=>r===a)||i.some(a=>r._pairedGroups.has(a)))return!0;return!1}},vc=class extends Lo{constructor(e,t,i,r){super(e,t,"video",i,r)}},wc=class extends Lo{constructor(e,t,i,r){super(e,t,"audio",i,r)}},Sc=class extends Lo{constructor(e,t,i,r){super(e,t,"subtitle",i,r)}},Fo=class n{constructor(){this._pairedGroups=new Set}pairWith(e){if(!(e instanceof n))throw new TypeError("other must be an OutputTrackGroup.");if(this===e)throw new TypeError("Cannot pair a group with itself.");this._pairedGroups.add(e),e._pairedGroups.add(this)}},Ud=n=>{if(!n||typeof n!="object")throw new TypeError("metadata must be an object.");if(n.languageCode!==void 0&&!jm(n.languageCode))throw new TypeError("metadata.languageCode, when provided, must be a three-letter, ISO 639-2/T language code.");if(n.name!==void 0&&typeof n.name!="string")throw new TypeError("metadata.name, when provided, must be a string.");if(n.disposition!==void 0&&rg(n.disposition),n.maximumPacketCount!==void 0&&(!Number.isInteger(n.maximumPacketCount)||n.maximumPacketCount<0))throw new TypeError("metadata.maximumPacketCount, when provided, must be a non-negative integer.");if(n.bitrate!==void 0&&(!Number.isFinite(n.bitrate)||n.bitrate<0))throw new TypeError("metadata.bitrate, when provided, must be a non-negative number.");if(n.averageBitrate!==void 0&&(!Number.isFinite(n.averageBitrate)||n.averageBitrate<0))throw new TypeError("metadata.averageBitrate, when provided, must be a non-negative number.");if(n.group!==void 0&&!(n.group instanceof Fo)&&(!Array.isArray(n.group)||n.group.some(e=>!(e instanceof Fo))))throw new TypeError("metadata.group, when provided, must be an OutputTrackGroup instance or an array of OutputTrackGroup instances.")},Za=class extends as{get target(){let e="Output.target cannot be used when using PathedTarget with an async callback. Use the 'target' event instead.";if(this._rootTargetPromise)throw new TypeError(e);let t=this._getRootTarget();if(za(t))throw new TypeError(e);return t}constructor(e){if(super(),this.state="pending",this.defaultTrackGroup=new Fo,this.tracks=[],this._onFinalize=null,this._unfinalizedTargets=new Set,this._rootWriterPromise=null,this._startPromise=null,this._cancelPromise=null,this._finalizePromise=null,this._mutex=new vo,this._metadataTags={},this._rootTarget=null,this._rootTargetPromise=null,this._firstMediaStreamTimestamp=null,!e||typeof e!="object")throw new TypeError("options must be an object.");if(!(e.format instanceof Ro))throw new TypeError("options.format must be an OutputFormat.");if(!(e.target instanceof gi||e.target instanceof Us))throw new TypeError("options.target must be a Target or a PathedTarget.");if(e.target instanceof gi&&this._rememberTarget(e.target),e.initTarget!==void 0&&!(e.initTarget instanceof gi)&&typeof e.initTarget!="function")throw new Error("options.initTarget, when provided, must be a Target or a function that returns or resolves to a Target.");if(e.onFinalize!==void 0&&typeof e.onFinalize!="function")throw new TypeError("options.onFinalize, when provided, must be a function.");this.format=e.format,this._target=e.target,this._onFinalize=e.onFinalize??null,this._initTarget=e.initTarget??null,this._initTarget instanceof gi&&this._rememberTarget(this._initTarget),this._muxer=e.format._createMuxer(this)}_getTargetValidated(e){_e(this._target instanceof Us);let t=this._target.getTarget(e),i=r=>{if(!(r instanceof gi))throw new TypeError("getTarget must return a Target.");return r};return za(t)?t.then(i):i(t)}async _getTarget(e){_e(this._target instanceof Us);let t=await this._getTargetValidated(e);return this._emit("target",{target:t,request:e,isRoot:e.isRoot}),this.state==="canceled"?await t._close():this._rememberTarget(t),t}_rememberTarget(e){this._unfinalizedTargets.add(e),e.on("finalized",()=>this._unfinalizedTargets.delete(e),{once:!0})}async _getInitTarget(){if(_e(this._initTarget!==null),this._initTarget instanceof gi)return this._initTarget;let e=await this._initTarget();return this.state==="canceled"?await e._close():this._rememberTarget(e),e}_hasInitTarget(){return this._initTarget!==null}_getRootTarget(){if(this._rootTarget)return this._rootTarget;if(this._rootTargetPromise)return this._rootTargetPromise;if(this._target instanceof gi)return this._emit("target",{target:this._target,request:null,isRoot:!0}),this._rootTarget=this._target,this._target;let e={path:this._target.rootPath,isRoot:!0,mimeType:this.format.mimeType},t=this._getTargetValidated(e),i=r=>(this.state==="canceled"?r._close():this._rememberTarget(r),this._emit("target",{target:r,request:e,isRoot:!0}),this._rootTarget=r,r);return za(t)?this._rootTargetPromise=t.then(i):i(t)}_getRootWriter(e){return this._rootWriterPromise??=(async()=>{let t=await this._getRootTarget(),i=new Os(t,typeof e=="boolean"?e:e(t));return i.start(),i})()}addVideoTrack(e,t={}){if(!(e instanceof Co))throw new TypeError("source must be a VideoSource.");if(Ud(t),t.rotation!==void 0&&![0,90,180,270].includes(t.rotation))throw new TypeError(`Invalid video rotation: ${t.rotation}. Has to be 0, 90, 180 or 270.`);if(t.flip!==void 0&&typeof t.flip!="boolean")throw new TypeError("metadata.flip, when provided, must be a boolean.");if(t.transformationMatrix!==void 0&&(!Array.isArray(t.transformationMatrix)||t.transformationMatrix.length!==9||!t.transformationMatrix.every(r=>Number.isFinite(r))))throw new TypeError("metadata.transformationMatrix, when provided, must be an array of 9 finite numbers.");if(t.frameRate!==void 0&&(!Number.isFinite(t.frameRate)||t.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${t.frameRate}. Must be a positive number.`);if(t.hasOnlyKeyPackets!==void 0&&typeof t.hasOnlyKeyPackets!="boolean")throw new TypeError("metadata.hasOnlyKeyPackets, when provided, must be a boolean.");if(t.canBeTransparent!==void 0&&typeof t.canBeTransparent!="boolean")throw new TypeError("metadata.canBeTransparent, when provided, must be a boolean.");if(t.decoderConfig!==void 0&&mc({decoderConfig:t.decoderConfig},e._codec),t.primingPacket!==void 0){if(!(t.primingPacket instanceof mr))throw new TypeError("metadata.primingPacket, when provided, must be an EncodedPacket.");if(t.decoderConfig===void 0)throw new TypeError("metadata.primingPacket can only be provided alongside metadata.decoderConfig.")}let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new vc(this.tracks.length+1,this,e,i))}addAudioTrack(e,t={}){if(!(e instanceof $a))throw new TypeError("source must be an AudioSource.");if(Ud(t),t.decoderConfig!==void 0&&gc({decoderConfig:t.decoderConfig},e._codec),t.primingPacket!==void 0){if(!(t.primingPacket instanceof mr))throw new TypeError("metadata.primingPacket, when provided, must be an EncodedPacket.");if(t.decoderConfig===void 0)throw new TypeError("metadata.primingPacket can only be provided alongside metadata.decoderConfig.")}let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new wc(this.tracks.length+1,this,e,i))}addSubtitleTrack(e,t={}){if(!(e instanceof Ya))throw new TypeError("source must be a SubtitleSource.");Ud(t);let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new Sc(this.tracks.length+1,this,e,i))}setMetadataTags(e){if(ig(e),this.state!=="pending")throw new Error("Cannot set metadata tags after output has been started or canceled.");this._metadataTags=e}_addTrack(e){if(this.state!=="pending")throw new Error("Cannot add track after output has been started or canceled.");if(e.source._connectedTrack)throw new Error("Source is already used for a track.");let t=this.format.getSupportedTrackCounts(),i=this.tracks.reduce((o,a)=>o+(a.type===e.type?1:0),0),r=t[e.type].max;if(i===r)throw new Error(r===0?`${this.format._name} does not support ${e.type} tracks.`:`${this.format._name} does not support more than ${r} ${e.type} track${r===1?"":"s"}.`);let s=t.total.max;if(this.tracks.length===s)throw new Error(`${this.format._name} does not support more than ${s} tracks${s===1?"":"s"} in total.`);if(e.isVideoTrack()){let o=this.format.getSupportedVideoCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support video tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported video codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}else if(e.isAudioTrack()){let o=this.format.getSupportedAudioCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support audio tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported audio codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}else if(e.isSubtitleTrack()){let o=this.format.getSupportedSubtitleCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support subtitle tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported subtitle codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}return this.tracks.push(e),e.source._connectedTrack=e,e}hasEnoughTracks(){let e=this.format.getSupportedTrackCounts();for(let i of t0){let r=this.tracks.reduce((o,a)=>o+(a.type===i?1:0),0),s=e[i].min;if(r<s)return!1}let t=e.total.min;return!(this.tracks.length<t)}async start(){let e=this.format.getSupportedTrackCounts();for(let i of t0){let r=this.tracks.reduce((o,a)=>o+(a.type===i?1:0),0),s=e[i].min;if(r<s)throw new Error(s===e[i].max?`${this.format._name} requires exactly ${s} ${i} track${s===1?"":"s"}.`:`${this.format._name} requires at least ${s} ${i} track${s===1?"":"s"}.`)}let t=e.total.min;if(this.tracks.length<t)throw new Error(t===e.total.max?`${this.format._name} requires exactly ${t} track${t===1?"":"s"}.`:`${this.format._name} requires at least ${t} track${t===1?"":"s"}.`);if(this.state==="canceled")throw new Error("Output has been canceled.");return this._startPromise?(ei._warn("Output has already been started."),this._startPromise):this._startPromise=(async()=>{this.state="started";let i=this._mutex.acquire();try{await this._muxer.start();let r=this.tracks.map(s=>s.source._start());await Promise.all(r)}finally{(await i)()}})()}getMimeType(){return this._muxer.getMimeType()}async cancel(){if(this.state==="canceled")return this._cancelPromise??void 0;if(this.state==="finalizing"||this.state==="finalized"){this.state==="finalized"&&ei._warn("Output has already been finalized.");return}return this._cancelPromise=(async()=>{this.state="canceled";let e=await this._mutex.acquire();try{let t=this.tracks.map(i=>i.source._flushOrWaitForOngoingClose(!0));await Promise.all(t),await Promise.all([...this._unfinalizedTargets].map(i=>i._close())),this._unfinalizedTargets.clear()}finally{e()}})()}async finalize(){if(this.state==="pending")throw new Error("Cannot finalize before starting.");if(this.state==="canceled")throw new Error("Cannot finalize after canceling.");return this._finalizePromise?(ei._warn("Output has already been finalized."),this._finalizePromise):this._finalizePromise=(async()=>{this.state="finalizing";let e=await this._mutex.acquire();try{let t=this.tracks.map(i=>i.source._flushOrWaitForOngoingClose(!1));if(await Promise.all(t),await this._muxer.finalize(),this._rootWriterPromise){let i=await this._rootWriterPromise;i.finalized||(await i.flush(),await i.finalize())}this._onFinalize&&await this._onFinalize(),this.state="finalized"}catch(t){throw this.state="canceled",t}finally{await Promise.all([...this._unfinalizedTargets].map(t=>t._close().catch(()=>{}))),this._unfinalizedTargets.clear(),e()}})()}};var n0=Symbol.for("mediabunny loaded");globalThis[n0]&&ei._error(`[WARNING]
Mediabunny was loaded twice. This will likely cause Mediabunny not to work correctly. Check if multiple dependencies are importing different versions of Mediabunny, or if something is being bundled incorrectly.`);globalThis[n0]=!0;var No=30,zS=[{codec:"avc1.640028",kind:"avc"},{codec:"avc1.42001f",kind:"avc"},{codec:"vp09.00.41.08",kind:"vp9"},{codec:"av01.0.08M.08",kind:"av1"}];async function r0(n){if(typeof VideoEncoder>"u")return{message:"This browser cannot write films; a picture and a 3D file can be had."};let[e,t]=[i0(n.width),i0(n.height)],i=await VS(e,t);if(i===null)return{message:"This browser has no encoder for films of this size."};let r=new Br,s=new Za({format:new Io,target:r}),o=new Xa(i.kind);s.addVideoTrack(o,{frameRate:No}),await s.start();let a=null,l=Promise.resolve(),c=new VideoEncoder({output:(h,d)=>{l=l.then(()=>o.add(mr.fromEncodedChunk(h),d))},error:h=>a=h});c.configure(i.config);let u=Math.max(1,Math.round(n.duration*No));for(let h=0;h<u&&a===null;h++){if(!n.wanted())return c.close(),await s.cancel(),{message:"The film was stopped."};let d=new VideoFrame(await n.picture(h/No),{timestamp:Math.round(h*1e6/No),duration:Math.round(1e6/No)});for(c.encode(d,{keyFrame:h%60===0}),d.close(),n.progress((h+1)/u);c.encodeQueueSize>4;)await new Promise(f=>setTimeout(f,4))}return a===null&&await c.flush(),await l,a!==null?{message:`The browser's encoder failed: ${a.message}.`}:(await s.finalize(),new Blob([r.buffer??new ArrayBuffer(0)],{type:"video/mp4"}))}async function VS(n,e){for(let{codec:t,kind:i}of zS){let r={codec:t,width:n,height:e,bitrate:8*n*e,framerate:No};if(i==="avc"&&(r.avc={format:"avc"}),(await VideoEncoder.isConfigSupported(r).catch(()=>null))?.supported===!0)return{kind:i,config:r}}return null}function i0(n){return 2*Math.max(1,Math.round(n/2))}var HS=5126,GS=5125,zd=class{views=[];accessors=[];parts=[];length=0;add(e,t,i){let r={SCALAR:1,VEC3:3,VEC4:4}[t],s={bufferView:this.views.length,componentType:e instanceof Float32Array?HS:GS,count:e.length/r,type:t};if(i){let o=l=>Array.from({length:s.count},(c,u)=>e[u*r+l]??0),a=Array.from({length:r},(l,c)=>o(c));s.min=a.map(l=>l.reduce((c,u)=>Math.min(c,u),1/0)),s.max=a.map(l=>l.reduce((c,u)=>Math.max(c,u),-1/0))}return this.views.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength}),this.parts.push(e),this.length+=e.byteLength,this.accessors.push(s)-1}bytes(){let e=new Uint8Array(this.length),t=0;for(let i of this.parts)e.set(new Uint8Array(i.buffer,i.byteOffset,i.byteLength),t),t+=i.byteLength;return e}};function s0(n,e,t){let i=new zd,r=i.add(e.positions,"VEC3",!0),s=i.add(e.normals,"VEC3",!1),o=[0,1].map(m=>{let x=[];e.tones.forEach((p,b)=>{p===m&&x.push(e.indices[3*b]??0,e.indices[3*b+1]??0,e.indices[3*b+2]??0)});let g=i.add(Uint32Array.from(x),"SCALAR",!1);return{attributes:{POSITION:r,NORMAL:s},indices:g,material:m}}),a=t.times.length,l=i.add(Float32Array.from(t.times),"SCALAR",!0),c=t.columns.centre,u=i.add(Float32Array.from({length:3*a},(m,x)=>c?.[x]??0),"VEC3",!1),h=i.add(WS(t,a),"VEC4",!1),d=e.hollow?bn.shell:bn.body,f={asset:{version:"2.0",generator:"chaplygin"},scene:0,scenes:[{name:n,nodes:[1]}],nodes:[{name:"body",mesh:0},{name:"space",children:[0],rotation:[-Math.SQRT1_2,0,0,Math.SQRT1_2]}],meshes:[{name:"body",primitives:o}],materials:d.map(m=>({pbrMetallicRoughness:{baseColorFactor:[...ac(m).map(qS),1],metallicFactor:0,roughnessFactor:.55},doubleSided:!0})),animations:[{name:"motion",samplers:[{input:l,output:u,interpolation:"LINEAR"},{input:l,output:h,interpolation:"LINEAR"}],channels:[{sampler:0,target:{node:0,path:"translation"}},{sampler:1,target:{node:0,path:"rotation"}}]}],accessors:i.accessors,bufferViews:i.views,buffers:[{byteLength:i.length}]};return XS(JSON.stringify(f),i.bytes())}function WS(n,e){let t=n.columns.attitude,i=new Float32Array(4*e),r=[0,0,0,1];for(let s=0;s<e;s++){let[o=1,a=0,l=0,c=0]=[0,1,2,3].map(h=>t?.[4*s+h]??(h===0?1:0)),u=a*(r[0]??0)+l*(r[1]??0)+c*(r[2]??0)+o*(r[3]??0)<0?-1:1;r=[u*a,u*l,u*c,u*o],i.set(r,4*s)}return i}function qS(n){let e=n/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4}function XS(n,e){let t=new TextEncoder().encode(n),i=4*Math.ceil(t.length/4),r=4*Math.ceil(e.length/4),s=20+i+8+r,o=new Uint8Array(s),a=new DataView(o.buffer);return[1179937895,2,s,i,1313821514].forEach((c,u)=>a.setUint32(4*u,c,!0)),o.fill(32,20,20+i),o.set(t,20),a.setUint32(20+i,r,!0),a.setUint32(24+i,5130562,!0),o.set(e,28+i),o}var $S="⁰¹²³⁴⁵⁶⁷⁸⁹";function bt(n,e=4){if(Number.isNaN(n))return"–";if(!Number.isFinite(n))return n>0?"∞":"−∞";if(n===0)return"0";let t=Math.abs(n);if(t>=.001&&t<1e5)return o0(n.toPrecision(e)).replace("-","−");let[i="",r="0"]=n.toExponential(e-1).split("e"),s=o0(i).replace("-","−"),o=Number(r),a=o<0?"⁻":"",l=[...String(Math.abs(o))].map(c=>$S[Number(c)]).join("");return`${s} × 10${a}${l}`}function o0(n){let e=n.includes("e")?String(Number(n)):n;return e.includes(".")?e.replace(/\.?0+$/,""):e}function Ac(n){let e=10**Math.floor(Math.log10(n));return([5,2,1].find(i=>i*e<=n*(1+1e-9))??1)*e}function Dr(n,e=.05){let t=1/0,i=-1/0;for(let o of n)Number.isFinite(o)&&(o<t&&(t=o),o>i&&(i=o));if(t>i)return[-1,1];let r=Math.max(Math.abs(t),Math.abs(i));if(i-t<=1e-9*r||i===t){let o=r>0?.1*r:1;return[t-o,i+o]}let s=e*(i-t);return[t-s,i+s]}function Bo(n,e,t){let i=(e-n)/Math.max(1,t);if(!(i>0))return[n];let r=Ac(i);for(;(e-n)/r>1.35*t;)r=Ac(2.5*r);let s=Math.ceil(n/r-1e-9),o=Math.floor(e/r+1e-9);return Array.from({length:o-s+1},(a,l)=>Number(((s+l)*r).toPrecision(12)))}var YS="'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif",Ja=640,zn={left:70,right:16,top:30,height:190,gap:44};function a0(n,e,t){let i=zn.top+t.length*(zn.height+zn.gap)+8,r=e[e.length-1]??1,s=a=>zn.left+a/(r||1)*(Ja-zn.left-zn.right),o=t.map(({label:a,unit:l,components:c},u)=>{let h=zn.top+u*(zn.height+zn.gap),[d,f]=Dr(c.flatMap(({values:b})=>Array.from(b))),m=b=>h+(f-b)/(f-d)*zn.height,x=c.map(({values:b},E)=>{let v=["","7 3","2 3"][E%3]??"",C=bn.components[E]??bn.series[E%bn.series.length]??bn.ink;return`<path d="${ZS(e,b,s,m)}" fill="none" stroke="${C}" stroke-width="1.3"${v?` stroke-dasharray="${v}"`:""}/>`}),g=c.map(({label:b},E)=>{let v=zn.left+E*84,C=bn.components[E]??bn.series[E%bn.series.length]??bn.ink,T=["","7 3","2 3"][E%3]??"";return`<path d="M${v} ${h-10}h22" stroke="${C}" stroke-width="1.6"${T?` stroke-dasharray="${T}"`:""}/>${Ka(v+28,h-6,b,"start",!0)}`});return u0(s,m,[0,r],[d,f],h,zn.height,u===t.length-1?"t  (s)":"",`${a}${l?`  (${l})`:""}`)+x.join("")+(c.length>1?g.join(""):"")});return c0(n,Ja,i,o.join(""))}function l0(n,e,t,i){let s=l=>zn.left+(l-e.range[0])/(e.range[1]-e.range[0])*(Ja-zn.left-zn.right),o=l=>16+(t.range[1]-l)/(t.range[1]-t.range[0])*480,a=i.map(({x:l,y:c,colour:u})=>{let h=[];for(let d=0;d<l.length;d++){let[f,m]=[s(l[d]??NaN),o(c[d]??NaN)];f>=zn.left&&f<=Ja-zn.right&&m>=16&&m<=496&&h.push(`M${f.toFixed(1)} ${m.toFixed(1)}h0`)}return`<path d="${h.join("")}" stroke="${u}" stroke-width="1.4" stroke-linecap="round"/>`});return c0(n,Ja,546,u0(s,o,e.range,t.range,16,480,e.label,t.label)+a.join(""))}function c0(n,e,t,i){return`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${e} ${t}" width="${e}" height="${t}" role="img"><title>${h0(n)}</title><rect width="100%" height="100%" fill="#fff"/>${i}</svg>
`}function u0(n,e,t,i,r,s,o,a){let[l,c,u]=[n(t[0]),n(t[1]),r+s],h=[`<path d="M${l} ${r}V${u}H${c}" fill="none" stroke="${bn.quiet}" stroke-width="0.8"/>`];for(let f of Bo(t[0],t[1],7)){let m=n(f).toFixed(1);h.push(`<path d="M${m} ${u}v4" stroke="${bn.quiet}" stroke-width="0.8"/>`,Ka(Number(m),u+17,bt(f,6),"middle"))}for(let f of Bo(i[0],i[1],Math.max(3,s/50))){let m=e(f);h.push(`<path d="M${l} ${m.toFixed(1)}h-4" stroke="${bn.quiet}" stroke-width="0.8"/>`,Ka(l-7,m+4,bt(f,6),"end"))}o&&h.push(Ka((l+c)/2,u+36,o,"middle",!0));let d=r+s/2;return h.push(`<g transform="rotate(-90 16 ${d})">${Ka(16,d+4,a,"middle",!0)}</g>`),h.join("")}function Ka(n,e,t,i,r=!1){return`<text x="${n.toFixed(1)}" y="${e.toFixed(1)}" font-family="${YS.replaceAll('"',"'")}" font-size="${r?14:12.5}"${r?' font-style="italic"':""} text-anchor="${i}" fill="${bn.ink}">${h0(t)}</text>`}function ZS(n,e,t,i){let r=[],s=!1;for(let o=0;o<n.length;o++){let a=e[o]??NaN;Number.isFinite(a)?(r.push(`${s?"L":"M"}${t(n[o]??0).toFixed(1)} ${i(a).toFixed(1)}`),s=!0):s=!1}return r.join("")}function h0(n){return n.replaceAll("&","&amp;").replaceAll("<","&lt;").replaceAll(">","&gt;").replaceAll('"',"&quot;")}var KS={body:["_1","_2","_3"],space:["_x","_y","_z"],quaternion:["_w","_x","_y","_z"]};function d0(n,e){let t=e.filter(({name:s})=>n.columns[s]!==void 0),i=["time (s)"];for(let{name:s,width:o,axes:a,unit:l}of t){let c=KS[a];for(let u=0;u<o;u++){let h=o===1?"":c?.[u]??`_${u+1}`;i.push(`${s}${h}${l==="1"?"":` (${l})`}`)}}let r=[i.map(p0).join(",")];return n.times.forEach((s,o)=>{let a=[String(s)];for(let{name:l,width:c}of t){let u=n.columns[l];for(let h=0;h<c;h++){let d=u?.[o*c+h]??NaN;a.push(Number.isFinite(d)?String(d):"")}}r.push(a.join(","))}),`${r.join(`
`)}
`}function f0(n,e){let t=[["orbit",...n].map(p0).join(",")];for(let{x:i,y:r,number:s}of e)i.forEach((o,a)=>t.push(`${s+1},${o},${r[a]??""}`));return`${t.join(`
`)}
`}function p0(n){return/[",\n]/.test(n)?`"${n.replaceAll('"','""')}"`:n}var JS=1280;function g0(n){let{lab:e,scene:t,plots:i,section:r,address:s}=n,{model:o}=e,a=o.name||"motion",l=X("div",{class:"lab-downloads"}),c=(h,d,f)=>{let m=X("button",{type:"button",class:"lab-button"},h);return m.addEventListener("click",()=>{Promise.resolve(f()).catch(x=>e.say(x instanceof Error?x.message:String(x),!0))}),l.append(X("div",{},m,X("span",{class:"lab-hint"},d))),m},u=(h,d,f="text/plain")=>Ls(h,new Blob([d],{type:`${f};charset=utf-8`}));return c("Copy the address","of this motion: parameters, start and instant are in it",async()=>{let h=s();await navigator.clipboard.writeText(h).then(()=>e.say("The address is on the clipboard."),()=>e.say(h))}),o.experiment!==""&&c("Experiment","a file that the program runs (TOML)",()=>u(`${a}.toml`,Do(e))),c("Data","every sample of this motion (CSV)",()=>u(`${a}.csv`,d0(e.shown.value.motion,o.columns),"text/csv")),r!==null&&(c("Points of the section","as a table (CSV)",()=>{let{x:h,y:d}=r.setting();u(`${a}-section.csv`,f0([h,d],r.orbits()),"text/csv")}),c("Section","as a drawing (SVG)",()=>{let{x:h,y:d}=r.sheet.frame,f=r.orbits().map(m=>({...m,colour:bn.series[m.number%bn.series.length]??bn.ink}));u(`${a}-section.svg`,l0(o.title,h,d,f),"image/svg+xml")})),c("Plots","over time, as a drawing (SVG)",()=>{let h=i.chosen().map(d=>({...d,label:d.text,components:d.components.map(f=>({...f,label:si(f.label)}))}));u(`${a}-plots.svg`,a0(o.title,e.shown.value.motion.times,h),"image/svg+xml")}),t!==null&&jS(n,t,a,c),l}function jS({lab:n},e,t,i){let{stage:r}=e,s=()=>[e.element.clientWidth,e.element.clientHeight];i("Picture","of the scene now (PNG)",async()=>{let l=await r.sized(...s(),3,()=>r.picture(n.clock.time.value));e.refresh();let c=await new Promise(u=>l.toBlob(u,"image/png"));if(c===null)throw new Error("The browser could not write the picture.");Ls(`${t}.png`,c)});let o=!1,a=i("Film","of the whole motion at the chosen speed (MP4)",async()=>{if(o){o=!1;return}o=!0,n.clock.pause(),a.textContent="Stop the film";let[l,c]=s(),u=JS/Math.max(l,c),{until:h}=n.clock,d=h/n.clock.speed.value,[f,m]=[m0(l*u),m0(c*u)],x=n.clock.speed.value,g={width:f,height:m,duration:d,picture:b=>r.picture(Math.min(h,b*x)),progress:b=>n.say(`Film: ${Math.round(100*b)} of 100`),wanted:()=>o},p=await r.sized(f,m,1,()=>r0(g)).finally(()=>{o=!1,a.textContent="Film",e.refresh()});if("message"in p)return n.say(p.message,!0);Ls(`${t}.mp4`,p),n.say(`The film lasts ${d.toFixed(1)} s.`)});n.shown.value.surfaces.body!==null&&i("Body in motion","for other 3D programs (glTF, GLB)",()=>{let{surfaces:{body:l},motion:c}=n.shown.value;l!==null&&Ls(`${t}.glb`,new Blob([s0(n.model.title,l,c)],{type:"model/gltf-binary"}))})}function m0(n){return 2*Math.max(1,Math.round(n/2))}function Do(n){let{model:e}=n,{experiment:t}=n.shown.value,i=r=>Object.entries(r).map(([s,o])=>({name:s,value:o}));return Vm(e.experiment,i(t.parameters),i(Da(n)),t.until===e.until?null:t.until)}var QS={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function Wn(n){return n==="1"||n==="unknown"?"":n.replace(/(?:\*\*|\^)\{?(-?\d+)\}?/g,(t,i)=>[...i].map(r=>QS[r]??r).join("")).replaceAll("*"," ").trim()}function Gi(n,e){return n.quantities.findIndex(t=>t.name===e)}async function*y0(n,e,t,i,r,s,o){let[a,l]=[Gi(e,i.x),Gi(e,i.y)],c=e.quantities.length,{on:u,value:h,direction:d}=i,f=(p,b,E)=>{let v=n.section({parameters:t,start:p,on:u,value:h,direction:d,points:E,until:o-b});return v.catch(()=>{}),v},m=0,x=performance.now(),g=f(r,m,Math.min(250,s));for(let p=0;g!==null;){let{rows:b,times:E,dimension:v,end:C}=await g;g=null;let T=b.length/v;if(p+=T,T===0){yield{x:new Float64Array(0),y:new Float64Array(0),rows:b,time:m,end:C?.reason??"it does not cross the section"};return}m+=E.at(-1)??0;let y=n.quantities(t,b,v);if(C===null&&p<s){let B=performance.now(),L=Math.round(Math.min(5e3,Math.max(50,T*60/Math.max(1,B-x))));x=B,g=f(b.slice((T-1)*v),m,Math.min(L,s-p))}let M=await y;yield{x:x0(M,c,a,e),y:x0(M,c,l,e),rows:b,time:m,end:C?.reason??null}}}function x0(n,e,t,i){let r=i.quantities[t]?.angle===!0;return Float64Array.from({length:n.length/e},(s,o)=>{let a=n[o*e+t]??NaN;return r?eA(a):a})}function eA(n){let e=Math.round(n/(2*Math.PI));return n-2*Math.PI*e}function _0(n,e,t,i){let r=0;for(let s=1;s<n.length;s++){let o=(n[s-1]??NaN)-e,a=(n[s]??NaN)-e,l=i?Math.floor(a/(2*Math.PI))-Math.floor(o/(2*Math.PI)):0,c=i?Math.sign(l):o<0&&a>=0?1:o>0&&a<=0?-1:0;c!==0&&(t===0||t===c)&&(r+=i?Math.abs(l):1)}return r}function b0(n){let[e,t]=[1/0,-1/0];for(let r=0;r<n.length;r++){let s=n[r]??NaN;s<e&&(e=s),s>t&&(t=s)}if(!(t>e))return e===1/0?0:e;let i=10**Math.floor(Math.log10((t-e)/2));return Number((Math.round((e+t)/2/i)*i).toPrecision(6))}function v0(n,e,t,i,r){let s=null,o=r*r;for(let a of n)for(let l=0;l<a.x.length;l++){let c=e(a.x[l]??NaN)-i.right,u=t(a.y[l]??NaN)-i.down,h=c*c+u*u;h<o&&([o,s]=[h,{orbit:a,index:l}])}return s}function Hd(n,e){return{...n,x:Vd(n.x,e.x),y:Vd(n.y,e.y),rows:Vd(n.rows,e.rows),until:e.time}}function Mc(n,e,t,i,r){let s=null,o=1/0;for(let{x:a,y:l,rows:c}of n){let u=c.length/e,h=a.length-u;for(let d=0;d<u;d++){let f=Math.hypot(((a[h+d]??NaN)-t.x)/i,((l[h+d]??NaN)-t.y)/r);f<o&&(o=f,s=c.subarray(d*e,(d+1)*e))}}return s}function Vd(n,e){let t=new Float64Array(n.length+e.length);return t.set(n),t.set(e,n.length),t}function Gd(n,e,t,i,r,s){let o=t.x.length>3e3?1.2:1.8,a=Math.max(1,Math.round(o*s))/s;n.fillStyle=r;for(let l=i;l<t.x.length;l++){let[c,u]=[e.right(t.x[l]??NaN),e.down(t.y[l]??NaN)];e.contains(c,u)&&n.fillRect(c-a/2,u-a/2,a,a)}}function A0(n,e,t,i,r){let s=o=>{o.x.length!==0&&(n.beginPath(),n.arc(e.right(o.x[0]??NaN),e.down(o.y[0]??NaN),5,0,2*Math.PI),n.stroke())};if(n.strokeStyle=n.fillStyle=r,n.lineWidth=1.6,t.forEach(s),i!==null){for(let o=0;o<i.x.length;o++){let[a,l]=[e.right(i.x[o]??NaN),e.down(i.y[o]??NaN)];e.contains(a,l)&&n.fillRect(a-1,l-1,2,2)}s(i)}}function M0(n,e,t){let i=n.state.slice(0,n.reduced).map(({name:r})=>r);for(let r of["x","y"]){let s=t[r];if(s.length<3||w0(s,n.quantities[Gi(n,e[r])]?.angle===!0))continue;let o=e[r==="x"?"y":"x"],a=i.find((l,c)=>[e.on,o].includes(l)||Gi(n,l)<0?!1:w0(Float64Array.from({length:t.rows.length/n.reduced},(u,h)=>t.rows[h*n.reduced+c]??NaN),!1));if(a!==void 0)return{...e,[r]:a}}return e}function w0(n,e){let[t,i]=Dr(e?n.map(r=>Math.abs(Math.tan(r/2))):n,0);return i-t>1e-6*Math.max(Math.abs(t),Math.abs(i))&&new Set(n).size>2}function T0(n,e,t){return Array.from({length:t},(i,r)=>{let s=r/(t-1);return{x:n.x+s*(e.x-n.x),y:n.y+s*(e.y-n.y)}})}function Tc(n){return n.mathml?si(n.mathml):n.name}function Ec(n,e){if(n.length!==e.length)return!1;for(let t=0;t<n.length;t++)if(n[t]!==e[t])return!1;return!0}function ja(n){return n.endsWith(".")?n:`${n}.`}var S0=5;function E0(n,e,t,i){let r={on:e.on,value:e.value,count:i(e.on,e.value)};if(r.count>=S0)return e;let s=n.state.slice(0,n.reduced).map(({name:c})=>c).filter(c=>Gi(n,c)>=0),o=[e.on,...s].filter(c=>n.wasm_tables?.section_quantities.includes(c)??!0).flatMap(c=>[0,b0(t(c))].map(u=>({on:c,value:u,count:i(c,u)}))),a=o.find(({count:c})=>c>=S0)??o.reduce((c,u)=>u.count>c.count?u:c,r),l={...e,on:a.on,value:a.value};for(let c of["x","y"]){if(l[c]!==l.on)continue;let u=s.find(h=>![l.on,l.x,l.y].includes(h));u!==void 0&&(l={...l,[c]:u})}return l}var ko="'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif";function _r(){return Number.parseFloat(getComputedStyle(document.documentElement).fontSize)||16}function Wd(n){return`${Math.round(n)}px ${ko}`}var tA={left:3.8,right:.9,top:.6,bottom:2.6},Cc=class{constructor(e,t,i,r,s=16){this.width=e;this.height=t;this.x=i;this.y=r;this.letter=s;let{left:o,right:a,top:l,bottom:c}=tA;this.margin={left:o*s,right:a*s,top:l*s,bottom:c*s}}width;height;x;y;letter;margin;get innerWidth(){return Math.max(1,this.width-this.margin.left-this.margin.right)}get innerHeight(){return Math.max(1,this.height-this.margin.top-this.margin.bottom)}right(e){let[t,i]=this.x.range;return this.margin.left+(e-t)/(i-t)*this.innerWidth}down(e){let[t,i]=this.y.range;return this.margin.top+(i-e)/(i-t)*this.innerHeight}valueX(e){let[t,i]=this.x.range;return t+(e-this.margin.left)/this.innerWidth*(i-t)}valueY(e){let[t,i]=this.y.range;return i-(e-this.margin.top)/this.innerHeight*(i-t)}contains(e,t){return e>=this.margin.left&&e<=this.width-this.margin.right&&t>=this.margin.top&&t<=this.height-this.margin.bottom}};function qd([n,e],t,i){return[t+(n-t)*i,t+(e-t)*i]}function R0(n,e,t){let{margin:{left:i,top:r},letter:s}=e,{innerWidth:o,innerHeight:a}=e;n.save(),n.font=`${.8*s}px ${ko}`,n.lineWidth=1,n.strokeStyle=t.quiet,n.beginPath(),n.moveTo(i-.5,r),n.lineTo(i-.5,r+a+.5),n.lineTo(i+o,r+a+.5),n.stroke(),n.fillStyle=t.ink,n.textAlign="center",n.textBaseline="top";for(let l of Bo(...e.x.range,Math.max(2,o/(5.6*s)))){let c=e.right(l);C0(n,c,r+a,0,4),n.fillText(bt(l,6),c,r+a+6)}n.textAlign="right",n.textBaseline="middle";for(let l of Bo(...e.y.range,Math.max(2,a/(3.4*s)))){let c=e.down(l);C0(n,i-4,c,4,0),n.fillText(bt(l,6),i-7,c)}n.font=`italic ${.92*s}px ${ko}`,n.textAlign="center",n.textBaseline="bottom",n.fillText(e.x.label,i+o/2,e.height-2),n.translate(.85*s,r+a/2),n.rotate(-Math.PI/2),n.textBaseline="middle",n.fillText(e.y.label,0,0),n.restore()}function C0(n,e,t,i,r){n.beginPath(),n.moveTo(e,t),n.lineTo(e+i,t+r),n.stroke()}var nA=5,hs=class{constructor(e){this.acts=e;this.element=X("div",{class:"lab-sheet",tabindex:0,role:"application","aria-label":e.label},this.base,this.over,this.tip,this.spoken),this.bindPointer(),this.element.addEventListener("keydown",t=>this.key(t)),this.element.addEventListener("blur",()=>{this.cross=null,this.mark()}),new ResizeObserver(()=>this.paint()).observe(this.element),bo(()=>this.repaint())}acts;element;boxing=!1;base=X("canvas",{"aria-hidden":!0});over=X("canvas",{"aria-hidden":!0});tip=X("div",{class:"lab-tip",hidden:!0,role:"tooltip"});spoken=X("span",{class:"lab-spoken",role:"status","aria-live":"polite"});x={range:[-1,1],label:""};y={range:[-1,1],label:""};cross=null;stroke=null;fingers=new Map;due=!1;get frame(){return new Cc(this.element.clientWidth,this.element.clientHeight,this.x,this.y,_r())}get pen(){return this.base.getContext("2d")}get canvas(){return this.base}setAxes(e,t){this.x=e,this.y=t,this.repaint()}setRanges(e,t){this.x={...this.x,range:e},this.y={...this.y,range:t},this.repaint(),this.acts.moved?.()}showAll(){let{x:e,y:t}=this.acts.whole();this.setRanges(e,t)}zoom(e,t=null){let i=t??this.cross??{x:Oo(this.x.range),y:Oo(this.y.range)};this.setRanges(qd(this.x.range,i.x,e),qd(this.y.range,i.y,e))}repaint(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due=!1,this.paint()}))}mark(){let{ratio:e}=fd(this.over),t=this.over.getContext("2d");if(t===null)return;let{frame:i}=this,r=nn();if(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,i.width,i.height),this.acts.marks?.(t,i),t.strokeStyle=r.ink,t.lineWidth=1,this.cross!==null){let[s,o]=[i.right(this.cross.x),i.down(this.cross.y)];t.beginPath(),t.moveTo(s-12,o),t.lineTo(s+12,o),t.moveTo(s,o-12),t.lineTo(s,o+12),t.stroke()}if(this.stroke!==null){let{from:s,to:o,box:a}=this.stroke;t.setLineDash([5,3]),t.beginPath(),a?t.rect(s.right,s.down,o.right-s.right,o.down-s.down):(t.moveTo(s.right,s.down),t.lineTo(o.right,o.down)),t.stroke(),t.setLineDash([])}}paint(){if(this.element.clientWidth===0)return;let{ratio:e}=fd(this.base),{pen:t,frame:i}=this;t!==null&&(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,i.width,i.height),this.acts.paint(t,i,e),R0(t,i,nn()),this.mark())}value(e,t){let{frame:i}=this;return{x:i.valueX(e),y:i.valueY(t)}}bindPointer(){let e=this.element,t=i=>{let{left:r,top:s}=e.getBoundingClientRect();return{right:i.clientX-r,down:i.clientY-s}};e.addEventListener("pointerdown",i=>{let r=t(i);this.frame.contains(r.right,r.down)&&(this.cross=null,this.fingers.set(i.pointerId,r),e.setPointerCapture(i.pointerId),this.fingers.size===1?this.stroke={from:r,to:r,box:this.boxing||i.shiftKey}:this.stroke=null)}),e.addEventListener("pointermove",i=>{let r=t(i);if(this.fingers.get(i.pointerId)===void 0)return this.point(r);if(this.fingers.size===2)return this.pinch(i.pointerId,r);this.fingers.set(i.pointerId,r),this.stroke!==null&&(this.stroke={...this.stroke,to:r}),this.mark()}),e.addEventListener("pointerup",i=>{if(!this.fingers.delete(i.pointerId))return;let{stroke:r}=this;if(this.stroke=null,this.mark(),r===null)return;let s=Math.hypot(r.to.right-r.from.right,r.to.down-r.from.down),[o,a]=[this.value(r.from.right,r.from.down),this.value(r.to.right,r.to.down)];s<nA?this.acts.click(o):r.box||this.acts.drag===void 0?this.setRanges(P0(o.x,a.x),P0(o.y,a.y)):this.acts.drag(o,a)}),e.addEventListener("pointercancel",i=>{this.fingers.delete(i.pointerId),this.stroke=null,this.mark()}),e.addEventListener("pointerleave",()=>this.tip.hidden=!0),e.addEventListener("dblclick",i=>i.preventDefault()),e.addEventListener("wheel",i=>{if(!e.matches(":focus-within")&&!i.ctrlKey)return;i.preventDefault();let{right:r,down:s}=t(i);this.zoom(Math.exp(.0015*i.deltaY),this.value(r,s))},{passive:!1})}pinch(e,t){let i=[...this.fingers].find(([a])=>a!==e)?.[1],r=this.fingers.get(e);if(this.fingers.set(e,t),i===void 0||r===void 0)return;let s=Math.hypot(r.right-i.right,r.down-i.down),o=Math.hypot(t.right-i.right,t.down-i.down);s>0&&o>0&&this.zoom(s/o,this.value(i.right,i.down))}point(e){let{frame:t}=this,i=t.contains(e.right,e.down)?this.acts.hover(this.value(e.right,e.down),t):null;if(this.mark(),this.tip.hidden=i===null,i===null)return;this.tip.textContent=i;let r=Math.min(e.right+14,t.width-this.tip.offsetWidth-4),s=e.down+16+this.tip.offsetHeight>t.height;this.tip.style.transform=`translate(${Math.max(0,r)}px, ${s?e.down-this.tip.offsetHeight-8:e.down+16}px)`}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let[t,i]=[this.x.range[1]-this.x.range[0],this.y.range[1]-this.y.range[0]],r=e.shiftKey?.1:.02,s=(l,c)=>{let u=this.cross??{x:Oo(this.x.range),y:Oo(this.y.range)};this.cross={x:u.x+l*r*t,y:u.y+c*r*i},this.spoken.textContent=this.acts.hover(this.cross,this.frame)??"",this.mark()},a={ArrowLeft:()=>s(-1,0),ArrowRight:()=>s(1,0),ArrowUp:()=>s(0,1),ArrowDown:()=>s(0,-1),Enter:()=>this.acts.click(this.cross??{x:Oo(this.x.range),y:Oo(this.y.range)}),"+":()=>this.zoom(1/1.3),"=":()=>this.zoom(1/1.3),"-":()=>this.zoom(1.3),0:()=>this.showAll(),...this.acts.keys}[e.key];a!==void 0&&(e.preventDefault(),a())}};function Oo([n,e]){return(n+e)/2}function P0(n,e){return n<e?[n,e]:[e,n]}var iA=["turns/s","rad/s","s"];async function I0(n,e,t,i){let r=null,s="";await n({do:"solve",subject:{what:e,experiment:t}},l=>{typeof l.error=="string"&&(s=l.error),l.closed_form!==void 0&&(r=l.closed_form)},i);let o=r;if(o===null)return s||"No closed form of this motion is known.";let a=o.constants.filter(({unit:l,meaning:c})=>iA.includes(l)||c==="rotation number");return{motion:o.motion,list:a}}function F0(n,e){let{bifurcation:t}=n.model;return t===null?null:new Yd(n,t,e)}var Xd="Over each region the motions fill tori; on the curves lie the special motions: stable on the solid ones, unstable on the broken ones. A click shows a motion with these values of the integrals; the ring is where the motion of the scene lies.",L0=12,Yd=class{constructor(e,t,i){this.lab=e;this.diagram=t;this.ask=i;this.sheet=new hs({label:`Bifurcation diagram: ${t.x} across, ${t.y} up. Arrow keys move a cross, Enter shows a motion with these values.`,paint:(r,s)=>this.paint(r,s),click:r=>{this.start(r)},hover:(r,s)=>this.hover(r,s),marks:(r,s)=>this.marks(r,s),whole:()=>this.whole()}),this.element=X("div",{},this.sheet.element,this.note,this.figures),this.axes(),e.shown.after(()=>{this.follow()})}lab;diagram;ask;element;sheet;point=null;visible=!1;known=$d({});stale=!1;running=null;note=X("p",{class:"lab-hint"},Xd);figures=X("div",{class:"lab-answers",role:"status","aria-live":"polite"});shown(){this.visible=!0,this.follow()}axes(){let{x:e,y:t}=this.whole();this.sheet.setAxes({range:e,label:this.label(this.diagram.x)},{range:t,label:this.label(this.diagram.y)})}async follow(){if(!this.visible)return;await this.locate();let{experiment:e}=this.lab.shown.value;this.stale=$d(e.parameters)!==this.known,this.note.textContent=this.stale?"These curves belong to the parameters with which the page opened, not to those of the motion in the scene; chaplygin lab draws them anew.":Xd,this.sheet.repaint();let{ask:t,lab:i}=this;if(t===null){this.figures.replaceChildren(X("p",{class:"lab-hint"},"The frequencies of the closed form are shown in the laboratory: chaplygin lab, or in a notebook."));return}this.running?.abort();let r=new AbortController;this.running=r,this.figures.replaceChildren(X("p",{class:"lab-hint"},"asking for the closed form …"));let s={what:i.model.name,experiment:Do(i)};try{this.stale&&await this.renew(t,s,$d(e.parameters),r.signal);let o=await I0(t,s.what,s.experiment,r.signal);if(r.signal.aborted)return;this.figures.replaceChildren(typeof o=="string"?X("p",{class:"lab-hint"},o):rA(o.motion,o.list))}catch(o){r.signal.aborted||this.figures.replaceChildren(X("p",{class:"lab-hint lab-refused"},o instanceof Error?o.message:String(o)))}}async renew(e,t,i,r){await e({do:"bifurcation",subject:t},s=>{let o=s.bifurcation;o==null||r.aborted||(this.diagram=o,this.known=i,this.stale=!1,this.note.textContent=Xd,this.axes())},r)}label(e){let t=this.lab.model.quantities.find(s=>s.name===e),i=t?.mathml?si(t.mathml):e,r=Wn(t?.unit??"1");return r?`${i}  (${r})`:i}whole(){let{curves:e}=this.diagram;return{x:Dr(e.flatMap(({x:t})=>t)),y:Dr(e.flatMap(({y:t})=>t))}}async locate(){let{engine:e,model:t}=this.lab,{state:i,experiment:r}=this.lab.shown.value;if(e===null||i===null)return;let s=await e.quantities(r.parameters,i.slice(0,t.reduced),t.reduced),o=a=>s[t.quantities.findIndex(l=>l.name===a)]??NaN;this.point={x:o(this.diagram.x),y:o(this.diagram.y)},this.sheet.mark()}paint(e,t){let i=nn();e.save(),e.beginPath(),e.rect(t.right(t.x.range[0]),t.down(t.y.range[1]),t.innerWidth,t.innerHeight),e.clip();let r=[...new Set(this.diagram.curves.map(({label:s})=>s))];this.diagram.curves.forEach(({x:s,y:o,label:a,stable:l})=>{e.strokeStyle=i.series[Math.max(0,r.indexOf(a))%i.series.length]??i.ink,e.lineWidth=1.8,e.globalAlpha=this.stale?.35:1,e.setLineDash(l?[]:[6,3.5]),e.beginPath(),s.forEach((c,u)=>{let[h,d]=[t.right(c),t.down(o[u]??NaN)];u===0?e.moveTo(h,d):e.lineTo(h,d)}),e.stroke()}),e.restore()}marks(e,t){this.point!==null&&(e.strokeStyle=nn().ink,e.fillStyle=nn().paper,e.lineWidth=2,e.beginPath(),e.arc(t.right(this.point.x),t.down(this.point.y),5,0,2*Math.PI),e.fill(),e.stroke())}hover(e,t){let i=null;for(let{label:s,x:o,y:a}of this.diagram.curves)o.forEach((l,c)=>{let u=Math.hypot(t.right(l)-t.right(e.x),t.down(a[c]??NaN)-t.down(e.y));u<8&&(i===null||u<i.far)&&(i={label:s,far:u})});let r=`${si(this.label(this.diagram.x))} = ${bt(e.x)}, ${this.label(this.diagram.y)} = ${bt(e.y)}`;return i===null?r:`${r}: ${i.label}`}async start(e){let{engine:t}=this.lab,{state:i,experiment:r,motion:s}=this.lab.shown.value;if(t===null||i===null)return this.lab.say("This page shows a recorded motion and cannot compute another.",!0);let{x:o,y:a}=this.diagram,{states:l}=s,c=s.times.length,u=[i];if(l!==void 0){let d=l.length/c;for(let f=1;f<L0;f++){let m=Math.floor(f*c/L0);u.push(l.slice(m*d,(m+1)*d))}}let h="";for(let d of u){let f={on:null,direction:0,x:o,y:a},m=await t.startOnLevel({parameters:r.parameters,reference:d,section:f,x:e.x,y:e.y});if("message"in m){h||=m.message;continue}await this.lab.change({...this.lab.wanted.value,start:{state:Array.from(m.state)}}),this.lab.clock.seek(0);return}this.lab.say(`${ja(h)} Where no torus lies over a point of the diagram there is no motion.`,!0)}};function $d(n){return JSON.stringify(Object.entries(n).sort(([e],[t])=>e<t?-1:1))}function rA(n,e){let t=e.map(({symbol:i,value:r,unit:s,meaning:o})=>X("tr",{},X("th",{scope:"row"},i),X("td",{class:"lab-number"},`${bt(Number(r),10)} ${s}`.trim()),X("td",{},o)));return X("div",{},X("p",{},`Closed form: ${n}`),X("table",{class:"lab-table"},...t))}function Zd(n,e=32){return Math.log2(Math.max(1,n)/2)/Math.log2(e/2)}function N0(n){return lc(Fs(),Zd(n))}function Qa(n){return Number.isFinite(n)?`MEGNO ${bt(n,3)}${n<2.5?", as on regular motions":n>4?", as on chaotic motions":""}`:"no indicator: the motion ends before"}var Rc=1e3;function Pc(n,e,t){let{low:i,high:r}=n,s=`${n.meaning||n.name}${n.unit&&n.unit!=="1"?`, ${n.unit}`:""}`,o=X("input",{type:"range",min:0,max:Rc,step:1,"aria-label":s}),a=X("input",{type:"text",inputmode:"decimal","aria-label":`${s}, as a number`,class:"lab-field",size:9}),l=f=>{let m=r>i?(f-i)/(r-i):0;o.value=String(Math.round(Rc*m)),o.style.setProperty("--share",String(Math.min(1,Math.max(0,m)))),o.setAttribute("aria-valuetext",`${bt(f)} ${n.unit}`),document.activeElement!==a&&(a.value=Math.abs(f)<1e-12*(r-i)?"0":sA(f))},c=!1;o.addEventListener("input",()=>{c||e(),c=!0;let f=oA(i+Number(o.value)/Rc*(r-i),r-i);l(f),t(f)}),o.addEventListener("change",()=>c=!1);let u=()=>{let f=Number(a.value.replaceAll("−","-").replace(",","."));if(a.value.trim()===""||!Number.isFinite(f)){a.setAttribute("aria-invalid","true");return}a.removeAttribute("aria-invalid"),e(),t(f),l(f)};a.addEventListener("change",u),a.addEventListener("keydown",f=>f.stopPropagation()),l(n.value);let h=Wn(n.unit)===""?null:X("span",{class:"lab-unit"},Wn(n.unit));return{element:X("div",{class:"lab-slider",title:n.meaning||null},X("span",{class:"lab-symbol"},n.symbol),o,X("span",{class:"lab-value"},a,h)),set:l}}function sA(n){return String(Number(n.toPrecision(5))).replaceAll("-","−")}function oA(n,e){let t=10**Math.floor(Math.log10(e/Rc));return Number((Math.round(n/t)*t).toPrecision(12))}function Ic(n,e,t){let i=e??(n>0?0:n<0?2*n:-1),r=t??(n>0?2*n:n<0?0:1);return i<r?[Math.min(i,n),Math.max(r,n)]:[i,i+Math.max(1,Math.abs(i))]}var B0='"use strict";(()=>{function Z({rows:r,misses:t},n){let e=new Float64Array(n),o=[];return r.forEach((s,i)=>{let a=Float64Array.from(s),u=P(s);for(let l=0;l<2;l++)for(let c of o)R(a,c);let m=P(a);if(!(m>1e-9*u))return;for(let l=0;l<n;l++)a[l]/=m;let f=(t[i]-N(s,e))/m;for(let l=0;l<n;l++)e[l]+=f*a[l];o.push(a)}),e}function L(r){let t=[];for(let n of r){let e=Float64Array.from(n),o=P(n);for(let i=0;i<2;i++)for(let a of t)R(e,a);let s=P(e);s>1e-9*o&&t.push(e.map(i=>i/s))}return t}function R(r,t){let n=N(r,t);for(let e=0;e<r.length;e++)r[e]-=n*t[e]}function N(r,t){let n=0;for(let e=0;e<r.length;e++)n+=r[e]*t[e];return n}function P(r){return Math.sqrt(N(r,r))}var et=1e-12,it=40,vt=1e-15,xt=4,St=64;function lt(r,{parameters:t,inputs:n}){let{model:e,tables:o}=r,s=r.parameters(t),i=Tt(r,s);if(i!==null)return{message:i};let a=Float64Array.from(e.start_inputs,l=>n[l.name]??l.value),u=a.findIndex(l=>!Number.isFinite(l));if(u>=0)return{message:`${e.start_inputs[u].name}: it must be a finite number`};let m;if(o.start===null){let l=Et(r,a,s);if("message"in l)return l;m=l.state}else{let l=o.motion.dimension,c=r.values(o.start,a,s);m=c.slice(0,l);let g=c.slice(l,l+o.excess.length),d=c.slice(l+g.length);for(let[p,{message:y,among:h}]of o.excess.entries()){let A=Math.max(...h.map(b=>Math.abs(a[b])));if(Math.abs(g[p])>et*A){let b=h.map(F=>tt(d[F])).join(", ");return{message:y.replace("{excess}",C(g[p])).replace("{nearest}",b),nearest:d}}}if(!m.every(Number.isFinite))return{message:o.singular}}let f=ct(r,m,s);return f===null?{state:m}:{message:f}}function Tt(r,t){let{model:n,tables:e}=r,o=t.findIndex(f=>!Number.isFinite(f));if(o>=0){let{name:f}=n.parameters[o];return`${n.name}: ${f} = ${tt(t[o])} must be a finite number`}if(e.conditions_on_parameters.length===0)return null;let i=r.values(e.admissible,new Float64Array(e.admissible.inputs),t).findIndex(f=>!(f>0));if(i<0)return null;let{parameter:a,condition:u}=e.conditions_on_parameters[i],m=t[n.parameters.findIndex(f=>f.name===a)];return`${n.name}: ${a} = ${tt(m)} is not admissible; ${u} must hold`}function ct(r,t,n){let{tables:e}=r;if(e.start_messages.length===0)return null;let o=Array.from(t).slice(0,e.guards.inputs),s=r.values(e.guards,o,n).findIndex(i=>!(i>0));return s<0?null:e.start_messages[s]}function Et(r,t,n){let{tables:e}=r,o=Float64Array.from(t);for(let{name:c,places:g}of e.directions){let d=Math.hypot(...g.map(p=>o[p]));if(d===0)return{message:`${c}: must not be zero, as it is a direction`};for(let p of g)o[p]/=d}let s=Float64Array.from(o),i=Array.from(s.keys()),a=ut(r,s,n,i),u=1+Math.max(0,...o.map(Math.abs)),m=Math.max(0,...s.map((c,g)=>Math.abs(c-o[g])));if(a.done&&m<=et*u)return{state:s};let f=a.misses.reduce((c,g,d)=>Math.abs(g)>Math.abs(a.misses[c])?d:c,0),l=`start: the relation ${e.relation_texts[f]} = 0 is missed by ${C(a.misses[f])}`;return a.done?{message:`${l}; the nearest admissible state is shown`,nearest:s}:{message:l}}function ut(r,t,n,e){let{phase_space:o,whole_relations:s}=r.tables,i=null;if(s===0)return{done:!0,misses:[]};let a=t.length;for(let u=0;u<it;u++){let m=r.values(o,t,n),f=Array.from(m.subarray(0,s));if(i??=f,!f.every(Number.isFinite))break;let l=f.map((p,y)=>Float64Array.from(e,h=>m[s+y*a+h])),c=Z({rows:l,misses:f.map(p=>-p)},e.length);e.forEach((p,y)=>t[p]+=c[y]);let g=1+Math.max(...t.map(Math.abs));if(Math.max(...c.map(Math.abs))<=vt*g)return{done:Pt(m,t,s),misses:i}}return{done:!1,misses:i??[]}}function Pt(r,t,n){let e=t.length,o=1+Math.max(...t.map(Math.abs));for(let s=0;s<n;s++){let i=0;for(let a=0;a<e;a++)i+=Math.abs(r[n+s*e+a]);if(!(Math.abs(r[s])<=et*(1+i*o)))return!1}return!0}function Nt(r,t,n){let{tables:e,model:o}=r,s=e.conditions.inputs,i=e.relations+e.integrals.length+o.quantities.length,a=d=>t.slice(i+d*s,i+(d+1)*s),u=[...Array(e.relations).keys()],m=e.integrals.map((d,p)=>({name:d,row:e.relations+p})),f=m.filter(({name:d})=>n.includes(d)),l=s-e.relations-n.length,c=[],g=L([...u,...f.map(({row:d})=>d)].map(a));for(let{row:d}of m.filter(p=>!f.includes(p))){let p=L([...g,a(d)]);p.length>g.length&&c.length<l&&c.push(d),g=p}return c}function mt(r,t){let{model:n,tables:e}=r,{section:o}=t,s=r.parameters(t.parameters),i=e.conditions.inputs,a=n.quantities.map(M=>M.name),u=[...o.on===null?[]:[o.on],o.x,o.y],m=u.map(M=>a.indexOf(M)),f=u.find((M,x)=>m[x]<0);if(f!==void 0)return{message:`${f}: no quantity of ${n.name}`};let l=e.relations+e.integrals.length,c=l+a.length,g=M=>r.values(e.conditions,M,s),d=Float64Array.from(Array.from(t.reference).slice(0,i)),p=g(d),y=Nt(r,p,u),h=e.relations+y.length,A=[...Array(e.relations).keys(),...y,...m.map(M=>l+M)],b=[...Array(h).fill(!1),...m.map(M=>n.quantities[M].angle)],F=[...A.map((M,x)=>x<e.relations?0:p[M]).slice(0,h),...o.on===null?[]:[o.value??0],t.x,t.y],v=U(r,d),T=(M,x)=>{let I=Float64Array.from(M);for(let k=0;k<it;k++){let z=g(I),B=A.map((S,j)=>at(x[j],z[S],b[j])),_=A.map(S=>Float64Array.from({length:i},(j,ot)=>z[c+S*i+ot]*v[ot])),$=_.map(S=>Math.sqrt(N(S,S))),O=Math.max(...B.map((S,j)=>Math.abs(S)/($[j]+1e-300)));if(!Number.isFinite(O))return null;if(O<1e-14||k>6&&O<1e-12)return I;let q=Z({rows:_,misses:B},i),E=Math.max(...q.map(Math.abs)),D=Math.min(1,.5/E);for(let S=0;S<i;S++)I[S]+=D*q[S]*v[S]}return null},V=A.length-1;for(let M=xt;M<=St;M*=4){let x=d;for(let $=1;$<=M&&x!==null;$++){let O=F.map((q,E)=>{if(E<h||E>V)return q;let D=p[A[E]];return D+$/M*at(q,D,b[E])});x=T(x,O)}if(x===null)continue;let I=g(x),k=r.values(e.rates,x,s),z=I.subarray(c+A[h]*i,c+(A[h]+1)*i),B=n.direction*N(Float64Array.from(z),k);if(o.direction*n.direction*B<0)continue;let _=ct(r,x,s);return _!==null?{message:_}:It(r,x,t.reference,s)}return{message:`no state on this level was found at ${o.x} = ${C(t.x)}, ${o.y} = ${C(t.y)}`}}function It(r,t,n,e){let{model:o,tables:s}=r,i=s.motion.dimension,a=n.length>=i?n:o.start,u=Float64Array.from({length:i},(f,l)=>l<t.length?t[l]:a[l]),m=Array.from({length:i-t.length},(f,l)=>t.length+l);return m.length>0&&!ut(r,u,e,m).done?{message:`${o.name}: no attitude belongs to this state`}:{state:u}}function U(r,t){let n=new Float64Array(r.tables.conditions.inputs).fill(1),e=r.tables.groups.map(s=>Math.hypot(...s.map(i=>t[i]))),o=Math.max(...e);return r.tables.groups.forEach((s,i)=>{let a=e[i]>1e-10*o?e[i]:o>0?o:1;for(let u of s)n[u]=a}),n}function at(r,t,n){let e=r-t;return n?e-2*Math.PI*Math.round(e/(2*Math.PI)):e}function tt(r){return Number.isInteger(r)&&Math.abs(r)<1e16?r.toFixed(1):String(r)}function C(r){return String(Number(r.toPrecision(6)))}var W=200,ft=.2,yt=1e-12,ht=32;function nt(r,t){let{tangent:n}=r.tables,e=n.dimension/2,o=t.kind==="lyapunov",s=new Float64Array(t.motions.length).fill(NaN),i=t.motions.map(({parameters:c,start:g})=>kt(r,r.parameters(c),Float64Array.from(g).slice(0,e),t.until,o)),a=[...i.keys()].filter(c=>i[c]!==null),u=[t.until/W],m=r.model.parameters.length,f=new Float64Array(i.length*2*e),l=new Float64Array(i.length*Math.max(m,1));for(let c=1;c<=W&&a.length>0;c++){a.forEach((d,p)=>{let{state:y,scales:h,deviation:A,values:b}=i[d],w=2*e*p;f.set(y,w);for(let F=0;F<e;F++)f[w+e+F]=A[F]*h[F];l.set(b,m*p)});let g=r.march(n,f.subarray(0,2*e*a.length),l.subarray(0,m*a.length),u,1,yt);a=a.filter((d,p)=>{let y=i[d],h=g[p];if(h.outcome!==0)return!1;y.state=h.states.subarray(0,e);for(let b=0;b<e;b++)y.deviation[b]=h.states[e+b]/y.scales[b];let A=y.total;return y.total+=Math.log(dt(y.deviation,pt(r,y,o))),y.mean+=((y.total+A)/2-y.mean)/c,y.sum+=2*(y.total-y.mean),c<=ft*W&&(y.settled=y.total),!0})}for(let c of a){let{total:g,settled:d,sum:p}=i[c],y=(g-d)/(t.until*(1-ft));s[c]=t.kind==="megno"?p/W:y}return s}function kt(r,t,n,e,o){let s=Float64Array.from(n,(m,f)=>Math.cos(1+2.7*f)),i=_t(r,n,t,e),a={values:t,state:n,scales:i,deviation:s,total:0,mean:0,sum:0,settled:0},u=pt(r,a,o);return u.length>=n.length?null:(dt(s,u),a)}function dt(r,t){for(let e=0;e<2;e++)for(let o of t)R(r,o);let n=P(r);for(let e=0;e<r.length;e++)r[e]/=n;return n}function pt(r,t,n){let{invariants:e,relations:o,integrals:s,rates:i}=r.tables,{state:a,values:u,scales:m}=t,f=a.length,l=o+s.length,c=n?l:o,g=c>0?r.values(e,a,u):a,d=Array.from({length:c},(p,y)=>{let h=g.slice(l+y*f,l+(y+1)*f);for(let A=0;A<f;A++)h[A]*=m[A];return h});if(n){let p=Float64Array.from(r.values(i,a,u));for(let y=0;y<f;y++)p[y]/=m[y];d.push(p)}return L(d)}function _t(r,t,n,e){let{tangent:o}=r.tables,s=t.length,i=Array.from({length:ht},(f,l)=>(l+1)/(10*ht)*e),a=new Float64Array(2*s);a.set(t);let[u]=r.march(o,a,n,i,i.length,yt),m=U(r,t);for(let f=0;f<u.count;f++){let l=U(r,u.states.subarray(2*s*f,2*s*f+s));for(let c=0;c<s;c++)m[c]=Math.max(m[c],l[c])}return m}function rt(r){let t=atob(r),n=new Uint8Array(t.length);for(let e=0;e<t.length;e++)n[e]=t.charCodeAt(e);return n}function G(r){return new Float32Array(rt(r).buffer)}function gt(r){return new Uint32Array(rt(r).buffer)}async function bt(r){let t=new Blob([rt(r)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(t).arrayBuffer()}var $t=65536,Ot=10000000n,st=1024,K=class r{constructor(t,n,e,o){this.model=t;this.tables=n;this.memory=e;this.functions=o}model;tables;memory;functions;at=st;static async create(t){if(t.wasm===null||t.wasm_tables===null)throw new Error(`${t.title}: this page cannot compute`);let n=new WebAssembly.Memory({initial:16}),e=await WebAssembly.instantiate(await bt(t.wasm),{env:{memory:n}});return new r(t,t.wasm_tables,n,e.instance.exports)}parameters(t){let n=new Set(this.model.parameters.map(e=>e.name));for(let e of Object.keys(t))if(!n.has(e)){let o=[...n].join(", ")||"none";throw new RangeError(`${this.model.name}: no parameter ${e}; it has ${o}`)}return Float64Array.from(this.model.parameters,e=>t[e.name]??e.value)}march(t,n,e,o,s,i){let a=n.length/t.dimension,u=e.length>t.parameters?BigInt(t.parameters):0n;this.at=st;let m=this.put(n),f=this.put(e),l=this.put(o),c=this.room(a*s*t.dimension),g=this.room(a*s),d=this.room(a),p=this.room(a),y=this.room(a),h=this.room(a),A=this.room(t.work);this.doubles(c,a*s*t.dimension).fill(NaN),this.whole(d,a).fill(0n);let b=this.functions[t.name];return b(0n,BigInt(a),m,f,u,l,BigInt(s),i,Ot,c,g,d,p,y,h,A),Array.from({length:a},(w,F)=>{let v=Number(this.whole(d,a)[F]),T=s*t.dimension;return{states:this.doubles(c+8*F*T,v*t.dimension).slice(),moments:this.doubles(g+8*F*s,v).slice(),count:v,outcome:Number(this.whole(p,a)[F]),ended:this.doubles(y,a)[F],steps:Number(this.whole(h,a)[F])}})}values(t,n,e){let o=n.length/t.inputs;this.at=st;let s=this.put(n),i=this.put(e),a=this.room(o*t.outputs),u=this.room(t.work);return this.functions[t.name](BigInt(o),s,i,a,u),this.doubles(a,o*t.outputs).slice()}put(t){let n=this.room(Math.max(t.length,1));return this.doubles(n,t.length).set(t),n}room(t){let n=this.at;this.at+=16*Math.ceil(t/2);let e=this.at-this.memory.buffer.byteLength;return e>0&&this.memory.grow(Math.ceil(e/$t)),n}doubles(t,n){return new Float64Array(this.memory.buffer,t,n)}whole(t,n){return new BigInt64Array(this.memory.buffer,t,n)}};function H(r,t){let n=new Float64Array(3*r.length*t.length),e=0;for(let o=0;o<r.length;o++)for(let s=0;s<t.length;s++){let i=Math.sin(r[o]);n[e++]=i*Math.cos(t[s]),n[e++]=i*Math.sin(t[s]),n[e++]=Math.cos(r[o])}return n}function J(r,t){let{theta:n,phi:e,hollow:o}=r,s=n.length,i=e.length,a=H(n,e),u=o?1:-1,m=s*i,f=m+2*(i+1),l=new Float32Array(3*f),c=new Float32Array(3*f);for(let h=0;h<3*m;h++)l[h]=t[h],c[h]=u*a[h];let g=[],d=[],p=(h,A,b,w)=>{qt(l,c,h,A,b)||([A,b]=[b,A]),g.push(h,A,b),d.push(w)},y=h=>Math.floor((e[h]+1e-9)/(Math.PI/2));for(let h=0;h+1<s;h++){let A=(n[h]+n[h+1])/2<Math.PI/2?1:0;for(let b=0;b<i;b++){let w=(b+1)%i,F=(y(b)+A)%2;p(h*i+b,h*i+w,(h+1)*i+w,F),p(h*i+b,(h+1)*i+w,(h+1)*i+b,F)}}for(let h of[!0,!1]){let A=(h?0:s-1)*i,b=m+(h?0:i+1),w=b+i,F=u*(h?1:-1);for(let v=0;v<i;v++){for(let T=0;T<3;T++){let V=l[3*(A+v)+T];l[3*(b+v)+T]=V,l[3*w+T]+=V/i}c[3*(b+v)+2]=F}c[3*w+2]=F;for(let v=0;v<i;v++)p(w,b+v,b+(v+1)%i,(y(v)+(h?1:0))%2)}return{positions:l,normals:c,indices:Uint32Array.from(g),tones:Uint8Array.from(d),hollow:o}}function qt(r,t,n,e,o){let s=[0,1,2].map(u=>r[3*e+u]-r[3*n+u]),i=[0,1,2].map(u=>r[3*o+u]-r[3*n+u]),a=0;for(let u=0;u<3;u++){let m=(u+1)%3,f=(u+2)%3,l=t[3*n+u]+t[3*e+u]+t[3*o+u];a+=(s[m]*i[f]-s[f]*i[m])*l}return a>=0}var At=8,Ft=24,Mt=48;function jt({scene:r}){return{body:r.body===null?null:J(r.body,G(r.body.positions)),inertia:null,ground:Lt(r.support)}}function Lt(r){return r?.kind!=="mesh"?null:{positions:G(r.positions),normals:G(r.normals),indices:gt(r.indices)}}var Q=class{constructor(t){this.module=t;this.first=jt(t.model)}module;first;at(t){let{module:n,first:e}=this,{contact:o,inertia:s,ground:i}=n.tables,a=n.parameters(t);return{body:o===null||e.body===null?e.body:this.body(o,a),inertia:s===null?null:this.closed(s,a),ground:i===null||e.ground===null?e.ground:this.ground(i,e.ground,a)}}body(t,n){let{body:e}=this.module.model.scene;if(e===null)return null;let o=H(e.theta,e.phi),s=this.rows(t,o,n),i=e.hollow?1:-1;for(let a=0;a<o.length;a+=3){let u=i*o[a+2];Math.abs(u)>1e-9&&(s[a+2]+=e.thickness*Math.sign(u))}return J(e,s)}closed(t,n){let e=Array.from({length:Ft},(i,a)=>Math.PI*(a+.02)/(Ft-.96)),o=Array.from({length:Mt},(i,a)=>2*Math.PI*a/Mt),s=this.rows(t,H(e,o),n);return J({theta:e,phi:o,positions:"",hollow:!1,thickness:0},s)}ground(t,n,e){let o=this.module.parameters({});if(e.every((l,c)=>l===o[c]))return n;let s=Float64Array.from(n.positions),i=s.length/3,a=this.rows(t,s,o);for(let l=0;l<s.length;l++)s[l]+=a[5*Math.floor(l/3)+4]*n.normals[l];let u=Float32Array.from(n.normals),m=new Float64Array(0);for(let l=0;l<=At;l++){m=this.rows(t,s,e);for(let c=0;c<i;c++){let[g,d,p,y]=[m[5*c],m[5*c+1],m[5*c+2],m[5*c+3]],h=d*d+p*p+y*y;if(!(h>0)||!Number.isFinite(g))continue;let A=l<At?-g/h:0,b=Math.sqrt(h);[d,p,y].forEach((w,F)=>{s[3*c+F]+=A*w,u[3*c+F]=w/b})}}return{positions:Float32Array.from(s,(l,c)=>l-m[5*Math.floor(c/3)+4]*u[c]),normals:u,indices:n.indices}}rows(t,n,e){let{module:o}=this,s=n.length/3,i=new Float64Array(s*t.inputs);for(let a=0;a<s;a++)i.set(n.subarray(3*a,3*a+3),a*t.inputs+o.tables.gamma);return o.values(t,i,e)}};var X=class r{constructor(t,n){this.model=t;this.module=n}model;module;drawn=null;static async create(t){return new r(t,await K.create(t))}async motion({parameters:t,start:n,times:e}){let{model:o,module:s}=this,i=s.tables.motion,a=s.parameters(t),[u]=s.march(i,n,a,e,e.length,o.tolerance),{count:m,states:f}=u,l=s.values(s.tables.columns,f,a),c=s.tables.columns.outputs,g={},d=0;for(let y of o.columns){let h=new Float64Array(m*y.width);for(let A=0;A<m;A++)for(let b=0;b<y.width;b++)h[A*y.width+b]=l[A*c+d+b];g[y.name]=h,d+=y.width}return{times:Float64Array.from({length:m},(y,h)=>o.direction*e[h]),columns:g,states:f,end:this.end(u)}}async section(t){let{model:n,module:e}=this,{section:o,section_quantities:s}=e.tables,i=s.indexOf(t.on);if(i<0)throw new RangeError(`${t.on}: no quantity of a section; they are ${s.join(", ")}`);let a=e.parameters(t.parameters),u=new Float64Array(a.length+2+s.length);u.set(a),u[a.length]=t.value??0,u[a.length+1]=n.direction*t.direction,u[a.length+2+i]=1;let m=Array.from(t.start).slice(0,o.dimension),f=[t.until??1/0],[l]=e.march(o,m,u,f,t.points,n.section_tolerance),{states:c,moments:g}=l,d=g.map(p=>n.direction*p);return{rows:c,times:d,dimension:o.dimension,end:this.end(l)}}async quantities(t,n,e){let{module:o}=this,s=o.tables.quantities;return o.values(s,Vt(n,e,s.inputs),o.parameters(t))}async indicator(t){let{parameters:n,start:e,until:o,kind:s}=t,[i]=nt(this.module,{motions:[{parameters:n,start:e}],until:o,kind:s});return i}async indicators(t){return nt(this.module,t)}async startFrom(t){return lt(this.module,t)}async startOnLevel(t){return mt(this.module,t)}async surfaces(t){return this.drawn??=new Q(this.module),this.drawn.at(t)}end({outcome:t,ended:n}){if(t===0)return null;let e=this.module.tables.reasons[t]??`outcome ${t}`;return{time:this.model.direction*n,reason:e}}};function Vt(r,t,n){if(t===n)return r;let e=r.length/t,o=new Float64Array(e*n);for(let s=0;s<e;s++)o.set(r.subarray(s*t,s*t+n),s*n);return o}function wt(r,t,n){switch(t){case"quantities":{let{parameters:e,rows:o,dimension:s}=n;return r.quantities(e,o,s)}case"surfaces":return r.surfaces(n);case"motion":case"section":case"indicator":case"indicators":case"startFrom":case"startOnLevel":return r[t](n);default:return Promise.reject(new Error(`There is no method ${t}.`))}}var Y=null;addEventListener("message",({data:r})=>{if(r.model!==void 0){Y=X.create(r.model),Y.catch(()=>{});return}let{id:t,method:n,argument:e}=r;(async()=>{try{if(Y===null)throw new Error("The worker has no model.");postMessage({id:t,value:await wt(await Y,n??"",e)})}catch(o){postMessage({id:t,message:o instanceof Error?o.message:String(o)})}})()});})();\n';function D0(n){return{motion:async e=>await n("motion",e),section:async e=>await n("section",e),quantities:async(e,t,i)=>await n("quantities",{parameters:e,rows:t,dimension:i}),indicator:async e=>await n("indicator",e),indicators:async e=>await n("indicators",e),startFrom:async e=>await n("startFrom",e),startOnLevel:async e=>await n("startOnLevel",e),surfaces:async e=>await n("surfaces",e)}}function el(n){let e=URL.createObjectURL(new Blob([B0],{type:"text/javascript"})),t=new Worker(e),i=new Map,r=0;return t.addEventListener("message",({data:o})=>{let a=i.get(o.id);i.delete(o.id),o.message!==void 0?a?.reject(new Error(o.message)):a?.resolve(o.value)}),t.addEventListener("error",o=>{for(let{reject:a}of i.values())a(new Error(o.message||"The computation failed."));i.clear()}),t.postMessage({model:{...n,recorded:null,experiment:""}}),{engine:D0((o,a)=>new Promise((l,c)=>{r+=1,i.set(r,{resolve:l,reject:c}),t.postMessage({id:r,method:o,argument:a})})),busy:()=>i.size>0,end(){t.terminate(),URL.revokeObjectURL(e);for(let{reject:o}of i.values())o(new Error("The computation was stopped."));i.clear()}}}function k0(){return Math.min(8,Math.max(1,(navigator.hardwareConcurrency||2)-1))}var Lc=class{constructor(e){this.model=e}model;worker=null;get engine(){return this.worker??=el(this.model),this.worker.engine}renew(){this.worker?.busy()===!0&&(this.worker.end(),this.worker=null)}};function O0(n,e=16){let t=[],i=1;for(;i*2<=e&&i*2<=n;)i*=2;for(let r=i;r>=1;r/=2)for(let s=0;s<n;s+=r)for(let o=0;o<n;o+=r)r<i&&s%(2*r)===0&&o%(2*r)===0||t.push({column:o,row:s,side:r});return t}function Kd([n,e],t,i){return n+(t+.5)/i*(e-n)}function Fc(n,e){let t=n.filter(Number.isFinite).sort();return t.length===0?NaN:t[Math.min(t.length-1,Math.floor(e*t.length))]??NaN}var lA=2*Math.PI;function z0(n){let e=n.length-1;if(e<8)return NaN;let t=Float64Array.from({length:e},(a,l)=>{let c=((n[l+1]??NaN)-(n[l]??NaN))/lA;return c-Math.floor(c)}),i=cA(t);if(Number.isNaN(i))return NaN;let r=0,s=0;for(let a=0;a<e;a++){let l=(t[a]??NaN)-i,c=(a+.5)/e,u=Math.exp(-1/(c*(1-c)));r+=u*(l-Math.floor(l)+i),s+=u}let o=r/s;return o-Math.round(o)}function V0(n,e){let[t,i]=[U0(n),U0(e)];return Float64Array.from(t,(r,s)=>Math.atan2(i[s]??NaN,r))}function U0(n){let e=Float64Array.from(n),t=e.reduce((r,s)=>r+s,0)/e.length,i=Math.sqrt(e.reduce((r,s)=>r+(s-t)**2,0)/e.length);return e.map(r=>(r-t)/(i||1))}function cA(n){let e=n.slice().sort(),t=Array.from(e,(o,a)=>(a+1<e.length?e[a+1]??0:(e[0]??0)+1)-o),i=t.reduce((o,a,l)=>a>(t[o]??0)?l:o,0),r=t[i]??0,s=t.reduce((o,a,l)=>l===i?o:Math.max(o,a),0);return!(r>=.02)||r<2*s?NaN:(e[(i+1)%e.length]??0)-r/2}var uA=4,hA=8;async function Jd(n,e,t,i,r){let{model:s,experiment:o,reference:a,section:l}=e;if(t.x===null||t.y===null){if(l===null)return{message:"There is no section."};let{on:x,value:g,direction:p}=l,{xRange:b,yRange:E}=t,v=Mc(e.orbits,s.reduced,{x:i,y:r},b[1]-b[0],E[1]-E[0]),C={parameters:o.parameters,reference:v??a,section:{on:x,value:g,direction:p,x:l.x,y:l.y},x:i,y:r},T=await n.startOnLevel(C);return"message"in T?T:{experiment:{...o,start:{state:Array.from(T.state)}},state:T.state}}let c=[[t.x,i],[t.y,r]],u=c.filter(([x])=>s.start_inputs.some(g=>g.name===x)),h={...o.parameters,...Object.fromEntries(c.filter(x=>!u.includes(x)))},{start:d}=o,f="state"in d&&u.length===0?d:{inputs:{..."inputs"in d?d.inputs:{},...Object.fromEntries(u)}},m="state"in f?{state:Float64Array.from(f.state)}:await n.startFrom({parameters:h,inputs:f.inputs});return"message"in m?m:{experiment:{...o,parameters:h,start:f},state:m.state}}async function dA(n,e,t,i,r=!1){let s=await Promise.all(i.map(([d,f])=>Jd(n,e,t,d,f)));r&&t.x===null&&e.orbits.push(...s.flatMap((d,f)=>"message"in d?[]:[fA(d.state,i[f]??[0,0],e.model)]));let{kind:o,until:a}=t;if(o==="rotation")return Promise.all(s.map(d=>pA(n,e,t,d)));let l=s.map((d,f)=>"message"in d?-1:f).filter(d=>d>=0),c=l.map(d=>{let{experiment:f,state:m}=s[d];return{parameters:f.parameters,start:m}}),u=await n.indicators({motions:c,until:a,kind:o}),h=s.map(()=>NaN);return l.forEach((d,f)=>h[d]=u[f]??NaN),h}function fA(n,[e,t],{reduced:i}){return{start:n,x:Float64Array.of(e),y:Float64Array.of(t),rows:n.slice(0,i),number:0,until:0,indicator:null}}async function pA(n,e,t,i){if("message"in i)return NaN;let{parameters:r}=i.experiment,{section:s,model:o}=e;if(s===null)return NaN;let[a,l]=[s.x,s.y].map(x=>o.quantities.findIndex(g=>g.name===x)),{rows:c,dimension:u}=await n.section({parameters:r,start:i.state,on:s.on,value:s.value,direction:s.direction,points:300,until:t.until});if(c.length===0)return NaN;let h=await n.quantities(r,c,u),d=o.quantities.length,f=x=>Float64Array.from({length:h.length/d},(g,p)=>h[p*d+(x??0)]??NaN),m=o.quantities[a??-1]?.angle===!0;return z0(m?f(a):V0(f(a),f(l)))}function H0(n,e,t){let{size:i}=e,r=new Float64Array(i*i).fill(NaN),s=O0(i),o=Array.from({length:k0()},()=>el(n.model)),a=0,l=0,c=!1,u=async({engine:d})=>{for(;!c&&a<s.length;){let f=s.slice(a,a+hA);a+=f.length;let m=f.map(({column:g,row:p})=>[Kd(e.xRange,g,i),Kd(e.yRange,p,i)]),x=await dA(d,n,e,m,(f[0]?.side??1)>=uA).catch(()=>f.map(()=>NaN));if(c)return;f.forEach(({column:g,row:p},b)=>r[p*i+g]=x[b]??NaN),l+=f.length,t(f,l/s.length)}},h=()=>{c=!0;for(let d of o)d.end()};return{values:r,done:Promise.all(o.map(u)).then(h,h),stop:h}}var G0=[{value:"megno",text:"MEGNO"},{value:"lyapunov",text:"Lyapunov exponent"},{value:"rotation",text:"rotation number"}];function W0(n,e){let{engine:t,model:i}=n;if(t===null||i.wasm===null)return null;let r=mA(n);return r.length<2&&e===null?null:new jd(n,r,e)}var jd=class{constructor(e,t,i){this.lab=e;this.choices=t;this.section=i;this.setting=this.opening(),this.sheet=new hs({label:"Chart. Arrow keys move a cross, Enter shows the motion there, plus and minus change the range.",paint:(r,s)=>this.paint(r,s),click:r=>{this.show(r)},hover:r=>this.hover(r),whole:()=>this.wholeRange(),moved:()=>this.moved()}),this.go.addEventListener("click",()=>this.run===null?this.start():this.run.stop()),this.element=X("div",{},this.tools(),this.sheet.element,this.key),this.axes()}lab;choices;section;element;sheet;setting;drawn=null;run=null;go=X("button",{type:"button",class:"lab-button"},"Compute");bar=X("progress",{class:"lab-progress",max:1,value:0,"aria-label":"Share of the chart that is done",hidden:!0});key=X("div",{class:"lab-key"});due=0;shown(){this.sheet.repaint(),this.followSection()}async followSection(){if(this.section===null||this.setting.x!==null||this.drawn!==null||(await this.section.prepared(),this.setting.x!==null||this.drawn!==null))return;let{x:e,y:t}=this.sectionRange();this.setting={...this.setting,xRange:e,yRange:t},this.axes()}opening(){let[e,t]=this.choices,i=this.section!==null,r=[0,1],{x:s,y:o}=i?this.sectionRange():{x:e?.range??r,y:t?.range??r};return{kind:"megno",x:i?null:e?.name??null,y:i?null:t?.name??null,xRange:s,yRange:o,size:100,until:Math.max(100,this.lab.model.until)}}tools(){let e=this.choices.map(({name:a,text:l})=>({value:a,text:l})),t=this.section===null?[]:[{value:"",text:"point of the section"}],{setting:i}=this,r=(a,l)=>Ei(a,[...t,...e],i[l]??"",c=>this.choose(l,c===""?null:c)),s=X("input",{type:"text",inputmode:"decimal",class:"lab-field","aria-label":"Time up to which each motion is followed",value:String(i.until)});s.addEventListener("change",()=>{let a=Number(s.value);a>0&&Number.isFinite(a)?this.setting={...this.setting,until:a}:this.lab.say("The time must be a positive number.",!0)});let o=this.section===null?G0.slice(0,2):G0;return X("div",{class:"lab-tools",role:"toolbar","aria-label":"Chart"},Ei("of",o,i.kind,a=>this.setting={...this.setting,kind:a}),r("across","x"),r("up","y"),X("label",{class:"lab-choice"},"to t =",s),Ei("points",[50,100,200,400].map(a=>({value:String(a),text:`${a} × ${a}`})),String(i.size),a=>this.setting={...this.setting,size:Number(a)}),this.go,this.bar)}choose(e,t){let i=e==="x"?"y":"x",r={...this.setting,[e]:t};t===null?r[i]=null:r[i]===null&&(r[i]=this.choices.find(a=>a.name!==t)?.name??null),this.setting=r;let{x:s,y:o}=this.wholeRange();this.setting={...this.setting,xRange:s,yRange:o};for(let[a,l]of["x","y"].entries()){let c=this.element.querySelectorAll(".lab-tools select")[a+1];c&&(c.value=this.setting[l]??"")}this.drawn=null,this.axes(),this.followSection()}choice(e){return this.choices.find(t=>t.name===e)}wholeRange(){return this.setting.x===null?this.sectionRange():{x:this.choice(this.setting.x)?.range??[0,1],y:this.choice(this.setting.y)?.range??[0,1]}}sectionRange(){let e=[-1,1],t=this.section?.sheet.frame;return{x:t?.x.range??e,y:t?.y.range??e}}axes(){let e=(o,a)=>{let l=this.section?.setting();if(o!==null||l===void 0)return this.choice(o)?.text??"";let c=this.lab.model.quantities.find(u=>u.name===l[a]);return c?.mathml?si(c.mathml):l[a]},{x:t,y:i,xRange:r,yRange:s}=this.setting;this.sheet.setAxes({range:r,label:e(t,"x")},{range:s,label:e(i,"y")})}moved(){let{x:e,y:t}=this.sheet.frame;this.setting={...this.setting,xRange:e.range,yRange:t.range}}start(){let{state:e,experiment:t}=this.lab.shown.value;if(e===null)return;let i={...this.setting},r={model:this.lab.model,experiment:t,reference:e,section:this.section?.setting()??null,orbits:[...this.section?.orbits()??[]]},s=document.createElement("canvas");s.width=s.height=i.size,this.go.textContent="Stop",this.bar.hidden=!1,this.bar.value=0;let o=performance.now(),a=H0(r,i,(l,c)=>{this.bar.value=c;for(let{column:u,row:h,side:d}of l)this.block(u,h,d);this.due===0&&(this.due=window.setTimeout(()=>{this.due=0,this.colour()},60))});this.drawn={setting:i,ground:r,values:a.values,picture:s,scale:[0,1]},this.sides=new Uint8Array(i.size*i.size),this.run=a,a.done.then(()=>{this.run=null,this.go.textContent="Compute",this.bar.hidden=!0,this.colour();let l=(performance.now()-o)/1e3,c=a.values.reduce((u,h)=>u+(Number.isFinite(h)?1:0),0);this.lab.say(`${c} of ${a.values.length} points have a value; computed in ${bt(l,3)} s.`)})}sides=new Uint8Array(0);block(e,t,i){let{drawn:r}=this;r!==null&&(this.sides[t*r.setting.size+e]=i)}colour(){let{drawn:e}=this;if(e===null)return;let{size:t,kind:i}=e.setting,r=e.picture.getContext("2d");if(r===null)return;e.scale=i==="megno"?[2,Math.min(32,Math.max(4,Fc(e.values,.98)))]:[Fc(e.values,.02),Fc(e.values,.98)];let s=r.createImageData(t,t);for(let o of[16,8,4,2,1])for(let a=0;a<t;a+=o)for(let l=0;l<t;l+=o){if(this.sides[a*t+l]!==o)continue;let c=e.values[a*t+l]??NaN,u=Number.isFinite(c)?lc(Fs(),this.share(c)):null;for(let h=a;h<Math.min(t,a+o);h++)for(let d=l;d<Math.min(t,l+o);d++){let f=4*((t-1-h)*t+d);s.data.set(u===null?[0,0,0,0]:[...u,255],f)}}r.putImageData(s,0,0),this.writeKey(),this.sheet.repaint()}share(e){let{drawn:t}=this,[i,r]=t?.scale??[0,1];return t?.setting.kind==="megno"?Zd(e,r):r>i?(e-i)/(r-i):.5}writeKey(){let{drawn:e}=this;if(e===null)return;let[t,i]=e.setting.kind==="megno"?["MEGNO 2, regular",`${bt(e.scale[1],3)} and more`]:e.scale.map(s=>bt(s,3)),r=X("i",{style:`background:linear-gradient(90deg,${Fs().join(",")})`});this.key.replaceChildren(X("span",{},t??""),r,X("span",{},i??""),X("span",{},"blank: no such motion"))}paint(e,t){let{drawn:i}=this;if(i===null){e.fillStyle=nn().quiet,e.font=`${t.letter}px ${ko}`,e.textAlign="center",e.fillText("Choose the axes and press Compute",t.width/2,t.height/2);return}let{xRange:r,yRange:s}=i.setting,[o,a]=r.map(u=>t.right(u)),[l,c]=s.map(u=>t.down(u));e.save(),e.beginPath(),e.rect(t.right(t.x.range[0]),t.down(t.y.range[1]),t.innerWidth,t.innerHeight),e.clip(),e.imageSmoothingEnabled=!1,e.drawImage(i.picture,o,c,a-o,l-c),e.restore()}cell(e){let{drawn:t}=this;if(t===null)return null;let{size:i,xRange:r,yRange:s}=t.setting,o=Math.floor((e.x-r[0])/(r[1]-r[0])*i),a=Math.floor((e.y-s[0])/(s[1]-s[0])*i);return o<0||a<0||o>=i||a>=i?null:{index:a*i+o,x:e.x,y:e.y}}hover(e){let t=this.cell(e);if(t===null||this.drawn===null)return null;let i=this.drawn.values[t.index]??NaN,r=`${this.sheet.frame.x.label} = ${bt(e.x)}, ${this.sheet.frame.y.label} = ${bt(e.y)}`,{kind:s}=this.drawn.setting;return Number.isFinite(i)?`${r}: ${s==="megno"?Qa(i):s==="lyapunov"?`exponent ${bt(i,3)}`:`rotation number ${bt(i,6)}`}`:`${r}: no value`}async show(e){let{engine:t}=this.lab,{drawn:i}=this;if(t===null||i===null)return;let r=await Jd(t,i.ground,i.setting,e.x,e.y);if("message"in r)return this.lab.say(r.message,!0);await this.lab.change({...r.experiment,until:this.lab.wanted.value.until}),this.lab.clock.seek(0)}};function mA({model:n}){let e=(r,s,o)=>{let a=r?si(r):s;return Wn(o)?`${a}  (${Wn(o)})`:a},t=sc(n).map(({name:r,mathml:s,unit:o,value:a,low:l,high:c})=>({name:r,value:a,text:e(s,r,o),range:[l,c]})),i=n.parameters.map(({name:r,mathml:s,unit:o,value:a,low:l,high:c})=>({name:r,value:a,text:e(s,r,o),range:Ic(a,l,c)}));return[...t,...i]}function zs(n){return{parameters:{},start:{inputs:{}},until:n.until}}function Qd(n,e){return JSON.stringify(q0(n))===JSON.stringify(q0(e))}function q0({parameters:n,start:e,until:t}){let i=r=>Object.entries(r).sort(([s],[o])=>s<o?-1:1);return[i(n),"state"in e?e.state:i(e.inputs),t]}function Bc(n,e){return Float64Array.from({length:e},(t,i)=>n*i/Math.max(1,e-1))}function ef(n,e,t){let i=new URLSearchParams;for(let[s,o]of Object.entries(n.parameters))i.set(`p.${s}`,String(o));if("state"in n.start)i.set("state",n.start.state.join(" "));else for(let[s,o]of Object.entries(n.start.inputs))i.set(`s.${s}`,String(o));n.until!==e.until&&i.set("until",String(n.until));for(let[s,o]of Object.entries(t))i.set(s,o);let r=i.toString();return r===""?"":`#lab&${r}`}function X0(n,e){if(!n.startsWith("#lab&"))return null;let t={parameters:{},inputs:{}},i=null,r=e.until,s={};for(let[a,l]of new URLSearchParams(n.slice(5))){let c=Number(l),u=a.slice(2);if(a.startsWith("p.")){if(!Number.isFinite(c)||!e.parameters.some(h=>h.name===u))return null;t.parameters[u]=c}else if(a.startsWith("s.")){if(!Number.isFinite(c)||!e.start_inputs.some(h=>h.name===u))return null;t.inputs[u]=c}else if(a==="state"){if(i=l.split(/[ +]/).map(Number),i.length!==e.state.length||!i.every(Number.isFinite))return null}else if(a==="until"){if(!(c>0)||!Number.isFinite(c))return null;r=c}else s[a]=l}let o=i===null?{inputs:t.inputs}:{state:i};return{experiment:{parameters:t.parameters,start:o,until:r},choices:s}}function tf(n,e,t,i){let{[e]:r,...s}=n;return t===i?s:{...s,[e]:t}}var Nc=class{constructor(e=200){this.longest=e}longest;past=[];future=[];push(e){this.past.push(e),this.past.length>this.longest&&this.past.shift(),this.future=[]}undo(e){let t=this.past.pop();return t!==void 0&&this.future.push(e),t}redo(e){let t=this.future.pop();return t!==void 0&&this.past.push(e),t}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}};function Z0(n){let{model:e}=n;if(n.engine===null)return X("p",{class:"lab-hint"},"This page plays the motion that was computed for it: under friction the equations change at events, so there are no sliders here. To change start or parameters, edit the experiment file (among what can be saved) and run it.");let t=gA(e),i=sc(e).map(l=>{let c=Pc({...l,symbol:Y0(l)},()=>n.mark(),u=>{let h=Da(n),d=tf(h,l.name,u,t.inputs.get(l.name)??NaN);n.change({...n.wanted.value,start:{inputs:d}},!1)});return[l.name,c]}),r=e.parameters.map(l=>{let[c,u]=Ic(l.value,l.low,l.high),h=Pc({...l,symbol:Y0(l),low:c,high:u},()=>n.mark(),d=>{n.changeParameters(tf(n.wanted.value.parameters,l.name,d,l.value))});return[l.name,h]}),s=Pc({name:"until",symbol:document.createTextNode("until"),meaning:"Duration of the motion",unit:"s",value:e.until,low:e.until/20,high:5*e.until},()=>n.mark(),l=>{l>0?n.change({...n.wanted.value,until:l},!1):n.say("The duration must be positive.",!0)}),o=X("p",{class:"lab-hint",hidden:!0},"This start was chosen in a section or chart; a slider takes it from here.");n.wanted.watch(l=>{for(let[c,u]of r)u.set(l.parameters[c]??t.parameters.get(c)??0);s.set(l.until)}),n.shown.watch(()=>{let l=Da(n);o.hidden=!("state"in n.wanted.value.start);for(let[c,u]of i)u.set(l[c]??t.inputs.get(c)??0)}),n.wanted.after(l=>{if(!("state"in l.start))for(let[c,u]of i)u.set(l.start.inputs[c]??t.inputs.get(c)??0)});let a=X("button",{type:"button",class:"lab-button"},"As at first");return a.addEventListener("click",()=>{n.change(zs(e))}),X("div",{class:"lab-sliders"},$0("Start",!0,i,o),$0("Parameters",r.length<=6||innerWidth>620,r,null),X("details",{open:!0},X("summary",{},"Run"),s.element,a))}function $0(n,e,t,i){return t.length===0?null:X("details",{open:e},X("summary",{},n),...t.map(([,r])=>r.element),i)}function Y0({mathml:n,name:e}){return n?zi(n):document.createTextNode(e.replaceAll("_"," "))}function gA(n){return{inputs:new Map(n.start_inputs.map(e=>[e.name,e.value])),parameters:new Map(n.parameters.map(e=>[e.name,e.value]))}}function nf(n){let e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i++)t[i]=e.charCodeAt(i);return t}function rf(n){return new Float64Array(nf(n).buffer)}function Uo(n){return new Float32Array(nf(n).buffer)}function K0(n){return new Uint32Array(nf(n).buffer)}function J0(n,e){let t=new Float64Array(3*n.length*e.length),i=0;for(let r=0;r<n.length;r++)for(let s=0;s<e.length;s++){let o=Math.sin(n[r]);t[i++]=o*Math.cos(e[s]),t[i++]=o*Math.sin(e[s]),t[i++]=Math.cos(n[r])}return t}function j0(n,e){let{theta:t,phi:i,hollow:r}=n,s=t.length,o=i.length,a=J0(t,i),l=r?1:-1,c=s*o,u=c+2*(o+1),h=new Float32Array(3*u),d=new Float32Array(3*u);for(let p=0;p<3*c;p++)h[p]=e[p],d[p]=l*a[p];let f=[],m=[],x=(p,b,E,v)=>{xA(h,d,p,b,E)||([b,E]=[E,b]),f.push(p,b,E),m.push(v)},g=p=>Math.floor((i[p]+1e-9)/(Math.PI/2));for(let p=0;p+1<s;p++){let b=(t[p]+t[p+1])/2<Math.PI/2?1:0;for(let E=0;E<o;E++){let v=(E+1)%o,C=(g(E)+b)%2;x(p*o+E,p*o+v,(p+1)*o+v,C),x(p*o+E,(p+1)*o+v,(p+1)*o+E,C)}}for(let p of[!0,!1]){let b=(p?0:s-1)*o,E=c+(p?0:o+1),v=E+o,C=l*(p?1:-1);for(let T=0;T<o;T++){for(let y=0;y<3;y++){let M=h[3*(b+T)+y];h[3*(E+T)+y]=M,h[3*v+y]+=M/o}d[3*(E+T)+2]=C}d[3*v+2]=C;for(let T=0;T<o;T++)x(v,E+T,E+(T+1)%o,(g(T)+(p?1:0))%2)}return{positions:h,normals:d,indices:Uint32Array.from(f),tones:Uint8Array.from(m),hollow:r}}function xA(n,e,t,i,r){let s=[0,1,2].map(l=>n[3*i+l]-n[3*t+l]),o=[0,1,2].map(l=>n[3*r+l]-n[3*t+l]),a=0;for(let l=0;l<3;l++){let c=(l+1)%3,u=(l+2)%3,h=e[3*t+l]+e[3*i+l]+e[3*r+l];a+=(s[c]*o[u]-s[u]*o[c])*h}return a>=0}function Dc({scene:n}){return{body:n.body===null?null:j0(n.body,Uo(n.body.positions)),inertia:null,ground:yA(n.support)}}function yA(n){return n?.kind!=="mesh"?null:{positions:Uo(n.positions),normals:Uo(n.normals),indices:K0(n.indices)}}var Wi=class{constructor(e){this.current=e}current;watchers=new Set;get value(){return this.current}set value(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.watchers])t(e)}}watch(e){return e(this.current),this.after(e)}after(e){return this.watchers.add(e),()=>this.watchers.delete(e)}};function Q0(n){let e=!1,t=null,i=async()=>{for(e=!0;t!==null;){let{argument:r,resolve:s,reject:o}=t;t=null;try{let a=await n(r);s(t===null?a:void 0)}catch(a){o(a)}}e=!1};return r=>new Promise((s,o)=>{t?.resolve(void 0),t={argument:r,resolve:s,reject:o},e||i()})}var zo=[.02,.05,.1,.25,.5,1,2,5,10],kc=class{time=new Wi(0);playing=new Wi(!1);speed=new Wi(1);end=1;frame=0;before=0;set until(e){this.end=e,this.time.value>e&&(this.time.value=e)}get until(){return this.end}play(){this.playing.value||(this.time.value>=this.end&&(this.time.value=0),this.playing.value=!0,this.before=0,this.frame=requestAnimationFrame(this.step))}pause(){this.playing.value&&(cancelAnimationFrame(this.frame),this.playing.value=!1)}toggle(){this.playing.value?this.pause():this.play()}seek(e){this.time.value=Math.min(Math.max(e,0),this.end)}changeSpeed(e){let t=zo.findIndex(i=>i>=this.speed.value-1e-9);this.speed.value=zo[Math.min(Math.max(t+e,0),zo.length-1)]??1}step=e=>{if(!this.playing.value)return;let t=this.before===0?0:Math.min(.1,(e-this.before)/1e3);this.before=e;let i=this.time.value+t*this.speed.value;this.time.value=i>=this.end?0:i,this.frame=requestAnimationFrame(this.step)}};function ex(n){if(n>=4&&n<=90)return 1;let e=n<4?n/8:n/40;return zo.reduce((t,i)=>Math.abs(Math.log(i/e))<Math.abs(Math.log(t/e))?i:t)}var Oc=class{constructor(e,t,i){this.model=e;this.engine=t;this.shown=new Wi(i),this.wanted=new Wi(i.experiment),this.compute=Q0(r=>Uc(e,t,r)),this.clock.until=i.motion.times.at(-1)??0,this.clock.speed.value=ex(this.clock.until)}model;engine;clock=new kc;shown;message=new Wi("");refused=new Wi(!1);history=new Nc;wanted;compute;async change(e,t=!0){return Qd(e,this.wanted.value)?!0:(t&&this.history.push(this.wanted.value),this.request(e))}mark(){this.history.push(this.wanted.value)}async undo(){let e=this.history.undo(this.wanted.value);e!==void 0&&await this.request(e)}async redo(){let e=this.history.redo(this.wanted.value);e!==void 0&&await this.request(e)}async changeParameters(e){let t=this.wanted.value,i=this.givenNumbers(t),r=i===null||this.engine===null?null:await this.engine.startFrom({parameters:e,inputs:i});if(r===null||!("nearest"in r)||r.nearest===void 0)return void this.change({...t,parameters:e},!1);let s=[...r.nearest],o={inputs:Object.fromEntries(this.model.start_inputs.map(({name:a},l)=>[a,s[l]??NaN]))};await this.change({...t,parameters:e,start:o},!1)&&this.say("With these parameters there is no motion from the start that was given; the nearest admissible one is taken.")}givenNumbers({start:e}){if("inputs"in e)return e.inputs;let{state:t,start_inputs:i}=this.model,r=i.map(({name:s})=>t.findIndex(o=>o.name===s));return r.some(s=>s<0)?null:Object.fromEntries(i.map(({name:s},o)=>[s,e.state[r[o]??0]??NaN]))}say(e,t=!1){this.refused.value=t,this.message.value=e}async request(e){this.wanted.value=e;let t;try{t=await this.compute(e)}catch(r){t=r instanceof Error?r.message:String(r)}if(t===void 0)return!1;if(typeof t=="string")return this.say(t,!0),!1;let i=t.motion.end;return this.say(i===null?"":`The motion ends at t = ${i.time.toPrecision(4)}: ${i.reason}.`,i!==null),this.clock.until=t.motion.times.at(-1)??0,this.shown.value=t,!0}};async function Uc(n,e,t){if(e===null)return n.recorded===null?"This page holds no motion and cannot compute one.":Qd(t,zs(n))?{experiment:t,motion:sf(n),state:Float64Array.from(n.start),surfaces:Dc(n)}:"This page shows a recorded motion and cannot compute another.";let i=await _A(e,t);if("message"in i)return i.message;let{parameters:r,until:s}=t,[o,a]=await Promise.all([e.motion({parameters:r,start:i.state,times:Bc(s,bA(n,s))}),e.surfaces(r)]);return{experiment:t,motion:o,state:i.state,surfaces:a}}async function _A(n,e){let{start:t,parameters:i}=e;return"state"in t?{state:Float64Array.from(t.state)}:n.startFrom({parameters:i,inputs:t.inputs})}function bA(n,e){let t=Math.round((n.samples-1)*e/n.until)+1;return Math.min(20001,Math.max(601,n.samples,t))}function sf(n){let e=n.recorded;if(e===null)return{times:new Float64Array(1),columns:{},end:null};let t=Object.fromEntries(Object.entries(e.columns).map(([i,r])=>[i,rf(r)]));return{times:rf(e.times),columns:t,end:e.end}}var vA=[["proven","✓"],["refuted","✗"],["undecided","?"],["not tried","–"]];function tx(n,e){let{motion:t}=n.shown.value;return n.model.laws.map(({name:i,verdict:r,column:s})=>({name:i,verdict:r,value:s===null?null:mi(t,s,1,e)?.[0]??null,drift:s===null?null:nx(t,s)}))}function nx(n,e){let t=n.columns[e];if(t===void 0)return null;let i=t[0]??NaN,r=0;for(let s of t){let o=Math.abs(s-i);o>r&&(r=o)}return r}function wA({verdict:n,text:e}){let[t,i]=vA.find(([r])=>n.startsWith(r))??["undecided","?"];return X("span",{class:`lab-verdict lab-${t.replace(" ","-")}`,title:e},`${i} ${n}`)}function ix(n){let{laws:e,columns:t}=n.model;if(e.length===0)return null;let i=new Map(t.map(({name:o,unit:a})=>[o,Wn(a)])),r=e.map(o=>{let a=X("span",{class:"lab-number"}),l=X("span",{class:"lab-number"}),c=wA(o),u=o.column===null?null:X("p",{class:"lab-law-numbers"},X("span",{},"now ",a),X("span",{},"drift ",l)),h=X("li",{},X("p",{class:"lab-law-head"},X("strong",{},o.meaning||o.name),c,X("span",{class:"lab-source"},o.source)),X("div",{class:"lab-formula",tabindex:0,role:"group","aria-label":`Formula of ${o.meaning||o.name}`},zi(o.mathml)),u);return{law:o,value:a,away:l,made:h}}),s=()=>{for(let{law:o,value:a}of r){if(o.column===null)continue;let l=mi(n.shown.value.motion,o.column,1,n.clock.time.value)?.[0]??NaN;a.textContent=`${bt(l,7)} ${i.get(o.column)??""}`}};return n.clock.time.after(s),n.shown.watch(({motion:o})=>{for(let{law:a,away:l}of r)a.column!==null&&(l.textContent=bt(nx(o,a.column)??NaN,2));s()}),X("ul",{class:"lab-laws"},...r.map(({made:o})=>o))}function tl(n,e,t,i){let r=0;for(let s=0;s+2<n.length;s+=3){let[o,a,l]=[n[s]??0,n[s+1]??0,n[s+2]??0],c=Math.hypot(o,a,l);c>0&&(r=Math.max(r,Math.acos(Math.min(1,Math.max(-1,e*l/c)))))}return r+t<i?r+t:Math.PI}function Vs(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i++){let r=n[i]??NaN,s=i%3;r<e[s]&&(e[s]=r),r>t[s]&&(t[s]=r)}return{low:e,high:t}}function sx({azimuth:n,elevation:e,distance:t,target:i},r){return[n,e,t,...r?i:[]].map(s=>Number(s.toPrecision(5))).join(" ")}function ox(n,e){let t=n.split(/[ +]/).map(Number),i=t.length===6;if(!(i||t.length===3)||!t.every(Number.isFinite)||!((t[2]??0)>0))return null;let[r=0,s=0,o=1,...a]=t;return{view:{azimuth:r,elevation:s,distance:o,target:i?a:e},moved:i}}var rx=Math.PI/2-.02,zc=30*Math.PI/180;function ax({azimuth:n,elevation:e}){let t=Math.cos(e);return[t*Math.cos(n),t*Math.sin(n),Math.sin(e)]}function lx(n){let e=ax(n);return n.target.map((t,i)=>t+n.distance*(e[i]??0))}function Vc(n,e,t){return{...n,azimuth:n.azimuth-Math.PI*e,elevation:Math.min(Math.max(n.elevation+Math.PI*t,-rx),rx)}}function nl(n,e){return{...n,distance:Math.min(Math.max(n.distance*e,.8),4e3)}}function af(n,e,t){let i=2*n.distance*Math.tan(zc/2),{azimuth:r,elevation:s}=n,o=[-Math.sin(r),Math.cos(r),0],a=[-Math.sin(s)*Math.cos(r),-Math.sin(s)*Math.sin(r),Math.cos(s)];return{...n,target:n.target.map((l,c)=>l+i*(t*(a[c]??0)-e*(o[c]??0)))}}function Vo(n,e,t,i){let s=ax({azimuth:e,elevation:t,distance:1,target:[0,0,0]}),o=[-Math.sin(e),Math.cos(e),0],a=[-Math.sin(t)*Math.cos(e),-Math.sin(t)*Math.sin(e),Math.cos(t)],l=Math.tan(zc/2)*SA,c=l*i,u={x:0,y:0},h=1;for(let f=0;f<3;f++){let m={left:1/0,right:-1/0,low:1/0,high:-1/0},x=1;for(let g=0;g+2<n.length;g+=3){let p=[n[g]??0,n[g+1]??0,n[g+2]??0],[b,E,v]=[of(p,o)-u.x,of(p,a)-u.y,of(p,s)];x=Math.max(x,v+Math.max(Math.abs(b)/c,Math.abs(E)/l));let C=f===0?1:h/Math.max(1e-6,h-v);m.left=Math.min(m.left,b*C),m.right=Math.max(m.right,b*C),m.low=Math.min(m.low,E*C),m.high=Math.max(m.high,E*C)}if(h=x,f===2)break;u.x+=(m.left+m.right)/2,u.y+=(m.low+m.high)/2}let d=[0,1,2].map(f=>u.x*(o[f]??0)+u.y*(a[f]??0));return{azimuth:e,elevation:t,distance:h,target:d}}var SA=.92;function of(n,e){return n[0]*e[0]+n[1]*e[1]+n[2]*e[2]}function Hc(n){let e=Math.floor(n.length/3),[t,i]=[0,0];for(let h=0;h<e;h++)t+=(n[3*h]??0)/e,i+=(n[3*h+1]??0)/e;let[r,s,o]=[0,0,0];for(let h=0;h<e;h++){let[d,f]=[(n[3*h]??0)-t,(n[3*h+1]??0)-i];r+=d*d,s+=d*f,o+=f*f}if(!(r+o>0))return 0;let a=.5*Math.atan2(2*s,r-o),l=e-1,u=Math.cos(a)*((n[3*l]??0)-(n[0]??0))+Math.sin(a)*((n[3*l+1]??0)-(n[1]??0))<0?-1:1;return Math.atan2(-u*Math.cos(a),u*Math.sin(a))}var AA=10;function lf(n,e,t,i=1.6){let r=hx(n,e).map(c=>c/t),{support:s}=n,o=[...ux(cx(n,e,r,t)),...r];if(s?.kind==="sphere"){let c=Math.abs(s.radius)/t,{azimuth:u,elevation:h}=TA(r,s.inside),d=s.inside?tl(r,-1,.3,1.75):tl(r,1,Math.max(.12,.75/c),1.2);return Vo([...o,...MA(c,s.inside,d)],u,h,i)}if(s?.kind==="mesh")return Vo([...o,...Uo(s.positions).map(c=>c/t)],Hc(r)+.3,.5,i);if(s?.kind==="point"||s===null&&n.path===null)return Vo(o,.6,.35,i);let a=Hc(r)+.42;if(!cf(n,e))return Vo(o,a,.5,i);let l=[...ux(cx(n,e,r,t).slice(0,3))].map((c,u)=>c+(u%3<2?1.1*Math.sign(c-(r[u%3]??0)):0));return Vo(l,a,.5,i)}function cx(n,e,t,i){let r=os(e,"centre",3);return n.path!==null||r===0?t:(e.columns.centre??t).slice(0,3*r).map(s=>s/i)}function*ux(n){let e=n.length/3,t=Math.max(1,Math.floor(e/60));for(let i=0;i<e;i+=t)for(let r=0;r<8;r++)for(let s=0;s<3;s++)yield(n[3*i+s]??0)+(r>>s&1?.45:-.45)}function*MA(n,e,t){for(let i=1;i<=6;i++){let r=t*i/6;for(let s=0;s<24;s++){let o=Math.PI*s/12;yield n*Math.sin(r)*Math.cos(o),yield n*Math.sin(r)*Math.sin(o),yield(e?-1:1)*n*Math.cos(r)}}}function cf(n,e){if(n.support?.kind!=="plane"&&n.path===null)return!1;let t=hx(n,e);if(t.length===0)return!1;let{low:i,high:r}=Vs(t);return Math.hypot(r[0]-i[0],r[1]-i[1])>AA*n.size}function TA(n,e){let t=[0,1,2].map(a=>{let l=0;for(let c=a;c<n.length;c+=3)l+=n[c]??0;return 3*l/Math.max(3,n.length)+.8*(n[n.length-3+a]??0)}),i=Math.hypot(...t)||1,r=Math.asin(Math.min(1,Math.max(-1,(t[2]??0)/i))),s=Math.hypot(t[0]??0,t[1]??0)<.35*i,o=s?Hc(n):Math.atan2(t[1]??0,t[0]??0)+.35;return e?{azimuth:o+(s?0:Math.PI),elevation:r<-.3?.62:.35}:{azimuth:o,elevation:Math.min(.6,Math.max(-.25,.6*r))}}function hx(n,e){if(n.path!==null)return hf(n,e);let t=e.columns.contact?"contact":"centre",i=os(e,t,3),r=(e.columns[t]??new Float64Array(0)).slice(0,3*i);return r.length>0?r:new Float64Array(3)}function uf(n,e){if(n.length===0)return 3;let{low:t,high:i}=Vs(n);return 2.2+Math.hypot(i[0]-t[0],i[1]-t[1])/e}function hf(n,e){let t=n.path??"",i=os(e,t,2),r=e.columns[t],s=new Float64Array(3*i);for(let o=0;o<i;o++)s.set([r?.[2*o]??0,r?.[2*o+1]??0,0],3*o);return s}function dx(n,e,t){let i=new Map,r=()=>{let[o,a]=[...i.values()];return o&&a?Math.hypot(o.x-a.x,o.y-a.y):0};n.addEventListener("pointerdown",o=>{i.set(o.pointerId,{x:o.clientX,y:o.clientY}),n.setPointerCapture(o.pointerId)}),n.addEventListener("pointermove",o=>{let a=i.get(o.pointerId);if(a===void 0)return;let l=n.clientHeight||1,c=(o.clientX-a.x)/l,u=(o.clientY-a.y)/l;if(i.size===2){let d=r();i.set(o.pointerId,{x:o.clientX,y:o.clientY});let f=r();d>0&&f>0&&(e.view=nl(e.view,d/f)),e.view=af(e.view,c/2,u/2),t(!0);return}i.set(o.pointerId,{x:o.clientX,y:o.clientY});let h=o.shiftKey||o.buttons===2||o.buttons===4;e.view=h?af(e.view,c,u):Vc(e.view,c,u),t(h)});let s=o=>{i.delete(o.pointerId)};n.addEventListener("pointerup",s),n.addEventListener("pointercancel",s),n.addEventListener("contextmenu",o=>o.preventDefault()),n.addEventListener("wheel",o=>{!n.matches(":focus-within")&&!o.ctrlKey||(o.preventDefault(),e.view=nl(e.view,Math.exp(.0015*o.deltaY)),t(!1))},{passive:!1})}var kx=0,Vf=1,Ox=2;var Xs=1,Ux=2,ua=3,ci=0,fn=1,Ni=2,$s=0,ha=1,Hf=2,Gf=3,Wf=4,zx=5;var Ys=100,Vx=101,Hx=102,Gx=103,Wx=104,qx=200,Xx=201,$x=202,Yx=203,qf=204,Xf=205,Zx=206,Kx=207,Jx=208,jx=209,Qx=210,ey=211,ty=212,ny=213,iy=214,hu=0,du=1,fu=2,na=3,pu=4,mu=5,gu=6,xu=7,Il=0,ry=1,sy=2,Mr=0,$f=1,Yf=2,Zf=3,Kf=4,Jf=5,jf=6,Qf=7;var ep=300,Zs=301,da=302,Gu=303,Wu=304,yu=1e3,vr=1001,_u=1002,On=1003,oy=1004;var Ll=1005;var ii=1006,qu=1007;var Zr=1008;var ui=1009,tp=1010,np=1011,fa=1012,Xu=1013,Zi=1014,Ki=1015,Ji=1016,$u=1017,Yu=1018,Ks=1020,ip=35902,rp=35899,sp=1021,op=1022,ji=1023,Gr=1026,Kr=1027,ap=1028,Zu=1029,Ms=1030,Ku=1031;var Ju=1033,Fl=33776,Nl=33777,Bl=33778,Dl=33779,ju=35840,Qu=35841,eh=35842,th=35843,nh=36196,ih=37492,rh=37496,sh=37488,oh=37489,kl=37490,ah=37491,lh=37808,ch=37809,uh=37810,hh=37811,dh=37812,fh=37813,ph=37814,mh=37815,gh=37816,xh=37817,yh=37818,_h=37819,bh=37820,vh=37821,wh=36492,Sh=36494,Ah=36495,Mh=36283,Th=36284,Ol=36285,Eh=36286;var ll=2300,bu=2301,cu=2302,Nf=2303,Bf=2400,Df=2401,kf=2402;var ay=3200;var Ul=0,ly=1,Jr="",_i="srgb",cl="srgb-linear",ul="linear",Lt="srgb";var uu=7680;var cy=519,uy=512,hy=513,dy=514,lp=515,fy=516,py=517,cp=518,up=519,hp=35044;var dp="300 es",Li=2e3,ia=2001;function EA(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function CA(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function hl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function my(){let n=hl("canvas");return n.style.display="block",n}var fx={},ra=null;function dl(...n){let e="THREE."+n.shift();ra?ra("log",e,...n):console.log(e,...n)}function gy(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function et(...n){n=gy(n);let e="THREE."+n.shift();if(ra)ra("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function rt(...n){n=gy(n);let e="THREE."+n.shift();if(ra)ra("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function al(...n){let e=n.join(" ");e in fx||(fx[e]=!0,et(...n))}function xy(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var yy={[hu]:hu,[fu]:gu,[pu]:pu,[na]:mu,[du]:du,[gu]:fu,[xu]:xu,[mu]:na},wr=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var df=Math.PI/180,vu=180/Math.PI;function Js(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function Mt(n,e,t){return Math.max(e,Math.min(t,n))}function RA(n,e){return(n%e+e)%e}function ff(n,e,t){return(1-t)*n+t*e}function _y(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Ch(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function by(n,e){if(e.constructor===Float32Array)return n;let t=Ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function vy(n,e){if(e.constructor===Float32Array)return n;let t=Ch(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var dt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Fi=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],u=i[r+2],h=i[r+3],d=s[o+0],f=s[o+1],m=s[o+2],x=s[o+3];if(h!==x||l!==d||c!==f||u!==m){let g=l*d+c*f+u*m+h*x;g<0&&(d=-d,f=-f,m=-m,x=-x,g=-g);let p=1-a;if(g<.9995){let b=Math.acos(g),E=Math.sin(b);p=Math.sin(p*b)/E,a=Math.sin(a*b)/E,l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+x*a}else{l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+x*a;let b=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=b,c*=b,u*=b,h*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],u=i[r+3],h=s[o],d=s[o+1],f=s[o+2],m=s[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(r/2),h=a(s/2),d=l(i/2),f=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:et("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(s-c)*f,this._z=(o-r)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(r+o)/f,this._z=(s+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(s-c)/f,this._x=(r+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-r)/f,this._x=(s+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-i*c,this._z=s*u+o*c+i*l-r*a,this._w=o*u-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(px.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(px.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),u=2*(a*t-s*r),h=2*(s*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return pf.copy(this).projectOnVector(e),this.sub(pf)}reflect(e){return this.sub(pf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},pf=new Z,px=new Fi,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],x=r[0],g=r[3],p=r[6],b=r[1],E=r[4],v=r[7],C=r[2],T=r[5],y=r[8];return s[0]=o*x+a*b+l*C,s[3]=o*g+a*E+l*T,s[6]=o*p+a*v+l*y,s[1]=c*x+u*b+h*C,s[4]=c*g+u*E+h*T,s[7]=c*p+u*v+h*y,s[2]=d*x+f*b+m*C,s[5]=d*g+f*E+m*T,s[8]=d*p+f*v+m*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*s*u+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*s,f=c*s-o*l,m=t*h+i*d+r*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/m;return e[0]=h*x,e[1]=(r*c-u*i)*x,e[2]=(a*i-r*o)*x,e[3]=d*x,e[4]=(u*t-r*l)*x,e[5]=(r*s-a*t)*x,e[6]=f*x,e[7]=(i*l-c*t)*x,e[8]=(o*t-i*s)*x,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return al("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(mf.makeScale(e,t)),this}rotate(e){return al("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(mf.makeRotation(-e)),this}translate(e,t){return al("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(mf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},mf=new st,mx=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),gx=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function PA(){let n={enabled:!0,workingColorSpace:cl,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Lt&&(r.r=Hr(r.r),r.g=Hr(r.g),r.b=Hr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(r.r=ta(r.r),r.g=ta(r.g),r.b=ta(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Jr?ul:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[cl]:{primaries:e,whitePoint:i,transfer:ul,toXYZ:mx,fromXYZ:gx,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:_i},outputColorSpaceConfig:{drawingBufferColorSpace:_i}},[_i]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:mx,fromXYZ:gx,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:_i}}}),n}var wt=PA();function Hr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ta(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ho,wu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Ho===void 0&&(Ho=hl("canvas")),Ho.width=e.width,Ho.height=e.height;let r=Ho.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=Ho}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=hl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=Hr(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Hr(t[i]/255)*255):t[i]=Hr(t[i]);return{data:t,width:e.width,height:e.height}}else return et("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},IA=0,sa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:IA++}),this.uuid=Js(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(gf(r[o].image)):s.push(gf(r[o]))}else s=gf(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function gf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?wu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(et("Texture: Unable to serialize Texture."),{})}var LA=0,xf=new Z,ai=class n extends wr{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=vr,r=vr,s=ii,o=Zr,a=ji,l=ui,c=n.DEFAULT_ANISOTROPY,u=Jr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:LA++}),this.uuid=Js(),this.name="",this.source=new sa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new dt(0,0),this.repeat=new dt(1,1),this.center=new dt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(xf).x}get height(){return this.source.getSize(xf).y}get depth(){return this.source.getSize(xf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){et(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==ep)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case yu:e.x=e.x-Math.floor(e.x);break;case vr:e.x=e.x<0?0:1;break;case _u:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case yu:e.y=e.y-Math.floor(e.y);break;case vr:e.y=e.y<0?0:1;break;case _u:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ai.DEFAULT_IMAGE=null;ai.DEFAULT_MAPPING=ep;ai.DEFAULT_ANISOTROPY=1;var en=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],x=l[2],g=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-x)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+x)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,v=(f+1)/2,C=(p+1)/2,T=(u+d)/4,y=(h+x)/4,M=(m+g)/4;return E>v&&E>C?E<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(E),r=T/i,s=y/i):v>C?v<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(v),i=T/r,s=M/r):C<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(C),i=y/s,r=M/s),this.set(i,r,s,t),this}let b=Math.sqrt((g-m)*(g-m)+(h-x)*(h-x)+(d-u)*(d-u));return Math.abs(b)<.001&&(b=1),this.x=(g-m)/b,this.y=(h-x)/b,this.z=(d-u)/b,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this.w=Mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this.w=Mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Su=class extends wr{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ii,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new en(0,0,e,t),this.scissorTest=!1,this.viewport=new en(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ai({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new sa(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends Su{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},fl=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=On,this.minFilter=On,this.wrapR=vr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Au=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=On,this.minFilter=On,this.wrapR=vr,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Qt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,u,h,d,f,m,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,u,h,d,f,m,x,g)}set(e,t,i,r,s,o,a,l,c,u,h,d,f,m,x,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=m,p[11]=x,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/Go.setFromMatrixColumn(e,0).length(),s=1/Go.setFromMatrixColumn(e,1).length(),o=1/Go.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-x*c,t[9]=-a*l,t[2]=x-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d+x*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=x+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,x=c*h;t[0]=d-x*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=x-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,x=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+x,t[1]=l*h,t[5]=x*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=x-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-x*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,x=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+x,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=x*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(FA,e,NA)}lookAt(e,t,i){let r=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),ds.crossVectors(i,xi),ds.lengthSq()===0&&(Math.abs(i.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),ds.crossVectors(i,xi)),ds.normalize(),Gc.crossVectors(xi,ds),r[0]=ds.x,r[4]=Gc.x,r[8]=xi.x,r[1]=ds.y,r[5]=Gc.y,r[9]=xi.y,r[2]=ds.z,r[6]=Gc.z,r[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],x=i[6],g=i[10],p=i[14],b=i[3],E=i[7],v=i[11],C=i[15],T=r[0],y=r[4],M=r[8],B=r[12],L=r[1],I=r[5],D=r[9],U=r[13],F=r[2],H=r[6],W=r[10],V=r[14],ae=r[3],$=r[7],j=r[11],te=r[15];return s[0]=o*T+a*L+l*F+c*ae,s[4]=o*y+a*I+l*H+c*$,s[8]=o*M+a*D+l*W+c*j,s[12]=o*B+a*U+l*V+c*te,s[1]=u*T+h*L+d*F+f*ae,s[5]=u*y+h*I+d*H+f*$,s[9]=u*M+h*D+d*W+f*j,s[13]=u*B+h*U+d*V+f*te,s[2]=m*T+x*L+g*F+p*ae,s[6]=m*y+x*I+g*H+p*$,s[10]=m*M+x*D+g*W+p*j,s[14]=m*B+x*U+g*V+p*te,s[3]=b*T+E*L+v*F+C*ae,s[7]=b*y+E*I+v*H+C*$,s[11]=b*M+E*D+v*W+C*j,s[15]=b*B+E*U+v*V+C*te,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],x=e[7],g=e[11],p=e[15],b=l*f-c*d,E=a*f-c*h,v=a*d-l*h,C=o*f-c*u,T=o*d-l*u,y=o*h-a*u;return t*(x*b-g*E+p*v)-i*(m*b-g*C+p*T)+r*(m*E-x*C+p*y)-s*(m*v-x*T+g*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],x=e[13],g=e[14],p=e[15],b=t*a-i*o,E=t*l-r*o,v=t*c-s*o,C=i*l-r*a,T=i*c-s*a,y=r*c-s*l,M=u*x-h*m,B=u*g-d*m,L=u*p-f*m,I=h*g-d*x,D=h*p-f*x,U=d*p-f*g,F=b*U-E*D+v*I+C*L-T*B+y*M;if(F===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/F;return e[0]=(a*U-l*D+c*I)*H,e[1]=(r*D-i*U-s*I)*H,e[2]=(x*y-g*T+p*C)*H,e[3]=(d*T-h*y-f*C)*H,e[4]=(l*L-o*U-c*B)*H,e[5]=(t*U-r*L+s*B)*H,e[6]=(g*v-m*y-p*E)*H,e[7]=(u*y-d*v+f*E)*H,e[8]=(o*D-a*L+c*M)*H,e[9]=(i*L-t*D-s*M)*H,e[10]=(m*T-x*v+p*b)*H,e[11]=(h*v-u*T-f*b)*H,e[12]=(a*B-o*I-l*M)*H,e[13]=(t*I-i*B+r*M)*H,e[14]=(x*E-m*C-g*b)*H,e[15]=(u*C-h*E+d*b)*H,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+i,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,h=a+a,d=s*c,f=s*u,m=s*h,x=o*u,g=o*h,p=a*h,b=l*c,E=l*u,v=l*h,C=i.x,T=i.y,y=i.z;return r[0]=(1-(x+p))*C,r[1]=(f+v)*C,r[2]=(m-E)*C,r[3]=0,r[4]=(f-v)*T,r[5]=(1-(d+p))*T,r[6]=(g+b)*T,r[7]=0,r[8]=(m+E)*y,r[9]=(g-b)*y,r[10]=(1-(d+x))*y,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=Go.set(r[0],r[1],r[2]).length(),a=Go.set(r[4],r[5],r[6]).length(),l=Go.set(r[8],r[9],r[10]).length();s<0&&(o=-o),qi.copy(this);let c=1/o,u=1/a,h=1/l;return qi.elements[0]*=c,qi.elements[1]*=c,qi.elements[2]*=c,qi.elements[4]*=u,qi.elements[5]*=u,qi.elements[6]*=u,qi.elements[8]*=h,qi.elements[9]*=h,qi.elements[10]*=h,t.setFromRotationMatrix(qi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=Li,l=!1){let c=this.elements,u=2*s/(t-e),h=2*s/(i-r),d=(t+e)/(t-e),f=(i+r)/(i-r),m,x;if(l)m=s/(o-s),x=o*s/(o-s);else if(a===Li)m=-(o+s)/(o-s),x=-2*o*s/(o-s);else if(a===ia)m=-o/(o-s),x=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Li,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-r),d=-(t+e)/(t-e),f=-(i+r)/(i-r),m,x;if(l)m=1/(o-s),x=o/(o-s);else if(a===Li)m=-2/(o-s),x=-(o+s)/(o-s);else if(a===ia)m=-1/(o-s),x=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Go=new Z,qi=new Qt,FA=new Z(0,0,0),NA=new Z(1,1,1),ds=new Z,Gc=new Z,xi=new Z,xx=new Qt,yx=new Fi,Sr=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],d=r[6],f=r[10];switch(t){case"XYZ":this._y=Math.asin(Mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(Mt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-Mt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,f),this._y=0);break;default:et("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return xx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(xx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return yx.setFromEuler(this),this.setFromQuaternion(yx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Sr.DEFAULT_ORDER="XYZ";var pl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},BA=0,_x=new Z,Wo=new Fi,kr=new Qt,Wc=new Z,il=new Z,DA=new Z,kA=new Fi,bx=new Z(1,0,0),vx=new Z(0,1,0),wx=new Z(0,0,1),Sx={type:"added"},OA={type:"removed"},qo={type:"childadded",child:null},yf={type:"childremoved",child:null},$n=class n extends wr{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:BA++}),this.uuid=Js(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Z,t=new Sr,i=new Fi,r=new Z(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new Qt},normalMatrix:{value:new st}}),this.matrix=new Qt,this.matrixWorld=new Qt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new pl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Wo.setFromAxisAngle(e,t),this.quaternion.multiply(Wo),this}rotateOnWorldAxis(e,t){return Wo.setFromAxisAngle(e,t),this.quaternion.premultiply(Wo),this}rotateX(e){return this.rotateOnAxis(bx,e)}rotateY(e){return this.rotateOnAxis(vx,e)}rotateZ(e){return this.rotateOnAxis(wx,e)}translateOnAxis(e,t){return _x.copy(e).applyQuaternion(this.quaternion),this.position.add(_x.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(bx,e)}translateY(e){return this.translateOnAxis(vx,e)}translateZ(e){return this.translateOnAxis(wx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(kr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Wc.copy(e):Wc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),il.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?kr.lookAt(il,Wc,this.up):kr.lookAt(Wc,il,this.up),this.quaternion.setFromRotationMatrix(kr),r&&(kr.extractRotation(r.matrixWorld),Wo.setFromRotationMatrix(kr),this.quaternion.premultiply(Wo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(rt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Sx),qo.child=e,this.dispatchEvent(qo),qo.child=null):rt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(OA),yf.child=e,this.dispatchEvent(yf),yf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),kr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),kr.multiply(e.parent.matrixWorld)),e.applyMatrix4(kr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Sx),qo.child=e,this.dispatchEvent(qo),qo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(il,e,DA),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(il,kA,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(e.shapes,h)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$n.DEFAULT_UP=new Z(0,1,0);$n.DEFAULT_MATRIX_AUTO_UPDATE=!0;$n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wn=class extends $n{constructor(){super(),this.isGroup=!0,this.type="Group"}},UA={type:"move"},oa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new wn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new wn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new wn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let x of e.hand.values()){let g=t.getJointPose(x,i),p=this._getHandJoint(c,x);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(UA)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new wn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},wy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fs={h:0,s:0,l:0},qc={h:0,s:0,l:0};function _f(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var je=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=_i){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,wt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=wt.workingColorSpace){return this.r=e,this.g=t,this.b=i,wt.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=wt.workingColorSpace){if(e=RA(e,1),t=Mt(t,0,1),i=Mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=_f(o,s,e+1/3),this.g=_f(o,s,e),this.b=_f(o,s,e-1/3)}return wt.colorSpaceToWorking(this,r),this}setStyle(e,t=_i){function i(s){s!==void 0&&parseFloat(s)<1&&et("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:et("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);et("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=_i){let i=wy[e.toLowerCase()];return i!==void 0?this.setHex(i,t):et("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Hr(e.r),this.g=Hr(e.g),this.b=Hr(e.b),this}copyLinearToSRGB(e){return this.r=ta(e.r),this.g=ta(e.g),this.b=ta(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=_i){return wt.workingToColorSpace(Xn.copy(this),e),Math.round(Mt(Xn.r*255,0,255))*65536+Math.round(Mt(Xn.g*255,0,255))*256+Math.round(Mt(Xn.b*255,0,255))}getHexString(e=_i){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=wt.workingColorSpace){wt.workingToColorSpace(Xn.copy(this),t);let i=Xn.r,r=Xn.g,s=Xn.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-i)/h+2;break;case s:l=(i-r)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=wt.workingColorSpace){return wt.workingToColorSpace(Xn.copy(this),t),e.r=Xn.r,e.g=Xn.g,e.b=Xn.b,e}getStyle(e=_i){wt.workingToColorSpace(Xn.copy(this),e);let t=Xn.r,i=Xn.g,r=Xn.b;return e!==_i?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(fs),this.setHSL(fs.h+e,fs.s+t,fs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(fs),e.getHSL(qc);let i=ff(fs.h,qc.h,t),r=ff(fs.s,qc.s,t),s=ff(fs.l,qc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xn=new je;je.NAMES=wy;var ml=class extends $n{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Sr,this.environmentIntensity=1,this.environmentRotation=new Sr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Xi=new Z,Or=new Z,bf=new Z,Ur=new Z,Xo=new Z,$o=new Z,Ax=new Z,vf=new Z,wf=new Z,Sf=new Z,Af=new en,Mf=new en,Tf=new en,xs=class n{constructor(e=new Z,t=new Z,i=new Z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Xi.subVectors(e,t),r.cross(Xi);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Xi.subVectors(r,t),Or.subVectors(i,t),bf.subVectors(e,t);let o=Xi.dot(Xi),a=Xi.dot(Or),l=Xi.dot(bf),c=Or.dot(Or),u=Or.dot(bf),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return s.set(1-f-m,m,f)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Ur)===null?!1:Ur.x>=0&&Ur.y>=0&&Ur.x+Ur.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Ur)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ur.x),l.addScaledVector(o,Ur.y),l.addScaledVector(a,Ur.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return Af.setScalar(0),Mf.setScalar(0),Tf.setScalar(0),Af.fromBufferAttribute(e,t),Mf.fromBufferAttribute(e,i),Tf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(Af,s.x),o.addScaledVector(Mf,s.y),o.addScaledVector(Tf,s.z),o}static isFrontFacing(e,t,i,r){return Xi.subVectors(i,t),Or.subVectors(e,t),Xi.cross(Or).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Xi.subVectors(this.c,this.b),Or.subVectors(this.a,this.b),Xi.cross(Or).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;Xo.subVectors(r,i),$o.subVectors(s,i),vf.subVectors(e,i);let l=Xo.dot(vf),c=$o.dot(vf);if(l<=0&&c<=0)return t.copy(i);wf.subVectors(e,r);let u=Xo.dot(wf),h=$o.dot(wf);if(u>=0&&h<=u)return t.copy(r);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Xo,o);Sf.subVectors(e,s);let f=Xo.dot(Sf),m=$o.dot(Sf);if(m>=0&&f<=m)return t.copy(s);let x=f*c-l*m;if(x<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector($o,a);let g=u*m-f*h;if(g<=0&&h-u>=0&&f-m>=0)return Ax.subVectors(s,r),a=(h-u)/(h-u+(f-m)),t.copy(r).addScaledVector(Ax,a);let p=1/(g+x+d);return o=x*p,a=d*p,t.copy(i).addScaledVector(Xo,o).addScaledVector($o,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ys=class{constructor(e=new Z(1/0,1/0,1/0),t=new Z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint($i.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint($i.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=$i.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,$i):$i.fromBufferAttribute(s,o),$i.applyMatrix4(e.matrixWorld),this.expandByPoint($i);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Xc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Xc.copy(i.boundingBox)),Xc.applyMatrix4(e.matrixWorld),this.union(Xc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,$i),$i.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(rl),$c.subVectors(this.max,rl),Yo.subVectors(e.a,rl),Zo.subVectors(e.b,rl),Ko.subVectors(e.c,rl),ps.subVectors(Zo,Yo),ms.subVectors(Ko,Zo),Hs.subVectors(Yo,Ko);let t=[0,-ps.z,ps.y,0,-ms.z,ms.y,0,-Hs.z,Hs.y,ps.z,0,-ps.x,ms.z,0,-ms.x,Hs.z,0,-Hs.x,-ps.y,ps.x,0,-ms.y,ms.x,0,-Hs.y,Hs.x,0];return!Ef(t,Yo,Zo,Ko,$c)||(t=[1,0,0,0,1,0,0,0,1],!Ef(t,Yo,Zo,Ko,$c))?!1:(Yc.crossVectors(ps,ms),t=[Yc.x,Yc.y,Yc.z],Ef(t,Yo,Zo,Ko,$c))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,$i).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize($i).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(zr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),zr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),zr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),zr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),zr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),zr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),zr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),zr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(zr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},zr=[new Z,new Z,new Z,new Z,new Z,new Z,new Z,new Z],$i=new Z,Xc=new ys,Yo=new Z,Zo=new Z,Ko=new Z,ps=new Z,ms=new Z,Hs=new Z,rl=new Z,$c=new Z,Yc=new Z,Gs=new Z;function Ef(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){Gs.fromArray(n,s);let a=r.x*Math.abs(Gs.x)+r.y*Math.abs(Gs.y)+r.z*Math.abs(Gs.z),l=e.dot(Gs),c=t.dot(Gs),u=i.dot(Gs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var vn=new Z,Zc=new dt,zA=0,dn=class extends wr{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:zA++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=hp,this.updateRanges=[],this.gpuType=Ki,this.version=0,this._normalizationScale=e!==void 0?Ch(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Zc.fromBufferAttribute(this,t),Zc.applyMatrix3(e),this.setXY(t,Zc.x,Zc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix3(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix4(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyNormalMatrix(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.transformDirection(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):by(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):vy(e,this.array)}};var gl=class extends dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var xl=class extends dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var kn=class extends dn{constructor(e,t,i){super(new Float32Array(e),t,i)}},VA=new ys,sl=new Z,Cf=new Z,aa=class{constructor(e=new Z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):VA.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;sl.subVectors(e,this.center);let t=sl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(sl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(Cf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(sl.copy(e.center).add(Cf)),this.expandByPoint(sl.copy(e.center).sub(Cf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},HA=0,Ii=new Qt,Rf=new $n,Jo=new Z,yi=new ys,ol=new ys,Dn=new Z,Vn=class n extends wr{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:HA++}),this.uuid=Js(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(EA(e)?xl:gl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new st().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Ii.makeRotationFromQuaternion(e),this.applyMatrix4(Ii),this}rotateX(e){return Ii.makeRotationX(e),this.applyMatrix4(Ii),this}rotateY(e){return Ii.makeRotationY(e),this.applyMatrix4(Ii),this}rotateZ(e){return Ii.makeRotationZ(e),this.applyMatrix4(Ii),this}translate(e,t,i){return Ii.makeTranslation(e,t,i),this.applyMatrix4(Ii),this}scale(e,t,i){return Ii.makeScale(e,t,i),this.applyMatrix4(Ii),this}lookAt(e){return Rf.lookAt(e),Rf.updateMatrix(),this.applyMatrix4(Rf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Jo).negate(),this.translate(Jo.x,Jo.y,Jo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new kn(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&et("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ys);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Z(-1/0,-1/0,-1/0),new Z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];yi.setFromBufferAttribute(s),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&rt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new aa);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Z,1/0);return}if(e){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];ol.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(yi.min,ol.min),yi.expandByPoint(Dn),Dn.addVectors(yi.max,ol.max),yi.expandByPoint(Dn)):(yi.expandByPoint(ol.min),yi.expandByPoint(ol.max))}yi.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Dn.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Dn));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Jo.fromBufferAttribute(e,c),Dn.add(Jo)),r=Math.max(r,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&rt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){rt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new dn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let B=0;B<i.count;B++)a[B]=new Z,l[B]=new Z;let u=new Z,h=new Z,d=new Z,f=new dt,m=new dt,x=new dt,g=new Z,p=new Z;function b(B,L,I){c[B]=c[L]=c[I]=1,u.fromBufferAttribute(i,B),h.fromBufferAttribute(i,L),d.fromBufferAttribute(i,I),f.fromBufferAttribute(s,B),m.fromBufferAttribute(s,L),x.fromBufferAttribute(s,I),h.sub(u),d.sub(u),m.sub(f),x.sub(f);let D=1/(m.x*x.y-x.x*m.y);isFinite(D)&&(g.copy(h).multiplyScalar(x.y).addScaledVector(d,-m.y).multiplyScalar(D),p.copy(d).multiplyScalar(m.x).addScaledVector(h,-x.x).multiplyScalar(D),a[B].add(g),a[L].add(g),a[I].add(g),l[B].add(p),l[L].add(p),l[I].add(p))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let B=0,L=E.length;B<L;++B){let I=E[B],D=I.start,U=I.count;for(let F=D,H=D+U;F<H;F+=3)b(e.getX(F+0),e.getX(F+1),e.getX(F+2))}let v=new Z,C=new Z,T=new Z,y=new Z;function M(B){T.fromBufferAttribute(r,B),y.copy(T);let L=a[B];v.copy(L),v.sub(T.multiplyScalar(T.dot(L))).normalize(),C.crossVectors(y,L);let D=C.dot(l[B])<0?-1:1;o.setXYZW(B,v.x,v.y,v.z,D)}for(let B=0,L=i.count;B<L;++B)c[B]&&M(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let r=new Z,s=new Z,o=new Z,a=new Z,l=new Z,c=new Z,u=new Z,h=new Z;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),x=e.getX(d+1),g=e.getX(d+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,x),o.fromBufferAttribute(t,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)r.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?f=l[x]*a.data.stride+a.offset:f=l[x]*u;for(let p=0;p<u;p++)d[m++]=c[f++]}return new dn(d,u,h)}if(this.index===null)return et("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],h=s[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},yl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=hp,this.updateRanges=[],this.version=0,this.uuid=Js()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[i+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Mx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(i,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Mx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Mx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Js()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ti=new Z,_l=class n{constructor(e,t,i,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=r,this._normalizationScale=e!==void 0?Ch(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.applyMatrix4(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.applyNormalMatrix(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.transformDirection(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){dl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new dn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){dl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):by(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):vy(e,this.data.array)}},Pf=new Z,GA=new Z,WA=new st,Yi=class{constructor(e=new Z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=Pf.subVectors(i,t).cross(GA.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(Pf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||WA.getNormalMatrix(e),r=this.coplanarPoint(Pf).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},qA=0,Ar=class extends wr{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:qA++}),this.uuid=Js(),this.name="",this.type="Material",this.blending=ha,this.side=ci,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qf,this.blendDst=Xf,this.blendEquation=Ys,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=na,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=cy,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=uu,this.stencilZFail=uu,this.stencilZPass=uu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){et(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new Yi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new dt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new dt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Vr=new Z,If=new Z,Kc=new Z,Jc=new Z,Mu=class{constructor(e=new Z,t=new Z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Vr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Vr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Vr.copy(this.origin).addScaledVector(this.direction,t),Vr.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){If.copy(e).add(t).multiplyScalar(.5),Kc.copy(t).sub(e).normalize(),Jc.copy(this.origin).sub(If);let s=e.distanceTo(t)*.5,o=-this.direction.dot(Kc),a=Jc.dot(this.direction),l=-Jc.dot(Kc),c=Jc.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=s*u,h>=0)if(d>=-m)if(d<=m){let x=1/u;h*=x,d*=x,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*s+a)),d=h>0?-s:Math.min(Math.max(-s,-l),s),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-s,-l),s),f=d*(d+2*l)+c):(h=Math.max(0,-(o*s+a)),d=h>0?s:Math.min(Math.max(-s,-l),s),f=-h*h+d*(d+2*l)+c);else d=o>0?-s:s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(If).addScaledVector(Kc,d),f}intersectSphere(e,t){if(e.radius<0)return null;Vr.subVectors(e.center,this.origin);let i=Vr.dot(this.direction),r=Vr.dot(Vr)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,r=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,r=(e.min.x-d.x)*c),u>=0?(s=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(s=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,Vr)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,x=t.y-o.y,g=t.z-o.z,p=i.x-o.x,b=i.y-o.y,E=i.z-o.z,v=Math.abs(l),C=Math.abs(c),T=Math.abs(u),y,M,B,L,I,D,U,F,H,W,V,ae;if(v>=C&&v>=T?(B=l,D=h,H=m,ae=p,l>=0?(y=c,M=u,L=d,I=f,U=x,F=g,W=b,V=E):(y=u,M=c,L=f,I=d,U=g,F=x,W=E,V=b)):C>=T?(B=c,D=d,H=x,ae=b,c>=0?(y=u,M=l,L=f,I=h,U=g,F=m,W=E,V=p):(y=l,M=u,L=h,I=f,U=m,F=g,W=p,V=E)):(B=u,D=f,H=g,ae=E,u>=0?(y=l,M=c,L=h,I=d,U=m,F=x,W=p,V=b):(y=c,M=l,L=d,I=h,U=x,F=m,W=b,V=p)),B===0)return null;let $=y/B,j=M/B,te=1/B,ue=L-$*D,he=I-j*D,ee=U-$*H,ge=F-j*H,be=W-$*ae,Pe=V-j*ae,Ae=be*ge-Pe*ee,$e=ue*Pe-he*be,lt=ee*he-ge*ue;if(r){if(Ae<0||$e<0||lt<0)return null}else if((Ae<0||$e<0||lt<0)&&(Ae>0||$e>0||lt>0))return null;let qe=Ae+$e+lt;if(qe===0)return null;let gt=te*(Ae*D+$e*H+lt*ae);return(qe>0?gt<0:gt>0)?null:this.at(gt/qe,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},_s=class extends Ar{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Sr,this.combine=Il,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Tx=new Qt,Ws=new Mu,jc=new aa,Ex=new Z,Qc=new Z,eu=new Z,tu=new Z,Lf=new Z,nu=new Z,Cx=new Z,iu=new Z,Ct=class extends $n{constructor(e=new Vn,t=new _s){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){nu.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(Lf.fromBufferAttribute(h,e),o?nu.addScaledVector(Lf,u):nu.addScaledVector(Lf.sub(t),u))}t.add(nu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),jc.copy(i.boundingSphere),jc.applyMatrix4(s),Ws.copy(e.ray).recast(e.near),!(jc.containsPoint(Ws.origin)===!1&&(Ws.intersectSphere(jc,Ex)===null||Ws.origin.distanceToSquared(Ex)>(e.far-e.near)**2))&&(Tx.copy(s).invert(),Ws.copy(e.ray).applyMatrix4(Tx),!(i.boundingBox!==null&&Ws.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ws)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,d=s.groups,f=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let g=d[m],p=o[g.materialIndex],b=Math.max(g.start,f.start),E=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let v=b,C=E;v<C;v+=3){let T=a.getX(v),y=a.getX(v+1),M=a.getX(v+2);r=ru(this,p,e,i,c,u,h,T,y,M),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let g=m,p=x;g<p;g+=3){let b=a.getX(g),E=a.getX(g+1),v=a.getX(g+2);r=ru(this,o,e,i,c,u,h,b,E,v),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,x=d.length;m<x;m++){let g=d[m],p=o[g.materialIndex],b=Math.max(g.start,f.start),E=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let v=b,C=E;v<C;v+=3){let T=v,y=v+1,M=v+2;r=ru(this,p,e,i,c,u,h,T,y,M),r&&(r.faceIndex=Math.floor(v/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,f.start),x=Math.min(l.count,f.start+f.count);for(let g=m,p=x;g<p;g+=3){let b=g,E=g+1,v=g+2;r=ru(this,o,e,i,c,u,h,b,E,v),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}}};function XA(n,e,t,i,r,s,o,a){let l;if(e.side===fn?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===ci,a),l===null)return null;iu.copy(a),iu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(iu);return c<t.near||c>t.far?null:{distance:c,point:iu.clone(),object:n}}function ru(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,Qc),n.getVertexPosition(l,eu),n.getVertexPosition(c,tu);let u=XA(n,e,t,i,Qc,eu,tu,Cx);if(u){let h=new Z;xs.getBarycoord(Cx,Qc,eu,tu,h),r&&(u.uv=xs.getInterpolatedAttribute(r,a,l,c,h,new dt)),s&&(u.uv1=xs.getInterpolatedAttribute(s,a,l,c,h,new dt)),o&&(u.normal=xs.getInterpolatedAttribute(o,a,l,c,h,new Z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new Z,materialIndex:0};xs.getNormal(Qc,eu,tu,d.normal),u.face=d,u.barycoord=h}return u}var Tu=class extends ai{constructor(e=null,t=1,i=1,r,s,o,a,l,c=On,u=On,h,d){super(null,o,a,l,c,u,r,s,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qs=new aa,$A=new dt(.5,.5),su=new Z,bs=class{constructor(e=new Yi,t=new Yi,i=new Yi,r=new Yi,s=new Yi,o=new Yi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Li,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],d=s[6],f=s[7],m=s[8],x=s[9],g=s[10],p=s[11],b=s[12],E=s[13],v=s[14],C=s[15];if(r[0].setComponents(c-o,f-u,p-m,C-b).normalize(),r[1].setComponents(c+o,f+u,p+m,C+b).normalize(),r[2].setComponents(c+a,f+h,p+x,C+E).normalize(),r[3].setComponents(c-a,f-h,p-x,C-E).normalize(),i)r[4].setComponents(l,d,g,v).normalize(),r[5].setComponents(c-l,f-d,p-g,C-v).normalize();else if(r[4].setComponents(c-l,f-d,p-g,C-v).normalize(),t===Li)r[5].setComponents(c+l,f+d,p+g,C+v).normalize();else if(t===ia)r[5].setComponents(l,d,g,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),qs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),qs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(qs)}intersectsSprite(e){qs.center.set(0,0,0);let t=$A.distanceTo(e.center);return qs.radius=.7071067811865476+t,qs.applyMatrix4(e.matrixWorld),this.intersectsSphere(qs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(su.x=r.normal.x>0?e.max.x:e.min.x,su.y=r.normal.y>0?e.max.y:e.min.y,su.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(su)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Rx=new Qt,Eu=class n{constructor(){this.coordinateSystem=Li,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];Rx.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new bs),i[r].setFromProjectionMatrix(Rx,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new bs),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var bl=class extends ai{constructor(e=[],t=Zs,i,r,s,o,a,l,c,u){super(e,t,i,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Wr=class extends ai{constructor(e,t,i=Zi,r,s,o,a=On,l=On,c,u=Gr,h=1){if(u!==Gr&&u!==Kr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,r,s,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new sa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},vl=class extends Wr{constructor(e,t=Zi,i=Zs,r,s,o=On,a=On,l,c=Gr){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},wl=class extends ai{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},qr=class n extends Vn{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new kn(c,3)),this.setAttribute("normal",new kn(u,3)),this.setAttribute("uv",new kn(h,2));function m(x,g,p,b,E,v,C,T,y,M,B){let L=v/y,I=C/M,D=v/2,U=C/2,F=T/2,H=y+1,W=M+1,V=0,ae=0,$=new Z;for(let j=0;j<W;j++){let te=j*I-U;for(let ue=0;ue<H;ue++){let he=ue*L-D;$[x]=he*b,$[g]=te*E,$[p]=F,c.push($.x,$.y,$.z),$[x]=0,$[g]=0,$[p]=T>0?1:-1,u.push($.x,$.y,$.z),h.push(ue/y),h.push(1-j/M),V+=1}}for(let j=0;j<M;j++)for(let te=0;te<y;te++){let ue=d+te+H*j,he=d+te+H*(j+1),ee=d+(te+1)+H*(j+1),ge=d+(te+1)+H*j;l.push(ue,he,ge),l.push(he,ee,ge),ae+=6}a.addGroup(f,ae,B),f+=ae,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Xr=class n extends Vn{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],d=[],f=[],m=0,x=[],g=i/2,p=0;b(),o===!1&&(e>0&&E(!0),t>0&&E(!1)),this.setIndex(u),this.setAttribute("position",new kn(h,3)),this.setAttribute("normal",new kn(d,3)),this.setAttribute("uv",new kn(f,2));function b(){let v=new Z,C=new Z,T=0,y=(t-e)/i;for(let M=0;M<=s;M++){let B=[],L=M/s,I=L*(t-e)+e;for(let D=0;D<=r;D++){let U=D/r,F=U*l+a,H=Math.sin(F),W=Math.cos(F);C.x=I*H,C.y=-L*i+g,C.z=I*W,h.push(C.x,C.y,C.z),v.set(H,y,W).normalize(),d.push(v.x,v.y,v.z),f.push(U,1-L),B.push(m++)}x.push(B)}for(let M=0;M<r;M++)for(let B=0;B<s;B++){let L=x[B][M],I=x[B+1][M],D=x[B+1][M+1],U=x[B][M+1];(e>0||B!==0)&&(u.push(L,I,U),T+=3),(t>0||B!==s-1)&&(u.push(I,D,U),T+=3)}c.addGroup(p,T,0),p+=T}function E(v){let C=m,T=new dt,y=new Z,M=0,B=v===!0?e:t,L=v===!0?1:-1;for(let D=1;D<=r;D++)h.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),m++;let I=m;for(let D=0;D<=r;D++){let F=D/r*l+a,H=Math.cos(F),W=Math.sin(F);y.x=B*W,y.y=g*L,y.z=B*H,h.push(y.x,y.y,y.z),d.push(0,L,0),T.x=H*.5+.5,T.y=W*.5*L+.5,f.push(T.x,T.y),m++}for(let D=0;D<r;D++){let U=C+D,F=I+D;v===!0?u.push(F,F+1,U):u.push(F+1,F,U),M+=3}c.addGroup(p,M,v===!0?1:2),p+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},Sl=class n extends Xr{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var vs=class n extends Vn{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],x=[],g=[];for(let p=0;p<u;p++){let b=p*d-o;for(let E=0;E<c;E++){let v=E*h-s;m.push(v,-b,0),x.push(0,0,1),g.push(E/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let b=0;b<a;b++){let E=b+c*p,v=b+c*(p+1),C=b+1+c*(p+1),T=b+1+c*p;f.push(E,v,T),f.push(v,C,T)}this.setIndex(f),this.setAttribute("position",new kn(m,3)),this.setAttribute("normal",new kn(x,3)),this.setAttribute("uv",new kn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var $r=class n extends Vn{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new Z,d=new Z,f=[],m=[],x=[],g=[];for(let p=0;p<=i;p++){let b=[],E=p/i,v=o+E*a,C=e*Math.cos(v),T=Math.sqrt(e*e-C*C),y=0;p===0&&o===0?y=.5/t:p===i&&l===Math.PI&&(y=-.5/t);for(let M=0;M<=t;M++){let B=M/t,L=r+B*s;h.x=-T*Math.cos(L),h.y=C,h.z=T*Math.sin(L),m.push(h.x,h.y,h.z),d.copy(h).normalize(),x.push(d.x,d.y,d.z),g.push(B+y,1-E),b.push(c++)}u.push(b)}for(let p=0;p<i;p++)for(let b=0;b<t;b++){let E=u[p][b+1],v=u[p][b],C=u[p+1][b],T=u[p+1][b+1];(p!==0||o>0)&&f.push(E,v,T),(p!==i-1||l<Math.PI)&&f.push(v,C,T)}this.setIndex(f),this.setAttribute("position",new kn(m,3)),this.setAttribute("normal",new kn(x,3)),this.setAttribute("uv",new kn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Al=class extends Ar{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new je(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function js(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(Px(r))r.isRenderTargetTexture?(et("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(Px(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function Yn(n){let e={};for(let t=0;t<n.length;t++){let i=js(n[t]);for(let r in i)e[r]=i[r]}return e}function Px(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function YA(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function fp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:wt.workingColorSpace}var Sy={clone:js,merge:Yn},ZA=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,KA=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,li=class extends Ar{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=ZA,this.fragmentShader=KA,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=js(e.uniforms),this.uniformsGroups=YA(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new je().setHex(r.value);break;case"v2":this.uniforms[i].value=new dt().fromArray(r.value);break;case"v3":this.uniforms[i].value=new Z().fromArray(r.value);break;case"v4":this.uniforms[i].value=new en().fromArray(r.value);break;case"m3":this.uniforms[i].value=new st().fromArray(r.value);break;case"m4":this.uniforms[i].value=new Qt().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Cu=class extends li{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Yr=class extends Ar{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new je(16777215),this.specular=new je(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ul,this.normalScale=new dt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Sr,this.combine=Il,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var Ml=class extends Ar{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ul,this.normalScale=new dt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Sr,this.combine=Il,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ru=class extends Ar{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ay,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Pu=class extends Ar{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function jo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function ou(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ws=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=t[++i],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(i=2,s=a);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Iu=class extends ws{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Bf,endingEnd:Bf}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case Df:s=e,a=2*t-i;break;case kf:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Df:o=e,l=2*i-t;break;case kf:o=1,l=i+r[1]-r[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-t)/(r-t),x=m*m,g=x*m,p=-d*g+2*d*x-d*m,b=(1+d)*g+(-1.5-2*d)*x+(-.5+d)*m+1,E=(-1-f)*g+(1.5+f)*x+.5*m,v=f*g-f*x;for(let C=0;C!==a;++C)s[C]=p*o[u+C]+b*o[c+C]+E*o[l+C]+v*o[h+C];return s}},Lu=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(r-t),h=1-u;for(let d=0;d!==a;++d)s[d]=o[c+d]*h+o[l+d]*u;return s}},Fu=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Nu=class extends ws{interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-t)/(r-t),x=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*x+o[l+g]*m;return s}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let x=o[c+m],g=o[l+m],p=f*d+m*2,b=h[p],E=h[p+1],v=e*d+m*2,C=u[v],T=u[v+1],y=jA(i,t,b,C,r);s[m]=Ay(y,x,E,T,g)}return s}};function Ay(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function JA(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function jA(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let a=Ay(s,e,t,i,r)-n;if(Math.abs(a)<1e-10)break;let l=JA(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var vi=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=jo(t,this.TimeBufferType),this.values=jo(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:jo(e.times,Array),values:jo(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),ou(e.settings)&&(i.settings={inTangents:jo(e.settings.inTangents,Array),outTangents:jo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Fu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Lu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Iu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Nu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case ll:t=this.InterpolantFactoryMethodDiscrete;break;case bu:t=this.InterpolantFactoryMethodLinear;break;case cu:t=this.InterpolantFactoryMethodSmooth;break;case Nf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return et("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return ll;case this.InterpolantFactoryMethodLinear:return bu;case this.InterpolantFactoryMethodSmooth:return cu;case this.InterpolantFactoryMethodBezier:return Nf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;ou(this.settings)&&(Ix(this.settings.inTangents,e),Ix(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;ou(this.settings)&&(Lx(this.settings.inTangents,e),Lx(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(rt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(rt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){rt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){rt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&CA(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){rt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===cu,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(r)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let x=t[h+m];if(x!==t[d+m]||x!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(s>0){e[o]=e[s];for(let a=s*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,ou(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function Ix(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function Lx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}vi.prototype.ValueTypeName="";vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=bu;var Ss=class extends vi{constructor(e,t,i){super(e,t,i)}};Ss.prototype.ValueTypeName="bool";Ss.prototype.ValueBufferType=Array;Ss.prototype.DefaultInterpolation=ll;Ss.prototype.InterpolantFactoryMethodLinear=void 0;Ss.prototype.InterpolantFactoryMethodSmooth=void 0;var Bu=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Bu.prototype.ValueTypeName="color";var Du=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Du.prototype.ValueTypeName="number";var ku=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(r-t),c=e*a;for(let u=c+a;c!==u;c+=4)Fi.slerpFlat(s,0,o,c-a,o,c,l);return s}},Tl=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new ku(this.times,this.values,this.getValueSize(),e)}};Tl.prototype.ValueTypeName="quaternion";Tl.prototype.InterpolantFactoryMethodSmooth=void 0;var As=class extends vi{constructor(e,t,i){super(e,t,i)}};As.prototype.ValueTypeName="string";As.prototype.ValueBufferType=Array;As.prototype.DefaultInterpolation=ll;As.prototype.InterpolantFactoryMethodLinear=void 0;As.prototype.InterpolantFactoryMethodSmooth=void 0;var Ou=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Ou.prototype.ValueTypeName="vector";var Uu=class{constructor(e,t,i){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},My=new Uu,zu=class{constructor(e){this.manager=e!==void 0?e:My,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};zu.DEFAULT_MATERIAL_NAME="__DEFAULT";var El=class extends $n{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},la=class extends El{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy($n.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Ff=new Qt,Fx=new Z,Nx=new Z,Vu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new dt(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new Qt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new bs,this._frameExtents=new dt(1,1),this._viewportCount=1,this._viewports=[new en(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;Fx.setFromMatrixPosition(e.matrixWorld),t.position.copy(Fx),Nx.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Nx),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){Ff.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Ff,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===ia||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Ff)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},au=new Z,lu=new Fi,br=new Z,Cl=class extends $n{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Qt,this.projectionMatrix=new Qt,this.projectionMatrixInverse=new Qt,this.coordinateSystem=Li,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(au,lu,br),br.x===1&&br.y===1&&br.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(au,lu,br.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(au,lu,br),br.x===1&&br.y===1&&br.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(au,lu,br.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},gs=new Z,Bx=new dt,Dx=new dt,ni=class extends Cl{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=vu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(df*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return vu*2*Math.atan(Math.tan(df*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(gs.x,gs.y).multiplyScalar(-e/gs.z),gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(gs.x,gs.y).multiplyScalar(-e/gs.z)}getViewSize(e,t){return this.getViewBounds(e,Bx,Dx),t.subVectors(Dx,Bx)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(df*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Rl=class extends Cl{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Of=class extends Vu{constructor(){super(new Rl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Pl=class extends El{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($n.DEFAULT_UP),this.updateMatrix(),this.target=new $n,this.shadow=new Of}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Qo=-90,ea=1,ca=class extends $n{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new ni(Qo,ea,e,t);r.layers=this.layers,this.add(r);let s=new ni(Qo,ea,e,t);s.layers=this.layers,this.add(s);let o=new ni(Qo,ea,e,t);o.layers=this.layers,this.add(o);let a=new ni(Qo,ea,e,t);a.layers=this.layers,this.add(a);let l=new ni(Qo,ea,e,t);l.layers=this.layers,this.add(l);let c=new ni(Qo,ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Li)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ia)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=x,e.setRenderTarget(i,5,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Hu=class extends ni{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var pp="\\[\\]\\.:\\/",QA=new RegExp("["+pp+"]","g"),mp="[^"+pp+"]",eM="[^"+pp.replace("\\.","")+"]",tM=/((?:WC+[\/:])*)/.source.replace("WC",mp),nM=/(WCOD+)?/.source.replace("WCOD",eM),iM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",mp),rM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",mp),sM=new RegExp("^"+tM+nM+iM+rM+"$"),oM=["material","materials","bones","map"],Uf=class{constructor(e,t,i){let r=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(QA,"")}static parseTrackName(e){let t=sM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);oM.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){et("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){rt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){rt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){rt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){rt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){rt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;rt("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Uf;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var oN=new Float32Array(1);var zf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};function gp(n,e,t,i){let r=aM(i);switch(t){case sp:return n*e;case ap:return n*e/r.components*r.byteLength;case Zu:return n*e/r.components*r.byteLength;case Ms:return n*e*2/r.components*r.byteLength;case Ku:return n*e*2/r.components*r.byteLength;case op:return n*e*3/r.components*r.byteLength;case ji:return n*e*4/r.components*r.byteLength;case Ju:return n*e*4/r.components*r.byteLength;case Fl:case Nl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Bl:case Dl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Qu:case th:return Math.max(n,16)*Math.max(e,8)/4;case ju:case eh:return Math.max(n,8)*Math.max(e,8)/2;case nh:case ih:case sh:case oh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case rh:case kl:case ah:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case lh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ch:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case uh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case hh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case dh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case fh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ph:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case mh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case gh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case xh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case yh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case _h:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case bh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case vh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case wh:case Sh:case Ah:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Mh:case Th:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ol:case Eh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function aM(n){switch(n){case ui:case tp:return{byteLength:1,components:1};case fa:case np:case Ji:return{byteLength:2,components:1};case $u:case Yu:return{byteLength:2,components:4};case Zi:case Xu:case Ki:return{byteLength:4,components:1};case ip:case rp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?et("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function $y(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function cM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],x=h[f];x.start<=m.start+m.count+1?m.count=Math.max(m.count,x.start+x.count-m.start):(++d,h[d]=x)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let x=h[f];n.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var uM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,hM=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,dM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,fM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,pM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,mM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,gM=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,xM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,yM=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,_M=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,vM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,wM=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,SM=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,AM=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,MM=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,TM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,EM=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,CM=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,RM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,PM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,IM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,LM=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,FM=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,NM=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,BM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,DM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,OM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,UM="gl_FragColor = linearToOutputTexel( gl_FragColor );",zM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,VM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,HM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,GM=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,WM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,qM=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,XM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,$M=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,YM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ZM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,KM=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,JM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,jM=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,QM=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,e1=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,t1=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,n1=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,i1=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,r1=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,s1=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,o1=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,a1=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,l1=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,c1=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,u1=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,h1=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,d1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,f1=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,p1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,m1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,g1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,x1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,y1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,_1=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,b1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,v1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,w1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,S1=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,A1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,M1=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,T1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,E1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,C1=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,R1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,P1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,I1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,L1=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,F1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,N1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,B1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,D1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,k1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,O1=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,U1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,z1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,V1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,H1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,G1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,W1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,q1=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,X1=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,$1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Y1=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Z1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,K1=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,J1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,j1=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Q1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,eT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,tT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,nT=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,iT=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,rT=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,sT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,oT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,aT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,lT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,cT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,uT=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dT=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,pT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,mT=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,gT=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,xT=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,yT=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,_T=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,vT=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,wT=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,ST=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,AT=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,MT=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,TT=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ET=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,CT=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,RT=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,PT=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,IT=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,LT=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,FT=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,NT=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,BT=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,DT=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,kT=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,OT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,UT=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,zT=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,VT=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,HT=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,mt={alphahash_fragment:uM,alphahash_pars_fragment:hM,alphamap_fragment:dM,alphamap_pars_fragment:fM,alphatest_fragment:pM,alphatest_pars_fragment:mM,aomap_fragment:gM,aomap_pars_fragment:xM,batching_pars_vertex:yM,batching_vertex:_M,begin_vertex:bM,beginnormal_vertex:vM,bsdfs:wM,iridescence_fragment:SM,bumpmap_pars_fragment:AM,clipping_planes_fragment:MM,clipping_planes_pars_fragment:TM,clipping_planes_pars_vertex:EM,clipping_planes_vertex:CM,color_fragment:RM,color_pars_fragment:PM,color_pars_vertex:IM,color_vertex:LM,common:FM,defaultnormal_vertex:NM,displacementmap_pars_vertex:BM,displacementmap_vertex:DM,emissivemap_fragment:kM,emissivemap_pars_fragment:OM,colorspace_fragment:UM,colorspace_pars_fragment:zM,envmap_fragment:VM,envmap_common_pars_fragment:HM,envmap_pars_fragment:GM,envmap_pars_vertex:WM,envmap_physical_pars_fragment:t1,envmap_vertex:qM,fog_vertex:XM,fog_pars_vertex:$M,fog_fragment:YM,fog_pars_fragment:ZM,gradientmap_pars_fragment:KM,lightmap_pars_fragment:JM,lights_lambert_fragment:jM,lights_lambert_pars_fragment:QM,lights_pars_begin:e1,lights_toon_fragment:n1,lights_toon_pars_fragment:i1,lights_phong_fragment:r1,lights_phong_pars_fragment:s1,lights_physical_fragment:o1,lights_physical_pars_fragment:a1,lights_fragment_begin:l1,lights_fragment_maps:c1,lights_fragment_end:u1,lightprobes_pars_fragment:h1,logdepthbuf_fragment:d1,logdepthbuf_pars_fragment:f1,logdepthbuf_pars_vertex:p1,logdepthbuf_vertex:m1,map_fragment:g1,map_pars_fragment:x1,map_particle_fragment:y1,map_particle_pars_fragment:_1,metalnessmap_fragment:b1,metalnessmap_pars_fragment:v1,morphinstance_vertex:w1,morphcolor_vertex:S1,morphnormal_vertex:A1,morphtarget_pars_vertex:M1,morphtarget_vertex:T1,normal_fragment_begin:E1,normal_fragment_maps:C1,normal_pars_fragment:R1,normal_pars_vertex:P1,normal_vertex:I1,normalmap_pars_fragment:L1,clearcoat_normal_fragment_begin:F1,clearcoat_normal_fragment_maps:N1,clearcoat_pars_fragment:B1,iridescence_pars_fragment:D1,opaque_fragment:k1,packing:O1,premultiplied_alpha_fragment:U1,project_vertex:z1,dithering_fragment:V1,dithering_pars_fragment:H1,roughnessmap_fragment:G1,roughnessmap_pars_fragment:W1,shadowmap_pars_fragment:q1,shadowmap_pars_vertex:X1,shadowmap_vertex:$1,shadowmask_pars_fragment:Y1,skinbase_vertex:Z1,skinning_pars_vertex:K1,skinning_vertex:J1,skinnormal_vertex:j1,specularmap_fragment:Q1,specularmap_pars_fragment:eT,tonemapping_fragment:tT,tonemapping_pars_fragment:nT,transmission_fragment:iT,transmission_pars_fragment:rT,uv_pars_fragment:sT,uv_pars_vertex:oT,uv_vertex:aT,worldpos_vertex:lT,background_vert:cT,background_frag:uT,backgroundCube_vert:hT,backgroundCube_frag:dT,cube_vert:fT,cube_frag:pT,depth_vert:mT,depth_frag:gT,distance_vert:xT,distance_frag:yT,equirect_vert:_T,equirect_frag:bT,linedashed_vert:vT,linedashed_frag:wT,meshbasic_vert:ST,meshbasic_frag:AT,meshlambert_vert:MT,meshlambert_frag:TT,meshmatcap_vert:ET,meshmatcap_frag:CT,meshnormal_vert:RT,meshnormal_frag:PT,meshphong_vert:IT,meshphong_frag:LT,meshphysical_vert:FT,meshphysical_frag:NT,meshtoon_vert:BT,meshtoon_frag:DT,points_vert:kT,points_frag:OT,shadow_vert:UT,shadow_frag:zT,sprite_vert:VT,sprite_frag:HT},Be={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new dt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new dt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},Er={basic:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:mt.meshbasic_vert,fragmentShader:mt.meshbasic_frag},lambert:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:mt.meshlambert_vert,fragmentShader:mt.meshlambert_frag},phong:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:mt.meshphong_vert,fragmentShader:mt.meshphong_frag},standard:{uniforms:Yn([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag},toon:{uniforms:Yn([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new je(0)}}]),vertexShader:mt.meshtoon_vert,fragmentShader:mt.meshtoon_frag},matcap:{uniforms:Yn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:mt.meshmatcap_vert,fragmentShader:mt.meshmatcap_frag},points:{uniforms:Yn([Be.points,Be.fog]),vertexShader:mt.points_vert,fragmentShader:mt.points_frag},dashed:{uniforms:Yn([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:mt.linedashed_vert,fragmentShader:mt.linedashed_frag},depth:{uniforms:Yn([Be.common,Be.displacementmap]),vertexShader:mt.depth_vert,fragmentShader:mt.depth_frag},normal:{uniforms:Yn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:mt.meshnormal_vert,fragmentShader:mt.meshnormal_frag},sprite:{uniforms:Yn([Be.sprite,Be.fog]),vertexShader:mt.sprite_vert,fragmentShader:mt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:mt.background_vert,fragmentShader:mt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:mt.backgroundCube_vert,fragmentShader:mt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:mt.cube_vert,fragmentShader:mt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:mt.equirect_vert,fragmentShader:mt.equirect_frag},distance:{uniforms:Yn([Be.common,Be.displacementmap,{referencePosition:{value:new Z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:mt.distance_vert,fragmentShader:mt.distance_frag},shadow:{uniforms:Yn([Be.lights,Be.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:mt.shadow_vert,fragmentShader:mt.shadow_frag}};Er.physical={uniforms:Yn([Er.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new dt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new dt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new dt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag};var Rh={r:0,b:0,g:0},GT=new Qt,Yy=new st;Yy.set(-1,0,0,0,1,0,0,0,1);function WT(n,e,t,i,r,s){let o=new je(0),a=r===!0?0:1,l,c,u=null,h=0,d=null;function f(b){let E=b.isScene===!0?b.background:null;if(E&&E.isTexture){let v=b.backgroundBlurriness>0;E=e.get(E,v)}return E}function m(b){let E=!1,v=f(b);v===null?g(o,a):v&&v.isColor&&(g(v,1),E=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,s):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(b,E){let v=f(E);v&&v.isCubeTexture?(c===void 0&&(c=new Ct(new qr(1,1,1),new li({name:"BackgroundCubeMaterial",uniforms:js(Er.backgroundCube.uniforms),vertexShader:Er.backgroundCube.vertexShader,fragmentShader:Er.backgroundCube.fragmentShader,side:fn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,T,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=v,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(GT.makeRotationFromEuler(E.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yy),c.material.toneMapped=wt.getTransfer(v.colorSpace)!==Lt,(u!==v||h!==v.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):v&&v.isTexture&&(l===void 0&&(l=new Ct(new vs(2,2),new li({name:"BackgroundMaterial",uniforms:js(Er.background.uniforms),vertexShader:Er.background.vertexShader,fragmentShader:Er.background.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=v,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=wt.getTransfer(v.colorSpace)!==Lt,v.matrixAutoUpdate===!0&&v.updateMatrix(),l.material.uniforms.uvTransform.value.copy(v.matrix),(u!==v||h!==v.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=v,h=v.version,d=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function g(b,E){b.getRGB(Rh,fp(n)),t.buffers.color.setClear(Rh.r,Rh.g,Rh.b,E,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,E=1){o.set(b),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,g(o,a)},render:m,addToRenderList:x,dispose:p}}function qT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=d(null),s=r,o=!1;function a(I,D,U,F,H){let W=!1,V=h(I,F,U,D);s!==V&&(s=V,c(s.object)),W=f(I,F,U,H),W&&m(I,F,U,H),H!==null&&e.update(H,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,v(I,D,U,F),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,D,U,F){let H=F.wireframe===!0,W=i[D.id];W===void 0&&(W={},i[D.id]=W);let V=I.isInstancedMesh===!0?I.id:0,ae=W[V];ae===void 0&&(ae={},W[V]=ae);let $=ae[U.id];$===void 0&&($={},ae[U.id]=$);let j=$[H];return j===void 0&&(j=d(l()),$[H]=j),j}function d(I){let D=[],U=[],F=[];for(let H=0;H<t;H++)D[H]=0,U[H]=0,F[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:D,enabledAttributes:U,attributeDivisors:F,object:I,attributes:{},index:null}}function f(I,D,U,F){let H=s.attributes,W=D.attributes,V=0,ae=U.getAttributes();for(let $ in ae)if(ae[$].location>=0){let te=H[$],ue=W[$];if(ue===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(ue=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(ue=I.instanceColor)),te===void 0||te.attribute!==ue||ue&&te.data!==ue.data)return!0;V++}return s.attributesNum!==V||s.index!==F}function m(I,D,U,F){let H={},W=D.attributes,V=0,ae=U.getAttributes();for(let $ in ae)if(ae[$].location>=0){let te=W[$];te===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(te=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(te=I.instanceColor));let ue={};ue.attribute=te,te&&te.data&&(ue.data=te.data),H[$]=ue,V++}s.attributes=H,s.attributesNum=V,s.index=F}function x(){let I=s.newAttributes;for(let D=0,U=I.length;D<U;D++)I[D]=0}function g(I){p(I,0)}function p(I,D){let U=s.newAttributes,F=s.enabledAttributes,H=s.attributeDivisors;U[I]=1,F[I]===0&&(n.enableVertexAttribArray(I),F[I]=1),H[I]!==D&&(n.vertexAttribDivisor(I,D),H[I]=D)}function b(){let I=s.newAttributes,D=s.enabledAttributes;for(let U=0,F=D.length;U<F;U++)D[U]!==I[U]&&(n.disableVertexAttribArray(U),D[U]=0)}function E(I,D,U,F,H,W,V){V===!0?n.vertexAttribIPointer(I,D,U,H,W):n.vertexAttribPointer(I,D,U,F,H,W)}function v(I,D,U,F){x();let H=F.attributes,W=U.getAttributes(),V=D.defaultAttributeValues;for(let ae in W){let $=W[ae];if($.location>=0){let j=H[ae];if(j===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(j=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(j=I.instanceColor)),j!==void 0){let te=j.normalized,ue=j.itemSize,he=e.get(j);if(he===void 0)continue;let ee=he.buffer,ge=he.type,be=he.bytesPerElement,Pe=ge===n.INT||ge===n.UNSIGNED_INT||j.gpuType===Xu;if(j.isInterleavedBufferAttribute){let Ae=j.data,$e=Ae.isInterleavedBuffer===!0?Ae.stride:Ae.itemSize,lt=j.offset;if(Ae.isInstancedInterleavedBuffer||Ae.isInstancedBufferAttribute){for(let qe=0;qe<$.locationSize;qe++)p($.location+qe,Ae.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=Ae.meshPerAttribute*Ae.count)}else for(let qe=0;qe<$.locationSize;qe++)g($.location+qe);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let qe=0;qe<$.locationSize;qe++)E($.location+qe,ue/$.locationSize,ge,te,$e*be,(lt+ue/$.locationSize*qe)*be,Pe)}else{if(j.isInstancedBufferAttribute){for(let Ae=0;Ae<$.locationSize;Ae++)p($.location+Ae,j.meshPerAttribute);I.isInstancedMesh!==!0&&F._maxInstanceCount===void 0&&(F._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Ae=0;Ae<$.locationSize;Ae++)g($.location+Ae);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ae=0;Ae<$.locationSize;Ae++)E($.location+Ae,ue/$.locationSize,ge,te,ue*be,ue/$.locationSize*Ae*be,Pe)}}else if(V!==void 0){let te=V[ae];if(te!==void 0)switch(te.length){case 2:n.vertexAttrib2fv($.location,te);break;case 3:n.vertexAttrib3fv($.location,te);break;case 4:n.vertexAttrib4fv($.location,te);break;default:n.vertexAttrib1fv($.location,te)}}}}b()}function C(){B();for(let I in i){let D=i[I];for(let U in D){let F=D[U];for(let H in F){let W=F[H];for(let V in W)u(W[V].object),delete W[V];delete F[H]}}delete i[I]}}function T(I){if(i[I.id]===void 0)return;let D=i[I.id];for(let U in D){let F=D[U];for(let H in F){let W=F[H];for(let V in W)u(W[V].object),delete W[V];delete F[H]}}delete i[I.id]}function y(I){for(let D in i){let U=i[D];for(let F in U){let H=U[F];if(H[I.id]===void 0)continue;let W=H[I.id];for(let V in W)u(W[V].object),delete W[V];delete H[I.id]}}}function M(I){for(let D in i){let U=i[D],F=I.isInstancedMesh===!0?I.id:0,H=U[F];if(H!==void 0){for(let W in H){let V=H[W];for(let ae in V)u(V[ae].object),delete V[ae];delete H[W]}delete U[F],Object.keys(U).length===0&&delete i[D]}}}function B(){L(),o=!0,s!==r&&(s=r,c(s.object))}function L(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:B,resetDefaultState:L,dispose:C,releaseStatesOfGeometry:T,releaseStatesOfObject:M,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:b}}function XT(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function $T(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(y){return!(y!==ji&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let M=y===Ji&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==ui&&y!==Ki&&!M&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(et("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&et("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&et("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),v=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:x,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:b,maxVaryings:E,maxFragmentUniforms:v,maxSamples:C,samples:T}}function YT(n){let e=this,t=null,i=0,r=!1,s=!1,o=new Yi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||r;return r=d,i=h.length,f},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,x=h.clipIntersection,g=h.clipShadows,p=n.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let b=s?0:i,E=b*4,v=p.clippingState||null;l.value=v,v=u(m,d,E,f);for(let C=0;C!==E;++C)v[C]=t[C];p.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,m){let x=h!==null?h.length:0,g=null;if(x!==0){if(g=l.value,m!==!0||g===null){let p=f+x*4,b=d.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<p)&&(g=new Float32Array(p));for(let E=0,v=f;E!==x;++E,v+=4)o.copy(h[E]).applyMatrix4(b,a),o.normal.toArray(g,v),g[v+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=x,e.numIntersection=0,g}}var Hl=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new bl(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},r=new qr(5,5,5),s=new li({name:"CubemapFromEquirect",uniforms:js(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:fn,blending:$s});s.uniforms.tEquirect.value=t;let o=new Ct(r,s),a=t.minFilter;return t.minFilter===Zr&&(t.minFilter=ii),new ca(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},Ty=256,ZT=3,KT=20,Zy=256,Ky=16,JT=3,jT=new Z,QT=new je,Ih=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ca(1,10,null),this._boxMesh=new Ct(new qr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=jT}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,x=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(e.background=l.getClearColor(QT));let g=new ca(i,r,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=x,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Ry(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Ty,_y(e))}_fromTexture(e,t){e.mapping===Zs||e.mapping===da?this._setSize(e.image.length===0?Ty:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Ey(e,!1,!1),i=Math.log2(e)-ZT;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ey(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Zs||e.mapping===da?(this._cubemapMaterial===null&&(this._cubemapMaterial=Ry()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cy()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=eE(),this._integrationMaterial=tE());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/Ky);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-JT)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Zy*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=nE());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function Ey(n,e,t){return new Hl(n,{minFilter:Zr,generateMipmaps:e,type:Ji,colorSpace:cl,depthBuffer:t})}function Gl(n,e,t){return new li({name:n,uniforms:e,vertexShader:mt.cube_vert,fragmentShader:t,side:fn,blending:$s,depthTest:!1,depthWrite:!1})}function eE(){return Gl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Zy}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function tE(){return Gl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Ky}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function nE(){return Gl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${KT}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Cy(){return Gl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Ry(){return Gl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function iE(n){let e=new WeakMap,t=new WeakMap,i=null;function r(d,f=!1){return d==null?null:f?o(d):s(d)}function s(d){if(d&&d.isTexture){let f=d.mapping;if(f===Gu||f===Wu)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let x=new Hl(m.height);return x.fromEquirectangularTexture(n,d),e.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===Gu||f===Wu,x=f===Zs||f===da;if(m||x){let g=t.get(d),p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new Ih(n)),g=m?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let b=d.image;return m&&b&&b.height>0||x&&b&&l(b)?(i===null&&(i=new Ih(n)),g=m?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===Gu?d.mapping=Zs:f===Wu&&(d.mapping=da),d}function l(d){let f=0,m=6;for(let x=0;x<m;x++)d[x]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:h}}function rE(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&al("WebGLRenderer: "+i+" extension not supported."),r}}}function sE(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let x=s.get(m);x&&(e.remove(x),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,x){return r[x.id]!==void 0||(x.addEventListener("dispose",a),r[x.id]=new WeakRef(x),o.register(x,x.id,x),t.memory.geometries++),x}function u(m){let x=m.attributes;for(let g in x)e.update(x[g],n.ARRAY_BUFFER)}function h(m){let x=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let b=x!==null?x.array.length:g.array.length/3-1,E=g.count>=65535?xl:gl,v=new E(Math.ceil(b/3)*6,1),C=v.array;if(x!==null){let y=x.array;p=x.version;for(let M=0,B=0;M<b;M+=3){let L=y[M+0],I=y[M+1],D=y[M+2];C[B++]=L,C[B++]=I,C[B++]=I,C[B++]=D,C[B++]=D,C[B++]=L}}else{p=g.version;for(let y=0,M=0;y<b;y+=3){let B=y+0,L=y+1,I=y+2;C[M++]=B,C[M++]=L,C[M++]=L,C[M++]=I,C[M++]=I,C[M++]=B}}v.version=p;let T=s.get(m);T&&e.remove(T),s.set(m,v)}function d(m){let x=s.get(m);if(x){let g=m.index;g!==null&&x.version<g.version&&h(m)}else h(m);return s.get(m)}function f(){for(let m in r){let x=r[m].deref();x!==void 0&&l(x)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function oE(n,e,t){let i;function r(h){i=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,s,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,s,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,h,0,f);let x=0;for(let g=0;g<f;g++)x+=d[g];t.update(x,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function aE(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:rt("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function lE(n,e,t){let i=new WeakMap,r=new en;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let B=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],E=0;f===!0&&(E=1),m===!0&&(E=2),x===!0&&(E=3);let v=a.attributes.position.count*E,C=1;v>e.maxTextureSize&&(C=Math.ceil(v/e.maxTextureSize),v=e.maxTextureSize);let T=new Float32Array(v*C*4*h),y=new fl(T,v,C,h);y.type=Ki,y.needsUpdate=!0;let M=E*4;for(let L=0;L<h;L++){let I=g[L],D=p[L],U=b[L],F=v*C*4*L;for(let H=0;H<I.count;H++){let W=H*M;f===!0&&(r.fromBufferAttribute(I,H),T[F+W+0]=r.x,T[F+W+1]=r.y,T[F+W+2]=r.z,T[F+W+3]=0),m===!0&&(r.fromBufferAttribute(D,H),T[F+W+4]=r.x,T[F+W+5]=r.y,T[F+W+6]=r.z,T[F+W+7]=0),x===!0&&(r.fromBufferAttribute(U,H),T[F+W+8]=r.x,T[F+W+9]=r.y,T[F+W+10]=r.z,T[F+W+11]=U.itemSize===4?r.w:1)}}d={count:h,texture:y,size:new dt(v,C)},i.set(a,d),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let x=0;x<c.length;x++)f+=c[x];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:s}}function cE(n,e,t,i,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,d=e.get(c,h);if(s.get(d)!==u&&(e.update(d),s.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;s.get(f)!==u&&(f.update(),s.set(f,u))}return d}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var uE={[$f]:"LINEAR_TONE_MAPPING",[Yf]:"REINHARD_TONE_MAPPING",[Zf]:"CINEON_TONE_MAPPING",[Kf]:"ACES_FILMIC_TONE_MAPPING",[jf]:"AGX_TONE_MAPPING",[Qf]:"NEUTRAL_TONE_MAPPING",[Jf]:"CUSTOM_TONE_MAPPING"};function hE(n,e,t,i,r,s){let o=new bi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Vn;u.setAttribute("position",new kn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new kn([0,2,0,0,2,0],2));let h=new Cu({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Ct(u,h),f=new Rl(-1,1,1,-1,0,1),m=null,x=null,g=!1,p,b=null,E=[],v=!1;this.setSize=function(C,T){o.setSize(C,T),a!==null&&a.setSize(C,T),l!==null&&l.setSize(C,T);for(let y=0;y<E.length;y++){let M=E[y];M.setSize&&M.setSize(C,T)}},this.setEffects=function(C){E=C,v=E.length>0&&E[0].isRenderPass===!0;let T=o.width,y=o.height;E.length>0&&a===null&&(a=new bi(T,y,{type:Ji,depthBuffer:!1,stencilBuffer:!1}),l=new bi(T,y,{type:Ji,depthBuffer:!1,stencilBuffer:!1}));let M=r===!0&&E.some(B=>B.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Wr(T,y),s===!0&&(c.format=Kr,c.type=Ks)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let B=0;B<E.length;B++){let L=E[B];L.setSize&&L.setSize(T,y),M&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(c)}},this.begin=function(C,T){if(g||C.toneMapping===Mr&&E.length===0)return!1;if(b=T,T!==null){let y=T.width,M=T.height;(o.width!==y||o.height!==M)&&this.setSize(y,M)}return v===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Mr,!0},this.hasRenderPass=function(){return v},this.end=function(C,T){C.toneMapping=p,g=!0;let y=o,M=a;for(let B=0;B<E.length;B++){let L=E[B];L.enabled!==!1&&(L.render(C,M,y,T),L.needsSwap!==!1&&(y=M,M=M===a?l:a))}if(m!==C.outputColorSpace||x!==C.toneMapping){m=C.outputColorSpace,x=C.toneMapping,h.defines={},wt.getTransfer(m)===Lt&&(h.defines.SRGB_TRANSFER="");let B=uE[x];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=y.texture,C.setRenderTarget(b),C.render(d,f),b=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var Jy=new ai,jy=new Wr(1,1),Qy=new vl(1),e_=new fl,t_=new Au,n_=new bl,Py=[],Iy=[],Ly=new Float32Array(16),Fy=new Float32Array(9),Ny=new Float32Array(4);function ma(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Py[r];if(s===void 0&&(s=new Float32Array(r),Py[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Tn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Fh(n,e){let t=Iy[e];t===void 0&&(t=new Int32Array(e),Iy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function dE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function fE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function pE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Tn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function mE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function gE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;Ny.set(i),n.uniformMatrix2fv(this.addr,!1,Ny),En(t,i)}}function xE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;Fy.set(i),n.uniformMatrix3fv(this.addr,!1,Fy),En(t,i)}}function yE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;Ly.set(i),n.uniformMatrix4fv(this.addr,!1,Ly),En(t,i)}}function _E(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function bE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function vE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function wE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function SE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function AE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function ME(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function TE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function Nh(n){return n.version===0&&(n.compareFunction=up,n.needsUpdate=!0),n}function EE(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Nh(jy):s=Jy,t.setTexture2D(e||s,r)}function CE(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||t_,r)}function RE(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Nh(Qy):s=n_,t.setTextureCube(e||s,r)}function PE(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||e_,r)}function IE(n){switch(n){case 5126:return dE;case 35664:return fE;case 35665:return pE;case 35666:return mE;case 35674:return gE;case 35675:return xE;case 35676:return yE;case 5124:case 35670:return _E;case 35667:case 35671:return bE;case 35668:case 35672:return vE;case 35669:case 35673:return wE;case 5125:return SE;case 36294:return AE;case 36295:return ME;case 36296:return TE;case 35678:case 36198:case 36298:case 36306:case 35682:return EE;case 35679:case 36299:case 36307:return CE;case 35680:case 36300:case 36308:case 36293:return RE;case 36289:case 36303:case 36311:case 36292:return PE}}function LE(n,e){n.uniform1fv(this.addr,e)}function FE(n,e){let t=ma(e,this.size,2);n.uniform2fv(this.addr,t)}function NE(n,e){let t=ma(e,this.size,3);n.uniform3fv(this.addr,t)}function BE(n,e){let t=ma(e,this.size,4);n.uniform4fv(this.addr,t)}function DE(n,e){let t=ma(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function kE(n,e){let t=ma(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function OE(n,e){let t=ma(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function UE(n,e){n.uniform1iv(this.addr,e)}function zE(n,e){n.uniform2iv(this.addr,e)}function VE(n,e){n.uniform3iv(this.addr,e)}function HE(n,e){n.uniform4iv(this.addr,e)}function GE(n,e){n.uniform1uiv(this.addr,e)}function WE(n,e){n.uniform2uiv(this.addr,e)}function qE(n,e){n.uniform3uiv(this.addr,e)}function XE(n,e){n.uniform4uiv(this.addr,e)}function $E(n,e,t){let i=this.cache,r=e.length,s=Fh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Nh(jy):o=Jy;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function YE(n,e,t){let i=this.cache,r=e.length,s=Fh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||t_,s[o])}function ZE(n,e,t){let i=this.cache,r=e.length,s=Fh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Nh(Qy):o=n_;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function KE(n,e,t){let i=this.cache,r=e.length,s=Fh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||e_,s[o])}function JE(n){switch(n){case 5126:return LE;case 35664:return FE;case 35665:return NE;case 35666:return BE;case 35674:return DE;case 35675:return kE;case 35676:return OE;case 5124:case 35670:return UE;case 35667:case 35671:return zE;case 35668:case 35672:return VE;case 35669:case 35673:return HE;case 5125:return GE;case 36294:return WE;case 36295:return qE;case 36296:return XE;case 35678:case 36198:case 36298:case 36306:case 35682:return $E;case 35679:case 36299:case 36307:return YE;case 35680:case 36300:case 36308:case 36293:return ZE;case 36289:case 36303:case 36311:case 36292:return KE}}var _p=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=IE(t.type)}},bp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=JE(t.type)}},vp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},xp=/(\w+)(\])?(\[|\.)?/g;function By(n,e){n.seq.push(e),n.map[e.id]=e}function jE(n,e,t){let i=n.name,r=i.length;for(xp.lastIndex=0;;){let s=xp.exec(i),o=xp.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){By(t,c===void 0?new _p(a,n,e):new bp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new vp(a),By(t,h)),t=h}}}var pa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);jE(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function Dy(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var QE=37297,eC=0;function tC(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var ky=new st;function nC(n){wt._getMatrix(ky,wt.workingColorSpace,n);let e=`mat3( ${ky.elements.map(t=>t.toFixed(4))} )`;switch(wt.getTransfer(n)){case ul:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return et("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Oy(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+tC(n.getShaderSource(e),a)}else return s}function iC(n,e){let t=nC(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var rC={[$f]:"Linear",[Yf]:"Reinhard",[Zf]:"Cineon",[Kf]:"ACESFilmic",[jf]:"AgX",[Qf]:"Neutral",[Jf]:"Custom"};function sC(n,e){let t=rC[e];return t===void 0?(et("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ph=new Z;function oC(){wt.getLuminanceCoefficients(Ph);let n=Ph.x.toFixed(4),e=Ph.y.toFixed(4),t=Ph.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function aC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Vl).join(`
`)}function lC(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function cC(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Vl(n){return n!==""}function Uy(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function zy(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var uC=/^[ \t]*#include +<([\w\d./]+)>/gm;function wp(n){return n.replace(uC,hC)}function hC(n,e){let t=mt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return wp(t)}var dC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vy(n){return n.replace(dC,fC)}function fC(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function Hy(n){let e=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var pC={[Xs]:"SHADOWMAP_TYPE_PCF",[ua]:"SHADOWMAP_TYPE_VSM"};function mC(n){return pC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var gC={[da]:"ENVMAP_MODE_REFRACTION"};function xC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":gC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var yC={[Il]:"ENVMAP_BLENDING_MULTIPLY",[ry]:"ENVMAP_BLENDING_MIX",[sy]:"ENVMAP_BLENDING_ADD"};function _C(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":yC[n.combine]||"ENVMAP_BLENDING_NONE"}function bC(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=mC(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=xC(t),h=_C(t),d=aC(t),f=lC(s),m=r.createProgram(),x,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(x=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Vl).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Vl).join(`
`),g.length>0&&(g+=`
`)):(x=[Hy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Vl).join(`
`),g=[Hy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Mr?"#define TONE_MAPPING":"",t.toneMapping!==Mr?mt.tonemapping_pars_fragment:"",t.toneMapping!==Mr?sC("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",mt.colorspace_pars_fragment,iC("linearToOutputTexel",t.outputColorSpace),oC(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Vl).join(`
`)),o=wp(o),o=Uy(o,t),o=zy(o,t),a=wp(a),a=Uy(a,t),a=zy(a,t),o=Vy(o),a=Vy(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",t.glslVersion===dp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===dp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let b=p+x+o,E=p+g+a,v=Dy(r,r.VERTEX_SHADER,b),C=Dy(r,r.FRAGMENT_SHADER,E);r.attachShader(m,v),r.attachShader(m,C),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function T(L){if(n.debug.checkShaderErrors){let I=r.getProgramInfoLog(m)||"",D=r.getShaderInfoLog(v)||"",U=r.getShaderInfoLog(C)||"",F=I.trim(),H=D.trim(),W=U.trim(),V=!0,ae=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,v,C);else{let $=Oy(r,v,"vertex"),j=Oy(r,C,"fragment");rt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+F+`
`+$+`
`+j)}else F!==""?et("WebGLProgram: Program Info Log:",F):(H===""||W==="")&&(ae=!1);ae&&(L.diagnostics={runnable:V,programLog:F,vertexShader:{log:H,prefix:x},fragmentShader:{log:W,prefix:g}})}r.deleteShader(v),r.deleteShader(C),y=new pa(r,m),M=cC(r,m)}let y;this.getUniforms=function(){return y===void 0&&T(this),y};let M;this.getAttributes=function(){return M===void 0&&T(this),M};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=r.getProgramParameter(m,QE)),B},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=eC++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=v,this.fragmentShader=C,this}var vC=0,Sp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ap(e),t.set(e,i)),i}},Ap=class{constructor(e){this.id=vC++,this.code=e,this.usedTimes=0}};function wC(n){return n===Ms||n===kl||n===Ol}function SC(n,e,t,i,r,s){let o=new pl,a=new Sp,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function m(y,M,B,L,I,D){let U=L.fog,F=I.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,V=e.get(y.envMap||H,W),ae=d[y.type],$=i.precision;y.precision!==null&&($=i.getMaxPrecision(y.precision),$!==y.precision&&et("WebGLProgram.getParameters:",y.precision,"not supported, using",$,"instead."));let j=F.morphAttributes.position||F.morphAttributes.normal||F.morphAttributes.color,te=j!==void 0?j.length:0,ue=0;F.morphAttributes.position!==void 0&&(ue=1),F.morphAttributes.normal!==void 0&&(ue=2),F.morphAttributes.color!==void 0&&(ue=3);let he,ee,ge,be;if(ae){let Ie=Er[ae];he=Ie.vertexShader,ee=Ie.fragmentShader}else{he=y.vertexShader,ee=y.fragmentShader;let Ie=a.getVertexShaderStage(y),ut=a.getFragmentShaderStage(y);a.update(y,Ie,ut),ge=Ie.id,be=ut.id}let Pe=n.getRenderTarget(),Ae=n.state.buffers.depth.getReversed(),$e=I.isInstancedMesh===!0,lt=I.isBatchedMesh===!0,qe=!!y.map,gt=!!y.matcap,ft=!!V,ot=ft&&V.isPMREMTexture===!0,Jt=!!y.aoMap,Wt=!!y.lightMap,pn=!!y.bumpMap&&y.wireframe===!1,Ot=!!y.normalMap,Pn=!!y.displacementMap,Tt=!!y.emissiveMap,An=!!y.metalnessMap,sn=!!y.roughnessMap,mn=y.anisotropy>0,O=y.clearcoat>0,Le=y.diffuseRoughness>0,Je=y.dispersion>0,ct=y.retroreflectivity>0,Me=y.iridescence>0,Vt=y.sheen>0,Ge=y.transmission>0,Ke=mn&&!!y.anisotropyMap,R=O&&!!y.clearcoatMap,w=O&&!!y.clearcoatNormalMap,q=O&&!!y.clearcoatRoughnessMap,de=Le&&!!y.diffuseRoughnessMap,oe=Me&&!!y.iridescenceMap,ye=Me&&!!y.iridescenceThicknessMap,ve=Vt&&!!y.sheenColorMap,ne=Vt&&!!y.sheenRoughnessMap,re=!!y.specularMap,me=!!y.specularColorMap,k=!!y.specularIntensityMap,se=Ge&&!!y.transmissionMap,ie=Ge&&!!y.thicknessMap,Te=!!y.gradientMap,xe=!!y.alphaMap,Se=y.alphaTest>0,Xe=!!y.alphaHash,tt=!!y.extensions,ce=Mr;y.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze=ot?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,nt={shaderID:ae,shaderType:y.type,shaderName:y.name,vertexShader:he,fragmentShader:ee,defines:y.defines,customVertexShaderID:ge,customFragmentShaderID:be,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:$,batching:lt,batchingColor:lt&&I._colorsTexture!==null,instancing:$e,instancingColor:$e&&I.instanceColor!==null,instancingMorph:$e&&I.morphTexture!==null,outputColorSpace:Pe===null?n.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:wt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:qe,matcap:gt,envMap:ft,envMapMode:ft&&V.mapping,envMapPMREM:ot,envMapMaxLod:ot?ze.length-1:null,envMapSize:ot?ze[0].width:null,aoMap:Jt,lightMap:Wt,bumpMap:pn,normalMap:Ot,displacementMap:Pn,emissiveMap:Tt,normalMapObjectSpace:Ot&&y.normalMapType===ly,normalMapTangentSpace:Ot&&y.normalMapType===Ul,packedNormalMap:Ot&&y.normalMapType===Ul&&wC(y.normalMap.format),metalnessMap:An,roughnessMap:sn,anisotropy:mn,anisotropyMap:Ke,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:w,clearcoatRoughnessMap:q,diffuseRoughness:Le,diffuseRoughnessMap:de,dispersion:Je,retroreflection:ct,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:Vt,sheenColorMap:ve,sheenRoughnessMap:ne,specularMap:re,specularColorMap:me,specularIntensityMap:k,transmission:Ge,transmissionMap:se,thicknessMap:ie,gradientMap:Te,opaque:y.transparent===!1&&y.blending===ha&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Xe,combine:y.combine,mapUv:qe&&f(y.map.channel),aoMapUv:Jt&&f(y.aoMap.channel),lightMapUv:Wt&&f(y.lightMap.channel),bumpMapUv:pn&&f(y.bumpMap.channel),normalMapUv:Ot&&f(y.normalMap.channel),displacementMapUv:Pn&&f(y.displacementMap.channel),emissiveMapUv:Tt&&f(y.emissiveMap.channel),metalnessMapUv:An&&f(y.metalnessMap.channel),roughnessMapUv:sn&&f(y.roughnessMap.channel),anisotropyMapUv:Ke&&f(y.anisotropyMap.channel),clearcoatMapUv:R&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:w&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:re&&f(y.specularMap.channel),specularColorMapUv:me&&f(y.specularColorMap.channel),specularIntensityMapUv:k&&f(y.specularIntensityMap.channel),transmissionMapUv:se&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!F.attributes.tangent&&(Ot||mn),vertexNormals:!!F.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!F.attributes.color&&F.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!F.attributes.uv&&(qe||xe),fog:!!U,useFog:y.fog===!0,fogExp2:!!U&&U.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||F.attributes.normal===void 0&&Ot===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Ae,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:F.attributes.position!==void 0,morphTargets:F.morphAttributes.position!==void 0,morphNormals:F.morphAttributes.normal!==void 0,morphColors:F.morphAttributes.color!==void 0,morphTargetsCount:te,morphTextureStride:ue,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:D.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&B.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:qe&&y.map.isVideoTexture===!0&&wt.getTransfer(y.map.colorSpace)===Lt,decodeVideoTextureEmissive:Tt&&y.emissiveMap.isVideoTexture===!0&&wt.getTransfer(y.emissiveMap.colorSpace)===Lt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Ni,flipSided:y.side===fn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:tt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&y.extensions.multiDraw===!0||lt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function x(y){let M=[];if(y.shaderID?M.push(y.shaderID):(M.push(y.customVertexShaderID),M.push(y.customFragmentShaderID)),y.defines!==void 0)for(let B in y.defines)M.push(B),M.push(y.defines[B]);return y.isRawShaderMaterial===!1&&(g(M,y),p(M,y),M.push(n.outputColorSpace)),M.push(y.customProgramCacheKey),M.join()}function g(y,M){y.push(M.precision),y.push(M.outputColorSpace),y.push(M.envMapMode),y.push(M.envMapPMREM),y.push(M.envMapMaxLod),y.push(M.envMapSize),y.push(M.mapUv),y.push(M.alphaMapUv),y.push(M.lightMapUv),y.push(M.aoMapUv),y.push(M.bumpMapUv),y.push(M.normalMapUv),y.push(M.displacementMapUv),y.push(M.emissiveMapUv),y.push(M.metalnessMapUv),y.push(M.roughnessMapUv),y.push(M.anisotropyMapUv),y.push(M.clearcoatMapUv),y.push(M.clearcoatNormalMapUv),y.push(M.clearcoatRoughnessMapUv),y.push(M.diffuseRoughnessMapUv),y.push(M.iridescenceMapUv),y.push(M.iridescenceThicknessMapUv),y.push(M.sheenColorMapUv),y.push(M.sheenRoughnessMapUv),y.push(M.specularMapUv),y.push(M.specularColorMapUv),y.push(M.specularIntensityMapUv),y.push(M.transmissionMapUv),y.push(M.thicknessMapUv),y.push(M.combine),y.push(M.fogExp2),y.push(M.sizeAttenuation),y.push(M.morphTargetsCount),y.push(M.numSunLights),y.push(M.numDirLights),y.push(M.numPointLights),y.push(M.numSpotLights),y.push(M.numSpotLightMaps),y.push(M.numHemiLights),y.push(M.numRectAreaLights),y.push(M.numSunLightShadows),y.push(M.numDirLightShadows),y.push(M.numPointLightShadows),y.push(M.numSpotLightShadows),y.push(M.numSpotLightShadowsWithMaps),y.push(M.numLightProbes),y.push(M.numLightProbeGrids),y.push(M.shadowMapType),y.push(M.toneMapping),y.push(M.numClippingPlanes),y.push(M.numClipIntersection),y.push(M.depthPacking)}function p(y,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function b(y){let M=d[y.type],B;if(M){let L=Er[M];B=Sy.clone(L.uniforms)}else B=y.uniforms;return B}function E(y,M){let B=u.get(M);return B!==void 0?++B.usedTimes:(B=new bC(n,M,y,r),c.push(B),u.set(M,B)),B}function v(y){if(--y.usedTimes===0){let M=c.indexOf(y);c[M]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function C(y){a.remove(y)}function T(){a.dispose()}return{getParameters:m,getProgramCacheKey:x,getUniforms:b,acquireProgram:E,releaseProgram:v,releaseShaderCache:C,programs:c,dispose:T}}function AC(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function MC(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Gy(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Wy(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,x,g,p){let b=n[e];return b===void 0?(b={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:g,group:p},n[e]=b):(b.id=d.id,b.object=d,b.geometry=f,b.material=m,b.materialVariant=o(d),b.groupOrder=x,b.renderOrder=d.renderOrder,b.z=g,b.group=p),e++,b}function l(d,f,m,x,g,p,b){b.reversedDepth===!0&&(g=-g);let E=a(d,f,m,x,g,p);m.transmission>0?i.push(E):m.transparent===!0?r.push(E):t.push(E)}function c(d,f,m,x,g,p){let b=a(d,f,m,x,g,p);m.transmission>0?i.unshift(b):m.transparent===!0?r.unshift(b):t.unshift(b)}function u(d,f){t.length>1&&t.sort(d||MC),i.length>1&&i.sort(f||Gy),r.length>1&&r.sort(f||Gy)}function h(){for(let d=e,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function TC(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new Wy,n.set(i,[o])):r>=s.length?(o=new Wy,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function EC(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Z,color:new je};break;case"SpotLight":t={position:new Z,direction:new Z,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Z,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Z,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new Z,halfWidth:new Z,halfHeight:new Z};break}return n[e.id]=t,t}}}function CC(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var RC=0;function PC(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function IC(n){let e=new EC,t=CC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Z);let r=new Z,s=new Qt,o=new Qt;function a(c){let u=0,h=0,d=0;for(let D=0;D<9;D++)i.probe[D].set(0,0,0);let f=0,m=0,x=0,g=0,p=0,b=0,E=0,v=0,C=0,T=0,y=0,M=0,B=0,L=0;c.sort(PC);for(let D=0,U=c.length;D<U;D++){let F=c[D],H=F.color,W=F.intensity,V=F.distance,ae=null;if(F.shadow&&F.shadow.map&&(F.shadow.map.texture.format===Ms?ae=F.shadow.map.texture:ae=F.shadow.map.depthTexture||F.shadow.map.texture),F.isAmbientLight)u+=H.r*W,h+=H.g*W,d+=H.b*W;else if(F.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(F.sh.coefficients[$],W);L++}else if(F.isSunLight){let $=e.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,te=t.get(F);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),i.sunShadow[m]=te,i.sunShadowMap[m]=ae;let ue=j.getViewportCount();for(let he=0;he<ue;he++)i.sunShadowMatrix[x+he]=j.getMatrix(he),i.sunShadowCascade[x+he]=j._cascadeData[he];x+=ue,m++}i.sun[f]=$,f++}else if(F.isDirectionalLight){let $=e.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),F.castShadow){let j=F.shadow,te=t.get(F);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.directionalShadow[g]=te,i.directionalShadowMap[g]=ae,i.directionalShadowMatrix[g]=F.shadow.matrix,C++}i.directional[g]=$,g++}else if(F.isSpotLight){let $=e.get(F);$.position.setFromMatrixPosition(F.matrixWorld),$.color.copy(H).multiplyScalar(W),$.distance=V,$.coneCos=Math.cos(F.angle),$.penumbraCos=Math.cos(F.angle*(1-F.penumbra)),$.decay=F.decay,i.spot[b]=$;let j=F.shadow;if(F.map&&(i.spotLightMap[M]=F.map,M++,j.updateMatrices(F),F.castShadow&&B++),i.spotLightMatrix[b]=j.matrix,F.castShadow){let te=t.get(F);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,i.spotShadow[b]=te,i.spotShadowMap[b]=ae,y++}b++}else if(F.isRectAreaLight){let $=e.get(F);$.color.copy(H).multiplyScalar(W),$.halfWidth.set(F.width*.5,0,0),$.halfHeight.set(0,F.height*.5,0),i.rectArea[E]=$,E++}else if(F.isPointLight){let $=e.get(F);if($.color.copy(F.color).multiplyScalar(F.intensity),$.distance=F.distance,$.decay=F.decay,F.castShadow){let j=F.shadow,te=t.get(F);te.shadowIntensity=j.intensity,te.shadowBias=j.bias,te.shadowNormalBias=j.normalBias,te.shadowRadius=j.radius,te.shadowMapSize=j.mapSize,te.shadowCameraNear=j.camera.near,te.shadowCameraFar=j.camera.far,i.pointShadow[p]=te,i.pointShadowMap[p]=ae,i.pointShadowMatrix[p]=F.shadow.matrix,T++}i.point[p]=$,p++}else if(F.isHemisphereLight){let $=e.get(F);$.skyColor.copy(F.color).multiplyScalar(W),$.groundColor.copy(F.groundColor).multiplyScalar(W),i.hemi[v]=$,v++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Be.LTC_FLOAT_1,i.rectAreaLTC2=Be.LTC_FLOAT_2):(i.rectAreaLTC1=Be.LTC_HALF_1,i.rectAreaLTC2=Be.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==b||I.rectAreaLength!==E||I.hemiLength!==v||I.numSunShadows!==m||I.numDirectionalShadows!==C||I.numPointShadows!==T||I.numSpotShadows!==y||I.numSpotMaps!==M||I.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=b,i.rectArea.length=E,i.point.length=p,i.hemi.length=v,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+M-B,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=B,i.numLightProbes=L,I.sunLength=f,I.directionalLength=g,I.pointLength=p,I.spotLength=b,I.rectAreaLength=E,I.hemiLength=v,I.numSunShadows=m,I.numDirectionalShadows=C,I.numPointShadows=T,I.numSpotShadows=y,I.numSpotMaps=M,I.numLightProbes=L,i.version=RC++)}function l(c,u){let h=0,d=0,f=0,m=0,x=0,g=0,p=u.matrixWorldInverse;for(let b=0,E=c.length;b<E;b++){let v=c[b];if(v.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),h++}else if(v.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(p),d++}else if(v.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(v.matrixWorld),r.setFromMatrixPosition(v.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(p),m++}else if(v.isRectAreaLight){let C=i.rectArea[x];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),o.identity(),s.copy(v.matrixWorld),s.premultiply(p),o.extractRotation(s),C.halfWidth.set(v.width*.5,0,0),C.halfHeight.set(0,v.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(v.matrixWorld),C.position.applyMatrix4(p),f++}else if(v.isHemisphereLight){let C=i.hemi[g];C.direction.setFromMatrixPosition(v.matrixWorld),C.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function qy(n){let e=new IC(n),t=[],i=[],r=[];function s(h){u.camera=h,t.length=0,i.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),r.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function LC(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new qy(n),e.set(r,[a])):s>=o.length?(a=new qy(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var FC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,NC=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,BC=[new Z(1,0,0),new Z(-1,0,0),new Z(0,1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1)],DC=[new Z(0,-1,0),new Z(0,-1,0),new Z(0,0,1),new Z(0,0,-1),new Z(0,-1,0),new Z(0,-1,0)],Xy=new Qt,zl=new Z,yp=new Z;function kC(n,e,t){let i=new bs,r=new dt,s=new dt,o=new en,a=new Ru,l=new Pu,c={},u=t.maxTextureSize,h={[ci]:fn,[fn]:ci,[Ni]:Ni},d=new li({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new dt},radius:{value:4}},vertexShader:FC,fragmentShader:NC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Vn;m.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ct(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xs;let p=this.type;this.render=function(T,y,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||T.length===0)return;this.type===Ux&&(et("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xs);let B=n.getRenderTarget(),L=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),D=n.state;D.setBlending($s),D.buffers.depth.getReversed()===!0?D.buffers.color.setClear(0,0,0,0):D.buffers.color.setClear(1,1,1,1),D.buffers.depth.setTest(!0),D.setScissorTest(!1);let U=p!==this.type;U&&y.traverse(function(F){F.material&&(Array.isArray(F.material)?F.material.forEach(H=>H.needsUpdate=!0):F.material.needsUpdate=!0)});for(let F=0,H=T.length;F<H;F++){let W=T[F],V=W.shadow;if(V===void 0){et("WebGLShadowMap:",W,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;r.copy(V.mapSize);let ae=V.getFrameExtents();r.multiply(ae),s.copy(V.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/ae.x),r.x=s.x*ae.x,V.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/ae.y),r.y=s.y*ae.y,V.mapSize.y=s.y));let $=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=$,V.map===null||U===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===ua){if(W.isPointLight){et("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new bi(r.x,r.y,{format:Ms,type:Ji,minFilter:ii,magFilter:ii,generateMipmaps:!1}),V.map.texture.name=W.name+".shadowMap",V.map.depthTexture=new Wr(r.x,r.y,Ki),V.map.depthTexture.name=W.name+".shadowMapDepth",V.map.depthTexture.format=Gr,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On}else W.isPointLight?(V.map=new Hl(r.x),V.map.depthTexture=new vl(r.x,Zi)):(V.map=new bi(r.x,r.y),V.map.depthTexture=new Wr(r.x,r.y,Zi)),V.map.depthTexture.name=W.name+".shadowMap",V.map.depthTexture.format=Gr,this.type===Xs?(V.map.depthTexture.compareFunction=$?cp:lp,V.map.depthTexture.minFilter=ii,V.map.depthTexture.magFilter=ii):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=On,V.map.depthTexture.magFilter=On);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==r.x||V.map.height!==r.y)&&V.map.setSize(r.x,r.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();W.isPointLight!==!0&&V.updateMatrices(W,M);let te=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:M.layers;for(let ue=0;ue<j;ue++){let he=V.getCamera(ue);if(W.isPointLight){let ee=V.camera,ge=V.matrix,be=W.distance||ee.far;be!==ee.far&&(ee.far=be,ee.updateProjectionMatrix()),zl.setFromMatrixPosition(W.matrixWorld),ee.position.copy(zl),yp.copy(ee.position),yp.add(BC[ue]),ee.up.copy(DC[ue]),ee.lookAt(yp),ee.updateMatrixWorld(),ge.makeTranslation(-zl.x,-zl.y,-zl.z),Xy.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Xy,ee.coordinateSystem,ee.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(V.map),n.clear());let ee=V.getViewport(ue);o.set(s.x*ee.x,s.y*ee.y,s.x*ee.z,s.y*ee.w),D.viewport(o)}i=V.getFrustum(ue),v(y,M,he,W,te,this.type)}V.isPointLightShadow!==!0&&this.type===ua&&b(V,M),V.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(B,L,I)};function b(T,y){let M=e.update(x);d.defines.VSM_SAMPLES!==T.blurSamples&&(d.defines.VSM_SAMPLES=T.blurSamples,f.defines.VSM_SAMPLES=T.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),T.mapPass===null?T.mapPass=new bi(r.x,r.y,{format:Ms,type:Ji}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),d.uniforms.shadow_pass.value=T.map.depthTexture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(y,null,M,d,x,null),f.uniforms.shadow_pass.value=T.mapPass.texture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(y,null,M,f,x,null)}function E(T,y,M,B){let L=null,I=M.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)L=I;else if(L=M.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let D=L.uuid,U=y.uuid,F=c[D];F===void 0&&(F={},c[D]=F);let H=F[U];H===void 0&&(H=L.clone(),F[U]=H,y.addEventListener("dispose",C)),L=H}if(L.visible=y.visible,L.wireframe=y.wireframe,B===ua?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:h[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,M.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let D=n.properties.get(L);D.light=M}return L}function v(T,y,M,B,L,I){if(T.visible===!1)return;if(T.layers.test(L)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&I===ua)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,T.matrixWorld);let F=e.update(T),H=T.material;if(Array.isArray(H)){let W=F.groups;for(let V=0,ae=W.length;V<ae;V++){let $=W[V],j=H[$.materialIndex];if(j&&j.visible){let te=E(T,j,B,I);T.onBeforeShadow(n,T,y,M,F,te,$),n.renderBufferDirect(M,null,F,te,T,$),T.onAfterShadow(n,T,y,M,F,te,$)}}}else if(H.visible){let W=E(T,H,B,I);T.onBeforeShadow(n,T,y,M,F,W,null),n.renderBufferDirect(M,null,F,W,T,null),T.onAfterShadow(n,T,y,M,F,W,null)}}let U=T.children;for(let F=0,H=U.length;F<H;F++)v(U[F],y,M,B,L,I)}function C(T){T.target.removeEventListener("dispose",C);for(let M in c){let B=c[M],L=T.target.uuid;L in B&&(B[L].dispose(),delete B[L])}}}function OC(n,e){function t(){let k=!1,se=new en,ie=null,Te=new en(0,0,0,0);return{setMask:function(xe){ie!==xe&&!k&&(n.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){k=xe},setClear:function(xe,Se,Xe,tt,ce){ce===!0&&(xe*=tt,Se*=tt,Xe*=tt),se.set(xe,Se,Xe,tt),Te.equals(se)===!1&&(n.clearColor(xe,Se,Xe,tt),Te.copy(se))},reset:function(){k=!1,ie=null,Te.set(-1,0,0,0)}}}function i(){let k=!1,se=!1,ie=null,Te=null,xe=null;return{setReversed:function(Se){if(se!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),se=Se;let tt=xe;xe=null,this.setClear(tt)}},getReversed:function(){return se},setTest:function(Se){Se?Ae(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!k&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(se&&(Se=yy[Se]),Te!==Se){switch(Se){case hu:n.depthFunc(n.NEVER);break;case du:n.depthFunc(n.ALWAYS);break;case fu:n.depthFunc(n.LESS);break;case na:n.depthFunc(n.LEQUAL);break;case pu:n.depthFunc(n.EQUAL);break;case mu:n.depthFunc(n.GEQUAL);break;case gu:n.depthFunc(n.GREATER);break;case xu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){k=Se},setClear:function(Se){xe!==Se&&(xe=Se,se&&(Se=1-Se),n.clearDepth(Se))},reset:function(){k=!1,ie=null,Te=null,xe=null,se=!1}}}function r(){let k=!1,se=null,ie=null,Te=null,xe=null,Se=null,Xe=null,tt=null,ce=null;return{setTest:function(ze){k||(ze?Ae(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(ze){se!==ze&&!k&&(n.stencilMask(ze),se=ze)},setFunc:function(ze,nt,Ie){(ie!==ze||Te!==nt||xe!==Ie)&&(n.stencilFunc(ze,nt,Ie),ie=ze,Te=nt,xe=Ie)},setOp:function(ze,nt,Ie){(Se!==ze||Xe!==nt||tt!==Ie)&&(n.stencilOp(ze,nt,Ie),Se=ze,Xe=nt,tt=Ie)},setLocked:function(ze){k=ze},setClear:function(ze){ce!==ze&&(n.clearStencil(ze),ce=ze)},reset:function(){k=!1,se=null,ie=null,Te=null,xe=null,Se=null,Xe=null,tt=null,ce=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],x=null,g=!1,p=null,b=null,E=null,v=null,C=null,T=null,y=null,M=new je(0,0,0),B=0,L=!1,I=null,D=null,U=null,F=null,H=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,ae=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec($)[1]),V=ae>=1):$.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),V=ae>=2);let j=null,te={},ue=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new en().fromArray(ue),ge=new en().fromArray(he);function be(k,se,ie,Te){let xe=new Uint8Array(4),Se=n.createTexture();n.bindTexture(k,Se),n.texParameteri(k,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(k,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ie;Xe++)k===n.TEXTURE_3D||k===n.TEXTURE_2D_ARRAY?n.texImage3D(se,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(se+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Se}let Pe={};Pe[n.TEXTURE_2D]=be(n.TEXTURE_2D,n.TEXTURE_2D,1),Pe[n.TEXTURE_CUBE_MAP]=be(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[n.TEXTURE_2D_ARRAY]=be(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pe[n.TEXTURE_3D]=be(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ae(n.DEPTH_TEST),o.setFunc(na),pn(!1),Ot(Vf),Ae(n.CULL_FACE),Jt($s);function Ae(k){u[k]!==!0&&(n.enable(k),u[k]=!0)}function $e(k){u[k]!==!1&&(n.disable(k),u[k]=!1)}function lt(k,se){return d[k]!==se?(n.bindFramebuffer(k,se),d[k]=se,k===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=se),k===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=se),!0):!1}function qe(k,se){let ie=m,Te=!1;if(k){ie=f.get(se),ie===void 0&&(ie=[],f.set(se,ie));let xe=k.textures;if(ie.length!==xe.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Xe=xe.length;Se<Xe;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=xe.length,Te=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ie)}function gt(k){return x!==k?(n.useProgram(k),x=k,!0):!1}let ft={[Ys]:n.FUNC_ADD,[Vx]:n.FUNC_SUBTRACT,[Hx]:n.FUNC_REVERSE_SUBTRACT};ft[Gx]=n.MIN,ft[Wx]=n.MAX;let ot={[qx]:n.ZERO,[Xx]:n.ONE,[$x]:n.SRC_COLOR,[qf]:n.SRC_ALPHA,[Qx]:n.SRC_ALPHA_SATURATE,[Jx]:n.DST_COLOR,[Zx]:n.DST_ALPHA,[Yx]:n.ONE_MINUS_SRC_COLOR,[Xf]:n.ONE_MINUS_SRC_ALPHA,[jx]:n.ONE_MINUS_DST_COLOR,[Kx]:n.ONE_MINUS_DST_ALPHA,[ey]:n.CONSTANT_COLOR,[ty]:n.ONE_MINUS_CONSTANT_COLOR,[ny]:n.CONSTANT_ALPHA,[iy]:n.ONE_MINUS_CONSTANT_ALPHA};function Jt(k,se,ie,Te,xe,Se,Xe,tt,ce,ze){if(k===$s){g===!0&&($e(n.BLEND),g=!1);return}if(g===!1&&(Ae(n.BLEND),g=!0),k!==zx){if(k!==p||ze!==L){if((b!==Ys||C!==Ys)&&(n.blendEquation(n.FUNC_ADD),b=Ys,C=Ys),ze)switch(k){case ha:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hf:n.blendFunc(n.ONE,n.ONE);break;case Gf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Wf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:rt("WebGLState: Invalid blending: ",k);break}else switch(k){case ha:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Gf:rt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wf:rt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:rt("WebGLState: Invalid blending: ",k);break}E=null,v=null,T=null,y=null,M.set(0,0,0),B=0,p=k,L=ze}return}xe=xe||se,Se=Se||ie,Xe=Xe||Te,(se!==b||xe!==C)&&(n.blendEquationSeparate(ft[se],ft[xe]),b=se,C=xe),(ie!==E||Te!==v||Se!==T||Xe!==y)&&(n.blendFuncSeparate(ot[ie],ot[Te],ot[Se],ot[Xe]),E=ie,v=Te,T=Se,y=Xe),(tt.equals(M)===!1||ce!==B)&&(n.blendColor(tt.r,tt.g,tt.b,ce),M.copy(tt),B=ce),p=k,L=!1}function Wt(k,se){k.side===Ni?$e(n.CULL_FACE):Ae(n.CULL_FACE);let ie=k.side===fn;se&&(ie=!ie),pn(ie),k.blending===ha&&k.transparent===!1?Jt($s):Jt(k.blending,k.blendEquation,k.blendSrc,k.blendDst,k.blendEquationAlpha,k.blendSrcAlpha,k.blendDstAlpha,k.blendColor,k.blendAlpha,k.premultipliedAlpha),o.setFunc(k.depthFunc),o.setTest(k.depthTest),o.setMask(k.depthWrite),s.setMask(k.colorWrite);let Te=k.stencilWrite;a.setTest(Te),Te&&(a.setMask(k.stencilWriteMask),a.setFunc(k.stencilFunc,k.stencilRef,k.stencilFuncMask),a.setOp(k.stencilFail,k.stencilZFail,k.stencilZPass)),Tt(k.polygonOffset,k.polygonOffsetFactor,k.polygonOffsetUnits),k.alphaToCoverage===!0?Ae(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function pn(k){I!==k&&(k?n.frontFace(n.CW):n.frontFace(n.CCW),I=k)}function Ot(k){k!==kx?(Ae(n.CULL_FACE),k!==D&&(k===Vf?n.cullFace(n.BACK):k===Ox?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),D=k}function Pn(k){k!==U&&(V&&n.lineWidth(k),U=k)}function Tt(k,se,ie){k?(Ae(n.POLYGON_OFFSET_FILL),(F!==se||H!==ie)&&(F=se,H=ie,o.getReversed()&&(se=-se,ie=-ie),n.polygonOffset(se,ie))):$e(n.POLYGON_OFFSET_FILL)}function An(k){k?Ae(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function sn(k){k===void 0&&(k=n.TEXTURE0+W-1),j!==k&&(n.activeTexture(k),j=k)}function mn(k,se,ie){ie===void 0&&(j===null?ie=n.TEXTURE0+W-1:ie=j);let Te=te[ie];Te===void 0&&(Te={type:void 0,texture:void 0},te[ie]=Te),(Te.type!==k||Te.texture!==se)&&(j!==ie&&(n.activeTexture(ie),j=ie),n.bindTexture(k,se||Pe[k]),Te.type=k,Te.texture=se)}function O(){let k=te[j];k!==void 0&&k.type!==void 0&&(n.bindTexture(k.type,null),k.type=void 0,k.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function ct(){try{n.texSubImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function Me(){try{n.texSubImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function Vt(){try{n.compressedTexSubImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function Ke(){try{n.texStorage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function R(){try{n.texStorage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function w(){try{n.texImage2D(...arguments)}catch(k){rt("WebGLState:",k)}}function q(){try{n.texImage3D(...arguments)}catch(k){rt("WebGLState:",k)}}function de(k){return h[k]!==void 0?h[k]:n.getParameter(k)}function oe(k,se){h[k]!==se&&(n.pixelStorei(k,se),h[k]=se)}function ye(k){ee.equals(k)===!1&&(n.scissor(k.x,k.y,k.z,k.w),ee.copy(k))}function ve(k){ge.equals(k)===!1&&(n.viewport(k.x,k.y,k.z,k.w),ge.copy(k))}function ne(k,se){let ie=c.get(se);ie===void 0&&(ie=new WeakMap,c.set(se,ie));let Te=ie.get(k);Te===void 0&&(Te=n.getUniformBlockIndex(se,k.name),n.uniformBlockBinding(se,Te,Te),ie.set(k,Te))}function re(k,se,ie){let xe=c.get(se).get(k);l[xe]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,te={},d={},l={},f=new WeakMap,m=[],x=null,g=!1,p=null,b=null,E=null,v=null,C=null,T=null,y=null,M=new je(0,0,0),B=0,L=!1,I=null,D=null,U=null,F=null,H=null,ee.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:Ae,disable:$e,bindFramebuffer:lt,drawBuffers:qe,useProgram:gt,setBlending:Jt,setMaterial:Wt,setFlipSided:pn,setCullFace:Ot,setLineWidth:Pn,setPolygonOffset:Tt,setScissorTest:An,activeTexture:sn,bindTexture:mn,unbindTexture:O,compressedTexImage2D:Le,compressedTexImage3D:Je,texImage2D:w,texImage3D:q,pixelStorei:oe,getParameter:de,updateUBOMapping:ne,uniformBlockBinding:re,texStorage2D:Ke,texStorage3D:R,texSubImage2D:ct,texSubImage3D:Me,compressedTexSubImage2D:Vt,compressedTexSubImage3D:Ge,scissor:ye,viewport:ve,reset:me}}function UC(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new dt,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,x=new FinalizationRegistry(R=>m.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,w){return g?new OffscreenCanvas(R,w):hl("canvas")}function b(R,w,q){let de=1,oe=Ke(R);if((oe.width>q||oe.height>q)&&(de=q/Math.max(oe.width,oe.height)),de<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(de*oe.width),ve=Math.floor(de*oe.height);d===void 0&&(d=p(ye,ve));let ne=w?p(ye,ve):d;return ne.width=ye,ne.height=ve,ne.getContext("2d").drawImage(R,0,0,ye,ve),et("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+ve+")."),ne}else return"data"in R&&et("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function E(R){return R.generateMipmaps}function v(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(R,w,q,de,oe,ye=!1){if(R!==null){if(n[R]!==void 0)return n[R];et("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;de&&(ve=e.get("EXT_texture_norm16"),ve||et("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=w;if(w===n.RED&&(q===n.FLOAT&&(ne=n.R32F),q===n.HALF_FLOAT&&(ne=n.R16F),q===n.UNSIGNED_BYTE&&(ne=n.R8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.R16_EXT),q===n.SHORT&&ve&&(ne=ve.R16_SNORM_EXT)),w===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.R8UI),q===n.UNSIGNED_SHORT&&(ne=n.R16UI),q===n.UNSIGNED_INT&&(ne=n.R32UI),q===n.BYTE&&(ne=n.R8I),q===n.SHORT&&(ne=n.R16I),q===n.INT&&(ne=n.R32I)),w===n.RG&&(q===n.FLOAT&&(ne=n.RG32F),q===n.HALF_FLOAT&&(ne=n.RG16F),q===n.UNSIGNED_BYTE&&(ne=n.RG8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RG16_EXT),q===n.SHORT&&ve&&(ne=ve.RG16_SNORM_EXT)),w===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RG8UI),q===n.UNSIGNED_SHORT&&(ne=n.RG16UI),q===n.UNSIGNED_INT&&(ne=n.RG32UI),q===n.BYTE&&(ne=n.RG8I),q===n.SHORT&&(ne=n.RG16I),q===n.INT&&(ne=n.RG32I)),w===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),q===n.UNSIGNED_INT&&(ne=n.RGB32UI),q===n.BYTE&&(ne=n.RGB8I),q===n.SHORT&&(ne=n.RGB16I),q===n.INT&&(ne=n.RGB32I)),w===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),q===n.UNSIGNED_INT&&(ne=n.RGBA32UI),q===n.BYTE&&(ne=n.RGBA8I),q===n.SHORT&&(ne=n.RGBA16I),q===n.INT&&(ne=n.RGBA32I)),w===n.RGB&&(q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGB16_EXT),q===n.SHORT&&ve&&(ne=ve.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),w===n.RGBA){let re=ye?ul:wt.getTransfer(oe);q===n.FLOAT&&(ne=n.RGBA32F),q===n.HALF_FLOAT&&(ne=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ne=re===Lt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ve&&(ne=ve.RGBA16_EXT),q===n.SHORT&&ve&&(ne=ve.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(R,w){let q;return R?w===null||w===Zi||w===Ks?q=n.DEPTH24_STENCIL8:w===Ki?q=n.DEPTH32F_STENCIL8:w===fa&&(q=n.DEPTH24_STENCIL8,et("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):w===null||w===Zi||w===Ks?q=n.DEPTH_COMPONENT24:w===Ki?q=n.DEPTH_COMPONENT32F:w===fa&&(q=n.DEPTH_COMPONENT16),q}function M(R,w){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==ii?Math.log2(Math.max(w.width,w.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?w.mipmaps.length:1}function B(R){let w=new WeakRef(R);i.get(R).__ref=w,m.add(w),x.register(R,w,w)}function L(R){let w=i.get(R).__ref;w!==void 0&&(m.delete(w),x.unregister(w))}function I(R){U(R.target)}function D(R){F(R.target)}function U(R){R.removeEventListener("dispose",I),L(R),W(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function F(R){R.removeEventListener("dispose",D),L(R),ae(R)}function H(){for(let R of m){let w=R.deref();w!==void 0&&(w.isRenderTarget===!0?F(w):U(w))}m.clear(),h.clear()}function W(R){let w=i.get(R);if(w.__webglInit===void 0)return;let q=R.source,de=f.get(q);if(de){let oe=de[w.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&V(R),Object.keys(de).length===0&&f.delete(q)}i.remove(R)}function V(R){let w=i.get(R);n.deleteTexture(w.__webglTexture);let q=R.source,de=f.get(q);delete de[w.__cacheKey],o.memory.textures--}function ae(R){let w=i.get(R);w.__depthDisposeCallback&&w.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&U(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(w.__webglFramebuffer[oe]))for(let ye=0;ye<w.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(w.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(w.__webglFramebuffer[oe]);w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer[oe])}else{if(Array.isArray(w.__webglFramebuffer))for(let oe=0;oe<w.__webglFramebuffer.length;oe++)n.deleteFramebuffer(w.__webglFramebuffer[oe]);else n.deleteFramebuffer(w.__webglFramebuffer);if(w.__webglDepthbuffer&&n.deleteRenderbuffer(w.__webglDepthbuffer),w.__webglMultisampledFramebuffer&&n.deleteFramebuffer(w.__webglMultisampledFramebuffer),w.__webglColorRenderbuffer)for(let oe=0;oe<w.__webglColorRenderbuffer.length;oe++)w.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(w.__webglColorRenderbuffer[oe]);w.__webglDepthRenderbuffer&&n.deleteRenderbuffer(w.__webglDepthRenderbuffer)}let de=R.textures;for(let oe=0,ye=de.length;oe<ye;oe++){let ve=i.get(de[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(de[oe])}i.remove(R)}let $=0;function j(){$=0}function te(){return $}function ue(R){$=R}function he(){let R=$;return R>=r.maxTextures&&et("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),$+=1,R}function ee(R){let w=[];return w.push(R.wrapS),w.push(R.wrapT),w.push(R.wrapR||0),w.push(R.magFilter),w.push(R.minFilter),w.push(R.anisotropy),w.push(R.internalFormat),w.push(R.format),w.push(R.type),w.push(R.generateMipmaps),w.push(R.mipmapsAutoUpdate),w.push(R.premultiplyAlpha),w.push(R.flipY),w.push(R.unpackAlignment),w.push(R.colorSpace),w.join()}function ge(R,w){let q=i.get(R);if(R.isVideoTexture&&Vt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let de=R.image;if(de===null)et("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)et("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(q,R,w);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+w)}function be(R,w){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,w);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+w)}function Pe(R,w){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,w);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+w)}function Ae(R,w){let q=i.get(R);if(R.version>0&&q.__version!==R.version){pn(q,R,w);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+w)}let $e={[yu]:n.REPEAT,[vr]:n.CLAMP_TO_EDGE,[_u]:n.MIRRORED_REPEAT},lt={[On]:n.NEAREST,[oy]:n.NEAREST_MIPMAP_NEAREST,[Ll]:n.NEAREST_MIPMAP_LINEAR,[ii]:n.LINEAR,[qu]:n.LINEAR_MIPMAP_NEAREST,[Zr]:n.LINEAR_MIPMAP_LINEAR},qe={[uy]:n.NEVER,[up]:n.ALWAYS,[hy]:n.LESS,[lp]:n.LEQUAL,[dy]:n.EQUAL,[cp]:n.GEQUAL,[fy]:n.GREATER,[py]:n.NOTEQUAL};function gt(R,w){if(w.type===Ki&&e.has("OES_texture_float_linear")===!1&&(w.magFilter===ii||w.magFilter===qu||w.magFilter===Ll||w.magFilter===Zr||w.minFilter===ii||w.minFilter===qu||w.minFilter===Ll||w.minFilter===Zr)&&et("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,$e[w.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,$e[w.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,$e[w.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,lt[w.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,lt[w.minFilter]),w.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,qe[w.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(w.magFilter===On||w.minFilter!==Ll&&w.minFilter!==Zr||w.type===Ki&&e.has("OES_texture_float_linear")===!1)return;if(w.anisotropy>1||i.get(w).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(w.anisotropy,r.getMaxAnisotropy())),i.get(w).__currentAnisotropy=w.anisotropy}}}function ft(R,w){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,w.addEventListener("dispose",I),B(w));let de=w.source,oe=f.get(de);oe===void 0&&(oe={},f.set(de,oe));let ye=ee(w);if(ye!==R.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ye].usedTimes++;let ve=oe[R.__cacheKey];ve!==void 0&&(oe[R.__cacheKey].usedTimes--,ve.usedTimes===0&&V(w)),R.__cacheKey=ye,R.__webglTexture=oe[ye].texture}return q}function ot(R,w,q){return Math.floor(Math.floor(R/q)/w)}function Jt(R,w,q,de){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,w.width,w.height,q,de,w.data);else{ye.sort((k,se)=>k.start-se.start);let ve=0;for(let k=1;k<ye.length;k++){let se=ye[ve],ie=ye[k],Te=se.start+se.count,xe=ot(ie.start,w.width,4),Se=ot(se.start,w.width,4);ie.start<=Te+1&&xe===Se&&ot(ie.start+ie.count-1,w.width,4)===xe?se.count=Math.max(se.count,ie.start+ie.count-se.start):(++ve,ye[ve]=ie)}ye.length=ve+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,w.width);for(let k=0,se=ye.length;k<se;k++){let ie=ye[k],Te=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Se=Te%w.width,Xe=Math.floor(Te/w.width),tt=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Se,Xe,tt,ce,q,de,w.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Wt(R,w,q){let de=n.TEXTURE_2D;(w.isDataArrayTexture||w.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),w.isData3DTexture&&(de=n.TEXTURE_3D);let oe=ft(R,w),ye=w.source;t.bindTexture(de,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(ye);if(ye.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&w.image instanceof ImageBitmap)===!1){let ce=wt.getPrimaries(wt.workingColorSpace),ze=w.colorSpace===Jr?null:wt.getPrimaries(w.colorSpace),nt=w.colorSpace===Jr||ce===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment);let re=b(w.image,!1,r.maxTextureSize);re=Ge(w,re);let me=s.convert(w.format,w.colorSpace),k=s.convert(w.type),se=T(w.internalFormat,me,k,w.normalized,w.colorSpace,w.isVideoTexture);gt(de,w);let ie,Te=w.mipmaps,xe=w.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,Xe=ye.dataReady,tt=M(w,re);if(w.isDepthTexture)se=y(w.format===Kr,w.type),Se&&(xe?t.texStorage2D(n.TEXTURE_2D,1,se,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,se,re.width,re.height,0,me,k,null));else if(w.isDataTexture)if(Te.length>0){xe&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,se,Te[0].width,Te[0].height);for(let ce=0,ze=Te.length;ce<ze;ce++)ie=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(n.TEXTURE_2D,ce,se,ie.width,ie.height,0,me,k,ie.data);w.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(n.TEXTURE_2D,tt,se,re.width,re.height),Xe&&Jt(w,re,me,k)):t.texImage2D(n.TEXTURE_2D,0,se,re.width,re.height,0,me,k,re.data);else if(w.isCompressedTexture)if(w.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,se,Te[0].width,Te[0].height,re.depth);for(let ce=0,ze=Te.length;ce<ze;ce++)if(ie=Te[ce],w.format!==ji)if(me!==null)if(xe){if(Xe)if(w.layerUpdates.size>0){let nt=gp(ie.width,ie.height,w.format,w.type);for(let Ie of w.layerUpdates){let ut=ie.data.subarray(Ie*nt/ie.data.BYTES_PER_ELEMENT,(Ie+1)*nt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ie,ie.width,ie.height,1,me,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,re.depth,me,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,se,ie.width,ie.height,re.depth,0,ie.data,0,0);else et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,re.depth,me,k,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,se,ie.width,ie.height,re.depth,0,me,k,ie.data);w.layerUpdates.size>0&&w.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,se,Te[0].width,Te[0].height);for(let ce=0,ze=Te.length;ce<ze;ce++)ie=Te[ce],w.format!==ji?me!==null?xe?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,se,ie.width,ie.height,0,ie.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,me,k,ie.data):t.texImage2D(n.TEXTURE_2D,ce,se,ie.width,ie.height,0,me,k,ie.data)}else if(w.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,se,re.width,re.height,re.depth),Xe)if(w.layerUpdates.size>0){let ce=gp(re.width,re.height,w.format,w.type);for(let ze of w.layerUpdates){let nt=re.data.subarray(ze*ce/re.data.BYTES_PER_ELEMENT,(ze+1)*ce/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,re.width,re.height,1,me,k,nt)}w.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,me,k,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,se,re.width,re.height,re.depth,0,me,k,re.data);else if(w.isData3DTexture)xe?(Se&&t.texStorage3D(n.TEXTURE_3D,tt,se,re.width,re.height,re.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,me,k,re.data)):t.texImage3D(n.TEXTURE_3D,0,se,re.width,re.height,re.depth,0,me,k,re.data);else if(w.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(n.TEXTURE_2D,tt,se,re.width,re.height);else{let ce=re.width,ze=re.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,se,ce,ze,0,me,k,null),ce>>=1,ze>>=1}}else if(w.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),re.parentNode!==ce){ce.appendChild(re),h.add(w),ce.onpaint=ze=>{let nt=ze.changedElements;for(let Ie of h)nt.includes(Ie.image)&&(Ie.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let nt=n.RGBA,Ie=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Ie,ut,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Se){let ce=Ke(Te[0]);t.texStorage2D(n.TEXTURE_2D,tt,se,ce.width,ce.height)}for(let ce=0,ze=Te.length;ce<ze;ce++)ie=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,k,ie):t.texImage2D(n.TEXTURE_2D,ce,se,me,k,ie);w.generateMipmaps=!1}else if(xe){if(Se){let ce=Ke(re);t.texStorage2D(n.TEXTURE_2D,tt,se,ce.width,ce.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,k,re)}else t.texImage2D(n.TEXTURE_2D,0,se,me,k,re);E(w)&&w.mipmapsAutoUpdate===!0&&v(de),ve.__version=ye.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function pn(R,w,q){if(w.image.length!==6)return;let de=ft(R,w),oe=w.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(oe);if(oe.version!==ye.__version||de===!0){t.activeTexture(n.TEXTURE0+q);let ve=wt.getPrimaries(wt.workingColorSpace),ne=w.colorSpace===Jr?null:wt.getPrimaries(w.colorSpace),re=w.colorSpace===Jr||ve===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,w.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,w.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,w.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let me=w.isCompressedTexture||w.image[0].isCompressedTexture,k=w.image[0]&&w.image[0].isDataTexture,se=[];for(let Ie=0;Ie<6;Ie++)!me&&!k?se[Ie]=b(w.image[Ie],!0,r.maxCubemapSize):se[Ie]=k?w.image[Ie].image:w.image[Ie],se[Ie]=Ge(w,se[Ie]);let ie=se[0],Te=s.convert(w.format,w.colorSpace),xe=s.convert(w.type),Se=T(w.internalFormat,Te,xe,w.normalized,w.colorSpace),Xe=w.isVideoTexture!==!0,tt=ye.__version===void 0||de===!0,ce=oe.dataReady,ze=M(w,ie);gt(n.TEXTURE_CUBE_MAP,w);let nt;if(w.isDepthTexture){if(Se=y(w.format===Kr,w.type),tt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,ie.width,ie.height,0,Te,xe,null)}else if(me){Xe&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,ie.width,ie.height);for(let Ie=0;Ie<6;Ie++){nt=se[Ie].mipmaps;for(let ut=0;ut<nt.length;ut++){let qt=nt[ut];w.format!==ji?Te!==null?Xe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,qt.width,qt.height,Te,qt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Se,qt.width,qt.height,0,qt.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,qt.width,qt.height,Te,xe,qt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Se,qt.width,qt.height,0,Te,xe,qt.data)}}}else{if(nt=w.mipmaps,Xe&&tt){nt.length>0&&ze++;let Ie=Ke(se[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(k){Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,se[Ie].width,se[Ie].height,Te,xe,se[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,se[Ie].width,se[Ie].height,0,Te,xe,se[Ie].data);for(let ut=0;ut<nt.length;ut++){let Zn=nt[ut].image[Ie].image;Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Zn.width,Zn.height,Te,xe,Zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Se,Zn.width,Zn.height,0,Te,xe,Zn.data)}}else{Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Te,xe,se[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,Te,xe,se[Ie]);for(let ut=0;ut<nt.length;ut++){let qt=nt[ut];Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Te,xe,qt.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Se,Te,xe,qt.image[Ie])}}}E(w)&&w.mipmapsAutoUpdate===!0&&v(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,w.onUpdate&&w.onUpdate(w)}R.__version=w.version}function Ot(R,w,q,de,oe,ye){let ve=s.convert(q.format,q.colorSpace),ne=s.convert(q.type),re=T(q.internalFormat,ve,ne,q.normalized,q.colorSpace),me=i.get(w),k=i.get(q);if(k.__renderTarget=w,!me.__hasExternalTextures){let se=Math.max(1,w.width>>ye),ie=Math.max(1,w.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,re,se,ie,w.depth,0,ve,ne,null):t.texImage2D(oe,ye,re,se,ie,0,ve,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,oe,k.__webglTexture,0,ct(w)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,oe,k.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Pn(R,w,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),w.depthBuffer){let de=w.depthTexture,oe=de&&de.isDepthTexture?de.type:null,ye=y(w.stencilBuffer,oe),ve=w.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(w),ye,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(w),ye,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,ye,w.width,w.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let de=w.textures;for(let oe=0;oe<de.length;oe++){let ye=de[oe],ve=s.convert(ye.format,ye.colorSpace),ne=s.convert(ye.type),re=T(ye.internalFormat,ve,ne,ye.normalized,ye.colorSpace);Me(w)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(w),re,w.width,w.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(w),re,w.width,w.height):n.renderbufferStorage(n.RENDERBUFFER,re,w.width,w.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Tt(R,w,q){let de=w.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(w.depthTexture&&w.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(w.depthTexture);oe.__renderTarget=w;let ye=de?w.depthTexture.image[0]:w.depthTexture.image;(!oe.__webglTexture||ye.width!==w.width||ye.height!==w.height)&&(ye.width=w.width,ye.height=w.height,w.depthTexture.needsUpdate=!0),de?Ae(w.depthTexture,0):ge(w.depthTexture,0);let ve=oe.__webglTexture,ne=ct(w),re=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=w.depthTexture.format===Kr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(w.depthTexture.format===Gr)Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ve,0);else if(w.depthTexture.format===Kr)Me(w)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,re,ve,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,me,re,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function An(R){let w=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(w.__boundDepthTexture!==R.depthTexture){let de=R.depthTexture;if(w.__depthDisposeCallback&&w.__depthDisposeCallback(),de){let oe=()=>{delete w.__boundDepthTexture,delete w.__depthDisposeCallback,de.removeEventListener("dispose",oe)};de.addEventListener("dispose",oe),w.__depthDisposeCallback=oe}w.__boundDepthTexture=de}if(R.depthTexture&&!w.__autoAllocateDepthBuffer)if(q)for(let de=0;de<6;de++)Tt(w.__webglFramebuffer[de],R,de);else R.texture.mipmaps.length>0?Tt(w.__webglFramebuffer[0],R,0):Tt(w.__webglFramebuffer,R,0);else if(q){w.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[de]),w.__webglDepthbuffer[de]===void 0)w.__webglDepthbuffer[de]=n.createRenderbuffer(),Pn(w.__webglDepthbuffer[de],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,w.__webglFramebuffer),w.__webglDepthbuffer===void 0)w.__webglDepthbuffer=n.createRenderbuffer(),Pn(w.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=w.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function sn(R,w,q){let de=i.get(R);w!==void 0&&Ot(de.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&An(R)}function mn(R){let w=R.texture,q=i.get(R),de=i.get(w);R.addEventListener("dispose",D),B(R);let oe=R.textures,ye=R.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=w.version,o.memory.textures++),ye){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let re=0;re<w.mipmaps.length;re++)q.__webglFramebuffer[ne][re]=n.createFramebuffer()}else q.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(w.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<w.mipmaps.length;ne++)q.__webglFramebuffer[ne]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ve)for(let ne=0,re=oe.length;ne<re;ne++){let me=i.get(oe[ne]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let re=oe[ne];q.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let me=s.convert(re.format,re.colorSpace),k=s.convert(re.type),se=T(re.internalFormat,me,k,re.normalized,re.colorSpace,R.isXRRenderTarget===!0),ie=ct(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,se,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Pn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),gt(n.TEXTURE_CUBE_MAP,w);for(let ne=0;ne<6;ne++)if(w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Ot(q.__webglFramebuffer[ne][re],R,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,re);else Ot(q.__webglFramebuffer[ne],R,w,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);E(w)?v(n.TEXTURE_CUBE_MAP):w.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ne=0,re=oe.length;ne<re;ne++){let me=oe[ne],k=i.get(me),se=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(se,k.__webglTexture),gt(se,me),Ot(q.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+ne,se,0),E(me)&&v(se)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ne=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,de.__webglTexture),gt(ne,w),w.mipmaps.length>0)for(let re=0;re<w.mipmaps.length;re++)Ot(q.__webglFramebuffer[re],R,w,n.COLOR_ATTACHMENT0,ne,re);else Ot(q.__webglFramebuffer,R,w,n.COLOR_ATTACHMENT0,ne,0);E(w)?v(ne):w.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,w.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&An(R)}function O(R){let w=R.textures;for(let q=0,de=w.length;q<de;q++){let oe=w[q];if(E(oe)&&oe.mipmapsAutoUpdate===!0){let ye=C(R),ve=i.get(oe).__webglTexture;t.bindTexture(ye,ve),v(ye),t.unbindTexture()}}}let Le=[];function Je(R){if(R.samples>0){if(Me(R)===!1){let w=R.textures,q=R.width,de=R.height,oe=n.COLOR_BUFFER_BIT,ye=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),ne=w.length>1;if(ne)for(let me=0;me<w.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<w.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=i.get(w[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,k,0)}n.blitFramebuffer(0,0,q,de,0,0,q,de,oe,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Le.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let me=0;me<w.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let k=i.get(w[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,k,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let w=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[w])}}}function ct(R){return Math.min(r.maxSamples,R.samples)}function Me(R){let w=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&w.__useRenderToTexture!==!1}function Vt(R){let w=o.render.frame;u.get(R)!==w&&(u.set(R,w),R.update())}function Ge(R,w){let q=R.colorSpace,de=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==cl&&q!==Jr&&(wt.getTransfer(q)===Lt?(de!==ji||oe!==ui)&&et("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):rt("WebGLTextures: Unsupported texture color space:",q)),w}function Ke(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=j,this.getTextureUnits=te,this.setTextureUnits=ue,this.setTexture2D=ge,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=Ae,this.rebindTextures=sn,this.setupRenderTarget=mn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=An,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Me,this.dispose=H}function zC(n,e){function t(i,r=Jr){let s,o=wt.getTransfer(r);if(i===ui)return n.UNSIGNED_BYTE;if(i===$u)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Yu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ip)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===rp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===tp)return n.BYTE;if(i===np)return n.SHORT;if(i===fa)return n.UNSIGNED_SHORT;if(i===Xu)return n.INT;if(i===Zi)return n.UNSIGNED_INT;if(i===Ki)return n.FLOAT;if(i===Ji)return n.HALF_FLOAT;if(i===sp)return n.ALPHA;if(i===op)return n.RGB;if(i===ji)return n.RGBA;if(i===Gr)return n.DEPTH_COMPONENT;if(i===Kr)return n.DEPTH_STENCIL;if(i===ap)return n.RED;if(i===Zu)return n.RED_INTEGER;if(i===Ms)return n.RG;if(i===Ku)return n.RG_INTEGER;if(i===Ju)return n.RGBA_INTEGER;if(i===Fl||i===Nl||i===Bl||i===Dl)if(o===Lt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Fl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Nl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Bl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Dl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Fl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Nl)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Bl)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Dl)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===ju||i===Qu||i===eh||i===th)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===ju)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Qu)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===eh)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===th)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===nh||i===ih||i===rh||i===sh||i===oh||i===kl||i===ah)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===nh||i===ih)return o===Lt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===rh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===sh)return s.COMPRESSED_R11_EAC;if(i===oh)return s.COMPRESSED_SIGNED_R11_EAC;if(i===kl)return s.COMPRESSED_RG11_EAC;if(i===ah)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===lh||i===ch||i===uh||i===hh||i===dh||i===fh||i===ph||i===mh||i===gh||i===xh||i===yh||i===_h||i===bh||i===vh)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===lh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===ch)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===uh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===hh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===dh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===fh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ph)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===mh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===gh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===xh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===yh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===_h)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===bh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===vh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===wh||i===Sh||i===Ah)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===wh)return o===Lt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Sh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ah)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Mh||i===Th||i===Ol||i===Eh)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===Mh)return s.COMPRESSED_RED_RGTC1_EXT;if(i===Th)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ol)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Eh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ks?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var VC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,HC=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Mp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new wl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new li({vertexShader:VC,fragmentShader:HC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Ct(new vs(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Tp=class extends wr{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,x=typeof XRWebGLBinding<"u",g=new Mp,p={},b=t.getContextAttributes(),E=null,v=null,C=[],T=[],y=new dt,M=null,B=null,L=new ni;L.viewport=new en;let I=new ni;I.viewport=new en;let D=[L,I],U=new Hu,F=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=C[ee];return ge===void 0&&(ge=new oa,C[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=C[ee];return ge===void 0&&(ge=new oa,C[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=C[ee];return ge===void 0&&(ge=new oa,C[ee]=ge),ge.getHandSpace()};function W(ee){let ge=T.indexOf(ee.inputSource);if(ge===-1)return;let be=C[ge];be!==void 0&&(be.update(ee.inputSource,ee.frame,c||o),be.dispatchEvent({type:ee.type,data:ee.inputSource}))}function V(){r.removeEventListener("select",W),r.removeEventListener("selectstart",W),r.removeEventListener("selectend",W),r.removeEventListener("squeeze",W),r.removeEventListener("squeezestart",W),r.removeEventListener("squeezeend",W),r.removeEventListener("end",V),r.removeEventListener("inputsourceschange",ae);for(let ee=0;ee<C.length;ee++){let ge=T[ee];ge!==null&&(T[ee]=null,C[ee].disconnect(ge))}F=null,H=null,g.reset();for(let ee in p)delete p[ee];if(e.setRenderTarget(E),f=null,d=null,h=null,r=null,v=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(M),e.setSize(y.width,y.height,!1),B!==null){let ee=B.camera;ee.fov=B.fov,ee.zoom=B.zoom,ee.updateProjectionMatrix(),B=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){s=ee,i.isPresenting===!0&&et("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&et("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(r,t)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(ee){if(r=ee,r!==null){if(E=e.getRenderTarget(),r.addEventListener("select",W),r.addEventListener("selectstart",W),r.addEventListener("selectend",W),r.addEventListener("squeeze",W),r.addEventListener("squeezestart",W),r.addEventListener("squeezeend",W),r.addEventListener("end",V),r.addEventListener("inputsourceschange",ae),b.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,Ae=null;b.depth&&(Ae=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=b.stencil?Kr:Gr,Pe=b.stencil?Ks:Zi);let $e={colorFormat:t.RGBA8,depthFormat:Ae,scaleFactor:s};h=this.getBinding(),d=h.createProjectionLayer($e),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),v=new bi(d.textureWidth,d.textureHeight,{format:ji,type:ui,depthTexture:new Wr(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(r,t,be),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new bi(f.framebufferWidth,f.framebufferHeight,{format:ji,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),he.setContext(r),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ae(ee){for(let ge=0;ge<ee.removed.length;ge++){let be=ee.removed[ge],Pe=T.indexOf(be);Pe>=0&&(T[Pe]=null,C[Pe].disconnect(be))}for(let ge=0;ge<ee.added.length;ge++){let be=ee.added[ge],Pe=T.indexOf(be);if(Pe===-1){for(let $e=0;$e<C.length;$e++)if($e>=T.length){T.push(be),Pe=$e;break}else if(T[$e]===null){T[$e]=be,Pe=$e;break}if(Pe===-1)break}let Ae=C[Pe];Ae&&Ae.connect(be)}}function $(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(r===null)return;let ge=ee.near,be=ee.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(be=g.depthFar)),U.near=I.near=L.near=ge,U.far=I.far=L.far=be,(F!==U.near||H!==U.far)&&(r.updateRenderState({depthNear:U.near,depthFar:U.far}),F=U.near,H=U.far),U.layers.mask=ee.layers.mask|6,L.layers.mask=U.layers.mask&-5,I.layers.mask=U.layers.mask&-3;let Pe=ee.parent,Ae=U.cameras;$(U,Pe);for(let $e=0;$e<Ae.length;$e++)$(Ae[$e],Pe);U.projectionMatrix.copy(L.projectionMatrix),U.projectionMatrixInverse.copy(L.projectionMatrixInverse),B===null&&ee.isPerspectiveCamera&&(B={camera:ee,fov:ee.fov,zoom:ee.zoom}),j(ee,U,Pe)};function j(ee,ge,be){be===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(be.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=vu*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return U},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(ee){l=ee,d!==null&&(d.fixedFoveation=ee),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(U)},this.getCameraTexture=function(ee){return p[ee]};let te=null;function ue(ee,ge){if(u=ge.getViewerPose(c||o),m=ge,u!==null){let be=u.views;f!==null&&(e.setRenderTargetFramebuffer(v,f.framebuffer),e.setRenderTarget(v));let Pe=!1;be.length!==U.cameras.length&&(U.cameras.length=0,Pe=!0);for(let qe=0;qe<be.length;qe++){let gt=be[qe],ft=null;if(f!==null)ft=f.getViewport(gt);else{let Jt=h.getViewSubImage(d,gt);ft=Jt.viewport,qe===0&&(e.setRenderTargetTextures(v,Jt.colorTexture,Jt.depthStencilTexture),e.setRenderTarget(v))}let ot=D[qe];ot===void 0&&(ot=new ni,ot.layers.enable(qe),ot.viewport=new en,D[qe]=ot),ot.matrix.fromArray(gt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(gt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ft.x,ft.y,ft.width,ft.height),qe===0&&(U.matrix.copy(ot.matrix),U.matrix.decompose(U.position,U.quaternion,U.scale)),Pe===!0&&U.cameras.push(ot)}let Ae=r.enabledFeatures;if(Ae&&Ae.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&x){h=i.getBinding();let qe=h.getDepthInformation(be[0]);qe&&qe.isValid&&qe.texture&&g.init(qe,r.renderState)}if(Ae&&Ae.includes("camera-access")&&x){e.state.unbindTexture(),h=i.getBinding();for(let qe=0;qe<be.length;qe++){let gt=be[qe].camera;if(gt){let ft=p[gt];ft||(ft=new wl,p[gt]=ft);let ot=h.getCameraImage(gt);ft.sourceTexture=ot}}}}for(let be=0;be<C.length;be++){let Pe=T[be],Ae=C[be];Pe!==null&&Ae!==void 0&&Ae.update(Pe,ge,c||o)}te&&te(ee,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),m=null}let he=new $y;he.setAnimationLoop(ue),this.setAnimationLoop=function(ee){te=ee},this.dispose=function(){}}},GC=new Qt,i_=new st;i_.set(-1,0,0,0,1,0,0,0,1);function WC(n,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,fp(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,b,E,v){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(g,p):p.isMeshLambertMaterial?(s(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,v)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),x(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,b,E):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===fn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===fn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let b=e.get(p),E=b.envMap,v=b.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(GC.makeRotationFromEuler(v)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(i_),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,b,E){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*b,g.scale.value=E*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,b){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===fn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function x(g,p){let b=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function qC(n,e,t,i){let r={},s={};function o(b,E){let v=E.program;i.uniformBlockBinding(b,v,r[b.id])}function a(b,E){let v=r[b.id];v===void 0&&(m(b),v=l(b),r[b.id]=v,b.addEventListener("dispose",g));let C=E.program;i.updateUBOMapping(b,C);let T=e.render.frame;s[b.id]!==T&&(c(b),s[b.id]=T)}function l(b){let E=n.createBuffer(),v=b.__size,C=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,v,C),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(b){let E=r[b.id],v=b.uniforms,C=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let T=0,y=v.length;T<y;T++){let M=v[T];if(Array.isArray(M))for(let B=0,L=M.length;B<L;B++)u(M[B],T,B,C);else u(M,T,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,E,v,C){if(d(b,E,v,C)===!0){let T=b.__offset,y=b.value;if(Array.isArray(y)){let M=0;for(let B=0;B<y.length;B++){let L=y[B],I=x(L,!0);h(L,b.__data,M),M+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(y,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,b.__data)}}function h(b,E,v){typeof b=="number"||typeof b=="boolean"?E[v]=b:b.isMatrix3?(E[v]=b.elements[0],E[v+1]=b.elements[1],E[v+2]=b.elements[2],E[v+3]=0,E[v+4]=b.elements[3],E[v+5]=b.elements[4],E[v+6]=b.elements[5],E[v+7]=0,E[v+8]=b.elements[6],E[v+9]=b.elements[7],E[v+10]=b.elements[8],E[v+11]=0):ArrayBuffer.isView(b)?E.set(b.subarray(0,E.length-v),v):b.toArray(E,v)}function d(b,E,v,C){let T=b.value,y=E+"_"+v;if(Array.isArray(T)){C[y]===void 0&&(C[y]=[]);let M=C[y],B=!1;for(let L=0;L<T.length;L++)f(T[L],M,L)===!0&&(B=!0);return B}return f(T,C,y)}function f(b,E,v){if(E[v]===void 0)return typeof b=="number"||typeof b=="boolean"?E[v]=b:ArrayBuffer.isView(b)?E[v]=b.slice():E[v]=b.clone(),!0;{let C=E[v];if(typeof b=="number"||typeof b=="boolean"){if(C!==b)return E[v]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(C.equals(b)===!1)return C.copy(b),!0}}return!1}function m(b){let E=b.uniforms,v=0,C=16;for(let y=0,M=E.length;y<M;y++){let B=Array.isArray(E[y])?E[y]:[E[y]];for(let L=0,I=B.length;L<I;L++){let D=B[L],U=Array.isArray(D.value)?D.value:[D.value],F=Array.isArray(E[y])||Array.isArray(D.value),H=v;for(let V=0,ae=U.length;V<ae;V++){let $=U[V],j=x($,F),te=v%C,ue=te%j.boundary,he=te+ue;v+=ue,he!==0&&C-he<j.storage&&(v+=C-he),V===0&&(H=v),v+=j.storage}let W=D.type==="int"?Int32Array:D.type==="uint"?Uint32Array:Float32Array;D.__data=new W((v-H)/Float32Array.BYTES_PER_ELEMENT),D.__offset=H}}let T=v%C;return T>0&&(v+=C-T),b.__size=v,b.__cache={},this}function x(b,E){let v={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(v.boundary=4,v.storage=4):b.isVector2?(v.boundary=8,v.storage=8):b.isVector3||b.isColor?(v.boundary=16,v.storage=12):b.isVector4?(v.boundary=16,v.storage=16):b.isMatrix3?(v.boundary=16,v.storage=48):b.isMatrix4?(v.boundary=16,v.storage=64):b.isTexture?et("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(v.boundary=16,v.storage=b.byteLength):et("WebGLRenderer: Unsupported uniform value type.",b),E===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function g(b){let E=b.target;E.removeEventListener("dispose",g),n.deleteBuffer(r[E.id]),delete r[E.id],delete s[E.id]}function p(){for(let b in r)n.deleteBuffer(r[b]);r={},s={}}return{bind:o,update:a,dispose:p}}var XC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Tr=null;function $C(){return Tr===null&&(Tr=new Tu(XC,16,16,Ms,Ji),Tr.name="DFG_LUT",Tr.minFilter=ii,Tr.magFilter=ii,Tr.wrapS=vr,Tr.wrapT=vr,Tr.generateMipmaps=!1,Tr.needsUpdate=!0),Tr}var Lh=class{constructor(e={}){let{canvas:t=my(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ui}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let x=f,g=new Set([Ju,Ku,Zu]),p=new Set([ui,Zi,fa,Ks,$u,Yu]),b=new Uint32Array(4),E=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},C=null,T=null,y=[],M=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Mr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,I=!1,D=null,U=null,F=null,H=null;this._outputColorSpace=_i;let W=0,V=0,ae=null,$=-1,j=null,te=new en,ue=new en,he=null,ee=new je(0),ge=0,be=t.width,Pe=t.height,Ae=1,$e=null,lt=null,qe=new en(0,0,be,Pe),gt=new en(0,0,be,Pe),ft=!1,ot=new bs,Jt=new Eu,Wt=!1,pn=!1,Ot=new Qt,Pn=new Z,Tt=new en,An={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function mn(){return ae===null?Ae:1}let O=i;function Le(A,z){return t.getContext(A,z)}let Je,ct,Me,Vt,Ge,Ke,R,w,q,de,oe,ye,ve,ne,re,me,k,se,ie,Te,xe,Se,Xe;try{let A={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),O===null){let z="webgl2";if(O=Le(z,A),O===null)throw Le(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(A){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),rt("WebGLRenderer: "+A.message),A}function tt(){Je=new rE(O),Je.init(),xe=new zC(O,Je),ct=new $T(O,Je,e,xe),Me=new OC(O,Je),ct.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),U=O.createFramebuffer(),F=O.createFramebuffer(),H=O.createFramebuffer(),Vt=new aE(O),Ge=new AC,Ke=new UC(O,Je,Me,Ge,ct,xe,Vt),R=new iE(L),w=new cM(O),Se=new qT(O,w),q=new sE(O,w,Vt,Se),de=new cE(O,q,w,Se,Vt),se=new lE(O,ct,Ke),re=new YT(Ge),oe=new SC(L,R,Je,ct,Se,re),ye=new WC(L,Ge),ve=new TC,ne=new LC(Je),k=new WT(L,R,Me,de,m,l),me=new kC(L,de,ct),Xe=new qC(O,Vt,ct,Me),ie=new XT(O,Je,Vt),Te=new oE(O,Je,Vt),Vt.programs=oe.programs,L.capabilities=ct,L.extensions=Je,L.properties=Ge,L.renderLists=ve,L.shadowMap=me,L.state=Me,L.info=Vt}x!==ui&&(B=new hE(x,t.width,t.height,a,r,s));let ce=new Tp(L,O);this.xr=ce,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Ae},this.setPixelRatio=function(A){A!==void 0&&(Ae=A,this.setSize(be,Pe,!1))},this.getSize=function(A){return A.set(be,Pe)},this.setSize=function(A,z,Q=!0){if(ce.isPresenting){et("WebGLRenderer: Can't change size while VR device is presenting.");return}be=A,Pe=z,t.width=Math.floor(A*Ae),t.height=Math.floor(z*Ae),Q===!0&&(t.style.width=A+"px",t.style.height=z+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,A,z)},this.getDrawingBufferSize=function(A){return A.set(be*Ae,Pe*Ae).floor()},this.setDrawingBufferSize=function(A,z,Q){be=A,Pe=z,Ae=Q,t.width=Math.floor(A*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,A,z)},this.setEffects=function(A){if(x===ui){rt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let z=0;z<A.length;z++)if(A[z].isOutputPass===!0){et("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(te)},this.getViewport=function(A){return A.copy(qe)},this.setViewport=function(A,z,Q,Y){A.isVector4?qe.set(A.x,A.y,A.z,A.w):qe.set(A,z,Q,Y),Me.viewport(te.copy(qe).multiplyScalar(mn()).round())},this.getScissor=function(A){return A.copy(gt)},this.setScissor=function(A,z,Q,Y){A.isVector4?gt.set(A.x,A.y,A.z,A.w):gt.set(A,z,Q,Y),Me.scissor(ue.copy(gt).multiplyScalar(mn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(A){Me.setScissorTest(ft=A)},this.setOpaqueSort=function(A){$e=A},this.setTransparentSort=function(A){lt=A},this.getClearColor=function(A){return A.copy(k.getClearColor())},this.setClearColor=function(){k.setClearColor(...arguments)},this.getClearAlpha=function(){return k.getClearAlpha()},this.setClearAlpha=function(){k.setClearAlpha(...arguments)},this.clear=function(A=!0,z=!0,Q=!0){let Y=0;if(A){let K=!1;if(ae!==null){let Ee=ae.texture.format;K=g.has(Ee)}if(K){let Ee=ae.texture.type,Fe=p.has(Ee),Ce=k.getClearColor(),Ne=k.getClearAlpha(),He=Ce.r,it=Ce.g,xt=Ce.b;Fe?(b[0]=He,b[1]=it,b[2]=xt,b[3]=Ne,O.clearBufferuiv(O.COLOR,0,b)):(E[0]=He,E[1]=it,E[2]=xt,E[3]=Ne,O.clearBufferiv(O.COLOR,0,E))}else Y|=O.COLOR_BUFFER_BIT}z&&(Y|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(Y|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&O.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),D=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),k.dispose(),ve.dispose(),ne.dispose(),Ke.dispose(),Ge.dispose(),R.dispose(),de.dispose(),q.dispose(),Se.dispose(),Xe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",ec),ce.removeEventListener("sessionend",nr),Rr.stop()};function ze(A){A.preventDefault(),dl("WebGLRenderer: Context Lost."),I=!0}function nt(){dl("WebGLRenderer: Context Restored."),I=!1;let A=Vt.autoReset,z=me.enabled,Q=me.autoUpdate,Y=me.needsUpdate,K=me.type;tt(),Vt.autoReset=A,me.enabled=z,me.autoUpdate=Q,me.needsUpdate=Y,me.type=K}function Ie(A){rt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let z=A.target;z.removeEventListener("dispose",ut),qt(z)}function qt(A){Zn(A),Ge.remove(A)}function Zn(A){let z=Ge.get(A).programs;z!==void 0&&(z.forEach(function(Q){oe.releaseProgram(Q)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,z,Q,Y,K,Ee){z===null&&(z=An);let Fe=K.isMesh&&K.matrixWorld.determinantAffine()<0,Ce=Ia(A,z,Q,Y,K);Me.setMaterial(Y,Fe);let Ne=Q.index,He=1;if(Y.wireframe===!0){if(Ne=q.getWireframeAttribute(Q),Ne===void 0)return;He=2}let it=Q.drawRange,xt=Q.attributes.position,Ve=it.start*He,yt=(it.start+it.count)*He;Ee!==null&&(Ve=Math.max(Ve,Ee.start*He),yt=Math.min(yt,(Ee.start+Ee.count)*He)),Ne!==null?(Ve=Math.max(Ve,0),yt=Math.min(yt,Ne.count)):xt!=null&&(Ve=Math.max(Ve,0),yt=Math.min(yt,xt.count));let tn=yt-Ve;if(tn<0||tn===1/0)return;Se.setup(K,Y,Ce,Q,Ne);let Nt,Bt=ie;if(Ne!==null&&(Nt=w.get(Ne),Bt=Te,Bt.setIndex(Nt)),K.isMesh)Y.wireframe===!0?(Me.setLineWidth(Y.wireframeLinewidth*mn()),Bt.setMode(O.LINES)):Bt.setMode(O.TRIANGLES);else if(K.isLine){let Mn=Y.linewidth;Mn===void 0&&(Mn=1),Me.setLineWidth(Mn*mn()),K.isLineSegments?Bt.setMode(O.LINES):K.isLineLoop?Bt.setMode(O.LINE_LOOP):Bt.setMode(O.LINE_STRIP)}else K.isPoints?Bt.setMode(O.POINTS):K.isSprite&&Bt.setMode(O.TRIANGLES);if(K.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Bt.renderMultiDraw(K._multiDrawStarts,K._multiDrawCounts,K._multiDrawCount);else{let Mn=K._multiDrawStarts,Oe=K._multiDrawCounts,gn=K._multiDrawCount,vt=Ne?w.get(Ne).bytesPerElement:1,Ir=Ge.get(Y).currentProgram.getUniforms();for(let xn=0;xn<gn;xn++)Ir.setValue(O,"_gl_DrawID",xn),Bt.render(Mn[xn]/vt,Oe[xn])}else if(K.isInstancedMesh)Bt.renderInstances(Ve,tn,K.count);else if(Q.isInstancedBufferGeometry){let Mn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Oe=Math.min(Q.instanceCount,Mn);Bt.renderInstances(Ve,tn,Oe)}else Bt.render(Ve,tn)};function Ca(A,z,Q,Y){D!==null&&A.isNodeMaterial&&D.setObject(Y,A),Wt===!0&&re.setState(A,Q,!1),A.transparent===!0&&A.side===Ni&&A.forceSinglePass===!1?(A.side=fn,A.needsUpdate=!0,ir(A,z,Y),A.side=ci,A.needsUpdate=!0,ir(A,z,Y),A.side=Ni):ir(A,z,Y)}this.compile=function(A,z,Q=null){Q===null&&(Q=A),D!==null&&D.renderStart(A,z,Q),T=ne.get(Q),T.init(z),M.push(T),Q.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),A!==Q&&A.traverseVisible(function(K){K.isLight&&K.layers.test(z.layers)&&(T.pushLight(K),K.castShadow&&T.pushShadow(K))}),T.setupLights(),D!==null&&D.updateLights(T.state.lightsArray),pn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,pn),Wt===!0&&re.setGlobalState(this.clippingPlanes,z),D!==null&&me.render(T.state.shadowsArray,Q,z);let Y=new Set;return A.traverse(function(K){if(!(K.isMesh||K.isPoints||K.isLine||K.isSprite))return;let Ee=K.material;if(Ee)if(Array.isArray(Ee))for(let Fe=0;Fe<Ee.length;Fe++){let Ce=Ee[Fe];Ca(Ce,Q,z,K),Y.add(Ce)}else Ca(Ee,Q,z,K),Y.add(Ee)}),T=M.pop(),D!==null&&D.renderEnd(),Y},this.compileAsync=function(A,z,Q=null){let Y=this.compile(A,z,Q);return new Promise(K=>{function Ee(){if(Y.forEach(function(Fe){let Ne=Ge.get(Fe).currentProgram;(Ne===void 0||Ne.isReady())&&Y.delete(Fe)}),Y.size===0){K(A);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let oo=null;function nd(A){oo&&oo(A)}function ec(){Rr.stop()}function nr(){Rr.start()}let Rr=new $y;Rr.setAnimationLoop(nd),typeof self<"u"&&Rr.setContext(self),this.setAnimationLoop=function(A){oo=A,ce.setAnimationLoop(A),A===null?Rr.stop():Rr.start()},ce.addEventListener("sessionstart",ec),ce.addEventListener("sessionend",nr),this.render=function(A,z){if(z!==void 0&&z.isCamera!==!0){rt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;D!==null&&D.renderStart(A,z);let Q=ce.enabled===!0&&ce.isPresenting===!0,Y=B!==null&&(ae===null||Q)&&B.begin(L,ae);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(L,A,z,ae),T=ne.get(A,M.length),T.init(z),T.state.textureUnits=Ke.getTextureUnits(),M.push(T),Ot.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Jt.setFromArrayCamera(z):ot.setFromProjectionMatrix(Ot,Li,z.reversedDepth),pn=this.localClippingEnabled,Wt=re.init(this.clippingPlanes,pn),C=ve.get(A,y.length),C.init(),y.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Fe=L.xr.getDepthSensingMesh();Fe!==null&&Pr(Fe,z,-1/0,L.sortObjects)}Pr(A,z,0,L.sortObjects),C.finish(),D!==null&&D.updateLights(T.state.lightsArray),L.sortObjects===!0&&C.sort($e,lt),sn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,sn&&k.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&re.beginShadows();let K=T.state.shadowsArray;if(me.render(K,A,z),Wt===!0&&re.endShadows(),(Y&&B.hasRenderPass())===!1){let Fe=C.opaque,Ce=C.transmissive;if(T.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Ce.length>0)for(let He=0,it=Ne.length;He<it;He++){let xt=Ne[He];ki(Fe,Ce,A,xt)}sn&&k.render(A);for(let He=0,it=Ne.length;He<it;He++){let xt=Ne[He];Ra(C,A,xt,xt.viewport)}}else Ce.length>0&&ki(Fe,Ce,A,z),sn&&k.render(A),Ra(C,A,z)}ae!==null&&V===0&&(Ke.updateMultisampleRenderTarget(ae),Ke.updateRenderTargetMipmap(ae)),Y&&B.end(L),A.isScene===!0&&A.onAfterRender(L,A,z),Se.resetDefaultState(),$=-1,j=null,M.pop(),M.length>0?(T=M[M.length-1],Ke.setTextureUnits(T.state.textureUnits),Wt===!0&&re.setGlobalState(L.clippingPlanes,T.state.camera)):T=null,y.pop(),y.length>0?C=y[y.length-1]:C=null,D!==null&&D.renderEnd()};function Pr(A,z,Q,Y){if(A.visible===!1)return;if(A.layers.test(z.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(z);else if(A.isLight)T.pushLight(A),A.castShadow&&T.pushShadow(A);else if(A.isSprite){let Fe=z.isArrayCamera?Jt:ot;if(!A.frustumCulled||A.intersectsFrustum(Fe)){Y&&Tt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ot);let Ce=de.update(A),Ne=A.material;Ne.visible&&C.push(A,Ce,Ne,Q,Tt.z,null,z)}}else if(A.isMesh||A.isLine||A.isPoints){let Fe=z.isArrayCamera?Jt:ot;if(!A.frustumCulled||A.intersectsFrustum(Fe)){let Ce=de.update(A),Ne=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Tt.copy(A.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Tt.copy(Ce.boundingSphere.center)),Tt.applyMatrix4(A.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ne)){let He=Ce.groups;for(let it=0,xt=He.length;it<xt;it++){let Ve=He[it],yt=Ne[Ve.materialIndex];yt&&yt.visible&&C.push(A,Ce,yt,Q,Tt.z,Ve,z)}}else Ne.visible&&C.push(A,Ce,Ne,Q,Tt.z,null,z)}}}let Ee=A.children;for(let Fe=0,Ce=Ee.length;Fe<Ce;Fe++)Pr(Ee[Fe],z,Q,Y)}function Ra(A,z,Q,Y){let{opaque:K,transmissive:Ee,transparent:Fe}=A;T.setupLightsView(Q),Wt===!0&&re.setGlobalState(L.clippingPlanes,Q),Y&&Me.viewport(te.copy(Y)),K.length>0&&on(K,z,Q),Ee.length>0&&on(Ee,z,Q),Fe.length>0&&on(Fe,z,Q),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function ki(A,z,Q,Y){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Ve=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new bi(1,1,{generateMipmaps:!0,type:Ve?Ji:ui,minFilter:Zr,samples:Math.max(4,ct.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:wt.workingColorSpace})}let Ee=T.state.transmissionRenderTarget[Y.id],Fe=Y.viewport||te;Ee.setSize(Fe.z*L.transmissionResolutionScale,Fe.w*L.transmissionResolutionScale);let Ce=L.getRenderTarget(),Ne=L.getActiveCubeFace(),He=L.getActiveMipmapLevel();L.setRenderTarget(Ee),L.getClearColor(ee),ge=L.getClearAlpha(),ge<1&&L.setClearColor(16777215,.5),L.clear(),sn&&k.render(Q);let it=L.toneMapping;L.toneMapping=Mr;let xt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),Wt===!0&&re.setGlobalState(L.clippingPlanes,Y),on(A,Q,Y),Ke.updateMultisampleRenderTarget(Ee),Ke.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let yt=0,tn=z.length;yt<tn;yt++){let Nt=z[yt],{object:Bt,geometry:Mn,material:Oe,group:gn}=Nt;if(Oe.side===Ni&&Bt.layers.test(Y.layers)){let vt=Oe.side;Oe.side=fn,Oe.needsUpdate=!0,un(Bt,Q,Y,Mn,Oe,gn),Oe.side=vt,Oe.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ke.updateMultisampleRenderTarget(Ee),Ke.updateRenderTargetMipmap(Ee))}L.setRenderTarget(Ce,Ne,He),L.setClearColor(ee,ge),xt!==void 0&&(Y.viewport=xt),L.toneMapping=it}function on(A,z,Q){let Y=z.isScene===!0?z.overrideMaterial:null;for(let K=0,Ee=A.length;K<Ee;K++){let Fe=A[K],{object:Ce,geometry:Ne,group:He}=Fe,it=Fe.material;it.allowOverride===!0&&Y!==null&&(it=Y),Ce.layers.test(Q.layers)&&un(Ce,z,Q,Ne,it,He)}}function un(A,z,Q,Y,K,Ee){D!==null&&K.isNodeMaterial&&D.setObject(A,K),A.onBeforeRender(L,z,Q,Y,K,Ee),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),K.onBeforeRender(L,z,Q,Y,A,Ee),K.transparent===!0&&K.side===Ni&&K.forceSinglePass===!1?(K.side=fn,K.needsUpdate=!0,L.renderBufferDirect(Q,z,Y,K,A,Ee),K.side=ci,K.needsUpdate=!0,L.renderBufferDirect(Q,z,Y,K,A,Ee),K.side=Ni):L.renderBufferDirect(Q,z,Y,K,A,Ee),A.onAfterRender(L,z,Q,Y,K,Ee)}function hn(A){let z=0;for(let Q of A)Q.texture!==null&&z++;return z}function ir(A,z,Q){z.isScene!==!0&&(z=An);let Y=Ge.get(A),K=T.state.lights,Ee=T.state.shadowsArray,Fe=K.state.version,Ce=oe.getParameters(A,K.state,Ee,z,Q,T.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ce),He=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let it=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=R.get(A.envMap||Y.environment,it),Y.envMapRotation=Y.environment!==null&&A.envMap===null?z.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ut),He=new Map,Y.programs=He,Y.programVariants=new Map);let xt=He.get(Ne);if(xt!==void 0){if(Y.currentProgram===xt&&Y.lightsStateVersion===Fe)return Pa(A,Ce),xt}else Ce.uniforms=oe.getUniforms(A),D!==null&&A.isNodeMaterial&&D.build(A,Q,Ce),A.onBeforeCompile(Ce,L),xt=oe.acquireProgram(Ce,Ne),He.set(Ne,xt),Y.uniforms=Ce.uniforms;let Ve=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ve.clippingPlanes=re.uniform),Pa(A,Ce),Y.needsLights=ts(A),Y.lightsStateVersion=Fe,Y.needsLights&&(Ve.ambientLightColor.value=K.state.ambient,Ve.lightProbe.value=K.state.probe,Ve.sunLights.value=K.state.sun,Ve.sunLightShadows.value=K.state.sunShadow,Ve.directionalLights.value=K.state.directional,Ve.directionalLightShadows.value=K.state.directionalShadow,Ve.spotLights.value=K.state.spot,Ve.spotLightShadows.value=K.state.spotShadow,Ve.rectAreaLights.value=K.state.rectArea,Ve.ltc_1.value=K.state.rectAreaLTC1,Ve.ltc_2.value=K.state.rectAreaLTC2,Ve.pointLights.value=K.state.point,Ve.pointLightShadows.value=K.state.pointShadow,Ve.hemisphereLights.value=K.state.hemi,Ve.sunShadowMatrix.value=K.state.sunShadowMatrix,Ve.sunShadowCascade.value=K.state.sunShadowCascade,Ve.directionalShadowMatrix.value=K.state.directionalShadowMatrix,Ve.spotLightMatrix.value=K.state.spotLightMatrix,Ve.spotLightMap.value=K.state.spotLightMap,Ve.pointShadowMatrix.value=K.state.pointShadowMatrix),Y.numLightProbeGrids=hn(T.state.lightProbeGridArray),Y.currentProgram=xt,Y.uniformsList=null,xt}function hi(A,z,Q,Y,K){let Ee=Ge.get(A),Fe=Ee.currentProgram.id+","+Y+","+K,Ce=Ee.programVariants.get(Fe);return Ce===void 0?(Ce=ir(A,z,Q),Ee.programVariants.set(Fe,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=K),Ce}function es(A){if(A.uniformsList===null){let z=A.currentProgram.getUniforms();A.uniformsList=pa.seqWithValue(z.seq,A.uniforms)}return A.uniformsList}function Pa(A,z){let Q=Ge.get(A);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Ia(A,z,Q,Y,K){z.isScene!==!0&&(z=An),Ke.resetTextureUnits();let Ee=z.fog,Fe=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Ce=ae===null?L.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:wt.workingColorSpace,Ne=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,He=R.get(Y.envMap||Fe,Ne),it=Y.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,xt=!!Q.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ve=!!Q.morphAttributes.position,yt=!!Q.morphAttributes.normal,tn=!!Q.morphAttributes.color,Nt=Mr;Y.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Nt=L.toneMapping);let Bt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Mn=Bt!==void 0?Bt.length:0,Oe=Ge.get(Y),gn=T.state.lights;if(Wt===!0&&(pn===!0||A!==j)){let Dt=A===j&&Y.id===$;re.setState(Y,A,Dt)}let vt=!1,Ir=!1;Y.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==gn.state.version||K.isBatchedMesh&&Oe.batching===!1||!K.isBatchedMesh&&Oe.batching===!0||K.isBatchedMesh&&Oe.batchingColor===!0&&K._colorsTexture===null||K.isBatchedMesh&&Oe.batchingColor===!1&&K._colorsTexture!==null||K.isInstancedMesh&&Oe.instancing===!1||!K.isInstancedMesh&&Oe.instancing===!0||K.isSkinnedMesh&&Oe.skinning===!1||!K.isSkinnedMesh&&Oe.skinning===!0||K.isInstancedMesh&&Oe.instancingColor===!0&&K.instanceColor===null||K.isInstancedMesh&&Oe.instancingColor===!1&&K.instanceColor!==null||K.isInstancedMesh&&Oe.instancingMorph===!0&&K.morphTexture===null||K.isInstancedMesh&&Oe.instancingMorph===!1&&K.morphTexture!==null||Oe.envMap!==He||Y.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==re.numPlanes||Oe.numIntersection!==re.numIntersection)||Oe.vertexAlphas!==it||Oe.vertexTangents!==xt||Oe.morphTargets!==Ve||Oe.morphNormals!==yt||Oe.morphColors!==tn||Oe.morphTargetsCount!==Mn||Oe.numLightProbeGrids!==hn(T.state.lightProbeGridArray)?vt=!0:(Oe.outputColorSpace!==Ce||Oe.toneMapping!==Nt)&&(Ir=!0):(vt=!0,Oe.__version=Y.version);let xn=Oe.currentProgram;(vt===!0||Ir===!0)&&(xn=Ir===!0?hi(Y,z,K,Ce,Nt):ir(Y,z,K),D&&Y.isNodeMaterial&&D.onUpdateProgram(Y,xn,Oe));let co=!1,rr=!1,Lr=!1,pt=xn.getUniforms(),an=Oe.uniforms;if(Me.useProgram(xn.program)&&(co=!0,rr=!0,Lr=!0),Y.id!==$&&($=Y.id,rr=!0),co||j!==A){Me.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),pt.setValue(O,"projectionMatrix",A.projectionMatrix),pt.setValue(O,"viewMatrix",A.matrixWorldInverse);let yn=pt.map.cameraPosition;yn!==void 0&&yn.setValue(O,Pn.setFromMatrixPosition(A.matrixWorld)),ct.logarithmicDepthBuffer&&pt.setValue(O,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&pt.setValue(O,"isOrthographic",A.isOrthographicCamera===!0),j!==A&&(j=A,rr=!0,Lr=!0)}if(Oe.needsLights&&(gn.state.sunShadowMap.length>0&&pt.setValue(O,"sunShadowMap",gn.state.sunShadowMap,Ke),gn.state.directionalShadowMap.length>0&&pt.setValue(O,"directionalShadowMap",gn.state.directionalShadowMap,Ke),gn.state.spotShadowMap.length>0&&pt.setValue(O,"spotShadowMap",gn.state.spotShadowMap,Ke),gn.state.pointShadowMap.length>0&&pt.setValue(O,"pointShadowMap",gn.state.pointShadowMap,Ke)),K.isSkinnedMesh){pt.setOptional(O,K,"bindMatrix"),pt.setOptional(O,K,"bindMatrixInverse");let Dt=K.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),pt.setValue(O,"boneTexture",Dt.boneTexture,Ke))}K.isBatchedMesh&&(pt.setOptional(O,K,"batchingTexture"),pt.setValue(O,"batchingTexture",K._matricesTexture,Ke),pt.setOptional(O,K,"batchingIdTexture"),pt.setValue(O,"batchingIdTexture",K._indirectTexture,Ke),pt.setOptional(O,K,"batchingColorTexture"),K._colorsTexture!==null&&pt.setValue(O,"batchingColorTexture",K._colorsTexture,Ke));let Kn=Q.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&se.update(K,Q,xn),(rr||Oe.receiveShadow!==K.receiveShadow)&&(Oe.receiveShadow=K.receiveShadow,pt.setValue(O,"receiveShadow",K.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(an.envMapIntensity.value=z.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=$C()),rr){if(pt.setValue(O,"toneMappingExposure",L.toneMappingExposure),Oe.needsLights&&ao(an,Lr),Ee&&Y.fog===!0&&ye.refreshFogUniforms(an,Ee),ye.refreshMaterialUniforms(an,Y,Ae,Pe,T.state.transmissionRenderTarget[A.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Dt=v,yn=0;for(let Gn of T.state.lightProbeGridArray)Gn.texture!==null&&(Dt.textures[yn]=Gn.texture,Dt.min[yn]=Gn.boundingBox.min,Dt.max[yn]=Gn.boundingBox.max,Dt.resolution[yn]=Gn.resolution,yn++);for(let Gn in Dt)Dt[Gn].length=yn;an.probesSH.value=Dt.textures,an.probesMin.value=Dt.min,an.probesMax.value=Dt.max,an.probesResolution.value=Dt.resolution}pa.upload(O,es(Oe),an,Ke)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(pa.upload(O,es(Oe),an,Ke),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&pt.setValue(O,"center",K.center),pt.setValue(O,"modelViewMatrix",K.modelViewMatrix),pt.setValue(O,"normalMatrix",K.normalMatrix),pt.setValue(O,"modelMatrix",K.matrixWorld),Y.uniformsGroups!==void 0){let Dt=Y.uniformsGroups;for(let yn=0,Gn=Dt.length;yn<Gn;yn++){let tc=Dt[yn];Xe.update(tc,xn),Xe.bind(tc,xn)}}return xn}function ao(A,z){A.ambientLightColor.needsUpdate=z,A.lightProbe.needsUpdate=z,A.sunLights.needsUpdate=z,A.sunLightShadows.needsUpdate=z,A.directionalLights.needsUpdate=z,A.directionalLightShadows.needsUpdate=z,A.pointLights.needsUpdate=z,A.pointLightShadows.needsUpdate=z,A.spotLights.needsUpdate=z,A.spotLightShadows.needsUpdate=z,A.rectAreaLights.needsUpdate=z,A.hemisphereLights.needsUpdate=z}function ts(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(A,z,Q){let Y=Ge.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ge.get(A.texture).__webglTexture=z,Ge.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:Q,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,z){let Q=Ge.get(A);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(A,z=0,Q=0){ae=A,W=z,V=Q;let Y=null,K=!1,Ee=!1;if(A){let Ce=Ge.get(A);if(Ce.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(O.FRAMEBUFFER,Ce.__webglFramebuffer),te.copy(A.viewport),ue.copy(A.scissor),he=A.scissorTest,Me.viewport(te),Me.scissor(ue),Me.setScissorTest(he),$=-1;return}else if(Ce.__webglFramebuffer===void 0)Ke.setupRenderTarget(A);else if(Ce.__hasExternalTextures)Ke.rebindTextures(A,Ge.get(A.texture).__webglTexture,Ge.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let it=A.depthTexture;if(Ce.__boundDepthTexture!==it){if(it!==null&&Ge.has(it)&&(A.width!==it.image.width||A.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let He=Ge.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[z])?Y=He[z][Q]:Y=He[z],K=!0):A.samples>0&&Ke.useMultisampledRTT(A)===!1?Y=Ge.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?Y=He[Q]:Y=He,te.copy(A.viewport),ue.copy(A.scissor),he=A.scissorTest}else te.copy(qe).multiplyScalar(Ae).floor(),ue.copy(gt).multiplyScalar(Ae).floor(),he=ft;if(Q!==0&&(Y=U),Me.bindFramebuffer(O.FRAMEBUFFER,Y)&&Me.drawBuffers(A,Y),Me.viewport(te),Me.scissor(ue),Me.setScissorTest(he),K){let Ce=Ge.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ce.__webglTexture,Q)}else if(Ee){let Ce=z;for(let Ne=0;Ne<A.textures.length;Ne++){let He=Ge.get(A.textures[Ne]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+Ne,He.__webglTexture,Q,Ce)}}else if(A!==null&&Q!==0){let Ce=Ge.get(A.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ce.__webglTexture,Q)}$=-1};function lo(A){let z=Ge.get(A);return(z.__readFormat!==A.format||z.__readType!==A.type)&&(z.__readFormat=A.format,z.__readType=A.type,z.__formatReadable=ct.textureFormatReadable(A.format),z.__typeReadable=ct.textureTypeReadable(A.type)),z}this.readRenderTargetPixels=function(A,z,Q,Y,K,Ee,Fe,Ce=0){if(!(A&&A.isWebGLRenderTarget)){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ne=Ne[Fe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Me.bindFramebuffer(O.FRAMEBUFFER,Ne);try{let He=A.textures[Ce],it=He.format,xt=He.type;A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ce);let Ve=lo(He);if(Ve.__formatReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=A.width-Y&&Q>=0&&Q<=A.height-K&&O.readPixels(z,Q,Y,K,xe.convert(it),xe.convert(xt),Ee)}finally{let He=ae!==null?Ge.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,z,Q,Y,K,Ee,Fe,Ce=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ne=Ne[Fe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=A.width-Y&&Q>=0&&Q<=A.height-K){Me.bindFramebuffer(O.FRAMEBUFFER,Ne);let He=A.textures[Ce],it=He.format,xt=He.type;A.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+Ce);let Ve=lo(He);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let yt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,yt),O.bufferData(O.PIXEL_PACK_BUFFER,Ee.byteLength,O.STREAM_READ),O.readPixels(z,Q,Y,K,xe.convert(it),xe.convert(xt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let tn=ae!==null?Ge.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(O.FRAMEBUFFER,tn);let Nt=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await xy(O,Nt,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,yt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,Ee),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(yt),O.deleteSync(Nt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,z=null,Q=0){let Y=Math.pow(2,-Q),K=Math.floor(A.image.width*Y),Ee=Math.floor(A.image.height*Y),Fe=z!==null?z.x:0,Ce=z!==null?z.y:0;Ke.setTexture2D(A,0),O.copyTexSubImage2D(O.TEXTURE_2D,Q,0,0,Fe,Ce,K,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(A,z,Q=null,Y=null,K=0,Ee=0){let Fe,Ce,Ne,He,it,xt,Ve,yt,tn,Nt=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(Q!==null)Fe=Q.max.x-Q.min.x,Ce=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,He=Q.min.x,it=Q.min.y,xt=Q.isBox3?Q.min.z:0;else{let pt=Math.pow(2,-K);Fe=Math.floor(Nt.width*pt),Ce=Math.floor(Nt.height*pt),A.isDataArrayTexture?Ne=Nt.depth:A.isData3DTexture?Ne=Math.floor(Nt.depth*pt):Ne=1,He=0,it=0,xt=0}Y!==null?(Ve=Y.x,yt=Y.y,tn=Y.z):(Ve=0,yt=0,tn=0);let Bt=xe.convert(z.format),Mn=xe.convert(z.type),Oe;z.isData3DTexture?(Ke.setTexture3D(z,0),Oe=O.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(Ke.setTexture2DArray(z,0),Oe=O.TEXTURE_2D_ARRAY):(Ke.setTexture2D(z,0),Oe=O.TEXTURE_2D),Me.activeTexture(O.TEXTURE0),Me.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,z.flipY),Me.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Me.pixelStorei(O.UNPACK_ALIGNMENT,z.unpackAlignment);let gn=Me.getParameter(O.UNPACK_ROW_LENGTH),vt=Me.getParameter(O.UNPACK_IMAGE_HEIGHT),Ir=Me.getParameter(O.UNPACK_SKIP_PIXELS),xn=Me.getParameter(O.UNPACK_SKIP_ROWS),co=Me.getParameter(O.UNPACK_SKIP_IMAGES);Me.pixelStorei(O.UNPACK_ROW_LENGTH,Nt.width),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,Nt.height),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,He),Me.pixelStorei(O.UNPACK_SKIP_ROWS,it),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,xt);let rr=A.isDataArrayTexture||A.isData3DTexture,Lr=z.isDataArrayTexture||z.isData3DTexture;if(A.isDepthTexture){let pt=Ge.get(A),an=Ge.get(z),Kn=Ge.get(pt.__renderTarget),Dt=Ge.get(an.__renderTarget);Me.bindFramebuffer(O.READ_FRAMEBUFFER,Kn.__webglFramebuffer),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let yn=0;yn<Ne;yn++)rr&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(A).__webglTexture,K,xt+yn),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ge.get(z).__webglTexture,Ee,tn+yn)),O.blitFramebuffer(He,it,He+Fe,it+Ce,Ve,yt,Ve+Fe,yt+Ce,O.DEPTH_BUFFER_BIT,O.NEAREST);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(K!==0||A.isRenderTargetTexture||Ge.has(A)){let pt=Ge.get(A),an=Ge.get(z);Me.bindFramebuffer(O.READ_FRAMEBUFFER,F),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let Kn=0;Kn<Ne;Kn++)rr?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,pt.__webglTexture,K,xt+Kn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,pt.__webglTexture,K),Lr?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,an.__webglTexture,Ee,tn+Kn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,an.__webglTexture,Ee),K!==0?O.blitFramebuffer(He,it,He+Fe,it+Ce,Ve,yt,Ve+Fe,yt+Ce,O.COLOR_BUFFER_BIT,O.NEAREST):Lr?O.copyTexSubImage3D(Oe,Ee,Ve,yt,tn+Kn,He,it,Fe,Ce):O.copyTexSubImage2D(Oe,Ee,Ve,yt,He,it,Fe,Ce);Me.bindFramebuffer(O.READ_FRAMEBUFFER,null),Me.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Lr?A.isDataTexture||A.isData3DTexture?O.texSubImage3D(Oe,Ee,Ve,yt,tn,Fe,Ce,Ne,Bt,Mn,Nt.data):z.isCompressedArrayTexture?O.compressedTexSubImage3D(Oe,Ee,Ve,yt,tn,Fe,Ce,Ne,Bt,Nt.data):O.texSubImage3D(Oe,Ee,Ve,yt,tn,Fe,Ce,Ne,Bt,Mn,Nt):A.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,Ee,Ve,yt,Fe,Ce,Bt,Mn,Nt.data):A.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,Ee,Ve,yt,Nt.width,Nt.height,Bt,Nt.data):O.texSubImage2D(O.TEXTURE_2D,Ee,Ve,yt,Fe,Ce,Bt,Mn,Nt);Me.pixelStorei(O.UNPACK_ROW_LENGTH,gn),Me.pixelStorei(O.UNPACK_IMAGE_HEIGHT,vt),Me.pixelStorei(O.UNPACK_SKIP_PIXELS,Ir),Me.pixelStorei(O.UNPACK_SKIP_ROWS,xn),Me.pixelStorei(O.UNPACK_SKIP_IMAGES,co),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&O.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(A){Ge.get(A).__webglFramebuffer===void 0&&Ke.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ke.setTextureCube(A,0):A.isData3DTexture?Ke.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ke.setTexture2DArray(A,0):Ke.setTexture2D(A,0),Me.unbindTexture()},this.resetState=function(){W=0,V=0,ae=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Li}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=wt._getDrawingBufferColorSpace(e),t.unpackColorSpace=wt._getUnpackColorSpace()}};var YC=new Xr(1,1,1,14).translate(0,.5,0),ZC=new Sl(1,1,20).translate(0,.5,0),KC=new Z(0,1,0),Bh=class{group=new wn;parts=[];thickness=1;constructor(e){for(let t of[!1,!0]){let i=new _s({color:e,transparent:t,opacity:t?.35:1,depthTest:!t,depthWrite:!t}),r=new Ct(YC,i),s=new Ct(ZC,i);r.renderOrder=s.renderOrder=t?10:2,this.parts.push({shaft:r,head:s}),this.group.add(r,s)}}set(e,t){let i=t.length();if(this.group.visible=Number.isFinite(i)&&i>1e-9,!this.group.visible)return;this.group.position.copy(e),this.group.quaternion.copy(new Fi().setFromUnitVectors(KC,t.clone().divideScalar(i)));let r=Math.min(this.thickness,.25*i),s=Math.min(5*r,.6*i);for(let{shaft:o,head:a}of this.parts)o.scale.set(r,i-s,r),a.scale.set(2.6*r,s,2.6*r),a.position.y=i-s}dispose(){for(let{shaft:e}of this.parts)e.material.dispose()}};var Wl=class{group=new wn;materials=[];middle=new Z;constructor(e,t){let{hollow:i}=e;for(let r of i?[fn,ci]:[Ni]){let s=JC(this.middle,r,i,t),o=new Ct(new Vn,s);o.castShadow=!i,o.renderOrder=r===fn?0:i?8:1,this.materials.push(s),this.group.add(o)}this.reshape(e)}reshape(e){let{low:t,high:i}=Vs(e.positions);this.middle.set(...t).add(new Z(...i)).multiplyScalar(.5);for(let r of this.group.children){if(!(r instanceof Ct))continue;r.geometry.dispose();let s=new Vn;s.setAttribute("position",new dn(e.positions,3)),s.setAttribute("normal",new dn(e.normals,3)),s.setIndex(new dn(e.indices,1)),r.geometry=s}}set glass(e){for(let t of this.materials)t.userData.wall!==!0&&(t.opacity=e?.4:1,t.transparent=e,t.depthWrite=!e,t.needsUpdate=!0)}dispose(){for(let e of this.group.children)e instanceof Ct&&e.geometry.dispose();for(let e of this.materials)e.dispose()}};function JC(n,e,t,i){let r=t&&e===ci,s=new Yr({color:16777215,specular:new je(3356733),shininess:42,side:e,transparent:r,opacity:r?.16:1,depthWrite:!r});s.userData.wall=r;let o=t?i.shell:i.body;return s.onBeforeCompile=a=>{a.uniforms.uMiddle={value:n},a.uniforms.uFirst={value:new je(o[0])},a.uniforms.uSecond={value:new je(o[1])},a.uniforms.uSeam={value:new je(i.seam)},a.vertexShader=a.vertexShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
uniform vec3 uMiddle;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vOwn = position - uMiddle;`),a.fragmentShader=a.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
uniform vec3 uFirst;
uniform vec3 uSecond;
uniform vec3 uSeam;`).replace("#include <color_fragment>",`vec3 width = fwidth(vOwn) + 1e-12;
        vec3 part = clamp(vOwn / width, -1.0, 1.0);
        diffuseColor.rgb = mix(uFirst, uSecond, 0.5 + 0.5 * part.x * part.y * part.z);
        vec3 near = 1.0 - smoothstep(0.3, 1.1, abs(vOwn) / width);
        diffuseColor.rgb = mix(diffuseColor.rgb, uSeam, 0.55 * max(near.x, max(near.y, near.z)));`).replace("#include <opaque_fragment>",`float rim = 1.0 - abs(dot(normalize(vViewPosition), normal));
        outgoingLight = mix(outgoingLight, 0.35 * uSeam, 0.75 * smoothstep(0.86, 0.99, rim));
        #include <opaque_fragment>`)},s}function o_(n,e){let t=new wn,i=new li({transparent:!0,depthWrite:!1,uniforms:{colour:{value:new je(e.grid)},spacing:{value:n},middle:{value:new Z},reach:{value:1}},vertexShader:`varying vec2 vPlace;
      void main() { vec4 place = modelMatrix * vec4(position, 1.0); vPlace = position.xy;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,fragmentShader:`varying vec2 vPlace; uniform vec3 colour; uniform float spacing; uniform vec3 middle; uniform float reach;
      void main() {
        vec2 line = vPlace / spacing; vec2 width = fwidth(line);
        vec2 off = abs(fract(line - 0.5) - 0.5);
        vec2 ink = (1.0 - smoothstep(0.1 * width, 0.85 * width, off)) * (1.0 - smoothstep(0.1, 0.5, width));
        float fade = 1.0 - smoothstep(0.25, 1.0, distance(vPlace, middle.xy) / reach);
        float alpha = 0.75 * max(ink.x, ink.y) * fade * fade;
        if (alpha < 0.004) discard;
        gl_FragColor = vec4(colour, alpha);
        #include <colorspace_fragment>
      }`}),r=new Ct(new vs(1,1),i),s=new Ct(new vs(1,1),new Al({opacity:e.shadow,depthWrite:!1}));s.receiveShadow=!0,r.renderOrder=-2,s.renderOrder=-1,r.frustumCulled=s.frustumCulled=!1,t.add(r,s);let o=[r,s].map(a=>a.geometry.getAttribute("position"));return{group:t,spacing:n,around(a,l,c,u){r_(o[0],a,l),r_(o[1],c,u),(i.uniforms.middle?.value).set(...a);let h=i.uniforms.reach;h&&(h.value=l)}}}function r_(n,[e,t],i){if(n!==void 0){for(let r=0;r<4;r++)n.setXYZ(r,e+i*(r%2?1:-1),t+i*(r<2?1:-1),0);n.needsUpdate=!0}}function a_(n,e,t,i){let r=t>=Math.PI,s=e&&!r?Math.PI-t:0,o=new $r(n,128,80,0,2*Math.PI,s,r?Math.PI:t);o.rotateX(Math.PI/2);let a=(t>.8?15:5)*(Math.PI/180);return u_(o,e,c_.graticule(a),i)}function l_(n,e,t){let i=new Vn;return i.setAttribute("position",new dn(n.positions,3)),i.setAttribute("normal",new dn(n.normals,3)),i.setIndex(new dn(n.indices,1)),u_(i,!1,c_.planes(e),t)}var c_={graticule:n=>`
    float polar = acos(clamp(vOwn.z / length(vOwn), -1.0, 1.0));
    float around = atan(vOwn.y, vOwn.x);
    vec2 line = vec2(polar, around) / ${n.toFixed(9)};
    vec2 width = vec2(fwidth(polar), length(fwidth(vOwn.xy)) / max(length(vOwn.xy), 1e-9)) / ${n.toFixed(9)};
    vec2 off = abs(fract(line - 0.5) - 0.5);
    vec2 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    float polarEdge = min(polar, 3.14159265 - polar);
    if (polarEdge < ${n.toFixed(9)}) ink.y = 0.0;
    float lines = max(ink.x, ink.y);`,planes:n=>`
    vec3 line = vOwn / ${n.toFixed(9)}; vec3 width = fwidth(line) + 1e-9;
    vec3 off = abs(fract(line - 0.5) - 0.5);
    vec3 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    ink *= clamp((0.98 - abs(vTurn)) / 0.1, 0.0, 1.0);
    float lines = max(ink.x, max(ink.y, ink.z));`};function u_(n,e,t,i){let r=new wn,[s,o]=e?[fn,ci]:[ci,fn],a=new Ct(n,s_(s,1,t,i));a.receiveShadow=!0,a.renderOrder=-2;let l=new Ct(n,s_(o,.14,t,i));return l.renderOrder=9,r.add(a,l),{group:r,spacing:0,around:()=>{}}}function s_(n,e,t,i){let r=e<1,s=new Ml({color:i.ground[0],side:n,transparent:r,opacity:e,depthWrite:!r});return s.onBeforeCompile=o=>{o.uniforms.uLine={value:new je(i.lines)},o.vertexShader=o.vertexShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vOwn = position;
vTurn = normalize(normal);`),o.fragmentShader=o.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;
uniform vec3 uLine;`).replace("#include <color_fragment>",`${t}
        diffuseColor.rgb = mix(diffuseColor.rgb, uLine, 0.7 * lines);
        ${r?"diffuseColor.a = mix(diffuseColor.a, 0.4, 0.6 * lines);":""}`)},s.customProgramCacheKey=()=>t+String(r),s}function Dh(n,e){return e!==null&&n.positions.length===e.positions.length&&n.positions.every((t,i)=>t===e.positions[i])}function Ep(n,e){let t=n.columns[e];if(t===void 0)return 0;let i=0;for(let r=0;r+2<t.length;r+=3){let s=Math.hypot(t[r]??0,t[r+1]??0,t[r+2]??0);s>i&&(i=s)}return i}function h_(n){let[e,t]=[1/0,-1/0];for(let s=0;s<n.length;s++)e=Math.min(e,n[s]??e),t=Math.max(t,n[s]??t);let i=(t-e)/12,r=10**Math.floor(Math.log10(i));return([1,2,5,10].find(s=>s*r>=i*(1-1e-9))??10)*r}var kh=class{constructor(e,t,i){this.mark=t;let r=new Yr({color:i.dark?"#8fa6bb":"#33424f",specular:2236962}),s=new Yr({color:i.body[1],specular:2236962}),o=new Yr({color:i.body[0],specular:2236962});for(let a of e){let l=new wn;for(let c of jC(a.kind,t,{dark:r,rod:s,joint:o}))c.castShadow=!0,l.add(c);this.parts.push({link:a,group:l}),this.group.add(l)}}mark;group=new wn;parts=[];at(e,t){for(let{link:i,group:r}of this.parts){let s=i.kind==="rod"?4:i.kind==="point"?2:3,o=mi(e,i.column,s,t);if(r.visible=o!==null&&o.every(Number.isFinite),o===null)continue;let[a=0,l=0,c=0,u=0]=o;if(i.kind==="rod"){let h=Math.hypot(c-a,u-l);r.position.set((a+c)/2,(l+u)/2,.5*this.mark),r.rotation.z=Math.atan2(u-l,c-a),r.scale.x=h}else r.position.set(a,l,0),r.rotation.z=i.kind==="point"?0:c}}};function jC(n,e,{dark:t,rod:i,joint:r}){let s=e/2;switch(n){case"rod":return[new Ct(new qr(1,.14*e,.1*e),i)];case"wheel":return[Cp(s,.3*e,0,t)];case"axle":{let o=new Ct(new Xr(.06*e,.06*e,1.1*e,12),i);return o.position.z=.75*s,[o,Cp(.75*s,.24*e,.55*e,t),Cp(.75*s,.24*e,-.55*e,t)]}case"blade":{let o=new Ct(new qr(1.3*e,.06*e,.45*e),t);return o.position.z=.225*e,[o]}case"point":{let o=new Ct(new $r(.16*e,24,16),r);return o.position.z=.5*e,[o]}}}function Cp(n,e,t,i){let r=new Ct(new Xr(n,n,e,32),i);return r.position.set(0,t,n),r}function Oh(n,e,t,i){let r=t<2?t:(t-1)*i+1,s=new Float64Array(3*r),o=new Float64Array(r),a=(c,u)=>e[3*c+u]??0,l=(c,u)=>{let h=Math.max(0,c-1),d=Math.min(t-1,c+1),f=(n[d]??0)-(n[h]??0);return f>0?(a(d,u)-a(h,u))/f:0};for(let c=0;c<r;c++){let u=Math.min(Math.floor(c/i),Math.max(0,t-2)),h=c/i-u,d=n[u]??0,f=t>1?(n[u+1]??0)-d:0;o[c]=d+h*f;for(let m=0;m<3;m++)s[3*c+m]=t<2||h===0?a(u,m):QC(a(u,m),a(u+1,m),f*l(u,m),f*l(u+1,m),h)}return{points:s,times:o,lengths:e2(s)}}function QC(n,e,t,i,r){let s=1-r;return s*s*(1+2*r)*n+r*r*(3-2*r)*e+r*s*s*t-r*r*s*i}function e2(n){let e=new Float64Array(n.length/3);for(let t=1;t<e.length;t++){let i=Math.hypot((n[3*t]??0)-(n[3*t-3]??0),(n[3*t+1]??0)-(n[3*t-2]??0),(n[3*t+2]??0)-(n[3*t-1]??0));e[t]=(e[t-1]??0)+i}return e}var t2=1200;function Rp(n){let e=n.columns.contact?"contact":"centre",t=os(n,e,3);return Oh(n.times,n.columns[e]??new Float64Array(0),t,d_(t))}function ql(n,e){let t=hf(n,e);return Oh(e.times,t,t.length/3,4)}function Pp(n){let e=Math.min(os(n,"contact",3),os(n,"attitude",4)),t=new Float64Array(3*e);for(let i=0;i<e;i++){let{attitude:r,centre:s,contact:o}=_o(n,n.times[i]??0),a=o.map((l,c)=>l-(s[c]??0));t.set(Nm(r,a),3*i)}return Oh(n.times,t,e,d_(e))}function d_(n){return Math.max(1,Math.min(6,Math.ceil(t2/Math.max(1,n))))}var Ip=5,n2=`
attribute vec3 to;
attribute vec2 corner;
attribute vec2 fromMark;
attribute vec2 toMark;
uniform vec2 screen;
uniform float width;
uniform float lift;
uniform vec2 now;
varying vec2 vMark;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  vec2 run = (b.xy / b.w - a.xy / a.w) * screen;
  float far = length(run);
  vec2 along = far > 1e-6 ? run / far : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  bool end = corner.x > 0.5;
  gl_Position = end ? b : a;
  vMark = end ? toMark : fromMark;
  // beyond both ends, so that joints stay closed; not where the curve is pale and would be twice as dark
  float joint = fromMark.x <= now.x ? 0.35 : 0.0;
  vec2 shift = side * corner.y + along * (end ? joint : -joint);
  gl_Position.xy += shift * width / screen * gl_Position.w;
  gl_Position.z -= lift * gl_Position.w;
}`,i2=`
uniform vec3 scale[${Ip}];
uniform vec2 span;
uniform vec2 now;
uniform float tail;
uniform float before;
uniform float after;
varying vec2 vMark;
void main() {
  float share = clamp((vMark.x - span.x) / (span.y - span.x), 0.0, 1.0) * ${(Ip-1).toFixed(1)};
  vec3 colour = scale[0];
  for (int k = 1; k < ${Ip}; k++) colour = mix(colour, scale[k], clamp(share - float(k - 1), 0.0, 1.0));
  float alpha = vMark.x <= now.x ? before : after;
  if (vMark.x <= now.x) alpha *= 1.0 - smoothstep(0.6 * tail, tail, now.y - vMark.y);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(colour, alpha);
  #include <colorspace_fragment>
}`,Xl=class{mesh;curve;constructor(e,t,i){this.curve=e;let r=e.times.length,s=f_(e),o=new li({vertexShader:n2,fragmentShader:i2,transparent:!0,depthWrite:!1,uniforms:{screen:{value:new dt(1,1)},width:{value:t.width},lift:{value:4e-4},scale:{value:i.map(a=>new je(a))},span:{value:new dt(e.times[0]??0,Math.max(e.times[r-1]??1,(e.times[0]??0)+1e-12))},now:{value:new dt(1/0,0)},tail:{value:t.tail},before:{value:t.before},after:{value:t.after}}});this.mesh=new Ct(s,o),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}at(e){let{times:t,lengths:i}=this.curve,r=0,s=t.length-1;for(;s-r>1;){let c=r+s>>1;(t[c]??0)<=e?r=c:s=c}let o=e>=(t[s]??0)?s:r;if(this.uniform("now").set(e,i[o]??0),this.uniform("after")>0)return;let a=(i[o]??0)-this.uniform("tail"),l=o;for(;l>0&&(i[l]??0)>a;)l-=1;this.mesh.geometry.setDrawRange(6*l,6*(o-l+1))}reshape(e){this.curve=e,this.mesh.geometry.dispose(),this.mesh.geometry=f_(e);let t=e.times[0]??0;this.uniform("span").set(t,Math.max(e.times.at(-1)??1,t+1e-12))}resize(e,t){this.uniform("screen").set(e,t)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}uniform(e){return this.mesh.material.uniforms[e]?.value}},Lp=12;function f_({points:n,times:e,lengths:t}){let i=Math.max(0,e.length-1),r=new Float32Array(4*Lp*i),s=new Uint32Array(6*i);for(let c=0;c<i;c++){for(let u=0;u<4;u++){let h=Lp*(4*c+u);r.set(n.subarray(3*c,3*c+6),h),r.set([u&1,u&2?1:-1,e[c]??0,t[c]??0,e[c+1]??0,t[c+1]??0],h+6)}s.set([0,1,2,2,1,3].map(u=>4*c+u),6*c)}let o=new Vn,a=new yl(r,Lp),l=(c,u,h)=>{o.setAttribute(c,new _l(a,u,h))};return l("position",3,0),l("to",3,3),l("corner",2,6),l("fromMark",2,8),l("toMark",2,10),o.setIndex(new dn(s,1)),o}function Fp(n,e,t=32,i=64){let r=[],s=[],o=[];for(let a=0;a<=t;a++){let l=Math.PI*a/t;for(let c=0;c<i;c++){let u=2*Math.PI*c/i,h=[Math.sin(l)*Math.cos(u),Math.sin(l)*Math.sin(u),Math.cos(l)],d=h.map((g,p)=>g/(n[p]??1)),f=Math.hypot(...d);if(r.push(...yo(e,h.map((g,p)=>g*(n[p]??1)))),s.push(...yo(e,d.map(g=>g/f))),a===t)continue;let[m,x]=[a*i+c,a*i+(c+1)%i];o.push(m,m+i,x+i,m,x+i,x)}}return{positions:Float32Array.from(r),normals:Float32Array.from(s),indices:Uint32Array.from(o),hollow:!1}}var r2=6.3,s2=.9,Uh=class{constructor(e,t,i,r,s){this.canvas=e;this.scene=t;this.surfaces=i;this.motion=r;this.shown=s;this.size=t.size>0?t.size:1,this.renderer=new Lh({canvas:e,antialias:!0,alpha:!0,powerPreference:"high-performance"}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Xs,this.camera.up.set(0,0,1),this.metres.scale.setScalar(1/this.size),this.world.add(this.metres,this.lamp,this.lamp.target),this.metres.add(this.bodyFrame),this.view=this.usual=lf(t,r,this.size),this.lamp.castShadow=!0,this.lamp.shadow.mapSize.set(1024,1024),this.lamp.shadow.radius=5,this.lamp.shadow.bias=-2e-4,this.lamp.shadow.normalBias=.01;let o=1.6;Object.assign(this.lamp.shadow.camera,{left:-o,right:o,top:o,bottom:-o,near:.5,far:14}),this.build()}canvas;scene;surfaces;motion;shown;view;size;renderer;camera=new ni(zc*180/Math.PI,1,.05,500);world=new ml;metres=new wn;lamp=new Pl(16777215,2.1);bodyFrame=new wn;colours=nn();body=null;ground=null;linkage=null;path=null;trace=null;arrows=new Map;inertia=null;centreMark=null;usual;given=!1;reach=4;width=1;height=1;setMotion(e,t){this.motion=e;let i=this.surfaces;if(this.surfaces=t,this.path===null||this.trace===null!=!this.leavesTrace||e.columns.attitude===void 0)return this.build();t.body!==null&&!Dh(t.body,i.body)&&this.body?.reshape(t.body);let{inertia:r}=t;r!==null&&!Dh(r,i.inertia)&&this.inertia?.reshape(this.insideBody(r));let s=Rp(this.motion);this.reach=uf(this.scene.path!==null?ql(this.scene,this.motion).points:s.points,this.size);let{ground:o}=t;(this.scene.support?.kind==="sphere"||o!==null&&!Dh(o,i.ground))&&(this.ground!==null&&this.metres.remove(this.ground.group),this.buildGround(s.points)),this.path.reshape(this.scene.path!==null?ql(this.scene,this.motion):s),this.trace?.reshape(Pp(this.motion));for(let{name:a,column:l}of this.scene.vectors){let c=this.arrows.get(a);c!==void 0&&(c.scale=Ep(e,l)||c.scale)}}get leavesTrace(){let{columns:e}=this.motion;return this.body!==null&&e.contact!==void 0&&e.attitude!==void 0}get spacing(){return this.ground?.spacing??0}recolour(){this.colours=nn(),this.build()}reset(){this.view=this.usual=lf(this.scene,this.motion,this.size,this.width/this.height)}get viewChoice(){let{view:e,usual:t}=this,i=this.shown.follow?[]:e.target.map((s,o)=>s-(t.target[o]??0));return[e.azimuth-t.azimuth,e.elevation-t.elevation,e.distance-t.distance,...i].every(s=>Math.abs(s)<1e-6)?"":sx(e,!this.shown.follow)}restoreView(e){let t=ox(e,this.view.target);return t===null?null:(this.view=t.view,this.given=!0,t.moved)}zoom(e){this.view=nl(this.view,e)}vectorScale(e){return this.arrows.get(e)?.scale??0}resize(e,t,i=Math.min(window.devicePixelRatio||1,2)){if(e<1||t<1)return;let r=this.width===1;this.width=e,this.height=t,this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.path?.resize(e,t),this.trace?.resize(e,t),r&&!this.given&&this.reset()}draw(e){if(this.width===1)return;let t=_o(this.motion,e);this.place(t),this.shown.follow&&this.follow(t);let i=new Z(...this.view.target);this.camera.position.set(...lx(this.view)),this.camera.near=Math.max(.02,this.view.distance/60),this.camera.far=this.view.distance+6*this.reach+60,this.camera.updateProjectionMatrix(),this.camera.lookAt(i);let r=this.view.target.map(l=>l*this.size),s=Math.min(Math.max(this.reach,2),.62*this.view.distance),o=this.placeOf(t);this.ground?.around(r,s*this.size,o,1.7*this.size);let a=new Z(...o).divideScalar(this.size);this.lamp.target.position.copy(a),this.lamp.position.copy(a).add(this.lampDirection().multiplyScalar(6)),this.renderer.render(this.world,this.camera)}async sized(e,t,i,r){let[s,o]=[this.width,this.height];this.resize(e,t,i);try{return await r()}finally{this.resize(s,o)}}picture(e){this.draw(e);let t=document.createElement("canvas");t.width=this.canvas.width,t.height=this.canvas.height;let i=t.getContext("2d");return i!==null&&(i.fillStyle=this.colours.paper,i.fillRect(0,0,t.width,t.height),i.drawImage(this.canvas,0,0)),t}dispose(){this.clear(),this.renderer.dispose()}lampDirection(){let{azimuth:e}=this.view,t=new Z(-Math.sin(e),Math.cos(e),0),i=new Z(Math.cos(e),Math.sin(e),0);return t.multiplyScalar(-.35).addScaledVector(i,.2).add(new Z(0,0,1)).normalize()}follow(e){let[t,i,r]=this.placeOf(e);this.view={...this.view,target:[t/this.size,i/this.size,r/this.size]}}placeOf(e){let{path:t}=this.scene;if(t===null)return e.centre;let[i=0,r=0]=mi(this.motion,t,2,e.t)??[];return[i,r,0]}clear(){this.body?.dispose(),this.inertia?.dispose(),this.path?.dispose(),this.trace?.dispose();for(let{arrow:e}of this.arrows.values())e.dispose();this.arrows.clear(),this.bodyFrame.clear(),this.metres.clear(),this.metres.add(this.bodyFrame);for(let e of this.world.children.filter(t=>t instanceof la))this.world.remove(e);this.body=this.ground=this.linkage=this.path=this.trace=this.inertia=this.centreMark=null}build(){this.clear();let{scene:e,colours:t,motion:i}=this;this.world.add(new la(16777215,t.dark?8226964:12174027,1.5)),this.buildBody();let r=Rp(this.motion);this.buildGround(r.points),e.links.length>0&&(this.linkage=new kh(e.links,.2*this.size,t),this.metres.add(this.linkage.group)),this.path=new Xl(e.path!==null?ql(this.scene,this.motion):r,{width:3,before:1,after:.16,tail:1/0},t.time),this.metres.add(this.path.mesh),this.leavesTrace&&(this.trace=new Xl(Pp(this.motion),{width:2.2,before:1,after:0,tail:r2*this.size},t.time),this.bodyFrame.add(this.trace.mesh));for(let[s,o]of e.vectors.entries()){let a=Ep(i,o.column);if(!(a>0))continue;let l=new Bh(t.components[s%3]??t.ink);this.arrows.set(o.name,{arrow:l,scale:a}),this.metres.add(l.group)}this.path.resize(this.width,this.height),this.trace?.resize(this.width,this.height)}buildBody(){let{scene:e,colours:t}=this,i=e.inertia_axes,{body:r,inertia:s}=this.surfaces;if(!(this.motion.columns.attitude!==void 0))return;let a=i?.5*this.size/Math.max(...i):0,l=i?.map(u=>u*a),c=r??(l?Fp(l,e.inertia_turn):null);if(c!==null&&(this.body=new Wl(c,t),this.bodyFrame.add(this.body.group)),l&&r!==null){let u=this.insideBody(s??Fp(l,e.inertia_turn));this.inertia=new Wl(u,{...t,body:["#efd9a4","#c77d4f"]}),this.bodyFrame.add(this.inertia.group)}this.centreMark=new Ct(new $r(.028*this.size,24,16),new _s({color:t.alarm,depthTest:!1,transparent:!0})),this.centreMark.renderOrder=11,this.bodyFrame.add(this.centreMark)}insideBody(e){let t=Math.max(...Vs(e.positions).high),i=.4*this.size/t;return{...e,positions:e.positions.map(r=>i*r)}}buildGround(e){let{scene:t,colours:i,size:r}=this;this.reach=uf(t.path!==null?ql(this.scene,this.motion).points:e,r);let s=t.support??(t.path===null?null:{kind:"plane"});if(!(s===null||s.kind==="point")){if(s.kind==="plane")this.ground=o_(Ac(Math.max(.5,this.reach/16)*r),i);else if(s.kind==="sphere"){let o=Math.hypot(e[0]??NaN,e[1]??NaN,e[2]??NaN)||Math.abs(s.radius),a=s.inside?.3:Math.max(.12,.75*r/o),c=this.surfaces.body?.hollow===!0?Math.PI:tl(e,s.inside?-1:1,a,s.inside?1.75:1.2);this.ground=a_(o,s.inside,c,i)}else{let o=this.surfaces.ground;if(o===null)return;this.ground=l_(o,h_(o.positions),i)}this.metres.add(this.ground.group)}}place(e){let{shown:t}=this,[i,r,s,o]=e.attitude;this.bodyFrame.position.set(...e.centre),this.bodyFrame.quaternion.set(r,s,o,i),this.body!==null&&(this.body.glass=t.inertia&&this.inertia!==null||t.centre),this.inertia!==null&&(this.inertia.group.visible=t.inertia),this.centreMark!==null&&(this.centreMark.visible=t.centre),this.linkage?.at(this.motion,e.t);for(let[a,l]of[[this.path,t.trace],[this.trace,t.traceOnBody]])a!==null&&(a.mesh.visible=l,a.at(e.t));for(let a of this.scene.vectors){let l=this.arrows.get(a.name);if(l===void 0)continue;let c=mi(this.motion,a.column,3,e.t);if(l.arrow.group.visible=t.vectors.has(a.name)&&c!==null,!l.arrow.group.visible||c===null)continue;let u=a.axes==="body"?yo(e.attitude,c):c,h=s2*this.size/l.scale;l.arrow.thickness=.0026*this.view.distance*this.size;let d=a.at==="contact"?e.contact:e.centre;l.arrow.set(new Z(...d),new Z(...u).multiplyScalar(h))}}};function p_(n){let{scene:e}=n.model,t=n.shown.value;if(!Np(n))return null;let i=X("canvas",{class:"lab-canvas","aria-hidden":!0}),r=X("div",{class:"lab-legend"}),s=X("div",{class:"lab-note"}),o=X("div",{class:"lab-timebar","aria-hidden":!0}),a=X("div",{class:"lab-scene",tabindex:0,role:"application","aria-label":`${n.model.title}: the motion in space. Arrow keys turn the view, plus and minus zoom, space plays, question mark lists all keys.`},i,r,o,s),l={trace:!0,traceOnBody:!0,inertia:!1,centre:!1,follow:cf(e,t.motion),vectors:new Set(e.vectors.filter(({column:p})=>p==="omega").map(({name:p})=>p))},c;try{c=new Uh(i,e,t.surfaces,t.motion,l)}catch{return null}let u=0,h=()=>{u===0&&(u=requestAnimationFrame(()=>{u=0,c.draw(n.clock.time.value),f()}))},d=new Map,f=()=>{let{motion:p}=n.shown.value;for(let b of e.vectors){let E=mi(p,b.column,3,n.clock.time.value),v=d.get(b.name);v&&E&&(v.textContent=`${bt(Math.hypot(...E),3)} ${Wn(b.unit)}`)}},m=()=>{d.clear();let p=nn();r.replaceChildren(...e.vectors.flatMap((E,v)=>{if(!l.vectors.has(E.name))return[];let C=X("span",{class:"lab-number"});d.set(E.name,C);let T=X("span",{class:"lab-arrow",style:`background:${p.components[v%3]??""}`});return[X("div",{},T,m_(E),C)]}));let b=n.clock.until;o.replaceChildren(X("span",{},"t = 0"),X("i",{style:`background:linear-gradient(90deg,${p.time.join(",")})`}),X("span",{},`${bt(b)} s`)),s.textContent=c.spacing>0?`grid ${bt(c.spacing)} m`:""},x=o2(n,c,l,()=>{m(),h()});return dx(a,c,p=>{p&&x.dispatchEvent(new CustomEvent("unfollow")),h()}),a2(a,n,c,x,h),new ResizeObserver(()=>{c.resize(a.clientWidth,a.clientHeight),c.draw(n.clock.time.value)}).observe(a),n.clock.time.after(h),n.shown.after(({motion:p,surfaces:b})=>{c.setMotion(p,b),m(),h()}),bo(()=>{c.recolour(),m(),h()}),m(),h(),{element:a,stage:c,switches:x,refresh:h,choice:()=>c.viewChoice,restore:p=>{let b=c.restoreView(p);b!==null&&b===l.follow&&x.querySelector('[data-key="f"]')?.click(),h()}}}function Np(n){let{columns:e}=n.shown.value.motion,{body:t,links:i,path:r}=n.model.scene;return e.contact!==void 0||r!==null||(t!==null||i.length>0)&&e.attitude!==void 0}function m_(n){return n.mathml?zi(n.mathml):document.createTextNode(n.name)}function o2(n,e,t,i){let{scene:r}=n.model,s=X("div",{class:"lab-switches",role:"toolbar","aria-label":"What is shown"}),o=(c,u,h,d,f)=>{let m=Is(c,`${u} (${h})`,d,x=>{f(x),i()});return m.dataset.key=h,s.append(m),m},a=o("follow","Keep the body in the middle","f",t.follow,c=>t.follow=c);s.addEventListener("unfollow",()=>{t.follow=!1,a.setAttribute("aria-pressed","false")}),o("path","Path on the ground","p",t.trace,c=>t.trace=c),r.path===null&&o("trace","Trace of the contact on the body","t",t.traceOnBody,c=>t.traceOnBody=c),r.vectors.forEach((c,u)=>{if(e.vectorScale(c.name)===0)return;let h=t.vectors.has(c.name);o(m_(c),`Vector ${c.name}`,String(u+1),h,d=>{let f=new Set(t.vectors);d?f.add(c.name):f.delete(c.name),t.vectors=f})}),r.inertia_axes!==null&&r.body!==null&&o("inertia","Inertia ellipsoid","i",t.inertia,c=>t.inertia=c),r.path===null&&o("centre","Centre of mass","c",t.centre,c=>t.centre=c);let l=X("button",{type:"button",title:"Whole view (r)","data-key":"r"},"whole view");return l.addEventListener("click",()=>{e.reset(),i()}),s.append(l),s}var g_=[["space","play or pause"],["← →, ↑ ↓","turn the view"],[", .","one sample back, on"],["Home, End","to the start, to the end"],["[ ]","slower, faster"],["+ −","nearer, farther"],["f","keep the body in the middle"],["p, t","path on the ground, trace on the body"],["1 2 3","vectors"],["i, c","inertia ellipsoid, centre of mass"],["r","whole view"],["Ctrl+Z, Ctrl+Shift+Z","undo, redo"]];function a2(n,e,t,i,r){let{clock:s}=e,o=(u,h)=>{t.view=Vc(t.view,u,h),r()},a=u=>{t.zoom(u),r()},l=u=>{let{times:h}=e.shown.value.motion;s.pause(),s.seek(s.time.value+u*((h[1]??0)-(h[0]??0)))},c={" ":()=>s.toggle(),ArrowLeft:()=>o(-.04,0),ArrowRight:()=>o(.04,0),ArrowUp:()=>o(0,-.04),ArrowDown:()=>o(0,.04),",":()=>l(-1),".":()=>l(1),Home:()=>s.seek(0),End:()=>s.seek(s.until),"[":()=>s.changeSpeed(-1),"]":()=>s.changeSpeed(1),"+":()=>a(1/1.15),"=":()=>a(1/1.15),"-":()=>a(1.15)};n.addEventListener("keydown",u=>{if(u.ctrlKey||u.metaKey||u.altKey)return;let h=c[u.key],d=i.querySelector(`[data-key="${CSS.escape(u.key.toLowerCase())}"]`);h===void 0&&d===null||(u.preventDefault(),h!==void 0?h():d?.click())})}function x_(){let n=g_.map(([e,t])=>X("tr",{},X("th",{scope:"row"},X("kbd",{},e)),X("td",{},t)));return X("div",{},X("p",{class:"lab-hint"},"Keys act while the scene, a section or a chart has the focus: click into it, or go there with Tab. With the pointer: drag turns, Shift and drag moves, the wheel zooms; with two fingers as usual."),X("table",{class:"lab-keys"},...n))}var l2=300;function y_(n,e,t){let i=()=>Object.fromEntries(Object.entries(t()).filter(([,a])=>a!=="")),r=()=>{let a=ef(n.shown.value.experiment,n.model,i());try{history.replaceState(history.state,"",a===""?location.pathname+location.search:a)}catch{}},s,o=()=>{clearTimeout(s),s=setTimeout(r,l2)};n.shown.after(r);for(let a of["change","click","pointerup","keyup","wheel"])e.addEventListener(a,o,{passive:!0});return()=>{let a=n.clock.time.value,l=a>0?{t:String(Number(a.toPrecision(6)))}:{},c=ef(n.shown.value.experiment,n.model,{...i(),...l});return(location.href.split("#")[0]??"")+(c||"")}}var __=0;function Bp(n,e,t=()=>{}){__+=1;let i=X("div",{role:"tablist","aria-label":n,class:"lab-tabs"}),r=[],s=e.map(({name:a,title:l,content:c})=>{let u=`lab-${__}-${a}`,h=X("button",{type:"button",role:"tab",id:`${u}-tab`,"aria-controls":u},l),d=X("div",{role:"tabpanel",id:u,"aria-labelledby":`${u}-tab`,class:`lab-panel lab-panel-${a}`},c);return i.append(h),r.push(d),h}),o=(a,l)=>{s.forEach((u,h)=>{let d=h===a;u.setAttribute("aria-selected",String(d)),u.tabIndex=d?0:-1;let f=r[h];f&&(f.hidden=!d)}),l&&s[a]?.focus();let c=e[a];c!==void 0&&(c.shown?.(),t(c.name))};return s.forEach((a,l)=>a.addEventListener("click",()=>o(l,!1))),i.addEventListener("keydown",a=>{let l=s.findIndex(h=>h===document.activeElement),u={ArrowRight:l+1,ArrowLeft:l-1,Home:0,End:s.length-1}[a.key];u!==void 0&&(a.preventDefault(),o((u+s.length)%s.length,!0))}),o(0,!1),{element:X("section",{class:"lab-deck","aria-label":n},i,...r),select:a=>{let l=e.findIndex(c=>c.name===a);l>=0&&o(l,!1)}}}var c2="uplot",u2="u-hz",h2="u-vt",d2="u-title",f2="u-wrap",p2="u-under",m2="u-over",g2="u-axis",to="u-off",x2="u-select",y2="u-cursor-x",_2="u-cursor-y",b2="u-cursor-pt",v2="u-legend",w2="u-live",S2="u-inline",A2="u-series",M2="u-marker",b_="u-label",T2="u-value",Yl="width",Zl="height";var v_="bottom",ga="left",Dp="right",Qp="#000",w_=Qp+"0",kp="mousemove",S_="mousedown",Op="mouseup",A_="mouseenter",M_="mouseleave",T_="dblclick",E2="resize",C2="scroll",E_="change",Wh="dppxchange",em="--",Sa=typeof window<"u",Gp=Sa?document:null,ya=Sa?window:null,R2=Sa?navigator:null,It,zh;function Wp(){let n=devicePixelRatio;It!=n&&(It=n,zh&&Xp(E_,zh,Wp),zh=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),no(E_,zh,Wp),ya.dispatchEvent(new CustomEvent(Wh)))}function wi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function qp(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Qi(n,e,t,i){let r=Gp.createElement(n);return e!=null&&wi(r,e),t?.insertBefore(r,i),r}function Bi(n,e){return Qi("div",n,e)}var C_=new WeakMap;function Cr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=C_.get(n);s!=o&&(n.style.transform=s,C_.set(n,s),e<0||t<0||e>i||t>r?wi(n,to):qp(n,to))}var R_=new WeakMap;function P_(n,e,t){let i=e+t,r=R_.get(n);i!=r&&(R_.set(n,i),n.style.background=e,n.style.borderColor=t)}var I_=new WeakMap;function L_(n,e,t,i){let r=e+""+t,s=I_.get(n);r!=s&&(I_.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var tm={passive:!0},P2={...tm,capture:!0};function no(n,e,t,i){e.addEventListener(n,t,i?P2:tm)}function Xp(n,e,t,i){e.removeEventListener(n,t,tm)}Sa&&Wp();function er(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:Si((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function ob(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var ab=n=>n!=null,lb=n=>n!=null&&n>0,$h=ob(ab),I2=ob(lb);function L2(n,e,t,i=0,r=!1){let s=r?I2:$h,o=r?lb:ab;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ht,l??-Ht]}function Yh(n,e,t,i){let r=B_(n),s=B_(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?jr:cb,a=r==1?Si:Di,l=s==1?Di:Si,c=a(o(Rn(n))),u=l(o(Rn(e))),h=_a(t,c),d=_a(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(d=Gt(d,-u))),i||t==2?(n=h*r,e=d*s):(n=fb(n,h),e=Zh(e,d)),[n,e]}function nm(n,e,t,i){let r=Yh(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var im=.1,F_={mode:3,pad:im},Jl={pad:0,soft:null,mode:0},F2={min:Jl,max:Jl};function qh(n,e,t,i){return Kh(t)?N_(n,e,t):(Jl.pad=t,Jl.soft=i?0:null,Jl.mode=i?3:0,N_(n,e,F2))}function Rt(n,e){return n??e}function N2(n,e,t){for(e=Rt(e,0),t=Rt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function N_(n,e,t){let i=t.min,r=t.max,s=Rt(i.pad,0),o=Rt(r.pad,0),a=Rt(i.hard,-Ht),l=Rt(r.hard,Ht),c=Rt(i.soft,Ht),u=Rt(r.soft,-Ht),h=Rt(i.mode,0),d=Rt(r.mode,0),f=e-n,m=jr(f),x=ri(Rn(n),Rn(e)),g=jr(x),p=Rn(g-m);(f<1e-24||p>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Ht&&(s=0),d==2&&u!=-Ht&&(o=0)));let b=f||x||1e3,E=jr(b),v=_a(10,Si(E)),C=b*(f==0?n==0?.1:1:s),T=Gt(fb(n-C,v/10),24),y=n>=c&&(h==1||h==3&&T<=c||h==2&&T>=c)?c:Ht,M=ri(a,T<y&&n>=y?y:tr(y,T)),B=b*(f==0?e==0?.1:1:o),L=Gt(Zh(e+B,v/10),24),I=e<=u&&(d==1||d==3&&L>=u||d==2&&L<=u)?u:-Ht,D=tr(l,L>I&&e<=I?I:ri(I,L));return M==D&&M==0&&(D=100),[M,D]}var B2=new Intl.NumberFormat(Sa?R2.language:"en-US"),rm=n=>B2.format(n),Ai=Math,Gh=Ai.PI,Rn=Ai.abs,Si=Ai.floor,Cn=Ai.round,Di=Ai.ceil,tr=Ai.min,ri=Ai.max,_a=Ai.pow,B_=Ai.sign,jr=Ai.log10,cb=Ai.log2,D2=(n,e=1)=>Ai.sinh(n)*e,Up=(n,e=1)=>Ai.asinh(n/e),Ht=1/0;function D_(n){return(jr((n^n>>31)-(n>>31))|0)+1}function $p(n,e,t){return tr(ri(n,e),t)}function ub(n){return typeof n=="function"}function St(n){return ub(n)?n:()=>n}var k2=()=>{},hb=n=>n,db=(n,e)=>e,O2=n=>null,k_=n=>!0,O_=(n,e)=>n==e,U2=/\.\d*?(?=9{6,}|0{6,})/gm,io=n=>{if(mb(n)||Es.has(n))return n;let e=`${n}`,t=e.match(U2);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${io(r)}e${s}`}return Gt(n,i)};function Qs(n,e){return io(Gt(io(n/e))*e)}function Zh(n,e){return io(Di(io(n/e))*e)}function fb(n,e){return io(Si(io(n/e))*e)}function Gt(n,e=0){if(mb(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Cn(i)/t}var Es=new Map;function pb(n){return((""+n).split(".")[1]||"").length}function Ql(n,e,t,i){let r=[],s=i.map(pb);for(let o=e;o<t;o++){let a=Rn(o),l=Gt(_a(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),d=n==10?u:Gt(u,h);r.push(d),Es.set(d,h)}}return r}var jl={},sm=[],ba=[null,null],Ts=Array.isArray,mb=Number.isInteger,z2=n=>n===void 0;function U_(n){return typeof n=="string"}function Kh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function V2(n){return n!=null&&typeof n=="object"}var H2=Object.getPrototypeOf(Uint8Array),gb="__proto__";function va(n,e=Kh){let t;if(Ts(n)){let i=n.find(r=>r!=null);if(Ts(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=va(n[r],e)}else t=n.slice()}else if(n instanceof H2)t=n.slice();else if(e(n)){t={};for(let i in n)i!=gb&&(t[i]=va(n[i],e))}else t=n;return t}function Sn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=gb&&(Kh(n[r])?Sn(n[r],va(i[r])):n[r]=va(i[r]))}return n}var G2=0,W2=1,q2=2;function X2(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function $2(n,e){if(K2(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return J2(o[0])||(o=Z2(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),d=e?e[o][c]:W2,f=[];for(let m=0;m<u.length;m++){let x=u[m],g=s.get(l[m]);x===null?d!=G2&&(h[g]=x,d==q2&&f.push(g)):h[g]=x}X2(h,f,r),i.push(h)}}return i}var Y2=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Z2(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function K2(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function J2(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ri(1,Si((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var xb=["January","February","March","April","May","June","July","August","September","October","November","December"],yb=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function _b(n){return n.slice(0,3)}var j2=yb.map(_b),Q2=xb.map(_b),eR={MMMM:xb,MMM:Q2,WWWW:yb,WWW:j2};function $l(n){return(n<10?"0":"")+n}function tR(n){return(n<10?"00":n<100?"0":"")+n}var nR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>$l(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>$l(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>$l(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>$l(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>$l(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>tR(n.getMilliseconds())};function om(n,e){e=e||eR;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?nR[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var iR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function rR(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==iR?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var bb=n=>n%1==0,Xh=[1,2,2.5,5],sR=Ql(10,-32,0,Xh),vb=Ql(10,0,32,Xh),oR=vb.filter(bb),eo=sR.concat(vb),am=`
`,wb="{YYYY}",z_=am+wb,Sb="{M}/{D}",Kl=am+Sb,Vh=Kl+"/{YY}",Ab="{aa}",aR="{h}:{mm}",xa=aR+Ab,V_=am+xa,H_=":{ss}",Ft=null;function Mb(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Ql(10,0,3,Xh).filter(bb):Ql(10,-3,0,Xh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,wb,Ft,Ft,Ft,Ft,Ft,Ft,1],[r*28,"{MMM}",z_,Ft,Ft,Ft,Ft,Ft,1],[r,Sb,z_,Ft,Ft,Ft,Ft,Ft,1],[i,"{h}"+Ab,Vh,Ft,Kl,Ft,Ft,Ft,1],[t,xa,Vh,Ft,Kl,Ft,Ft,Ft,1],[e,H_,Vh+" "+xa,Ft,Kl+" "+xa,Ft,V_,Ft,1],[n,H_+".{fff}",Vh+" "+xa,Ft,Kl+" "+xa,Ft,V_,Ft,1]];function u(h){return(d,f,m,x,g,p)=>{let b=[],E=g>=o,v=g>=s&&g<o,C=h(m),T=Gt(C*n,3),y=zp(C.getFullYear(),E?0:C.getMonth(),v||E?1:C.getDate()),M=Gt(y*n,3);if(v||E){let B=v?g/s:0,L=E?g/o:0,I=T==M?T:Gt(zp(y.getFullYear()+L,y.getMonth()+B,1)*n,3),D=new Date(Cn(I/n)),U=D.getFullYear(),F=D.getMonth();for(let H=0;I<=x;H++){let W=zp(U+L*H,F+B*H,1),V=W-h(Gt(W*n,3));I=Gt((+W+V)*n,3),I<=x&&b.push(I)}}else{let B=g>=r?r:g,L=Si(m)-Si(T),I=M+L+Zh(T-M,B);b.push(I);let D=h(I),U=D.getHours()+D.getMinutes()/t+D.getSeconds()/i,F=g/i,H=d.axes[f]._space,W=p/H;for(;I=Gt(I+g,n==1?0:3),!(I>x);)if(F>1){let V=Si(Gt(U+F,6))%24,j=h(I).getHours()-V;j>1&&(j=-1),I-=j*i,U=(U+F)%24;let te=b[b.length-1];Gt((I-te)/g,3)*W>=.7&&b.push(I)}else b.push(I)}return b}}return[l,c,u]}var[lR,cR,uR]=Mb(1),[hR,dR,fR]=Mb(.001);Ql(2,-53,53,[1]);function G_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function W_(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,d,f;return i.map(m=>{let x=n(m),g=x.getFullYear(),p=x.getMonth(),b=x.getDate(),E=x.getHours(),v=x.getMinutes(),C=x.getSeconds(),T=g!=l&&a[2]||p!=c&&a[3]||b!=u&&a[4]||E!=h&&a[5]||v!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=p,u=b,h=E,d=v,f=C,T(x)})}}function pR(n,e){let t=om(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function zp(n,e,t){return new Date(n,e,t)}function q_(n,e){return e(n)}var mR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function X_(n,e){return(t,i,r,s)=>s==null?em:e(n(i))}function gR(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function xR(n,e){return n.series[e].fill(n,e)}var yR={show:!0,live:!0,isolate:!1,mount:k2,markers:{show:!0,width:2,stroke:gR,fill:xR,dash:"solid"},idx:null,idxs:null,values:[]};function _R(n,e){let t=n.cursor.points,i=Bi(),r=t.size(n,e);Kt(i,Yl,r),Kt(i,Zl,r);let s=r/-2;Kt(i,"marginLeft",s),Kt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Kt(i,"borderWidth",o),i}function bR(n,e){let t=n.series[e].points;return t._fill||t._stroke}function vR(n,e){let t=n.series[e].points;return t._stroke||t._fill}function wR(n,e){return n.series[e].points.size}var Vp=[0,0];function SR(n,e,t){return Vp[0]=e,Vp[1]=t,Vp}function Hh(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Hp(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var AR={show:!0,x:!0,y:!0,lock:!1,move:SR,points:{one:!1,show:_R,size:wR,width:0,stroke:vR,fill:bR},bind:{mousedown:Hh,mouseup:Hh,click:Hh,dblclick:Hh,mousemove:Hp,mouseleave:Hp,mouseenter:Hp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Tb={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},lm=Sn({},Tb,{filter:db}),Eb=Sn({},lm,{size:10}),Cb=Sn({},Tb,{show:!1}),cm='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Rb="bold "+cm,Pb=1.5,$_={show:!0,scale:"x",stroke:Qp,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rb,side:2,grid:lm,ticks:Eb,border:Cb,font:cm,lineGap:Pb,rotate:0},MR="Value",TR="Time",Y_={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function ER(n,e,t,i,r){return e.map(s=>s==null?"":rm(s))}function CR(n,e,t,i,r,s,o){let a=[],l=Es.get(r)||0;t=o?t:Gt(Zh(t,r),l);for(let c=t;c<=i;c=Gt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Yp(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?jr:cb,u=Si(c(t));r=_a(l,u),l==10&&(r=eo[er(r,eo)]);let h=t,d=r*l;l==10&&(d=eo[er(d,eo)]);do a.push(h),h=h+r,l==10&&!Es.has(h)&&(h=Gt(h,Es.get(r))),h>=d&&(r=h,d=r*l,l==10&&(d=eo[er(d,eo)]));while(h<=i);return a}function RR(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Yp(n,e,ri(l,t),i,r):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Yp(n,e,ri(l,-i),-t,r):[l]).reverse().map(d=>-d).concat(u,c)}var Ib=/./,PR=/[12357]/,IR=/[125]/,Z_=/1/,Zp=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function LR(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?Ib:l(7,o)-u>=c?PR:l(5,o)-u>=c?IR:Z_;if(h==Z_){let d=Rn(l(1,o)-u);if(d<c)return Zp(e.slice().reverse(),a.distr,h,Di(c/d)).reverse()}return Zp(e,a.distr,h,1)}function FR(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Zp(e.slice().reverse(),3,Ib,Di(a/c)).reverse():e}function NR(n,e,t,i){return i==null?em:e==null?"":rm(e)}var K_={show:!0,scale:"y",stroke:Qp,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Rb,side:3,grid:lm,ticks:Eb,border:Cb,font:cm,lineGap:Pb,rotate:0};function BR(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function DR(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Rn(o-s),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var J_={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},Lb=(n,e,t,i,r)=>r,j_={show:!0,auto:!0,sorted:0,gaps:Lb,alpha:1,facets:[Sn({},J_,{scale:"x"}),Sn({},J_,{scale:"y"})]},Q_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Lb,alpha:1,points:{show:DR,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function kR(n,e,t,i,r){return t/10}var Fb={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},OR=Sn({},Fb,{time:!1,ori:1}),eb={};function Nb(n,e){let t=eb[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(i,r,s,o,a,l,c)}},n!=null&&(eb[n]=t)),t}var wa=1,Kp=2;function ro(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],u=i==2?o[r.facets[0].scale]:o[n.series[0].scale],h=i==2?o[r.facets[1].scale]:o[r.scale],d=a.left,f=a.top,m=a.width,x=a.height,g=n.valToPosH,p=n.valToPosV;return u.ori==0?t(r,l,c,u,h,g,p,d,f,m,x,jh,Aa,ed,Db,Ob):t(r,l,c,u,h,p,g,f,d,x,m,Qh,Ma,dm,kb,Ub)}function um(n,e){let t=0,i=0,r=Rt(n.bands,sm);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function UR(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Qr(n,e,t,i,r,s){return ro(n,e,(o,a,l,c,u,h,d,f,m,x,g)=>{let p=o.pxRound,b=c.dir*(c.ori==0?1:-1),E=c.ori==0?Aa:Ma,v,C;b==1?(v=t,C=i):(v=i,C=t);let T=p(h(a[v],c,x,f)),y=p(d(l[v],u,g,m)),M=p(h(a[C],c,x,f)),B=p(d(s==1?u.max:u.min,u,g,m)),L=new Path2D(r);return E(L,M,B),E(L,T,B),E(L,T,y),L})}function Jh(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?ed:dm,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+s),l=d[1]}}let c=t+r-l,u=10;c>0&&a(o,l,i-u/2,c,i+s+u)}return o}function zR(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function hm(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let h=c,d=c;if(r==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=s(n[h]),m=d==h?f:s(n[d]),x=h-r;f=o<=0&&x>=0&&x<l?s(n[x]):f;let p=d+r;m=o>=0&&p>=0&&p<l?s(n[p]):m,m>=f&&a.push([f,m])}return a}function tb(n){return n==0?hb:n==1?Cn:e=>Qs(e,n)}function Bb(n){let e=n==0?jh:Qh,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?i(r,s,o,a,l):(c=tr(c,a/2,l/2),u=tr(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var jh=(n,e,t)=>{n.moveTo(e,t)},Qh=(n,e,t)=>{n.moveTo(t,e)},Aa=(n,e,t)=>{n.lineTo(e,t)},Ma=(n,e,t)=>{n.lineTo(t,e)},ed=Bb(0),dm=Bb(1),Db=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},kb=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},Ob=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},Ub=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function zb(n){return(e,t,i,r,s)=>ro(e,t,(o,a,l,c,u,h,d,f,m,x,g)=>{let{pxRound:p,points:b}=o,E,v;c.ori==0?(E=jh,v=Db):(E=Qh,v=kb);let C=Gt(b.width*It,3),T=(b.size-b.width)/2*It,y=Gt(T*2,3),M=new Path2D,B=new Path2D,{left:L,top:I,width:D,height:U}=e.bbox;ed(B,L-y,I-y,D+y*2,U+y*2);let F=H=>{if(l[H]!=null){let W=p(h(a[H],c,x,f)),V=p(d(l[H],u,g,m));E(M,W+T,V),v(M,W,V,T,0,Gh*2)}};if(s)s.forEach(F);else for(let H=i;H<=r;H++)F(H);return{stroke:C>0?M:null,fill:M,clip:B,flags:wa|Kp}})}function Vb(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var VR=Vb(Aa),HR=Vb(Ma);function Hb(n){let e=Rt(n?.alignGaps,0);return(t,i,r,s)=>ro(t,i,(o,a,l,c,u,h,d,f,m,x,g)=>{[r,s]=$h(l,r,s);let p=o.pxRound,b=U=>p(h(U,c,x,f)),E=U=>p(d(U,u,g,m)),v,C;c.ori==0?(v=Aa,C=VR):(v=Ma,C=HR);let T=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wa},M=y.stroke,B=!1;if(s-r>=x*4){let U=he=>t.posToVal(he,c.key,!0),F=null,H=null,W,V,ae,$=b(a[T==1?r:s]),j=b(a[r]),te=b(a[s]),ue=U(T==1?j+1:te-1);for(let he=T==1?r:s;he>=r&&he<=s;he+=T){let ee=a[he],be=(T==1?ee<ue:ee>ue)?$:b(ee),Pe=l[he];be==$?Pe!=null?(V=Pe,F==null?(v(M,be,E(V)),W=F=H=V):V<F?F=V:V>H&&(H=V)):Pe===null&&(B=!0):(F!=null&&C(M,$,E(F),E(H),E(W),E(V)),Pe!=null?(V=Pe,v(M,be,E(V)),F=H=W=V):(F=H=null,Pe===null&&(B=!0)),$=be,ue=U($+T))}F!=null&&F!=H&&ae!=$&&C(M,$,E(F),E(H),E(W),E(V))}else for(let U=T==1?r:s;U>=r&&U<=s;U+=T){let F=l[U];F===null?B=!0:F!=null&&v(M,b(a[U]),E(F))}let[I,D]=um(t,i);if(o.fill!=null||I!=0){let U=y.fill=new Path2D(M),F=o.fillTo(t,i,o.min,o.max,I),H=E(F),W=b(a[r]),V=b(a[s]);T==-1&&([V,W]=[W,V]),v(U,V,H),v(U,W,H)}if(!o.spanGaps){let U=[];B&&U.push(...hm(a,l,r,s,T,b,e)),y.gaps=U=o.gaps(t,i,r,s,U),y.clip=Jh(U,c.ori,f,m,x,g)}return D!=0&&(y.band=D==2?[Qr(t,i,r,s,M,-1),Qr(t,i,r,s,M,1)]:Qr(t,i,r,s,M,D)),y})}function GR(n){let e=Rt(n.align,1),t=Rt(n.ascDesc,!1),i=Rt(n.alignGaps,0),r=Rt(n.extend,!1);return(s,o,a,l)=>ro(s,o,(c,u,h,d,f,m,x,g,p,b,E)=>{[a,l]=$h(h,a,l);let v=c.pxRound,{left:C,width:T}=s.bbox,y=j=>v(m(j,d,b,g)),M=j=>v(x(j,f,E,p)),B=d.ori==0?Aa:Ma,L={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wa},I=L.stroke,D=d.dir*(d.ori==0?1:-1),U=M(h[D==1?a:l]),F=y(u[D==1?a:l]),H=F,W=F;r&&e==-1&&(W=C,B(I,W,U)),B(I,F,U);for(let j=D==1?a:l;j>=a&&j<=l;j+=D){let te=h[j];if(te==null)continue;let ue=y(u[j]),he=M(te);e==1?B(I,ue,U):B(I,H,he),B(I,ue,he),U=he,H=ue}let V=H;r&&e==1&&(V=C+T,B(I,V,U));let[ae,$]=um(s,o);if(c.fill!=null||ae!=0){let j=L.fill=new Path2D(I),te=c.fillTo(s,o,c.min,c.max,ae),ue=M(te);B(j,V,ue),B(j,W,ue)}if(!c.spanGaps){let j=[];j.push(...hm(u,h,a,l,D,y,i));let te=c.width*It/2,ue=t||e==1?te:-te,he=t||e==-1?-te:te;j.forEach(ee=>{ee[0]+=ue,ee[1]+=he}),L.gaps=j=c.gaps(s,o,a,l,j),L.clip=Jh(j,d.ori,g,p,b,E)}return $!=0&&(L.band=$==2?[Qr(s,o,a,l,I,-1),Qr(s,o,a,l,I,1)]:Qr(s,o,a,l,I,$)),L})}function nb(n,e,t,i,r,s,o=Ht){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Rn(n[l]-n[a]);u<c&&(c=u,o=Rn(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function WR(n){n=n||jl;let e=Rt(n.size,[.6,Ht,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=St(r),o=1-e[0],a=Rt(e[1],Ht),l=Rt(e[2],1),c=Rt(n.disp,jl),u=Rt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,x,g)=>ro(f,m,(p,b,E,v,C,T,y,M,B,L,I)=>{let D=p.pxRound,U=t,F=i*It,H=a*It,W=l*It,V,ae;v.ori==0?[V,ae]=s(f,m):[ae,V]=s(f,m);let $=v.dir*(v.ori==0?1:-1),j=v.ori==0?ed:dm,te=v.ori==0?u:(Le,Je,ct,Me,Vt,Ge,Ke)=>{u(Le,Je,ct,Vt,Me,Ke,Ge)},ue=Rt(f.bands,sm).find(Le=>Le.series[0]==m),he=ue!=null?ue.dir:0,ee=p.fillTo(f,m,p.min,p.max,he),ge=D(y(ee,C,I,B)),be,Pe,Ae,$e=L,lt=D(p.width*It),qe=!1,gt=null,ft=null,ot=null,Jt=null;h!=null&&(lt==0||d!=null)&&(qe=!0,gt=h.values(f,m,x,g),ft=new Map,new Set(gt).forEach(Le=>{Le!=null&&ft.set(Le,new Path2D)}),lt>0&&(ot=d.values(f,m,x,g),Jt=new Map,new Set(ot).forEach(Le=>{Le!=null&&Jt.set(Le,new Path2D)})));let{x0:Wt,size:pn}=c;if(Wt!=null&&pn!=null){U=1,b=Wt.values(f,m,x,g),Wt.unit==2&&(b=b.map(ct=>f.posToVal(M+ct*L,v.key,!0)));let Le=pn.values(f,m,x,g);pn.unit==2?Pe=Le[0]*L:Pe=T(Le[0],v,L,M)-T(0,v,L,M),$e=nb(b,E,T,v,L,M,$e),Ae=$e-Pe+F}else $e=nb(b,E,T,v,L,M,$e),Ae=$e*o+F,Pe=$e-Ae;Ae<1&&(Ae=0),lt>=Pe/2&&(lt=0),Ae<5&&(D=hb);let Ot=Ae>0,Pn=$e-Ae-(Ot?lt:0);Pe=D($p(Pn,W,H)),be=(U==0?Pe/2:U==$?0:Pe)-U*$*((U==0?F/2:0)+(Ot?lt/2:0));let Tt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},An=qe?null:new Path2D,sn=null;if(ue!=null)sn=f.data[ue.series[1]];else{let{y0:Le,y1:Je}=c;Le!=null&&Je!=null&&(E=Je.values(f,m,x,g),sn=Le.values(f,m,x,g))}let mn=V*Pe,O=ae*Pe;for(let Le=$==1?x:g;Le>=x&&Le<=g;Le+=$){let Je=E[Le];if(Je==null)continue;if(sn!=null){let q=sn[Le]??0;if(Je-q==0)continue;ge=y(q,C,I,B)}let ct=v.distr!=2||c!=null?b[Le]:Le,Me=T(ct,v,L,M),Vt=y(Rt(Je,ee),C,I,B),Ge=D(Me-be),Ke=D(ri(Vt,ge)),R=D(tr(Vt,ge)),w=Ke-R;if(Je!=null){let q=Je<0?O:mn,de=Je<0?mn:O;qe?(lt>0&&ot[Le]!=null&&j(Jt.get(ot[Le]),Ge,R+Si(lt/2),Pe,ri(0,w-lt),q,de),gt[Le]!=null&&j(ft.get(gt[Le]),Ge,R+Si(lt/2),Pe,ri(0,w-lt),q,de)):j(An,Ge,R+Si(lt/2),Pe,ri(0,w-lt),q,de),te(f,m,Le,Ge-lt/2,R,Pe+lt,w)}}return lt>0?Tt.stroke=qe?Jt:An:qe||(Tt._fill=p.width==0?p._fill:p._stroke??p._fill,Tt.width=0),Tt.fill=qe?ft:An,Tt})}function qR(n,e){let t=Rt(e?.alignGaps,0);return(i,r,s,o)=>ro(i,r,(a,l,c,u,h,d,f,m,x,g,p)=>{[s,o]=$h(c,s,o);let b=a.pxRound,E=V=>b(d(V,u,g,m)),v=V=>b(f(V,h,p,x)),C,T,y;u.ori==0?(C=jh,y=Aa,T=Ob):(C=Qh,y=Ma,T=Ub);let M=u.dir*(u.ori==0?1:-1),B=E(l[M==1?s:o]),L=B,I=[],D=[];for(let V=M==1?s:o;V>=s&&V<=o;V+=M)if(c[V]!=null){let $=l[V],j=E($);I.push(L=j),D.push(v(c[V]))}let U={stroke:n(I,D,C,y,T,b),fill:null,clip:null,band:null,gaps:null,flags:wa},F=U.stroke,[H,W]=um(i,r);if(a.fill!=null||H!=0){let V=U.fill=new Path2D(F),ae=a.fillTo(i,r,a.min,a.max,H),$=v(ae);y(V,L,$),y(V,B,$)}if(!a.spanGaps){let V=[];V.push(...hm(l,c,s,o,M,E,t)),U.gaps=V=a.gaps(i,r,s,o,V),U.clip=Jh(V,u.ori,m,x,g,p)}return W!=0&&(U.band=W==2?[Qr(i,r,s,o,F,-1),Qr(i,r,s,o,F,1)]:Qr(i,r,s,o,F,W)),U})}function XR(n){return qR($R,n)}function $R(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)r(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var Jp=new Set;function ib(){for(let n of Jp)n.syncRect(!0)}Sa&&(no(E2,ya,ib),no(C2,ya,ib,!0),no(Wh,ya,()=>{Hn.pxRatio=It}));var YR=Hb(),ZR=zb();function rb(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>jp(s,o,e,t))}function KR(n,e){return n.map((t,i)=>i==0?{}:Sn({},e,t))}function jp(n,e,t,i){return Sn({},e==0?t:i,n)}function Gb(n,e,t){return e==null?ba:[e,t]}var JR=Gb;function jR(n,e,t){return e==null?ba:qh(e,t,im,!0)}function Wb(n,e,t,i){return e==null?ba:Yh(e,t,n.scales[i].log,!1)}var QR=Wb;function qb(n,e,t,i){return e==null?ba:nm(e,t,n.scales[i].log,!1)}var eP=qb;function tP(n,e,t,i,r){let s=ri(D_(n),D_(e)),o=e-n,a=er(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Es.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function sb(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Cn((t=+r)*It))+"px"),[n,e,t]}function nP(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Hn(n,e,t){let i={mode:Rt(n.mode,1)},r=i.mode;function s(_,S,P,N){let G=S.valToPct(_);return N+P*(S.dir==-1?1-G:G)}function o(_,S,P,N){let G=S.valToPct(_);return N+P*(S.dir==-1?G:1-G)}function a(_,S,P,N){return S.ori==0?s(_,S,P,N):o(_,S,P,N)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Bi(c2);if(n.id!=null&&(c.id=n.id),wi(c,n.class),n.title){let _=Bi(d2,c);_.textContent=n.title}let u=Qi("canvas"),h=i.ctx=u.getContext("2d"),d=Bi(f2,c);no("click",d,_=>{_.target===m&&(Xt!=fo||jt!=po)&&Un.click(i,_)},!0);let f=i.under=Bi(p2,d);d.appendChild(u);let m=i.over=Bi(m2,d);n=va(n);let x=+Rt(n.pxAlign,1),g=tb(x);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let p=n.ms||.001,b=i.series=r==1?rb(n.series||[],Y_,Q_,!1):KR(n.series||[null],j_),E=i.axes=rb(n.axes||[],$_,K_,!0),v=i.scales={},C=i.bands=n.bands||[];C.forEach(_=>{_.fill=St(_.fill||null),_.dir=Rt(_.dir,-1)});let T=r==2?b[1].facets[0].scale:b[0].scale,y={axes:Lr,series:yt},M=(n.drawOrder||["axes","series"]).map(_=>y[_]);function B(_){let S=_.distr==3?P=>jr(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>Up(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=S(P),{_min:G,_max:J}=_,le=J-G;return(N-G)/le}}function L(_){let S=v[_];if(S==null){let P=(n.scales||jl)[_]||jl;if(P.from!=null){L(P.from);let N=Sn({},v[P.from],P,{key:_});N.valToPct=B(N),v[_]=N}else{S=v[_]=Sn({},_==T?Fb:OR,P),S.key=_;let N=S.time,G=S.range,J=Ts(G);if((_!=T||r==2&&!N)&&(J&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?F_:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?F_:{mode:1,hard:G[1],soft:G[1]}},J=!1),!J&&Kh(G))){let le=G;G=(pe,we,De)=>we==null?ba:qh(we,De,le)}S.range=St(G||(N?JR:_==T?S.distr==3?QR:S.distr==4?eP:Gb:S.distr==3?Wb:S.distr==4?qb:jR)),S.auto=St(J?!1:S.auto),S.clamp=St(S.clamp||kR),S._min=S._max=null,S.valToPct=B(S)}}}L("x"),L("y"),r==1&&b.forEach(_=>{L(_.scale)}),E.forEach(_=>{L(_.scale)});for(let _ in n.scales)L(_);let I=v[T],D=I.distr,U,F;I.ori==0?(wi(c,u2),U=s,F=o):(wi(c,h2),U=o,F=s);let H={};for(let _ in v){let S=v[_];(S.min!=null||S.max!=null)&&(H[_]={min:S.min,max:S.max},S.min=S.max=null)}let W=n.tzDate||(_=>new Date(Cn(_/p))),V=n.fmtDate||om,ae=p==1?uR(W):fR(W),$=W_(W,G_(p==1?cR:dR,V)),j=X_(W,q_(mR,V)),te=[],ue=i.legend=Sn({},yR,n.legend),he=i.cursor=Sn({},AR,{drag:{y:r==2}},n.cursor),ee=ue.show,ge=he.show,be=ue.markers;ue.idxs=te,be.width=St(be.width),be.dash=St(be.dash),be.stroke=St(be.stroke),be.fill=St(be.fill);let Pe,Ae,$e,lt=[],qe=[],gt,ft=!1,ot={};if(ue.live){let _=b[1]?b[1].values:null;ft=_!=null,gt=ft?_(i,1,0):{_:0};for(let S in gt)ot[S]=em}if(ee)if(Pe=Qi("table",v2,c),$e=Qi("tbody",null,Pe),ue.mount(i,Pe),ft){Ae=Qi("thead",null,Pe,$e);let _=Qi("tr",null,Ae);Qi("th",null,_);for(var Jt in gt)Qi("th",b_,_).textContent=Jt}else wi(Pe,S2),ue.live&&wi(Pe,w2);let Wt={show:!0},pn={show:!1};function Ot(_,S){if(S==0&&(ft||!ue.live||r==2))return ba;let P=[],N=Qi("tr",A2,$e,$e.childNodes[S]);wi(N,_.class),_.show||wi(N,to);let G=Qi("th",null,N);if(be.show){let pe=Bi(M2,G);if(S>0){let we=be.width(i,S);we&&(pe.style.border=we+"px "+be.dash(i,S)+" "+be.stroke(i,S)),pe.style.background=be.fill(i,S)}}let J=Bi(b_,G);_.label instanceof HTMLElement?J.appendChild(_.label):J.textContent=_.label,S>0&&(be.show||(J.style.color=_.width>0?be.stroke(i,S):be.fill(i,S)),Tt("click",G,pe=>{if(he._lock)return;tt(pe);let we=b.indexOf(_);if((pe.ctrlKey||pe.metaKey)!=ue.isolate){let De=b.some((ke,Ue)=>Ue>0&&Ue!=we&&ke.show);b.forEach((ke,Ue)=>{Ue>0&&sr(Ue,De?Ue==we?Wt:pn:Wt,!0,_n.setSeries)})}else sr(we,{show:!_.show},!0,_n.setSeries)},!1),nt&&Tt(A_,G,pe=>{he._lock||(tt(pe),sr(b.indexOf(_),go,!0,_n.setSeries))},!1));for(var le in gt){let pe=Qi("td",T2,N);pe.textContent="--",P.push(pe)}return[N,P]}let Pn=new Map;function Tt(_,S,P,N=!0){let G=Pn.get(S)||{},J=he.bind[_](i,S,P,N);J&&(no(_,S,G[_]=J),Pn.set(S,G))}function An(_,S,P){let N=Pn.get(S)||{};for(let G in N)(_==null||G==_)&&(Xp(G,S,N[G]),delete N[G]);_==null&&Pn.delete(S)}let sn=0,mn=0,O=0,Le=0,Je=0,ct=0,Me=Je,Vt=ct,Ge=O,Ke=Le,R=0,w=0,q=0,de=0;i.bbox={};let oe=!1,ye=!1,ve=!1,ne=!1,re=!1,me=!1;function k(_,S,P){(P||_!=i.width||S!=i.height)&&se(_,S),pt(!1),ve=!0,ye=!0,Gn()}function se(_,S){i.width=sn=O=_,i.height=mn=Le=S,Je=ct=0,Se(),Xe();let P=i.bbox;R=P.left=Qs(Je*It,.5),w=P.top=Qs(ct*It,.5),q=P.width=Qs(O*It,.5),de=P.height=Qs(Le*It,.5)}let ie=3;function Te(){let _=!1,S=0;for(;!_;){S++;let P=co(S),N=rr(S);_=S==ie||P&&N,_||(se(i.width,i.height),ye=!0)}}function xe({width:_,height:S}){k(_,S)}i.setSize=xe;function Se(){let _=!1,S=!1,P=!1,N=!1;E.forEach((G,J)=>{if(G.show&&G._show){let{side:le,_size:pe}=G,we=le%2,De=G.label!=null?G.labelSize:0,ke=pe+De;ke>0&&(we?(O-=ke,le==3?(Je+=ke,N=!0):P=!0):(Le-=ke,le==0?(ct+=ke,_=!0):S=!0))}}),nr[0]=_,nr[1]=P,nr[2]=S,nr[3]=N,O-=ki[1]+ki[3],Je+=ki[3],Le-=ki[2]+ki[0],ct+=ki[0]}function Xe(){let _=Je+O,S=ct+Le,P=Je,N=ct;function G(J,le){switch(J){case 1:return _+=le,_-le;case 2:return S+=le,S-le;case 3:return P-=le,P+le;case 0:return N-=le,N+le}}E.forEach((J,le)=>{if(J.show&&J._show){let pe=J.side;J._pos=G(pe,J._size),J.label!=null&&(J._lpos=G(pe,J.labelSize))}})}if(he.dataIdx==null){let _=he.hover,S=_.skip=new Set(_.skip??[]);S.add(void 0);let P=_.prox=St(_.prox),N=_.bias??=0;he.dataIdx=(G,J,le,pe)=>{if(J==0)return le;let we=le,De=P(G,J,le,pe)??Ht,ke=De>=0&&De<Ht,Ue=I.ori==0?O:Le,at=he.left,Pt=e[0],Et=e[J];if(S.has(Et[le])){we=null;let _t=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=le;_t==null&&Ye-- >0;)S.has(Et[Ye])||(_t=Ye);if(N==0||N==1)for(Ye=le;Qe==null&&Ye++<Et.length;)S.has(Et[Ye])||(Qe=Ye);if(_t!=null||Qe!=null)if(ke){let Yt=_t==null?-1/0:U(Pt[_t],I,Ue,0),ln=Qe==null?1/0:U(Pt[Qe],I,Ue,0),Nn=at-Yt,Ut=ln-at;Nn<=Ut?Nn<=De&&(we=_t):Ut<=De&&(we=Qe)}else we=Qe==null?_t:_t==null?Qe:le-_t<=Qe-le?_t:Qe}else ke&&Rn(at-U(Pt[le],I,Ue,0))>De&&(we=null);return we}}let tt=_=>{he.event=_};he.idxs=te,he._lock=!1;let ce=he.points;ce.show=St(ce.show),ce.size=St(ce.size),ce.stroke=St(ce.stroke),ce.width=St(ce.width),ce.fill=St(ce.fill);let ze=i.focus=Sn({},n.focus||{alpha:.3},he.focus),nt=ze.prox>=0,Ie=nt&&ce.one,ut=[],qt=[],Zn=[];function Ca(_,S){let P=ce.show(i,S);if(P instanceof HTMLElement)return wi(P,b2),wi(P,_.class),Cr(P,-10,-10,O,Le),m.insertBefore(P,ut[S]),P}function oo(_,S){if(r==1||S>0){let P=r==1&&v[_.scale].time,N=_.value;_.value=P?U_(N)?X_(W,q_(N,V)):N||j:N||NR,_.label=_.label||(P?TR:MR)}if(Ie||S>0){_.width=_.width==null?1:_.width,_.paths=_.paths||YR||O2,_.fillTo=St(_.fillTo||UR),_.pxAlign=+Rt(_.pxAlign,x),_.pxRound=tb(_.pxAlign),_.stroke=St(_.stroke||null),_.fill=St(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=BR(ri(1,_.width),1),N=_.points=Sn({},{size:P,width:ri(1,P*.2),stroke:_.stroke,space:P*2,paths:ZR,_stroke:null,_fill:null},_.points);N.show=St(N.show),N.filter=St(N.filter),N.fill=St(N.fill),N.stroke=St(N.stroke),N.paths=St(N.paths),N.pxAlign=_.pxAlign}if(ee){let P=Ot(_,S);lt.splice(S,0,P[0]),qe.splice(S,0,P[1]),ue.values.push(null)}if(ge){te.splice(S,0,null);let P=null;Ie?S==0&&(P=Ca(_,S)):S>0&&(P=Ca(_,S)),ut.splice(S,0,P),qt.splice(S,0,0),Zn.splice(S,0,0)}Fn("addSeries",S)}function nd(_,S){S=S??b.length,_=r==1?jp(_,S,Y_,Q_):jp(_,S,{},j_),b.splice(S,0,_),oo(b[S],S)}i.addSeries=nd;function ec(_){if(b.splice(_,1),ee){ue.values.splice(_,1),qe.splice(_,1);let S=lt.splice(_,1)[0];An(null,S.firstChild),S.remove()}ge&&(te.splice(_,1),ut.splice(_,1)[0].remove(),qt.splice(_,1),Zn.splice(_,1)),Fn("delSeries",_)}i.delSeries=ec;let nr=[!1,!1,!1,!1];function Rr(_,S){if(_._show=_.show,_.show){let P=_.side%2,N=v[_.scale];N==null&&(_.scale=P?b[1].scale:T,N=v[_.scale]);let G=N.time;_.size=St(_.size),_.space=St(_.space),_.rotate=St(_.rotate),Ts(_.incrs)&&_.incrs.forEach(le=>{!Es.has(le)&&Es.set(le,pb(le))}),_.incrs=St(_.incrs||(N.distr==2?oR:G?p==1?lR:hR:eo)),_.splits=St(_.splits||(G&&N.distr==1?ae:N.distr==3?Yp:N.distr==4?RR:CR)),_.stroke=St(_.stroke),_.grid.stroke=St(_.grid.stroke),_.ticks.stroke=St(_.ticks.stroke),_.border.stroke=St(_.border.stroke);let J=_.values;_.values=Ts(J)&&!Ts(J[0])?St(J):G?Ts(J)?W_(W,G_(J,V)):U_(J)?pR(W,J):J||$:J||ER,_.filter=St(_.filter||(N.distr>=3&&N.log==10?LR:N.distr==3&&N.log==2?FR:db)),_.font=sb(_.font),_.labelFont=sb(_.labelFont),_._size=_.size(i,null,S,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(nr[S]=!0,_._el=Bi(g2,d))}}function Pr(_,S,P,N){let[G,J,le,pe]=P,we=S%2,De=0;return we==0&&(pe||J)&&(De=S==0&&!G||S==2&&!le?Cn($_.size/3):0),we==1&&(G||le)&&(De=S==1&&!J||S==3&&!pe?Cn(K_.size/2):0),De}let Ra=i.padding=(n.padding||[Pr,Pr,Pr,Pr]).map(_=>St(Rt(_,Pr))),ki=i._padding=Ra.map((_,S)=>_(i,S,nr,0)),on,un=null,hn=null,ir=r==1?b[0].idxs:null,hi=null,es=!1;function Pa(_,S){if(e=_??[],i.data=i._data=e,r==2){on=0;for(let P=1;P<b.length;P++)on+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),hi=e[0],on=hi.length;let P=e;if(D==2){P=e.slice();let N=P[0]=Array(on);for(let G=0;G<on;G++)N[G]=G}i._data=e=P}if(pt(!0),Fn("setData"),D==2&&(ve=!0),S!==!1){let P=I;P.auto(i,es)?Ia():is(T,P.min,P.max),ne=ne||he.left>=0,me=!0,Gn()}}i.setData=Pa;function Ia(){es=!0;let _,S;r==1&&(on>0?(un=ir[0]=0,hn=ir[1]=on-1,_=e[0][un],S=e[0][hn],D==2?(_=un,S=hn):_==S&&(D==3?[_,S]=Yh(_,_,I.log,!1):D==4?[_,S]=nm(_,_,I.log,!1):I.time?S=_+Cn(86400/p):[_,S]=qh(_,S,im,!0))):(un=ir[0]=_=null,hn=ir[1]=S=null)),is(T,_,S)}let ao,ts,lo,A,z,Q,Y,K,Ee,Fe;function Ce(_,S,P,N,G,J){_??=w_,P??=sm,N??="butt",G??=w_,J??="round",_!=ao&&(h.strokeStyle=ao=_),G!=ts&&(h.fillStyle=ts=G),S!=lo&&(h.lineWidth=lo=S),J!=z&&(h.lineJoin=z=J),N!=Q&&(h.lineCap=Q=N),P!=A&&h.setLineDash(A=P)}function Ne(_,S,P,N){S!=ts&&(h.fillStyle=ts=S),_!=Y&&(h.font=Y=_),P!=K&&(h.textAlign=K=P),N!=Ee&&(h.textBaseline=Ee=N)}function He(_,S,P,N,G=0){if(N.length>0&&_.auto(i,es)&&(S==null||S.min==null)){let J=Rt(un,0),le=Rt(hn,N.length-1),pe=P.min==null?L2(N,J,le,G,_.distr==3):[P.min,P.max];_.min=tr(_.min,P.min=pe[0]),_.max=ri(_.max,P.max=pe[1])}}let it={min:null,max:null};function xt(){for(let N in v){let G=v[N];H[N]==null&&(G.min==null||H[T]!=null&&G.auto(i,es))&&(H[N]=it)}for(let N in v){let G=v[N];H[N]==null&&G.from!=null&&H[G.from]!=null&&(H[N]=it)}H[T]!=null&&pt(!0);let _={};for(let N in H){let G=H[N];if(G!=null){let J=_[N]=va(v[N],V2);if(G.min!=null)Sn(J,G);else if(N!=T||r==2)if(on==0&&J.from==null){let le=J.range(i,null,null,N);J.min=le[0],J.max=le[1]}else J.min=Ht,J.max=-Ht}}if(on>0){b.forEach((N,G)=>{if(r==1){let J=N.scale,le=H[J];if(le==null)return;let pe=_[J];if(G==0){let we=pe.range(i,pe.min,pe.max,J);pe.min=we[0],pe.max=we[1],un=er(pe.min,e[0]),hn=er(pe.max,e[0]),hn-un>1&&(e[0][un]<pe.min&&un++,e[0][hn]>pe.max&&hn--),N.min=hi[un],N.max=hi[hn]}else N.show&&N.auto&&He(pe,le,N,e[G],N.sorted);N.idxs[0]=un,N.idxs[1]=hn}else if(G>0&&N.show&&N.auto){let[J,le]=N.facets,pe=J.scale,we=le.scale,[De,ke]=e[G],Ue=_[pe],at=_[we];Ue!=null&&He(Ue,H[pe],J,De,J.sorted),at!=null&&He(at,H[we],le,ke,le.sorted),N.min=le.min,N.max=le.max}});for(let N in _){let G=_[N],J=H[N];if(G.from==null&&(J==null||J.min==null)){let le=G.range(i,G.min==Ht?null:G.min,G.max==-Ht?null:G.max,N);G.min=le[0],G.max=le[1]}}}for(let N in _){let G=_[N];if(G.from!=null){let J=_[G.from];if(J.min==null)G.min=G.max=null;else{let le=G.range(i,J.min,J.max,N);G.min=le[0],G.max=le[1]}}}let S={},P=!1;for(let N in _){let G=_[N],J=v[N];if(J.min!=G.min||J.max!=G.max){J.min=G.min,J.max=G.max;let le=J.distr;J._min=le==3?jr(J.min):le==4?Up(J.min,J.asinh):le==100?J.fwd(J.min):J.min,J._max=le==3?jr(J.max):le==4?Up(J.max,J.asinh):le==100?J.fwd(J.max):J.max,S[N]=P=!0}}if(P){b.forEach((N,G)=>{r==2?G>0&&S.y&&(N._paths=null):S[N.scale]&&(N._paths=null)});for(let N in S)ve=!0,Fn("setScale",N);ge&&he.left>=0&&(ne=me=!0)}for(let N in H)H[N]=null}function Ve(_){let S=$p(un-1,0,on-1),P=$p(hn+1,0,on-1);for(;_[S]==null&&S>0;)S--;for(;_[P]==null&&P<on-1;)P++;return[S,P]}function yt(){if(on>0){let _=b.some(S=>S._focus)&&Fe!=ze.alpha;_&&(h.globalAlpha=Fe=ze.alpha),b.forEach((S,P)=>{if(P>0&&S.show&&(tn(P,!1),tn(P,!0),S._paths==null)){let N=Fe;Fe!=S.alpha&&(h.globalAlpha=Fe=S.alpha);let G=r==2?[0,e[P][0].length-1]:Ve(e[P]);S._paths=S.paths(i,P,G[0],G[1]),Fe!=N&&(h.globalAlpha=Fe=N)}}),b.forEach((S,P)=>{if(P>0&&S.show){let N=Fe;Fe!=S.alpha&&(h.globalAlpha=Fe=S.alpha),S._paths!=null&&Nt(P,!1);{let G=S._paths!=null?S._paths.gaps:null,J=S.points.show(i,P,un,hn,G),le=S.points.filter(i,P,J,G);(J||le)&&(S.points._paths=S.points.paths(i,P,un,hn,le),Nt(P,!0))}Fe!=N&&(h.globalAlpha=Fe=N),Fn("drawSeries",P)}}),_&&(h.globalAlpha=Fe=1)}}function tn(_,S){let P=S?b[_].points:b[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Nt(_,S){let P=S?b[_].points:b[_],{stroke:N,fill:G,clip:J,flags:le,_stroke:pe=P._stroke,_fill:we=P._fill,_width:De=P.width}=P._paths;De=Gt(De*It,3);let ke=null,Ue=De%2/2;S&&we==null&&(we=De>0?"#fff":pe);let at=P.pxAlign==1&&Ue>0;if(at&&h.translate(Ue,Ue),!S){let Pt=R-De/2,Et=w-De/2,_t=q+De,Qe=de+De;ke=new Path2D,ke.rect(Pt,Et,_t,Qe)}S?Oe(pe,De,P.dash,P.cap,we,N,G,le,J):Bt(_,pe,De,P.dash,P.cap,we,N,G,le,ke,J),at&&h.translate(-Ue,-Ue)}function Bt(_,S,P,N,G,J,le,pe,we,De,ke){let Ue=!1;we!=0&&C.forEach((at,Pt)=>{if(at.series[0]==_){let Et=b[at.series[1]],_t=e[at.series[1]],Qe=(Et._paths||jl).band;Ts(Qe)&&(Qe=at.dir==1?Qe[0]:Qe[1]);let Ye,Yt=null;Et.show&&Qe&&N2(_t,un,hn)?(Yt=at.fill(i,Pt)||J,Ye=Et._paths.clip):Qe=null,Oe(S,P,N,G,Yt,le,pe,we,De,ke,Ye,Qe),Ue=!0}}),Ue||Oe(S,P,N,G,J,le,pe,we,De,ke)}let Mn=wa|Kp;function Oe(_,S,P,N,G,J,le,pe,we,De,ke,Ue){Ce(_,S,P,N,G),(we||De||Ue)&&(h.save(),we&&h.clip(we),De&&h.clip(De)),Ue?(pe&Mn)==Mn?(h.clip(Ue),ke&&h.clip(ke),vt(G,le),gn(_,J,S)):pe&Kp?(vt(G,le),h.clip(Ue),gn(_,J,S)):pe&wa&&(h.save(),h.clip(Ue),ke&&h.clip(ke),vt(G,le),h.restore(),gn(_,J,S)):(vt(G,le),gn(_,J,S)),(we||De||Ue)&&h.restore()}function gn(_,S,P){P>0&&(S instanceof Map?S.forEach((N,G)=>{h.strokeStyle=ao=G,h.stroke(N)}):S!=null&&_&&h.stroke(S))}function vt(_,S){S instanceof Map?S.forEach((P,N)=>{h.fillStyle=ts=N,h.fill(P)}):S!=null&&_&&h.fill(S)}function Ir(_,S,P,N){let G=E[_],J;if(N<=0)J=[0,0];else{let le=G._space=G.space(i,_,S,P,N),pe=G._incrs=G.incrs(i,_,S,P,N,le);J=tP(S,P,pe,N,le)}return G._found=J}function xn(_,S,P,N,G,J,le,pe,we,De){let ke=le%2/2;x==1&&h.translate(ke,ke),Ce(pe,le,we,De,pe),h.beginPath();let Ue,at,Pt,Et,_t=G+(N==0||N==3?-J:J);P==0?(at=G,Et=_t):(Ue=G,Pt=_t);for(let Qe=0;Qe<_.length;Qe++)S[Qe]!=null&&(P==0?Ue=Pt=_[Qe]:at=Et=_[Qe],h.moveTo(Ue,at),h.lineTo(Pt,Et));h.stroke(),x==1&&h.translate(-ke,-ke)}function co(_){let S=!0;return E.forEach((P,N)=>{if(!P.show)return;let G=v[P.scale];if(G.min==null){P._show&&(S=!1,P._show=!1,pt(!1));return}else P._show||(S=!1,P._show=!0,pt(!1));let J=P.side,le=J%2,{min:pe,max:we}=G,[De,ke]=Ir(N,pe,we,le==0?O:Le);if(ke==0)return;let Ue=G.distr==2,at=P._splits=P.splits(i,N,pe,we,De,ke,Ue),Pt=G.distr==2?at.map(Ye=>hi[Ye]):at,Et=G.distr==2?hi[at[1]]-hi[at[0]]:De,_t=P._values=P.values(i,P.filter(i,Pt,N,ke,Et),N,ke,Et);P._rotate=J==2?P.rotate(i,_t,N,ke):0;let Qe=P._size;P._size=Di(P.size(i,_t,N,_)),Qe!=null&&P._size!=Qe&&(S=!1)}),S}function rr(_){let S=!0;return Ra.forEach((P,N)=>{let G=P(i,N,nr,_);G!=ki[N]&&(S=!1),ki[N]=G}),S}function Lr(){for(let _=0;_<E.length;_++){let S=E[_];if(!S.show||!S._show)continue;let P=S.side,N=P%2,G,J,le=S.stroke(i,_),pe=P==0||P==3?-1:1,[we,De]=S._found;if(S.label!=null){let jn=S.labelGap*pe,pi=Cn((S._lpos+jn)*It);Ne(S.labelFont[0],le,"center",P==2?"top":v_),h.save(),N==1?(G=J=0,h.translate(pi,Cn(w+de/2)),h.rotate((P==3?-Gh:Gh)/2)):(G=Cn(R+q/2),J=pi);let Ps=ub(S.label)?S.label(i,_,we,De):S.label;h.fillText(Ps,G,J),h.restore()}if(De==0)continue;let ke=v[S.scale],Ue=N==0?q:de,at=N==0?R:w,Pt=S._splits,Et=ke.distr==2?Pt.map(jn=>hi[jn]):Pt,_t=ke.distr==2?hi[Pt[1]]-hi[Pt[0]]:we,Qe=S.ticks,Ye=S.border,Yt=Qe.show?Qe.size:0,ln=Cn(Yt*It),Nn=Cn((S.alignTo==2?S._size-Yt-S.gap:S.gap)*It),Ut=S._rotate*-Gh/180,cn=g(S._pos*It),di=(ln+Nn)*pe,Jn=cn+di;J=N==0?Jn:0,G=N==1?Jn:0;let Mi=S.font[0],Oi=S.align==1?ga:S.align==2?Dp:Ut>0?ga:Ut<0?Dp:N==0?"center":P==3?Dp:ga,ar=Ut||N==1?"middle":P==2?"top":v_;Ne(Mi,le,Oi,ar);let fi=S.font[1]*S.lineGap,Ti=Pt.map(jn=>g(a(jn,ke,Ue,at))),Ui=S._values;for(let jn=0;jn<Ui.length;jn++){let pi=Ui[jn];if(pi!=null){N==0?G=Ti[jn]:J=Ti[jn],pi=""+pi;let Ps=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let Qn=0;Qn<Ps.length;Qn++){let Fm=Ps[Qn];Ut?(h.save(),h.translate(G,J+Qn*fi),h.rotate(Ut),h.fillText(Fm,0,0),h.restore()):h.fillText(Fm,G,J+Qn*fi)}}}Qe.show&&xn(Ti,Qe.filter(i,Et,_,De,_t),N,P,cn,ln,Gt(Qe.width*It,3),Qe.stroke(i,_),Qe.dash,Qe.cap);let lr=S.grid;lr.show&&xn(Ti,lr.filter(i,Et,_,De,_t),N,N==0?2:1,N==0?w:R,N==0?de:q,Gt(lr.width*It,3),lr.stroke(i,_),lr.dash,lr.cap),Ye.show&&xn([cn],[1],N==0?1:0,N==0?1:2,N==1?w:R,N==1?de:q,Gt(Ye.width*It,3),Ye.stroke(i,_),Ye.dash,Ye.cap)}Fn("drawAxes")}function pt(_){b.forEach((S,P)=>{P>0&&(S._paths=null,_&&(r==1?(S.min=null,S.max=null):S.facets.forEach(N=>{N.min=null,N.max=null})))})}let an=!1,Kn=!1,Dt=[];function yn(){Kn=!1;for(let _=0;_<Dt.length;_++)Fn(...Dt[_]);Dt.length=0}function Gn(){an||(Y2(mm),an=!0)}function tc(_,S=!1){an=!0,Kn=S,_(i),mm(),S&&Dt.length>0&&queueMicrotask(yn)}i.batch=tc;function mm(){if(oe&&(xt(),oe=!1),ve&&(Te(),ve=!1),ye){if(Kt(f,ga,Je),Kt(f,"top",ct),Kt(f,Yl,O),Kt(f,Zl,Le),Kt(m,ga,Je),Kt(m,"top",ct),Kt(m,Yl,O),Kt(m,Zl,Le),Kt(d,Yl,sn),Kt(d,Zl,mn),u.width=Cn(sn*It),u.height=Cn(mn*It),E.forEach(({_el:_,_show:S,_size:P,_pos:N,side:G})=>{if(_!=null)if(S){let J=G===3||G===0?P:0,le=G%2==1;Kt(_,le?"left":"top",N-J),Kt(_,le?"width":"height",P),Kt(_,le?"top":"left",le?ct:Je),Kt(_,le?"height":"width",le?Le:O),qp(_,to)}else wi(_,to)}),ao=ts=lo=z=Q=Y=K=Ee=A=null,Fe=1,Na(!0),Je!=Me||ct!=Vt||O!=Ge||Le!=Ke){pt(!1);let _=O/Ge,S=Le/Ke;if(ge&&!ne&&he.left>=0){he.left*=_,he.top*=S,uo&&Cr(uo,Cn(he.left),0,O,Le),ho&&Cr(ho,0,Cn(he.top),O,Le);for(let P=0;P<ut.length;P++){let N=ut[P];N!=null&&(qt[P]*=_,Zn[P]*=S,Cr(N,Di(qt[P]),Di(Zn[P]),O,Le))}}if($t.show&&!re&&$t.left>=0&&$t.width>0){$t.left*=_,$t.width*=_,$t.top*=S,$t.height*=S;for(let P in ld)Kt(mo,P,$t[P])}Me=Je,Vt=ct,Ge=O,Ke=Le}Fn("setSize"),ye=!1}sn>0&&mn>0&&(h.clearRect(0,0,u.width,u.height),Fn("drawClear"),M.forEach(_=>_()),Fn("draw")),$t.show&&re&&(nc($t),re=!1),ge&&ne&&(Rs(null,!0,!1),ne=!1),ue.show&&ue.live&&me&&(od(),me=!1),l||(l=!0,i.status=1,Fn("ready")),es=!1,an=!1}i.redraw=(_,S)=>{ve=S||!1,_!==!1?is(T,I.min,I.max):Gn()};function id(_,S){let P=v[_];if(P.from==null){if(on==0){let N=P.range(i,S.min,S.max,_);S.min=N[0],S.max=N[1]}if(S.min>S.max){let N=S.min;S.min=S.max,S.max=N}if(on>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;_==T&&P.distr==2&&on>0&&(S.min=er(S.min,e[0]),S.max=er(S.max,e[0]),S.min==S.max&&S.max++),H[_]=S,oe=!0,Gn()}}i.setScale=id;let rd,sd,uo,ho,gm,xm,fo,po,ym,_m,Xt,jt,ns=!1,Un=he.drag,In=Un.x,Ln=Un.y;ge&&(he.x&&(rd=Bi(y2,m)),he.y&&(sd=Bi(_2,m)),I.ori==0?(uo=rd,ho=sd):(uo=sd,ho=rd),Xt=he.left,jt=he.top);let $t=i.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),mo=$t.show?Bi(x2,$t.over?m:f):null;function nc(_,S){if($t.show){for(let P in _)$t[P]=_[P],P in ld&&Kt(mo,P,_[P]);S!==!1&&Fn("setSelect")}}i.setSelect=nc;function gv(_){if(b[_].show)ee&&qp(lt[_],to);else if(ee&&wi(lt[_],to),ge){let P=Ie?ut[0]:ut[_];P!=null&&Cr(P,-10,-10,O,Le)}}function is(_,S,P){id(_,{min:S,max:P})}function sr(_,S,P,N){S.focus!=null&&vv(_),S.show!=null&&b.forEach((G,J)=>{J>0&&(_==J||_==null)&&(G.show=S.show,gv(J),r==2?(is(G.facets[0].scale,null,null),is(G.facets[1].scale,null,null)):is(G.scale,null,null),Gn())}),P!==!1&&Fn("setSeries",_,S),N&&Ba("setSeries",i,_,S)}i.setSeries=sr;function xv(_,S){Sn(C[_],S)}function yv(_,S){_.fill=St(_.fill||null),_.dir=Rt(_.dir,-1),S=S??C.length,C.splice(S,0,_)}function _v(_){_==null?C.length=0:C.splice(_,1)}i.addBand=yv,i.setBand=xv,i.delBand=_v;function bv(_,S){b[_].alpha=S,ge&&ut[_]!=null&&(ut[_].style.opacity=S),ee&&lt[_]&&(lt[_].style.opacity=S)}let Fr,rs,Cs,go={focus:!0};function vv(_){if(_!=Cs){let S=_==null,P=ze.alpha!=1;b.forEach((N,G)=>{if(r==1||G>0){let J=S||G==0||G==_;N._focus=S?null:J,P&&bv(G,J?1:ze.alpha)}}),Cs=_,P&&Gn()}}ee&&nt&&Tt(M_,Pe,_=>{he._lock||(tt(_),Cs!=null&&sr(null,go,!0,_n.setSeries))});function or(_,S,P){let N=v[S];P&&(_=_/It-(N.ori==1?ct:Je));let G=O;N.ori==1&&(G=Le,_=G-_),N.dir==-1&&(_=G-_);let J=N._min,le=N._max,pe=_/G,we=J+(le-J)*pe,De=N.distr;return De==3?_a(10,we):De==4?D2(we,N.asinh):De==100?N.bwd(we):we}function wv(_,S){let P=or(_,T,S);return er(P,e[0],un,hn)}i.valToIdx=_=>er(_,e[0]),i.posToIdx=wv,i.posToVal=or,i.valToPos=(_,S,P)=>v[S].ori==0?s(_,v[S],P?q:O,P?R:0):o(_,v[S],P?de:Le,P?w:0),i.setCursor=(_,S,P)=>{Xt=_.left,jt=_.top,Rs(null,S,P)};function bm(_,S){Kt(mo,ga,$t.left=_),Kt(mo,Yl,$t.width=S)}function vm(_,S){Kt(mo,"top",$t.top=_),Kt(mo,Zl,$t.height=S)}let La=I.ori==0?bm:vm,Fa=I.ori==1?bm:vm;function Sv(){if(ee&&ue.live)for(let _=r==2?1:0;_<b.length;_++){if(_==0&&ft)continue;let S=ue.values[_],P=0;for(let N in S)qe[_][P++].firstChild.nodeValue=S[N]}}function od(_,S){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{te[N]=P}):z2(_.idx)||te.fill(_.idx),ue.idx=te[0]),ee&&ue.live){for(let P=0;P<b.length;P++)(P>0||r==1&&!ft)&&Av(P,te[P]);Sv()}me=!1,S!==!1&&Fn("setLegend")}i.setLegend=od;function Av(_,S){let P=b[_],N=_==0&&D==2?hi:e[_],G;ft?G=P.values(i,_,S)??ot:(G=P.value(i,S==null?null:N[S],_,S),G=G==null?ot:{_:G}),ue.values[_]=G}function Rs(_,S,P){ym=Xt,_m=jt,[Xt,jt]=he.move(i,Xt,jt),he.left=Xt,he.top=jt,ge&&(uo&&Cr(uo,Cn(Xt),0,O,Le),ho&&Cr(ho,0,Cn(jt),O,Le));let N,G=un>hn;Fr=Ht,rs=null;let J=I.ori==0?O:Le,le=I.ori==1?O:Le;if(Xt<0||on==0||G){N=he.idx=null;for(let pe=0;pe<b.length;pe++){let we=ut[pe];we!=null&&Cr(we,-10,-10,O,Le)}nt&&sr(null,go,!0,_==null&&_n.setSeries),ue.live&&(te.fill(N),me=!0)}else{let pe,we,De;r==1&&(pe=I.ori==0?Xt:jt,we=or(pe,T),N=he.idx=er(we,e[0],un,hn),De=U(e[0][N],I,J,0));let ke=-10,Ue=-10,at=0,Pt=0,Et=!0,_t="",Qe="";for(let Ye=r==2?1:0;Ye<b.length;Ye++){let Yt=b[Ye],ln=te[Ye],Nn=ln==null?null:r==1?e[Ye][ln]:e[Ye][1][ln],Ut=he.dataIdx(i,Ye,N,we),cn=Ut==null?null:r==1?e[Ye][Ut]:e[Ye][1][Ut];if(me=me||cn!=Nn||Ut!=ln,te[Ye]=Ut,Ye>0&&Yt.show){let di=Ut==null?-10:Ut==N?De:U(r==1?e[0][Ut]:e[Ye][0][Ut],I,J,0),Jn=cn==null?-10:F(cn,r==1?v[Yt.scale]:v[Yt.facets[1].scale],le,0);if(nt&&cn!=null){let Mi=I.ori==1?Xt:jt,Oi=Rn(ze.dist(i,Ye,Ut,Jn,Mi));if(Oi<Fr){let ar=ze.bias;if(ar!=0){let fi=or(Mi,Yt.scale),Ti=cn>=0?1:-1,Ui=fi>=0?1:-1;Ui==Ti&&(Ui==1?ar==1?cn>=fi:cn<=fi:ar==1?cn<=fi:cn>=fi)&&(Fr=Oi,rs=Ye)}else Fr=Oi,rs=Ye}}if(me||Ie){let Mi,Oi;I.ori==0?(Mi=di,Oi=Jn):(Mi=Jn,Oi=di);let ar,fi,Ti,Ui,lr,jn,pi=!0,Ps=ce.bbox;if(Ps!=null){pi=!1;let Qn=Ps(i,Ye);Ti=Qn.left,Ui=Qn.top,ar=Qn.width,fi=Qn.height}else Ti=Mi,Ui=Oi,ar=fi=ce.size(i,Ye);if(jn=ce.fill(i,Ye),lr=ce.stroke(i,Ye),Ie)Ye==rs&&Fr<=ze.prox&&(ke=Ti,Ue=Ui,at=ar,Pt=fi,Et=pi,_t=jn,Qe=lr);else{let Qn=ut[Ye];Qn!=null&&(qt[Ye]=Ti,Zn[Ye]=Ui,L_(Qn,ar,fi,pi),P_(Qn,jn,lr),Cr(Qn,Di(Ti),Di(Ui),O,Le))}}}}if(Ie){let Ye=ze.prox,Yt=Cs==null?Fr<=Ye:Fr>Ye||rs!=Cs;if(me||Yt){let ln=ut[0];ln!=null&&(qt[0]=ke,Zn[0]=Ue,L_(ln,at,Pt,Et),P_(ln,_t,Qe),Cr(ln,Di(ke),Di(Ue),O,Le))}}}if($t.show&&ns)if(_!=null){let[pe,we]=_n.scales,[De,ke]=_n.match,[Ue,at]=_.cursor.sync.scales,Pt=_.cursor.drag;if(In=Pt._x,Ln=Pt._y,In||Ln){let{left:Et,top:_t,width:Qe,height:Ye}=_.select,Yt=_.scales[Ue].ori,ln=_.posToVal,Nn,Ut,cn,di,Jn,Mi=pe!=null&&De(pe,Ue),Oi=we!=null&&ke(we,at);Mi&&In?(Yt==0?(Nn=Et,Ut=Qe):(Nn=_t,Ut=Ye),cn=v[pe],di=U(ln(Nn,Ue),cn,J,0),Jn=U(ln(Nn+Ut,Ue),cn,J,0),La(tr(di,Jn),Rn(Jn-di))):La(0,J),Oi&&Ln?(Yt==1?(Nn=Et,Ut=Qe):(Nn=_t,Ut=Ye),cn=v[we],di=F(ln(Nn,at),cn,le,0),Jn=F(ln(Nn+Ut,at),cn,le,0),Fa(tr(di,Jn),Rn(Jn-di))):Fa(0,le)}else cd()}else{let pe=Rn(ym-gm),we=Rn(_m-xm);if(I.ori==1){let at=pe;pe=we,we=at}In=Un.x&&pe>=Un.dist,Ln=Un.y&&we>=Un.dist;let De=Un.uni;De!=null?In&&Ln&&(In=pe>=De,Ln=we>=De,!In&&!Ln&&(we>pe?Ln=!0:In=!0)):Un.x&&Un.y&&(In||Ln)&&(In=Ln=!0);let ke,Ue;In&&(I.ori==0?(ke=fo,Ue=Xt):(ke=po,Ue=jt),La(tr(ke,Ue),Rn(Ue-ke)),Ln||Fa(0,le)),Ln&&(I.ori==1?(ke=fo,Ue=Xt):(ke=po,Ue=jt),Fa(tr(ke,Ue),Rn(Ue-ke)),In||La(0,J)),!In&&!Ln&&(La(0,0),Fa(0,0))}if(Un._x=In,Un._y=Ln,_==null){if(P){if(Lm!=null){let[pe,we]=_n.scales;_n.values[0]=pe!=null?or(I.ori==0?Xt:jt,pe):null,_n.values[1]=we!=null?or(I.ori==1?Xt:jt,we):null}Ba(kp,i,Xt,jt,O,Le,N)}if(nt){let pe=P&&_n.setSeries,we=ze.prox;Cs==null?Fr<=we&&sr(rs,go,!0,pe):Fr>we?sr(null,go,!0,pe):rs!=Cs&&sr(rs,go,!0,pe)}}me&&(ue.idx=N,od()),S!==!1&&Fn("setCursor")}let ss=null;Object.defineProperty(i,"rect",{get(){return ss==null&&Na(!1),ss}});function Na(_=!1){_?ss=null:(ss=m.getBoundingClientRect(),Fn("syncRect",ss))}function wm(_,S,P,N,G,J,le){he._lock||ns&&_!=null&&_.movementX==0&&_.movementY==0||(ad(_,S,P,N,G,J,le,!1,_!=null),_!=null?Rs(null,!0,!0):Rs(S,!0,!1))}function ad(_,S,P,N,G,J,le,pe,we){if(ss==null&&Na(!1),tt(_),_!=null)P=_.clientX-ss.left,N=_.clientY-ss.top;else{if(P<0||N<0){Xt=-10,jt=-10;return}let[De,ke]=_n.scales,Ue=S.cursor.sync,[at,Pt]=Ue.values,[Et,_t]=Ue.scales,[Qe,Ye]=_n.match,Yt=S.axes[0].side%2==1,ln=I.ori==0?O:Le,Nn=I.ori==1?O:Le,Ut=Yt?J:G,cn=Yt?G:J,di=Yt?N:P,Jn=Yt?P:N;if(Et!=null?P=Qe(De,Et)?a(at,v[De],ln,0):-10:P=ln*(di/Ut),_t!=null?N=Ye(ke,_t)?a(Pt,v[ke],Nn,0):-10:N=Nn*(Jn/cn),I.ori==1){let Mi=P;P=N,N=Mi}}we&&(S==null||S.cursor.event.type==kp)&&((P<=1||P>=O-1)&&(P=Qs(P,O)),(N<=1||N>=Le-1)&&(N=Qs(N,Le))),pe?(gm=P,xm=N,[fo,po]=he.move(i,P,N)):(Xt=P,jt=N)}let ld={width:0,height:0,left:0,top:0};function cd(){nc(ld,!1)}let Sm,Am,Mm,Tm;function Em(_,S,P,N,G,J,le){ns=!0,In=Ln=Un._x=Un._y=!1,ad(_,S,P,N,G,J,le,!0,!1),_!=null&&(Tt(Op,Gp,Cm,!1),Ba(S_,i,fo,po,O,Le,null));let{left:pe,top:we,width:De,height:ke}=$t;Sm=pe,Am=we,Mm=De,Tm=ke}function Cm(_,S,P,N,G,J,le){ns=Un._x=Un._y=!1,ad(_,S,P,N,G,J,le,!1,!0);let{left:pe,top:we,width:De,height:ke}=$t,Ue=De>0||ke>0,at=Sm!=pe||Am!=we||Mm!=De||Tm!=ke;if(Ue&&at&&nc($t),Un.setScale&&Ue&&at){let Pt=pe,Et=De,_t=we,Qe=ke;if(I.ori==1&&(Pt=we,Et=ke,_t=pe,Qe=De),In&&is(T,or(Pt,T),or(Pt+Et,T)),Ln)for(let Ye in v){let Yt=v[Ye];Ye!=T&&Yt.from==null&&Yt.min!=Ht&&is(Ye,or(_t+Qe,Ye),or(_t,Ye))}cd()}else he.lock&&(he._lock=!he._lock,Rs(S,!0,_!=null));_!=null&&(An(Op,Gp),Ba(Op,i,Xt,jt,O,Le,null))}function Mv(_,S,P,N,G,J,le){if(he._lock)return;tt(_);let pe=ns;if(ns){let we=!0,De=!0,ke=10,Ue,at;I.ori==0?(Ue=In,at=Ln):(Ue=Ln,at=In),Ue&&at&&(we=Xt<=ke||Xt>=O-ke,De=jt<=ke||jt>=Le-ke),Ue&&we&&(Xt=Xt<fo?0:O),at&&De&&(jt=jt<po?0:Le),Rs(null,!0,!0),ns=!1}Xt=-10,jt=-10,te.fill(null),Rs(null,!0,!0),pe&&(ns=pe)}function Rm(_,S,P,N,G,J,le){he._lock||(tt(_),Ia(),cd(),_!=null&&Ba(T_,i,Xt,jt,O,Le,null))}function Pm(){E.forEach(nP),k(i.width,i.height,!0)}no(Wh,ya,Pm);let xo={};xo.mousedown=Em,xo.mousemove=wm,xo.mouseup=Cm,xo.dblclick=Rm,xo.setSeries=(_,S,P,N)=>{let G=_n.match[2];P=G(i,S,P),P!=-1&&sr(P,N,!0,!1)},ge&&(Tt(S_,m,Em),Tt(kp,m,wm),Tt(A_,m,_=>{tt(_),Na(!1)}),Tt(M_,m,Mv),Tt(T_,m,Rm),Jp.add(i),i.syncRect=Na);let ic=i.hooks=n.hooks||{};function Fn(_,S,P){Kn?Dt.push([_,S,P]):_ in ic&&ic[_].forEach(N=>{N.call(null,i,S,P)})}(n.plugins||[]).forEach(_=>{for(let S in _.hooks)ic[S]=(ic[S]||[]).concat(_.hooks[S])});let Im=(_,S,P)=>P,_n=Sn({key:null,setSeries:!1,filters:{pub:k_,sub:k_},scales:[T,b[1]?b[1].scale:null],match:[O_,O_,Im],values:[null,null]},he.sync);_n.match.length==2&&_n.match.push(Im),he.sync=_n;let Lm=_n.key,ud=Nb(Lm);function Ba(_,S,P,N,G,J,le){_n.filters.pub(_,S,P,N,G,J,le)&&ud.pub(_,S,P,N,G,J,le)}ud.sub(i);function Tv(_,S,P,N,G,J,le){_n.filters.sub(_,S,P,N,G,J,le)&&xo[_](null,S,P,N,G,J,le)}i.pub=Tv;function Ev(){ud.unsub(i),Jp.delete(i),Pn.clear(),Xp(Wh,ya,Pm),c.remove(),Pe?.remove(),Fn("destroy")}i.destroy=Ev;function hd(){Fn("init",n,e),Pa(e||n.data,!1),H[T]?id(T,H[T]):Ia(),re=$t.show&&($t.width>0||$t.height>0),ne=me=!0,k(n.width,n.height)}return b.forEach(oo),E.forEach(Rr),t?t instanceof HTMLElement?(t.appendChild(c),hd()):t(i,hd):hd(),i}Hn.assign=Sn;Hn.fmtNum=rm;Hn.rangeNum=qh;Hn.rangeLog=Yh;Hn.rangeAsinh=nm;Hn.orient=ro;Hn.pxRatio=It;Hn.join=$2;Hn.fmtDate=om,Hn.tzDate=rR;Hn.sync=Nb;{Hn.addGap=zR,Hn.clipGaps=Jh;let n=Hn.paths={points:zb};n.linear=Hb,n.stepped=GR,n.bars=WR,n.spline=XR}var iP={body:["1","2","3"],space:["x","y","z"],quaternion:["w","x","y","z"]};function $b(n,e){return n.columns.flatMap(t=>{let i=e.columns[t.name];if(i===void 0||t.axes==="plane")return[];let r=t.name.startsWith("law_"),s=(r?t.name.slice(4):t.name).replaceAll("_"," "),o=r?`drift of ${s}`:sP(t.mathml)??s,a=rP(t),l=Array.from({length:t.width},(c,u)=>({label:t.width===1?o:`${o}${lP(a[u]??String(u+1))}`,values:r?i.map(h=>h-(i[0]??0)):oP(i,t.width,u)}));return[{...t,text:o,unit:Wn(t.unit),components:l}]})}function rP({name:n,axes:e,width:t}){let i=iP[e];if(i!==void 0)return i;if(e==="pair"){let r=(1+Math.round(Math.sqrt(1+8*t)))/2;return Xb(r).filter(([s,o])=>s<o).map(([s,o])=>`${s}${o}`)}return n==="attitude"?Xb(Math.round(Math.sqrt(t))).map(([r,s])=>`${r}${s}`):[]}function Xb(n){let e=Array.from({length:n},(t,i)=>i+1);return e.flatMap(t=>e.map(i=>[t,i]))}function sP(n){let e=si(n);return e!==""&&e.length<=4?e:null}function oP(n,e,t){return e===1?n:Float64Array.from({length:n.length/e},(i,r)=>n[e*r+t]??NaN)}var aP="₀₁₂₃₄₅₆₇₈₉";function lP(n){return/^[0-9]+$/.test(n)?[...n].map(e=>aP[Number(e)]).join(""):`_${n}`}var Kb=10.5;function Jb(n){let e=new Set(uP(n)),t=X("div",{class:"lab-chips",role:"toolbar","aria-label":"Quantities"}),i=X("div",{class:"lab-plots"}),r=X("div",{},t,i),s=[],o=()=>$b(n.model,n.shown.value.motion),a=()=>o().filter(({name:d})=>e.has(d)),l=()=>{for(let{plot:d}of s)d.destroy();i.replaceChildren(),s=a().map(d=>{let f=X("figure",{class:"lab-plot","aria-label":`${d.meaning||d.name} over time`});i.append(f);let m=Math.max(240,i.clientWidth||600),x=cP(d,f);return{plot:hP(n,d,f,m),readings:x,size:Yb(d)}}),c()},c=()=>{for(let{plot:d,readings:f,size:m}of s){fm(d,n);let{times:x}=n.shown.value.motion,{index:g,share:p}=rc(x,n.clock.time.value);f.forEach((b,E)=>{let v=d.data[E+1],C=(1-p)*(v?.[g]??NaN)+(p>0?p*(v?.[g+1]??NaN):0);b.textContent=bt(Math.abs(C)<1e-12*m?0:C,4)})}},u=()=>{let d=a();if(d.length!==s.length)return l();s=s.map((f,m)=>{let x=d[m];return x===void 0?f:(f.plot.setData(Qb(n,x)),{...f,size:Yb(x)})}),c()};for(let d of o()){let f=d.mathml&&d.text.length<=4?zi(d.mathml):d.text;t.append(Is(f,d.meaning||d.name,e.has(d.name),m=>{m?e.add(d.name):e.delete(d.name),l()}))}n.shown.after(u),n.clock.time.after(c),bo(l);let h=0;return new ResizeObserver(()=>{if(i.clientWidth===h||i.clientWidth===0)return;let d=h===0;if(h=i.clientWidth,d)l();else for(let{plot:f}of s)f.setSize({width:h,height:Math.round(Kb*_r())})}).observe(i),{element:r,chosen:a}}function Yb(n){return n.components.reduce((e,{values:t})=>t.reduce((i,r)=>Math.max(i,Math.abs(r)||0),e),0)}function cP(n,e){let t=nn(),i=X("figcaption",{class:"lab-curves"});return e.append(i),n.components.map(({label:r},s)=>{let o=X("span",{class:"lab-number"}),a=`border-top: 2.5px ${Zb[s%Zb.length]??"solid"} ${jb(t,s,n.components.length)}`,[l="",c=""]=r.split("_");return i.append(X("span",{},X("i",{style:a}),l,c===""?null:X("sub",{},c)," = ",o)),o})}var Zb=["solid","dashed","dotted","solid"];function jb(n,e,t){let i=t>n.components.length?n.series:n.components;return i[e%i.length]??n.ink}function uP(n){let e=n.model.columns.map(({name:i})=>i),t=["omega","gamma"].filter(i=>e.includes(i));return t.length>0?t:e.filter(i=>!i.startsWith("lambda")).slice(0,2)}function Qb(n,e){return[n.shown.value.motion.times,...e.components.map(({values:t})=>t)]}function hP(n,e,t,i){let r=nn(),s={stroke:r.quiet,font:Wd(.8*_r()),ticks:{stroke:r.line,width:1,size:4},grid:{stroke:r.line,width:.5}},o=[[],[7,3],[2,3],[8,3,2,3]],a=`${e.text}${e.unit?`  (${e.unit})`:""}`,l=new Hn({width:i,height:Math.round(Kb*_r()),legend:{show:!1},scales:{x:{time:!1}},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:6},focus:{prox:24}},axes:[{...s,size:1.9*_r(),values:(h,d)=>d.map(f=>bt(f,6))},{...s,size:3.9*_r(),label:a,labelSize:1.4*_r(),labelFont:`italic ${Wd(.88*_r())}`,values:(h,d)=>d.map(f=>bt(f,6))}],series:[{},...e.components.map(({label:h},d)=>({label:h,stroke:jb(r,d,e.components.length),width:1.5,dash:o[d%o.length]??[],points:{show:!1}}))],hooks:{draw:[h=>fm(h,n)]}},Qb(n,e),t),c=h=>{let{left:d}=l.over.getBoundingClientRect();n.clock.pause(),n.clock.seek(l.posToVal(h.clientX-d,"x"))};l.over.addEventListener("pointerdown",h=>{l.over.setPointerCapture(h.pointerId),c(h)}),l.over.addEventListener("pointermove",h=>{l.over.hasPointerCapture(h.pointerId)&&c(h)}),l.over.style.touchAction="pan-y";let u=X("div",{class:"lab-plot-now"});return l.over.append(u),fm(l,n),l}function fm(n,e){let t=n.over.querySelector(".lab-plot-now");t!==null&&(t.style.transform=`translateX(${n.valToPos(e.clock.time.value,"x").toFixed(2)}px)`)}var dP={play:"M7 4.5v15l12-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",first:"M6 5h2.4v14H6zM19 5v14L9.5 12z",undo:"M9 6V2.5L3 8l6 5.500V10h5a4 4 0 0 1 0 8H8v2.500h6a6.500 6.500 0 0 0 0-14.500z",redo:"M15 6V2.500L21 8l-6 5.500V10h-5a4 4 0 0 0 0 8h6v2.500h-6a6.500 6.500 0 0 1 0-14.500z",whole:"M4 4h6v2.200H6.200V10H4zM14 4h6v6h-2.200V6.200H14zM4 14h2.200v3.800H10V20H4zM17.800 14H20v6h-6v-2.200h3.800z",link:"M10.600 13.400a1 1 0 0 0 1.400 0l4.200-4.200a1.800 1.800 0 0 0-2.600-2.600l-1.700 1.700-1.500-1.500 1.700-1.700a4 4 0 0 1 5.600 5.600l-4.200 4.200a3.100 3.100 0 0 1-4.400 0zM13.400 10.600a1 1 0 0 0-1.400 0l-4.200 4.200a1.800 1.800 0 0 0 2.600 2.600l1.700-1.700 1.500 1.500-1.700 1.700a4 4 0 0 1-5.600-5.600l4.200-4.200a3.100 3.100 0 0 1 4.400 0z",help:"M11 16.500h2.200V19H11zM12.100 5C9.700 5 8 6.500 7.900 8.900h2.300c.1-1.100.8-1.800 1.900-1.800s1.800.7 1.800 1.600c0 .8-.4 1.200-1.300 1.900-1.200.9-1.700 1.700-1.600 3.300v.6h2.200v-.4c0-.9.3-1.300 1.400-2.100 1-.8 1.700-1.700 1.700-3.300C16.300 6.500 14.600 5 12.100 5z"},ev="http://www.w3.org/2000/svg";function tv(n){let e=document.createElementNS(ev,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","lab-icon");let t=document.createElementNS(ev,"path");return t.setAttribute("d",dP[n]),e.append(t),e}function Ta(n,e,t){let i=document.createElement("button");return i.type="button",i.className="lab-icon-button",i.title=e,i.setAttribute("aria-label",e),i.append(tv(n)),i.addEventListener("click",t),i}function nv(n,e,t){n.title=t,n.setAttribute("aria-label",t),n.replaceChildren(tv(e))}function iv(n,e){let{clock:t}=n,i=Ta("play","Play (space)",()=>t.toggle());i.classList.add("lab-play");let r=Ta("first","To the start (Home)",()=>t.seek(0)),s=X("input",{type:"range",min:0,step:"any","aria-label":"Time",class:"lab-scrub"}),o=X("output",{class:"lab-time","aria-live":"off"}),a=X("select",{"aria-label":"Speed",title:"Speed ([ and ])"}),l=Ta("undo","Undo (Ctrl+Z)",()=>{n.undo()}),c=Ta("redo","Redo (Ctrl+Shift+Z)",()=>{n.redo()}),u=Ta("whole","Full screen",e);s.addEventListener("input",()=>{t.pause(),t.seek(Number(s.value))}),a.addEventListener("change",()=>t.speed.value=Number(a.value)),t.speed.watch(m=>{let x=[...new Set([...zo,m])].sort((g,p)=>g-p);a.replaceChildren(...x.map(g=>{let p=X("option",{value:g},`${bt(g,2)}×`);return p.selected=g===m,p}))}),t.playing.watch(m=>nv(i,m?"pause":"play",m?"Pause (space)":"Play (space)"));let h="s",d=()=>{let m=t.time.value,x=t.until<1?4:t.until<100?2:1;s.max=String(t.until),s.value=String(m),s.style.setProperty("--share",String(t.until>0?m/t.until:0));let g=`${m.toFixed(x)} ${h}`;o.textContent=`t = ${g}`,s.setAttribute("aria-valuetext",`${g} of ${t.until.toFixed(x)} ${h}`)};t.time.watch(d),n.shown.after(d),n.wanted.watch(()=>{l.disabled=!n.history.canUndo,c.disabled=!n.history.canRedo});let f=n.engine===null?null:X("span",{class:"lab-group"},l,c);return X("div",{class:"lab-transport",role:"toolbar","aria-label":"Playback"},r,i,s,o,X("label",{class:"lab-speed"},a),f,u)}var fP=[{value:"1",text:"rising"},{value:"-1",text:"falling"},{value:"0",text:"both"}],pP=[200,1e3,5e3,2e4].map(n=>({value:String(n),text:String(n)}));function rv(n,e,t,i){let{model:r}=n,s=r.quantities.map(x=>({value:x.name,text:Tc(x)})),o=r.wasm_tables?.section_quantities??r.quantities.map(({name:x})=>x),a=X("input",{type:"text",inputmode:"decimal",class:"lab-field","aria-label":"Value on the section"});a.value=String(e.value),a.addEventListener("change",()=>{let x=Number(a.value.replace("−","-"));a.value.trim()!==""&&Number.isFinite(x)?i.change({value:x}):n.say("The value on the section must be a number.",!0)});let l=(x,g,p)=>{let b=X("button",{type:"button",title:g},x);return b.addEventListener("click",p),b},c=Ei("on",s.filter(x=>o.includes(x.value)),e.on,x=>i.change({on:x})),u=Ei("direction",fP,String(e.direction),x=>i.change({direction:Number(x)})),h=Ei("across",s,e.x,x=>i.change({x})),d=Ei("up",s,e.y,x=>i.change({y:x}));return{element:X("div",{class:"lab-tools",role:"toolbar","aria-label":"Section"},c,X("label",{class:"lab-choice"},"=",a),u,h,d,Ei("points",pP,String(t),x=>i.points(Number(x))),Is("indicator","Colour orbits by MEGNO, an indicator of chaos",!1,i.indicator),Is("box","Drag a box to enlarge it (or Shift and drag)",!1,i.box),l("+","Nearer (+)",()=>i.zoom(1/1.5)),l("−","Farther (−)",()=>i.zoom(1.5)),l("all","Show all points (0)",i.all),l("clear","Remove all orbits but that of the scene",i.clear)),write:x=>{a.value=String(x.value);for(let[g,p]of[[c,x.on],[h,x.x],[d,x.y],[u,String(x.direction)]]){let b=g.querySelector("select");b!==null&&(b.value=p)}}}}function sv({on:n,value:e,direction:t,x:i,y:r}){return[n,e,t,i,r].join(" ")}function ov(n,e){let[t="",i="",r="",s="",o=""]=n.split(/[ +]/),a=Number(i);return!([t,s,o].every(c=>Gi(e,c)>=0)&&(e.wasm_tables?.section_quantities.includes(t)??!0))||i===""||!Number.isFinite(a)||!["-1","0","1"].includes(r)?null:{on:t,value:a,direction:Number(r),x:s,y:o}}var mP=12;function av(n){let{engine:e,model:t}=n;return e===null||t.section===null?null:new pm(n,new Lc(t),{...t.section})}var pm=class{constructor(e,t,i){this.lab=e;this.engines=t;this.chosen=i;this.sheet=new hs({label:"Poincaré section. Arrow keys move a cross, Enter starts an orbit there, plus and minus zoom, 0 shows all.",paint:(r,s,o)=>this.paint(r,s,o),click:r=>{this.start([r])},drag:(r,s)=>{this.start(T0(r,s,mP))},hover:(r,s)=>this.hover(r,s),marks:(r,s)=>this.marks(r,s),whole:()=>this.whole(),keys:{Backspace:()=>this.remove(this.list.at(-1)),Delete:()=>this.remove(this.list.at(-1))}}),this.tools=rv(e,i,this.points,{change:r=>this.choose({...this.chosen,...r}),points:r=>this.points=r,indicator:r=>this.colourBy(r),box:r=>this.sheet.boxing=r,zoom:r=>this.sheet.zoom(r),all:()=>this.sheet.showAll(),clear:()=>this.clear()}),this.element=X("div",{},this.tools.element,this.sheet.element,this.key,this.entries),e.shown.after(()=>this.follow()),this.axes({x:[-1,1],y:[-1,1]})}lab;engines;chosen;element;sheet;list=[];points=1e3;byIndicator=!1;serial=0;era=0;longest=1/0;placed=!1;opening=Promise.resolve();own=!1;current="";hovered=null;visible=!1;tools;entries=X("div",{class:"lab-orbits",role:"group","aria-label":"Orbits"});key=X("div",{class:"lab-key",hidden:!0});shown(){this.visible=!0,this.follow()}async prepared(){this.shown(),await this.opening}orbits(){return this.list}setting(){return this.chosen}choice(){return this.own?sv(this.chosen):""}restore(e){let t=ov(e,this.lab.model);t!==null&&(this.placed=!0,this.tools.write(t),this.choose(t))}choose(e){this.own=!0,this.chosen=e,this.clear()}quantity(e){return this.lab.model.quantities.find(t=>t.name===e)}axes({x:e,y:t}){let i=r=>{let s=this.quantity(r);if(s===void 0)return r;let o=Wn(s.unit);return`${Tc(s)}${o?`  (${o})`:""}`};this.sheet.setAxes({range:e,label:i(this.chosen.x)},{range:t,label:i(this.chosen.y)})}clear(){this.list=[],this.serial=0,this.next(),this.current="",this.follow(),this.entries.replaceChildren(),this.sheet.repaint()}follow(){let{state:e,experiment:t}=this.lab.shown.value;if(!this.visible||e===null)return;let i=JSON.stringify([t.parameters,Array.from(e)]);if(i===this.current)return;let r=this.list.some(s=>Ec(s.start,e))&&this.current.startsWith(`[${JSON.stringify(t.parameters)}`);if(this.current=i,r)return this.mark();this.list=[],this.serial=0,this.next(),this.opening=this.open(e)}async open(e){let{era:t}=this,{motion:i,experiment:r}=this.lab.shown.value,{model:s}=this.lab,{states:o}=i;if(o===void 0)return void this.trace(e,!0);let a=await this.engines.engine.quantities(r.parameters,o,o.length/i.times.length);if(t!==this.era)return;let l=s.quantities.length,c=x=>{let g=Gi(s,x);return Float64Array.from(i.times,(p,b)=>a[b*l+g]??NaN)},u=(x,g)=>_0(c(x),g,this.chosen.direction,s.quantities[Gi(s,x)]?.angle===!0),h=!this.placed;this.placed=!0,h&&(this.chosen=E0(s,this.chosen,c,u),this.axes({x:[-1,1],y:[-1,1]}),this.tools.write(this.chosen));let d=i.times.at(-1)??1,f=u(this.chosen.on,this.chosen.value);this.longest=f===0?20*d:5*d*Math.max(this.points,1e3)/f;let m=await this.trace(e,!0);m!==null&&h&&this.spread(m)&&await this.opening}spread(e){let t=M0(this.lab.model,this.chosen,e);return t===this.chosen?!1:(this.chosen=t,this.tools.write(t),this.clear(),!0)}next(){this.era+=1,this.engines.renew()}mark(){this.writeEntries(),this.sheet.mark()}async start(e){let{state:t,experiment:i}=this.lab.shown.value;if(t===null)return;let{era:r}=this,{on:s,value:o,direction:a,x:l,y:c}=this.chosen,u="";for(let h of e){let[[d,f],[m,x]]=[this.sheet.frame.x.range,this.sheet.frame.y.range],g=Mc(this.list,this.lab.model.reduced,h,f-d,x-m),p=await this.engines.engine.startOnLevel({parameters:i.parameters,reference:g??t,section:{on:s,value:o,direction:a,x:l,y:c},x:h.x,y:h.y}).catch(()=>null);if(r!==this.era||p===null)return;if("message"in p){u=p.message;continue}if(await this.trace(p.state,!1,h),r!==this.era)return;h===e.at(-1)&&this.play(p.state)}u!==""&&this.lab.say(ja(u),!0)}play(e){let{lab:t}=this,{parameters:i}=t.shown.value.experiment;this.current=JSON.stringify([i,Array.from(e)]),t.change({...t.wanted.value,start:{state:Array.from(e)}}),t.clock.seek(0),this.mark()}async trace(e,t,i=null){let{era:r}=this,{parameters:s}=this.lab.shown.value.experiment,o={start:e,x:new Float64Array(0),y:new Float64Array(0),rows:new Float64Array(0),number:this.serial,until:0,indicator:null};i!==null&&(o=Hd(o,{x:Float64Array.of(i.x),y:Float64Array.of(i.y),rows:o.rows,time:0})),this.serial+=1,this.list.push(o),this.writeEntries();try{for await(let a of y0(this.engines.engine,this.lab.model,s,this.chosen,e,this.points,this.longest)){if(r!==this.era)return null;let l=this.list.indexOf(o);if(l<0)return null;let c=o.x.length;o=Hd(o,a),this.list[l]=o,t&&c===0?this.axes(this.whole()):this.add(o,c),a.end!==null&&a.x.length===0&&this.lab.say(`The motion has no point of this section: ${a.end}.`,!0)}}catch(a){return r!==this.era||this.lab.say(ja(a instanceof Error?a.message:String(a)),!0),null}return this.writeEntries(),this.byIndicator&&this.judge(o),o}colourBy(e){this.byIndicator=e,this.key.hidden=!e;let t=X("i",{style:`background:linear-gradient(90deg,${Fs().join(",")})`});if(this.key.replaceChildren(X("span",{},"MEGNO 2, regular"),t,X("span",{},"32 and more, chaotic")),this.sheet.repaint(),this.writeEntries(),e)for(let i of this.list)this.judge(i)}async judge(e){if(e.indicator!==null||!(e.until>0))return;let{era:t}=this,{parameters:i}=this.lab.shown.value.experiment,r=Math.min(e.until,20*this.lab.model.until),s=await this.engines.engine.indicator({parameters:i,start:e.start,until:r,kind:"megno"}).catch(()=>null);if(s===null)return;let o=this.list.findIndex(l=>l.number===e.number),a=this.list[o];t!==this.era||a===void 0||(this.list[o]={...a,indicator:s},this.sheet.repaint(),this.writeEntries())}remove(e){this.list=this.list.filter(t=>t!==e),this.sheet.repaint(),this.writeEntries()}colour(e){if(this.byIndicator&&e.indicator!==null)return`rgb(${N0(e.indicator).join()})`;if(this.byIndicator)return nn().quiet;let{series:t}=nn();return t[e.number%t.length]??nn().ink}paint(e,t,i){for(let r of this.list)Gd(e,t,r,0,this.colour(r),i)}add(e,t){let{pen:i,frame:r}=this.sheet;i!==null&&Gd(i,r,e,t,this.colour(e),Math.min(window.devicePixelRatio||1,2))}whole(){let e=t=>this.quantity(this.chosen[t])?.angle===!0?[-Math.PI,Math.PI]:Dr(this.list.flatMap(i=>Array.from(i[t])),.12);return{x:e("x"),y:e("y")}}hover(e,t){let i={right:t.right(e.x),down:t.down(e.y)},r=v0(this.list,l=>t.right(l),l=>t.down(l),i,9);if(this.hovered=r?.orbit??null,r===null)return null;let{model:s}=this.lab,o=s.state.slice(0,s.reduced).map(({name:l,mathml:c},u)=>`${si(c||l)} = ${bt(r.orbit.start[u]??NaN)}`),{indicator:a}=r.orbit;return`starts at ${o.join(", ")}${a===null?"":`; ${Qa(a)}`}`}marks(e,t){let{state:i}=this.lab.shown.value,r=this.list.filter(s=>i!==null&&Ec(s.start,i));A0(e,t,r,this.hovered,nn().ink)}writeEntries(){let{state:e}=this.lab.shown.value,t=this.list.slice(-40).map(i=>{let r=`Play orbit ${i.number+1}: ${i.x.length} points${i.indicator===null?"":`, ${Qa(i.indicator)}`}`,s=e!==null&&Ec(i.start,e),o=X("button",{type:"button","aria-label":r,title:r,"aria-current":s?"true":null},X("i",{style:`background:${this.colour(i)}`}),String(i.number+1));return o.addEventListener("click",()=>this.play(i.start)),o});this.entries.replaceChildren(...t)}};var Ea=[[68,1,84],[59,82,139],[33,145,140],[94,201,98],[253,231,37]];function lv(){let n=null,e=new Float64Array(0),t=X("canvas",{class:"lab-tile-chart",role:"img"}),i=X("p",{class:"lab-hint"});return r=>{if(r.chart!==void 0)return n=r.chart,t.width=n.x.count,t.height=n.y.count,e=new Float64Array(n.x.count*n.y.count).fill(NaN),t.setAttribute("aria-label",`${n.title} over ${n.x.name} and ${n.y.name}`),X("figure",{},t,i);if(r.tile!==void 0&&n!==null){let{row:s,width:o,values:a}=r.tile;a.forEach((h,d)=>e[s*o+d]=h??NaN);let[l,c]=gP(t,e,n.x.count),u=n.unit==="1"?"":` ${n.unit}`;i.textContent=`${n.title} from ${l.toPrecision(4)} (dark) to ${c.toPrecision(4)}${u} (light); ${n.x.name} from ${n.x.low} to ${n.x.high} across, ${n.y.name} from ${n.y.low} to ${n.y.high} up; kept in ${n.store}`}return null}}function gP(n,e,t){let i=e.filter(Number.isFinite).sort(),r=i[Math.floor(.005*i.length)]??0,s=i[Math.ceil(.995*i.length)-1]??1,o=e.length/t,a=n.getContext("2d");if(a===null)return[r,s];let l=a.createImageData(t,o);return e.forEach((c,u)=>{if(!Number.isFinite(c))return;let h=4*((o-1-Math.floor(u/t))*t+u%t);l.data.set([...xP((c-r)/(s-r||1)),255],h)}),a.putImageData(l,0,0),[r,s]}function xP(n){let e=Math.min(1,Math.max(0,n))*(Ea.length-1),t=Math.min(Ea.length-2,Math.floor(e)),[i,r]=[Ea[t]??Ea[0],Ea[t+1]??Ea[4]];return i.map((s,o)=>Math.round(s+(e-t)*((r[o]??s)-s)))}function cv(n,e){let{model:t}=e,i=X("p",{class:"lab-hint",role:"status","aria-live":"polite"}),r=X("div",{class:"lab-answers"}),s=X("button",{type:"button",class:"lab-button"},"Stop");s.hidden=!0;let o=null;s.addEventListener("click",()=>o?.abort());let a=async(M,B)=>{o?.abort();let L=new AbortController;o=L,r.replaceChildren(),s.hidden=!1,i.classList.remove("lab-refused"),i.textContent="asking …";let I="",D=U=>{typeof U.error=="string"&&(I=U.error),typeof U.doing=="string"&&(i.textContent=`${U.doing} …`),typeof U.progress=="number"&&(i.textContent=`${Math.round(100*U.progress)} % …`);let F=B(U);F!==null&&r.append(F)};try{await n({...M,subject:{what:t.name,experiment:Do(e)}},D,L.signal)}catch(U){I=L.signal.aborted?"Stopped.":U instanceof Error?U.message:String(U)}o===L&&(s.hidden=!0,i.textContent=I,i.classList.toggle("lab-refused",I!==""))},l=[],c=(M,B,...L)=>{let I=X("button",{type:"button",class:"lab-button"},M);I.addEventListener("click",()=>{let{request:D,show:U}=B();a(D,U)}),l.push(X("div",{class:"lab-tools"},I,...L))};c("Prove the laws",()=>({request:{do:"prove"},show:_P}));let u=yP("for",["integrals","measure","symmetries"]),h=so("degree","2");c("Search",()=>({request:{do:"find",kind:u.value(),degree:Number(h.value())},show:bP}),u.label,h.label),c("Closed form",()=>({request:{do:"solve"},show:vP}));let d=so("on the section",`${t.section?.on??t.quantities[0]?.name??""}`),f=so("after returns","1");c("Periodic orbit",()=>({request:{do:"orbit",on:d.value(),after:Number(f.value())},show:wP}),d.label,f.label);let m=so("of","megno"),[x,g]=t.parameters,p=(M,B)=>`${M}=${B-.2*(Math.abs(B)||1)}:${B+.2*(Math.abs(B)||1)}:100`,b=so("across",x?p(x.name,x.value):""),E=so("up",g?p(g.name,g.value):"");c("Long chart",()=>({request:{do:"chart",of:m.value(),x:b.value(),y:E.value()},show:lv()}),m.label,b.label,E.label),c("Data (NetCDF)",()=>({request:{do:"data",format:"nc"},show:SP}));let v=so("as",`${t.name}-changed.toml`),C=X("button",{type:"button",class:"lab-button"},"Save the experiment");C.addEventListener("click",()=>{y(v.value(),!1)}),l.push(X("div",{class:"lab-tools"},C,v.label));let T="";async function y(M,B){let L=B||T===M,I=`${M} is saved in the folder of the lab.`;await n({do:"save",file:M,experiment:Do(e),replace:L},D=>{typeof D.error=="string"&&(I=D.error)}).catch(D=>I=D instanceof Error?D.message:String(D)),T=I.includes("exists already")?M:"",i.textContent=T===""?I:`${M} exists already: press again to replace it.`,i.classList.toggle("lab-refused",!I.endsWith("of the lab."))}return X("div",{class:"lab-python"},...l,X("div",{class:"lab-tools"},i,s),r)}function so(n,e){let t=X("input",{type:"text",class:"lab-field lab-free",size:Math.max(3,e.length),value:e,"aria-label":n});return{label:X("label",{class:"lab-choice"},X("span",{},n),t),value:()=>t.value.trim()}}function yP(n,e){let t=e[0]??"";return{label:Ei(n,e.map(r=>({value:r,text:r})),t,r=>t=r),value:()=>t}}var td=(n,e,...t)=>X("p",{},X("strong",{},n)," ",e,...t);function _P({verdict:n}){let e=n;return e===void 0?null:td(e.name,e.reason===""?e.stated:`${e.stated}: ${e.reason}`)}function bP({found:n}){let e=n;if(e===void 0)return null;let t=e.repeats?`; repeats ${e.repeats}`:"";return X("div",{},X("div",{class:"lab-wide-formula"},e.mathml===""?e.text:zi(e.mathml)),X("p",{class:"lab-hint"},e.stated+t))}function vP({closed_form:n}){let e=n;if(e===void 0)return null;let t=e.constants.map(({symbol:i,value:r,error:s,unit:o,meaning:a})=>X("tr",{},X("th",{scope:"row"},i),X("td",{class:"lab-number"},[r,s==="0"?"":`± ${s}`,o].filter(l=>l!=="").join(" ")),X("td",{},a)));return X("div",{},td(e.title,[e.source,e.motion].filter(i=>i!=="").join(", ")),...e.equations.map(i=>X("div",{class:"lab-wide-formula"},zi(i))),X("table",{class:"lab-table"},...t))}function wP({orbit:n}){let e=n;if(e===void 0)return null;let t=[["period",`${e.period.toPrecision(12)} s`],...Object.entries({...e.values,...e.points[0]}).map(([i,r])=>[i,r.toPrecision(12)]),["multipliers",e.multipliers.map(({real:i,imaginary:r})=>`${i.toPrecision(6)}${r===0?"":` ${r>0?"+":"−"} ${Math.abs(r).toPrecision(6)} i`}`).join(",  ")]];return X("div",{},td(e.kind,"(observed)"),X("table",{class:"lab-table"},...t.map(([i,r])=>X("tr",{},X("th",{scope:"row"},i),X("td",{class:"lab-number"},r)))))}function SP({file:n}){let e=n;return e===void 0?null:(Ls(e.name,new Blob([Uint8Array.from(atob(e.base64),t=>t.charCodeAt(0))])),td(e.name,"is among the downloads."))}function uv(n){return n.kind==="http"?(e,t,i)=>AP(`${n.base}ask`,e,t,i):n.kind==="widget"?n.ask:null}async function AP(n,e,t,i){let r=await fetch(n,{method:"POST",headers:{"Content-Type":"application/json"},body:JSON.stringify(e),...i===void 0?{}:{signal:i}}).catch(a=>{throw i?.aborted===!0?a:new Error("The lab does not answer; is it still running?")});if(r.body===null)return;let s=r.body.pipeThrough(new TextDecoderStream).getReader(),o="";for(;;){let{done:a,value:l}=await s.read();if(a)break;o+=l;let c=o.split(`
`);o=c.pop()??"";for(let u of c){let h=JSON.parse(u);h.done!==!0&&t(h)}}}function hv({model:n}){return n.wasm===null?null:el(n).engine}var dv='.uplot,.uplot *,.uplot *:before,.uplot *:after{box-sizing:border-box}.uplot{font-family:system-ui,-apple-system,Segoe UI,Roboto,Helvetica Neue,Arial,Noto Sans,sans-serif,"Apple Color Emoji","Segoe UI Emoji",Segoe UI Symbol,"Noto Color Emoji";line-height:1.5;width:min-content}.u-title{text-align:center;font-size:18px;font-weight:700}.u-wrap{position:relative;user-select:none}.u-over,.u-under{position:absolute}.u-under{overflow:hidden}.uplot canvas{display:block;position:relative;width:100%;height:100%}.u-axis{position:absolute}.u-legend{font-size:14px;margin:auto;text-align:center}.u-inline{display:block}.u-inline *{display:inline-block}.u-inline tr{margin-right:16px}.u-legend th{font-weight:600}.u-legend th>*{vertical-align:middle;display:inline-block}.u-legend .u-marker{width:1em;height:1em;margin-right:4px;background-clip:padding-box!important}.u-inline.u-live th:after{content:":";vertical-align:middle}.u-inline:not(.u-live) .u-value{display:none}.u-series>*{padding:4px}.u-series th{cursor:pointer}.u-legend .u-off>*{opacity:.3}.u-select{background:#00000012;position:absolute;pointer-events:none}.u-cursor-x,.u-cursor-y{position:absolute;left:0;top:0;pointer-events:none;will-change:transform}.u-hz .u-cursor-x,.u-vt .u-cursor-y{height:100%;border-right:1px dashed #607D8B}.u-hz .u-cursor-y,.u-vt .u-cursor-x{width:100%;border-bottom:1px dashed #607D8B}.u-cursor-pt{position:absolute;top:0;left:0;border-radius:50%;border:0 solid;pointer-events:none;will-change:transform;background-clip:padding-box!important}.u-axis.u-off,.u-select.u-off,.u-cursor-x.u-off,.u-cursor-y.u-off,.u-cursor-pt.u-off{display:none}.chaplygin-lab{--ink: #1f2730;--quiet: #66727d;--line: #d9dfe4;--faint: #eef1f4;--alarm: #b3475a;--paper: #ffffff;--box: #f6f8f9;--accent: #2f6690;--on-accent: #ffffff;--proven: #237055;--undecided: #8a6114;--thumb: #ffffff;color:var(--ink);font-family:STIX Two Text,"Libertinus Serif",Palatino Linotype,Palatino,Georgia,serif;line-height:1.4;container:lab / inline-size;position:relative}@media screen and (prefers-color-scheme:dark){.chaplygin-lab{--ink: #dde3e8;--quiet: #97a4af;--line: #36414b;--faint: #20282f;--alarm: #e58a99;--paper: #151a1f;--box: #1c2329;--accent: #79aede;--on-accent: #10161b;--proven: #63c39f;--undecided: #dba94a;--thumb: #dde3e8}}.chaplygin-lab *,.chaplygin-lab *:before{box-sizing:border-box}.chaplygin-lab.lab-live>.chaplygin-still{display:none}.lab-root{display:grid;gap:.9rem;grid-template-columns:minmax(0,1fr);background:var(--paper);text-align:left}.lab-root:fullscreen{padding:.8rem;overflow:auto}.lab-root [hidden]{display:none!important}.lab-view{min-width:0}.lab-scene{position:relative;height:clamp(15rem,58cqi,min(64vh,46rem));border-radius:6px;touch-action:none;cursor:grab;user-select:none;-webkit-user-select:none;overflow:hidden}.lab-scene:active{cursor:grabbing}.lab-canvas{display:block;width:100%;height:100%}.lab-legend,.lab-note,.lab-timebar{position:absolute;font-size:.86rem;color:var(--quiet);pointer-events:none}.lab-legend{top:.3rem;left:.5rem;color:var(--ink);display:grid;gap:.1rem}.lab-legend div{display:flex;gap:.45rem;align-items:center}.lab-arrow,.lab-timebar i{print-color-adjust:exact;-webkit-print-color-adjust:exact}.lab-arrow{width:1.3rem;height:3px;border-radius:2px}.lab-note{right:.6rem;bottom:.3rem}.lab-timebar{left:.5rem;bottom:.3rem;display:flex;gap:.45rem;align-items:center}.lab-timebar i{width:clamp(4rem,16cqi,11rem);height:.5rem;border-radius:1px}.lab-number{font-variant-numeric:tabular-nums;white-space:nowrap}.lab-root button,.lab-root select,.lab-root input[type=text]{font:inherit;font-size:.9rem;color:var(--ink);background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.24rem .55rem;min-height:2rem}.lab-root button{cursor:pointer}.lab-root button:hover:not(:disabled){background:var(--box);border-color:var(--quiet)}.lab-root button:disabled{color:var(--quiet);opacity:.55;cursor:default}.lab-root button[aria-pressed=true],.lab-root button[aria-pressed=true]:hover{background:var(--accent);color:var(--on-accent);border-color:var(--accent)}.lab-root :focus-visible{outline:2.5px solid var(--accent);outline-offset:2px}.lab-scene:focus-visible{outline-offset:-2px}.lab-icon{width:1.15rem;height:1.15rem;fill:currentColor;display:block}.lab-root .lab-icon-button{padding:.35rem;display:inline-grid;place-items:center;min-width:2.1rem}.lab-root .lab-play{background:var(--accent);color:var(--on-accent);border-color:var(--accent);min-width:2.8rem}.lab-root .lab-play:hover:not(:disabled){background:var(--accent);filter:brightness(1.1)}.lab-transport{display:flex;align-items:center;gap:.5rem;padding:.45rem 0}.lab-group{display:inline-flex;gap:.3rem}.lab-time{font-variant-numeric:tabular-nums;white-space:nowrap;min-width:5.6em;font-size:.95rem}.lab-switches,.lab-chips,.lab-tools{display:flex;flex-wrap:wrap;gap:.35rem}.lab-switches button,.lab-chips button{border-radius:1rem;padding:.12rem .7rem}.lab-message{min-height:1.4em;margin:.35rem 0 0;color:var(--quiet);font-size:.92rem}.lab-message:empty{visibility:hidden}.lab-refused{color:var(--alarm)}.lab-hint{color:var(--quiet);font-size:.88rem;margin:.3rem 0}.lab-root input[type=range]{appearance:none;-webkit-appearance:none;background:none;flex:1;min-width:3rem;height:2rem;margin:0;cursor:pointer;accent-color:var(--accent)}.lab-root input[type=range]::-webkit-slider-runnable-track{height:4px;border-radius:2px;background:linear-gradient(90deg,var(--accent) calc(100% * var(--share, 0)),var(--line) 0)}.lab-root input[type=range]::-moz-range-track{height:4px;border-radius:2px;background:var(--line)}.lab-root input[type=range]::-moz-range-progress{height:4px;border-radius:2px;background:var(--accent)}.lab-root input[type=range]::-webkit-slider-thumb{-webkit-appearance:none;width:1.05rem;height:1.05rem;border-radius:50%;margin-top:calc(2px - .525rem);background:var(--thumb);border:2px solid var(--accent)}.lab-root input[type=range]::-moz-range-thumb{width:.85rem;height:.85rem;border-radius:50%;background:var(--thumb);border:2px solid var(--accent)}.lab-sliders{columns:19rem 3;column-gap:2rem}.lab-sliders summary{color:var(--quiet);font-size:.9rem;cursor:pointer;width:fit-content;break-after:avoid}.lab-sliders>*+*{margin-top:.5rem}.lab-slider{display:flex;gap:.5rem;align-items:center;break-inside:avoid}.lab-symbol{white-space:nowrap;flex:0 0 3.2rem}.lab-value{display:inline-flex;align-items:baseline;gap:.3rem;min-width:9.3rem}.lab-root .lab-field{width:5.6rem;padding:.1rem .35rem;min-height:1.7rem;font-variant-numeric:tabular-nums;text-align:right}.lab-root .lab-field[aria-invalid=true]{border-color:var(--alarm)}.lab-unit{color:var(--quiet);font-size:.84rem;white-space:nowrap}.lab-deck{min-width:0}.lab-tabs{display:flex;gap:.2rem;border-bottom:1px solid var(--line);margin-bottom:.6rem;overflow-x:auto;scrollbar-width:none}.lab-root .lab-tabs button{border:0;border-bottom:3px solid transparent;border-radius:0;background:none;color:var(--quiet);padding:.3rem .6rem;white-space:nowrap;font-size:.98rem}.lab-root .lab-tabs button[aria-selected=true]{color:var(--ink);border-bottom-color:var(--accent)}.lab-root .lab-tabs :focus-visible{outline-offset:-3px}.lab-laws{list-style:none;margin:0;padding:0;columns:24rem 3;column-gap:2rem}.lab-laws li{break-inside:avoid;padding-bottom:.7rem}.lab-laws p{margin:0}.lab-law-head{display:flex;flex-wrap:wrap;gap:.1rem .8rem;align-items:baseline}.lab-law-head strong{font-weight:600}.lab-source{color:var(--quiet);font-size:.86rem}.lab-verdict{white-space:nowrap;color:var(--quiet)}.lab-proven{color:var(--proven)}.lab-refuted{color:var(--alarm)}.lab-undecided{color:var(--undecided)}.lab-formula{overflow:auto hidden;padding:.15rem 0}.lab-law-numbers{color:var(--quiet);font-size:.9rem;display:flex;flex-wrap:wrap;gap:0 1.2rem}.lab-law-numbers .lab-number{color:var(--ink)}.lab-keys{border-collapse:collapse;font-size:.92rem}.lab-keys th{text-align:left;font-weight:400;padding:.12rem 1.2rem .12rem 0;white-space:nowrap}.lab-keys td{padding:.12rem 0}.lab-root kbd{font:inherit;font-variant-numeric:tabular-nums}.lab-plots{display:grid;gap:.4rem;margin-top:.5rem}.lab-plot{margin:0;min-width:0}.lab-plot-now{position:absolute;top:0;bottom:0;left:0;width:1.5px;margin-left:-.75px;background:var(--ink);opacity:.7;pointer-events:none}.lab-root .uplot{font-family:inherit}.lab-curves{display:flex;flex-wrap:wrap;gap:0 1.2rem;padding-left:62px;font-size:.88rem}.lab-curves span{white-space:nowrap}.lab-curves>span{min-width:7.2em}.lab-curves i{display:inline-block;width:1.4rem;vertical-align:middle;margin-right:.4rem}.lab-choice{display:inline-flex;align-items:center;gap:.35rem;font-size:.9rem;color:var(--quiet)}.lab-tools{align-items:center;gap:.4rem .8rem;margin-bottom:.5rem}.lab-sheet{position:relative;width:100%;height:clamp(17rem,76cqi,min(70vh,44rem));touch-action:none;cursor:crosshair}.lab-sheet canvas{position:absolute;inset:0;width:100%;height:100%;display:block}.lab-tip{position:absolute;z-index:2;pointer-events:none;background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.25rem .5rem;font-size:.84rem;max-width:17rem;box-shadow:0 2px 8px #0002}.lab-progress{width:8rem;accent-color:var(--accent)}.lab-key{display:flex;align-items:center;gap:.5rem;font-size:.86rem;color:var(--quiet);margin-top:.3rem}.lab-key i{flex:0 1 12rem;height:.55rem;border-radius:1px}@container lab (max-width: 560px){.lab-transport{flex-wrap:wrap;gap:.3rem}.lab-root .lab-transport .lab-scrub{order:-1;flex:1 0 100%}.lab-time{flex:1;text-align:center;min-width:0}.lab-root .lab-speed select{padding:.24rem .2rem}.lab-switches{flex-wrap:nowrap;overflow-x:auto;scrollbar-width:none;padding-bottom:.2rem}.lab-switches button{flex:none}.lab-root .lab-icon-button{min-width:2.4rem;min-height:2.6rem}.lab-value{min-width:8.4rem}.lab-symbol{flex-basis:2.6rem}.lab-curves{padding-left:0}}@container lab (min-width: 1100px){.lab-root{grid-template-columns:minmax(0,1.25fr) minmax(0,1fr);gap:1rem 1.6rem;align-items:start}.lab-scene{height:clamp(20rem,34cqi,72vh)}.lab-root>.lab-deck:last-child{grid-column:2;grid-row:1 / span 2}.lab-sheet{height:clamp(20rem,34cqi,72vh)}}@media(prefers-reduced-motion:reduce){.lab-root *{transition:none!important;animation:none!important}}.lab-python{display:grid;gap:.2rem}.lab-python .lab-tools{margin-bottom:.2rem}.lab-root input.lab-free{width:auto;max-width:70cqi;text-align:left}.lab-answers{overflow-x:auto}.lab-answers p{margin:.3rem 0}.lab-wide-formula{overflow-x:auto;padding:.2rem 0}.lab-table{border-collapse:collapse;font-size:.92rem}.lab-table th{text-align:left;font-weight:400;color:var(--quiet)}.lab-table :is(th,td){padding:.15rem .9rem .15rem 0;vertical-align:baseline}.lab-tile-chart{width:min(100%,26rem);aspect-ratio:1;image-rendering:pixelated;border:1px solid var(--line)}@media print{.chaplygin-lab.lab-live>.chaplygin-still{display:block}.lab-root{display:none}.chaplygin-lab:not(:has(>.chaplygin-still:not(:empty)))>.lab-root{display:block}.chaplygin-lab:not(:has(>.chaplygin-still:not(:empty))) .lab-root>:not(.lab-view),.lab-transport,.lab-switches,.lab-message{display:none}}.lab-orbits{display:flex;flex-wrap:wrap;gap:.25rem;margin-top:.4rem}.lab-root .lab-orbits button{padding:0 .45rem;min-height:1.6rem;font-size:.82rem;display:inline-flex;gap:.3rem;align-items:center;border-radius:1rem}.lab-orbits i{width:.65rem;height:.65rem;border-radius:50%}.lab-root .lab-orbits button[aria-current=true]{border-color:var(--ink);box-shadow:inset 0 0 0 1px var(--ink)}.lab-spoken{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}.lab-downloads{columns:20rem 3;column-gap:1.6rem}.lab-downloads div{break-inside:avoid;padding-bottom:.4rem;display:flex;gap:.7rem;align-items:center}.lab-root .lab-downloads button{min-width:10.5rem}';function fv(n){let e=n.getRootNode(),t=e instanceof ShadowRoot?e:document.head;if(t.querySelector("style[data-chaplygin-lab]")!==null)return;let i=document.createElement("style");i.dataset.chaplyginLab="",i.textContent=dv,t.append(i)}function mv(n,e){fv(n);let t=X("div",{class:"lab-root"});n.append(t);let i=null,r=TP(e).then(o=>{({lab:i}=o),EP(n,t,o,uv(e))});r.catch(o=>{t.replaceChildren(X("p",{class:"lab-message lab-refused",role:"alert"},o instanceof Error?o.message:String(o)))});let s=CP(r,()=>i);return window.chaplygin=s,s}async function TP(n){let{model:e}=n,t=hv(n),i=t===null?null:X0(location.hash,e),r=i?.experiment??zs(e),s="";i===null&&location.hash.startsWith("#lab&")&&(s="The address asks for values that this system does not have; the page shows its own start.");let o;if(i===null&&e.recorded!==null?o={experiment:r,motion:sf(e),state:Float64Array.from(e.start),surfaces:Dc(e)}:o=await Uc(e,t,r),typeof o=="string"){s=o;let c=await Uc(e,t,zs(e));if(typeof c=="string")throw new Error(c);o=c}let a=new Oc(e,t,o);s!==""&&a.say(s,!0);let l=Number(i?.choices.t);return Number.isFinite(l)&&a.clock.seek(l),{lab:a,choices:i?.choices??{}}}function EP(n,e,{lab:t,choices:i},r){let s=p_(t);s!==null&&n.classList.add("lab-live");let o=()=>{document.fullscreenElement!==null?document.exitFullscreen():e.requestFullscreen().catch(()=>t.say("This browser shows no full screen here.",!0))},a=X("p",{class:"lab-message",role:"status","aria-live":"polite"});t.message.watch(v=>{a.textContent=v,a.classList.toggle("lab-refused",t.refused.value)});let l=Jb(t),c=[{name:"plots",title:"Over time",content:l.element}],u=av(t);u!==null&&c.push({name:"section",title:"Section",content:u.element,shown:()=>u.shown()});let h=W0(t,u);h!==null&&c.push({name:"chart",title:"Chart",content:h.element,shown:()=>h.shown()});let d=F0(t,r);d!==null&&c.push({name:"bifurcation",title:"Bifurcation diagram",content:d.element,shown:()=>d.shown()});let f=[{name:"experiment",title:"Start and parameters",content:Z0(t)}],m=ix(t);m!==null&&f.push({name:"laws",title:"Laws",content:m});let x="",g=y_(t,e,()=>({view:s?.choice()??"",section:u?.choice()??"",show:x})),p=g0({lab:t,scene:s,plots:l,section:u,address:g});r!==null&&f.push({name:"python",title:"Python",content:cv(r,t)}),f.push({name:"downloads",title:"Save",content:p},{name:"keys",title:"Keys",content:x_()});let b=X("div",{class:"lab-view"},s?.element??null,iv(t,o),s?.switches??null,a),E=Bp("Pictures",c,v=>x=v===c[0]?.name?"":v);e.append(b,Bp("Values",f).element,E.element),i.view!==void 0&&s?.restore(i.view),i.section!==void 0&&u?.restore(i.section),i.show!==void 0&&E.select(i.show),e.addEventListener("keydown",v=>{!(v.ctrlKey||v.metaKey)||v.key.toLowerCase()!=="z"||(v.preventDefault(),v.shiftKey?t.redo():t.undo())}),s===null&&Np(t)&&t.message.value===""&&t.say("This browser draws no scene, as it offers no WebGL; everything else works.")}function CP(n,e){let t=()=>{let i=e();if(i===null)throw new Error("The page is not ready yet: wait for chaplygin.ready.");return i};return{ready:n,seek(i){t().clock.pause(),t().clock.seek(i)},pose:()=>_o(t().shown.value.motion,t().clock.time.value),async set({parameters:i,start:r}){let s=t(),o=s.wanted.value,a={...o,parameters:{...o.parameters,...i}};if(Array.isArray(r)?a.start={state:r}:r!==void 0&&(a.start={inputs:{..."inputs"in o.start?o.start.inputs:{},...r}}),!await s.change(a)&&s.refused.value)throw new Error(s.message.value)},async motion(i,r){let s=t(),{motion:o,state:a,experiment:l}=s.shown.value;if(s.engine===null||a===null)return pv(o.times,o.columns);let c={parameters:l.parameters,start:a,times:Bc(i,r)},u=await s.engine.motion(c);return pv(u.times,u.columns)},async section(i){let r=t(),{state:s,experiment:o}=r.shown.value;if(r.engine===null||s===null)throw new Error("This page shows a recorded motion and cannot compute a section.");let{rows:a,dimension:l}=await r.engine.section({parameters:o.parameters,start:s,...i});return Array.from({length:a.length/l},(c,u)=>Array.from(a.subarray(u*l,(u+1)*l)))},laws:()=>tx(t(),t().clock.time.value)}}function pv(n,e){let t=Object.entries(e).map(([i,r])=>[i,Array.from(r)]);return{time:Array.from(n),...Object.fromEntries(t)}}return Fv(RP);})();
/*! Bundled license information:

mediabunny/dist/modules/src/misc.js:
mediabunny/dist/modules/src/logging.js:
mediabunny/dist/modules/src/metadata.js:
mediabunny/dist/modules/shared/bitstream.js:
mediabunny/dist/modules/shared/aac-misc.js:
mediabunny/dist/modules/shared/ac3-misc.js:
mediabunny/dist/modules/src/version.js:
mediabunny/dist/modules/src/codec-data.js:
mediabunny/dist/modules/src/codec.js:
mediabunny/dist/modules/src/packet.js:
mediabunny/dist/modules/src/isobmff/isobmff-misc.js:
mediabunny/dist/modules/src/isobmff/isobmff-reader.js:
mediabunny/dist/modules/src/adts/adts-reader.js:
mediabunny/dist/modules/src/reader.js:
mediabunny/dist/modules/src/muxer.js:
mediabunny/dist/modules/src/subtitles.js:
mediabunny/dist/modules/src/isobmff/isobmff-boxes.js:
mediabunny/dist/modules/src/writer.js:
mediabunny/dist/modules/src/target.js:
mediabunny/dist/modules/src/isobmff/isobmff-muxer.js:
mediabunny/dist/modules/src/media-source.js:
mediabunny/dist/modules/src/output-format.js:
mediabunny/dist/modules/src/output.js:
mediabunny/dist/modules/src/index.js:
  (*!
   * Copyright (c) 2026-present, Vanilagy and contributors
   *
   * This Source Code Form is subject to the terms of the Mozilla Public
   * License, v. 2.0. If a copy of the MPL was not distributed with this
   * file, You can obtain one at https://mozilla.org/MPL/2.0/.
   *)

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
