"use strict";var ChaplyginLab=(()=>{var gu=Object.defineProperty;var $0=Object.getOwnPropertyDescriptor;var Z0=Object.getOwnPropertyNames;var J0=Object.prototype.hasOwnProperty;var K0=(i,e)=>{for(var t in e)gu(i,t,{get:e[t],enumerable:!0})},j0=(i,e,t,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let s of Z0(e))!J0.call(i,s)&&s!==t&&gu(i,s,{get:()=>e[s],enumerable:!(n=$0(e,s))||n.enumerable});return i};var Q0=i=>j0(gu({},"__esModule",{value:!0}),i);var E1={};K0(E1,{mount:()=>ru,mountAll:()=>S1,render:()=>A1});function he(i,e={},...t){let n=document.createElement(i);for(let[s,r]of Object.entries(e))r===null||r===!1||n.setAttribute(s,r===!0?"":String(r));return n.append(...t.filter(s=>s!==null)),n}function Hs(i,e,t,n){let s=he("button",{type:"button","aria-label":e,title:e,"aria-pressed":String(t)},i);return s.addEventListener("click",()=>{let r=s.getAttribute("aria-pressed")!=="true";s.setAttribute("aria-pressed",String(r)),n(r)}),s}function Mr(i,e,t,n){let s=he("select",{"aria-label":i});for(let{value:r,text:o}of e){let a=he("option",{value:r},o);a.selected=r===t,s.append(a)}return s.addEventListener("change",()=>n(s.value)),he("label",{class:"lab-choice"},he("span",{},i),s)}function xu(i){let e=Math.min(window.devicePixelRatio||1,2),t=Math.max(1,Math.round(i.clientWidth*e)),n=Math.max(1,Math.round(i.clientHeight*e));return(i.width!==t||i.height!==n)&&(i.width=t,i.height=n),{width:t,height:n,ratio:e}}function Ws(i){return{parameters:{},start:{inputs:{}},until:i.until}}function _u(i,e){return JSON.stringify(Kd(i))===JSON.stringify(Kd(e))}function Kd({parameters:i,start:e,until:t}){let n=s=>Object.entries(s).sort(([r],[o])=>r<o?-1:1);return[n(i),"state"in e?e.state:n(e.inputs),t]}function Pa(i,e){return Float64Array.from({length:e},(t,n)=>i*n/Math.max(1,e-1))}function vu(i,e,t){let n=new URLSearchParams;for(let[r,o]of Object.entries(i.parameters))n.set(`p.${r}`,String(o));if("state"in i.start)n.set("state",i.start.state.join(" "));else for(let[r,o]of Object.entries(i.start.inputs))n.set(`s.${r}`,String(o));i.until!==e.until&&n.set("until",String(i.until));for(let[r,o]of Object.entries(t))n.set(r,o);let s=n.toString();return s===""?"":`#lab&${s}`}function jd(i,e){if(!i.startsWith("#lab&"))return null;let t={parameters:{},inputs:{}},n=null,s=e.until,r={};for(let[a,l]of new URLSearchParams(i.slice(5))){let c=Number(l),u=a.slice(2);if(a.startsWith("p.")){if(!Number.isFinite(c)||!e.parameters.some(h=>h.name===u&&!h.fixed))return null;t.parameters[u]=c}else if(a.startsWith("s.")){if(!Number.isFinite(c)||!e.start_inputs.some(h=>h.name===u))return null;t.inputs[u]=c}else if(a==="state"){if(n=l.split(/[ +]/).map(Number),n.length!==e.state.length||!n.every(Number.isFinite))return null}else if(a==="until"){if(!(c>0)||!Number.isFinite(c))return null;s=c}else r[a]=l}let o=n===null?{inputs:t.inputs}:{state:n};return{experiment:{parameters:t.parameters,start:o,until:s},choices:r}}function yu(i,e,t,n){let{[e]:s,...r}=i;return t===n?r:{...r,[e]:t}}var Ca=class{constructor(e=200){this.longest=e}longest;past=[];future=[];push(e){this.past.push(e),this.past.length>this.longest&&this.past.shift(),this.future=[]}undo(e){let t=this.past.pop();return t!==void 0&&this.future.push(e),t}redo(e){let t=this.future.pop();return t!==void 0&&this.past.push(e),t}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}};var ex="http://www.w3.org/1998/Math/MathML";function Qi(i){let t=new DOMParser().parseFromString(i,"text/html").querySelector("math");return t===null?document.createTextNode(i):(nf(t),document.importNode(t,!0))}function So(i){let e=new DOMParser().parseFromString(i,"text/html");return tf(e.querySelector("math")??e.body).trim()||i}function tf(i){let e=[...i.children].map(tf),[t="",n="",s=""]=e;switch(i.localName){case"msub":return t+Ia(n,Qd);case"msup":return t+Ia(n,ef);case"msubsup":return t+Ia(n,Qd)+Ia(s,ef);case"mfrac":return`${t}/${n}`;default:return e.length>0?e.join(""):i.textContent??""}}var tx="0123456789",Qd="₀₁₂₃₄₅₆₇₈₉",ef="⁰¹²³⁴⁵⁶⁷⁸⁹";function Ia(i,e){return[...i].map(t=>e[tx.indexOf(t)]??t).join("")}function nf(i){for(let{name:e}of[...i.attributes])(e.startsWith("on")||e==="href")&&i.removeAttribute(e);for(let e of[...i.children])e.namespaceURI===ex?nf(e):e.remove()}function La(i,e){let t=i.length-1;if(t<=0||!(e>(i[0]??0)))return{index:0,share:0};if(e>=(i[t]??0))return{index:t,share:0};let n=0,s=t;for(;s-n>1;){let o=n+s>>1;(i[o]??0)<=e?n=o:s=o}let r=i[n]??0;return{index:n,share:(e-r)/((i[s]??0)-r)}}function jn(i,e,t,n){let s=i.columns[e];if(s===void 0)return null;let{index:r,share:o}=La(i.times,n),a=(l,c)=>s[l*t+c]??NaN;return Array.from({length:t},(l,c)=>o===0?a(r,c):(1-o)*a(r,c)+o*a(r+1,c))}function nx(i,e,t){let n=i[0]*e[0]+i[1]*e[1]+i[2]*e[2]+i[3]*e[3],s=n<0?-1:1;n=Math.min(1,Math.abs(n));let r=Math.acos(n),o=Math.sin(r),a=o>1e-9?Math.sin((1-t)*r)/o:1-t,l=(o>1e-9?Math.sin(t*r)/o:t)*s;return ix([a*i[0]+l*e[0],a*i[1]+l*e[1],a*i[2]+l*e[2],a*i[3]+l*e[3]])}function ix(i){let e=Math.hypot(...i)||1;return[i[0]/e,i[1]/e,i[2]/e,i[3]/e]}function Sr(i,e){let[t,n,s,r]=i,o=2*(s*e[2]-r*e[1]),a=2*(r*e[0]-n*e[2]),l=2*(n*e[1]-s*e[0]);return[e[0]+t*o+s*l-r*a,e[1]+t*a+r*o-n*l,e[2]+t*l+n*a-s*o]}function sf(i,e){return Sr([i[0],-i[1],-i[2],-i[3]],e)}function wo(i,e){let t=i.columns.attitude,{index:n,share:s}=La(i.times,e),r=c=>[0,1,2,3].map(u=>t?.[4*c+u]??(u===0?1:0)),o=s===0?r(n):nx(r(n),r(n+1),s),a=c=>jn(i,c,3,e),l=a("centre")??[0,0,0];return{t:sx(i,e),attitude:o,centre:l,contact:a("contact")??l}}function sx(i,e){let{times:t}=i;return Math.min(Math.max(e,t[0]??0),t[t.length-1]??0)}function Xs(i,e,t){let n=i.columns[e];if(n===void 0)return 0;for(let s=0;s<i.times.length;s++)for(let r=0;r<t;r++)if(!Number.isFinite(n[s*t+r]))return s;return i.times.length}var rx={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function vi(i){return i==="1"||i==="unknown"?"":i.replace(/(?:\*\*|\^)\{?(-?\d+)\}?/g,(t,n)=>[...n].map(s=>rx[s]??s).join("")).replaceAll("*"," ").trim()}var ox="⁰¹²³⁴⁵⁶⁷⁸⁹";function Kt(i,e=4){if(Number.isNaN(i))return"–";if(!Number.isFinite(i))return i>0?"∞":"−∞";if(i===0)return"0";let t=Math.abs(i);if(t>=.001&&t<1e5)return rf(i.toPrecision(e)).replace("-","−");let[n="",s="0"]=i.toExponential(e-1).split("e"),r=rf(n).replace("-","−"),o=Number(s),a=o<0?"⁻":"",l=[...String(Math.abs(o))].map(c=>ox[Number(c)]).join("");return`${r}·10${a}${l}`}function rf(i){let e=i.includes("e")?String(Number(i)):i;return e.includes(".")?e.replace(/\.?0+$/,""):e}function Na(i){let e=10**Math.floor(Math.log10(i));return([5,2,1].find(n=>n*e<=i*(1+1e-9))??1)*e}function of(i,e=.05){let t=1/0,n=-1/0;for(let o of i)Number.isFinite(o)&&(o<t&&(t=o),o>n&&(n=o));if(t>n)return[-1,1];let s=Math.max(Math.abs(t),Math.abs(n));if(n-t<=1e-9*s||n===t){let o=s>0?.1*s:1;return[t-o,n+o]}let r=e*(n-t);return[t-r,n+r]}function bu(i,e,t){let n=(e-i)/Math.max(1,t);if(!(n>0))return[i];let s=Na(n);for(;(e-i)/s>1.35*t;)s=Na(2.5*s);let r=Math.ceil(i/s-1e-9),o=Math.floor(e/s+1e-9);return Array.from({length:o-r+1},(a,l)=>Number(((r+l)*s).toPrecision(12)))}var Da=1e3;function Fa(i,e,t){let{low:n,high:s}=i,r=`${i.meaning||i.name}${i.unit&&i.unit!=="1"?`, ${i.unit}`:""}`,o=he("input",{type:"range",min:0,max:Da,step:1,"aria-label":r}),a=he("input",{type:"text",inputmode:"decimal","aria-label":`${r}, as a number`,class:"lab-field",size:9}),l=f=>{let g=s>n?(f-n)/(s-n):0;o.value=String(Math.round(Da*g)),o.style.setProperty("--share",String(Math.min(1,Math.max(0,g)))),o.setAttribute("aria-valuetext",`${Kt(f)} ${i.unit}`),document.activeElement!==a&&(a.value=ax(f))},c=!1;o.addEventListener("input",()=>{c||e(),c=!0;let f=lx(n+Number(o.value)/Da*(s-n),s-n);l(f),t(f)}),o.addEventListener("change",()=>c=!1);let u=()=>{let f=Number(a.value.replace("−","-").replace(",","."));if(a.value.trim()===""||!Number.isFinite(f)){a.setAttribute("aria-invalid","true");return}a.removeAttribute("aria-invalid"),e(),t(f),l(f)};a.addEventListener("change",u),a.addEventListener("keydown",f=>f.stopPropagation()),l(i.value);let h=vi(i.unit)===""?null:he("span",{class:"lab-unit"},vi(i.unit));return{element:he("div",{class:"lab-slider",title:i.meaning||null},he("span",{class:"lab-symbol"},i.symbol),o,he("span",{class:"lab-value"},a,h)),set:l}}function ax(i){return String(Number(i.toPrecision(6)))}function lx(i,e){let t=10**Math.floor(Math.log10(e/Da));return Number((Math.round(i/t)*t).toPrecision(12))}function af(i,e,t){let n=e??(i>0?0:i<0?2*i:-1),s=t??(i>0?2*i:i<0?0:1);return n<s?[Math.min(n,i),Math.max(s,i)]:[n,n+Math.max(1,Math.abs(n))]}function uf(i){let{model:e}=i;if(i.engine===null)return null;let t=cx(e),n=e.start_inputs.map(l=>{let c=Fa({...l,symbol:Qi(l.mathml)},()=>i.mark(),u=>{let h=cf(i),d=yu(h,l.name,u,t.inputs.get(l.name)??NaN);i.change({...i.wanted.value,start:{inputs:d}},!1)});return[l.name,c]}),s=e.parameters.filter(l=>!l.fixed).map(l=>{let[c,u]=af(l.value,l.low,l.high),h=Fa({...l,symbol:Qi(l.mathml),low:c,high:u},()=>i.mark(),d=>{let f=i.wanted.value;i.change({...f,parameters:yu(f.parameters,l.name,d,l.value)},!1)});return[l.name,h]}),r=Fa({name:"until",symbol:document.createTextNode("until"),meaning:"Duration of the motion",unit:"s",value:e.until,low:e.until/20,high:5*e.until},()=>i.mark(),l=>{l>0?i.change({...i.wanted.value,until:l},!1):i.say("The duration must be positive.",!0)}),o=he("p",{class:"lab-hint",hidden:!0},"This start was chosen in a section or chart; a slider takes it from here.");i.wanted.watch(l=>{for(let[c,u]of s)u.set(l.parameters[c]??t.parameters.get(c)??0);r.set(l.until)}),i.shown.watch(()=>{let l=cf(i);o.hidden=!("state"in i.wanted.value.start);for(let[c,u]of n)u.set(l[c]??t.inputs.get(c)??0)}),i.wanted.after(l=>{if(!("state"in l.start))for(let[c,u]of n)u.set(l.start.inputs[c]??t.inputs.get(c)??0)});let a=he("button",{type:"button",class:"lab-button"},"As at first");return a.addEventListener("click",()=>{i.change(Ws(e))}),he("div",{class:"lab-sliders"},lf("Start",n,o),lf("Parameters",s,null),he("fieldset",{},he("legend",{},"Run"),r.element,a))}function lf(i,e,t){return e.length===0?null:he("fieldset",{},he("legend",{},i),...e.map(([,n])=>n.element),t)}function cx(i){return{inputs:new Map(i.start_inputs.map(e=>[e.name,e.value])),parameters:new Map(i.parameters.map(e=>[e.name,e.value]))}}function cf(i){let{start:e}=i.wanted.value;if("inputs"in e)return{...e.inputs};let{motion:t}=i.shown.value,n={};for(let{name:s}of i.model.start_inputs){let r=i.model.state.findIndex(a=>a.name===s),o=r>=0?e.state[r]:ux(i,s,t.times[0]??0);o!==void 0&&Number.isFinite(o)&&(n[s]=o)}return n}function ux(i,e,t){let n=e.lastIndexOf("_"),s=i.model.columns.find(o=>o.name===e||o.name===e.slice(0,n));if(s===void 0)return;let r=s.name===e?0:Number(e.slice(n+1))-1;return jn(i.shown.value.motion,s.name,s.width,t)?.[r]}function hx(i,e){let t=new Float64Array(3*i.length*e.length),n=0;for(let s=0;s<i.length;s++)for(let r=0;r<e.length;r++){let o=Math.sin(i[s]);t[n++]=o*Math.cos(e[r]),t[n++]=o*Math.sin(e[r]),t[n++]=Math.cos(i[s])}return t}function hf(i,e){let{theta:t,phi:n,hollow:s}=i,r=t.length,o=n.length,a=hx(t,n),l=s?1:-1,c=r*o,u=c+2*(o+1),h=new Float32Array(3*u),d=new Float32Array(3*u);for(let p=0;p<3*c;p++)h[p]=e[p],d[p]=l*a[p];let f=[],g=[],M=(p,v,T,b)=>{dx(h,d,p,v,T)||([v,T]=[T,v]),f.push(p,v,T),g.push(b)},m=p=>Math.floor((n[p]+1e-9)/(Math.PI/2));for(let p=0;p+1<r;p++){let v=(t[p]+t[p+1])/2<Math.PI/2?1:0;for(let T=0;T<o;T++){let b=(T+1)%o,C=(m(T)+v)%2;M(p*o+T,p*o+b,(p+1)*o+b,C),M(p*o+T,(p+1)*o+b,(p+1)*o+T,C)}}for(let p of[!0,!1]){let v=(p?0:r-1)*o,T=c+(p?0:o+1),b=T+o,C=l*(p?1:-1);for(let E=0;E<o;E++){for(let _=0;_<3;_++){let A=h[3*(v+E)+_];h[3*(T+E)+_]=A,h[3*b+_]+=A/o}d[3*(T+E)+2]=C}d[3*b+2]=C;for(let E=0;E<o;E++)M(b,T+E,T+(E+1)%o,(m(E)+(p?1:0))%2)}return{positions:h,normals:d,indices:Uint32Array.from(f),tones:Uint8Array.from(g),hollow:s}}function dx(i,e,t,n,s){let r=[0,1,2].map(l=>i[3*n+l]-i[3*t+l]),o=[0,1,2].map(l=>i[3*s+l]-i[3*t+l]),a=0;for(let l=0;l<3;l++){let c=(l+1)%3,u=(l+2)%3,h=e[3*t+l]+e[3*n+l]+e[3*s+l];a+=(r[c]*o[u]-r[u]*o[c])*h}return a>=0}function Mu(i){let e=atob(i),t=new Uint8Array(e.length);for(let n=0;n<e.length;n++)t[n]=e.charCodeAt(n);return t}function Su(i){return new Float64Array(Mu(i).buffer)}function qs(i){return new Float32Array(Mu(i).buffer)}function df(i){return new Uint32Array(Mu(i).buffer)}var yi=class{constructor(e){this.current=e}current;watchers=new Set;get value(){return this.current}set value(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.watchers])t(e)}}watch(e){return e(this.current),this.after(e)}after(e){return this.watchers.add(e),()=>this.watchers.delete(e)}};function ff(i){let e=!1,t=null,n=async()=>{for(e=!0;t!==null;){let{argument:s,resolve:r,reject:o}=t;t=null;try{let a=await i(s);r(t===null?a:void 0)}catch(a){o(a)}}e=!1};return s=>new Promise((r,o)=>{t?.resolve(void 0),t={argument:s,resolve:r,reject:o},e||n()})}var wr=[.02,.05,.1,.25,.5,1,2,5,10],Ua=class{time=new yi(0);playing=new yi(!1);speed=new yi(1);end=1;frame=0;before=0;set until(e){this.end=e,this.time.value>e&&(this.time.value=e)}get until(){return this.end}play(){this.playing.value||(this.time.value>=this.end&&(this.time.value=0),this.playing.value=!0,this.before=0,this.frame=requestAnimationFrame(this.step))}pause(){this.playing.value&&(cancelAnimationFrame(this.frame),this.playing.value=!1)}toggle(){this.playing.value?this.pause():this.play()}seek(e){this.time.value=Math.min(Math.max(e,0),this.end)}changeSpeed(e){let t=wr.findIndex(n=>n>=this.speed.value-1e-9);this.speed.value=wr[Math.min(Math.max(t+e,0),wr.length-1)]??1}step=e=>{if(!this.playing.value)return;let t=this.before===0?0:Math.min(.1,(e-this.before)/1e3);this.before=e;let n=this.time.value+t*this.speed.value;this.time.value=n>=this.end?0:n,this.frame=requestAnimationFrame(this.step)}};function pf(i){if(i>=4&&i<=90)return 1;let e=i<4?i/8:i/40;return wr.reduce((t,n)=>Math.abs(Math.log(n/e))<Math.abs(Math.log(t/e))?n:t)}var Oa=class{constructor(e,t,n){this.model=e;this.engine=t;this.shown=new yi(n),this.wanted=new yi(n.experiment),this.compute=ff(s=>ka(e,t,s)),this.clock.until=n.motion.times.at(-1)??0,this.clock.speed.value=pf(this.clock.until)}model;engine;clock=new Ua;shown;message=new yi("");refused=new yi(!1);history=new Ca;wanted;compute;async change(e,t=!0){return _u(e,this.wanted.value)?!0:(t&&this.history.push(this.wanted.value),this.request(e))}mark(){this.history.push(this.wanted.value)}async undo(){let e=this.history.undo(this.wanted.value);e!==void 0&&await this.request(e)}async redo(){let e=this.history.redo(this.wanted.value);e!==void 0&&await this.request(e)}say(e,t=!1){this.refused.value=t,this.message.value=e}async request(e){this.wanted.value=e;let t;try{t=await this.compute(e)}catch(s){t=s instanceof Error?s.message:String(s)}if(t===void 0)return!1;if(typeof t=="string")return this.say(t,!0),!1;let n=t.motion.end;return this.say(n===null?"":`The motion ends at t = ${n.time.toPrecision(4)}: ${n.reason}.`,n!==null),this.clock.until=t.motion.times.at(-1)??0,this.shown.value=t,!0}};async function ka(i,e,t){if(e===null)return i.recorded===null?"This page holds no motion and cannot compute one.":_u(t,Ws(i))?{experiment:t,motion:wu(i),state:Float64Array.from(i.start),surface:Ba(i)}:"This page shows a recorded motion and cannot compute another.";let n=await fx(e,t);if("message"in n)return n.message;let{parameters:s,until:r}=t,[o,a]=await Promise.all([e.motion({parameters:s,start:n.state,times:Pa(r,px(i,r))}),e.bodyMesh(s)]);return{experiment:t,motion:o,state:n.state,surface:a??Ba(i)}}async function fx(i,e){let{start:t,parameters:n}=e;return"state"in t?{state:Float64Array.from(t.state)}:i.startFrom({parameters:n,inputs:t.inputs})}function px(i,e){let t=Math.round((i.samples-1)*e/i.until)+1;return Math.min(20001,Math.max(601,i.samples,t))}function wu(i){let e=i.recorded;if(e===null)return{times:new Float64Array(1),columns:{},end:null};let t=Object.fromEntries(Object.entries(e.columns).map(([n,s])=>[n,Su(s)]));return{times:Su(e.times),columns:t,end:e.end}}function Ba(i){let e=i.scene.body;return e===null?null:hf(e,qs(e.positions))}var mx=[["proven","✓"],["refuted","✗"],["undecided","?"],["not tried","–"]];function mf(i,e){let{motion:t}=i.shown.value;return i.model.laws.map(({name:n,verdict:s,column:r})=>({name:n,verdict:s,value:r===null?null:jn(t,r,1,e)?.[0]??null,drift:r===null?null:gf(t,r)}))}function gf(i,e){let t=i.columns[e];if(t===void 0)return null;let n=t[0]??NaN,s=0;for(let r of t){let o=Math.abs(r-n);o>s&&(s=o)}return s}function gx({verdict:i,text:e}){let[t,n]=mx.find(([s])=>i.startsWith(s))??["undecided","?"];return he("span",{class:`lab-verdict lab-${t.replace(" ","-")}`,title:e},`${n} ${i}`)}function xf(i){let{laws:e,columns:t}=i.model;if(e.length===0)return null;let n=new Map(t.map(({name:o,unit:a})=>[o,vi(a)])),s=e.map(o=>{let a=he("span",{class:"lab-number"}),l=he("span",{class:"lab-number"}),c=gx(o),u=o.column===null?null:he("p",{class:"lab-law-numbers"},he("span",{},"now ",a),he("span",{},"drift ",l)),h=he("li",{},he("p",{class:"lab-law-head"},he("strong",{},o.meaning||o.name),c,he("span",{class:"lab-source"},o.source)),he("div",{class:"lab-formula",tabindex:0,role:"group","aria-label":`Formula of ${o.meaning||o.name}`},Qi(o.mathml)),u);return{law:o,value:a,away:l,made:h}}),r=()=>{for(let{law:o,value:a}of s){if(o.column===null)continue;let l=jn(i.shown.value.motion,o.column,1,i.clock.time.value)?.[0]??NaN;a.textContent=`${Kt(l,7)} ${n.get(o.column)??""}`}};return i.clock.time.after(r),i.shown.watch(({motion:o})=>{for(let{law:a,away:l}of s)a.column!==null&&(l.textContent=Kt(gf(o,a.column)??NaN,2));r()}),he("ul",{class:"lab-laws"},...s.map(({made:o})=>o))}var xx={dark:!1,ink:"#1f2730",quiet:"#66727d",line:"#d9dfe4",paper:"#ffffff",alarm:"#bb5566",time:["#f6c667","#ec8f4d","#cf4f5b","#8a2a75","#3b1a68"],body:["#f4f1ea","#5b86ad"],shell:["#f0ece2","#a9bfd3"],seam:"#3d5a76",ground:["#f4f7fa","#b3bfcb"],grid:"#aab6c2",shadow:.34,components:["#004488","#bb5566","#d9a521"],series:["#332288","#cc6677","#117733","#ddaa33","#88ccee","#aa4499","#999933","#44aa99"]},_x={dark:!0,ink:"#dde3e8",quiet:"#97a4af",line:"#36414b",paper:"#151a1f",alarm:"#e58a99",time:["#f8d98c","#f2a65a","#e66f79","#b873d6","#8fa8ff"],body:["#f4f1ea","#5b86ad"],shell:["#dcd9d0","#8fa9c2"],seam:"#25394d",ground:["#5b6773","#2c353e"],grid:"#56636f",shadow:.6,components:["#6ea8e6","#e58a99","#e6bd52"],series:["#a497f3","#e58a99","#58b97b","#e6bd52","#88ccee","#d582c8","#c3c35c","#5cc4b2"]},vf=()=>typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function Tn(){return vf()?.matches?_x:xx}function Ar(i){vf()?.addEventListener("change",i)}function _f(i){let e=Number.parseInt(i.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function yf(i,e){let t=i.length-1,n=Math.min(Math.max(e,0),1)*t,s=Math.min(Math.floor(n),t-1),[r,o]=[_f(i[s]??"#000000"),_f(i[s+1]??"#000000")],a=n-s;return[0,1,2].map(l=>Math.round((r[l]??0)+a*((o[l]??0)-(r[l]??0))))}var za=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"];function Ao(i,e,t,n){let s=0;for(let r=0;r+2<i.length;r+=3){let[o,a,l]=[i[r]??0,i[r+1]??0,i[r+2]??0],c=Math.hypot(o,a,l);c>0&&(s=Math.max(s,Math.acos(Math.min(1,Math.max(-1,e*l/c)))))}return s+t<n?s+t:Math.PI}function Eo(i){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let n=0;n<i.length;n++){let s=i[n]??NaN,r=n%3;s<e[r]&&(e[r]=s),s>t[r]&&(t[r]=s)}return{low:e,high:t}}var bf=Math.PI/2-.02,Va=30*Math.PI/180;function Mf({azimuth:i,elevation:e}){let t=Math.cos(e);return[t*Math.cos(i),t*Math.sin(i),Math.sin(e)]}function Sf(i){let e=Mf(i);return i.target.map((t,n)=>t+i.distance*(e[n]??0))}function Ga(i,e,t){return{...i,azimuth:i.azimuth-Math.PI*e,elevation:Math.min(Math.max(i.elevation+Math.PI*t,-bf),bf)}}function To(i,e){return{...i,distance:Math.min(Math.max(i.distance*e,.8),4e3)}}function Eu(i,e,t){let n=2*i.distance*Math.tan(Va/2),{azimuth:s,elevation:r}=i,o=[-Math.sin(s),Math.cos(s),0],a=[-Math.sin(r)*Math.cos(s),-Math.sin(r)*Math.sin(s),Math.cos(r)];return{...i,target:i.target.map((l,c)=>l+n*(t*(a[c]??0)-e*(o[c]??0)))}}function Er(i,e,t,n){let r=Mf({azimuth:e,elevation:t,distance:1,target:[0,0,0]}),o=[-Math.sin(e),Math.cos(e),0],a=[-Math.sin(t)*Math.cos(e),-Math.sin(t)*Math.sin(e),Math.cos(t)],l=Math.tan(Va/2)*vx,c=l*n,u={x:0,y:0},h=1;for(let f=0;f<3;f++){let g={left:1/0,right:-1/0,low:1/0,high:-1/0},M=1;for(let m=0;m+2<i.length;m+=3){let p=[i[m]??0,i[m+1]??0,i[m+2]??0],[v,T,b]=[Au(p,o)-u.x,Au(p,a)-u.y,Au(p,r)];M=Math.max(M,b+Math.max(Math.abs(v)/c,Math.abs(T)/l));let C=f===0?1:h/Math.max(1e-6,h-b);g.left=Math.min(g.left,v*C),g.right=Math.max(g.right,v*C),g.low=Math.min(g.low,T*C),g.high=Math.max(g.high,T*C)}if(h=M,f===2)break;u.x+=(g.left+g.right)/2,u.y+=(g.low+g.high)/2}let d=[0,1,2].map(f=>u.x*(o[f]??0)+u.y*(a[f]??0));return{azimuth:e,elevation:t,distance:h,target:d}}var vx=.92;function Au(i,e){return i[0]*e[0]+i[1]*e[1]+i[2]*e[2]}function Ha(i){let e=Math.floor(i.length/3),[t,n]=[0,0];for(let h=0;h<e;h++)t+=(i[3*h]??0)/e,n+=(i[3*h+1]??0)/e;let[s,r,o]=[0,0,0];for(let h=0;h<e;h++){let[d,f]=[(i[3*h]??0)-t,(i[3*h+1]??0)-n];s+=d*d,r+=d*f,o+=f*f}if(!(s+o>0))return 0;let a=.5*Math.atan2(2*r,s-o),l=e-1,u=Math.cos(a)*((i[3*l]??0)-(i[0]??0))+Math.sin(a)*((i[3*l+1]??0)-(i[1]??0))<0?-1:1;return Math.atan2(-u*Math.cos(a),u*Math.sin(a))}var yx=10;function Tu(i,e,t,n=1.6){let s=Af(i,e).map(c=>c/t),{support:r}=i,o=[...wf(s)];if(r?.kind==="sphere"){let c=Math.abs(r.radius)/t,{azimuth:u,elevation:h}=Mx(s,r.inside),d=r.inside?Ao(s,-1,.3,1.75):Ao(s,1,Math.max(.12,.75/c),1.2);return Er([...o,...bx(c,r.inside,d)],u,h,n)}if(r?.kind==="mesh")return Er([...o,...qs(r.positions).map(c=>c/t)],Ha(s)+.3,.5,n);if(r?.kind==="point"||r===null&&i.path===null)return Er(o,.6,.35,n);let a=Ha(s)+.42;if(!Ru(i,e))return Er(o,a,.5,n);let l=[...wf(s.slice(0,3))].map((c,u)=>c+(u%3<2?1.6*Math.sign(c-(s[u%3]??0)):0));return Er(l,a,.5,n)}function*wf(i){let e=i.length/3,t=Math.max(1,Math.floor(e/60));for(let n=0;n<e;n+=t)for(let s=0;s<8;s++)for(let r=0;r<3;r++)yield(i[3*n+r]??0)+(s>>r&1?.5:-.5)}function*bx(i,e,t){for(let n=1;n<=6;n++){let s=t*n/6;for(let r=0;r<24;r++){let o=Math.PI*r/12;yield i*Math.sin(s)*Math.cos(o),yield i*Math.sin(s)*Math.sin(o),yield(e?-1:1)*i*Math.cos(s)}}}function Ru(i,e){if(i.support?.kind!=="plane")return!1;let t=Af(i,e);if(t.length===0)return!1;let{low:n,high:s}=Eo(t);return Math.hypot(s[0]-n[0],s[1]-n[1])>yx*i.size}function Mx(i,e){let t=[0,1,2].map(a=>{let l=0;for(let c=a;c<i.length;c+=3)l+=i[c]??0;return 3*l/Math.max(3,i.length)+.8*(i[i.length-3+a]??0)}),n=Math.hypot(...t)||1,s=Math.asin(Math.min(1,Math.max(-1,(t[2]??0)/n))),r=Math.hypot(t[0]??0,t[1]??0)<.35*n,o=r?Ha(i):Math.atan2(t[1]??0,t[0]??0)+.35;return e?{azimuth:o+(r?0:Math.PI),elevation:s<-.3?.62:.35}:{azimuth:o,elevation:Math.min(.6,Math.max(-.25,.6*s))}}function Af(i,e){if(i.path!==null)return Cu(i,e);let t=e.columns.contact?"contact":"centre",n=Xs(e,t,3),s=(e.columns[t]??new Float64Array(0)).slice(0,3*n);return s.length>0?s:new Float64Array(3)}function Ef(i,e){if(i.length===0)return 3;let{low:t,high:n}=Eo(i);return 2.2+Math.hypot(n[0]-t[0],n[1]-t[1])/e}function Cu(i,e){let t=i.path??"",n=Xs(e,t,2),s=e.columns[t],r=new Float64Array(3*n);for(let o=0;o<n;o++)r.set([s?.[2*o]??0,s?.[2*o+1]??0,0],3*o);return r}function Tf(i,e,t){let n=new Map,s=()=>{let[o,a]=[...n.values()];return o&&a?Math.hypot(o.x-a.x,o.y-a.y):0};i.addEventListener("pointerdown",o=>{n.set(o.pointerId,{x:o.clientX,y:o.clientY}),i.setPointerCapture(o.pointerId)}),i.addEventListener("pointermove",o=>{let a=n.get(o.pointerId);if(a===void 0)return;let l=i.clientHeight||1,c=(o.clientX-a.x)/l,u=(o.clientY-a.y)/l;if(n.size===2){let d=s();n.set(o.pointerId,{x:o.clientX,y:o.clientY});let f=s();d>0&&f>0&&(e.view=To(e.view,d/f)),e.view=Eu(e.view,c/2,u/2),t(!0);return}n.set(o.pointerId,{x:o.clientX,y:o.clientY});let h=o.shiftKey||o.buttons===2||o.buttons===4;e.view=h?Eu(e.view,c,u):Ga(e.view,c,u),t(h)});let r=o=>{n.delete(o.pointerId)};i.addEventListener("pointerup",r),i.addEventListener("pointercancel",r),i.addEventListener("contextmenu",o=>o.preventDefault()),i.addEventListener("wheel",o=>{!i.matches(":focus-within")&&!o.ctrlKey||(o.preventDefault(),e.view=To(e.view,Math.exp(.0015*o.deltaY)),t(!1))},{passive:!1})}var jf=0,rh=1,Qf=2;var Ks=1,ep=2,Jr=3,qn=0,en=1,fi=2,js=0,Kr=1,oh=2,ah=3,lh=4,tp=5;var Qs=100,np=101,ip=102,sp=103,rp=104,op=200,ap=201,lp=202,cp=203,ch=204,uh=205,up=206,hp=207,dp=208,fp=209,pp=210,mp=211,gp=212,xp=213,_p=214,dl=0,fl=1,pl=2,Vr=3,ml=4,gl=5,xl=6,_l=7,ta=0,vp=1,yp=2,Wi=0,hh=1,dh=2,fh=3,ph=4,mh=5,gh=6,xh=7;var _h=300,er=301,jr=302,Xl=303,ql=304,vl=1e3,zi=1001,yl=1002,An=1003,bp=1004;var na=1005;var Vn=1006,Yl=1007;var ds=1008;var Yn=1009,vh=1010,yh=1011,Qr=1012,$l=1013,Ai=1014,Ei=1015,Ti=1016,Zl=1017,Jl=1018,tr=1020,bh=35902,Mh=35899,Sh=1021,wh=1022,Ri=1023,os=1026,fs=1027,Ah=1028,Kl=1029,Os=1030,jl=1031;var Ql=1033,ia=33776,sa=33777,ra=33778,oa=33779,ec=35840,tc=35841,nc=35842,ic=35843,sc=36196,rc=37492,oc=37496,ac=37488,lc=37489,aa=37490,cc=37491,uc=37808,hc=37809,dc=37810,fc=37811,pc=37812,mc=37813,gc=37814,xc=37815,_c=37816,vc=37817,yc=37818,bc=37819,Mc=37820,Sc=37821,wc=36492,Ac=36494,Ec=36495,Tc=36283,Rc=36284,la=36285,Cc=36286;var No=2300,bl=2301,ul=2302,ju=2303,Qu=2400,eh=2401,th=2402;var Mp=3200;var ca=0,Sp=1,ps="",ti="srgb",Do="srgb-linear",Fo="linear",wt="srgb";var hl=7680;var wp=519,Ap=512,Ep=513,Tp=514,Eh=515,Rp=516,Cp=517,Th=518,Rh=519,Ch=35044;var Ph="300 es",hi=2e3,Gr=2001;function Sx(i){for(let e=i.length-1;e>=0;--e)if(i[e]>=65535)return!0;return!1}function wx(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function Uo(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Pp(){let i=Uo("canvas");return i.style.display="block",i}var Rf={},Hr=null;function Oo(...i){let e="THREE."+i.shift();Hr?Hr("log",e,...i):console.log(e,...i)}function Ip(i){let e=i[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=i[1];t&&t.isStackTrace?i[0]+=" "+t.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function Ze(...i){i=Ip(i);let e="THREE."+i.shift();if(Hr)Hr("warn",e,...i);else{let t=i[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...i)}}function Qe(...i){i=Ip(i);let e="THREE."+i.shift();if(Hr)Hr("error",e,...i);else{let t=i[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...i)}}function Lo(...i){let e=i.join(" ");e in Rf||(Rf[e]=!0,Ze(...i))}function Lp(i,e,t){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(e,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:n()}}setTimeout(r,t)})}var Np={[dl]:dl,[pl]:xl,[ml]:ml,[Vr]:gl,[fl]:fl,[xl]:pl,[_l]:_l,[gl]:Vr},Vi=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[e]===void 0&&(n[e]=[]),n[e].indexOf(t)===-1&&n[e].push(t)}hasEventListener(e,t){let n=this._listeners;return n===void 0?!1:n[e]!==void 0&&n[e].indexOf(t)!==-1}removeEventListener(e,t){let n=this._listeners;if(n===void 0)return;let s=n[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let n=t[e.type];if(n!==void 0){e.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Pn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Pu=Math.PI/180,Ml=180/Math.PI;function nr(){let i=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(Pn[i&255]+Pn[i>>8&255]+Pn[i>>16&255]+Pn[i>>24&255]+"-"+Pn[e&255]+Pn[e>>8&255]+"-"+Pn[e>>16&15|64]+Pn[e>>24&255]+"-"+Pn[t&63|128]+Pn[t>>8&255]+"-"+Pn[t>>16&255]+Pn[t>>24&255]+Pn[n&255]+Pn[n>>8&255]+Pn[n>>16&255]+Pn[n>>24&255]).toLowerCase()}function xt(i,e,t){return Math.max(e,Math.min(t,i))}function Ax(i,e){return(i%e+e)%e}function Iu(i,e,t){return(1-t)*i+t*e}function Dp(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function Pc(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Fp(i,e){if(e.constructor===Float32Array)return i;let t=Pc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/t,-1)}function Up(i,e){if(e.constructor===Float32Array)return i;let t=Pc(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*t)}var ot=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,n=this.y,s=e.elements;return this.x=s[0]*t+s[3]*n+s[6],this.y=s[1]*t+s[4]*n+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y;return t*t+n*n}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let n=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*n-o*s+e.x,this.y=r*s+o*n+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},di=class{constructor(e=0,t=0,n=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=n,this._w=s}static slerpFlat(e,t,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3],d=r[o+0],f=r[o+1],g=r[o+2],M=r[o+3];if(h!==M||l!==d||c!==f||u!==g){let m=l*d+c*f+u*g+h*M;m<0&&(d=-d,f=-f,g=-g,M=-M,m=-m);let p=1-a;if(m<.9995){let v=Math.acos(m),T=Math.sin(v);p=Math.sin(p*v)/T,a=Math.sin(a*v)/T,l=l*p+d*a,c=c*p+f*a,u=u*p+g*a,h=h*p+M*a}else{l=l*p+d*a,c=c*p+f*a,u=u*p+g*a,h=h*p+M*a;let v=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=v,c*=v,u*=v,h*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,n,s,r,o){let a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],d=r[o+1],f=r[o+2],g=r[o+3];return e[t]=a*g+u*h+l*f-c*d,e[t+1]=l*g+u*d+c*h-a*f,e[t+2]=c*g+u*f+a*d-l*h,e[t+3]=u*g-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,n,s){return this._x=e,this._y=t,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let n=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),d=l(n/2),f=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"YXZ":this._x=d*u*h+c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"ZXY":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h-d*f*g;break;case"ZYX":this._x=d*u*h-c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h+d*f*g;break;case"YZX":this._x=d*u*h+c*f*g,this._y=c*f*h+d*u*g,this._z=c*u*g-d*f*h,this._w=c*u*h-d*f*g;break;case"XZY":this._x=d*u*h-c*f*g,this._y=c*f*h-d*u*g,this._z=c*u*g+d*f*h,this._w=c*u*h+d*f*g;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let n=t/2,s=Math.sin(n);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,n=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=n+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(n>a&&n>h){let f=2*Math.sqrt(1+n-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-n-h);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-n-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let n=e.dot(t)+1;return n<1e-8?(n=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=n):(this._x=0,this._y=-e.z,this._z=e.y,this._w=n)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=n),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(xt(this.dot(e),-1,1)))}rotateTowards(e,t){let n=this.angleTo(e);if(n===0)return this;let s=Math.min(1,t/n);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let n=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+n*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,n){return this.copy(e).slerp(t,n)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},q=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,n=0){this.x=e,this.y=t,this.z=n}set(e,t,n){return n===void 0&&(n=this.z),this.x=e,this.y=t,this.z=n,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Cf.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Cf.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*n+r[6]*s,this.y=r[1]*t+r[4]*n+r[7]*s,this.z=r[2]*t+r[5]*n+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,n=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*n),u=2*(a*t-r*s),h=2*(r*n-o*t);return this.x=t+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,n=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*n+r[8]*s,this.y=r[1]*t+r[5]*n+r[9]*s,this.z=r[2]*t+r[6]*n+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let n=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let n=e.dot(this)/t;return this.copy(e).multiplyScalar(n)}projectOnPlane(e){return Lu.copy(this).projectOnVector(e),this.sub(Lu)}reflect(e){return this.sub(Lu.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let n=this.dot(e)/t;return Math.acos(xt(n,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,n=this.y-e.y,s=this.z-e.z;return t*t+n*n+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,n){let s=Math.sin(t)*e;return this.x=s*Math.sin(n),this.y=Math.cos(t)*e,this.z=s*Math.cos(n),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,n){return this.x=e*Math.sin(t),this.y=n,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),n=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=n,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,n=Math.sqrt(1-t*t);return this.x=n*Math.cos(e),this.y=t,this.z=n*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Lu=new q,Cf=new di,et=class{static{this.prototype.isMatrix3=!0}constructor(e,t,n,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c)}set(e,t,n,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],this}extractBasis(e,t,n){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],d=n[2],f=n[5],g=n[8],M=s[0],m=s[3],p=s[6],v=s[1],T=s[4],b=s[7],C=s[2],E=s[5],_=s[8];return r[0]=o*M+a*v+l*C,r[3]=o*m+a*T+l*E,r[6]=o*p+a*b+l*_,r[1]=c*M+u*v+h*C,r[4]=c*m+u*T+h*E,r[7]=c*p+u*b+h*_,r[2]=d*M+f*v+g*C,r[5]=d*m+f*T+g*E,r[8]=d*p+f*b+g*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*r,f=c*r-o*l,g=t*h+n*d+s*f;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let M=1/g;return e[0]=h*M,e[1]=(s*c-u*n)*M,e[2]=(a*n-s*o)*M,e[3]=d*M,e[4]=(u*t-s*l)*M,e[5]=(s*r-a*t)*M,e[6]=f*M,e[7]=(n*l-c*t)*M,e[8]=(o*t-n*r)*M,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,n,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Lo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Nu.makeScale(e,t)),this}rotate(e){return Lo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Nu.makeRotation(-e)),this}translate(e,t){return Lo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Nu.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,n,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<9;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<9;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Nu=new et,Pf=new et().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),If=new et().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Ex(){let i={enabled:!0,workingColorSpace:Do,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===wt&&(s.r=rs(s.r),s.g=rs(s.g),s.b=rs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===wt&&(s.r=zr(s.r),s.g=zr(s.g),s.b=zr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ps?Fo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Do]:{primaries:e,whitePoint:n,transfer:Fo,toXYZ:Pf,fromXYZ:If,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:ti},outputColorSpaceConfig:{drawingBufferColorSpace:ti}},[ti]:{primaries:e,whitePoint:n,transfer:wt,toXYZ:Pf,fromXYZ:If,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:ti}}}),i}var mt=Ex();function rs(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function zr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Tr,Sl=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let n;if(e instanceof HTMLCanvasElement)n=e;else{Tr===void 0&&(Tr=Uo("canvas")),Tr.width=e.width,Tr.height=e.height;let s=Tr.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),n=Tr}return n.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Uo("canvas");t.width=e.width,t.height=e.height;let n=t.getContext("2d");n.drawImage(e,0,0,e.width,e.height);let s=n.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=rs(r[o]/255)*255;return n.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let n=0;n<t.length;n++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[n]=Math.floor(rs(t[n]/255)*255):t[n]=rs(t[n]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Tx=0,Wr=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Tx++}),this.uuid=nr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Du(s[o].image)):r.push(Du(s[o]))}else r=Du(s);n.url=r}return t||(e.images[this.uuid]=n),n}};function Du(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?Sl.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var Rx=0,Fu=new q,Wn=class i extends Vi{constructor(e=i.DEFAULT_IMAGE,t=i.DEFAULT_MAPPING,n=zi,s=zi,r=Vn,o=ds,a=Ri,l=Yn,c=i.DEFAULT_ANISOTROPY,u=ps){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Rx++}),this.uuid=nr(),this.name="",this.source=new Wr(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new ot(0,0),this.repeat=new ot(1,1),this.center=new ot(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new et,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Fu).x}get height(){return this.source.getSize(Fu).y}get depth(){return this.source.getSize(Fu).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let n=e[t];if(n===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),t||(e.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==_h)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case vl:e.x=e.x-Math.floor(e.x);break;case zi:e.x=e.x<0?0:1;break;case yl:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case vl:e.y=e.y-Math.floor(e.y);break;case zi:e.y=e.y<0?0:1;break;case yl:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Wn.DEFAULT_IMAGE=null;Wn.DEFAULT_MAPPING=_h;Wn.DEFAULT_ANISOTROPY=1;var Wt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,n=0,s=1){this.x=e,this.y=t,this.z=n,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,n,s){return this.x=e,this.y=t,this.z=n,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,n=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*n+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,n,s,r,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],g=l[9],M=l[2],m=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-M)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+M)<.1&&Math.abs(g+m)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,b=(f+1)/2,C=(p+1)/2,E=(u+d)/4,_=(h+M)/4,A=(g+m)/4;return T>b&&T>C?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=E/n,r=_/n):b>C?b<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),n=E/s,r=A/s):C<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(C),n=_/r,s=A/r),this.set(n,s,r,t),this}let v=Math.sqrt((m-g)*(m-g)+(h-M)*(h-M)+(d-u)*(d-u));return Math.abs(v)<.001&&(v=1),this.x=(m-g)/v,this.y=(h-M)/v,this.z=(d-u)/v,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=xt(this.x,e.x,t.x),this.y=xt(this.y,e.y,t.y),this.z=xt(this.z,e.z,t.z),this.w=xt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=xt(this.x,e,t),this.y=xt(this.y,e,t),this.z=xt(this.z,e,t),this.w=xt(this.w,e,t),this}clampLength(e,t){let n=this.length();return this.divideScalar(n||1).multiplyScalar(xt(n,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,n){return this.x=e.x+(t.x-e.x)*n,this.y=e.y+(t.y-e.y)*n,this.z=e.z+(t.z-e.z)*n,this.w=e.w+(t.w-e.w)*n,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},wl=class extends Vi{constructor(e=1,t=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Vn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=n.depth,this.scissor=new Wt(0,0,e,t),this.scissorTest=!1,this.viewport=new Wt(0,0,e,t),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new Wn({width:e,height:t,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:Vn,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,n=1){if(this.width!==e||this.height!==t||this.depth!==n){this.width=e,this.height=t,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,n=e.textures.length;t<n;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Wr(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ni=class extends wl{constructor(e=1,t=1,n={}){super(e,t,n),this.isWebGLRenderTarget=!0}},Bo=class extends Wn{constructor(e=null,t=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=An,this.minFilter=An,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Al=class extends Wn{constructor(e=null,t=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:n,depth:s},this.magFilter=An,this.minFilter=An,this.wrapR=zi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var Ht=class i{static{this.prototype.isMatrix4=!0}constructor(e,t,n,s,r,o,a,l,c,u,h,d,f,g,M,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,M,m)}set(e,t,n,s,r,o,a,l,c,u,h,d,f,g,M,m){let p=this.elements;return p[0]=e,p[4]=t,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=g,p[11]=M,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(e){let t=this.elements,n=e.elements;return t[0]=n[0],t[1]=n[1],t[2]=n[2],t[3]=n[3],t[4]=n[4],t[5]=n[5],t[6]=n[6],t[7]=n[7],t[8]=n[8],t[9]=n[9],t[10]=n[10],t[11]=n[11],t[12]=n[12],t[13]=n[13],t[14]=n[14],t[15]=n[15],this}copyPosition(e){let t=this.elements,n=e.elements;return t[12]=n[12],t[13]=n[13],t[14]=n[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,n){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),n.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(e,t,n){return this.set(e.x,t.x,n.x,0,e.y,t.y,n.y,0,e.z,t.z,n.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,n=e.elements,s=1/Rr.setFromMatrixColumn(e,0).length(),r=1/Rr.setFromMatrixColumn(e,1).length(),o=1/Rr.setFromMatrixColumn(e,2).length();return t[0]=n[0]*s,t[1]=n[1]*s,t[2]=n[2]*s,t[3]=0,t[4]=n[4]*r,t[5]=n[5]*r,t[6]=n[6]*r,t[7]=0,t[8]=n[8]*o,t[9]=n[9]*o,t[10]=n[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,n=e.x,s=e.y,r=e.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(e.order==="XYZ"){let d=o*u,f=o*h,g=a*u,M=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+g*c,t[5]=d-M*c,t[9]=-a*l,t[2]=M-d*c,t[6]=g+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,g=c*u,M=c*h;t[0]=d+M*a,t[4]=g*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-g,t[6]=M+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,g=c*u,M=c*h;t[0]=d-M*a,t[4]=-o*h,t[8]=g+f*a,t[1]=f+g*a,t[5]=o*u,t[9]=M-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,g=a*u,M=a*h;t[0]=l*u,t[4]=g*c-f,t[8]=d*c+M,t[1]=l*h,t[5]=M*c+d,t[9]=f*c-g,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,g=a*l,M=a*c;t[0]=l*u,t[4]=M-d*h,t[8]=g*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+g,t[10]=d-M*h}else if(e.order==="XZY"){let d=o*l,f=o*c,g=a*l,M=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+M,t[5]=o*u,t[9]=f*h-g,t[2]=g*h-f,t[6]=a*u,t[10]=M*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Cx,e,Px)}lookAt(e,t,n){let s=this.elements;return Qn.subVectors(e,t),Qn.lengthSq()===0&&(Qn.z=1),Qn.normalize(),Ss.crossVectors(n,Qn),Ss.lengthSq()===0&&(Math.abs(n.z)===1?Qn.x+=1e-4:Qn.z+=1e-4,Qn.normalize(),Ss.crossVectors(n,Qn)),Ss.normalize(),Wa.crossVectors(Qn,Ss),s[0]=Ss.x,s[4]=Wa.x,s[8]=Qn.x,s[1]=Ss.y,s[5]=Wa.y,s[9]=Qn.y,s[2]=Ss.z,s[6]=Wa.z,s[10]=Qn.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let n=e.elements,s=t.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],d=n[9],f=n[13],g=n[2],M=n[6],m=n[10],p=n[14],v=n[3],T=n[7],b=n[11],C=n[15],E=s[0],_=s[4],A=s[8],B=s[12],D=s[1],N=s[5],k=s[9],G=s[13],L=s[2],H=s[6],Y=s[10],V=s[14],le=s[3],J=s[7],j=s[11],ie=s[15];return r[0]=o*E+a*D+l*L+c*le,r[4]=o*_+a*N+l*H+c*J,r[8]=o*A+a*k+l*Y+c*j,r[12]=o*B+a*G+l*V+c*ie,r[1]=u*E+h*D+d*L+f*le,r[5]=u*_+h*N+d*H+f*J,r[9]=u*A+h*k+d*Y+f*j,r[13]=u*B+h*G+d*V+f*ie,r[2]=g*E+M*D+m*L+p*le,r[6]=g*_+M*N+m*H+p*J,r[10]=g*A+M*k+m*Y+p*j,r[14]=g*B+M*G+m*V+p*ie,r[3]=v*E+T*D+b*L+C*le,r[7]=v*_+T*N+b*H+C*J,r[11]=v*A+T*k+b*Y+C*j,r[15]=v*B+T*G+b*V+C*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],g=e[3],M=e[7],m=e[11],p=e[15],v=l*f-c*d,T=a*f-c*h,b=a*d-l*h,C=o*f-c*u,E=o*d-l*u,_=o*h-a*u;return t*(M*v-m*T+p*b)-n*(g*v-m*C+p*E)+s*(g*T-M*C+p*_)-r*(g*b-M*E+m*_)}determinantAffine(){let e=this.elements,t=e[0],n=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-n*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,n){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=n),this}invert(){let e=this.elements,t=e[0],n=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],g=e[12],M=e[13],m=e[14],p=e[15],v=t*a-n*o,T=t*l-s*o,b=t*c-r*o,C=n*l-s*a,E=n*c-r*a,_=s*c-r*l,A=u*M-h*g,B=u*m-d*g,D=u*p-f*g,N=h*m-d*M,k=h*p-f*M,G=d*p-f*m,L=v*G-T*k+b*N+C*D-E*B+_*A;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/L;return e[0]=(a*G-l*k+c*N)*H,e[1]=(s*k-n*G-r*N)*H,e[2]=(M*_-m*E+p*C)*H,e[3]=(d*E-h*_-f*C)*H,e[4]=(l*D-o*G-c*B)*H,e[5]=(t*G-s*D+r*B)*H,e[6]=(m*b-g*_-p*T)*H,e[7]=(u*_-d*b+f*T)*H,e[8]=(o*k-a*D+c*A)*H,e[9]=(n*D-t*k-r*A)*H,e[10]=(g*E-M*b+p*v)*H,e[11]=(h*b-u*E-f*v)*H,e[12]=(a*B-o*N-l*A)*H,e[13]=(t*N-n*B+s*A)*H,e[14]=(M*T-g*C-m*v)*H,e[15]=(u*C-h*T+d*v)*H,this}scale(e){let t=this.elements,n=e.x,s=e.y,r=e.z;return t[0]*=n,t[4]*=s,t[8]*=r,t[1]*=n,t[5]*=s,t[9]*=r,t[2]*=n,t[6]*=s,t[10]*=r,t[3]*=n,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],n=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,n,s))}makeTranslation(e,t,n){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,n,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),n=Math.sin(e);return this.set(1,0,0,0,0,t,-n,0,0,n,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,0,n,0,0,1,0,0,-n,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),n=Math.sin(e);return this.set(t,-n,0,0,n,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let n=Math.cos(t),s=Math.sin(t),r=1-n,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(e,t,n){return this.set(e,0,0,0,0,t,0,0,0,0,n,0,0,0,0,1),this}makeShear(e,t,n,s,r,o){return this.set(1,n,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,n){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,h=a+a,d=r*c,f=r*u,g=r*h,M=o*u,m=o*h,p=a*h,v=l*c,T=l*u,b=l*h,C=n.x,E=n.y,_=n.z;return s[0]=(1-(M+p))*C,s[1]=(f+b)*C,s[2]=(g-T)*C,s[3]=0,s[4]=(f-b)*E,s[5]=(1-(d+p))*E,s[6]=(m+v)*E,s[7]=0,s[8]=(g+T)*_,s[9]=(m-v)*_,s[10]=(1-(d+M))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,n){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),t.identity(),this;let o=Rr.set(s[0],s[1],s[2]).length(),a=Rr.set(s[4],s[5],s[6]).length(),l=Rr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),bi.copy(this);let c=1/o,u=1/a,h=1/l;return bi.elements[0]*=c,bi.elements[1]*=c,bi.elements[2]*=c,bi.elements[4]*=u,bi.elements[5]*=u,bi.elements[6]*=u,bi.elements[8]*=h,bi.elements[9]*=h,bi.elements[10]*=h,t.setFromRotationMatrix(bi),n.x=o,n.y=a,n.z=l,this}makePerspective(e,t,n,s,r,o,a=hi,l=!1){let c=this.elements,u=2*r/(t-e),h=2*r/(n-s),d=(t+e)/(t-e),f=(n+s)/(n-s),g,M;if(l)g=r/(o-r),M=o*r/(o-r);else if(a===hi)g=-(o+r)/(o-r),M=-2*o*r/(o-r);else if(a===Gr)g=-o/(o-r),M=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,n,s,r,o,a=hi,l=!1){let c=this.elements,u=2/(t-e),h=2/(n-s),d=-(t+e)/(t-e),f=-(n+s)/(n-s),g,M;if(l)g=1/(o-r),M=o/(o-r);else if(a===hi)g=-2/(o-r),M=-(o+r)/(o-r);else if(a===Gr)g=-1/(o-r),M=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=g,c[14]=M,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,n=e.elements;for(let s=0;s<16;s++)if(t[s]!==n[s])return!1;return!0}fromArray(e,t=0){for(let n=0;n<16;n++)this.elements[n]=e[n+t];return this}toArray(e=[],t=0){let n=this.elements;return e[t]=n[0],e[t+1]=n[1],e[t+2]=n[2],e[t+3]=n[3],e[t+4]=n[4],e[t+5]=n[5],e[t+6]=n[6],e[t+7]=n[7],e[t+8]=n[8],e[t+9]=n[9],e[t+10]=n[10],e[t+11]=n[11],e[t+12]=n[12],e[t+13]=n[13],e[t+14]=n[14],e[t+15]=n[15],e}},Rr=new q,bi=new Ht,Cx=new q(0,0,0),Px=new q(1,1,1),Ss=new q,Wa=new q,Qn=new q,Lf=new Ht,Nf=new di,Gi=class i{constructor(e=0,t=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=n,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,n,s=this._order){return this._x=e,this._y=t,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,n=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],d=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(xt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-xt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(xt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-xt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(xt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-xt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,n===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,n){return Lf.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Lf,t,n)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Nf.setFromEuler(this),this.setFromQuaternion(Nf,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Gi.DEFAULT_ORDER="XYZ";var ko=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Ix=0,Df=new q,Cr=new di,es=new Ht,Xa=new q,Ro=new q,Lx=new q,Nx=new di,Ff=new q(1,0,0),Uf=new q(0,1,0),Of=new q(0,0,1),Bf={type:"added"},Dx={type:"removed"},Pr={type:"childadded",child:null},Uu={type:"childremoved",child:null},Ln=class i extends Vi{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Ix++}),this.uuid=nr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let e=new q,t=new Gi,n=new di,s=new q(1,1,1);function r(){n.setFromEuler(t,!1)}function o(){t.setFromQuaternion(n,void 0,!1)}t._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Ht},normalMatrix:{value:new et}}),this.matrix=new Ht,this.matrixWorld=new Ht,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ko,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Cr.setFromAxisAngle(e,t),this.quaternion.multiply(Cr),this}rotateOnWorldAxis(e,t){return Cr.setFromAxisAngle(e,t),this.quaternion.premultiply(Cr),this}rotateX(e){return this.rotateOnAxis(Ff,e)}rotateY(e){return this.rotateOnAxis(Uf,e)}rotateZ(e){return this.rotateOnAxis(Of,e)}translateOnAxis(e,t){return Df.copy(e).applyQuaternion(this.quaternion),this.position.add(Df.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ff,e)}translateY(e){return this.translateOnAxis(Uf,e)}translateZ(e){return this.translateOnAxis(Of,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(es.copy(this.matrixWorld).invert())}lookAt(e,t,n){e.isVector3?Xa.copy(e):Xa.set(e,t,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Ro.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?es.lookAt(Ro,Xa,this.up):es.lookAt(Xa,Ro,this.up),this.quaternion.setFromRotationMatrix(es),s&&(es.extractRotation(s.matrixWorld),Cr.setFromRotationMatrix(es),this.quaternion.premultiply(Cr.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(Qe("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(Bf),Pr.child=e,this.dispatchEvent(Pr),Pr.child=null):Qe("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Dx),Uu.child=e,this.dispatchEvent(Uu),Uu.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),es.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),es.multiply(e.parent.matrixWorld)),e.applyMatrix4(es),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(Bf),Pr.child=e,this.dispatchEvent(Pr),Pr.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,n=[]){this[e]===t&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,n);return n}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,e,Lx),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ro,Nx,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,n=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*n-r[8]*s,r[13]+=n-r[1]*t-r[5]*n-r[9]*s,r[14]+=s-r[2]*t-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let n=0,s=t.length;n<s;n++)t[n].updateMatrixWorld(e)}updateWorldMatrix(e,t,n=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(e){let t=e===void 0||typeof e=="string",n={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];r(e.shapes,h)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),g=o(e.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let n=0;n<e.children.length;n++){let s=e.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ln.DEFAULT_UP=new q(0,1,0);Ln.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ln.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var cn=class extends Ln{constructor(){super(),this.isGroup=!0,this.type="Group"}},Fx={type:"move"},Xr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new cn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new cn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new q,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new q),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new cn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new q,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new q,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let n of e.hand.values())this._getHandJoint(t,n)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,n){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let M of e.hand.values()){let m=t.getJointPose(M,n),p=this._getHandJoint(c,M);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,g=.005;c.inputState.pinching&&d>f+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Fx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let n=new cn;n.matrixAutoUpdate=!1,n.visible=!1,e.joints[t.jointName]=n,e.add(n)}return e.joints[t.jointName]}},Op={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ws={h:0,s:0,l:0},qa={h:0,s:0,l:0};function Ou(i,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?i+(e-i)*6*t:t<1/2?e:t<2/3?i+(e-i)*6*(2/3-t):i}var Ye=class{constructor(e,t,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,n)}set(e,t,n){if(t===void 0&&n===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,n);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=ti){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,mt.colorSpaceToWorking(this,t),this}setRGB(e,t,n,s=mt.workingColorSpace){return this.r=e,this.g=t,this.b=n,mt.colorSpaceToWorking(this,s),this}setHSL(e,t,n,s=mt.workingColorSpace){if(e=Ax(e,1),t=xt(t,0,1),n=xt(n,0,1),t===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+t):n+t-n*t,o=2*n-r;this.r=Ou(o,r,e+1/3),this.g=Ou(o,r,e),this.b=Ou(o,r,e-1/3)}return mt.colorSpaceToWorking(this,s),this}setStyle(e,t=ti){function n(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=ti){let n=Op[e.toLowerCase()];return n!==void 0?this.setHex(n,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=rs(e.r),this.g=rs(e.g),this.b=rs(e.b),this}copyLinearToSRGB(e){return this.r=zr(e.r),this.g=zr(e.g),this.b=zr(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=ti){return mt.workingToColorSpace(In.copy(this),e),Math.round(xt(In.r*255,0,255))*65536+Math.round(xt(In.g*255,0,255))*256+Math.round(xt(In.b*255,0,255))}getHexString(e=ti){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=mt.workingColorSpace){mt.workingToColorSpace(In.copy(this),t);let n=In.r,s=In.g,r=In.b,o=Math.max(n,s,r),a=Math.min(n,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=mt.workingColorSpace){return mt.workingToColorSpace(In.copy(this),t),e.r=In.r,e.g=In.g,e.b=In.b,e}getStyle(e=ti){mt.workingToColorSpace(In.copy(this),e);let t=In.r,n=In.g,s=In.b;return e!==ti?`color(${e} ${t.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(e,t,n){return this.getHSL(ws),this.setHSL(ws.h+e,ws.s+t,ws.l+n)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,n){return this.r=e.r+(t.r-e.r)*n,this.g=e.g+(t.g-e.g)*n,this.b=e.b+(t.b-e.b)*n,this}lerpHSL(e,t){this.getHSL(ws),e.getHSL(qa);let n=Iu(ws.h,qa.h,t),s=Iu(ws.s,qa.s,t),r=Iu(ws.l,qa.l,t);return this.setHSL(n,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,n=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*n+r[6]*s,this.g=r[1]*t+r[4]*n+r[7]*s,this.b=r[2]*t+r[5]*n+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},In=new Ye;Ye.NAMES=Op;var zo=class extends Ln{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Gi,this.environmentIntensity=1,this.environmentRotation=new Gi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Mi=new q,ts=new q,Bu=new q,ns=new q,Ir=new q,Lr=new q,kf=new q,ku=new q,zu=new q,Vu=new q,Gu=new Wt,Hu=new Wt,Wu=new Wt,Rs=class i{constructor(e=new q,t=new q,n=new q){this.a=e,this.b=t,this.c=n}static getNormal(e,t,n,s){s.subVectors(n,t),Mi.subVectors(e,t),s.cross(Mi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,n,s,r){Mi.subVectors(s,t),ts.subVectors(n,t),Bu.subVectors(e,t);let o=Mi.dot(Mi),a=Mi.dot(ts),l=Mi.dot(Bu),c=ts.dot(ts),u=ts.dot(Bu),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,g=(o*u-a*l)*d;return r.set(1-f-g,g,f)}static containsPoint(e,t,n,s){return this.getBarycoord(e,t,n,s,ns)===null?!1:ns.x>=0&&ns.y>=0&&ns.x+ns.y<=1}static getInterpolation(e,t,n,s,r,o,a,l){return this.getBarycoord(e,t,n,s,ns)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ns.x),l.addScaledVector(o,ns.y),l.addScaledVector(a,ns.z),l)}static getInterpolatedAttribute(e,t,n,s,r,o){return Gu.setScalar(0),Hu.setScalar(0),Wu.setScalar(0),Gu.fromBufferAttribute(e,t),Hu.fromBufferAttribute(e,n),Wu.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Gu,r.x),o.addScaledVector(Hu,r.y),o.addScaledVector(Wu,r.z),o}static isFrontFacing(e,t,n,s){return Mi.subVectors(n,t),ts.subVectors(e,t),Mi.cross(ts).dot(s)<0}set(e,t,n){return this.a.copy(e),this.b.copy(t),this.c.copy(n),this}setFromPointsAndIndices(e,t,n,s){return this.a.copy(e[t]),this.b.copy(e[n]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,n,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,n),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Mi.subVectors(this.c,this.b),ts.subVectors(this.a,this.b),Mi.cross(ts).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return i.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return i.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,n,s,r){return i.getInterpolation(e,this.a,this.b,this.c,t,n,s,r)}containsPoint(e){return i.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return i.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let n=this.a,s=this.b,r=this.c,o,a;Ir.subVectors(s,n),Lr.subVectors(r,n),ku.subVectors(e,n);let l=Ir.dot(ku),c=Lr.dot(ku);if(l<=0&&c<=0)return t.copy(n);zu.subVectors(e,s);let u=Ir.dot(zu),h=Lr.dot(zu);if(u>=0&&h<=u)return t.copy(s);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(n).addScaledVector(Ir,o);Vu.subVectors(e,r);let f=Ir.dot(Vu),g=Lr.dot(Vu);if(g>=0&&f<=g)return t.copy(r);let M=f*c-l*g;if(M<=0&&c>=0&&g<=0)return a=c/(c-g),t.copy(n).addScaledVector(Lr,a);let m=u*g-f*h;if(m<=0&&h-u>=0&&f-g>=0)return kf.subVectors(r,s),a=(h-u)/(h-u+(f-g)),t.copy(s).addScaledVector(kf,a);let p=1/(m+M+d);return o=M*p,a=d*p,t.copy(n).addScaledVector(Ir,o).addScaledVector(Lr,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Cs=class{constructor(e=new q(1/0,1/0,1/0),t=new q(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t+=3)this.expandByPoint(Si.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,n=e.count;t<n;t++)this.expandByPoint(Si.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,n=e.length;t<n;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let n=Si.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(n),this.max.copy(e).add(n),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let n=e.geometry;if(n!==void 0){let r=n.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Si):Si.fromBufferAttribute(r,o),Si.applyMatrix4(e.matrixWorld),this.expandByPoint(Si);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Ya.copy(e.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),Ya.copy(n.boundingBox)),Ya.applyMatrix4(e.matrixWorld),this.union(Ya)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Si),Si.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,n;return e.normal.x>0?(t=e.normal.x*this.min.x,n=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,n=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,n+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,n+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,n+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,n+=e.normal.z*this.min.z),t<=-e.constant&&n>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Co),$a.subVectors(this.max,Co),Nr.subVectors(e.a,Co),Dr.subVectors(e.b,Co),Fr.subVectors(e.c,Co),As.subVectors(Dr,Nr),Es.subVectors(Fr,Dr),Ys.subVectors(Nr,Fr);let t=[0,-As.z,As.y,0,-Es.z,Es.y,0,-Ys.z,Ys.y,As.z,0,-As.x,Es.z,0,-Es.x,Ys.z,0,-Ys.x,-As.y,As.x,0,-Es.y,Es.x,0,-Ys.y,Ys.x,0];return!Xu(t,Nr,Dr,Fr,$a)||(t=[1,0,0,0,1,0,0,0,1],!Xu(t,Nr,Dr,Fr,$a))?!1:(Za.crossVectors(As,Es),t=[Za.x,Za.y,Za.z],Xu(t,Nr,Dr,Fr,$a))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Si).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Si).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(is[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),is[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),is[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),is[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),is[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),is[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),is[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),is[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(is),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},is=[new q,new q,new q,new q,new q,new q,new q,new q],Si=new q,Ya=new Cs,Nr=new q,Dr=new q,Fr=new q,As=new q,Es=new q,Ys=new q,Co=new q,$a=new q,Za=new q,$s=new q;function Xu(i,e,t,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){$s.fromArray(i,r);let a=s.x*Math.abs($s.x)+s.y*Math.abs($s.y)+s.z*Math.abs($s.z),l=e.dot($s),c=t.dot($s),u=n.dot($s);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var ln=new q,Ja=new ot,Ux=0,pn=class extends Vi{constructor(e,t,n=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ux++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=n,this.usage=Ch,this.updateRanges=[],this.gpuType=Ei,this.version=0,this._normalizationScale=e!==void 0?Pc(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,n){e*=this.itemSize,n*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[n+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,n=this.count;t<n;t++)Ja.fromBufferAttribute(this,t),Ja.applyMatrix3(e),this.setXY(t,Ja.x,Ja.y);else if(this.itemSize===3)for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix3(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyMatrix4(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyMatrix4(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.applyNormalMatrix(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)ln.fromBufferAttribute(this,t),ln.transformDirection(e),this.setXYZ(t,ln.x,ln.y,ln.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let n=this.array[e*this.itemSize+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.array[e*this.itemSize+t]=n,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,n){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.array[e+0]=t,this.array[e+1]=n,this}setXYZ(e,t,n,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=n,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Fp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Up(e,this.array)}};var Vo=class extends pn{constructor(e,t,n){super(new Uint16Array(e),t,n)}};var Go=class extends pn{constructor(e,t,n){super(new Uint32Array(e),t,n)}};var un=class extends pn{constructor(e,t,n){super(new Float32Array(e),t,n)}},Ox=new Cs,Po=new q,qu=new q,qr=class{constructor(e=new q,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let n=this.center;t!==void 0?n.copy(t):Ox.setFromPoints(e).getCenter(n);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,n.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let n=this.center.distanceToSquared(e);return t.copy(e),n>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Po.subVectors(e,this.center);let t=Po.lengthSq();if(t>this.radius*this.radius){let n=Math.sqrt(t),s=(n-this.radius)*.5;this.center.addScaledVector(Po,s/n),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(qu.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Po.copy(e.center).add(qu)),this.expandByPoint(Po.copy(e.center).sub(qu))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Bx=0,ui=new Ht,Yu=new Ln,Ur=new q,ei=new Cs,Io=new Cs,wn=new q,Gn=class i extends Vi{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Bx++}),this.uuid=nr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(Sx(e)?Go:Vo)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,n=0){this.groups.push({start:e,count:t,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new et().getNormalMatrix(e);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return ui.makeRotationFromQuaternion(e),this.applyMatrix4(ui),this}rotateX(e){return ui.makeRotationX(e),this.applyMatrix4(ui),this}rotateY(e){return ui.makeRotationY(e),this.applyMatrix4(ui),this}rotateZ(e){return ui.makeRotationZ(e),this.applyMatrix4(ui),this}translate(e,t,n){return ui.makeTranslation(e,t,n),this.applyMatrix4(ui),this}scale(e,t,n){return ui.makeScale(e,t,n),this.applyMatrix4(ui),this}lookAt(e){return Yu.lookAt(e),Yu.updateMatrix(),this.applyMatrix4(Yu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ur).negate(),this.translate(Ur.x,Ur.y,Ur.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let n=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new un(n,3))}else{let n=Math.min(e.length,t.count);for(let s=0;s<n;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Cs);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new q(-1/0,-1/0,-1/0),new q(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let n=0,s=t.length;n<s;n++){let r=t[n];ei.setFromBufferAttribute(r),this.morphTargetsRelative?(wn.addVectors(this.boundingBox.min,ei.min),this.boundingBox.expandByPoint(wn),wn.addVectors(this.boundingBox.max,ei.max),this.boundingBox.expandByPoint(wn)):(this.boundingBox.expandByPoint(ei.min),this.boundingBox.expandByPoint(ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qe('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qr);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){Qe("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new q,1/0);return}if(e){let n=this.boundingSphere.center;if(ei.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Io.setFromBufferAttribute(a),this.morphTargetsRelative?(wn.addVectors(ei.min,Io.min),ei.expandByPoint(wn),wn.addVectors(ei.max,Io.max),ei.expandByPoint(wn)):(ei.expandByPoint(Io.min),ei.expandByPoint(Io.max))}ei.getCenter(n);let s=0;for(let r=0,o=e.count;r<o;r++)wn.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(wn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)wn.fromBufferAttribute(a,c),l&&(Ur.fromBufferAttribute(e,c),wn.add(Ur)),s=Math.max(s,n.distanceToSquared(wn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Qe('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){Qe("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new pn(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(n.count);for(let B=0;B<n.count;B++)a[B]=new q,l[B]=new q;let u=new q,h=new q,d=new q,f=new ot,g=new ot,M=new ot,m=new q,p=new q;function v(B,D,N){c[B]=c[D]=c[N]=1,u.fromBufferAttribute(n,B),h.fromBufferAttribute(n,D),d.fromBufferAttribute(n,N),f.fromBufferAttribute(r,B),g.fromBufferAttribute(r,D),M.fromBufferAttribute(r,N),h.sub(u),d.sub(u),g.sub(f),M.sub(f);let k=1/(g.x*M.y-M.x*g.y);isFinite(k)&&(m.copy(h).multiplyScalar(M.y).addScaledVector(d,-g.y).multiplyScalar(k),p.copy(d).multiplyScalar(g.x).addScaledVector(h,-M.x).multiplyScalar(k),a[B].add(m),a[D].add(m),a[N].add(m),l[B].add(p),l[D].add(p),l[N].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let B=0,D=T.length;B<D;++B){let N=T[B],k=N.start,G=N.count;for(let L=k,H=k+G;L<H;L+=3)v(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let b=new q,C=new q,E=new q,_=new q;function A(B){E.fromBufferAttribute(s,B),_.copy(E);let D=a[B];b.copy(D),b.sub(E.multiplyScalar(E.dot(D))).normalize(),C.crossVectors(_,D);let k=C.dot(l[B])<0?-1:1;o.setXYZW(B,b.x,b.y,b.z,k)}for(let B=0,D=n.count;B<D;++B)c[B]&&A(B);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==t.count)n=new pn(new Float32Array(t.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new q,r=new q,o=new q,a=new q,l=new q,c=new q,u=new q,h=new q;if(e)for(let d=0,f=e.count;d<f;d+=3){let g=e.getX(d+0),M=e.getX(d+1),m=e.getX(d+2);s.fromBufferAttribute(t,g),r.fromBufferAttribute(t,M),o.fromBufferAttribute(t,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,M),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(M,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)s.fromBufferAttribute(t,d+0),r.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(d+0,u.x,u.y,u.z),n.setXYZ(d+1,u.x,u.y,u.z),n.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,n=e.count;t<n;t++)wn.fromBufferAttribute(e,t),wn.normalize(),e.setXYZ(t,wn.x,wn.y,wn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,g=0;for(let M=0,m=l.length;M<m;M++){a.isInterleavedBufferAttribute?f=l[M]*a.data.stride+a.offset:f=l[M]*u;for(let p=0;p<u;p++)d[g++]=c[f++]}return new pn(d,u,h)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new i,n=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,n);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,n);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let n=this.attributes;for(let l in n){let c=n[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let n=e.index;n!==null&&this.setIndex(n.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],h=r[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},El=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Ch,this.updateRanges=[],this.version=0,this.uuid=nr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,n){e*=this.stride,n*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[n+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=zf(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let n=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=zf(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function zf(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=nr()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var kn=new q,Ps=class i{constructor(e,t,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=n,this.normalized=s,this._normalizationScale=e!==void 0?Pc(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,n=this.data.count;t<n;t++)kn.fromBufferAttribute(this,t),kn.applyMatrix4(e),this.setXYZ(t,kn.x,kn.y,kn.z);return this}applyNormalMatrix(e){for(let t=0,n=this.count;t<n;t++)kn.fromBufferAttribute(this,t),kn.applyNormalMatrix(e),this.setXYZ(t,kn.x,kn.y,kn.z);return this}transformDirection(e){for(let t=0,n=this.count;t<n;t++)kn.fromBufferAttribute(this,t),kn.transformDirection(e),this.setXYZ(t,kn.x,kn.y,kn.z);return this}getComponent(e,t){let n=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(n=this._denormalize(n)),n}setComponent(e,t,n){return this.normalized&&(n=this._normalize(n)),this.data.array[e*this.data.stride+this.offset+t]=n,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,n){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n)),this.data.array[e+0]=t,this.data.array[e+1]=n,this}setXYZ(e,t,n,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this}setXYZW(e,t,n,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=n,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Oo("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new pn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new i(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Oo("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Fp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Up(e,this.data.array)}},$u=new q,kx=new q,zx=new et,wi=class{constructor(e=new q(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,n,s){return this.normal.set(e,t,n),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,n){let s=$u.subVectors(n,t).cross(kx.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,n=!0){let s=e.delta($u),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),n=this.distanceToPoint(e.end);return t<0&&n>0||n<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let n=t||zx.getNormalMatrix(e),s=this.coplanarPoint($u).applyMatrix4(e),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Vx=0,Hi=class extends Vi{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vx++}),this.uuid=nr(),this.name="",this.type="Material",this.blending=Kr,this.side=qn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ch,this.blendDst=uh,this.blendEquation=Qs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ye(0,0,0),this.blendAlpha=0,this.depthFunc=Vr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=wp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hl,this.stencilZFail=hl,this.stencilZPass=hl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let n=e[t];if(n===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[t]=n}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(e).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(e).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(e).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(e).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(e).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new Ye().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(n=>new wi().fromJSON(n))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let n=e.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new ot().fromArray(n)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new ot().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,n=null;if(t!==null){let s=t.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=t[r].clone()}return this.clippingPlanes=n,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var ss=new q,Zu=new q,Ka=new q,ja=new q,Tl=class{constructor(e=new q,t=new q(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,ss)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let n=t.dot(this.direction);return n<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=ss.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(ss.copy(this.origin).addScaledVector(this.direction,t),ss.distanceToSquared(e))}distanceSqToSegment(e,t,n,s){Zu.copy(e).add(t).multiplyScalar(.5),Ka.copy(t).sub(e).normalize(),ja.copy(this.origin).sub(Zu);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Ka),a=ja.dot(this.direction),l=-ja.dot(Ka),c=ja.lengthSq(),u=Math.abs(1-o*o),h,d,f,g;if(u>0)if(h=o*l-a,d=o*a-l,g=r*u,h>=0)if(d>=-g)if(d<=g){let M=1/u;h*=M,d*=M,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-g?(h=Math.max(0,-(-o*r+a)),d=h>0?-r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c):d<=g?(h=0,d=Math.min(Math.max(-r,-l),r),f=d*(d+2*l)+c):(h=Math.max(0,-(o*r+a)),d=h>0?r:Math.min(Math.max(-r,-l),r),f=-h*h+d*(d+2*l)+c);else d=o>0?-r:r,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(Zu).addScaledVector(Ka,d),f}intersectSphere(e,t){if(e.radius<0)return null;ss.subVectors(e.center,this.origin);let n=ss.dot(this.direction),s=ss.dot(ss)-n*n,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(e.normal)+e.constant)/t;return n>=0?n:null}intersectPlane(e,t){let n=this.distanceToPlane(e);return n===null?null:this.at(n,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let n,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(n=(e.min.x-d.x)*c,s=(e.max.x-d.x)*c):(n=(e.max.x-d.x)*c,s=(e.min.x-d.x)*c),u>=0?(r=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(r=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,t)}intersectsBox(e){return this.intersectBox(e,ss)!==null}intersectTriangle(e,t,n,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,g=t.x-o.x,M=t.y-o.y,m=t.z-o.z,p=n.x-o.x,v=n.y-o.y,T=n.z-o.z,b=Math.abs(l),C=Math.abs(c),E=Math.abs(u),_,A,B,D,N,k,G,L,H,Y,V,le;if(b>=C&&b>=E?(B=l,k=h,H=g,le=p,l>=0?(_=c,A=u,D=d,N=f,G=M,L=m,Y=v,V=T):(_=u,A=c,D=f,N=d,G=m,L=M,Y=T,V=v)):C>=E?(B=c,k=d,H=M,le=v,c>=0?(_=u,A=l,D=f,N=h,G=m,L=g,Y=T,V=p):(_=l,A=u,D=h,N=f,G=g,L=m,Y=p,V=T)):(B=u,k=f,H=m,le=T,u>=0?(_=l,A=c,D=h,N=d,G=g,L=M,Y=p,V=v):(_=c,A=l,D=d,N=h,G=M,L=g,Y=v,V=p)),B===0)return null;let J=_/B,j=A/B,ie=1/B,de=D-J*k,ue=N-j*k,Q=G-J*H,me=L-j*H,_e=Y-J*le,Te=V-j*le,Me=_e*me-Te*Q,He=de*Te-ue*_e,it=Q*ue-me*de;if(s){if(Me<0||He<0||it<0)return null}else if((Me<0||He<0||it<0)&&(Me>0||He>0||it>0))return null;let Ve=Me+He+it;if(Ve===0)return null;let ut=ie*(Me*k+He*H+it*le);return(Ve>0?ut<0:ut>0)?null:this.at(ut/Ve,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Is=class extends Hi{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Gi,this.combine=ta,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Vf=new Ht,Zs=new Tl,Qa=new qr,Gf=new q,el=new q,tl=new q,nl=new q,Ju=new q,il=new q,Hf=new q,sl=new q,yt=class extends Ln{constructor(e=new Gn,t=new Is){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,n=Object.keys(t);if(n.length>0){let s=t[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){il.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],h=r[l];u!==0&&(Ju.fromBufferAttribute(h,e),o?il.addScaledVector(Ju,u):il.addScaledVector(Ju.sub(t),u))}t.add(il)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Qa.copy(n.boundingSphere),Qa.applyMatrix4(r),Zs.copy(e.ray).recast(e.near),!(Qa.containsPoint(Zs.origin)===!1&&(Zs.intersectSphere(Qa,Gf)===null||Zs.origin.distanceToSquared(Gf)>(e.far-e.near)**2))&&(Vf.copy(r).invert(),Zs.copy(e.ray).applyMatrix4(Vf),!(n.boundingBox!==null&&Zs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(e,t,Zs)))}_computeIntersections(e,t,n){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,M=d.length;g<M;g++){let m=d[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),T=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,C=T;b<C;b+=3){let E=a.getX(b),_=a.getX(b+1),A=a.getX(b+2);s=rl(this,p,e,n,c,u,h,E,_,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),M=Math.min(a.count,f.start+f.count);for(let m=g,p=M;m<p;m+=3){let v=a.getX(m),T=a.getX(m+1),b=a.getX(m+2);s=rl(this,o,e,n,c,u,h,v,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,M=d.length;g<M;g++){let m=d[g],p=o[m.materialIndex],v=Math.max(m.start,f.start),T=Math.min(l.count,Math.min(m.start+m.count,f.start+f.count));for(let b=v,C=T;b<C;b+=3){let E=b,_=b+1,A=b+2;s=rl(this,p,e,n,c,u,h,E,_,A),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let g=Math.max(0,f.start),M=Math.min(l.count,f.start+f.count);for(let m=g,p=M;m<p;m+=3){let v=m,T=m+1,b=m+2;s=rl(this,o,e,n,c,u,h,v,T,b),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Gx(i,e,t,n,s,r,o,a){let l;if(e.side===en?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,e.side===qn,a),l===null)return null;sl.copy(a),sl.applyMatrix4(i.matrixWorld);let c=t.ray.origin.distanceTo(sl);return c<t.near||c>t.far?null:{distance:c,point:sl.clone(),object:i}}function rl(i,e,t,n,s,r,o,a,l,c){i.getVertexPosition(a,el),i.getVertexPosition(l,tl),i.getVertexPosition(c,nl);let u=Gx(i,e,t,n,el,tl,nl,Hf);if(u){let h=new q;Rs.getBarycoord(Hf,el,tl,nl,h),s&&(u.uv=Rs.getInterpolatedAttribute(s,a,l,c,h,new ot)),r&&(u.uv1=Rs.getInterpolatedAttribute(r,a,l,c,h,new ot)),o&&(u.normal=Rs.getInterpolatedAttribute(o,a,l,c,h,new q),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new q,materialIndex:0};Rs.getNormal(el,tl,nl,d.normal),u.face=d,u.barycoord=h}return u}var Rl=class extends Wn{constructor(e=null,t=1,n=1,s,r,o,a,l,c=An,u=An,h,d){super(null,o,a,l,c,u,s,r,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Js=new qr,Hx=new ot(.5,.5),ol=new q,Ls=class{constructor(e=new wi,t=new wi,n=new wi,s=new wi,r=new wi,o=new wi){this.planes=[e,t,n,s,r,o]}set(e,t,n,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let n=0;n<6;n++)t[n].copy(e.planes[n]);return this}setFromProjectionMatrix(e,t=hi,n=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],d=r[6],f=r[7],g=r[8],M=r[9],m=r[10],p=r[11],v=r[12],T=r[13],b=r[14],C=r[15];if(s[0].setComponents(c-o,f-u,p-g,C-v).normalize(),s[1].setComponents(c+o,f+u,p+g,C+v).normalize(),s[2].setComponents(c+a,f+h,p+M,C+T).normalize(),s[3].setComponents(c-a,f-h,p-M,C-T).normalize(),n)s[4].setComponents(l,d,m,b).normalize(),s[5].setComponents(c-l,f-d,p-m,C-b).normalize();else if(s[4].setComponents(c-l,f-d,p-m,C-b).normalize(),t===hi)s[5].setComponents(c+l,f+d,p+m,C+b).normalize();else if(t===Gr)s[5].setComponents(l,d,m,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Js.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Js.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Js)}intersectsSprite(e){Js.center.set(0,0,0);let t=Hx.distanceTo(e.center);return Js.radius=.7071067811865476+t,Js.applyMatrix4(e.matrixWorld),this.intersectsSphere(Js)}intersectsSphere(e){let t=this.planes,n=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let n=0;n<6;n++){let s=t[n];if(ol.x=s.normal.x>0?e.max.x:e.min.x,ol.y=s.normal.y>0?e.max.y:e.min.y,ol.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(ol)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let n=0;n<6;n++)if(t[n].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Wf=new Ht,Cl=class i{constructor(){this.coordinateSystem=hi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,n=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Wf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ls),n[s].setFromProjectionMatrix(Wf,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let n=0;n<this._count;n++)if(t[n].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,n=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Ls),t[s].copy(n[s]);return this._count=e._count,this}clone(){return new i().copy(this)}};var Ho=class extends Wn{constructor(e=[],t=er,n,s,r,o,a,l,c,u){super(e,t,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var as=class extends Wn{constructor(e,t,n=Ai,s,r,o,a=An,l=An,c,u=os,h=1){if(u!==os&&u!==fs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Wr(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Wo=class extends as{constructor(e,t=Ai,n=er,s,r,o=An,a=An,l,c=os){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,n,s,r,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Xo=class extends Wn{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ls=class i extends Gn{constructor(e=1,t=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;g("z","y","x",-1,-1,n,t,e,o,r,0),g("z","y","x",1,-1,n,t,-e,o,r,1),g("x","z","y",1,1,e,n,t,s,o,2),g("x","z","y",1,-1,e,n,-t,s,o,3),g("x","y","z",1,-1,e,t,n,s,r,4),g("x","y","z",-1,-1,e,t,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new un(c,3)),this.setAttribute("normal",new un(u,3)),this.setAttribute("uv",new un(h,2));function g(M,m,p,v,T,b,C,E,_,A,B){let D=b/_,N=C/A,k=b/2,G=C/2,L=E/2,H=_+1,Y=A+1,V=0,le=0,J=new q;for(let j=0;j<Y;j++){let ie=j*N-G;for(let de=0;de<H;de++){let ue=de*D-k;J[M]=ue*v,J[m]=ie*T,J[p]=L,c.push(J.x,J.y,J.z),J[M]=0,J[m]=0,J[p]=E>0?1:-1,u.push(J.x,J.y,J.z),h.push(de/_),h.push(1-j/A),V+=1}}for(let j=0;j<A;j++)for(let ie=0;ie<_;ie++){let de=d+ie+H*j,ue=d+ie+H*(j+1),Q=d+(ie+1)+H*(j+1),me=d+(ie+1)+H*j;l.push(de,ue,me),l.push(ue,Q,me),le+=6}a.addGroup(f,le,B),f+=le,d+=V}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var cs=class i extends Gn{constructor(e=1,t=1,n=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let u=[],h=[],d=[],f=[],g=0,M=[],m=n/2,p=0;v(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new un(h,3)),this.setAttribute("normal",new un(d,3)),this.setAttribute("uv",new un(f,2));function v(){let b=new q,C=new q,E=0,_=(t-e)/n;for(let A=0;A<=r;A++){let B=[],D=A/r,N=D*(t-e)+e;for(let k=0;k<=s;k++){let G=k/s,L=G*l+a,H=Math.sin(L),Y=Math.cos(L);C.x=N*H,C.y=-D*n+m,C.z=N*Y,h.push(C.x,C.y,C.z),b.set(H,_,Y).normalize(),d.push(b.x,b.y,b.z),f.push(G,1-D),B.push(g++)}M.push(B)}for(let A=0;A<s;A++)for(let B=0;B<r;B++){let D=M[B][A],N=M[B+1][A],k=M[B+1][A+1],G=M[B][A+1];(e>0||B!==0)&&(u.push(D,N,G),E+=3),(t>0||B!==r-1)&&(u.push(N,k,G),E+=3)}c.addGroup(p,E,0),p+=E}function T(b){let C=g,E=new ot,_=new q,A=0,B=b===!0?e:t,D=b===!0?1:-1;for(let k=1;k<=s;k++)h.push(0,m*D,0),d.push(0,D,0),f.push(.5,.5),g++;let N=g;for(let k=0;k<=s;k++){let L=k/s*l+a,H=Math.cos(L),Y=Math.sin(L);_.x=B*Y,_.y=m*D,_.z=B*H,h.push(_.x,_.y,_.z),d.push(0,D,0),E.x=H*.5+.5,E.y=Y*.5*D+.5,f.push(E.x,E.y),g++}for(let k=0;k<s;k++){let G=C+k,L=N+k;b===!0?u.push(L,L+1,G):u.push(L+1,L,G),A+=3}c.addGroup(p,A,b===!0?1:2),p+=A}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},qo=class i extends cs{constructor(e=1,t=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,e,t,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(e){return new i(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var Ns=class i extends Gn{constructor(e=1,t=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:n,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=e/a,d=t/l,f=[],g=[],M=[],m=[];for(let p=0;p<u;p++){let v=p*d-o;for(let T=0;T<c;T++){let b=T*h-r;g.push(b,-v,0),M.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let v=0;v<a;v++){let T=v+c*p,b=v+c*(p+1),C=v+1+c*(p+1),E=v+1+c*p;f.push(T,b,E),f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new un(g,3)),this.setAttribute("normal",new un(M,3)),this.setAttribute("uv",new un(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.width,e.height,e.widthSegments,e.heightSegments)}};var us=class i extends Gn{constructor(e=1,t=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),n=Math.max(2,Math.floor(n));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new q,d=new q,f=[],g=[],M=[],m=[];for(let p=0;p<=n;p++){let v=[],T=p/n,b=o+T*a,C=e*Math.cos(b),E=Math.sqrt(e*e-C*C),_=0;p===0&&o===0?_=.5/t:p===n&&l===Math.PI&&(_=-.5/t);for(let A=0;A<=t;A++){let B=A/t,D=s+B*r;h.x=-E*Math.cos(D),h.y=C,h.z=E*Math.sin(D),g.push(h.x,h.y,h.z),d.copy(h).normalize(),M.push(d.x,d.y,d.z),m.push(B+_,1-T),v.push(c++)}u.push(v)}for(let p=0;p<n;p++)for(let v=0;v<t;v++){let T=u[p][v+1],b=u[p][v],C=u[p+1][v],E=u[p+1][v+1];(p!==0||o>0)&&f.push(T,b,E),(p!==n-1||l<Math.PI)&&f.push(b,C,E)}this.setIndex(f),this.setAttribute("position",new un(g,3)),this.setAttribute("normal",new un(M,3)),this.setAttribute("uv",new un(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new i(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var Yo=class extends Hi{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Ye(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function ir(i){let e={};for(let t in i){e[t]={};for(let n in i[t]){let s=i[t][n];if(Xf(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][n]=null):e[t][n]=s.clone();else if(Array.isArray(s))if(Xf(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][n]=r}else e[t][n]=s.slice();else e[t][n]=s}}return e}function Nn(i){let e={};for(let t=0;t<i.length;t++){let n=ir(i[t]);for(let s in n)e[s]=n[s]}return e}function Xf(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function Wx(i){let e=[];for(let t=0;t<i.length;t++)e.push(i[t].clone());return e}function Ih(i){let e=i.getRenderTarget();return e===null?i.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:mt.workingColorSpace}var Bp={clone:ir,merge:Nn},Xx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,qx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Xn=class extends Hi{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Xx,this.fragmentShader=qx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=ir(e.uniforms),this.uniformsGroups=Wx(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(t.extensions=n),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let n in e.uniforms){let s=e.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=t[s.value]||null;break;case"c":this.uniforms[n].value=new Ye().setHex(s.value);break;case"v2":this.uniforms[n].value=new ot().fromArray(s.value);break;case"v3":this.uniforms[n].value=new q().fromArray(s.value);break;case"v4":this.uniforms[n].value=new Wt().fromArray(s.value);break;case"m3":this.uniforms[n].value=new et().fromArray(s.value);break;case"m4":this.uniforms[n].value=new Ht().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let n in e.extensions)this.extensions[n]=e.extensions[n];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Pl=class extends Xn{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var hs=class extends Hi{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new Ye(16777215),this.specular=new Ye(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ye(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ca,this.normalScale=new ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Gi,this.combine=ta,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var $o=class extends Hi{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Ye(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ye(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=ca,this.normalScale=new ot(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Gi,this.combine=ta,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Il=class extends Hi{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Mp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Ll=class extends Hi{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Or(i,e){return!i||i.constructor===e?i:typeof e.BYTES_PER_ELEMENT=="number"?new e(i):Array.prototype.slice.call(i)}function al(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var Ds=class{constructor(e,t,n,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(n),this.sampleValues=t,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,n=this._cachedIndex,s=t[n],r=t[n-1];n:{e:{let o;t:{i:if(!(e<s)){for(let a=n+2;;){if(s===void 0){if(e<r)break i;return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=t[++n],e<s)break e}o=t.length;break t}if(!(e>=r)){let a=t[1];e<a&&(n=2,r=a);for(let l=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===l)break;if(s=r,r=t[--n-1],e>=r)break e}o=n,n=0;break t}break n}for(;n<o;){let a=n+o>>>1;e<t[a]?o=a:n=a+1}if(s=t[n],r=t[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=t.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=n[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Nl=class extends Ds{constructor(e,t,n,s){super(e,t,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Qu,endingEnd:Qu}}intervalChanged_(e,t,n){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case eh:r=e,a=2*t-n;break;case th:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=n}if(l===void 0)switch(this.getSettings_().endingEnd){case eh:o=e,l=2*n-t;break;case th:o=1,l=n+s[1]-s[0];break;default:o=e-1,l=t}let c=(n-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-n),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,g=(n-t)/(s-t),M=g*g,m=M*g,p=-d*m+2*d*M-d*g,v=(1+d)*m+(-1.5-2*d)*M+(-.5+d)*g+1,T=(-1-f)*m+(1.5+f)*M+.5*g,b=f*m-f*M;for(let C=0;C!==a;++C)r[C]=p*o[u+C]+v*o[c+C]+T*o[l+C]+b*o[h+C];return r}},Dl=class extends Ds{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(n-t)/(s-t),h=1-u;for(let d=0;d!==a;++d)r[d]=o[c+d]*h+o[l+d]*u;return r}},Fl=class extends Ds{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Ul=class extends Ds{interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let g=(n-t)/(s-t),M=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*M+o[l+m]*g;return r}let d=a*2,f=e-1;for(let g=0;g!==a;++g){let M=o[c+g],m=o[l+g],p=f*d+g*2,v=h[p],T=h[p+1],b=e*d+g*2,C=u[b],E=u[b+1],_=$x(n,t,v,C,s);r[g]=kp(_,M,T,E,m)}return r}};function kp(i,e,t,n,s){let r=1-i;return r*r*r*e+3*r*r*i*t+3*r*i*i*n+i*i*i*s}function Yx(i,e,t,n,s){let r=1-i;return 3*r*r*(t-e)+6*r*i*(n-t)+3*i*i*(s-n)}function $x(i,e,t,n,s){let r=(i-e)/(s-e);for(let o=0;o<8;o++){let a=kp(r,e,t,n,s)-i;if(Math.abs(a)<1e-10)break;let l=Yx(r,e,t,n,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ii=class{constructor(e,t,n,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Or(t,this.TimeBufferType),this.values=Or(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,n;if(t.toJSON!==this.toJSON)n=t.toJSON(e);else{n={name:e.name,times:Or(e.times,Array),values:Or(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(n.interpolation=s),al(e.settings)&&(n.settings={inTangents:Or(e.settings.inTangents,Array),outTangents:Or(e.settings.outTangents,Array)})}return n.type=e.ValueTypeName,n}InterpolantFactoryMethodDiscrete(e){return new Fl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Dl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Nl(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Ul(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case No:t=this.InterpolantFactoryMethodDiscrete;break;case bl:t=this.InterpolantFactoryMethodLinear;break;case ul:t=this.InterpolantFactoryMethodSmooth;break;case ju:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return Ze("KeyframeTrack:",n),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return No;case this.InterpolantFactoryMethodLinear:return bl;case this.InterpolantFactoryMethodSmooth:return ul;case this.InterpolantFactoryMethodBezier:return ju}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]+=e;al(this.settings)&&(qf(this.settings.inTangents,e),qf(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let n=0,s=t.length;n!==s;++n)t[n]*=e;al(this.settings)&&(Yf(this.settings.inTangents,e),Yf(this.settings.outTangents,e))}return this}trim(e,t){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<e;)++r;for(;o!==-1&&n[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(Qe("KeyframeTrack: Invalid value size in track.",this),e=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Qe("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=n[a];if(typeof l=="number"&&isNaN(l)){Qe("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){Qe("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&wx(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Qe("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ul,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let h=a*n,d=h-n,f=h+n;for(let g=0;g!==n;++g){let M=t[h+g];if(M!==t[d+g]||M!==t[f+g]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*n,d=o*n;for(let f=0;f!==n;++f)t[d+f]=t[h+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*n,l=o*n,c=0;c!==n;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*n)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),n=this.constructor,s=new n(this.name,e,t);return s.createInterpolant=this.createInterpolant,al(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function qf(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]+=e}function Yf(i,e){for(let t=0,n=i.length;t!==n;t+=2)i[t]*=e}ii.prototype.ValueTypeName="";ii.prototype.TimeBufferType=Float32Array;ii.prototype.ValueBufferType=Float32Array;ii.prototype.DefaultInterpolation=bl;var Fs=class extends ii{constructor(e,t,n){super(e,t,n)}};Fs.prototype.ValueTypeName="bool";Fs.prototype.ValueBufferType=Array;Fs.prototype.DefaultInterpolation=No;Fs.prototype.InterpolantFactoryMethodLinear=void 0;Fs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ol=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};Ol.prototype.ValueTypeName="color";var Bl=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};Bl.prototype.ValueTypeName="number";var kl=class extends Ds{constructor(e,t,n,s){super(e,t,n,s)}interpolate_(e,t,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(n-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)di.slerpFlat(r,0,o,c-a,o,c,l);return r}},Zo=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}InterpolantFactoryMethodLinear(e){return new kl(this.times,this.values,this.getValueSize(),e)}};Zo.prototype.ValueTypeName="quaternion";Zo.prototype.InterpolantFactoryMethodSmooth=void 0;var Us=class extends ii{constructor(e,t,n){super(e,t,n)}};Us.prototype.ValueTypeName="string";Us.prototype.ValueBufferType=Array;Us.prototype.DefaultInterpolation=No;Us.prototype.InterpolantFactoryMethodLinear=void 0;Us.prototype.InterpolantFactoryMethodSmooth=void 0;var zl=class extends ii{constructor(e,t,n,s){super(e,t,n,s)}};zl.prototype.ValueTypeName="vector";var Vl=class{constructor(e,t,n){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=n,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],g=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},zp=new Vl,Gl=class{constructor(e){this.manager=e!==void 0?e:zp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let n=this;return new Promise(function(s,r){n.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Gl.DEFAULT_MATERIAL_NAME="__DEFAULT";var Jo=class extends Ln{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new Ye(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Yr=class extends Jo{constructor(e,t,n){super(e,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ye(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Ku=new Ht,$f=new q,Zf=new q,Hl=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new ot(512,512),this.mapType=Yn,this.map=null,this.mapPass=null,this.matrix=new Ht,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ls,this._frameExtents=new ot(1,1),this._viewportCount=1,this._viewports=[new Wt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;$f.setFromMatrixPosition(e.matrixWorld),t.position.copy($f),Zf.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(Zf),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,n,s){Ku.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),n.setFromProjectionMatrix(Ku,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Gr||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Ku)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ll=new q,cl=new di,ki=new q,Ko=class extends Ln{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Ht,this.projectionMatrix=new Ht,this.projectionMatrixInverse=new Ht,this.coordinateSystem=hi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ll,cl,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ll,cl,ki.set(1,1,1)).invert()}updateWorldMatrix(e,t,n=!1){super.updateWorldMatrix(e,t,n),this.matrixWorld.decompose(ll,cl,ki),ki.x===1&&ki.y===1&&ki.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ll,cl,ki.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ts=new q,Jf=new ot,Kf=new ot,zn=class extends Ko{constructor(e=50,t=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Ml*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Pu*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Ml*2*Math.atan(Math.tan(Pu*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,n){Ts.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Ts.x,Ts.y).multiplyScalar(-e/Ts.z),Ts.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ts.x,Ts.y).multiplyScalar(-e/Ts.z)}getViewSize(e,t){return this.getViewBounds(e,Jf,Kf),t.subVectors(Kf,Jf)}setViewOffset(e,t,n,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Pu*.5*this.fov)/this.zoom,n=2*t,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-n,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var jo=class extends Ko{constructor(e=-1,t=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-e,o=n+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},nh=class extends Hl{constructor(){super(new jo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Qo=class extends Jo{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ln.DEFAULT_UP),this.updateMatrix(),this.target=new Ln,this.shadow=new nh}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var ea=class extends Gn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Br=-90,kr=1,$r=class extends Ln{constructor(e,t,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new zn(Br,kr,e,t);s.layers=this.layers,this.add(s);let r=new zn(Br,kr,e,t);r.layers=this.layers,this.add(r);let o=new zn(Br,kr,e,t);o.layers=this.layers,this.add(o);let a=new zn(Br,kr,e,t);a.layers=this.layers,this.add(a);let l=new zn(Br,kr,e,t);l.layers=this.layers,this.add(l);let c=new zn(Br,kr,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[n,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===hi)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Gr)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),g=e.xr.enabled;e.xr.enabled=!1;let M=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(n,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(n,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(n,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(n,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(n,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),n.texture.mipmapsAutoUpdate=M,e.setRenderTarget(n,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=g,n.texture.needsPMREMUpdate=!0}},Wl=class extends zn{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Lh="\\[\\]\\.:\\/",Zx=new RegExp("["+Lh+"]","g"),Nh="[^"+Lh+"]",Jx="[^"+Lh.replace("\\.","")+"]",Kx=/((?:WC+[\/:])*)/.source.replace("WC",Nh),jx=/(WCOD+)?/.source.replace("WCOD",Jx),Qx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Nh),e_=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Nh),t_=new RegExp("^"+Kx+jx+Qx+e_+"$"),n_=["material","materials","bones","map"],ih=class{constructor(e,t,n){let s=n||kt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(e,t)}setValue(e,t){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,n=e.length;t!==n;++t)e[t].unbind()}},kt=class i{constructor(e,t,n){this.path=t,this.parsedPath=n||i.parseTrackName(t),this.node=i.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,n){return e&&e.isAnimationObjectGroup?new i.Composite(e,t,n):new i(e,t,n)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Zx,"")}static parseTrackName(e){let t=t_.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let n={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);n_.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return n}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let n=e.skeleton.getBoneByName(t);if(n!==void 0)return n}if(e.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=n(a.children);if(l)return l}return null},s=n(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)e[t++]=n[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,n=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=i.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let c=t.objectIndex;switch(n){case"materials":if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){Qe("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){Qe("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){Qe("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){Qe("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[n]===void 0){Qe("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[n]}if(c!==void 0){if(e[c]===void 0){Qe("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;Qe("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){Qe("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};kt.Composite=ih;kt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};kt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};kt.prototype.GetterByBindingType=[kt.prototype._getValue_direct,kt.prototype._getValue_array,kt.prototype._getValue_arrayElement,kt.prototype._getValue_toArray];kt.prototype.SetterByBindingTypeAndVersioning=[[kt.prototype._setValue_direct,kt.prototype._setValue_direct_setNeedsUpdate,kt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_array,kt.prototype._setValue_array_setNeedsUpdate,kt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_arrayElement,kt.prototype._setValue_arrayElement_setNeedsUpdate,kt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[kt.prototype._setValue_fromArray,kt.prototype._setValue_fromArray_setNeedsUpdate,kt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var vA=new Float32Array(1);var Zr=class extends El{constructor(e,t,n=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var sh=class{static{this.prototype.isMatrix2=!0}constructor(e,t,n,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let n=0;n<4;n++)this.elements[n]=e[n+t];return this}set(e,t,n,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=n,r[3]=s,this}};function Dh(i,e,t,n){let s=i_(n);switch(t){case Sh:return i*e;case Ah:return i*e/s.components*s.byteLength;case Kl:return i*e/s.components*s.byteLength;case Os:return i*e*2/s.components*s.byteLength;case jl:return i*e*2/s.components*s.byteLength;case wh:return i*e*3/s.components*s.byteLength;case Ri:return i*e*4/s.components*s.byteLength;case Ql:return i*e*4/s.components*s.byteLength;case ia:case sa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case ra:case oa:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case tc:case ic:return Math.max(i,16)*Math.max(e,8)/4;case ec:case nc:return Math.max(i,8)*Math.max(e,8)/2;case sc:case rc:case ac:case lc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*8;case oc:case aa:case cc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case uc:return Math.floor((i+3)/4)*Math.floor((e+3)/4)*16;case hc:return Math.floor((i+4)/5)*Math.floor((e+3)/4)*16;case dc:return Math.floor((i+4)/5)*Math.floor((e+4)/5)*16;case fc:return Math.floor((i+5)/6)*Math.floor((e+4)/5)*16;case pc:return Math.floor((i+5)/6)*Math.floor((e+5)/6)*16;case mc:return Math.floor((i+7)/8)*Math.floor((e+4)/5)*16;case gc:return Math.floor((i+7)/8)*Math.floor((e+5)/6)*16;case xc:return Math.floor((i+7)/8)*Math.floor((e+7)/8)*16;case _c:return Math.floor((i+9)/10)*Math.floor((e+4)/5)*16;case vc:return Math.floor((i+9)/10)*Math.floor((e+5)/6)*16;case yc:return Math.floor((i+9)/10)*Math.floor((e+7)/8)*16;case bc:return Math.floor((i+9)/10)*Math.floor((e+9)/10)*16;case Mc:return Math.floor((i+11)/12)*Math.floor((e+9)/10)*16;case Sc:return Math.floor((i+11)/12)*Math.floor((e+11)/12)*16;case wc:case Ac:case Ec:return Math.ceil(i/4)*Math.ceil(e/4)*16;case Tc:case Rc:return Math.ceil(i/4)*Math.ceil(e/4)*8;case la:case Cc:return Math.ceil(i/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function i_(i){switch(i){case Yn:case vh:return{byteLength:1,components:1};case Qr:case yh:case Ti:return{byteLength:2,components:1};case Zl:case Jl:return{byteLength:2,components:4};case Ai:case $l:case Ei:return{byteLength:4,components:1};case bh:case Mh:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function lm(){let i=null,e=!1,t=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&i!==null&&(n=i.requestAnimationFrame(s),e=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){i=r}}}function r_(i){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=i.createBuffer();i.bindBuffer(l,d),i.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=i.SHORT;else if(c instanceof Uint32Array)f=i.UNSIGNED_INT;else if(c instanceof Int32Array)f=i.INT;else if(c instanceof Int8Array)f=i.BYTE;else if(c instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){let u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((f,g)=>f.start-g.start);let d=0;for(let f=1;f<h.length;f++){let g=h[d],M=h[f];M.start<=g.start+g.count+1?g.count=Math.max(g.count,M.start+M.count-g.start):(++d,h[d]=M)}h.length=d+1;for(let f=0,g=h.length;f<g;f++){let M=h[f];i.bufferSubData(c,M.start*u.BYTES_PER_ELEMENT,u,M.start,M.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(i.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var o_=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,a_=`#ifdef USE_ALPHAHASH
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
#endif`,l_=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,c_=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,u_=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,h_=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,d_=`#ifdef USE_AOMAP
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
#endif`,f_=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,p_=`#ifdef USE_BATCHING
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
#endif`,m_=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,g_=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,x_=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,__=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,v_=`#ifdef USE_IRIDESCENCE
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
#endif`,y_=`#ifdef USE_BUMPMAP
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
#endif`,b_=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,M_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,S_=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,w_=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,A_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,E_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,T_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,R_=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,C_=`#define PI 3.141592653589793
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
} // validated`,P_=`vec3 transformedNormal = objectNormal;
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
#endif`,I_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,L_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,N_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,D_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,F_="gl_FragColor = linearToOutputTexel( gl_FragColor );",U_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,O_=`#ifdef USE_ENVMAP
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
#endif`,B_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,k_=`#ifdef USE_ENVMAP
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
#endif`,z_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,V_=`#ifdef USE_ENVMAP
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
#endif`,G_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,H_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,W_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,X_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,q_=`#ifdef USE_GRADIENTMAP
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
}`,Y_=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,$_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Z_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,J_=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,K_=`#ifdef USE_ENVMAP
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
#endif`,j_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Q_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,ev=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,tv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,nv=`PhysicalMaterial material;
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
#endif`,iv=`uniform sampler2D dfgLUT;
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
}`,sv=`
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
#endif`,rv=`#if defined( RE_IndirectDiffuse )
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
#endif`,ov=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,av=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,lv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,cv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,uv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,hv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,dv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,fv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,pv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,mv=`#if defined( USE_POINTS_UV )
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
#endif`,gv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,xv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,_v=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,vv=`#if defined( USE_MORPHCOLORS )
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
#endif`,yv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,bv=`#ifdef USE_MORPHTARGETS
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
#endif`,Mv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Sv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,wv=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Av=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Ev=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Tv=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Rv=`#ifdef USE_NORMALMAP
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
#endif`,Cv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Pv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Iv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Lv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Nv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,Dv=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Fv=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Uv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ov=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Bv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,kv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,zv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Vv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Gv=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Hv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,Wv=`float getShadowMask() {
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
}`,Xv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,qv=`#ifdef USE_SKINNING
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
#endif`,Yv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,$v=`#ifdef USE_SKINNING
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
#endif`,Zv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Jv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Kv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,jv=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Qv=`#ifdef USE_TRANSMISSION
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
#endif`,ey=`#ifdef USE_TRANSMISSION
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
#endif`,ty=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ny=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,iy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,ry=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,oy=`uniform sampler2D t2D;
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
}`,ay=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ly=`uniform float backgroundBlurriness;
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
}`,cy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hy=`#include <common>
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
}`,dy=`#if DEPTH_PACKING == 3200
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
}`,fy=`#define DISTANCE
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
}`,py=`#define DISTANCE
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
}`,my=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,gy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,xy=`uniform float scale;
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
}`,_y=`uniform vec3 diffuse;
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
}`,vy=`#include <common>
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
}`,yy=`uniform vec3 diffuse;
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
}`,by=`#define LAMBERT
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
}`,My=`#define LAMBERT
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
}`,Sy=`#define MATCAP
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
}`,wy=`#define MATCAP
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
}`,Ay=`#define NORMAL
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
}`,Ey=`#define NORMAL
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
}`,Ty=`#define PHONG
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
}`,Ry=`#define PHONG
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
}`,Cy=`#define STANDARD
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
}`,Py=`#define STANDARD
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
}`,Iy=`#define TOON
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
}`,Ly=`#define TOON
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
}`,Ny=`uniform float size;
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
}`,Dy=`uniform vec3 diffuse;
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
}`,Fy=`#include <common>
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
}`,Uy=`uniform vec3 color;
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
}`,Oy=`uniform float rotation;
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
}`,By=`uniform vec3 diffuse;
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
}`,ct={alphahash_fragment:o_,alphahash_pars_fragment:a_,alphamap_fragment:l_,alphamap_pars_fragment:c_,alphatest_fragment:u_,alphatest_pars_fragment:h_,aomap_fragment:d_,aomap_pars_fragment:f_,batching_pars_vertex:p_,batching_vertex:m_,begin_vertex:g_,beginnormal_vertex:x_,bsdfs:__,iridescence_fragment:v_,bumpmap_pars_fragment:y_,clipping_planes_fragment:b_,clipping_planes_pars_fragment:M_,clipping_planes_pars_vertex:S_,clipping_planes_vertex:w_,color_fragment:A_,color_pars_fragment:E_,color_pars_vertex:T_,color_vertex:R_,common:C_,defaultnormal_vertex:P_,displacementmap_pars_vertex:I_,displacementmap_vertex:L_,emissivemap_fragment:N_,emissivemap_pars_fragment:D_,colorspace_fragment:F_,colorspace_pars_fragment:U_,envmap_fragment:O_,envmap_common_pars_fragment:B_,envmap_pars_fragment:k_,envmap_pars_vertex:z_,envmap_physical_pars_fragment:K_,envmap_vertex:V_,fog_vertex:G_,fog_pars_vertex:H_,fog_fragment:W_,fog_pars_fragment:X_,gradientmap_pars_fragment:q_,lightmap_pars_fragment:Y_,lights_lambert_fragment:$_,lights_lambert_pars_fragment:Z_,lights_pars_begin:J_,lights_toon_fragment:j_,lights_toon_pars_fragment:Q_,lights_phong_fragment:ev,lights_phong_pars_fragment:tv,lights_physical_fragment:nv,lights_physical_pars_fragment:iv,lights_fragment_begin:sv,lights_fragment_maps:rv,lights_fragment_end:ov,lightprobes_pars_fragment:av,logdepthbuf_fragment:lv,logdepthbuf_pars_fragment:cv,logdepthbuf_pars_vertex:uv,logdepthbuf_vertex:hv,map_fragment:dv,map_pars_fragment:fv,map_particle_fragment:pv,map_particle_pars_fragment:mv,metalnessmap_fragment:gv,metalnessmap_pars_fragment:xv,morphinstance_vertex:_v,morphcolor_vertex:vv,morphnormal_vertex:yv,morphtarget_pars_vertex:bv,morphtarget_vertex:Mv,normal_fragment_begin:Sv,normal_fragment_maps:wv,normal_pars_fragment:Av,normal_pars_vertex:Ev,normal_vertex:Tv,normalmap_pars_fragment:Rv,clearcoat_normal_fragment_begin:Cv,clearcoat_normal_fragment_maps:Pv,clearcoat_pars_fragment:Iv,iridescence_pars_fragment:Lv,opaque_fragment:Nv,packing:Dv,premultiplied_alpha_fragment:Fv,project_vertex:Uv,dithering_fragment:Ov,dithering_pars_fragment:Bv,roughnessmap_fragment:kv,roughnessmap_pars_fragment:zv,shadowmap_pars_fragment:Vv,shadowmap_pars_vertex:Gv,shadowmap_vertex:Hv,shadowmask_pars_fragment:Wv,skinbase_vertex:Xv,skinning_pars_vertex:qv,skinning_vertex:Yv,skinnormal_vertex:$v,specularmap_fragment:Zv,specularmap_pars_fragment:Jv,tonemapping_fragment:Kv,tonemapping_pars_fragment:jv,transmission_fragment:Qv,transmission_pars_fragment:ey,uv_pars_fragment:ty,uv_pars_vertex:ny,uv_vertex:iy,worldpos_vertex:sy,background_vert:ry,background_frag:oy,backgroundCube_vert:ay,backgroundCube_frag:ly,cube_vert:cy,cube_frag:uy,depth_vert:hy,depth_frag:dy,distance_vert:fy,distance_frag:py,equirect_vert:my,equirect_frag:gy,linedashed_vert:xy,linedashed_frag:_y,meshbasic_vert:vy,meshbasic_frag:yy,meshlambert_vert:by,meshlambert_frag:My,meshmatcap_vert:Sy,meshmatcap_frag:wy,meshnormal_vert:Ay,meshnormal_frag:Ey,meshphong_vert:Ty,meshphong_frag:Ry,meshphysical_vert:Cy,meshphysical_frag:Py,meshtoon_vert:Iy,meshtoon_frag:Ly,points_vert:Ny,points_frag:Dy,shadow_vert:Fy,shadow_frag:Uy,sprite_vert:Oy,sprite_frag:By},Le={common:{diffuse:{value:new Ye(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new et}},envmap:{envMap:{value:null},envMapRotation:{value:new et},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new et}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new et}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new et},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new et},normalScale:{value:new ot(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new et},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new et}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new et}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new et}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ye(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ye(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0},uvTransform:{value:new et}},sprite:{diffuse:{value:new Ye(16777215)},opacity:{value:1},center:{value:new ot(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new et},alphaMap:{value:null},alphaMapTransform:{value:new et},alphaTest:{value:0}}},qi={basic:{uniforms:Nn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:ct.meshbasic_vert,fragmentShader:ct.meshbasic_frag},lambert:{uniforms:Nn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Ye(0)},envMapIntensity:{value:1}}]),vertexShader:ct.meshlambert_vert,fragmentShader:ct.meshlambert_frag},phong:{uniforms:Nn([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new Ye(0)},specular:{value:new Ye(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ct.meshphong_vert,fragmentShader:ct.meshphong_frag},standard:{uniforms:Nn([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new Ye(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag},toon:{uniforms:Nn([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new Ye(0)}}]),vertexShader:ct.meshtoon_vert,fragmentShader:ct.meshtoon_frag},matcap:{uniforms:Nn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:ct.meshmatcap_vert,fragmentShader:ct.meshmatcap_frag},points:{uniforms:Nn([Le.points,Le.fog]),vertexShader:ct.points_vert,fragmentShader:ct.points_frag},dashed:{uniforms:Nn([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ct.linedashed_vert,fragmentShader:ct.linedashed_frag},depth:{uniforms:Nn([Le.common,Le.displacementmap]),vertexShader:ct.depth_vert,fragmentShader:ct.depth_frag},normal:{uniforms:Nn([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:ct.meshnormal_vert,fragmentShader:ct.meshnormal_frag},sprite:{uniforms:Nn([Le.sprite,Le.fog]),vertexShader:ct.sprite_vert,fragmentShader:ct.sprite_frag},background:{uniforms:{uvTransform:{value:new et},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ct.background_vert,fragmentShader:ct.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new et}},vertexShader:ct.backgroundCube_vert,fragmentShader:ct.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ct.cube_vert,fragmentShader:ct.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ct.equirect_vert,fragmentShader:ct.equirect_frag},distance:{uniforms:Nn([Le.common,Le.displacementmap,{referencePosition:{value:new q},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ct.distance_vert,fragmentShader:ct.distance_frag},shadow:{uniforms:Nn([Le.lights,Le.fog,{color:{value:new Ye(0)},opacity:{value:1}}]),vertexShader:ct.shadow_vert,fragmentShader:ct.shadow_frag}};qi.physical={uniforms:Nn([qi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new et},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new et},clearcoatNormalScale:{value:new ot(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new et},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new et},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new et},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new et},sheen:{value:0},sheenColor:{value:new Ye(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new et},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new et},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new et},transmissionSamplerSize:{value:new ot},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new et},attenuationDistance:{value:0},attenuationColor:{value:new Ye(0)},specularColor:{value:new Ye(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new et},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new et},anisotropyVector:{value:new ot},anisotropyMap:{value:null},anisotropyMapTransform:{value:new et}}]),vertexShader:ct.meshphysical_vert,fragmentShader:ct.meshphysical_frag};var Ic={r:0,b:0,g:0},ky=new Ht,cm=new et;cm.set(-1,0,0,0,1,0,0,0,1);function zy(i,e,t,n,s,r){let o=new Ye(0),a=s===!0?0:1,l,c,u=null,h=0,d=null;function f(v){let T=v.isScene===!0?v.background:null;if(T&&T.isTexture){let b=v.backgroundBlurriness>0;T=e.get(T,b)}return T}function g(v){let T=!1,b=f(v);b===null?m(o,a):b&&b.isColor&&(m(b,1),T=!0);let C=i.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,r):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(i.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function M(v,T){let b=f(T);b&&b.isCubeTexture?(c===void 0&&(c=new yt(new ls(1,1,1),new Xn({name:"BackgroundCubeMaterial",uniforms:ir(qi.backgroundCube.uniforms),vertexShader:qi.backgroundCube.vertexShader,fragmentShader:qi.backgroundCube.fragmentShader,side:en,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ky.makeRotationFromEuler(T.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(cm),c.material.toneMapped=mt.getTransfer(b.colorSpace)!==wt,(u!==b||h!==b.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new yt(new Ns(2,2),new Xn({name:"BackgroundMaterial",uniforms:ir(qi.background.uniforms),vertexShader:qi.background.vertexShader,fragmentShader:qi.background.fragmentShader,side:qn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=mt.getTransfer(b.colorSpace)!==wt,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(u!==b||h!==b.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,u=b,h=b.version,d=i.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,T){v.getRGB(Ic,Ih(i)),t.buffers.color.setClear(Ic.r,Ic.g,Ic.b,T,r)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,T=1){o.set(v),a=T,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:g,addToRenderList:M,dispose:p}}function Vy(i,e){let t=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(N,k,G,L,H){let Y=!1,V=h(N,L,G,k);r!==V&&(r=V,c(r.object)),Y=f(N,L,G,H),Y&&g(N,L,G,H),H!==null&&e.update(H,i.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,b(N,k,G,L),H!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,e.get(H).buffer))}function l(){return i.createVertexArray()}function c(N){return i.bindVertexArray(N)}function u(N){return i.deleteVertexArray(N)}function h(N,k,G,L){let H=L.wireframe===!0,Y=n[k.id];Y===void 0&&(Y={},n[k.id]=Y);let V=N.isInstancedMesh===!0?N.id:0,le=Y[V];le===void 0&&(le={},Y[V]=le);let J=le[G.id];J===void 0&&(J={},le[G.id]=J);let j=J[H];return j===void 0&&(j=d(l()),J[H]=j),j}function d(N){let k=[],G=[],L=[];for(let H=0;H<t;H++)k[H]=0,G[H]=0,L[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:L,object:N,attributes:{},index:null}}function f(N,k,G,L){let H=r.attributes,Y=k.attributes,V=0,le=G.getAttributes();for(let J in le)if(le[J].location>=0){let ie=H[J],de=Y[J];if(de===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(de=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(de=N.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;V++}return r.attributesNum!==V||r.index!==L}function g(N,k,G,L){let H={},Y=k.attributes,V=0,le=G.getAttributes();for(let J in le)if(le[J].location>=0){let ie=Y[J];ie===void 0&&(J==="instanceMatrix"&&N.instanceMatrix&&(ie=N.instanceMatrix),J==="instanceColor"&&N.instanceColor&&(ie=N.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),H[J]=de,V++}r.attributes=H,r.attributesNum=V,r.index=L}function M(){let N=r.newAttributes;for(let k=0,G=N.length;k<G;k++)N[k]=0}function m(N){p(N,0)}function p(N,k){let G=r.newAttributes,L=r.enabledAttributes,H=r.attributeDivisors;G[N]=1,L[N]===0&&(i.enableVertexAttribArray(N),L[N]=1),H[N]!==k&&(i.vertexAttribDivisor(N,k),H[N]=k)}function v(){let N=r.newAttributes,k=r.enabledAttributes;for(let G=0,L=k.length;G<L;G++)k[G]!==N[G]&&(i.disableVertexAttribArray(G),k[G]=0)}function T(N,k,G,L,H,Y,V){V===!0?i.vertexAttribIPointer(N,k,G,H,Y):i.vertexAttribPointer(N,k,G,L,H,Y)}function b(N,k,G,L){M();let H=L.attributes,Y=G.getAttributes(),V=k.defaultAttributeValues;for(let le in Y){let J=Y[le];if(J.location>=0){let j=H[le];if(j===void 0&&(le==="instanceMatrix"&&N.instanceMatrix&&(j=N.instanceMatrix),le==="instanceColor"&&N.instanceColor&&(j=N.instanceColor)),j!==void 0){let ie=j.normalized,de=j.itemSize,ue=e.get(j);if(ue===void 0)continue;let Q=ue.buffer,me=ue.type,_e=ue.bytesPerElement,Te=me===i.INT||me===i.UNSIGNED_INT||j.gpuType===$l;if(j.isInterleavedBufferAttribute){let Me=j.data,He=Me.isInterleavedBuffer===!0?Me.stride:Me.itemSize,it=j.offset;if(Me.isInstancedInterleavedBuffer||Me.isInstancedBufferAttribute){for(let Ve=0;Ve<J.locationSize;Ve++)p(J.location+Ve,Me.meshPerAttribute);N.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Me.meshPerAttribute*Me.count)}else for(let Ve=0;Ve<J.locationSize;Ve++)m(J.location+Ve);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Ve=0;Ve<J.locationSize;Ve++)T(J.location+Ve,de/J.locationSize,me,ie,He*_e,(it+de/J.locationSize*Ve)*_e,Te)}else{if(j.isInstancedBufferAttribute){for(let Me=0;Me<J.locationSize;Me++)p(J.location+Me,j.meshPerAttribute);N.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let Me=0;Me<J.locationSize;Me++)m(J.location+Me);i.bindBuffer(i.ARRAY_BUFFER,Q);for(let Me=0;Me<J.locationSize;Me++)T(J.location+Me,de/J.locationSize,me,ie,de*_e,de/J.locationSize*Me*_e,Te)}}else if(V!==void 0){let ie=V[le];if(ie!==void 0)switch(ie.length){case 2:i.vertexAttrib2fv(J.location,ie);break;case 3:i.vertexAttrib3fv(J.location,ie);break;case 4:i.vertexAttrib4fv(J.location,ie);break;default:i.vertexAttrib1fv(J.location,ie)}}}}v()}function C(){B();for(let N in n){let k=n[N];for(let G in k){let L=k[G];for(let H in L){let Y=L[H];for(let V in Y)u(Y[V].object),delete Y[V];delete L[H]}}delete n[N]}}function E(N){if(n[N.id]===void 0)return;let k=n[N.id];for(let G in k){let L=k[G];for(let H in L){let Y=L[H];for(let V in Y)u(Y[V].object),delete Y[V];delete L[H]}}delete n[N.id]}function _(N){for(let k in n){let G=n[k];for(let L in G){let H=G[L];if(H[N.id]===void 0)continue;let Y=H[N.id];for(let V in Y)u(Y[V].object),delete Y[V];delete H[N.id]}}}function A(N){for(let k in n){let G=n[k],L=N.isInstancedMesh===!0?N.id:0,H=G[L];if(H!==void 0){for(let Y in H){let V=H[Y];for(let le in V)u(V[le].object),delete V[le];delete H[Y]}delete G[L],Object.keys(G).length===0&&delete n[k]}}}function B(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:B,resetDefaultState:D,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:A,releaseStatesOfProgram:_,initAttributes:M,enableAttribute:m,disableUnusedAttributes:v}}function Gy(i,e,t){let n;function s(l){n=l}function r(l,c){i.drawArrays(n,l,c),t.update(c,n,1)}function o(l,c,u){u!==0&&(i.drawArraysInstanced(n,l,c,u),t.update(c,n,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Hy(i,e,t,n){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Ri&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let A=_===Ti&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==Yn&&_!==Ei&&!A&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ze("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),M=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),v=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),b=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),C=i.getParameter(i.MAX_SAMPLES),E=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:g,maxTextureSize:M,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:v,maxVaryings:T,maxFragmentUniforms:b,maxSamples:C,samples:E}}function Wy(i){let e=this,t=null,n=0,s=!1,r=!1,o=new wi,a=new et,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||n!==0||s;return s=d,n=h.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let g=h.clippingPlanes,M=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{let v=r?0:n,T=v*4,b=p.clippingState||null;l.value=b,b=u(g,d,T,f);for(let C=0;C!==T;++C)b[C]=t[C];p.clippingState=b,this.numIntersection=M?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=n>0),e.numPlanes=n,e.numIntersection=0}function u(h,d,f,g){let M=h!==null?h.length:0,m=null;if(M!==0){if(m=l.value,g!==!0||m===null){let p=f+M*4,v=d.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,b=f;T!==M;++T,b+=4)o.copy(h[T]).applyMatrix4(v,a),o.normal.toArray(m,b),m[b+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=M,e.numIntersection=0,m}}var da=class extends ni{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let n={width:e,height:e,depth:1},s=[n,n,n,n,n,n];this.texture=new Ho(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ls(5,5,5),r=new Xn({name:"CubemapFromEquirect",uniforms:ir(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:en,blending:js});r.uniforms.tEquirect.value=t;let o=new yt(s,r),a=t.minFilter;return t.minFilter===ds&&(t.minFilter=Vn),new $r(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,n=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,n,s);e.setRenderTarget(r)}},Vp=256,Xy=3,qy=20,um=256,hm=16,Yy=3,$y=new q,Zy=new Ye,Nc=class i{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new $r(1,10,null),this._boxMesh=new yt(new ls(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,n=.1,s=100,r={}){let{size:o=256,position:a=$y}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,g=l.autoClearStencil,M=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,M===null&&(e.background=l.getClearColor(Zy));let m=new $r(n,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=g,e.background=M,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Wp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Hp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Vp,Dp(e))}_fromTexture(e,t){e.mapping===er||e.mapping===jr?this._setSize(e.image.length===0?Vp:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let n=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(n),n}_allocateTarget(){let e=this._cubeSize,t=Gp(e,!1,!1),n=Math.log2(e)-Xy;for(let s=0;s<=n;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==t||e&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Gp(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===er||e.mapping===jr?(this._cubemapMaterial===null&&(this._cubemapMaterial=Wp()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Hp()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=Jy(),this._integrationMaterial=Ky());let t=this._cubeSize,n=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/hm);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-Yy)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(um*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=jy());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,n),s.envMap.value=e.texture,this._renderCube(r,0,n)}};function Gp(i,e,t){return new da(i,{minFilter:ds,generateMipmaps:e,type:Ti,colorSpace:Do,depthBuffer:t})}function fa(i,e,t){return new Xn({name:i,uniforms:e,vertexShader:ct.cube_vert,fragmentShader:t,side:en,blending:js,depthTest:!1,depthWrite:!1})}function Jy(){return fa("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${um}u

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
	`)}function Ky(){return fa("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:hm}},`

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
	`)}function jy(){return fa("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${qy}
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
	`)}function Hp(){return fa("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Wp(){return fa("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Qy(i){let e=new WeakMap,t=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Xl||f===ql)if(e.has(d)){let g=e.get(d).texture;return a(g,d.mapping)}else{let g=d.image;if(g&&g.height>0){let M=new da(g.height);return M.fromEquirectangularTexture(i,d),e.set(d,M),d.addEventListener("dispose",c),a(M.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,g=f===Xl||f===ql,M=f===er||f===jr;if(g||M){let m=t.get(d),p=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return n===null&&(n=new Nc(i)),m=g?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),m.texture;if(m!==void 0)return m.texture;{let v=d.image;return g&&v&&v.height>0||M&&v&&l(v)?(n===null&&(n=new Nc(i)),m=g?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,t.set(d,m),d.addEventListener("dispose",u),m.texture):null}}}return d}function a(d,f){return f===Xl?d.mapping=er:f===ql&&(d.mapping=jr),d}function l(d){let f=0,g=6;for(let M=0;M<g;M++)d[M]!==void 0&&f++;return f===g}function c(d){let f=d.target;f.removeEventListener("dispose",c);let g=e.get(f);g!==void 0&&(e.delete(f),g.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let g=t.get(f);g!==void 0&&(t.delete(f),g.dispose())}function h(){e=new WeakMap,t=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:h}}function eb(i){let e={};function t(n){if(e[n]!==void 0)return e[n];let s=i.getExtension(n);return e[n]=s,s}return{has:function(n){return t(n)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(n){let s=t(n);return s===null&&Lo("WebGLRenderer: "+n+" extension not supported."),s}}}function tb(i,e,t,n){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&e.remove(g.index);for(let m in g.attributes)e.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let M=r.get(g);M&&(e.remove(M),r.delete(g)),n.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,t.memory.geometries--}function c(g,M){return s[M.id]!==void 0||(M.addEventListener("dispose",a),s[M.id]=new WeakRef(M),o.register(M,M.id,M),t.memory.geometries++),M}function u(g){let M=g.attributes;for(let m in M)e.update(M[m],i.ARRAY_BUFFER)}function h(g){let M=g.index,m=g.attributes.position,p=0;if(m===void 0)return;let v=M!==null?M.array.length:m.array.length/3-1,T=m.count>=65535?Go:Vo,b=new T(Math.ceil(v/3)*6,1),C=b.array;if(M!==null){let _=M.array;p=M.version;for(let A=0,B=0;A<v;A+=3){let D=_[A+0],N=_[A+1],k=_[A+2];C[B++]=D,C[B++]=N,C[B++]=N,C[B++]=k,C[B++]=k,C[B++]=D}}else{p=m.version;for(let _=0,A=0;_<v;_+=3){let B=_+0,D=_+1,N=_+2;C[A++]=B,C[A++]=D,C[A++]=D,C[A++]=N,C[A++]=N,C[A++]=B}}b.version=p;let E=r.get(g);E&&e.remove(E),r.set(g,b)}function d(g){let M=r.get(g);if(M){let m=g.index;m!==null&&M.version<m.version&&h(g)}else h(g);return r.get(g)}function f(){for(let g in s){let M=s[g].deref();M!==void 0&&l(M)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function nb(i,e,t){let n;function s(h){n=h}let r,o;function a(h){r=h.type,o=h.bytesPerElement}function l(h,d){i.drawElements(n,d,r,h*o),t.update(d,n,1)}function c(h,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,h*o,f),t.update(d,n,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,h,0,f);let M=0;for(let m=0;m<f;m++)M+=d[m];t.update(M,n,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function ib(i){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(t.calls++,o){case i.TRIANGLES:t.triangles+=a*(r/3);break;case i.LINES:t.lines+=a*(r/2);break;case i.LINE_STRIP:t.lines+=a*(r-1);break;case i.LINE_LOOP:t.lines+=a*r;break;case i.POINTS:t.points+=a*r;break;default:Qe("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:n}}function sb(i,e,t){let n=new WeakMap,s=new Wt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=n.get(a);if(d===void 0||d.count!==h){let B=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",B)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,M=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],T=0;f===!0&&(T=1),g===!0&&(T=2),M===!0&&(T=3);let b=a.attributes.position.count*T,C=1;b>e.maxTextureSize&&(C=Math.ceil(b/e.maxTextureSize),b=e.maxTextureSize);let E=new Float32Array(b*C*4*h),_=new Bo(E,b,C,h);_.type=Ei,_.needsUpdate=!0;let A=T*4;for(let D=0;D<h;D++){let N=m[D],k=p[D],G=v[D],L=b*C*4*D;for(let H=0;H<N.count;H++){let Y=H*A;f===!0&&(s.fromBufferAttribute(N,H),E[L+Y+0]=s.x,E[L+Y+1]=s.y,E[L+Y+2]=s.z,E[L+Y+3]=0),g===!0&&(s.fromBufferAttribute(k,H),E[L+Y+4]=s.x,E[L+Y+5]=s.y,E[L+Y+6]=s.z,E[L+Y+7]=0),M===!0&&(s.fromBufferAttribute(G,H),E[L+Y+8]=s.x,E[L+Y+9]=s.y,E[L+Y+10]=s.z,E[L+Y+11]=G.itemSize===4?s.w:1)}}d={count:h,texture:_,size:new ot(b,C)},n.set(a,d),a.addEventListener("dispose",B)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,t);else{let f=0;for(let M=0;M<c.length;M++)f+=c[M];let g=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(i,"morphTargetBaseInfluence",g),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function rb(i,e,t,n,s){let r=new WeakMap;function o(c){let u=s.render.frame,h=c.geometry,d=e.get(c,h);if(r.get(d)!==u&&(e.update(d),r.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,i.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,i.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return d}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),n.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var ob={[hh]:"LINEAR_TONE_MAPPING",[dh]:"REINHARD_TONE_MAPPING",[fh]:"CINEON_TONE_MAPPING",[ph]:"ACES_FILMIC_TONE_MAPPING",[gh]:"AGX_TONE_MAPPING",[xh]:"NEUTRAL_TONE_MAPPING",[mh]:"CUSTOM_TONE_MAPPING"};function ab(i,e,t,n,s,r){let o=new ni(e,t,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Gn;u.setAttribute("position",new un([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new un([0,2,0,0,2,0],2));let h=new Pl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new yt(u,h),f=new jo(-1,1,1,-1,0,1),g=null,M=null,m=!1,p,v=null,T=[],b=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let _=0;_<T.length;_++){let A=T[_];A.setSize&&A.setSize(C,E)}},this.setEffects=function(C){T=C,b=T.length>0&&T[0].isRenderPass===!0;let E=o.width,_=o.height;T.length>0&&a===null&&(a=new ni(E,_,{type:Ti,depthBuffer:!1,stencilBuffer:!1}),l=new ni(E,_,{type:Ti,depthBuffer:!1,stencilBuffer:!1}));let A=s===!0&&T.some(B=>B.needsDepthTexture===!0);A!==(o.depthTexture!==null)&&(A===!0&&c===null&&(c=new as(E,_),r===!0&&(c.format=fs,c.type=tr)),o.dispose(),o.depthTexture=A?c:null,o.resolveDepthBuffer=A,o.storeMultisampledDepthBuffer=A);for(let B=0;B<T.length;B++){let D=T[B];D.setSize&&D.setSize(E,_),A&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(C,E){if(m||C.toneMapping===Wi&&T.length===0)return!1;if(v=E,E!==null){let _=E.width,A=E.height;(o.width!==_||o.height!==A)&&this.setSize(_,A)}return b===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Wi,!0},this.hasRenderPass=function(){return b},this.end=function(C,E){C.toneMapping=p,m=!0;let _=o,A=a;for(let B=0;B<T.length;B++){let D=T[B];D.enabled!==!1&&(D.render(C,A,_,E),D.needsSwap!==!1&&(_=A,A=A===a?l:a))}if(g!==C.outputColorSpace||M!==C.toneMapping){g=C.outputColorSpace,M=C.toneMapping,h.defines={},mt.getTransfer(g)===wt&&(h.defines.SRGB_TRANSFER="");let B=ob[M];B&&(h.defines[B]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=_.texture,C.setRenderTarget(v),C.render(d,f),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var dm=new Wn,fm=new as(1,1),pm=new Wo(1),mm=new Bo,gm=new Al,xm=new Ho,Xp=[],qp=[],Yp=new Float32Array(16),$p=new Float32Array(9),Zp=new Float32Array(4);function to(i,e,t){let n=i[0];if(n<=0||n>0)return i;let s=e*t,r=Xp[s];if(r===void 0&&(r=new Float32Array(s),Xp[s]=r),e!==0){n.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,i[o].toArray(r,a)}return r}function mn(i,e){if(i.length!==e.length)return!1;for(let t=0,n=i.length;t<n;t++)if(i[t]!==e[t])return!1;return!0}function gn(i,e){for(let t=0,n=e.length;t<n;t++)i[t]=e[t]}function Fc(i,e){let t=qp[e];t===void 0&&(t=new Int32Array(e),qp[e]=t);for(let n=0;n!==e;++n)t[n]=i.allocateTextureUnit();return t}function lb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1f(this.addr,e),t[0]=e)}function cb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2fv(this.addr,e),gn(t,e)}}function ub(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(i.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(mn(t,e))return;i.uniform3fv(this.addr,e),gn(t,e)}}function hb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4fv(this.addr,e),gn(t,e)}}function db(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix2fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;Zp.set(n),i.uniformMatrix2fv(this.addr,!1,Zp),gn(t,n)}}function fb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix3fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;$p.set(n),i.uniformMatrix3fv(this.addr,!1,$p),gn(t,n)}}function pb(i,e){let t=this.cache,n=e.elements;if(n===void 0){if(mn(t,e))return;i.uniformMatrix4fv(this.addr,!1,e),gn(t,e)}else{if(mn(t,n))return;Yp.set(n),i.uniformMatrix4fv(this.addr,!1,Yp),gn(t,n)}}function mb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1i(this.addr,e),t[0]=e)}function gb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2iv(this.addr,e),gn(t,e)}}function xb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;i.uniform3iv(this.addr,e),gn(t,e)}}function _b(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4iv(this.addr,e),gn(t,e)}}function vb(i,e){let t=this.cache;t[0]!==e&&(i.uniform1ui(this.addr,e),t[0]=e)}function yb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(i.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(mn(t,e))return;i.uniform2uiv(this.addr,e),gn(t,e)}}function bb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(i.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(mn(t,e))return;i.uniform3uiv(this.addr,e),gn(t,e)}}function Mb(i,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(i.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(mn(t,e))return;i.uniform4uiv(this.addr,e),gn(t,e)}}function Uc(i){return i.version===0&&(i.compareFunction=Rh,i.needsUpdate=!0),i}function Sb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=Uc(fm):r=dm,t.setTexture2D(e||r,s)}function wb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture3D(e||gm,s)}function Ab(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=Uc(pm):r=xm,t.setTextureCube(e||r,s)}function Eb(i,e,t){let n=this.cache,s=t.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),t.setTexture2DArray(e||mm,s)}function Tb(i){switch(i){case 5126:return lb;case 35664:return cb;case 35665:return ub;case 35666:return hb;case 35674:return db;case 35675:return fb;case 35676:return pb;case 5124:case 35670:return mb;case 35667:case 35671:return gb;case 35668:case 35672:return xb;case 35669:case 35673:return _b;case 5125:return vb;case 36294:return yb;case 36295:return bb;case 36296:return Mb;case 35678:case 36198:case 36298:case 36306:case 35682:return Sb;case 35679:case 36299:case 36307:return wb;case 35680:case 36300:case 36308:case 36293:return Ab;case 36289:case 36303:case 36311:case 36292:return Eb}}function Rb(i,e){i.uniform1fv(this.addr,e)}function Cb(i,e){let t=to(e,this.size,2);i.uniform2fv(this.addr,t)}function Pb(i,e){let t=to(e,this.size,3);i.uniform3fv(this.addr,t)}function Ib(i,e){let t=to(e,this.size,4);i.uniform4fv(this.addr,t)}function Lb(i,e){let t=to(e,this.size,4);i.uniformMatrix2fv(this.addr,!1,t)}function Nb(i,e){let t=to(e,this.size,9);i.uniformMatrix3fv(this.addr,!1,t)}function Db(i,e){let t=to(e,this.size,16);i.uniformMatrix4fv(this.addr,!1,t)}function Fb(i,e){i.uniform1iv(this.addr,e)}function Ub(i,e){i.uniform2iv(this.addr,e)}function Ob(i,e){i.uniform3iv(this.addr,e)}function Bb(i,e){i.uniform4iv(this.addr,e)}function kb(i,e){i.uniform1uiv(this.addr,e)}function zb(i,e){i.uniform2uiv(this.addr,e)}function Vb(i,e){i.uniform3uiv(this.addr,e)}function Gb(i,e){i.uniform4uiv(this.addr,e)}function Hb(i,e,t){let n=this.cache,s=e.length,r=Fc(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=Uc(fm):o=dm;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function Wb(i,e,t){let n=this.cache,s=e.length,r=Fc(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||gm,r[o])}function Xb(i,e,t){let n=this.cache,s=e.length,r=Fc(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=Uc(pm):o=xm;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function qb(i,e,t){let n=this.cache,s=e.length,r=Fc(t,s);mn(n,r)||(i.uniform1iv(this.addr,r),gn(n,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||mm,r[o])}function Yb(i){switch(i){case 5126:return Rb;case 35664:return Cb;case 35665:return Pb;case 35666:return Ib;case 35674:return Lb;case 35675:return Nb;case 35676:return Db;case 5124:case 35670:return Fb;case 35667:case 35671:return Ub;case 35668:case 35672:return Ob;case 35669:case 35673:return Bb;case 5125:return kb;case 36294:return zb;case 36295:return Vb;case 36296:return Gb;case 35678:case 36198:case 36298:case 36306:case 35682:return Hb;case 35679:case 36299:case 36307:return Wb;case 35680:case 36300:case 36308:case 36293:return Xb;case 36289:case 36303:case 36311:case 36292:return qb}}var Oh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.setValue=Tb(t.type)}},Bh=class{constructor(e,t,n){this.id=e,this.addr=n,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=Yb(t.type)}},kh=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],n)}}},Fh=/(\w+)(\])?(\[|\.)?/g;function Jp(i,e){i.seq.push(e),i.map[e.id]=e}function $b(i,e,t){let n=i.name,s=n.length;for(Fh.lastIndex=0;;){let r=Fh.exec(n),o=Fh.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Jp(t,c===void 0?new Oh(a,i,e):new Bh(a,i,e));break}else{let h=t.map[a];h===void 0&&(h=new kh(a),Jp(t,h)),t=h}}}var eo=class{constructor(e,t){this.seq=[],this.map={};let n=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);$b(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,n,s){let r=this.map[t];r!==void 0&&r.setValue(e,n,s)}setOptional(e,t,n){let s=t[n];s!==void 0&&this.setValue(e,n,s)}static upload(e,t,n,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let n=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&n.push(o)}return n}};function Kp(i,e,t){let n=i.createShader(e);return i.shaderSource(n,t),i.compileShader(n),n}var Zb=37297,Jb=0;function Kb(i,e){let t=i.split(`
`),n=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return n.join(`
`)}var jp=new et;function jb(i){mt._getMatrix(jp,mt.workingColorSpace,i);let e=`mat3( ${jp.elements.map(t=>t.toFixed(4))} )`;switch(mt.getTransfer(i)){case Fo:return[e,"LinearTransferOETF"];case wt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",i),[e,"LinearTransferOETF"]}}function Qp(i,e,t){let n=i.getShaderParameter(e,i.COMPILE_STATUS),r=(i.getShaderInfoLog(e)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+Kb(i.getShaderSource(e),a)}else return r}function Qb(i,e){let t=jb(e);return[`vec4 ${i}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var eM={[hh]:"Linear",[dh]:"Reinhard",[fh]:"Cineon",[ph]:"ACESFilmic",[gh]:"AgX",[xh]:"Neutral",[mh]:"Custom"};function tM(i,e){let t=eM[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Lc=new q;function nM(){mt.getLuminanceCoefficients(Lc);let i=Lc.x.toFixed(4),e=Lc.y.toFixed(4),t=Lc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function iM(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(ha).join(`
`)}function sM(i){let e=[];for(let t in i){let n=i[t];n!==!1&&e.push("#define "+t+" "+n)}return e.join(`
`)}function rM(i,e){let t={},n=i.getProgramParameter(e,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(e,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:i.getAttribLocation(e,o),locationSize:a}}return t}function ha(i){return i!==""}function em(i,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function tm(i,e){return i.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var oM=/^[ \t]*#include +<([\w\d./]+)>/gm;function zh(i){return i.replace(oM,aM)}function aM(i,e){let t=ct[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return zh(t)}var lM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function nm(i){return i.replace(lM,cM)}function cM(i,e,t,n){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function im(i){let e=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?e+=`
#define HIGH_PRECISION`:i.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var uM={[Ks]:"SHADOWMAP_TYPE_PCF",[Jr]:"SHADOWMAP_TYPE_VSM"};function hM(i){return uM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var dM={[jr]:"ENVMAP_MODE_REFRACTION"};function fM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":dM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var pM={[ta]:"ENVMAP_BLENDING_MULTIPLY",[vp]:"ENVMAP_BLENDING_MIX",[yp]:"ENVMAP_BLENDING_ADD"};function mM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":pM[i.combine]||"ENVMAP_BLENDING_NONE"}function gM(i,e,t,n){let s=i.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=hM(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=fM(t),h=mM(t),d=iM(t),f=sM(r),g=s.createProgram(),M,m,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(M=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(ha).join(`
`),M.length>0&&(M+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(ha).join(`
`),m.length>0&&(m+=`
`)):(M=[im(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(ha).join(`
`),m=[im(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Wi?"#define TONE_MAPPING":"",t.toneMapping!==Wi?ct.tonemapping_pars_fragment:"",t.toneMapping!==Wi?tM("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ct.colorspace_pars_fragment,Qb("linearToOutputTexel",t.outputColorSpace),nM(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(ha).join(`
`)),o=zh(o),o=em(o,t),o=tm(o,t),a=zh(a),a=em(a,t),a=tm(a,t),o=nm(o),a=nm(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,M=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+M,m=["#define varying in",t.glslVersion===Ph?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Ph?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=p+M+o,T=p+m+a,b=Kp(s,s.VERTEX_SHADER,v),C=Kp(s,s.FRAGMENT_SHADER,T);s.attachShader(g,b),s.attachShader(g,C),t.index0AttributeName!==void 0?s.bindAttribLocation(g,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function E(D){if(i.debug.checkShaderErrors){let N=s.getProgramInfoLog(g)||"",k=s.getShaderInfoLog(b)||"",G=s.getShaderInfoLog(C)||"",L=N.trim(),H=k.trim(),Y=G.trim(),V=!0,le=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(V=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,g,b,C);else{let J=Qp(s,b,"vertex"),j=Qp(s,C,"fragment");Qe("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+L+`
`+J+`
`+j)}else L!==""?Ze("WebGLProgram: Program Info Log:",L):(H===""||Y==="")&&(le=!1);le&&(D.diagnostics={runnable:V,programLog:L,vertexShader:{log:H,prefix:M},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(b),s.deleteShader(C),_=new eo(s,g),A=rM(s,g)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let A;this.getAttributes=function(){return A===void 0&&E(this),A};let B=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return B===!1&&(B=s.getProgramParameter(g,Zb)),B},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=Jb++,this.cacheKey=e,this.usedTimes=1,this.program=g,this.vertexShader=b,this.fragmentShader=C,this}var xM=0,Vh=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,n){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let n of t)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,n=t.get(e);return n===void 0&&(n=new Set,t.set(e,n)),n}_getShaderStage(e){let t=this.shaderCache,n=t.get(e);return n===void 0&&(n=new Gh(e),t.set(e,n)),n}},Gh=class{constructor(e){this.id=xM++,this.code=e,this.usedTimes=0}};function _M(i){return i===Os||i===aa||i===la}function vM(i,e,t,n,s,r){let o=new ko,a=new Vh,l=new Set,c=[],u=new Map,h=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return l.add(_),_===0?"uv":`uv${_}`}function g(_,A,B,D,N,k){let G=D.fog,L=N.geometry,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?D.environment:null,Y=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=e.get(_.envMap||H,Y),le=d[_.type],J=n.precision;_.precision!==null&&(J=n.getMaxPrecision(_.precision),J!==_.precision&&Ze("WebGLProgram.getParameters:",_.precision,"not supported, using",J,"instead."));let j=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ie=j!==void 0?j.length:0,de=0;L.morphAttributes.position!==void 0&&(de=1),L.morphAttributes.normal!==void 0&&(de=2),L.morphAttributes.color!==void 0&&(de=3);let ue,Q,me,_e;if(le){let Re=qi[le];ue=Re.vertexShader,Q=Re.fragmentShader}else{ue=_.vertexShader,Q=_.fragmentShader;let Re=a.getVertexShaderStage(_),rt=a.getFragmentShaderStage(_);a.update(_,Re,rt),me=Re.id,_e=rt.id}let Te=i.getRenderTarget(),Me=i.state.buffers.depth.getReversed(),He=N.isInstancedMesh===!0,it=N.isBatchedMesh===!0,Ve=!!_.map,ut=!!_.matcap,at=!!V,tt=at&&V.isPMREMTexture===!0,Vt=!!_.aoMap,Dt=!!_.lightMap,tn=!!_.bumpMap&&_.wireframe===!1,Ct=!!_.normalMap,vn=!!_.displacementMap,_t=!!_.emissiveMap,dn=!!_.metalnessMap,qt=!!_.roughnessMap,nn=_.anisotropy>0,U=_.clearcoat>0,Ce=_.diffuseRoughness>0,qe=_.dispersion>0,st=_.retroreflectivity>0,Se=_.iridescence>0,It=_.sheen>0,ze=_.transmission>0,Xe=nn&&!!_.anisotropyMap,R=U&&!!_.clearcoatMap,y=U&&!!_.clearcoatNormalMap,W=U&&!!_.clearcoatRoughnessMap,ce=Ce&&!!_.diffuseRoughnessMap,re=Se&&!!_.iridescenceMap,xe=Se&&!!_.iridescenceThicknessMap,ve=It&&!!_.sheenColorMap,ee=It&&!!_.sheenRoughnessMap,ne=!!_.specularMap,pe=!!_.specularColorMap,F=!!_.specularIntensityMap,se=ze&&!!_.transmissionMap,te=ze&&!!_.thicknessMap,we=!!_.gradientMap,ge=!!_.alphaMap,be=_.alphaTest>0,Ge=!!_.alphaHash,Je=!!_.extensions,ae=Wi;_.toneMapped&&(Te===null||Te.isXRRenderTarget===!0)&&(ae=i.toneMapping);let Oe=tt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Ke={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:ue,fragmentShader:Q,defines:_.defines,customVertexShaderID:me,customFragmentShaderID:_e,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:J,batching:it,batchingColor:it&&N._colorsTexture!==null,instancing:He,instancingColor:He&&N.instanceColor!==null,instancingMorph:He&&N.morphTexture!==null,outputColorSpace:Te===null?i.outputColorSpace:Te.isXRRenderTarget===!0?Te.texture.colorSpace:mt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Ve,matcap:ut,envMap:at,envMapMode:at&&V.mapping,envMapPMREM:tt,envMapMaxLod:tt?Oe.length-1:null,envMapSize:tt?Oe[0].width:null,aoMap:Vt,lightMap:Dt,bumpMap:tn,normalMap:Ct,displacementMap:vn,emissiveMap:_t,normalMapObjectSpace:Ct&&_.normalMapType===Sp,normalMapTangentSpace:Ct&&_.normalMapType===ca,packedNormalMap:Ct&&_.normalMapType===ca&&_M(_.normalMap.format),metalnessMap:dn,roughnessMap:qt,anisotropy:nn,anisotropyMap:Xe,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:y,clearcoatRoughnessMap:W,diffuseRoughness:Ce,diffuseRoughnessMap:ce,dispersion:qe,retroreflection:st,iridescence:Se,iridescenceMap:re,iridescenceThicknessMap:xe,sheen:It,sheenColorMap:ve,sheenRoughnessMap:ee,specularMap:ne,specularColorMap:pe,specularIntensityMap:F,transmission:ze,transmissionMap:se,thicknessMap:te,gradientMap:we,opaque:_.transparent===!1&&_.blending===Kr&&_.alphaToCoverage===!1,alphaMap:ge,alphaTest:be,alphaHash:Ge,combine:_.combine,mapUv:Ve&&f(_.map.channel),aoMapUv:Vt&&f(_.aoMap.channel),lightMapUv:Dt&&f(_.lightMap.channel),bumpMapUv:tn&&f(_.bumpMap.channel),normalMapUv:Ct&&f(_.normalMap.channel),displacementMapUv:vn&&f(_.displacementMap.channel),emissiveMapUv:_t&&f(_.emissiveMap.channel),metalnessMapUv:dn&&f(_.metalnessMap.channel),roughnessMapUv:qt&&f(_.roughnessMap.channel),anisotropyMapUv:Xe&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:y&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:W&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ce&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:re&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:ee&&f(_.sheenRoughnessMap.channel),specularMapUv:ne&&f(_.specularMap.channel),specularColorMapUv:pe&&f(_.specularColorMap.channel),specularIntensityMapUv:F&&f(_.specularIntensityMap.channel),transmissionMapUv:se&&f(_.transmissionMap.channel),thicknessMapUv:te&&f(_.thicknessMap.channel),alphaMapUv:ge&&f(_.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Ct||nn),vertexNormals:!!L.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:N.isPoints===!0&&!!L.attributes.uv&&(Ve||ge),fog:!!G,useFog:_.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||L.attributes.normal===void 0&&Ct===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Me,skinning:N.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:A.sun.length,numDirLights:A.directional.length,numPointLights:A.point.length,numSpotLights:A.spot.length,numSpotLightMaps:A.spotLightMap.length,numRectAreaLights:A.rectArea.length,numHemiLights:A.hemi.length,numSunLightShadows:A.sunShadowMap.length,numDirLightShadows:A.directionalShadowMap.length,numPointLightShadows:A.pointShadowMap.length,numSpotLightShadows:A.spotShadowMap.length,numSpotLightShadowsWithMaps:A.numSpotLightShadowsWithMaps,numLightProbes:A.numLightProbes,numLightProbeGrids:k.filter(Re=>Re.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&B.length>0,shadowMapType:i.shadowMap.type,toneMapping:ae,decodeVideoTexture:Ve&&_.map.isVideoTexture===!0&&mt.getTransfer(_.map.colorSpace)===wt,decodeVideoTextureEmissive:_t&&_.emissiveMap.isVideoTexture===!0&&mt.getTransfer(_.emissiveMap.colorSpace)===wt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===fi,flipSided:_.side===en,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:Je&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Je&&_.extensions.multiDraw===!0||it)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ke.vertexUv1s=l.has(1),Ke.vertexUv2s=l.has(2),Ke.vertexUv3s=l.has(3),l.clear(),Ke}function M(_){let A=[];if(_.shaderID?A.push(_.shaderID):(A.push(_.customVertexShaderID),A.push(_.customFragmentShaderID)),_.defines!==void 0)for(let B in _.defines)A.push(B),A.push(_.defines[B]);return _.isRawShaderMaterial===!1&&(m(A,_),p(A,_),A.push(i.outputColorSpace)),A.push(_.customProgramCacheKey),A.join()}function m(_,A){_.push(A.precision),_.push(A.outputColorSpace),_.push(A.envMapMode),_.push(A.envMapPMREM),_.push(A.envMapMaxLod),_.push(A.envMapSize),_.push(A.mapUv),_.push(A.alphaMapUv),_.push(A.lightMapUv),_.push(A.aoMapUv),_.push(A.bumpMapUv),_.push(A.normalMapUv),_.push(A.displacementMapUv),_.push(A.emissiveMapUv),_.push(A.metalnessMapUv),_.push(A.roughnessMapUv),_.push(A.anisotropyMapUv),_.push(A.clearcoatMapUv),_.push(A.clearcoatNormalMapUv),_.push(A.clearcoatRoughnessMapUv),_.push(A.diffuseRoughnessMapUv),_.push(A.iridescenceMapUv),_.push(A.iridescenceThicknessMapUv),_.push(A.sheenColorMapUv),_.push(A.sheenRoughnessMapUv),_.push(A.specularMapUv),_.push(A.specularColorMapUv),_.push(A.specularIntensityMapUv),_.push(A.transmissionMapUv),_.push(A.thicknessMapUv),_.push(A.combine),_.push(A.fogExp2),_.push(A.sizeAttenuation),_.push(A.morphTargetsCount),_.push(A.numSunLights),_.push(A.numDirLights),_.push(A.numPointLights),_.push(A.numSpotLights),_.push(A.numSpotLightMaps),_.push(A.numHemiLights),_.push(A.numRectAreaLights),_.push(A.numSunLightShadows),_.push(A.numDirLightShadows),_.push(A.numPointLightShadows),_.push(A.numSpotLightShadows),_.push(A.numSpotLightShadowsWithMaps),_.push(A.numLightProbes),_.push(A.numLightProbeGrids),_.push(A.shadowMapType),_.push(A.toneMapping),_.push(A.numClippingPlanes),_.push(A.numClipIntersection),_.push(A.depthPacking)}function p(_,A){o.disableAll(),A.instancing&&o.enable(0),A.instancingColor&&o.enable(1),A.instancingMorph&&o.enable(2),A.matcap&&o.enable(3),A.envMap&&o.enable(4),A.normalMapObjectSpace&&o.enable(5),A.normalMapTangentSpace&&o.enable(6),A.clearcoat&&o.enable(7),A.iridescence&&o.enable(8),A.alphaTest&&o.enable(9),A.vertexColors&&o.enable(10),A.vertexAlphas&&o.enable(11),A.vertexUv1s&&o.enable(12),A.vertexUv2s&&o.enable(13),A.vertexUv3s&&o.enable(14),A.vertexTangents&&o.enable(15),A.anisotropy&&o.enable(16),A.alphaHash&&o.enable(17),A.batching&&o.enable(18),A.dispersion&&o.enable(19),A.retroreflection&&o.enable(24),A.diffuseRoughness&&o.enable(25),A.batchingColor&&o.enable(20),A.gradientMap&&o.enable(21),A.packedNormalMap&&o.enable(22),A.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),A.fog&&o.enable(0),A.useFog&&o.enable(1),A.flatShading&&o.enable(2),A.logarithmicDepthBuffer&&o.enable(3),A.reversedDepthBuffer&&o.enable(4),A.skinning&&o.enable(5),A.morphTargets&&o.enable(6),A.morphNormals&&o.enable(7),A.morphColors&&o.enable(8),A.premultipliedAlpha&&o.enable(9),A.shadowMapEnabled&&o.enable(10),A.doubleSided&&o.enable(11),A.flipSided&&o.enable(12),A.useDepthPacking&&o.enable(13),A.dithering&&o.enable(14),A.transmission&&o.enable(15),A.sheen&&o.enable(16),A.opaque&&o.enable(17),A.pointsUvs&&o.enable(18),A.decodeVideoTexture&&o.enable(19),A.decodeVideoTextureEmissive&&o.enable(20),A.alphaToCoverage&&o.enable(21),A.numLightProbeGrids>0&&o.enable(22),A.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let A=d[_.type],B;if(A){let D=qi[A];B=Bp.clone(D.uniforms)}else B=_.uniforms;return B}function T(_,A){let B=u.get(A);return B!==void 0?++B.usedTimes:(B=new gM(i,A,_,s),c.push(B),u.set(A,B)),B}function b(_){if(--_.usedTimes===0){let A=c.indexOf(_);c[A]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function C(_){a.remove(_)}function E(){a.dispose()}return{getParameters:g,getProgramCacheKey:M,getUniforms:v,acquireProgram:T,releaseProgram:b,releaseShaderCache:C,programs:c,dispose:E}}function yM(){let i=new WeakMap;function e(o){return i.has(o)}function t(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:e,get:t,remove:n,update:s,dispose:r}}function bM(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.material.id!==e.material.id?i.material.id-e.material.id:i.materialVariant!==e.materialVariant?i.materialVariant-e.materialVariant:i.z!==e.z?i.z-e.z:i.id-e.id}function sm(i,e){return i.groupOrder!==e.groupOrder?i.groupOrder-e.groupOrder:i.renderOrder!==e.renderOrder?i.renderOrder-e.renderOrder:i.z!==e.z?e.z-i.z:i.id-e.id}function rm(){let i=[],e=0,t=[],n=[],s=[];function r(){e=0,t.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,g,M,m,p){let v=i[e];return v===void 0?(v={id:d.id,object:d,geometry:f,material:g,materialVariant:o(d),groupOrder:M,renderOrder:d.renderOrder,z:m,group:p},i[e]=v):(v.id=d.id,v.object=d,v.geometry=f,v.material=g,v.materialVariant=o(d),v.groupOrder=M,v.renderOrder=d.renderOrder,v.z=m,v.group=p),e++,v}function l(d,f,g,M,m,p,v){v.reversedDepth===!0&&(m=-m);let T=a(d,f,g,M,m,p);g.transmission>0?n.push(T):g.transparent===!0?s.push(T):t.push(T)}function c(d,f,g,M,m,p){let v=a(d,f,g,M,m,p);g.transmission>0?n.unshift(v):g.transparent===!0?s.unshift(v):t.unshift(v)}function u(d,f){t.length>1&&t.sort(d||bM),n.length>1&&n.sort(f||sm),s.length>1&&s.sort(f||sm)}function h(){for(let d=e,f=i.length;d<f;d++){let g=i[d];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:t,transmissive:n,transparent:s,init:r,push:l,unshift:c,finish:h,sort:u}}function MM(){let i=new WeakMap;function e(n,s){let r=i.get(n),o;return r===void 0?(o=new rm,i.set(n,[o])):s>=r.length?(o=new rm,r.push(o)):o=r[s],o}function t(){i=new WeakMap}return{get:e,dispose:t}}function SM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new q,color:new Ye};break;case"SpotLight":t={position:new q,direction:new q,color:new Ye,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new q,color:new Ye,distance:0,decay:0};break;case"HemisphereLight":t={direction:new q,skyColor:new Ye,groundColor:new Ye};break;case"RectAreaLight":t={color:new Ye,position:new q,halfWidth:new q,halfHeight:new q};break}return i[e.id]=t,t}}}function wM(){let i={};return{get:function(e){if(i[e.id]!==void 0)return i[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ot};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ot};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new ot,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[e.id]=t,t}}}var AM=0;function EM(i,e){return(e.castShadow?2:0)-(i.castShadow?2:0)+(e.map?1:0)-(i.map?1:0)}function TM(i){let e=new SM,t=wM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new q);let s=new q,r=new Ht,o=new Ht;function a(c){let u=0,h=0,d=0;for(let k=0;k<9;k++)n.probe[k].set(0,0,0);let f=0,g=0,M=0,m=0,p=0,v=0,T=0,b=0,C=0,E=0,_=0,A=0,B=0,D=0;c.sort(EM);for(let k=0,G=c.length;k<G;k++){let L=c[k],H=L.color,Y=L.intensity,V=L.distance,le=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Os?le=L.shadow.map.texture:le=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=H.r*Y,h+=H.g*Y,d+=H.b*Y;else if(L.isLightProbe){for(let J=0;J<9;J++)n.probe[J].addScaledVector(L.sh.coefficients[J],Y);D++}else if(L.isSunLight){let J=e.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[g]=ie,n.sunShadowMap[g]=le;let de=j.getViewportCount();for(let ue=0;ue<de;ue++)n.sunShadowMatrix[M+ue]=j.getMatrix(ue),n.sunShadowCascade[M+ue]=j._cascadeData[ue];M+=de,g++}n.sun[f]=J,f++}else if(L.isDirectionalLight){let J=e.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.directionalShadow[m]=ie,n.directionalShadowMap[m]=le,n.directionalShadowMatrix[m]=L.shadow.matrix,C++}n.directional[m]=J,m++}else if(L.isSpotLight){let J=e.get(L);J.position.setFromMatrixPosition(L.matrixWorld),J.color.copy(H).multiplyScalar(Y),J.distance=V,J.coneCos=Math.cos(L.angle),J.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),J.decay=L.decay,n.spot[v]=J;let j=L.shadow;if(L.map&&(n.spotLightMap[A]=L.map,A++,j.updateMatrices(L),L.castShadow&&B++),n.spotLightMatrix[v]=j.matrix,L.castShadow){let ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,n.spotShadow[v]=ie,n.spotShadowMap[v]=le,_++}v++}else if(L.isRectAreaLight){let J=e.get(L);J.color.copy(H).multiplyScalar(Y),J.halfWidth.set(L.width*.5,0,0),J.halfHeight.set(0,L.height*.5,0),n.rectArea[T]=J,T++}else if(L.isPointLight){let J=e.get(L);if(J.color.copy(L.color).multiplyScalar(L.intensity),J.distance=L.distance,J.decay=L.decay,L.castShadow){let j=L.shadow,ie=t.get(L);ie.shadowIntensity=j.intensity,ie.shadowBias=j.bias,ie.shadowNormalBias=j.normalBias,ie.shadowRadius=j.radius,ie.shadowMapSize=j.mapSize,ie.shadowCameraNear=j.camera.near,ie.shadowCameraFar=j.camera.far,n.pointShadow[p]=ie,n.pointShadowMap[p]=le,n.pointShadowMatrix[p]=L.shadow.matrix,E++}n.point[p]=J,p++}else if(L.isHemisphereLight){let J=e.get(L);J.skyColor.copy(L.color).multiplyScalar(Y),J.groundColor.copy(L.groundColor).multiplyScalar(Y),n.hemi[b]=J,b++}}T>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=Le.LTC_FLOAT_1,n.rectAreaLTC2=Le.LTC_FLOAT_2):(n.rectAreaLTC1=Le.LTC_HALF_1,n.rectAreaLTC2=Le.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=d;let N=n.hash;(N.sunLength!==f||N.directionalLength!==m||N.pointLength!==p||N.spotLength!==v||N.rectAreaLength!==T||N.hemiLength!==b||N.numSunShadows!==g||N.numDirectionalShadows!==C||N.numPointShadows!==E||N.numSpotShadows!==_||N.numSpotMaps!==A||N.numLightProbes!==D)&&(n.sun.length=f,n.directional.length=m,n.spot.length=v,n.rectArea.length=T,n.point.length=p,n.hemi.length=b,n.sunShadow.length=g,n.sunShadowMap.length=g,n.sunShadowMatrix.length=M,n.sunShadowCascade.length=M,n.directionalShadow.length=C,n.directionalShadowMap.length=C,n.directionalShadowMatrix.length=C,n.pointShadow.length=E,n.pointShadowMap.length=E,n.pointShadowMatrix.length=E,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+A-B,n.spotLightMap.length=A,n.numSpotLightShadowsWithMaps=B,n.numLightProbes=D,N.sunLength=f,N.directionalLength=m,N.pointLength=p,N.spotLength=v,N.rectAreaLength=T,N.hemiLength=b,N.numSunShadows=g,N.numDirectionalShadows=C,N.numPointShadows=E,N.numSpotShadows=_,N.numSpotMaps=A,N.numLightProbes=D,n.version=AM++)}function l(c,u){let h=0,d=0,f=0,g=0,M=0,m=0,p=u.matrixWorldInverse;for(let v=0,T=c.length;v<T;v++){let b=c[v];if(b.isSunLight){let C=n.sun[h];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),h++}else if(b.isDirectionalLight){let C=n.directional[d];C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),d++}else if(b.isSpotLight){let C=n.spot[g];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),C.direction.sub(s),C.direction.transformDirection(p),g++}else if(b.isRectAreaLight){let C=n.rectArea[M];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),o.identity(),r.copy(b.matrixWorld),r.premultiply(p),o.extractRotation(r),C.halfWidth.set(b.width*.5,0,0),C.halfHeight.set(0,b.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),M++}else if(b.isPointLight){let C=n.point[f];C.position.setFromMatrixPosition(b.matrixWorld),C.position.applyMatrix4(p),f++}else if(b.isHemisphereLight){let C=n.hemi[m];C.direction.setFromMatrixPosition(b.matrixWorld),C.direction.transformDirection(p),m++}}}return{setup:a,setupView:l,state:n}}function om(i){let e=new TM(i),t=[],n=[],s=[];function r(h){u.camera=h,t.length=0,n.length=0,s.length=0}function o(h){h.isLightProbeGrid?s.push(h):t.push(h)}function a(h){n.push(h)}function l(){e.setup(t),s.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function RM(i){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new om(i),e.set(s,[a])):r>=o.length?(a=new om(i),o.push(a)):a=o[r],a}function n(){e=new WeakMap}return{get:t,dispose:n}}var CM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,PM=`uniform sampler2D shadow_pass;
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
}`,IM=[new q(1,0,0),new q(-1,0,0),new q(0,1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1)],LM=[new q(0,-1,0),new q(0,-1,0),new q(0,0,1),new q(0,0,-1),new q(0,-1,0),new q(0,-1,0)],am=new Ht,ua=new q,Uh=new q;function NM(i,e,t){let n=new Ls,s=new ot,r=new ot,o=new Wt,a=new Il,l=new Ll,c={},u=t.maxTextureSize,h={[qn]:en,[en]:qn,[fi]:fi},d=new Xn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new ot},radius:{value:4}},vertexShader:CM,fragmentShader:PM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let g=new Gn;g.setAttribute("position",new pn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let M=new yt(g,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ks;let p=this.type;this.render=function(E,_,A){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===ep&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ks);let B=i.getRenderTarget(),D=i.getActiveCubeFace(),N=i.getActiveMipmapLevel(),k=i.state;k.setBlending(js),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=p!==this.type;G&&_.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(H=>H.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,H=E.length;L<H;L++){let Y=E[L],V=Y.shadow;if(V===void 0){Ze("WebGLShadowMap:",Y,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let le=V.getFrameExtents();s.multiply(le),r.copy(V.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,V.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,V.mapSize.y=r.y));let J=i.state.buffers.depth.getReversed();if(V.camera._reversedDepth=J,V.map===null||G===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===Jr){if(Y.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new ni(s.x,s.y,{format:Os,type:Ti,minFilter:Vn,magFilter:Vn,generateMipmaps:!1}),V.map.texture.name=Y.name+".shadowMap",V.map.depthTexture=new as(s.x,s.y,Ei),V.map.depthTexture.name=Y.name+".shadowMapDepth",V.map.depthTexture.format=os,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=An,V.map.depthTexture.magFilter=An}else Y.isPointLight?(V.map=new da(s.x),V.map.depthTexture=new Wo(s.x,Ai)):(V.map=new ni(s.x,s.y),V.map.depthTexture=new as(s.x,s.y,Ai)),V.map.depthTexture.name=Y.name+".shadowMap",V.map.depthTexture.format=os,this.type===Ks?(V.map.depthTexture.compareFunction=J?Th:Eh,V.map.depthTexture.minFilter=Vn,V.map.depthTexture.magFilter=Vn):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=An,V.map.depthTexture.magFilter=An);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let j=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();Y.isPointLight!==!0&&V.updateMatrices(Y,A);let ie=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:A.layers;for(let de=0;de<j;de++){let ue=V.getCamera(de);if(Y.isPointLight){let Q=V.camera,me=V.matrix,_e=Y.distance||Q.far;_e!==Q.far&&(Q.far=_e,Q.updateProjectionMatrix()),ua.setFromMatrixPosition(Y.matrixWorld),Q.position.copy(ua),Uh.copy(Q.position),Uh.add(IM[de]),Q.up.copy(LM[de]),Q.lookAt(Uh),Q.updateMatrixWorld(),me.makeTranslation(-ua.x,-ua.y,-ua.z),am.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),V._frustum.setFromProjectionMatrix(am,Q.coordinateSystem,Q.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)i.setRenderTarget(V.map,de),i.clear();else{de===0&&(i.setRenderTarget(V.map),i.clear());let Q=V.getViewport(de);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),k.viewport(o)}n=V.getFrustum(de),b(_,A,ue,Y,ie,this.type)}V.isPointLightShadow!==!0&&this.type===Jr&&v(V,A),V.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(B,D,N)};function v(E,_){let A=e.update(M);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new ni(s.x,s.y,{format:Os,type:Ti}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,i.setRenderTarget(E.mapPass),i.clear(),i.renderBufferDirect(_,null,A,d,M,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,i.setRenderTarget(E.map),i.clear(),i.renderBufferDirect(_,null,A,f,M,null)}function T(E,_,A,B){let D=null,N=A.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(N!==void 0)D=N;else if(D=A.isPointLight===!0?l:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let k=D.uuid,G=_.uuid,L=c[k];L===void 0&&(L={},c[k]=L);let H=L[G];H===void 0&&(H=D.clone(),L[G]=H,_.addEventListener("dispose",C)),D=H}if(D.visible=_.visible,D.wireframe=_.wireframe,B===Jr?D.side=_.shadowSide!==null?_.shadowSide:_.side:D.side=_.shadowSide!==null?_.shadowSide:h[_.side],D.alphaMap=_.alphaMap,D.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,D.map=_.map,D.clipShadows=_.clipShadows,D.clippingPlanes=_.clippingPlanes,D.clipIntersection=_.clipIntersection,D.displacementMap=_.displacementMap,D.displacementScale=_.displacementScale,D.displacementBias=_.displacementBias,D.wireframeLinewidth=_.wireframeLinewidth,D.linewidth=_.linewidth,A.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let k=i.properties.get(D);k.light=A}return D}function b(E,_,A,B,D,N){if(E.visible===!1)return;if(E.layers.test(D)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&N===Jr)&&(!E.frustumCulled||E.intersectsFrustum(n))){E.modelViewMatrix.multiplyMatrices(A.matrixWorldInverse,E.matrixWorld);let L=e.update(E),H=E.material;if(Array.isArray(H)){let Y=L.groups;for(let V=0,le=Y.length;V<le;V++){let J=Y[V],j=H[J.materialIndex];if(j&&j.visible){let ie=T(E,j,B,N);E.onBeforeShadow(i,E,_,A,L,ie,J),i.renderBufferDirect(A,null,L,ie,E,J),E.onAfterShadow(i,E,_,A,L,ie,J)}}}else if(H.visible){let Y=T(E,H,B,N);E.onBeforeShadow(i,E,_,A,L,Y,null),i.renderBufferDirect(A,null,L,Y,E,null),E.onAfterShadow(i,E,_,A,L,Y,null)}}let G=E.children;for(let L=0,H=G.length;L<H;L++)b(G[L],_,A,B,D,N)}function C(E){E.target.removeEventListener("dispose",C);for(let A in c){let B=c[A],D=E.target.uuid;D in B&&(B[D].dispose(),delete B[D])}}}function DM(i,e){function t(){let F=!1,se=new Wt,te=null,we=new Wt(0,0,0,0);return{setMask:function(ge){te!==ge&&!F&&(i.colorMask(ge,ge,ge,ge),te=ge)},setLocked:function(ge){F=ge},setClear:function(ge,be,Ge,Je,ae){ae===!0&&(ge*=Je,be*=Je,Ge*=Je),se.set(ge,be,Ge,Je),we.equals(se)===!1&&(i.clearColor(ge,be,Ge,Je),we.copy(se))},reset:function(){F=!1,te=null,we.set(-1,0,0,0)}}}function n(){let F=!1,se=!1,te=null,we=null,ge=null;return{setReversed:function(be){if(se!==be){let Ge=e.get("EXT_clip_control");be?Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.ZERO_TO_ONE_EXT):Ge.clipControlEXT(Ge.LOWER_LEFT_EXT,Ge.NEGATIVE_ONE_TO_ONE_EXT),se=be;let Je=ge;ge=null,this.setClear(Je)}},getReversed:function(){return se},setTest:function(be){be?Me(i.DEPTH_TEST):He(i.DEPTH_TEST)},setMask:function(be){te!==be&&!F&&(i.depthMask(be),te=be)},setFunc:function(be){if(se&&(be=Np[be]),we!==be){switch(be){case dl:i.depthFunc(i.NEVER);break;case fl:i.depthFunc(i.ALWAYS);break;case pl:i.depthFunc(i.LESS);break;case Vr:i.depthFunc(i.LEQUAL);break;case ml:i.depthFunc(i.EQUAL);break;case gl:i.depthFunc(i.GEQUAL);break;case xl:i.depthFunc(i.GREATER);break;case _l:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}we=be}},setLocked:function(be){F=be},setClear:function(be){ge!==be&&(ge=be,se&&(be=1-be),i.clearDepth(be))},reset:function(){F=!1,te=null,we=null,ge=null,se=!1}}}function s(){let F=!1,se=null,te=null,we=null,ge=null,be=null,Ge=null,Je=null,ae=null;return{setTest:function(Oe){F||(Oe?Me(i.STENCIL_TEST):He(i.STENCIL_TEST))},setMask:function(Oe){se!==Oe&&!F&&(i.stencilMask(Oe),se=Oe)},setFunc:function(Oe,Ke,Re){(te!==Oe||we!==Ke||ge!==Re)&&(i.stencilFunc(Oe,Ke,Re),te=Oe,we=Ke,ge=Re)},setOp:function(Oe,Ke,Re){(be!==Oe||Ge!==Ke||Je!==Re)&&(i.stencilOp(Oe,Ke,Re),be=Oe,Ge=Ke,Je=Re)},setLocked:function(Oe){F=Oe},setClear:function(Oe){ae!==Oe&&(i.clearStencil(Oe),ae=Oe)},reset:function(){F=!1,se=null,te=null,we=null,ge=null,be=null,Ge=null,Je=null,ae=null}}}let r=new t,o=new n,a=new s,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,g=[],M=null,m=!1,p=null,v=null,T=null,b=null,C=null,E=null,_=null,A=new Ye(0,0,0),B=0,D=!1,N=null,k=null,G=null,L=null,H=null,Y=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,le=0,J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(J)[1]),V=le>=1):J.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),V=le>=2);let j=null,ie={},de=i.getParameter(i.SCISSOR_BOX),ue=i.getParameter(i.VIEWPORT),Q=new Wt().fromArray(de),me=new Wt().fromArray(ue);function _e(F,se,te,we){let ge=new Uint8Array(4),be=i.createTexture();i.bindTexture(F,be),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ge=0;Ge<te;Ge++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(se,0,i.RGBA,1,1,we,0,i.RGBA,i.UNSIGNED_BYTE,ge):i.texImage2D(se+Ge,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ge);return be}let Te={};Te[i.TEXTURE_2D]=_e(i.TEXTURE_2D,i.TEXTURE_2D,1),Te[i.TEXTURE_CUBE_MAP]=_e(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Te[i.TEXTURE_2D_ARRAY]=_e(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Te[i.TEXTURE_3D]=_e(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Me(i.DEPTH_TEST),o.setFunc(Vr),tn(!1),Ct(rh),Me(i.CULL_FACE),Vt(js);function Me(F){u[F]!==!0&&(i.enable(F),u[F]=!0)}function He(F){u[F]!==!1&&(i.disable(F),u[F]=!1)}function it(F,se){return d[F]!==se?(i.bindFramebuffer(F,se),d[F]=se,F===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=se),F===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=se),!0):!1}function Ve(F,se){let te=g,we=!1;if(F){te=f.get(se),te===void 0&&(te=[],f.set(se,te));let ge=F.textures;if(te.length!==ge.length||te[0]!==i.COLOR_ATTACHMENT0){for(let be=0,Ge=ge.length;be<Ge;be++)te[be]=i.COLOR_ATTACHMENT0+be;te.length=ge.length,we=!0}}else te[0]!==i.BACK&&(te[0]=i.BACK,we=!0);we&&i.drawBuffers(te)}function ut(F){return M!==F?(i.useProgram(F),M=F,!0):!1}let at={[Qs]:i.FUNC_ADD,[np]:i.FUNC_SUBTRACT,[ip]:i.FUNC_REVERSE_SUBTRACT};at[sp]=i.MIN,at[rp]=i.MAX;let tt={[op]:i.ZERO,[ap]:i.ONE,[lp]:i.SRC_COLOR,[ch]:i.SRC_ALPHA,[pp]:i.SRC_ALPHA_SATURATE,[dp]:i.DST_COLOR,[up]:i.DST_ALPHA,[cp]:i.ONE_MINUS_SRC_COLOR,[uh]:i.ONE_MINUS_SRC_ALPHA,[fp]:i.ONE_MINUS_DST_COLOR,[hp]:i.ONE_MINUS_DST_ALPHA,[mp]:i.CONSTANT_COLOR,[gp]:i.ONE_MINUS_CONSTANT_COLOR,[xp]:i.CONSTANT_ALPHA,[_p]:i.ONE_MINUS_CONSTANT_ALPHA};function Vt(F,se,te,we,ge,be,Ge,Je,ae,Oe){if(F===js){m===!0&&(He(i.BLEND),m=!1);return}if(m===!1&&(Me(i.BLEND),m=!0),F!==tp){if(F!==p||Oe!==D){if((v!==Qs||C!==Qs)&&(i.blendEquation(i.FUNC_ADD),v=Qs,C=Qs),Oe)switch(F){case Kr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case oh:i.blendFunc(i.ONE,i.ONE);break;case ah:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case lh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Qe("WebGLState: Invalid blending: ",F);break}else switch(F){case Kr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case oh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case ah:Qe("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case lh:Qe("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qe("WebGLState: Invalid blending: ",F);break}T=null,b=null,E=null,_=null,A.set(0,0,0),B=0,p=F,D=Oe}return}ge=ge||se,be=be||te,Ge=Ge||we,(se!==v||ge!==C)&&(i.blendEquationSeparate(at[se],at[ge]),v=se,C=ge),(te!==T||we!==b||be!==E||Ge!==_)&&(i.blendFuncSeparate(tt[te],tt[we],tt[be],tt[Ge]),T=te,b=we,E=be,_=Ge),(Je.equals(A)===!1||ae!==B)&&(i.blendColor(Je.r,Je.g,Je.b,ae),A.copy(Je),B=ae),p=F,D=!1}function Dt(F,se){F.side===fi?He(i.CULL_FACE):Me(i.CULL_FACE);let te=F.side===en;se&&(te=!te),tn(te),F.blending===Kr&&F.transparent===!1?Vt(js):Vt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;a.setTest(we),we&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),_t(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?Me(i.SAMPLE_ALPHA_TO_COVERAGE):He(i.SAMPLE_ALPHA_TO_COVERAGE)}function tn(F){N!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),N=F)}function Ct(F){F!==jf?(Me(i.CULL_FACE),F!==k&&(F===rh?i.cullFace(i.BACK):F===Qf?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):He(i.CULL_FACE),k=F}function vn(F){F!==G&&(V&&i.lineWidth(F),G=F)}function _t(F,se,te){F?(Me(i.POLYGON_OFFSET_FILL),(L!==se||H!==te)&&(L=se,H=te,o.getReversed()&&(se=-se,te=-te),i.polygonOffset(se,te))):He(i.POLYGON_OFFSET_FILL)}function dn(F){F?Me(i.SCISSOR_TEST):He(i.SCISSOR_TEST)}function qt(F){F===void 0&&(F=i.TEXTURE0+Y-1),j!==F&&(i.activeTexture(F),j=F)}function nn(F,se,te){te===void 0&&(j===null?te=i.TEXTURE0+Y-1:te=j);let we=ie[te];we===void 0&&(we={type:void 0,texture:void 0},ie[te]=we),(we.type!==F||we.texture!==se)&&(j!==te&&(i.activeTexture(te),j=te),i.bindTexture(F,se||Te[F]),we.type=F,we.texture=se)}function U(){let F=ie[j];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ce(){try{i.compressedTexImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function qe(){try{i.compressedTexImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function st(){try{i.texSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Se(){try{i.texSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function It(){try{i.compressedTexSubImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ze(){try{i.compressedTexSubImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function Xe(){try{i.texStorage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function R(){try{i.texStorage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function y(){try{i.texImage2D(...arguments)}catch(F){Qe("WebGLState:",F)}}function W(){try{i.texImage3D(...arguments)}catch(F){Qe("WebGLState:",F)}}function ce(F){return h[F]!==void 0?h[F]:i.getParameter(F)}function re(F,se){h[F]!==se&&(i.pixelStorei(F,se),h[F]=se)}function xe(F){Q.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function ve(F){me.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function ee(F,se){let te=c.get(se);te===void 0&&(te=new WeakMap,c.set(se,te));let we=te.get(F);we===void 0&&(we=i.getUniformBlockIndex(se,F.name),i.uniformBlockBinding(se,we,we),te.set(F,we))}function ne(F,se,te){let ge=c.get(se).get(F);l[ge]!==te&&(i.bindBufferBase(i.UNIFORM_BUFFER,ge,te),l[ge]=te)}function pe(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),u={},h={},j=null,ie={},d={},l={},f=new WeakMap,g=[],M=null,m=!1,p=null,v=null,T=null,b=null,C=null,E=null,_=null,A=new Ye(0,0,0),B=0,D=!1,N=null,k=null,G=null,L=null,H=null,Q.set(0,0,i.canvas.width,i.canvas.height),me.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Me,disable:He,bindFramebuffer:it,drawBuffers:Ve,useProgram:ut,setBlending:Vt,setMaterial:Dt,setFlipSided:tn,setCullFace:Ct,setLineWidth:vn,setPolygonOffset:_t,setScissorTest:dn,activeTexture:qt,bindTexture:nn,unbindTexture:U,compressedTexImage2D:Ce,compressedTexImage3D:qe,texImage2D:y,texImage3D:W,pixelStorei:re,getParameter:ce,updateUBOMapping:ee,uniformBlockBinding:ne,texStorage2D:Xe,texStorage3D:R,texSubImage2D:st,texSubImage3D:Se,compressedTexSubImage2D:It,compressedTexSubImage3D:ze,scissor:xe,viewport:ve,reset:pe}}function FM(i,e,t,n,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new ot,u=new WeakMap,h=new Set,d,f=new WeakMap,g=new Set,M=new FinalizationRegistry(R=>g.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,y){return m?new OffscreenCanvas(R,y):Uo("canvas")}function v(R,y,W){let ce=1,re=Xe(R);if((re.width>W||re.height>W)&&(ce=W/Math.max(re.width,re.height)),ce<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xe=Math.floor(ce*re.width),ve=Math.floor(ce*re.height);d===void 0&&(d=p(xe,ve));let ee=y?p(xe,ve):d;return ee.width=xe,ee.height=ve,ee.getContext("2d").drawImage(R,0,0,xe,ve),Ze("WebGLRenderer: Texture has been resized from ("+re.width+"x"+re.height+") to ("+xe+"x"+ve+")."),ee}else return"data"in R&&Ze("WebGLRenderer: Image in DataTexture is too big ("+re.width+"x"+re.height+")."),R;return R}function T(R){return R.generateMipmaps}function b(R){i.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function E(R,y,W,ce,re,xe=!1){if(R!==null){if(i[R]!==void 0)return i[R];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;ce&&(ve=e.get("EXT_texture_norm16"),ve||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ee=y;if(y===i.RED&&(W===i.FLOAT&&(ee=i.R32F),W===i.HALF_FLOAT&&(ee=i.R16F),W===i.UNSIGNED_BYTE&&(ee=i.R8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.R16_EXT),W===i.SHORT&&ve&&(ee=ve.R16_SNORM_EXT)),y===i.RED_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.R8UI),W===i.UNSIGNED_SHORT&&(ee=i.R16UI),W===i.UNSIGNED_INT&&(ee=i.R32UI),W===i.BYTE&&(ee=i.R8I),W===i.SHORT&&(ee=i.R16I),W===i.INT&&(ee=i.R32I)),y===i.RG&&(W===i.FLOAT&&(ee=i.RG32F),W===i.HALF_FLOAT&&(ee=i.RG16F),W===i.UNSIGNED_BYTE&&(ee=i.RG8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RG16_EXT),W===i.SHORT&&ve&&(ee=ve.RG16_SNORM_EXT)),y===i.RG_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RG8UI),W===i.UNSIGNED_SHORT&&(ee=i.RG16UI),W===i.UNSIGNED_INT&&(ee=i.RG32UI),W===i.BYTE&&(ee=i.RG8I),W===i.SHORT&&(ee=i.RG16I),W===i.INT&&(ee=i.RG32I)),y===i.RGB_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGB8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGB16UI),W===i.UNSIGNED_INT&&(ee=i.RGB32UI),W===i.BYTE&&(ee=i.RGB8I),W===i.SHORT&&(ee=i.RGB16I),W===i.INT&&(ee=i.RGB32I)),y===i.RGBA_INTEGER&&(W===i.UNSIGNED_BYTE&&(ee=i.RGBA8UI),W===i.UNSIGNED_SHORT&&(ee=i.RGBA16UI),W===i.UNSIGNED_INT&&(ee=i.RGBA32UI),W===i.BYTE&&(ee=i.RGBA8I),W===i.SHORT&&(ee=i.RGBA16I),W===i.INT&&(ee=i.RGBA32I)),y===i.RGB&&(W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGB16_EXT),W===i.SHORT&&ve&&(ee=ve.RGB16_SNORM_EXT),W===i.UNSIGNED_INT_5_9_9_9_REV&&(ee=i.RGB9_E5),W===i.UNSIGNED_INT_10F_11F_11F_REV&&(ee=i.R11F_G11F_B10F)),y===i.RGBA){let ne=xe?Fo:mt.getTransfer(re);W===i.FLOAT&&(ee=i.RGBA32F),W===i.HALF_FLOAT&&(ee=i.RGBA16F),W===i.UNSIGNED_BYTE&&(ee=ne===wt?i.SRGB8_ALPHA8:i.RGBA8),W===i.UNSIGNED_SHORT&&ve&&(ee=ve.RGBA16_EXT),W===i.SHORT&&ve&&(ee=ve.RGBA16_SNORM_EXT),W===i.UNSIGNED_SHORT_4_4_4_4&&(ee=i.RGBA4),W===i.UNSIGNED_SHORT_5_5_5_1&&(ee=i.RGB5_A1)}return(ee===i.R16F||ee===i.R32F||ee===i.RG16F||ee===i.RG32F||ee===i.RGBA16F||ee===i.RGBA32F)&&e.get("EXT_color_buffer_float"),ee}function _(R,y){let W;return R?y===null||y===Ai||y===tr?W=i.DEPTH24_STENCIL8:y===Ei?W=i.DEPTH32F_STENCIL8:y===Qr&&(W=i.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):y===null||y===Ai||y===tr?W=i.DEPTH_COMPONENT24:y===Ei?W=i.DEPTH_COMPONENT32F:y===Qr&&(W=i.DEPTH_COMPONENT16),W}function A(R,y){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==An&&R.minFilter!==Vn?Math.log2(Math.max(y.width,y.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?y.mipmaps.length:1}function B(R){let y=new WeakRef(R);n.get(R).__ref=y,g.add(y),M.register(R,y,y)}function D(R){let y=n.get(R).__ref;y!==void 0&&(g.delete(y),M.unregister(y))}function N(R){G(R.target)}function k(R){L(R.target)}function G(R){R.removeEventListener("dispose",N),D(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function L(R){R.removeEventListener("dispose",k),D(R),le(R)}function H(){for(let R of g){let y=R.deref();y!==void 0&&(y.isRenderTarget===!0?L(y):G(y))}g.clear(),h.clear()}function Y(R){let y=n.get(R);if(y.__webglInit===void 0)return;let W=R.source,ce=f.get(W);if(ce){let re=ce[y.__cacheKey];re.usedTimes--,re.usedTimes===0&&V(R),Object.keys(ce).length===0&&f.delete(W)}n.remove(R)}function V(R){let y=n.get(R);i.deleteTexture(y.__webglTexture);let W=R.source,ce=f.get(W);delete ce[y.__cacheKey],o.memory.textures--}function le(R){let y=n.get(R);y.__depthDisposeCallback&&y.__depthDisposeCallback();let W=R.depthTexture;if(W&&W.renderTarget===R&&G(W),R.isWebGLCubeRenderTarget)for(let re=0;re<6;re++){if(Array.isArray(y.__webglFramebuffer[re]))for(let xe=0;xe<y.__webglFramebuffer[re].length;xe++)i.deleteFramebuffer(y.__webglFramebuffer[re][xe]);else i.deleteFramebuffer(y.__webglFramebuffer[re]);y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer[re])}else{if(Array.isArray(y.__webglFramebuffer))for(let re=0;re<y.__webglFramebuffer.length;re++)i.deleteFramebuffer(y.__webglFramebuffer[re]);else i.deleteFramebuffer(y.__webglFramebuffer);if(y.__webglDepthbuffer&&i.deleteRenderbuffer(y.__webglDepthbuffer),y.__webglMultisampledFramebuffer&&i.deleteFramebuffer(y.__webglMultisampledFramebuffer),y.__webglColorRenderbuffer)for(let re=0;re<y.__webglColorRenderbuffer.length;re++)y.__webglColorRenderbuffer[re]&&i.deleteRenderbuffer(y.__webglColorRenderbuffer[re]);y.__webglDepthRenderbuffer&&i.deleteRenderbuffer(y.__webglDepthRenderbuffer)}let ce=R.textures;for(let re=0,xe=ce.length;re<xe;re++){let ve=n.get(ce[re]);ve.__webglTexture&&(i.deleteTexture(ve.__webglTexture),o.memory.textures--),n.remove(ce[re])}n.remove(R)}let J=0;function j(){J=0}function ie(){return J}function de(R){J=R}function ue(){let R=J;return R>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function Q(R){let y=[];return y.push(R.wrapS),y.push(R.wrapT),y.push(R.wrapR||0),y.push(R.magFilter),y.push(R.minFilter),y.push(R.anisotropy),y.push(R.internalFormat),y.push(R.format),y.push(R.type),y.push(R.generateMipmaps),y.push(R.mipmapsAutoUpdate),y.push(R.premultiplyAlpha),y.push(R.flipY),y.push(R.unpackAlignment),y.push(R.colorSpace),y.join()}function me(R,y){let W=n.get(R);if(R.isVideoTexture&&It(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&W.__version!==R.version){let ce=R.image;if(ce===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(ce.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{Dt(W,R,y);return}}else R.isExternalTexture&&(W.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D,W.__webglTexture,i.TEXTURE0+y)}function _e(R,y){let W=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&W.__version!==R.version){Dt(W,R,y);return}else R.isExternalTexture&&(W.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(i.TEXTURE_2D_ARRAY,W.__webglTexture,i.TEXTURE0+y)}function Te(R,y){let W=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&W.__version!==R.version){Dt(W,R,y);return}t.bindTexture(i.TEXTURE_3D,W.__webglTexture,i.TEXTURE0+y)}function Me(R,y){let W=n.get(R);if(R.version>0&&W.__version!==R.version){tn(W,R,y);return}t.bindTexture(i.TEXTURE_CUBE_MAP,W.__webglTexture,i.TEXTURE0+y)}let He={[vl]:i.REPEAT,[zi]:i.CLAMP_TO_EDGE,[yl]:i.MIRRORED_REPEAT},it={[An]:i.NEAREST,[bp]:i.NEAREST_MIPMAP_NEAREST,[na]:i.NEAREST_MIPMAP_LINEAR,[Vn]:i.LINEAR,[Yl]:i.LINEAR_MIPMAP_NEAREST,[ds]:i.LINEAR_MIPMAP_LINEAR},Ve={[Ap]:i.NEVER,[Rh]:i.ALWAYS,[Ep]:i.LESS,[Eh]:i.LEQUAL,[Tp]:i.EQUAL,[Th]:i.GEQUAL,[Rp]:i.GREATER,[Cp]:i.NOTEQUAL};function ut(R,y){if(y.type===Ei&&e.has("OES_texture_float_linear")===!1&&(y.magFilter===Vn||y.magFilter===Yl||y.magFilter===na||y.magFilter===ds||y.minFilter===Vn||y.minFilter===Yl||y.minFilter===na||y.minFilter===ds)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,He[y.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,He[y.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,He[y.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,it[y.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,it[y.minFilter]),y.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Ve[y.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(y.magFilter===An||y.minFilter!==na&&y.minFilter!==ds||y.type===Ei&&e.has("OES_texture_float_linear")===!1)return;if(y.anisotropy>1||n.get(y).__currentAnisotropy){let W=e.get("EXT_texture_filter_anisotropic");i.texParameterf(R,W.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(y.anisotropy,s.getMaxAnisotropy())),n.get(y).__currentAnisotropy=y.anisotropy}}}function at(R,y){let W=!1;R.__webglInit===void 0&&(R.__webglInit=!0,y.addEventListener("dispose",N),B(y));let ce=y.source,re=f.get(ce);re===void 0&&(re={},f.set(ce,re));let xe=Q(y);if(xe!==R.__cacheKey){re[xe]===void 0&&(re[xe]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,W=!0),re[xe].usedTimes++;let ve=re[R.__cacheKey];ve!==void 0&&(re[R.__cacheKey].usedTimes--,ve.usedTimes===0&&V(y)),R.__cacheKey=xe,R.__webglTexture=re[xe].texture}return W}function tt(R,y,W){return Math.floor(Math.floor(R/W)/y)}function Vt(R,y,W,ce){let xe=R.updateRanges;if(xe.length===0)t.texSubImage2D(i.TEXTURE_2D,0,0,0,y.width,y.height,W,ce,y.data);else{xe.sort((F,se)=>F.start-se.start);let ve=0;for(let F=1;F<xe.length;F++){let se=xe[ve],te=xe[F],we=se.start+se.count,ge=tt(te.start,y.width,4),be=tt(se.start,y.width,4);te.start<=we+1&&ge===be&&tt(te.start+te.count-1,y.width,4)===ge?se.count=Math.max(se.count,te.start+te.count-se.start):(++ve,xe[ve]=te)}xe.length=ve+1;let ee=t.getParameter(i.UNPACK_ROW_LENGTH),ne=t.getParameter(i.UNPACK_SKIP_PIXELS),pe=t.getParameter(i.UNPACK_SKIP_ROWS);t.pixelStorei(i.UNPACK_ROW_LENGTH,y.width);for(let F=0,se=xe.length;F<se;F++){let te=xe[F],we=Math.floor(te.start/4),ge=Math.ceil(te.count/4),be=we%y.width,Ge=Math.floor(we/y.width),Je=ge,ae=1;t.pixelStorei(i.UNPACK_SKIP_PIXELS,be),t.pixelStorei(i.UNPACK_SKIP_ROWS,Ge),t.texSubImage2D(i.TEXTURE_2D,0,be,Ge,Je,ae,W,ce,y.data)}R.clearUpdateRanges(),t.pixelStorei(i.UNPACK_ROW_LENGTH,ee),t.pixelStorei(i.UNPACK_SKIP_PIXELS,ne),t.pixelStorei(i.UNPACK_SKIP_ROWS,pe)}}function Dt(R,y,W){let ce=i.TEXTURE_2D;(y.isDataArrayTexture||y.isCompressedArrayTexture)&&(ce=i.TEXTURE_2D_ARRAY),y.isData3DTexture&&(ce=i.TEXTURE_3D);let re=at(R,y),xe=y.source;t.bindTexture(ce,R.__webglTexture,i.TEXTURE0+W);let ve=n.get(xe);if(xe.version!==ve.__version||re===!0){if(t.activeTexture(i.TEXTURE0+W),(typeof ImageBitmap<"u"&&y.image instanceof ImageBitmap)===!1){let ae=mt.getPrimaries(mt.workingColorSpace),Oe=y.colorSpace===ps?null:mt.getPrimaries(y.colorSpace),Ke=y.colorSpace===ps||ae===Oe?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ke)}t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment);let ne=v(y.image,!1,s.maxTextureSize);ne=ze(y,ne);let pe=r.convert(y.format,y.colorSpace),F=r.convert(y.type),se=E(y.internalFormat,pe,F,y.normalized,y.colorSpace,y.isVideoTexture);ut(ce,y);let te,we=y.mipmaps,ge=y.isVideoTexture!==!0,be=ve.__version===void 0||re===!0,Ge=xe.dataReady,Je=A(y,ne);if(y.isDepthTexture)se=_(y.format===fs,y.type),be&&(ge?t.texStorage2D(i.TEXTURE_2D,1,se,ne.width,ne.height):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,F,null));else if(y.isDataTexture)if(we.length>0){ge&&be&&t.texStorage2D(i.TEXTURE_2D,Je,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,pe,F,te.data);y.generateMipmaps=!1}else ge?(be&&t.texStorage2D(i.TEXTURE_2D,Je,se,ne.width,ne.height),Ge&&Vt(y,ne,pe,F)):t.texImage2D(i.TEXTURE_2D,0,se,ne.width,ne.height,0,pe,F,ne.data);else if(y.isCompressedTexture)if(y.isCompressedArrayTexture){ge&&be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,se,we[0].width,we[0].height,ne.depth);for(let ae=0,Oe=we.length;ae<Oe;ae++)if(te=we[ae],y.format!==Ri)if(pe!==null)if(ge){if(Ge)if(y.layerUpdates.size>0){let Ke=Dh(te.width,te.height,y.format,y.type);for(let Re of y.layerUpdates){let rt=te.data.subarray(Re*Ke/te.data.BYTES_PER_ELEMENT,(Re+1)*Ke/te.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,Re,te.width,te.height,1,pe,rt)}}else t.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,pe,te.data)}else t.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,te.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ge?Ge&&t.texSubImage3D(i.TEXTURE_2D_ARRAY,ae,0,0,0,te.width,te.height,ne.depth,pe,F,te.data):t.texImage3D(i.TEXTURE_2D_ARRAY,ae,se,te.width,te.height,ne.depth,0,pe,F,te.data);y.layerUpdates.size>0&&y.clearLayerUpdates()}else{ge&&be&&t.texStorage2D(i.TEXTURE_2D,Je,se,we[0].width,we[0].height);for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],y.format!==Ri?pe!==null?ge?Ge&&t.compressedTexSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.height,pe,te.data):t.compressedTexImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,te.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,te.width,te.height,pe,F,te.data):t.texImage2D(i.TEXTURE_2D,ae,se,te.width,te.height,0,pe,F,te.data)}else if(y.isDataArrayTexture)if(ge){if(be&&t.texStorage3D(i.TEXTURE_2D_ARRAY,Je,se,ne.width,ne.height,ne.depth),Ge)if(y.layerUpdates.size>0){let ae=Dh(ne.width,ne.height,y.format,y.type);for(let Oe of y.layerUpdates){let Ke=ne.data.subarray(Oe*ae/ne.data.BYTES_PER_ELEMENT,(Oe+1)*ae/ne.data.BYTES_PER_ELEMENT);t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Oe,ne.width,ne.height,1,pe,F,Ke)}y.clearLayerUpdates()}else t.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,ne.width,ne.height,ne.depth,pe,F,ne.data)}else t.texImage3D(i.TEXTURE_2D_ARRAY,0,se,ne.width,ne.height,ne.depth,0,pe,F,ne.data);else if(y.isData3DTexture)ge?(be&&t.texStorage3D(i.TEXTURE_3D,Je,se,ne.width,ne.height,ne.depth),Ge&&t.texSubImage3D(i.TEXTURE_3D,0,0,0,0,ne.width,ne.height,ne.depth,pe,F,ne.data)):t.texImage3D(i.TEXTURE_3D,0,se,ne.width,ne.height,ne.depth,0,pe,F,ne.data);else if(y.isFramebufferTexture){if(be)if(ge)t.texStorage2D(i.TEXTURE_2D,Je,se,ne.width,ne.height);else{let ae=ne.width,Oe=ne.height;for(let Ke=0;Ke<Je;Ke++)t.texImage2D(i.TEXTURE_2D,Ke,se,ae,Oe,0,pe,F,null),ae>>=1,Oe>>=1}}else if(y.isHTMLTexture){if("texElementImage2D"in i){let ae=i.canvas;if(ae.hasAttribute("layoutsubtree")||ae.setAttribute("layoutsubtree","true"),ne.parentNode!==ae){ae.appendChild(ne),h.add(y),ae.onpaint=Oe=>{let Ke=Oe.changedElements;for(let Re of h)Ke.includes(Re.image)&&(Re.needsUpdate=!0)},ae.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,ne);else{let Ke=i.RGBA,Re=i.RGBA,rt=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ke,Re,rt,ne)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(we.length>0){if(ge&&be){let ae=Xe(we[0]);t.texStorage2D(i.TEXTURE_2D,Je,se,ae.width,ae.height)}for(let ae=0,Oe=we.length;ae<Oe;ae++)te=we[ae],ge?Ge&&t.texSubImage2D(i.TEXTURE_2D,ae,0,0,pe,F,te):t.texImage2D(i.TEXTURE_2D,ae,se,pe,F,te);y.generateMipmaps=!1}else if(ge){if(be){let ae=Xe(ne);t.texStorage2D(i.TEXTURE_2D,Je,se,ae.width,ae.height)}Ge&&t.texSubImage2D(i.TEXTURE_2D,0,0,0,pe,F,ne)}else t.texImage2D(i.TEXTURE_2D,0,se,pe,F,ne);T(y)&&y.mipmapsAutoUpdate===!0&&b(ce),ve.__version=xe.version,y.onUpdate&&y.onUpdate(y)}R.__version=y.version}function tn(R,y,W){if(y.image.length!==6)return;let ce=at(R,y),re=y.source;t.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+W);let xe=n.get(re);if(re.version!==xe.__version||ce===!0){t.activeTexture(i.TEXTURE0+W);let ve=mt.getPrimaries(mt.workingColorSpace),ee=y.colorSpace===ps?null:mt.getPrimaries(y.colorSpace),ne=y.colorSpace===ps||ve===ee?i.NONE:i.BROWSER_DEFAULT_WEBGL;t.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,y.flipY),t.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,y.premultiplyAlpha),t.pixelStorei(i.UNPACK_ALIGNMENT,y.unpackAlignment),t.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,ne);let pe=y.isCompressedTexture||y.image[0].isCompressedTexture,F=y.image[0]&&y.image[0].isDataTexture,se=[];for(let Re=0;Re<6;Re++)!pe&&!F?se[Re]=v(y.image[Re],!0,s.maxCubemapSize):se[Re]=F?y.image[Re].image:y.image[Re],se[Re]=ze(y,se[Re]);let te=se[0],we=r.convert(y.format,y.colorSpace),ge=r.convert(y.type),be=E(y.internalFormat,we,ge,y.normalized,y.colorSpace),Ge=y.isVideoTexture!==!0,Je=xe.__version===void 0||ce===!0,ae=re.dataReady,Oe=A(y,te);ut(i.TEXTURE_CUBE_MAP,y);let Ke;if(y.isDepthTexture){if(be=_(y.format===fs,y.type),Je)if(Ge)t.texStorage2D(i.TEXTURE_CUBE_MAP,1,be,te.width,te.height);else for(let Re=0;Re<6;Re++)t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,te.width,te.height,0,we,ge,null)}else if(pe){Ge&&Je&&t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,te.width,te.height);for(let Re=0;Re<6;Re++){Ke=se[Re].mipmaps;for(let rt=0;rt<Ke.length;rt++){let Ft=Ke[rt];y.format!==Ri?we!==null?Ge?ae&&t.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt,0,0,Ft.width,Ft.height,we,Ft.data):t.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt,be,Ft.width,Ft.height,0,Ft.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ge?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt,0,0,Ft.width,Ft.height,we,ge,Ft.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt,be,Ft.width,Ft.height,0,we,ge,Ft.data)}}}else{if(Ke=y.mipmaps,Ge&&Je){Ke.length>0&&Oe++;let Re=Xe(se[0]);t.texStorage2D(i.TEXTURE_CUBE_MAP,Oe,be,Re.width,Re.height)}for(let Re=0;Re<6;Re++)if(F){Ge?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,se[Re].width,se[Re].height,we,ge,se[Re].data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,se[Re].width,se[Re].height,0,we,ge,se[Re].data);for(let rt=0;rt<Ke.length;rt++){let Dn=Ke[rt].image[Re].image;Ge?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt+1,0,0,Dn.width,Dn.height,we,ge,Dn.data):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt+1,be,Dn.width,Dn.height,0,we,ge,Dn.data)}}else{Ge?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,0,0,we,ge,se[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,0,be,we,ge,se[Re]);for(let rt=0;rt<Ke.length;rt++){let Ft=Ke[rt];Ge?ae&&t.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt+1,0,0,we,ge,Ft.image[Re]):t.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+Re,rt+1,be,we,ge,Ft.image[Re])}}}T(y)&&y.mipmapsAutoUpdate===!0&&b(i.TEXTURE_CUBE_MAP),xe.__version=re.version,y.onUpdate&&y.onUpdate(y)}R.__version=y.version}function Ct(R,y,W,ce,re,xe){let ve=r.convert(W.format,W.colorSpace),ee=r.convert(W.type),ne=E(W.internalFormat,ve,ee,W.normalized,W.colorSpace),pe=n.get(y),F=n.get(W);if(F.__renderTarget=y,!pe.__hasExternalTextures){let se=Math.max(1,y.width>>xe),te=Math.max(1,y.height>>xe);re===i.TEXTURE_3D||re===i.TEXTURE_2D_ARRAY?t.texImage3D(re,xe,ne,se,te,y.depth,0,ve,ee,null):t.texImage2D(re,xe,ne,se,te,0,ve,ee,null)}t.bindFramebuffer(i.FRAMEBUFFER,R),Se(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ce,re,F.__webglTexture,0,st(y)):(re===i.TEXTURE_2D||re>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&re<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,ce,re,F.__webglTexture,xe),t.bindFramebuffer(i.FRAMEBUFFER,null)}function vn(R,y,W){if(i.bindRenderbuffer(i.RENDERBUFFER,R),y.depthBuffer){let ce=y.depthTexture,re=ce&&ce.isDepthTexture?ce.type:null,xe=_(y.stencilBuffer,re),ve=y.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;Se(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,st(y),xe,y.width,y.height):W?i.renderbufferStorageMultisample(i.RENDERBUFFER,st(y),xe,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,xe,y.width,y.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ve,i.RENDERBUFFER,R)}else{let ce=y.textures;for(let re=0;re<ce.length;re++){let xe=ce[re],ve=r.convert(xe.format,xe.colorSpace),ee=r.convert(xe.type),ne=E(xe.internalFormat,ve,ee,xe.normalized,xe.colorSpace);Se(y)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,st(y),ne,y.width,y.height):W?i.renderbufferStorageMultisample(i.RENDERBUFFER,st(y),ne,y.width,y.height):i.renderbufferStorage(i.RENDERBUFFER,ne,y.width,y.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function _t(R,y,W){let ce=y.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(i.FRAMEBUFFER,R),!(y.depthTexture&&y.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let re=n.get(y.depthTexture);re.__renderTarget=y;let xe=ce?y.depthTexture.image[0]:y.depthTexture.image;(!re.__webglTexture||xe.width!==y.width||xe.height!==y.height)&&(xe.width=y.width,xe.height=y.height,y.depthTexture.needsUpdate=!0),ce?Me(y.depthTexture,0):me(y.depthTexture,0);let ve=re.__webglTexture,ee=st(y),ne=ce?i.TEXTURE_CUBE_MAP_POSITIVE_X+W:i.TEXTURE_2D,pe=y.depthTexture.format===fs?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(y.depthTexture.format===os)Se(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,pe,ne,ve,0);else if(y.depthTexture.format===fs)Se(y)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,pe,ne,ve,0,ee):i.framebufferTexture2D(i.FRAMEBUFFER,pe,ne,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function dn(R){let y=n.get(R),W=R.isWebGLCubeRenderTarget===!0;if(y.__boundDepthTexture!==R.depthTexture){let ce=R.depthTexture;if(y.__depthDisposeCallback&&y.__depthDisposeCallback(),ce){let re=()=>{delete y.__boundDepthTexture,delete y.__depthDisposeCallback,ce.removeEventListener("dispose",re)};ce.addEventListener("dispose",re),y.__depthDisposeCallback=re}y.__boundDepthTexture=ce}if(R.depthTexture&&!y.__autoAllocateDepthBuffer)if(W)for(let ce=0;ce<6;ce++)_t(y.__webglFramebuffer[ce],R,ce);else R.texture.mipmaps.length>0?_t(y.__webglFramebuffer[0],R,0):_t(y.__webglFramebuffer,R,0);else if(W){y.__webglDepthbuffer=[];for(let ce=0;ce<6;ce++)if(t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[ce]),y.__webglDepthbuffer[ce]===void 0)y.__webglDepthbuffer[ce]=i.createRenderbuffer(),vn(y.__webglDepthbuffer[ce],R,!1);else{let re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer[ce];i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,xe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer[0]):t.bindFramebuffer(i.FRAMEBUFFER,y.__webglFramebuffer),y.__webglDepthbuffer===void 0)y.__webglDepthbuffer=i.createRenderbuffer(),vn(y.__webglDepthbuffer,R,!1);else{let re=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,xe=y.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,xe),i.framebufferRenderbuffer(i.FRAMEBUFFER,re,i.RENDERBUFFER,xe)}t.bindFramebuffer(i.FRAMEBUFFER,null)}function qt(R,y,W){let ce=n.get(R);y!==void 0&&Ct(ce.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),W!==void 0&&dn(R)}function nn(R){let y=R.texture,W=n.get(R),ce=n.get(y);R.addEventListener("dispose",k),B(R);let re=R.textures,xe=R.isWebGLCubeRenderTarget===!0,ve=re.length>1;if(ve||(ce.__webglTexture===void 0&&(ce.__webglTexture=i.createTexture()),ce.__version=y.version,o.memory.textures++),xe){W.__webglFramebuffer=[];for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0){W.__webglFramebuffer[ee]=[];for(let ne=0;ne<y.mipmaps.length;ne++)W.__webglFramebuffer[ee][ne]=i.createFramebuffer()}else W.__webglFramebuffer[ee]=i.createFramebuffer()}else{if(y.mipmaps.length>0){W.__webglFramebuffer=[];for(let ee=0;ee<y.mipmaps.length;ee++)W.__webglFramebuffer[ee]=i.createFramebuffer()}else W.__webglFramebuffer=i.createFramebuffer();if(ve)for(let ee=0,ne=re.length;ee<ne;ee++){let pe=n.get(re[ee]);pe.__webglTexture===void 0&&(pe.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Se(R)===!1){W.__webglMultisampledFramebuffer=i.createFramebuffer(),W.__webglColorRenderbuffer=[],t.bindFramebuffer(i.FRAMEBUFFER,W.__webglMultisampledFramebuffer);for(let ee=0;ee<re.length;ee++){let ne=re[ee];W.__webglColorRenderbuffer[ee]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,W.__webglColorRenderbuffer[ee]);let pe=r.convert(ne.format,ne.colorSpace),F=r.convert(ne.type),se=E(ne.internalFormat,pe,F,ne.normalized,ne.colorSpace,R.isXRRenderTarget===!0),te=st(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,te,se,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ee,i.RENDERBUFFER,W.__webglColorRenderbuffer[ee])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(W.__webglDepthRenderbuffer=i.createRenderbuffer(),vn(W.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(i.FRAMEBUFFER,null)}}if(xe){t.bindTexture(i.TEXTURE_CUBE_MAP,ce.__webglTexture),ut(i.TEXTURE_CUBE_MAP,y);for(let ee=0;ee<6;ee++)if(y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Ct(W.__webglFramebuffer[ee][ne],R,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,ne);else Ct(W.__webglFramebuffer[ee],R,y,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ee,0);T(y)?b(i.TEXTURE_CUBE_MAP):y.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let ee=0,ne=re.length;ee<ne;ee++){let pe=re[ee],F=n.get(pe),se=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(se=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(se,F.__webglTexture),ut(se,pe),Ct(W.__webglFramebuffer,R,pe,i.COLOR_ATTACHMENT0+ee,se,0),T(pe)&&b(se)}t.unbindTexture()}else{let ee=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ee=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),t.bindTexture(ee,ce.__webglTexture),ut(ee,y),y.mipmaps.length>0)for(let ne=0;ne<y.mipmaps.length;ne++)Ct(W.__webglFramebuffer[ne],R,y,i.COLOR_ATTACHMENT0,ee,ne);else Ct(W.__webglFramebuffer,R,y,i.COLOR_ATTACHMENT0,ee,0);T(y)?b(ee):y.mipmaps.length>0&&i.texParameteri(ee,i.TEXTURE_MAX_LEVEL,y.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&dn(R)}function U(R){let y=R.textures;for(let W=0,ce=y.length;W<ce;W++){let re=y[W];if(T(re)&&re.mipmapsAutoUpdate===!0){let xe=C(R),ve=n.get(re).__webglTexture;t.bindTexture(xe,ve),b(xe),t.unbindTexture()}}}let Ce=[];function qe(R){if(R.samples>0){if(Se(R)===!1){let y=R.textures,W=R.width,ce=R.height,re=i.COLOR_BUFFER_BIT,xe=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ve=n.get(R),ee=y.length>1;if(ee)for(let pe=0;pe<y.length;pe++)t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,null),t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,null,0);t.bindFramebuffer(i.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<y.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(re|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(re|=i.STENCIL_BUFFER_BIT)),ee){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=n.get(y[pe]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,F,0)}i.blitFramebuffer(0,0,W,ce,0,0,W,ce,re,i.NEAREST),l===!0&&(Ce.length=0,Ce.push(i.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ce.push(xe),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,Ce))}if(t.bindFramebuffer(i.READ_FRAMEBUFFER,null),t.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ee)for(let pe=0;pe<y.length;pe++){t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=n.get(y[pe]).__webglTexture;t.bindFramebuffer(i.FRAMEBUFFER,ve.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+pe,i.TEXTURE_2D,F,0)}t.bindFramebuffer(i.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let y=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[y])}}}function st(R){return Math.min(s.maxSamples,R.samples)}function Se(R){let y=n.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&y.__useRenderToTexture!==!1}function It(R){let y=o.render.frame;u.get(R)!==y&&(u.set(R,y),R.update())}function ze(R,y){let W=R.colorSpace,ce=R.format,re=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||W!==Do&&W!==ps&&(mt.getTransfer(W)===wt?(ce!==Ri||re!==Yn)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qe("WebGLTextures: Unsupported texture color space:",W)),y}function Xe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=j,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=_e,this.setTexture3D=Te,this.setTextureCube=Me,this.rebindTextures=qt,this.setupRenderTarget=nn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=qe,this.setupDepthRenderbuffer=dn,this.setupFrameBufferTexture=Ct,this.useMultisampledRTT=Se,this.dispose=H}function UM(i,e){function t(n,s=ps){let r,o=mt.getTransfer(s);if(n===Yn)return i.UNSIGNED_BYTE;if(n===Zl)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Jl)return i.UNSIGNED_SHORT_5_5_5_1;if(n===bh)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Mh)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===vh)return i.BYTE;if(n===yh)return i.SHORT;if(n===Qr)return i.UNSIGNED_SHORT;if(n===$l)return i.INT;if(n===Ai)return i.UNSIGNED_INT;if(n===Ei)return i.FLOAT;if(n===Ti)return i.HALF_FLOAT;if(n===Sh)return i.ALPHA;if(n===wh)return i.RGB;if(n===Ri)return i.RGBA;if(n===os)return i.DEPTH_COMPONENT;if(n===fs)return i.DEPTH_STENCIL;if(n===Ah)return i.RED;if(n===Kl)return i.RED_INTEGER;if(n===Os)return i.RG;if(n===jl)return i.RG_INTEGER;if(n===Ql)return i.RGBA_INTEGER;if(n===ia||n===sa||n===ra||n===oa)if(o===wt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ia)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===ra)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===oa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ia)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===sa)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===ra)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===oa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===ec||n===tc||n===nc||n===ic)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===ec)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===tc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===nc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===ic)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===sc||n===rc||n===oc||n===ac||n===lc||n===aa||n===cc)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(n===sc||n===rc)return o===wt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===oc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===ac)return r.COMPRESSED_R11_EAC;if(n===lc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===aa)return r.COMPRESSED_RG11_EAC;if(n===cc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===uc||n===hc||n===dc||n===fc||n===pc||n===mc||n===gc||n===xc||n===_c||n===vc||n===yc||n===bc||n===Mc||n===Sc)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(n===uc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===hc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===dc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===fc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===pc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===mc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===gc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===xc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===_c)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===vc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===yc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===bc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Mc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Sc)return o===wt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===wc||n===Ac||n===Ec)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(n===wc)return o===wt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Ac)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Ec)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Tc||n===Rc||n===la||n===Cc)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(n===Tc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Rc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===la)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Cc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===tr?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:t}}var OM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,BM=`
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

}`,Hh=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let n=new Xo(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=n}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,n=new Xn({vertexShader:OM,fragmentShader:BM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new yt(new Ns(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Wh=class extends Vi{constructor(e,t){super();let n=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,g=null,M=typeof XRWebGLBinding<"u",m=new Hh,p={},v=t.getContextAttributes(),T=null,b=null,C=[],E=[],_=new ot,A=null,B=null,D=new zn;D.viewport=new Wt;let N=new zn;N.viewport=new Wt;let k=[D,N],G=new Wl,L=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=C[Q];return me===void 0&&(me=new Xr,C[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=C[Q];return me===void 0&&(me=new Xr,C[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=C[Q];return me===void 0&&(me=new Xr,C[Q]=me),me.getHandSpace()};function Y(Q){let me=E.indexOf(Q.inputSource);if(me===-1)return;let _e=C[me];_e!==void 0&&(_e.update(Q.inputSource,Q.frame,c||o),_e.dispatchEvent({type:Q.type,data:Q.inputSource}))}function V(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",le);for(let Q=0;Q<C.length;Q++){let me=E[Q];me!==null&&(E[Q]=null,C[Q].disconnect(me))}L=null,H=null,m.reset();for(let Q in p)delete p[Q];if(e.setRenderTarget(T),f=null,d=null,h=null,s=null,b=null,ue.stop(),n.isPresenting=!1,e.setPixelRatio(A),e.setSize(_.width,_.height,!1),B!==null){let Q=B.camera;Q.fov=B.fov,Q.zoom=B.zoom,Q.updateProjectionMatrix(),B=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&M&&(h=new XRWebGLBinding(s,t)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",V),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),A=e.getPixelRatio(),e.getSize(_),M&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Te=null,Me=null;v.depth&&(Me=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?fs:os,Te=v.stencil?tr:Ai);let He={colorFormat:t.RGBA8,depthFormat:Me,scaleFactor:r};h=this.getBinding(),d=h.createProjectionLayer(He),s.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),b=new ni(d.textureWidth,d.textureHeight,{format:Ri,type:Yn,depthTexture:new as(d.textureWidth,d.textureHeight,Te,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),b=new ni(f.framebufferWidth,f.framebufferHeight,{format:Ri,type:Yn,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function le(Q){for(let me=0;me<Q.removed.length;me++){let _e=Q.removed[me],Te=E.indexOf(_e);Te>=0&&(E[Te]=null,C[Te].disconnect(_e))}for(let me=0;me<Q.added.length;me++){let _e=Q.added[me],Te=E.indexOf(_e);if(Te===-1){for(let He=0;He<C.length;He++)if(He>=E.length){E.push(_e),Te=He;break}else if(E[He]===null){E[He]=_e,Te=He;break}if(Te===-1)break}let Me=C[Te];Me&&Me.connect(_e)}}function J(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,_e=Q.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(_e=m.depthFar)),G.near=N.near=D.near=me,G.far=N.far=D.far=_e,(L!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),L=G.near,H=G.far),G.layers.mask=Q.layers.mask|6,D.layers.mask=G.layers.mask&-5,N.layers.mask=G.layers.mask&-3;let Te=Q.parent,Me=G.cameras;J(G,Te);for(let He=0;He<Me.length;He++)J(Me[He],Te);G.projectionMatrix.copy(D.projectionMatrix),G.projectionMatrixInverse.copy(D.projectionMatrixInverse),B===null&&Q.isPerspectiveCamera&&(B={camera:Q,fov:Q.fov,zoom:Q.zoom}),j(Q,G,Te)};function j(Q,me,_e){_e===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(_e.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Ml*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(Q){return p[Q]};let ie=null;function de(Q,me){if(u=me.getViewerPose(c||o),g=me,u!==null){let _e=u.views;f!==null&&(e.setRenderTargetFramebuffer(b,f.framebuffer),e.setRenderTarget(b));let Te=!1;_e.length!==G.cameras.length&&(G.cameras.length=0,Te=!0);for(let Ve=0;Ve<_e.length;Ve++){let ut=_e[Ve],at=null;if(f!==null)at=f.getViewport(ut);else{let Vt=h.getViewSubImage(d,ut);at=Vt.viewport,Ve===0&&(e.setRenderTargetTextures(b,Vt.colorTexture,Vt.depthStencilTexture),e.setRenderTarget(b))}let tt=k[Ve];tt===void 0&&(tt=new zn,tt.layers.enable(Ve),tt.viewport=new Wt,k[Ve]=tt),tt.matrix.fromArray(ut.transform.matrix),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.projectionMatrix.fromArray(ut.projectionMatrix),tt.projectionMatrixInverse.copy(tt.projectionMatrix).invert(),tt.viewport.set(at.x,at.y,at.width,at.height),Ve===0&&(G.matrix.copy(tt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Te===!0&&G.cameras.push(tt)}let Me=s.enabledFeatures;if(Me&&Me.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&M){h=n.getBinding();let Ve=h.getDepthInformation(_e[0]);Ve&&Ve.isValid&&Ve.texture&&m.init(Ve,s.renderState)}if(Me&&Me.includes("camera-access")&&M){e.state.unbindTexture(),h=n.getBinding();for(let Ve=0;Ve<_e.length;Ve++){let ut=_e[Ve].camera;if(ut){let at=p[ut];at||(at=new Xo,p[ut]=at);let tt=h.getCameraImage(ut);at.sourceTexture=tt}}}}for(let _e=0;_e<C.length;_e++){let Te=E[_e],Me=C[_e];Te!==null&&Me!==void 0&&Me.update(Te,me,c||o)}ie&&ie(Q,me),me.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:me}),g=null}let ue=new lm;ue.setAnimationLoop(de),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},kM=new Ht,_m=new et;_m.set(-1,0,0,0,1,0,0,0,1);function zM(i,e){function t(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,Ih(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,v,T,b){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?r(m,p):p.isMeshLambertMaterial?(r(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(r(m,p),d(m,p),p.isMeshPhysicalMaterial&&f(m,p,b)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),M(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,v,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,t(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===en&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,t(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===en&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,t(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,t(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);let v=e.get(p),T=v.envMap,b=v.envMapRotation;T&&(m.envMap.value=T,m.envMapRotation.value.setFromMatrix4(kM.makeRotationFromEuler(b)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(_m),m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,v,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*v,m.scale.value=T*.5,p.map&&(m.map.value=p.map,t(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,t(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,t(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function d(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function f(m,p,v){m.ior.value=p.ior,p.diffuseRoughness>0&&(m.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===en&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.retroreflectivity>0&&(m.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function M(m,p){let v=e.get(p).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function VM(i,e,t,n){let s={},r={};function o(v,T){let b=T.program;n.uniformBlockBinding(v,b,s[v.id])}function a(v,T){let b=s[v.id];b===void 0&&(g(v),b=l(v),s[v.id]=b,v.addEventListener("dispose",m));let C=T.program;n.updateUBOMapping(v,C);let E=e.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let T=i.createBuffer(),b=v.__size,C=v.usage;return i.bindBuffer(i.UNIFORM_BUFFER,T),i.bufferData(i.UNIFORM_BUFFER,b,C),i.bindBuffer(i.UNIFORM_BUFFER,null),T}function c(v){let T=s[v.id],b=v.uniforms,C=v.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let E=0,_=b.length;E<_;E++){let A=b[E];if(Array.isArray(A))for(let B=0,D=A.length;B<D;B++)u(A[B],E,B,C);else u(A,E,0,C)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function u(v,T,b,C){if(d(v,T,b,C)===!0){let E=v.__offset,_=v.value;if(Array.isArray(_)){let A=0;for(let B=0;B<_.length;B++){let D=_[B],N=M(D,!0);h(D,v.__data,A),A+=N.storage/Float32Array.BYTES_PER_ELEMENT}}else h(_,v.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,E,v.__data)}}function h(v,T,b){typeof v=="number"||typeof v=="boolean"?T[b]=v:v.isMatrix3?(T[b]=v.elements[0],T[b+1]=v.elements[1],T[b+2]=v.elements[2],T[b+3]=0,T[b+4]=v.elements[3],T[b+5]=v.elements[4],T[b+6]=v.elements[5],T[b+7]=0,T[b+8]=v.elements[6],T[b+9]=v.elements[7],T[b+10]=v.elements[8],T[b+11]=0):ArrayBuffer.isView(v)?T.set(v.subarray(0,T.length-b),b):v.toArray(T,b)}function d(v,T,b,C){let E=v.value,_=T+"_"+b;if(Array.isArray(E)){C[_]===void 0&&(C[_]=[]);let A=C[_],B=!1;for(let D=0;D<E.length;D++)f(E[D],A,D)===!0&&(B=!0);return B}return f(E,C,_)}function f(v,T,b){if(T[b]===void 0)return typeof v=="number"||typeof v=="boolean"?T[b]=v:ArrayBuffer.isView(v)?T[b]=v.slice():T[b]=v.clone(),!0;{let C=T[b];if(typeof v=="number"||typeof v=="boolean"){if(C!==v)return T[b]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(C.equals(v)===!1)return C.copy(v),!0}}return!1}function g(v){let T=v.uniforms,b=0,C=16;for(let _=0,A=T.length;_<A;_++){let B=Array.isArray(T[_])?T[_]:[T[_]];for(let D=0,N=B.length;D<N;D++){let k=B[D],G=Array.isArray(k.value)?k.value:[k.value],L=Array.isArray(T[_])||Array.isArray(k.value),H=b;for(let V=0,le=G.length;V<le;V++){let J=G[V],j=M(J,L),ie=b%C,de=ie%j.boundary,ue=ie+de;b+=de,ue!==0&&C-ue<j.storage&&(b+=C-ue),V===0&&(H=b),b+=j.storage}let Y=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new Y((b-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let E=b%C;return E>0&&(b+=C-E),v.__size=b,v.__cache={},this}function M(v,T){let b={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(b.boundary=4,b.storage=4):v.isVector2?(b.boundary=8,b.storage=8):v.isVector3||v.isColor?(b.boundary=16,b.storage=12):v.isVector4?(b.boundary=16,b.storage=16):v.isMatrix3?(b.boundary=16,b.storage=48):v.isMatrix4?(b.boundary=16,b.storage=64):v.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(b.boundary=16,b.storage=v.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",v),T===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function m(v){let T=v.target;T.removeEventListener("dispose",m),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(let v in s)i.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:p}}var GM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Xi=null;function HM(){return Xi===null&&(Xi=new Rl(GM,16,16,Os,Ti),Xi.name="DFG_LUT",Xi.minFilter=Vn,Xi.magFilter=Vn,Xi.wrapS=zi,Xi.wrapT=zi,Xi.generateMipmaps=!1,Xi.needsUpdate=!0),Xi}var Dc=class{constructor(e={}){let{canvas:t=Pp(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Yn}=e;this.isWebGLRenderer=!0;let g;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=n.getContextAttributes().alpha}else g=o;let M=f,m=new Set([Ql,jl,Kl]),p=new Set([Yn,Ai,Qr,tr,Zl,Jl]),v=new Uint32Array(4),T=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},C=null,E=null,_=[],A=[],B=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Wi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,N=!1,k=null,G=null,L=null,H=null;this._outputColorSpace=ti;let Y=0,V=0,le=null,J=-1,j=null,ie=new Wt,de=new Wt,ue=null,Q=new Ye(0),me=0,_e=t.width,Te=t.height,Me=1,He=null,it=null,Ve=new Wt(0,0,_e,Te),ut=new Wt(0,0,_e,Te),at=!1,tt=new Ls,Vt=new Cl,Dt=!1,tn=!1,Ct=new Ht,vn=new q,_t=new Wt,dn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},qt=!1;function nn(){return le===null?Me:1}let U=n;function Ce(w,O){return t.getContext(w,O)}let qe,st,Se,It,ze,Xe,R,y,W,ce,re,xe,ve,ee,ne,pe,F,se,te,we,ge,be,Ge;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Oe,!1),t.addEventListener("webglcontextrestored",Ke,!1),t.addEventListener("webglcontextcreationerror",Re,!1),U===null){let O="webgl2";if(U=Ce(O,w),U===null)throw Ce(O)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Je()}catch(w){throw t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),Qe("WebGLRenderer: "+w.message),w}function Je(){qe=new eb(U),qe.init(),ge=new UM(U,qe),st=new Hy(U,qe,e,ge),Se=new DM(U,qe),st.reversedDepthBuffer&&d&&Se.buffers.depth.setReversed(!0),G=U.createFramebuffer(),L=U.createFramebuffer(),H=U.createFramebuffer(),It=new ib(U),ze=new yM,Xe=new FM(U,qe,Se,ze,st,ge,It),R=new Qy(D),y=new r_(U),be=new Vy(U,y),W=new tb(U,y,It,be),ce=new rb(U,W,y,be,It),se=new sb(U,st,Xe),ne=new Wy(ze),re=new vM(D,R,qe,st,be,ne),xe=new zM(D,ze),ve=new MM,ee=new RM(qe),F=new zy(D,R,Se,ce,g,l),pe=new NM(D,ce,st),Ge=new VM(U,It,st,Se),te=new Gy(U,qe,It),we=new nb(U,qe,It),It.programs=re.programs,D.capabilities=st,D.extensions=qe,D.properties=ze,D.renderLists=ve,D.shadowMap=pe,D.state=Se,D.info=It}M!==Yn&&(B=new ab(M,t.width,t.height,a,s,r));let ae=new Wh(D,U);this.xr=ae,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let w=qe.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=qe.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return Me},this.setPixelRatio=function(w){w!==void 0&&(Me=w,this.setSize(_e,Te,!1))},this.getSize=function(w){return w.set(_e,Te)},this.setSize=function(w,O,K=!0){if(ae.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=w,Te=O,t.width=Math.floor(w*Me),t.height=Math.floor(O*Me),K===!0&&(t.style.width=w+"px",t.style.height=O+"px"),B!==null&&B.setSize(t.width,t.height),this.setViewport(0,0,w,O)},this.getDrawingBufferSize=function(w){return w.set(_e*Me,Te*Me).floor()},this.setDrawingBufferSize=function(w,O,K){_e=w,Te=O,Me=K,t.width=Math.floor(w*K),t.height=Math.floor(O*K),this.setViewport(0,0,w,O)},this.setEffects=function(w){if(M===Yn){Qe("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let O=0;O<w.length;O++)if(w[O].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}B.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(ie)},this.getViewport=function(w){return w.copy(Ve)},this.setViewport=function(w,O,K,X){w.isVector4?Ve.set(w.x,w.y,w.z,w.w):Ve.set(w,O,K,X),Se.viewport(ie.copy(Ve).multiplyScalar(nn()).round())},this.getScissor=function(w){return w.copy(ut)},this.setScissor=function(w,O,K,X){w.isVector4?ut.set(w.x,w.y,w.z,w.w):ut.set(w,O,K,X),Se.scissor(de.copy(ut).multiplyScalar(nn()).round())},this.getScissorTest=function(){return at},this.setScissorTest=function(w){Se.setScissorTest(at=w)},this.setOpaqueSort=function(w){He=w},this.setTransparentSort=function(w){it=w},this.getClearColor=function(w){return w.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(w=!0,O=!0,K=!0){let X=0;if(w){let $=!1;if(le!==null){let Ae=le.texture.format;$=m.has(Ae)}if($){let Ae=le.texture.type,Pe=p.has(Ae),Ee=F.getClearColor(),Ie=F.getClearAlpha(),ke=Ee.r,je=Ee.g,ht=Ee.b;Pe?(v[0]=ke,v[1]=je,v[2]=ht,v[3]=Ie,U.clearBufferuiv(U.COLOR,0,v)):(T[0]=ke,T[1]=je,T[2]=ht,T[3]=Ie,U.clearBufferiv(U.COLOR,0,T))}else X|=U.COLOR_BUFFER_BIT}O&&(X|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),K&&(X|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),X!==0&&U.clear(X)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),k=w},this.dispose=function(){t.removeEventListener("webglcontextlost",Oe,!1),t.removeEventListener("webglcontextrestored",Ke,!1),t.removeEventListener("webglcontextcreationerror",Re,!1),F.dispose(),ve.dispose(),ee.dispose(),Xe.dispose(),ze.dispose(),R.dispose(),ce.dispose(),W.dispose(),be.dispose(),Ge.dispose(),re.dispose(),ae.dispose(),ae.removeEventListener("sessionstart",Aa),ae.removeEventListener("sessionend",Li),$i.stop()};function Oe(w){w.preventDefault(),Oo("WebGLRenderer: Context Lost."),N=!0}function Ke(){Oo("WebGLRenderer: Context Restored."),N=!1;let w=It.autoReset,O=pe.enabled,K=pe.autoUpdate,X=pe.needsUpdate,$=pe.type;Je(),It.autoReset=w,pe.enabled=O,pe.autoUpdate=K,pe.needsUpdate=X,pe.type=$}function Re(w){Qe("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function rt(w){let O=w.target;O.removeEventListener("dispose",rt),Ft(O)}function Ft(w){Dn(w),ze.remove(w)}function Dn(w){let O=ze.get(w).programs;O!==void 0&&(O.forEach(function(K){re.releaseProgram(K)}),w.isShaderMaterial&&re.releaseShaderCache(w))}this.renderBufferDirect=function(w,O,K,X,$,Ae){O===null&&(O=dn);let Pe=$.isMesh&&$.matrixWorld.determinantAffine()<0,Ee=_o(w,O,K,X,$);Se.setMaterial(X,Pe);let Ie=K.index,ke=1;if(X.wireframe===!0){if(Ie=W.getWireframeAttribute(K),Ie===void 0)return;ke=2}let je=K.drawRange,ht=K.attributes.position,Be=je.start*ke,dt=(je.start+je.count)*ke;Ae!==null&&(Be=Math.max(Be,Ae.start*ke),dt=Math.min(dt,(Ae.start+Ae.count)*ke)),Ie!==null?(Be=Math.max(Be,0),dt=Math.min(dt,Ie.count)):ht!=null&&(Be=Math.max(Be,0),dt=Math.min(dt,ht.count));let Xt=dt-Be;if(Xt<0||Xt===1/0)return;be.setup($,X,Ee,K,Ie);let Et,Tt=te;if(Ie!==null&&(Et=y.get(Ie),Tt=we,Tt.setIndex(Et)),$.isMesh)X.wireframe===!0?(Se.setLineWidth(X.wireframeLinewidth*nn()),Tt.setMode(U.LINES)):Tt.setMode(U.TRIANGLES);else if($.isLine){let fn=X.linewidth;fn===void 0&&(fn=1),Se.setLineWidth(fn*nn()),$.isLineSegments?Tt.setMode(U.LINES):$.isLineLoop?Tt.setMode(U.LINE_LOOP):Tt.setMode(U.LINE_STRIP)}else $.isPoints?Tt.setMode(U.POINTS):$.isSprite&&Tt.setMode(U.TRIANGLES);if($.isBatchedMesh)if(qe.get("WEBGL_multi_draw"))Tt.renderMultiDraw($._multiDrawStarts,$._multiDrawCounts,$._multiDrawCount);else{let fn=$._multiDrawStarts,Fe=$._multiDrawCounts,sn=$._multiDrawCount,pt=Ie?y.get(Ie).bytesPerElement:1,Ji=ze.get(X).currentProgram.getUniforms();for(let rn=0;rn<sn;rn++)Ji.setValue(U,"_gl_DrawID",rn),Tt.render(fn[rn]/pt,Fe[rn])}else if($.isInstancedMesh)Tt.renderInstances(Be,Xt,$.count);else if(K.isInstancedBufferGeometry){let fn=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Fe=Math.min(K.instanceCount,fn);Tt.renderInstances(Be,Xt,Fe)}else Tt.render(Be,Xt)};function mo(w,O,K,X){k!==null&&w.isNodeMaterial&&k.setObject(X,w),Dt===!0&&ne.setState(w,K,!1),w.transparent===!0&&w.side===fi&&w.forceSinglePass===!1?(w.side=en,w.needsUpdate=!0,Ni(w,O,X),w.side=qn,w.needsUpdate=!0,Ni(w,O,X),w.side=fi):Ni(w,O,X)}this.compile=function(w,O,K=null){K===null&&(K=w),k!==null&&k.renderStart(w,O,K),E=ee.get(K),E.init(O),A.push(E),K.traverseVisible(function($){$.isLight&&$.layers.test(O.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),w!==K&&w.traverseVisible(function($){$.isLight&&$.layers.test(O.layers)&&(E.pushLight($),$.castShadow&&E.pushShadow($))}),E.setupLights(),k!==null&&k.updateLights(E.state.lightsArray),tn=this.localClippingEnabled,Dt=ne.init(this.clippingPlanes,tn),Dt===!0&&ne.setGlobalState(this.clippingPlanes,O),k!==null&&pe.render(E.state.shadowsArray,K,O);let X=new Set;return w.traverse(function($){if(!($.isMesh||$.isPoints||$.isLine||$.isSprite))return;let Ae=$.material;if(Ae)if(Array.isArray(Ae))for(let Pe=0;Pe<Ae.length;Pe++){let Ee=Ae[Pe];mo(Ee,K,O,$),X.add(Ee)}else mo(Ae,K,O,$),X.add(Ae)}),E=A.pop(),k!==null&&k.renderEnd(),X},this.compileAsync=function(w,O,K=null){let X=this.compile(w,O,K);return new Promise($=>{function Ae(){if(X.forEach(function(Pe){let Ie=ze.get(Pe).currentProgram;(Ie===void 0||Ie.isReady())&&X.delete(Pe)}),X.size===0){$(w);return}setTimeout(Ae,10)}qe.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let hr=null;function ou(w){hr&&hr(w)}function Aa(){$i.stop()}function Li(){$i.start()}let $i=new lm;$i.setAnimationLoop(ou),typeof self<"u"&&$i.setContext(self),this.setAnimationLoop=function(w){hr=w,ae.setAnimationLoop(w),w===null?$i.stop():$i.start()},ae.addEventListener("sessionstart",Aa),ae.addEventListener("sessionend",Li),this.render=function(w,O){if(O!==void 0&&O.isCamera!==!0){Qe("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(N===!0)return;k!==null&&k.renderStart(w,O);let K=ae.enabled===!0&&ae.isPresenting===!0,X=B!==null&&(le===null||K)&&B.begin(D,le);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),O.parent===null&&O.matrixWorldAutoUpdate===!0&&O.updateMatrixWorld(),ae.enabled===!0&&ae.isPresenting===!0&&(B===null||B.isCompositing()===!1)&&(ae.cameraAutoUpdate===!0&&ae.updateCamera(O),O=ae.getCamera()),w.isScene===!0&&w.onBeforeRender(D,w,O,le),E=ee.get(w,A.length),E.init(O),E.state.textureUnits=Xe.getTextureUnits(),A.push(E),Ct.multiplyMatrices(O.projectionMatrix,O.matrixWorldInverse),O.isArrayCamera?Vt.setFromArrayCamera(O):tt.setFromProjectionMatrix(Ct,hi,O.reversedDepth),tn=this.localClippingEnabled,Dt=ne.init(this.clippingPlanes,tn),C=ve.get(w,_.length),C.init(),_.push(C),this.info.render.frame++,ae.enabled===!0&&ae.isPresenting===!0){let Pe=D.xr.getDepthSensingMesh();Pe!==null&&Zi(Pe,O,-1/0,D.sortObjects)}Zi(w,O,0,D.sortObjects),C.finish(),k!==null&&k.updateLights(E.state.lightsArray),D.sortObjects===!0&&C.sort(He,it),qt=ae.enabled===!1||ae.isPresenting===!1||ae.hasDepthSensing()===!1,qt&&F.addToRenderList(C,w),this.info.autoReset===!0&&this.info.reset(),Dt===!0&&ne.beginShadows();let $=E.state.shadowsArray;if(pe.render($,w,O),Dt===!0&&ne.endShadows(),(X&&B.hasRenderPass())===!1){let Pe=C.opaque,Ee=C.transmissive;if(E.setupLights(),O.isArrayCamera){let Ie=O.cameras;if(Ee.length>0)for(let ke=0,je=Ie.length;ke<je;ke++){let ht=Ie[ke];gi(Pe,Ee,w,ht)}qt&&F.render(w);for(let ke=0,je=Ie.length;ke<je;ke++){let ht=Ie[ke];go(C,w,ht,ht.viewport)}}else Ee.length>0&&gi(Pe,Ee,w,O),qt&&F.render(w),go(C,w,O)}le!==null&&V===0&&(Xe.updateMultisampleRenderTarget(le),Xe.updateRenderTargetMipmap(le)),X&&B.end(D),w.isScene===!0&&w.onAfterRender(D,w,O),be.resetDefaultState(),J=-1,j=null,A.pop(),A.length>0?(E=A[A.length-1],Xe.setTextureUnits(E.state.textureUnits),Dt===!0&&ne.setGlobalState(D.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?C=_[_.length-1]:C=null,k!==null&&k.renderEnd()};function Zi(w,O,K,X){if(w.visible===!1)return;if(w.layers.test(O.layers)){if(w.isGroup)K=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(O);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Pe=O.isArrayCamera?Vt:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){X&&_t.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Ct);let Ee=ce.update(w),Ie=w.material;Ie.visible&&C.push(w,Ee,Ie,K,_t.z,null,O)}}else if(w.isMesh||w.isLine||w.isPoints){let Pe=O.isArrayCamera?Vt:tt;if(!w.frustumCulled||w.intersectsFrustum(Pe)){let Ee=ce.update(w),Ie=w.material;if(X&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),_t.copy(w.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),_t.copy(Ee.boundingSphere.center)),_t.applyMatrix4(w.matrixWorld).applyMatrix4(Ct)),Array.isArray(Ie)){let ke=Ee.groups;for(let je=0,ht=ke.length;je<ht;je++){let Be=ke[je],dt=Ie[Be.materialIndex];dt&&dt.visible&&C.push(w,Ee,dt,K,_t.z,Be,O)}}else Ie.visible&&C.push(w,Ee,Ie,K,_t.z,null,O)}}}let Ae=w.children;for(let Pe=0,Ee=Ae.length;Pe<Ee;Pe++)Zi(Ae[Pe],O,K,X)}function go(w,O,K,X){let{opaque:$,transmissive:Ae,transparent:Pe}=w;E.setupLightsView(K),Dt===!0&&ne.setGlobalState(D.clippingPlanes,K),X&&Se.viewport(ie.copy(X)),$.length>0&&Yt($,O,K),Ae.length>0&&Yt(Ae,O,K),Pe.length>0&&Yt(Pe,O,K),Se.buffers.depth.setTest(!0),Se.buffers.depth.setMask(!0),Se.buffers.color.setMask(!0),Se.setPolygonOffset(!1)}function gi(w,O,K,X){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[X.id]===void 0){let Be=qe.has("EXT_color_buffer_half_float")||qe.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[X.id]=new ni(1,1,{generateMipmaps:!0,type:Be?Ti:Yn,minFilter:ds,samples:Math.max(4,st.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:mt.workingColorSpace})}let Ae=E.state.transmissionRenderTarget[X.id],Pe=X.viewport||ie;Ae.setSize(Pe.z*D.transmissionResolutionScale,Pe.w*D.transmissionResolutionScale);let Ee=D.getRenderTarget(),Ie=D.getActiveCubeFace(),ke=D.getActiveMipmapLevel();D.setRenderTarget(Ae),D.getClearColor(Q),me=D.getClearAlpha(),me<1&&D.setClearColor(16777215,.5),D.clear(),qt&&F.render(K);let je=D.toneMapping;D.toneMapping=Wi;let ht=X.viewport;if(X.viewport!==void 0&&(X.viewport=void 0),E.setupLightsView(X),Dt===!0&&ne.setGlobalState(D.clippingPlanes,X),Yt(w,K,X),Xe.updateMultisampleRenderTarget(Ae),Xe.updateRenderTargetMipmap(Ae),qe.has("WEBGL_multisampled_render_to_texture")===!1){let Be=!1;for(let dt=0,Xt=O.length;dt<Xt;dt++){let Et=O[dt],{object:Tt,geometry:fn,material:Fe,group:sn}=Et;if(Fe.side===fi&&Tt.layers.test(X.layers)){let pt=Fe.side;Fe.side=en,Fe.needsUpdate=!0,jt(Tt,K,X,fn,Fe,sn),Fe.side=pt,Fe.needsUpdate=!0,Be=!0}}Be===!0&&(Xe.updateMultisampleRenderTarget(Ae),Xe.updateRenderTargetMipmap(Ae))}D.setRenderTarget(Ee,Ie,ke),D.setClearColor(Q,me),ht!==void 0&&(X.viewport=ht),D.toneMapping=je}function Yt(w,O,K){let X=O.isScene===!0?O.overrideMaterial:null;for(let $=0,Ae=w.length;$<Ae;$++){let Pe=w[$],{object:Ee,geometry:Ie,group:ke}=Pe,je=Pe.material;je.allowOverride===!0&&X!==null&&(je=X),Ee.layers.test(K.layers)&&jt(Ee,O,K,Ie,je,ke)}}function jt(w,O,K,X,$,Ae){k!==null&&$.isNodeMaterial&&k.setObject(w,$),w.onBeforeRender(D,O,K,X,$,Ae),w.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),$.onBeforeRender(D,O,K,X,w,Ae),$.transparent===!0&&$.side===fi&&$.forceSinglePass===!1?($.side=en,$.needsUpdate=!0,D.renderBufferDirect(K,O,X,$,w,Ae),$.side=qn,$.needsUpdate=!0,D.renderBufferDirect(K,O,X,$,w,Ae),$.side=fi):D.renderBufferDirect(K,O,X,$,w,Ae),w.onAfterRender(D,O,K,X,$,Ae)}function Qt(w){let O=0;for(let K of w)K.texture!==null&&O++;return O}function Ni(w,O,K){O.isScene!==!0&&(O=dn);let X=ze.get(w),$=E.state.lights,Ae=E.state.shadowsArray,Pe=$.state.version,Ee=re.getParameters(w,$.state,Ae,O,K,E.state.lightProbeGridArray),Ie=re.getProgramCacheKey(Ee),ke=X.programs;X.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?O.environment:null,X.fog=O.fog;let je=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;X.envMap=R.get(w.envMap||X.environment,je),X.envMapRotation=X.environment!==null&&w.envMap===null?O.environmentRotation:w.envMapRotation,ke===void 0&&(w.addEventListener("dispose",rt),ke=new Map,X.programs=ke,X.programVariants=new Map);let ht=ke.get(Ie);if(ht!==void 0){if(X.currentProgram===ht&&X.lightsStateVersion===Pe)return xo(w,Ee),ht}else Ee.uniforms=re.getUniforms(w),k!==null&&w.isNodeMaterial&&k.build(w,K,Ee),w.onBeforeCompile(Ee,D),ht=re.acquireProgram(Ee,Ie),ke.set(Ie,ht),X.uniforms=Ee.uniforms;let Be=X.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(Be.clippingPlanes=ne.uniform),xo(w,Ee),X.needsLights=_s(w),X.lightsStateVersion=Pe,X.needsLights&&(Be.ambientLightColor.value=$.state.ambient,Be.lightProbe.value=$.state.probe,Be.sunLights.value=$.state.sun,Be.sunLightShadows.value=$.state.sunShadow,Be.directionalLights.value=$.state.directional,Be.directionalLightShadows.value=$.state.directionalShadow,Be.spotLights.value=$.state.spot,Be.spotLightShadows.value=$.state.spotShadow,Be.rectAreaLights.value=$.state.rectArea,Be.ltc_1.value=$.state.rectAreaLTC1,Be.ltc_2.value=$.state.rectAreaLTC2,Be.pointLights.value=$.state.point,Be.pointLightShadows.value=$.state.pointShadow,Be.hemisphereLights.value=$.state.hemi,Be.sunShadowMatrix.value=$.state.sunShadowMatrix,Be.sunShadowCascade.value=$.state.sunShadowCascade,Be.directionalShadowMatrix.value=$.state.directionalShadowMatrix,Be.spotLightMatrix.value=$.state.spotLightMatrix,Be.spotLightMap.value=$.state.spotLightMap,Be.pointShadowMatrix.value=$.state.pointShadowMatrix),X.numLightProbeGrids=Qt(E.state.lightProbeGridArray),X.currentProgram=ht,X.uniformsList=null,ht}function $n(w,O,K,X,$){let Ae=ze.get(w),Pe=Ae.currentProgram.id+","+X+","+$,Ee=Ae.programVariants.get(Pe);return Ee===void 0?(Ee=Ni(w,O,K),Ae.programVariants.set(Pe,Ee)):(Ae.currentProgram=Ee,Ae.uniformsList=null,Ae.outputColorSpace=X,Ae.toneMapping=$),Ee}function xs(w){if(w.uniformsList===null){let O=w.currentProgram.getUniforms();w.uniformsList=eo.seqWithValue(O.seq,w.uniforms)}return w.uniformsList}function xo(w,O){let K=ze.get(w);K.outputColorSpace=O.outputColorSpace,K.batching=O.batching,K.batchingColor=O.batchingColor,K.instancing=O.instancing,K.instancingColor=O.instancingColor,K.instancingMorph=O.instancingMorph,K.skinning=O.skinning,K.morphTargets=O.morphTargets,K.morphNormals=O.morphNormals,K.morphColors=O.morphColors,K.morphTargetsCount=O.morphTargetsCount,K.numClippingPlanes=O.numClippingPlanes,K.numIntersection=O.numClipIntersection,K.vertexAlphas=O.vertexAlphas,K.vertexTangents=O.vertexTangents,K.toneMapping=O.toneMapping}function _o(w,O,K,X,$){O.isScene!==!0&&(O=dn),Xe.resetTextureUnits();let Ae=O.fog,Pe=X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial?O.environment:null,Ee=le===null?D.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:mt.workingColorSpace,Ie=X.isMeshStandardMaterial||X.isMeshLambertMaterial&&!X.envMap||X.isMeshPhongMaterial&&!X.envMap,ke=R.get(X.envMap||Pe,Ie),je=X.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,ht=!!K.attributes.tangent&&(!!X.normalMap||X.anisotropy>0),Be=!!K.morphAttributes.position,dt=!!K.morphAttributes.normal,Xt=!!K.morphAttributes.color,Et=Wi;X.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(Et=D.toneMapping);let Tt=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,fn=Tt!==void 0?Tt.length:0,Fe=ze.get(X),sn=E.state.lights;if(Dt===!0&&(tn===!0||w!==j)){let Rt=w===j&&X.id===J;ne.setState(X,w,Rt)}let pt=!1,Ji=!1;X.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==sn.state.version||$.isBatchedMesh&&Fe.batching===!1||!$.isBatchedMesh&&Fe.batching===!0||$.isBatchedMesh&&Fe.batchingColor===!0&&$._colorsTexture===null||$.isBatchedMesh&&Fe.batchingColor===!1&&$._colorsTexture!==null||$.isInstancedMesh&&Fe.instancing===!1||!$.isInstancedMesh&&Fe.instancing===!0||$.isSkinnedMesh&&Fe.skinning===!1||!$.isSkinnedMesh&&Fe.skinning===!0||$.isInstancedMesh&&Fe.instancingColor===!0&&$.instanceColor===null||$.isInstancedMesh&&Fe.instancingColor===!1&&$.instanceColor!==null||$.isInstancedMesh&&Fe.instancingMorph===!0&&$.morphTexture===null||$.isInstancedMesh&&Fe.instancingMorph===!1&&$.morphTexture!==null||Fe.envMap!==ke||X.fog===!0&&Fe.fog!==Ae||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==ne.numPlanes||Fe.numIntersection!==ne.numIntersection)||Fe.vertexAlphas!==je||Fe.vertexTangents!==ht||Fe.morphTargets!==Be||Fe.morphNormals!==dt||Fe.morphColors!==Xt||Fe.morphTargetsCount!==fn||Fe.numLightProbeGrids!==Qt(E.state.lightProbeGridArray)?pt=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==Et)&&(Ji=!0):(pt=!0,Fe.__version=X.version);let rn=Fe.currentProgram;(pt===!0||Ji===!0)&&(rn=Ji===!0?$n(X,O,$,Ee,Et):Ni(X,O,$),k&&X.isNodeMaterial&&k.onUpdateProgram(X,rn,Fe));let pr=!1,Di=!1,Ki=!1,lt=rn.getUniforms(),$t=Fe.uniforms;if(Se.useProgram(rn.program)&&(pr=!0,Di=!0,Ki=!0),X.id!==J&&(J=X.id,Di=!0),pr||j!==w){Se.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),lt.setValue(U,"projectionMatrix",w.projectionMatrix),lt.setValue(U,"viewMatrix",w.matrixWorldInverse);let on=lt.map.cameraPosition;on!==void 0&&on.setValue(U,vn.setFromMatrixPosition(w.matrixWorld)),st.logarithmicDepthBuffer&&lt.setValue(U,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(X.isMeshPhongMaterial||X.isMeshToonMaterial||X.isMeshLambertMaterial||X.isMeshBasicMaterial||X.isMeshStandardMaterial||X.isShaderMaterial)&&lt.setValue(U,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,Di=!0,Ki=!0)}if(Fe.needsLights&&(sn.state.sunShadowMap.length>0&&lt.setValue(U,"sunShadowMap",sn.state.sunShadowMap,Xe),sn.state.directionalShadowMap.length>0&&lt.setValue(U,"directionalShadowMap",sn.state.directionalShadowMap,Xe),sn.state.spotShadowMap.length>0&&lt.setValue(U,"spotShadowMap",sn.state.spotShadowMap,Xe),sn.state.pointShadowMap.length>0&&lt.setValue(U,"pointShadowMap",sn.state.pointShadowMap,Xe)),$.isSkinnedMesh){lt.setOptional(U,$,"bindMatrix"),lt.setOptional(U,$,"bindMatrixInverse");let Rt=$.skeleton;Rt&&(Rt.boneTexture===null&&Rt.computeBoneTexture(),lt.setValue(U,"boneTexture",Rt.boneTexture,Xe))}$.isBatchedMesh&&(lt.setOptional(U,$,"batchingTexture"),lt.setValue(U,"batchingTexture",$._matricesTexture,Xe),lt.setOptional(U,$,"batchingIdTexture"),lt.setValue(U,"batchingIdTexture",$._indirectTexture,Xe),lt.setOptional(U,$,"batchingColorTexture"),$._colorsTexture!==null&&lt.setValue(U,"batchingColorTexture",$._colorsTexture,Xe));let Fn=K.morphAttributes;if((Fn.position!==void 0||Fn.normal!==void 0||Fn.color!==void 0)&&se.update($,K,rn),(Di||Fe.receiveShadow!==$.receiveShadow)&&(Fe.receiveShadow=$.receiveShadow,lt.setValue(U,"receiveShadow",$.receiveShadow)),(X.isMeshStandardMaterial||X.isMeshLambertMaterial||X.isMeshPhongMaterial)&&X.envMap===null&&O.environment!==null&&($t.envMapIntensity.value=O.environmentIntensity),$t.dfgLUT!==void 0&&($t.dfgLUT.value=HM()),Di){if(lt.setValue(U,"toneMappingExposure",D.toneMappingExposure),Fe.needsLights&&dr($t,Ki),Ae&&X.fog===!0&&xe.refreshFogUniforms($t,Ae),xe.refreshMaterialUniforms($t,X,Me,Te,E.state.transmissionRenderTarget[w.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Rt=b,on=0;for(let Cn of E.state.lightProbeGridArray)Cn.texture!==null&&(Rt.textures[on]=Cn.texture,Rt.min[on]=Cn.boundingBox.min,Rt.max[on]=Cn.boundingBox.max,Rt.resolution[on]=Cn.resolution,on++);for(let Cn in Rt)Rt[Cn].length=on;$t.probesSH.value=Rt.textures,$t.probesMin.value=Rt.min,$t.probesMax.value=Rt.max,$t.probesResolution.value=Rt.resolution}eo.upload(U,xs(Fe),$t,Xe)}if(X.isShaderMaterial&&X.uniformsNeedUpdate===!0&&(eo.upload(U,xs(Fe),$t,Xe),X.uniformsNeedUpdate=!1),X.isSpriteMaterial&&lt.setValue(U,"center",$.center),lt.setValue(U,"modelViewMatrix",$.modelViewMatrix),lt.setValue(U,"normalMatrix",$.normalMatrix),lt.setValue(U,"modelMatrix",$.matrixWorld),X.uniformsGroups!==void 0){let Rt=X.uniformsGroups;for(let on=0,Cn=Rt.length;on<Cn;on++){let Ea=Rt[on];Ge.update(Ea,rn),Ge.bind(Ea,rn)}}return rn}function dr(w,O){w.ambientLightColor.needsUpdate=O,w.lightProbe.needsUpdate=O,w.sunLights.needsUpdate=O,w.sunLightShadows.needsUpdate=O,w.directionalLights.needsUpdate=O,w.directionalLightShadows.needsUpdate=O,w.pointLights.needsUpdate=O,w.pointLightShadows.needsUpdate=O,w.spotLights.needsUpdate=O,w.spotLightShadows.needsUpdate=O,w.rectAreaLights.needsUpdate=O,w.hemisphereLights.needsUpdate=O}function _s(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(w,O,K){let X=ze.get(w);X.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,X.__autoAllocateDepthBuffer===!1&&(X.__useRenderToTexture=!1),ze.get(w.texture).__webglTexture=O,ze.get(w.depthTexture).__webglTexture=X.__autoAllocateDepthBuffer?void 0:K,X.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,O){let K=ze.get(w);K.__webglFramebuffer=O,K.__useDefaultFramebuffer=O===void 0},this.setRenderTarget=function(w,O=0,K=0){le=w,Y=O,V=K;let X=null,$=!1,Ae=!1;if(w){let Ee=ze.get(w);if(Ee.__useDefaultFramebuffer!==void 0){Se.bindFramebuffer(U.FRAMEBUFFER,Ee.__webglFramebuffer),ie.copy(w.viewport),de.copy(w.scissor),ue=w.scissorTest,Se.viewport(ie),Se.scissor(de),Se.setScissorTest(ue),J=-1;return}else if(Ee.__webglFramebuffer===void 0)Xe.setupRenderTarget(w);else if(Ee.__hasExternalTextures)Xe.rebindTextures(w,ze.get(w.texture).__webglTexture,ze.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let je=w.depthTexture;if(Ee.__boundDepthTexture!==je){if(je!==null&&ze.has(je)&&(w.width!==je.image.width||w.height!==je.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xe.setupDepthRenderbuffer(w)}}let Ie=w.texture;(Ie.isData3DTexture||Ie.isDataArrayTexture||Ie.isCompressedArrayTexture)&&(Ae=!0);let ke=ze.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(ke[O])?X=ke[O][K]:X=ke[O],$=!0):w.samples>0&&Xe.useMultisampledRTT(w)===!1?X=ze.get(w).__webglMultisampledFramebuffer:Array.isArray(ke)?X=ke[K]:X=ke,ie.copy(w.viewport),de.copy(w.scissor),ue=w.scissorTest}else ie.copy(Ve).multiplyScalar(Me).floor(),de.copy(ut).multiplyScalar(Me).floor(),ue=at;if(K!==0&&(X=G),Se.bindFramebuffer(U.FRAMEBUFFER,X)&&Se.drawBuffers(w,X),Se.viewport(ie),Se.scissor(de),Se.setScissorTest(ue),$){let Ee=ze.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+O,Ee.__webglTexture,K)}else if(Ae){let Ee=O;for(let Ie=0;Ie<w.textures.length;Ie++){let ke=ze.get(w.textures[Ie]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Ie,ke.__webglTexture,K,Ee)}}else if(w!==null&&K!==0){let Ee=ze.get(w.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Ee.__webglTexture,K)}J=-1};function fr(w){let O=ze.get(w);return(O.__readFormat!==w.format||O.__readType!==w.type)&&(O.__readFormat=w.format,O.__readType=w.type,O.__formatReadable=st.textureFormatReadable(w.format),O.__typeReadable=st.textureTypeReadable(w.type)),O}this.readRenderTargetPixels=function(w,O,K,X,$,Ae,Pe,Ee=0){if(!(w&&w.isWebGLRenderTarget)){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie){Se.bindFramebuffer(U.FRAMEBUFFER,Ie);try{let ke=w.textures[Ee],je=ke.format,ht=ke.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ee);let Be=fr(ke);if(Be.__formatReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Be.__typeReadable===!1){Qe("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}O>=0&&O<=w.width-X&&K>=0&&K<=w.height-$&&U.readPixels(O,K,X,$,ge.convert(je),ge.convert(ht),Ae)}finally{let ke=le!==null?ze.get(le).__webglFramebuffer:null;Se.bindFramebuffer(U.FRAMEBUFFER,ke)}}},this.readRenderTargetPixelsAsync=async function(w,O,K,X,$,Ae,Pe,Ee=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ie=ze.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Pe!==void 0&&(Ie=Ie[Pe],Array.isArray(Ie)&&(Ie=Ie[0])),Ie)if(O>=0&&O<=w.width-X&&K>=0&&K<=w.height-$){Se.bindFramebuffer(U.FRAMEBUFFER,Ie);let ke=w.textures[Ee],je=ke.format,ht=ke.type;w.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Ee);let Be=fr(ke);if(Be.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Be.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let dt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,dt),U.bufferData(U.PIXEL_PACK_BUFFER,Ae.byteLength,U.STREAM_READ),U.readPixels(O,K,X,$,ge.convert(je),ge.convert(ht),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let Xt=le!==null?ze.get(le).__webglFramebuffer:null;Se.bindFramebuffer(U.FRAMEBUFFER,Xt);let Et=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await Lp(U,Et,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,dt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Ae),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(dt),U.deleteSync(Et),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,O=null,K=0){let X=Math.pow(2,-K),$=Math.floor(w.image.width*X),Ae=Math.floor(w.image.height*X),Pe=O!==null?O.x:0,Ee=O!==null?O.y:0;Xe.setTexture2D(w,0),U.copyTexSubImage2D(U.TEXTURE_2D,K,0,0,Pe,Ee,$,Ae),Se.unbindTexture()},this.copyTextureToTexture=function(w,O,K=null,X=null,$=0,Ae=0){let Pe,Ee,Ie,ke,je,ht,Be,dt,Xt,Et=w.isCompressedTexture?w.mipmaps[Ae]:w.image;if(K!==null)Pe=K.max.x-K.min.x,Ee=K.max.y-K.min.y,Ie=K.isBox3?K.max.z-K.min.z:1,ke=K.min.x,je=K.min.y,ht=K.isBox3?K.min.z:0;else{let lt=Math.pow(2,-$);Pe=Math.floor(Et.width*lt),Ee=Math.floor(Et.height*lt),w.isDataArrayTexture?Ie=Et.depth:w.isData3DTexture?Ie=Math.floor(Et.depth*lt):Ie=1,ke=0,je=0,ht=0}X!==null?(Be=X.x,dt=X.y,Xt=X.z):(Be=0,dt=0,Xt=0);let Tt=ge.convert(O.format),fn=ge.convert(O.type),Fe;O.isData3DTexture?(Xe.setTexture3D(O,0),Fe=U.TEXTURE_3D):O.isDataArrayTexture||O.isCompressedArrayTexture?(Xe.setTexture2DArray(O,0),Fe=U.TEXTURE_2D_ARRAY):(Xe.setTexture2D(O,0),Fe=U.TEXTURE_2D),Se.activeTexture(U.TEXTURE0),Se.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,O.flipY),Se.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,O.premultiplyAlpha),Se.pixelStorei(U.UNPACK_ALIGNMENT,O.unpackAlignment);let sn=Se.getParameter(U.UNPACK_ROW_LENGTH),pt=Se.getParameter(U.UNPACK_IMAGE_HEIGHT),Ji=Se.getParameter(U.UNPACK_SKIP_PIXELS),rn=Se.getParameter(U.UNPACK_SKIP_ROWS),pr=Se.getParameter(U.UNPACK_SKIP_IMAGES);Se.pixelStorei(U.UNPACK_ROW_LENGTH,Et.width),Se.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Et.height),Se.pixelStorei(U.UNPACK_SKIP_PIXELS,ke),Se.pixelStorei(U.UNPACK_SKIP_ROWS,je),Se.pixelStorei(U.UNPACK_SKIP_IMAGES,ht);let Di=w.isDataArrayTexture||w.isData3DTexture,Ki=O.isDataArrayTexture||O.isData3DTexture;if(w.isDepthTexture){let lt=ze.get(w),$t=ze.get(O),Fn=ze.get(lt.__renderTarget),Rt=ze.get($t.__renderTarget);Se.bindFramebuffer(U.READ_FRAMEBUFFER,Fn.__webglFramebuffer),Se.bindFramebuffer(U.DRAW_FRAMEBUFFER,Rt.__webglFramebuffer);for(let on=0;on<Ie;on++)Di&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ze.get(w).__webglTexture,$,ht+on),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ze.get(O).__webglTexture,Ae,Xt+on)),U.blitFramebuffer(ke,je,ke+Pe,je+Ee,Be,dt,Be+Pe,dt+Ee,U.DEPTH_BUFFER_BIT,U.NEAREST);Se.bindFramebuffer(U.READ_FRAMEBUFFER,null),Se.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if($!==0||w.isRenderTargetTexture||ze.has(w)){let lt=ze.get(w),$t=ze.get(O);Se.bindFramebuffer(U.READ_FRAMEBUFFER,L),Se.bindFramebuffer(U.DRAW_FRAMEBUFFER,H);for(let Fn=0;Fn<Ie;Fn++)Di?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,lt.__webglTexture,$,ht+Fn):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,lt.__webglTexture,$),Ki?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,$t.__webglTexture,Ae,Xt+Fn):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,$t.__webglTexture,Ae),$!==0?U.blitFramebuffer(ke,je,ke+Pe,je+Ee,Be,dt,Be+Pe,dt+Ee,U.COLOR_BUFFER_BIT,U.NEAREST):Ki?U.copyTexSubImage3D(Fe,Ae,Be,dt,Xt+Fn,ke,je,Pe,Ee):U.copyTexSubImage2D(Fe,Ae,Be,dt,ke,je,Pe,Ee);Se.bindFramebuffer(U.READ_FRAMEBUFFER,null),Se.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Ki?w.isDataTexture||w.isData3DTexture?U.texSubImage3D(Fe,Ae,Be,dt,Xt,Pe,Ee,Ie,Tt,fn,Et.data):O.isCompressedArrayTexture?U.compressedTexSubImage3D(Fe,Ae,Be,dt,Xt,Pe,Ee,Ie,Tt,Et.data):U.texSubImage3D(Fe,Ae,Be,dt,Xt,Pe,Ee,Ie,Tt,fn,Et):w.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Ae,Be,dt,Pe,Ee,Tt,fn,Et.data):w.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Ae,Be,dt,Et.width,Et.height,Tt,Et.data):U.texSubImage2D(U.TEXTURE_2D,Ae,Be,dt,Pe,Ee,Tt,fn,Et);Se.pixelStorei(U.UNPACK_ROW_LENGTH,sn),Se.pixelStorei(U.UNPACK_IMAGE_HEIGHT,pt),Se.pixelStorei(U.UNPACK_SKIP_PIXELS,Ji),Se.pixelStorei(U.UNPACK_SKIP_ROWS,rn),Se.pixelStorei(U.UNPACK_SKIP_IMAGES,pr),Ae===0&&O.generateMipmaps===!0&&O.mipmapsAutoUpdate===!0&&U.generateMipmap(Fe),Se.unbindTexture()},this.initRenderTarget=function(w){ze.get(w).__webglFramebuffer===void 0&&Xe.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xe.setTextureCube(w,0):w.isData3DTexture?Xe.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xe.setTexture2DArray(w,0):Xe.setTexture2D(w,0),Se.unbindTexture()},this.resetState=function(){Y=0,V=0,le=null,Se.reset(),be.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return hi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=mt._getDrawingBufferColorSpace(e),t.unpackColorSpace=mt._getUnpackColorSpace()}};function Oc(i,e,t,n){let s=t<2?t:(t-1)*n+1,r=new Float64Array(3*s),o=new Float64Array(s),a=(c,u)=>e[3*c+u]??0,l=(c,u)=>{let h=Math.max(0,c-1),d=Math.min(t-1,c+1),f=(i[d]??0)-(i[h]??0);return f>0?(a(d,u)-a(h,u))/f:0};for(let c=0;c<s;c++){let u=Math.min(Math.floor(c/n),Math.max(0,t-2)),h=c/n-u,d=i[u]??0,f=t>1?(i[u+1]??0)-d:0;o[c]=d+h*f;for(let g=0;g<3;g++)r[3*c+g]=t<2||h===0?a(u,g):WM(a(u,g),a(u+1,g),f*l(u,g),f*l(u+1,g),h)}return{points:r,times:o,lengths:XM(r)}}function WM(i,e,t,n,s){let r=1-s;return r*r*(1+2*s)*i+s*s*(3-2*s)*e+s*r*r*t-s*s*r*n}function XM(i){let e=new Float64Array(i.length/3);for(let t=1;t<e.length;t++){let n=Math.hypot((i[3*t]??0)-(i[3*t-3]??0),(i[3*t+1]??0)-(i[3*t-2]??0),(i[3*t+2]??0)-(i[3*t-1]??0));e[t]=(e[t-1]??0)+n}return e}var qM=new cs(1,1,1,14).translate(0,.5,0),YM=new qo(1,1,20).translate(0,.5,0),$M=new q(0,1,0),Bc=class{group=new cn;parts=[];thickness=1;constructor(e){for(let t of[!1,!0]){let n=new Is({color:e,transparent:t,opacity:t?.35:1,depthTest:!t,depthWrite:!t}),s=new yt(qM,n),r=new yt(YM,n);s.renderOrder=r.renderOrder=t?10:2,this.parts.push({shaft:s,head:r}),this.group.add(s,r)}}set(e,t){let n=t.length();if(this.group.visible=Number.isFinite(n)&&n>1e-9,!this.group.visible)return;this.group.position.copy(e),this.group.quaternion.copy(new di().setFromUnitVectors($M,t.clone().divideScalar(n)));let s=Math.min(this.thickness,.25*n),r=Math.min(5*s,.6*n);for(let{shaft:o,head:a}of this.parts)o.scale.set(s,n-r,s),a.scale.set(2.6*s,r,2.6*s),a.position.y=n-r}dispose(){for(let{shaft:e}of this.parts)e.material.dispose()}};var pa=class{group=new cn;materials=[];constructor(e,t){let n=new Gn;n.setAttribute("position",new pn(e.positions,3)),n.setAttribute("normal",new pn(e.normals,3)),n.setIndex(new pn(e.indices,1));let{low:s,high:r}=Eo(e.positions),o=new q(...s).add(new q(...r)).multiplyScalar(.5),{hollow:a}=e;for(let l of a?[en,qn]:[fi]){let c=ZM(o,l,a,t),u=new yt(n,c);u.castShadow=!a,u.renderOrder=l===en?0:a?8:1,this.materials.push(c),this.group.add(u)}}set glass(e){for(let t of this.materials)t.userData.wall!==!0&&(t.opacity=e?.4:1,t.transparent=e,t.depthWrite=!e,t.needsUpdate=!0)}dispose(){for(let e of this.group.children)e instanceof yt&&e.geometry.dispose();for(let e of this.materials)e.dispose()}};function ZM(i,e,t,n){let s=t&&e===qn,r=new hs({color:16777215,specular:new Ye(3356733),shininess:42,side:e,transparent:s,opacity:s?.16:1,depthWrite:!s});r.userData.wall=s;let o=t?n.shell:n.body;return r.onBeforeCompile=a=>{a.uniforms.uMiddle={value:i},a.uniforms.uFirst={value:new Ye(o[0])},a.uniforms.uSecond={value:new Ye(o[1])},a.uniforms.uSeam={value:new Ye(n.seam)},a.vertexShader=a.vertexShader.replace("#include <common>",`#include <common>
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
        #include <opaque_fragment>`)},r}function ym(i,e){let t=new cn,n=new Xn({transparent:!0,depthWrite:!1,uniforms:{colour:{value:new Ye(e.grid)},spacing:{value:i},middle:{value:new q},reach:{value:1}},vertexShader:`varying vec2 vPlace;
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
      }`}),s=new yt(new Ns(1,1),n),r=new yt(new Ns(1,1),new Yo({opacity:e.shadow,depthWrite:!1}));r.receiveShadow=!0,s.renderOrder=-2,r.renderOrder=-1,s.frustumCulled=r.frustumCulled=!1,t.add(s,r);let o=[s,r].map(a=>a.geometry.getAttribute("position"));return{group:t,spacing:i,around(a,l){for(let u of o){for(let h=0;h<4;h++)u.setXYZ(h,a[0]+l*(h%2?1:-1),a[1]+l*(h<2?1:-1),0);u.needsUpdate=!0}(n.uniforms.middle?.value).set(...a);let c=n.uniforms.reach;c&&(c.value=l)}}}function bm(i,e,t,n){let s=t>=Math.PI,r=e&&!s?Math.PI-t:0,o=new us(i,128,80,0,2*Math.PI,r,s?Math.PI:t);o.rotateX(Math.PI/2);let a=(t>.8?15:5)*(Math.PI/180);return wm(o,e,Sm.graticule(a),n)}function Mm(i,e,t){let n=new Gn;return n.setAttribute("position",new pn(i.positions,3)),n.setAttribute("normal",new pn(i.normals,3)),n.setIndex(new pn(i.indices,1)),wm(n,!1,Sm.planes(e),t)}var Sm={graticule:i=>`
    float polar = acos(clamp(vOwn.z / length(vOwn), -1.0, 1.0));
    float around = atan(vOwn.y, vOwn.x);
    vec2 line = vec2(polar, around) / ${i.toFixed(9)};
    vec2 width = vec2(fwidth(polar), length(fwidth(vOwn.xy)) / max(length(vOwn.xy), 1e-9)) / ${i.toFixed(9)};
    vec2 off = abs(fract(line - 0.5) - 0.5);
    vec2 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    float polarEdge = min(polar, 3.14159265 - polar);
    if (polarEdge < ${i.toFixed(9)}) ink.y = 0.0;
    float lines = max(ink.x, ink.y);`,planes:i=>`
    vec3 line = vOwn / ${i.toFixed(9)}; vec3 width = fwidth(line) + 1e-9;
    vec3 off = abs(fract(line - 0.5) - 0.5);
    vec3 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    ink *= clamp((0.98 - abs(vTurn)) / 0.1, 0.0, 1.0);
    float lines = max(ink.x, max(ink.y, ink.z));`};function wm(i,e,t,n){let s=new cn,[r,o]=e?[en,qn]:[qn,en],a=new yt(i,vm(r,1,t,n));a.receiveShadow=!0,a.renderOrder=-2;let l=new yt(i,vm(o,.14,t,n));return l.renderOrder=9,s.add(a,l),{group:s,spacing:0,around:()=>{}}}function vm(i,e,t,n){let s=e<1,r=new $o({color:n.ground[0],side:i,transparent:s,opacity:e,depthWrite:!s});return r.onBeforeCompile=o=>{o.uniforms.uLine={value:new Ye(n.grid)},o.vertexShader=o.vertexShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vOwn = position;
vTurn = normalize(normal);`),o.fragmentShader=o.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;
uniform vec3 uLine;`).replace("#include <color_fragment>",`${t}
        diffuseColor.rgb = mix(diffuseColor.rgb, uLine, 0.7 * lines);
        ${s?"diffuseColor.a = mix(diffuseColor.a, 0.4, 0.6 * lines);":""}`)},r.customProgramCacheKey=()=>t+String(s),r}var kc=class{constructor(e,t,n){this.mark=t;let s=new hs({color:n.dark?"#8fa6bb":"#33424f",specular:2236962}),r=new hs({color:n.body[1],specular:2236962}),o=new hs({color:n.body[0],specular:2236962});for(let a of e){let l=new cn;for(let c of JM(a.kind,t,{dark:s,rod:r,joint:o}))c.castShadow=!0,l.add(c);this.parts.push({link:a,group:l}),this.group.add(l)}}mark;group=new cn;parts=[];at(e,t){for(let{link:n,group:s}of this.parts){let r=n.kind==="rod"?4:n.kind==="point"?2:3,o=jn(e,n.column,r,t);if(s.visible=o!==null&&o.every(Number.isFinite),o===null)continue;let[a=0,l=0,c=0,u=0]=o;if(n.kind==="rod"){let h=Math.hypot(c-a,u-l);s.position.set((a+c)/2,(l+u)/2,.5*this.mark),s.rotation.z=Math.atan2(u-l,c-a),s.scale.x=h}else s.position.set(a,l,0),s.rotation.z=n.kind==="point"?0:c}}};function JM(i,e,{dark:t,rod:n,joint:s}){let r=e/2;switch(i){case"rod":return[new yt(new ls(1,.14*e,.1*e),n)];case"wheel":return[Xh(r,.3*e,0,t)];case"axle":{let o=new yt(new cs(.06*e,.06*e,1.1*e,12),n);return o.position.z=.75*r,[o,Xh(.75*r,.24*e,.55*e,t),Xh(.75*r,.24*e,-.55*e,t)]}case"blade":{let o=new yt(new ls(1.3*e,.06*e,.45*e),t);return o.position.z=.225*e,[o]}case"point":{let o=new yt(new us(.16*e,24,16),s);return o.position.z=.5*e,[o]}}}function Xh(i,e,t,n){let s=new yt(new cs(i,i,e,32),n);return s.position.set(0,t,i),s}var qh=5,KM=`
attribute vec3 from;
attribute vec3 to;
attribute vec2 fromMark;
attribute vec2 toMark;
uniform vec2 screen;
uniform float width;
uniform float lift;
varying vec2 vMark;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  vec2 run = (b.xy / b.w - a.xy / a.w) * screen;
  float far = length(run);
  vec2 along = far > 1e-6 ? run / far : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  bool end = position.x > 0.5;
  gl_Position = end ? b : a;
  vMark = end ? toMark : fromMark;
  // half a width beyond both ends: the joints of thick curves stay closed
  vec2 shift = side * position.y + along * (end ? 0.35 : -0.35);
  gl_Position.xy += shift * width / screen * gl_Position.w;
  gl_Position.z -= lift * gl_Position.w;
}`,jM=`
uniform vec3 scale[${qh}];
uniform vec2 span;
uniform vec2 now;
uniform float tail;
uniform float before;
uniform float after;
varying vec2 vMark;
void main() {
  float share = clamp((vMark.x - span.x) / (span.y - span.x), 0.0, 1.0) * ${(qh-1).toFixed(1)};
  vec3 colour = scale[0];
  for (int k = 1; k < ${qh}; k++) colour = mix(colour, scale[k], clamp(share - float(k - 1), 0.0, 1.0));
  float alpha = vMark.x <= now.x ? before : after;
  if (vMark.x <= now.x) alpha *= 1.0 - smoothstep(0.6 * tail, tail, now.y - vMark.y);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(colour, alpha);
  #include <colorspace_fragment>
}`,ma=class{mesh;curve;constructor(e,t,n){this.curve=e;let s=e.times.length,r=new Float32Array(5*Math.max(2,s));for(let u=0;u<s;u++)r.set([e.points[3*u]??0,e.points[3*u+1]??0,e.points[3*u+2]??0,e.times[u]??0,e.lengths[u]??0],5*u);let o=new ea;o.setAttribute("position",new un([0,-1,0,1,-1,0,0,1,0,1,1,0],3)),o.setIndex([0,1,2,2,1,3]);let a=new Zr(r,5,1),l=new Zr(r.slice(5),5,1);o.setAttribute("from",new Ps(a,3,0)),o.setAttribute("fromMark",new Ps(a,2,3)),o.setAttribute("to",new Ps(l,3,0)),o.setAttribute("toMark",new Ps(l,2,3)),o.instanceCount=Math.max(0,s-1);let c=new Xn({vertexShader:KM,fragmentShader:jM,transparent:!0,depthWrite:!1,uniforms:{screen:{value:new ot(1,1)},width:{value:t.width},lift:{value:4e-4},scale:{value:n.map(u=>new Ye(u))},span:{value:new ot(e.times[0]??0,Math.max(e.times[s-1]??1,(e.times[0]??0)+1e-12))},now:{value:new ot(1/0,0)},tail:{value:t.tail},before:{value:t.before},after:{value:t.after}}});this.mesh=new yt(o,c),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}at(e){let{times:t,lengths:n}=this.curve,s=0,r=t.length-1;for(;r-s>1;){let o=s+r>>1;(t[o]??0)<=e?s=o:r=o}this.uniform("now").set(e,n[e>=(t[r]??0)?r:s]??0)}resize(e,t){this.uniform("screen").set(e,t)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}uniform(e){return this.mesh.material.uniforms[e]?.value}};function Yh(i,e,t=32,n=64){let s=[],r=[],o=[];for(let a=0;a<=t;a++){let l=Math.PI*a/t;for(let c=0;c<n;c++){let u=2*Math.PI*c/n,h=[Math.sin(l)*Math.cos(u),Math.sin(l)*Math.sin(u),Math.cos(l)],d=h.map((m,p)=>m/(i[p]??1)),f=Math.hypot(...d);if(s.push(...Sr(e,h.map((m,p)=>m*(i[p]??1)))),r.push(...Sr(e,d.map(m=>m/f))),a===t)continue;let[g,M]=[a*n+c,a*n+(c+1)%n];o.push(g,g+n,M+n,g,M+n,M)}}return{positions:Float32Array.from(s),normals:Float32Array.from(r),indices:Uint32Array.from(o),hollow:!1}}var QM=6.3,eS=.9,zc=class{constructor(e,t,n,s,r){this.canvas=e;this.scene=t;this.surface=n;this.motion=s;this.shown=r;this.size=t.size>0?t.size:1,this.renderer=new Dc({canvas:e,antialias:!0,alpha:!0,powerPreference:"high-performance"}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Ks,this.camera.up.set(0,0,1),this.metres.scale.setScalar(1/this.size),this.world.add(this.metres,this.lamp,this.lamp.target),this.metres.add(this.bodyFrame),this.view=Tu(t,s,this.size),this.lamp.castShadow=!0,this.lamp.shadow.mapSize.set(1024,1024),this.lamp.shadow.radius=5,this.lamp.shadow.bias=-2e-4,this.lamp.shadow.normalBias=.01;let o=1.6;Object.assign(this.lamp.shadow.camera,{left:-o,right:o,top:o,bottom:-o,near:.5,far:14}),this.build()}canvas;scene;surface;motion;shown;view;size;renderer;camera=new zn(Va*180/Math.PI,1,.05,500);world=new zo;metres=new cn;lamp=new Qo(16777215,2.1);bodyFrame=new cn;colours=Tn();body=null;ground=null;linkage=null;path=null;trace=null;arrows=new Map;inertia=null;centreMark=null;reach=4;width=1;height=1;setMotion(e,t){this.motion=e,this.surface=t,this.build()}get spacing(){return this.ground?.spacing??0}recolour(){this.colours=Tn(),this.build()}reset(){this.view=Tu(this.scene,this.motion,this.size,this.width/this.height)}zoom(e){this.view=To(this.view,e)}vectorScale(e){return this.arrows.get(e)?.scale??0}resize(e,t,n=Math.min(window.devicePixelRatio||1,2)){if(e<1||t<1)return;let s=this.width===1;this.width=e,this.height=t,this.renderer.setPixelRatio(n),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.path?.resize(e,t),this.trace?.resize(e,t),s&&this.reset()}draw(e){let t=wo(this.motion,e);this.place(t),this.shown.follow&&this.follow(t);let n=new q(...this.view.target);this.camera.position.set(...Sf(this.view)),this.camera.near=Math.max(.02,this.view.distance/60),this.camera.far=this.view.distance+6*this.reach+60,this.camera.updateProjectionMatrix(),this.camera.lookAt(n);let s=this.view.target.map(a=>a*this.size),r=Math.min(Math.max(this.reach,2),.62*this.view.distance);this.ground?.around(s,r*this.size);let o=new q(...t.centre).divideScalar(this.size);this.linkage!==null&&o.set(s[0],s[1],0).divideScalar(this.size),this.lamp.target.position.copy(o),this.lamp.position.copy(o).add(this.lampDirection().multiplyScalar(6)),this.renderer.render(this.world,this.camera)}async picture(e,t,n,s){let[r,o]=[this.width,this.height];this.resize(t,n,s),this.draw(e);let a=document.createElement("canvas");a.width=this.canvas.width,a.height=this.canvas.height;let l=a.getContext("2d");return l!==null&&(l.fillStyle=this.colours.paper,l.fillRect(0,0,a.width,a.height),l.drawImage(this.canvas,0,0)),this.resize(r,o),this.draw(e),a}dispose(){this.clear(),this.renderer.dispose()}lampDirection(){let{azimuth:e}=this.view,t=new q(-Math.sin(e),Math.cos(e),0),n=new q(Math.cos(e),Math.sin(e),0);return t.multiplyScalar(-.35).addScaledVector(n,.2).add(new q(0,0,1)).normalize()}follow(e){let{path:t}=this.scene,n=t===null?e.centre:jn(this.motion,t,2,e.t)??[0,0],[s=0,r=0,o=0]=n;this.view={...this.view,target:[s/this.size,r/this.size,o/this.size]}}clear(){this.body?.dispose(),this.path?.dispose(),this.trace?.dispose();for(let{arrow:e}of this.arrows.values())e.dispose();this.arrows.clear(),this.bodyFrame.clear(),this.metres.clear(),this.metres.add(this.bodyFrame);for(let e of this.world.children.filter(t=>t instanceof Yr))this.world.remove(e);this.body=this.ground=this.linkage=this.path=this.trace=this.inertia=this.centreMark=null}build(){this.clear();let{scene:e,colours:t,motion:n}=this;this.world.add(new Yr(16777215,t.dark?8226964:12174027,1.5)),this.buildBody();let s=this.curveOf("contact");this.buildGround(s.points),e.links.length>0&&(this.linkage=new kc(e.links,.2*this.size,t),this.metres.add(this.linkage.group)),this.path=new ma(e.path!==null?this.planPath():s,{width:3,before:1,after:.16,tail:1/0},t.time),this.metres.add(this.path.mesh),this.body!==null&&n.columns.contact&&n.columns.attitude&&(this.trace=new ma(this.traceOnBody(),{width:2.2,before:1,after:0,tail:QM*this.size},t.time),this.bodyFrame.add(this.trace.mesh));for(let[r,o]of e.vectors.entries()){let a=tS(n,o.column);if(!(a>0))continue;let l=new Bc(t.components[r%3]??t.ink);this.arrows.set(o.name,{arrow:l,scale:a}),this.metres.add(l.group)}this.path.resize(this.width,this.height),this.trace?.resize(this.width,this.height)}buildBody(){let{scene:e,colours:t}=this,n=e.inertia_axes,s=this.surface;if(!(this.motion.columns.attitude!==void 0))return;let o=n?.5*this.size/Math.max(...n):0,a=n?.map(c=>c*o),l=s??(a?Yh(a,e.inertia_turn):null);if(l!==null&&(this.body=new pa(l,t),this.bodyFrame.add(this.body.group)),a&&s!==null){let c=a.map(h=>.8*h),u=new pa(Yh(c,e.inertia_turn),{...t,body:["#efd9a4","#c77d4f"]});this.inertia=new yt,this.inertia.add(u.group),this.bodyFrame.add(this.inertia)}this.centreMark=new yt(new us(.028*this.size,24,16),new Is({color:t.alarm,depthTest:!1,transparent:!0})),this.centreMark.renderOrder=11,this.bodyFrame.add(this.centreMark)}buildGround(e){let{scene:t,colours:n,size:s}=this;this.reach=Ef(t.path!==null?this.planPath().points:e,s);let r=t.support??(t.path===null?null:{kind:"plane"});if(!(r===null||r.kind==="point")){if(r.kind==="plane")this.ground=ym(Na(Math.max(.5,this.reach/16)*s),n);else if(r.kind==="sphere"){let o=Math.hypot(e[0]??NaN,e[1]??NaN,e[2]??NaN)||Math.abs(r.radius),a=r.inside?.3:Math.max(.12,.75*s/o),c=this.surface?.hollow===!0?Math.PI:Ao(e,r.inside?-1:1,a,r.inside?1.75:1.2);this.ground=bm(o,r.inside,c,n)}else{let o=qs(r.positions),a={positions:o,normals:qs(r.normals),indices:df(r.indices)};this.ground=Mm(a,nS(o),n)}this.metres.add(this.ground.group)}}curveOf(e){let t=this.motion.columns[e]?e:"centre",n=Xs(this.motion,t,3),s=Math.max(1,Math.min(6,Math.ceil(2400/Math.max(1,n))));return Oc(this.motion.times,this.motion.columns[t]??new Float64Array(0),n,s)}planPath(){let e=Cu(this.scene,this.motion);return Oc(this.motion.times,e,e.length/3,4)}traceOnBody(){let{motion:e}=this,t=Math.min(Xs(e,"contact",3),Xs(e,"attitude",4)),n=new Float64Array(3*t);for(let s=0;s<t;s++){let r=e.times[s]??0,{attitude:o,centre:a,contact:l}=wo(e,r),c=l.map((u,h)=>u-(a[h]??0));n.set(sf(o,c),3*s)}return Oc(e.times,n,t,Math.max(1,Math.min(6,Math.ceil(2400/Math.max(1,t)))))}place(e){let{shown:t}=this,[n,s,r,o]=e.attitude;this.bodyFrame.position.set(...e.centre),this.bodyFrame.quaternion.set(s,r,o,n),this.body!==null&&(this.body.glass=t.inertia&&this.inertia!==null||t.centre),this.inertia!==null&&(this.inertia.visible=t.inertia),this.centreMark!==null&&(this.centreMark.visible=t.centre),this.linkage?.at(this.motion,e.t);for(let[a,l]of[[this.path,t.trace],[this.trace,t.traceOnBody]])a!==null&&(a.mesh.visible=l,a.at(e.t));for(let a of this.scene.vectors){let l=this.arrows.get(a.name);if(l===void 0)continue;let c=jn(this.motion,a.column,3,e.t);if(l.arrow.group.visible=t.vectors.has(a.name)&&c!==null,!l.arrow.group.visible||c===null)continue;let u=a.axes==="body"?Sr(e.attitude,c):c,h=eS*this.size/l.scale;l.arrow.thickness=.0026*this.view.distance*this.size;let d=a.at==="contact"?e.contact:e.centre;l.arrow.set(new q(...d),new q(...u).multiplyScalar(h))}}};function tS(i,e){let t=i.columns[e];if(t===void 0)return 0;let n=0;for(let s=0;s+2<t.length;s+=3){let r=Math.hypot(t[s]??0,t[s+1]??0,t[s+2]??0);r>n&&(n=r)}return n}function nS(i){let[e,t]=[1/0,-1/0];for(let r=0;r<i.length;r++)e=Math.min(e,i[r]??e),t=Math.max(t,i[r]??t);let n=(t-e)/12,s=10**Math.floor(Math.log10(n));return([1,2,5,10].find(r=>r*s>=n*(1-1e-9))??10)*s}function Am(i){let{scene:e}=i.model,t=i.shown.value;if(!iS(i))return null;let n=he("canvas",{class:"lab-canvas","aria-hidden":!0}),s=he("div",{class:"lab-legend"}),r=he("div",{class:"lab-note"}),o=he("div",{class:"lab-timebar","aria-hidden":!0}),a=he("div",{class:"lab-scene",tabindex:0,role:"application","aria-label":`${i.model.title}: the motion in space. Arrow keys turn the view, plus and minus zoom, space plays, question mark lists all keys.`},n,s,o,r),l={trace:!0,traceOnBody:!0,inertia:!1,centre:!1,follow:Ru(e,t.motion),vectors:new Set(e.vectors.filter(({column:m})=>m==="omega").map(({name:m})=>m))},c;try{c=new zc(n,e,t.surface,t.motion,l)}catch{return null}let u=0,h=()=>{u===0&&(u=requestAnimationFrame(()=>{u=0,c.draw(i.clock.time.value),f()}))},d=new Map,f=()=>{let{motion:m}=i.shown.value;for(let p of e.vectors){let v=jn(m,p.column,3,i.clock.time.value),T=d.get(p.name);T&&v&&(T.textContent=`${Kt(Math.hypot(...v),3)} ${vi(p.unit)}`)}},g=()=>{d.clear();let m=Tn();s.replaceChildren(...e.vectors.flatMap((v,T)=>{if(!l.vectors.has(v.name))return[];let b=he("span",{class:"lab-number"});d.set(v.name,b);let C=he("span",{class:"lab-arrow",style:`background:${m.components[T%3]??""}`});return[he("div",{},C,Em(v),b)]}));let p=i.clock.until;o.replaceChildren(he("span",{},"t = 0"),he("i",{style:`background:linear-gradient(90deg,${m.time.join(",")})`}),he("span",{},`${Kt(p)} s`)),r.textContent=c.spacing>0?`grid ${Kt(c.spacing)} m`:""},M=sS(i,c,l,()=>{g(),h()});return Tf(a,c,m=>{m&&M.dispatchEvent(new CustomEvent("unfollow")),h()}),rS(a,i,c,M,h),new ResizeObserver(()=>{c.resize(a.clientWidth,a.clientHeight),c.draw(i.clock.time.value)}).observe(a),i.clock.time.after(h),i.shown.after(({motion:m,surface:p})=>{c.setMotion(m,p),g(),h()}),Ar(()=>{c.recolour(),g(),h()}),g(),h(),{element:a,stage:c,switches:M,refresh:h}}function iS(i){let{columns:e}=i.shown.value.motion;return e.attitude!==void 0||i.model.scene.path!==null||e.contact!==void 0}function Em(i){return i.mathml?Qi(i.mathml):document.createTextNode(i.name)}function sS(i,e,t,n){let{scene:s}=i.model,r=he("div",{class:"lab-switches",role:"toolbar","aria-label":"What is shown"}),o=(c,u,h,d,f)=>{let g=Hs(c,`${u} (${h})`,d,M=>{f(M),n()});return g.dataset.key=h,r.append(g),g},a=o("follow","Keep the body in the middle","f",t.follow,c=>t.follow=c);r.addEventListener("unfollow",()=>{t.follow=!1,a.setAttribute("aria-pressed","false")}),o("path","Path on the ground","p",t.trace,c=>t.trace=c),s.path===null&&o("trace","Trace of the contact on the body","t",t.traceOnBody,c=>t.traceOnBody=c),s.vectors.forEach((c,u)=>{if(e.vectorScale(c.name)===0)return;let h=t.vectors.has(c.name);o(Em(c),`Vector ${c.name}`,String(u+1),h,d=>{let f=new Set(t.vectors);d?f.add(c.name):f.delete(c.name),t.vectors=f})}),s.inertia_axes!==null&&s.body!==null&&o("inertia","Inertia ellipsoid","i",t.inertia,c=>t.inertia=c),s.path===null&&o("centre","Centre of mass","c",t.centre,c=>t.centre=c);let l=he("button",{type:"button",title:"Whole view (r)","data-key":"r"},"whole view");return l.addEventListener("click",()=>{e.reset(),n()}),r.append(l),r}var Tm=[["space","play or pause"],["← →, ↑ ↓","turn the view"],[", .","one sample back, on"],["Home, End","to the start, to the end"],["[ ]","slower, faster"],["+ −","nearer, farther"],["f","keep the body in the middle"],["p, t","path on the ground, trace on the body"],["1 2 3","vectors"],["i, c","inertia ellipsoid, centre of mass"],["r","whole view"],["Ctrl+Z, Ctrl+Shift+Z","undo, redo"]];function rS(i,e,t,n,s){let{clock:r}=e,o=(u,h)=>{t.view=Ga(t.view,u,h),s()},a=u=>{t.zoom(u),s()},l=u=>{let{times:h}=e.shown.value.motion;r.pause(),r.seek(r.time.value+u*((h[1]??0)-(h[0]??0)))},c={" ":()=>r.toggle(),ArrowLeft:()=>o(-.04,0),ArrowRight:()=>o(.04,0),ArrowUp:()=>o(0,-.04),ArrowDown:()=>o(0,.04),",":()=>l(-1),".":()=>l(1),Home:()=>r.seek(0),End:()=>r.seek(r.until),"[":()=>r.changeSpeed(-1),"]":()=>r.changeSpeed(1),"+":()=>a(1/1.15),"=":()=>a(1/1.15),"-":()=>a(1.15)};i.addEventListener("keydown",u=>{if(u.ctrlKey||u.metaKey||u.altKey)return;let h=c[u.key],d=n.querySelector(`[data-key="${CSS.escape(u.key.toLowerCase())}"]`);h===void 0&&d===null||(u.preventDefault(),h!==void 0?h():d?.click())})}function Rm(){let i=Tm.map(([e,t])=>he("tr",{},he("th",{scope:"row"},he("kbd",{},e)),he("td",{},t)));return he("div",{},he("p",{class:"lab-hint"},"Keys act while the scene, a section or a chart has the focus: click into it, or go there with Tab. With the pointer: drag turns, Shift and drag moves, the wheel zooms; with two fingers as usual."),he("table",{class:"lab-keys"},...i))}function Cm(i){let e=()=>{let t=i.clock.time.value,n=t>0?{t:String(Number(t.toPrecision(6)))}:{};return location.href.split("#")[0]+vu(i.shown.value.experiment,i.model,n)};return i.shown.after(({experiment:t})=>{let n=vu(t,i.model,{});try{history.replaceState(null,"",n===""?location.pathname+location.search:n)}catch{}}),e}var Pm=0;function $h(i,e,t=()=>{}){Pm+=1;let n=he("div",{role:"tablist","aria-label":i,class:"lab-tabs"}),s=[],r=e.map(({name:a,title:l,content:c})=>{let u=`lab-${Pm}-${a}`,h=he("button",{type:"button",role:"tab",id:`${u}-tab`,"aria-controls":u},l),d=he("div",{role:"tabpanel",id:u,"aria-labelledby":`${u}-tab`,class:`lab-panel lab-panel-${a}`},c);return n.append(h),s.push(d),h}),o=(a,l)=>{r.forEach((u,h)=>{let d=h===a;u.setAttribute("aria-selected",String(d)),u.tabIndex=d?0:-1;let f=s[h];f&&(f.hidden=!d)}),l&&r[a]?.focus();let c=e[a];c!==void 0&&(c.shown?.(),t(c.name))};return r.forEach((a,l)=>a.addEventListener("click",()=>o(l,!1))),n.addEventListener("keydown",a=>{let l=r.findIndex(h=>h===document.activeElement),u={ArrowRight:l+1,ArrowLeft:l-1,Home:0,End:r.length-1}[a.key];u!==void 0&&(a.preventDefault(),o((u+r.length)%r.length,!0))}),o(0,!1),{element:he("section",{class:"lab-deck","aria-label":i},n,...s),select:a=>{let l=e.findIndex(c=>c.name===a);l>=0&&o(l,!1)}}}var oS="uplot",aS="u-hz",lS="u-vt",cS="u-title",uS="u-wrap",hS="u-under",dS="u-over",fS="u-axis",or="u-off",pS="u-select",mS="u-cursor-x",gS="u-cursor-y",xS="u-cursor-pt",_S="u-legend",vS="u-live",yS="u-inline",bS="u-series",MS="u-marker",Im="u-label",SS="u-value",xa="width",_a="height";var Lm="bottom",no="left",Zh="right",dd="#000",Nm=dd+"0",Jh="mousemove",Dm="mousedown",Kh="mouseup",Fm="mouseenter",Um="mouseleave",Om="dblclick",wS="resize",AS="scroll",Bm="change",Xc="dppxchange",fd="--",co=typeof window<"u",nd=co?document:null,so=co?window:null,ES=co?navigator:null,St,Vc;function id(){let i=devicePixelRatio;St!=i&&(St=i,Vc&&rd(Bm,Vc,id),Vc=matchMedia(`(min-resolution: ${St-.001}dppx) and (max-resolution: ${St+.001}dppx)`),ar(Bm,Vc,id),so.dispatchEvent(new CustomEvent(Xc)))}function si(i,e){if(e!=null){let t=i.classList;!t.contains(e)&&t.add(e)}}function sd(i,e){let t=i.classList;t.contains(e)&&t.remove(e)}function zt(i,e,t){i.style[e]=t+"px"}function Ci(i,e,t,n){let s=nd.createElement(i);return e!=null&&si(s,e),t?.insertBefore(s,n),s}function pi(i,e){return Ci("div",i,e)}var km=new WeakMap;function Yi(i,e,t,n,s){let r="translate("+e+"px,"+t+"px)",o=km.get(i);r!=o&&(i.style.transform=r,km.set(i,r),e<0||t<0||e>n||t>s?si(i,or):sd(i,or))}var zm=new WeakMap;function Vm(i,e,t){let n=e+t,s=zm.get(i);n!=s&&(zm.set(i,n),i.style.background=e,i.style.borderColor=t)}var Gm=new WeakMap;function Hm(i,e,t,n){let s=e+""+t,r=Gm.get(i);s!=r&&(Gm.set(i,s),i.style.height=t+"px",i.style.width=e+"px",i.style.marginLeft=n?-e/2+"px":0,i.style.marginTop=n?-t/2+"px":0)}var pd={passive:!0},TS={...pd,capture:!0};function ar(i,e,t,n){e.addEventListener(i,t,n?TS:pd)}function rd(i,e,t,n){e.removeEventListener(i,t,pd)}co&&id();function Pi(i,e,t,n){let s;t=t||0,n=n||e.length-1;let r=n<=2147483647;for(;n-t>1;)s=r?t+n>>1:ri((t+n)/2),e[s]<i?t=s:n=s;return i-e[t]<=e[n]-i?t:n}function xg(i){return(t,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(t[a])){r=a;break}for(let a=s;a>=n;a--)if(i(t[a])){o=a;break}return[r,o]}}var _g=i=>i!=null,vg=i=>i!=null&&i>0,$c=xg(_g),RS=xg(vg);function CS(i,e,t,n=0,s=!1){let r=s?RS:$c,o=s?vg:_g;[e,t]=r(i,e,t);let a=i[e],l=i[e];if(e>-1)if(n==1)a=i[e],l=i[t];else if(n==-1)a=i[t],l=i[e];else for(let c=e;c<=t;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Lt,l??-Lt]}function Zc(i,e,t,n){let s=qm(i),r=qm(e);i==e&&(s==-1?(i*=t,e/=t):(i/=t,e*=t));let o=t==10?ms:yg,a=s==1?ri:mi,l=r==1?mi:ri,c=a(o(_n(i))),u=l(o(_n(e))),h=ro(t,c),d=ro(t,u);return t==10&&(c<0&&(h=Nt(h,-c)),u<0&&(d=Nt(d,-u))),n||t==2?(i=h*s,e=d*r):(i=wg(i,h),e=Jc(e,d)),[i,e]}function md(i,e,t,n){let s=Zc(i,e,t,n);return i==0&&(s[0]=0),e==0&&(s[1]=0),s}var gd=.1,Wm={mode:3,pad:gd},ya={pad:0,soft:null,mode:0},PS={min:ya,max:ya};function qc(i,e,t,n){return Kc(t)?Xm(i,e,t):(ya.pad=t,ya.soft=n?0:null,ya.mode=n?3:0,Xm(i,e,PS))}function bt(i,e){return i??e}function IS(i,e,t){for(e=bt(e,0),t=bt(t,i.length-1);e<=t;){if(i[e]!=null)return!0;e++}return!1}function Xm(i,e,t){let n=t.min,s=t.max,r=bt(n.pad,0),o=bt(s.pad,0),a=bt(n.hard,-Lt),l=bt(s.hard,Lt),c=bt(n.soft,Lt),u=bt(s.soft,-Lt),h=bt(n.mode,0),d=bt(s.mode,0),f=e-i,g=ms(f),M=Hn(_n(i),_n(e)),m=ms(M),p=_n(m-g);(f<1e-24||p>10)&&(f=0,(i==0||e==0)&&(f=1e-24,h==2&&c!=Lt&&(r=0),d==2&&u!=-Lt&&(o=0)));let v=f||M||1e3,T=ms(v),b=ro(10,ri(T)),C=v*(f==0?i==0?.1:1:r),E=Nt(wg(i-C,b/10),24),_=i>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Lt,A=Hn(a,E<_&&i>=_?_:Ii(_,E)),B=v*(f==0?e==0?.1:1:o),D=Nt(Jc(e+B,b/10),24),N=e<=u&&(d==1||d==3&&D>=u||d==2&&D<=u)?u:-Lt,k=Ii(l,D>N&&e<=N?N:Hn(N,D));return A==k&&A==0&&(k=100),[A,k]}var LS=new Intl.NumberFormat(co?ES.language:"en-US"),xd=i=>LS.format(i),oi=Math,Wc=oi.PI,_n=oi.abs,ri=oi.floor,xn=oi.round,mi=oi.ceil,Ii=oi.min,Hn=oi.max,ro=oi.pow,qm=oi.sign,ms=oi.log10,yg=oi.log2,NS=(i,e=1)=>oi.sinh(i)*e,jh=(i,e=1)=>oi.asinh(i/e),Lt=1/0;function Ym(i){return(ms((i^i>>31)-(i>>31))|0)+1}function od(i,e,t){return Ii(Hn(i,e),t)}function bg(i){return typeof i=="function"}function gt(i){return bg(i)?i:()=>i}var DS=()=>{},Mg=i=>i,Sg=(i,e)=>e,FS=i=>null,$m=i=>!0,Zm=(i,e)=>i==e,US=/\.\d*?(?=9{6,}|0{6,})/gm,lr=i=>{if(Eg(i)||ks.has(i))return i;let e=`${i}`,t=e.match(US);if(t==null)return i;let n=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${lr(s)}e${r}`}return Nt(i,n)};function sr(i,e){return lr(Nt(lr(i/e))*e)}function Jc(i,e){return lr(mi(lr(i/e))*e)}function wg(i,e){return lr(ri(lr(i/e))*e)}function Nt(i,e=0){if(Eg(i))return i;let t=10**e,n=i*t*(1+Number.EPSILON);return xn(n)/t}var ks=new Map;function Ag(i){return((""+i).split(".")[1]||"").length}function Ma(i,e,t,n){let s=[],r=n.map(Ag);for(let o=e;o<t;o++){let a=_n(o),l=Nt(ro(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),d=i==10?u:Nt(u,h);s.push(d),ks.set(d,h)}}return s}var ba={},_d=[],oo=[null,null],Bs=Array.isArray,Eg=Number.isInteger,OS=i=>i===void 0;function Jm(i){return typeof i=="string"}function Kc(i){let e=!1;if(i!=null){let t=i.constructor;e=t==null||t==Object}return e}function BS(i){return i!=null&&typeof i=="object"}var kS=Object.getPrototypeOf(Uint8Array),Tg="__proto__";function ao(i,e=Kc){let t;if(Bs(i)){let n=i.find(s=>s!=null);if(Bs(n)||e(n)){t=Array(i.length);for(let s=0;s<i.length;s++)t[s]=ao(i[s],e)}else t=i.slice()}else if(i instanceof kS)t=i.slice();else if(e(i)){t={};for(let n in i)n!=Tg&&(t[n]=ao(i[n],e))}else t=i;return t}function hn(i){let e=arguments;for(let t=1;t<e.length;t++){let n=e[t];for(let s in n)s!=Tg&&(Kc(i[s])?hn(i[s],ao(n[s])):i[s]=ao(n[s]))}return i}var zS=0,VS=1,GS=2;function HS(i,e,t){for(let n=0,s,r=-1;n<e.length;n++){let o=e[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<t&&i[s]==null;)i[r=s++]=null}}}function WS(i,e){if(YS(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return $S(o[0])||(o=qS(o)),o}let t=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let n=[Array.from(t).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),d=e?e[o][c]:VS,f=[];for(let g=0;g<u.length;g++){let M=u[g],m=r.get(l[g]);M===null?d!=zS&&(h[m]=M,d==GS&&f.push(m)):h[m]=M}HS(h,f,s),n.push(h)}}return n}var XS=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function qS(i){let e=i[0],t=e.length,n=Array(t);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[n[l]];s.push(a)}return s}function YS(i){let e=i[0][0],t=e.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function $S(i,e=100){let t=i.length;if(t<=1)return!0;let n=0,s=t-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;let r=Hn(1,ri((s-n+1)/e));for(let o=i[n],a=n+r;a<=s;a+=r){let l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Rg=["January","February","March","April","May","June","July","August","September","October","November","December"],Cg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Pg(i){return i.slice(0,3)}var ZS=Cg.map(Pg),JS=Rg.map(Pg),KS={MMMM:Rg,MMM:JS,WWWW:Cg,WWW:ZS};function ga(i){return(i<10?"0":"")+i}function jS(i){return(i<10?"00":i<100?"0":"")+i}var QS={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,e)=>e.MMMM[i.getMonth()],MMM:(i,e)=>e.MMM[i.getMonth()],MM:i=>ga(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>ga(i.getDate()),D:i=>i.getDate(),WWWW:(i,e)=>e.WWWW[i.getDay()],WWW:(i,e)=>e.WWW[i.getDay()],HH:i=>ga(i.getHours()),H:i=>i.getHours(),h:i=>{let e=i.getHours();return e==0?12:e>12?e-12:e},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>ga(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>ga(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>jS(i.getMilliseconds())};function vd(i,e){e=e||KS;let t=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)t.push(s[0][0]=="{"?QS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var ew=new Intl.DateTimeFormat().resolvedOptions().timeZone;function tw(i,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+i+i.getTimezoneOffset()*6e4):e==ew?t=i:(t=new Date(i.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(i.getMilliseconds())),t}var Ig=i=>i%1==0,Yc=[1,2,2.5,5],nw=Ma(10,-32,0,Yc),Lg=Ma(10,0,32,Yc),iw=Lg.filter(Ig),rr=nw.concat(Lg),yd=`
`,Ng="{YYYY}",Km=yd+Ng,Dg="{M}/{D}",va=yd+Dg,Gc=va+"/{YY}",Fg="{aa}",sw="{h}:{mm}",io=sw+Fg,jm=yd+io,Qm=":{ss}",At=null;function Ug(i){let e=i*1e3,t=e*60,n=t*60,s=n*24,r=s*30,o=s*365,l=(i==1?Ma(10,0,3,Yc).filter(Ig):Ma(10,-3,0,Yc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Ng,At,At,At,At,At,At,1],[s*28,"{MMM}",Km,At,At,At,At,At,1],[s,Dg,Km,At,At,At,At,At,1],[n,"{h}"+Fg,Gc,At,va,At,At,At,1],[t,io,Gc,At,va,At,At,At,1],[e,Qm,Gc+" "+io,At,va+" "+io,At,jm,At,1],[i,Qm+".{fff}",Gc+" "+io,At,va+" "+io,At,jm,At,1]];function u(h){return(d,f,g,M,m,p)=>{let v=[],T=m>=o,b=m>=r&&m<o,C=h(g),E=Nt(C*i,3),_=Qh(C.getFullYear(),T?0:C.getMonth(),b||T?1:C.getDate()),A=Nt(_*i,3);if(b||T){let B=b?m/r:0,D=T?m/o:0,N=E==A?E:Nt(Qh(_.getFullYear()+D,_.getMonth()+B,1)*i,3),k=new Date(xn(N/i)),G=k.getFullYear(),L=k.getMonth();for(let H=0;N<=M;H++){let Y=Qh(G+D*H,L+B*H,1),V=Y-h(Nt(Y*i,3));N=Nt((+Y+V)*i,3),N<=M&&v.push(N)}}else{let B=m>=s?s:m,D=ri(g)-ri(E),N=A+D+Jc(E-A,B);v.push(N);let k=h(N),G=k.getHours()+k.getMinutes()/t+k.getSeconds()/n,L=m/n,H=d.axes[f]._space,Y=p/H;for(;N=Nt(N+m,i==1?0:3),!(N>M);)if(L>1){let V=ri(Nt(G+L,6))%24,j=h(N).getHours()-V;j>1&&(j=-1),N-=j*n,G=(G+L)%24;let ie=v[v.length-1];Nt((N-ie)/m,3)*Y>=.7&&v.push(N)}else v.push(N)}return v}}return[l,c,u]}var[rw,ow,aw]=Ug(1),[lw,cw,uw]=Ug(.001);Ma(2,-53,53,[1]);function eg(i,e){return i.map(t=>t.map((n,s)=>s==0||s==8||n==null?n:e(s==1||t[8]==0?n:t[1]+n)))}function tg(i,e){return(t,n,s,r,o)=>{let a=e.find(g=>o>=g[0])||e[e.length-1],l,c,u,h,d,f;return n.map(g=>{let M=i(g),m=M.getFullYear(),p=M.getMonth(),v=M.getDate(),T=M.getHours(),b=M.getMinutes(),C=M.getSeconds(),E=m!=l&&a[2]||p!=c&&a[3]||v!=u&&a[4]||T!=h&&a[5]||b!=d&&a[6]||C!=f&&a[7]||a[1];return l=m,c=p,u=v,h=T,d=b,f=C,E(M)})}}function hw(i,e){let t=vd(e);return(n,s,r,o,a)=>s.map(l=>t(i(l)))}function Qh(i,e,t){return new Date(i,e,t)}function ng(i,e){return e(i)}var dw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ig(i,e){return(t,n,s,r)=>r==null?fd:e(i(n))}function fw(i,e){let t=i.series[e];return t.width?t.stroke(i,e):t.points.width?t.points.stroke(i,e):null}function pw(i,e){return i.series[e].fill(i,e)}var mw={show:!0,live:!0,isolate:!1,mount:DS,markers:{show:!0,width:2,stroke:fw,fill:pw,dash:"solid"},idx:null,idxs:null,values:[]};function gw(i,e){let t=i.cursor.points,n=pi(),s=t.size(i,e);zt(n,xa,s),zt(n,_a,s);let r=s/-2;zt(n,"marginLeft",r),zt(n,"marginTop",r);let o=t.width(i,e,s);return o&&zt(n,"borderWidth",o),n}function xw(i,e){let t=i.series[e].points;return t._fill||t._stroke}function _w(i,e){let t=i.series[e].points;return t._stroke||t._fill}function vw(i,e){return i.series[e].points.size}var ed=[0,0];function yw(i,e,t){return ed[0]=e,ed[1]=t,ed}function Hc(i,e,t,n=!0){return s=>{s.button==0&&(!n||s.target==e)&&t(s)}}function td(i,e,t,n=!0){return s=>{(!n||s.target==e)&&t(s)}}var bw={show:!0,x:!0,y:!0,lock:!1,move:yw,points:{one:!1,show:gw,size:vw,width:0,stroke:_w,fill:xw},bind:{mousedown:Hc,mouseup:Hc,click:Hc,dblclick:Hc,mousemove:td,mouseleave:td,mouseenter:td},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,e,t,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Og={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},bd=hn({},Og,{filter:Sg}),Bg=hn({},bd,{size:10}),kg=hn({},Og,{show:!1}),Md='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',zg="bold "+Md,Vg=1.5,sg={show:!0,scale:"x",stroke:dd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zg,side:2,grid:bd,ticks:Bg,border:kg,font:Md,lineGap:Vg,rotate:0},Mw="Value",Sw="Time",rg={show:!0,scale:"x",auto:!1,sorted:1,min:Lt,max:-Lt,idxs:[]};function ww(i,e,t,n,s){return e.map(r=>r==null?"":xd(r))}function Aw(i,e,t,n,s,r,o){let a=[],l=ks.get(s)||0;t=o?t:Nt(Jc(t,s),l);for(let c=t;c<=n;c=Nt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function ad(i,e,t,n,s,r,o){let a=[],l=i.scales[i.axes[e].scale].log,c=l==10?ms:yg,u=ri(c(t));s=ro(l,u),l==10&&(s=rr[Pi(s,rr)]);let h=t,d=s*l;l==10&&(d=rr[Pi(d,rr)]);do a.push(h),h=h+s,l==10&&!ks.has(h)&&(h=Nt(h,ks.get(s))),h>=d&&(s=h,d=s*l,l==10&&(d=rr[Pi(d,rr)]));while(h<=n);return a}function Ew(i,e,t,n,s,r,o){let l=i.scales[i.axes[e].scale].asinh,c=n>l?ad(i,e,Hn(l,t),n,s):[l],u=n>=0&&t<=0?[0]:[];return(t<-l?ad(i,e,Hn(l,-n),-t,s):[l]).reverse().map(d=>-d).concat(u,c)}var Gg=/./,Tw=/[12357]/,Rw=/[125]/,og=/1/,ld=(i,e,t,n)=>i.map((s,r)=>e==4&&s==0||r%n==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Cw(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Gg:l(7,o)-u>=c?Tw:l(5,o)-u>=c?Rw:og;if(h==og){let d=_n(l(1,o)-u);if(d<c)return ld(e.slice().reverse(),a.distr,h,mi(c/d)).reverse()}return ld(e,a.distr,h,1)}function Pw(i,e,t,n,s){let r=i.axes[t],o=r.scale,a=r._space,l=i.valToPos,c=_n(l(1,o)-l(2,o));return c<a?ld(e.slice().reverse(),3,Gg,mi(a/c)).reverse():e}function Iw(i,e,t,n){return n==null?fd:e==null?"":xd(e)}var ag={show:!0,scale:"y",stroke:dd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zg,side:3,grid:bd,ticks:Bg,border:kg,font:Md,lineGap:Vg,rotate:0};function Lw(i,e){let t=3+(i||1)*2;return Nt(t*e,3)}function Nw(i,e){let{scale:t,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],t,!0),o=i.valToPos(s[n[1]],t,!0),a=_n(o-r),l=i.series[e],c=a/(l.points.space*St);return n[1]-n[0]<=c}var lg={scale:null,auto:!0,sorted:0,min:Lt,max:-Lt},Hg=(i,e,t,n,s)=>s,cg={show:!0,auto:!0,sorted:0,gaps:Hg,alpha:1,facets:[hn({},lg,{scale:"x"}),hn({},lg,{scale:"y"})]},ug={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Hg,alpha:1,points:{show:Nw,filter:null},values:null,min:Lt,max:-Lt,idxs:[],path:null,clip:null};function Dw(i,e,t,n,s){return t/10}var Wg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Fw=hn({},Wg,{time:!1,ori:1}),hg={};function Xg(i,e){let t=hg[i];return t||(t={key:i,plots:[],sub(n){t.plots.push(n)},unsub(n){t.plots=t.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(hg[i]=t)),t}var lo=1,cd=2;function cr(i,e,t){let n=i.mode,s=i.series[e],r=n==2?i._data[e]:i._data,o=i.scales,a=i.bbox,l=r[0],c=n==2?r[1]:r[e],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],d=a.left,f=a.top,g=a.width,M=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?t(s,l,c,u,h,m,p,d,f,g,M,Qc,uo,tu,Yg,Zg):t(s,l,c,u,h,p,m,f,d,M,g,eu,ho,Ad,$g,Jg)}function Sd(i,e){let t=0,n=0,s=bt(i.bands,_d);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?n|=1:n|=2)}return[t,n==1?-1:n==2?1:n==3?2:0]}function Uw(i,e,t,n,s){let r=i.mode,o=i.series[e],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function gs(i,e,t,n,s,r){return cr(i,e,(o,a,l,c,u,h,d,f,g,M,m)=>{let p=o.pxRound,v=c.dir*(c.ori==0?1:-1),T=c.ori==0?uo:ho,b,C;v==1?(b=t,C=n):(b=n,C=t);let E=p(h(a[b],c,M,f)),_=p(d(l[b],u,m,g)),A=p(h(a[C],c,M,f)),B=p(d(r==1?u.max:u.min,u,m,g)),D=new Path2D(s);return T(D,A,B),T(D,E,B),T(D,E,_),D})}function jc(i,e,t,n,s,r){let o=null;if(i.length>0){o=new Path2D;let a=e==0?tu:Ad,l=t;for(let h=0;h<i.length;h++){let d=i[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,n,f,n+r),l=d[1]}}let c=t+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Ow(i,e,t){let n=i[i.length-1];n&&n[0]==e?n[1]=t:i.push([e,t])}function wd(i,e,t,n,s,r,o){let a=[],l=i.length;for(let c=s==1?t:n;c>=t&&c<=n;c+=s)if(e[c]===null){let h=c,d=c;if(s==1)for(;++c<=n&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=r(i[h]),g=d==h?f:r(i[d]),M=h-s;f=o<=0&&M>=0&&M<l?r(i[M]):f;let p=d+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=f&&a.push([f,g])}return a}function dg(i){return i==0?Mg:i==1?xn:e=>sr(e,i)}function qg(i){let e=i==0?Qc:eu,t=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=Ii(c,a/2,l/2),u=Ii(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Qc=(i,e,t)=>{i.moveTo(e,t)},eu=(i,e,t)=>{i.moveTo(t,e)},uo=(i,e,t)=>{i.lineTo(e,t)},ho=(i,e,t)=>{i.lineTo(t,e)},tu=qg(0),Ad=qg(1),Yg=(i,e,t,n,s,r)=>{i.arc(e,t,n,s,r)},$g=(i,e,t,n,s,r)=>{i.arc(t,e,n,s,r)},Zg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(e,t,n,s,r,o)},Jg=(i,e,t,n,s,r,o)=>{i.bezierCurveTo(t,e,s,n,o,r)};function Kg(i){return(e,t,n,s,r)=>cr(e,t,(o,a,l,c,u,h,d,f,g,M,m)=>{let{pxRound:p,points:v}=o,T,b;c.ori==0?(T=Qc,b=Yg):(T=eu,b=$g);let C=Nt(v.width*St,3),E=(v.size-v.width)/2*St,_=Nt(E*2,3),A=new Path2D,B=new Path2D,{left:D,top:N,width:k,height:G}=e.bbox;tu(B,D-_,N-_,k+_*2,G+_*2);let L=H=>{if(l[H]!=null){let Y=p(h(a[H],c,M,f)),V=p(d(l[H],u,m,g));T(A,Y+E,V),b(A,Y,V,E,0,Wc*2)}};if(r)r.forEach(L);else for(let H=n;H<=s;H++)L(H);return{stroke:C>0?A:null,fill:A,clip:B,flags:lo|cd}})}function jg(i){return(e,t,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(e,t,n),r!=s&&o!=s&&i(e,t,s),i(e,t,o))}}var Bw=jg(uo),kw=jg(ho);function Qg(i){let e=bt(i?.alignGaps,0);return(t,n,s,r)=>cr(t,n,(o,a,l,c,u,h,d,f,g,M,m)=>{[s,r]=$c(l,s,r);let p=o.pxRound,v=G=>p(h(G,c,M,f)),T=G=>p(d(G,u,m,g)),b,C;c.ori==0?(b=uo,C=Bw):(b=ho,C=kw);let E=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:lo},A=_.stroke,B=!1;if(r-s>=M*4){let G=ue=>t.posToVal(ue,c.key,!0),L=null,H=null,Y,V,le,J=v(a[E==1?s:r]),j=v(a[s]),ie=v(a[r]),de=G(E==1?j+1:ie-1);for(let ue=E==1?s:r;ue>=s&&ue<=r;ue+=E){let Q=a[ue],_e=(E==1?Q<de:Q>de)?J:v(Q),Te=l[ue];_e==J?Te!=null?(V=Te,L==null?(b(A,_e,T(V)),Y=L=H=V):V<L?L=V:V>H&&(H=V)):Te===null&&(B=!0):(L!=null&&C(A,J,T(L),T(H),T(Y),T(V)),Te!=null?(V=Te,b(A,_e,T(V)),L=H=Y=V):(L=H=null,Te===null&&(B=!0)),J=_e,de=G(J+E))}L!=null&&L!=H&&le!=J&&C(A,J,T(L),T(H),T(Y),T(V))}else for(let G=E==1?s:r;G>=s&&G<=r;G+=E){let L=l[G];L===null?B=!0:L!=null&&b(A,v(a[G]),T(L))}let[N,k]=Sd(t,n);if(o.fill!=null||N!=0){let G=_.fill=new Path2D(A),L=o.fillTo(t,n,o.min,o.max,N),H=T(L),Y=v(a[s]),V=v(a[r]);E==-1&&([V,Y]=[Y,V]),b(G,V,H),b(G,Y,H)}if(!o.spanGaps){let G=[];B&&G.push(...wd(a,l,s,r,E,v,e)),_.gaps=G=o.gaps(t,n,s,r,G),_.clip=jc(G,c.ori,f,g,M,m)}return k!=0&&(_.band=k==2?[gs(t,n,s,r,A,-1),gs(t,n,s,r,A,1)]:gs(t,n,s,r,A,k)),_})}function zw(i){let e=bt(i.align,1),t=bt(i.ascDesc,!1),n=bt(i.alignGaps,0),s=bt(i.extend,!1);return(r,o,a,l)=>cr(r,o,(c,u,h,d,f,g,M,m,p,v,T)=>{[a,l]=$c(h,a,l);let b=c.pxRound,{left:C,width:E}=r.bbox,_=j=>b(g(j,d,v,m)),A=j=>b(M(j,f,T,p)),B=d.ori==0?uo:ho,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:lo},N=D.stroke,k=d.dir*(d.ori==0?1:-1),G=A(h[k==1?a:l]),L=_(u[k==1?a:l]),H=L,Y=L;s&&e==-1&&(Y=C,B(N,Y,G)),B(N,L,G);for(let j=k==1?a:l;j>=a&&j<=l;j+=k){let ie=h[j];if(ie==null)continue;let de=_(u[j]),ue=A(ie);e==1?B(N,de,G):B(N,H,ue),B(N,de,ue),G=ue,H=de}let V=H;s&&e==1&&(V=C+E,B(N,V,G));let[le,J]=Sd(r,o);if(c.fill!=null||le!=0){let j=D.fill=new Path2D(N),ie=c.fillTo(r,o,c.min,c.max,le),de=A(ie);B(j,V,de),B(j,Y,de)}if(!c.spanGaps){let j=[];j.push(...wd(u,h,a,l,k,_,n));let ie=c.width*St/2,de=t||e==1?ie:-ie,ue=t||e==-1?-ie:ie;j.forEach(Q=>{Q[0]+=de,Q[1]+=ue}),D.gaps=j=c.gaps(r,o,a,l,j),D.clip=jc(j,d.ori,m,p,v,T)}return J!=0&&(D.band=J==2?[gs(r,o,a,l,N,-1),gs(r,o,a,l,N,1)]:gs(r,o,a,l,N,J)),D})}function fg(i,e,t,n,s,r,o=Lt){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(e[l]!==void 0){if(a!=null){let u=_n(i[l]-i[a]);u<c&&(c=u,o=_n(t(i[l],n,s,r)-t(i[a],n,s,r)))}a=l}}return o}function Vw(i){i=i||ba;let e=bt(i.size,[.6,Lt,1]),t=i.align||0,n=i.gap||0,s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=gt(s),o=1-e[0],a=bt(e[1],Lt),l=bt(e[2],1),c=bt(i.disp,ba),u=bt(i.each,f=>{}),{fill:h,stroke:d}=c;return(f,g,M,m)=>cr(f,g,(p,v,T,b,C,E,_,A,B,D,N)=>{let k=p.pxRound,G=t,L=n*St,H=a*St,Y=l*St,V,le;b.ori==0?[V,le]=r(f,g):[le,V]=r(f,g);let J=b.dir*(b.ori==0?1:-1),j=b.ori==0?tu:Ad,ie=b.ori==0?u:(Ce,qe,st,Se,It,ze,Xe)=>{u(Ce,qe,st,It,Se,Xe,ze)},de=bt(f.bands,_d).find(Ce=>Ce.series[0]==g),ue=de!=null?de.dir:0,Q=p.fillTo(f,g,p.min,p.max,ue),me=k(_(Q,C,N,B)),_e,Te,Me,He=D,it=k(p.width*St),Ve=!1,ut=null,at=null,tt=null,Vt=null;h!=null&&(it==0||d!=null)&&(Ve=!0,ut=h.values(f,g,M,m),at=new Map,new Set(ut).forEach(Ce=>{Ce!=null&&at.set(Ce,new Path2D)}),it>0&&(tt=d.values(f,g,M,m),Vt=new Map,new Set(tt).forEach(Ce=>{Ce!=null&&Vt.set(Ce,new Path2D)})));let{x0:Dt,size:tn}=c;if(Dt!=null&&tn!=null){G=1,v=Dt.values(f,g,M,m),Dt.unit==2&&(v=v.map(st=>f.posToVal(A+st*D,b.key,!0)));let Ce=tn.values(f,g,M,m);tn.unit==2?Te=Ce[0]*D:Te=E(Ce[0],b,D,A)-E(0,b,D,A),He=fg(v,T,E,b,D,A,He),Me=He-Te+L}else He=fg(v,T,E,b,D,A,He),Me=He*o+L,Te=He-Me;Me<1&&(Me=0),it>=Te/2&&(it=0),Me<5&&(k=Mg);let Ct=Me>0,vn=He-Me-(Ct?it:0);Te=k(od(vn,Y,H)),_e=(G==0?Te/2:G==J?0:Te)-G*J*((G==0?L/2:0)+(Ct?it/2:0));let _t={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},dn=Ve?null:new Path2D,qt=null;if(de!=null)qt=f.data[de.series[1]];else{let{y0:Ce,y1:qe}=c;Ce!=null&&qe!=null&&(T=qe.values(f,g,M,m),qt=Ce.values(f,g,M,m))}let nn=V*Te,U=le*Te;for(let Ce=J==1?M:m;Ce>=M&&Ce<=m;Ce+=J){let qe=T[Ce];if(qe==null)continue;if(qt!=null){let W=qt[Ce]??0;if(qe-W==0)continue;me=_(W,C,N,B)}let st=b.distr!=2||c!=null?v[Ce]:Ce,Se=E(st,b,D,A),It=_(bt(qe,Q),C,N,B),ze=k(Se-_e),Xe=k(Hn(It,me)),R=k(Ii(It,me)),y=Xe-R;if(qe!=null){let W=qe<0?U:nn,ce=qe<0?nn:U;Ve?(it>0&&tt[Ce]!=null&&j(Vt.get(tt[Ce]),ze,R+ri(it/2),Te,Hn(0,y-it),W,ce),ut[Ce]!=null&&j(at.get(ut[Ce]),ze,R+ri(it/2),Te,Hn(0,y-it),W,ce)):j(dn,ze,R+ri(it/2),Te,Hn(0,y-it),W,ce),ie(f,g,Ce,ze-it/2,R,Te+it,y)}}return it>0?_t.stroke=Ve?Vt:dn:Ve||(_t._fill=p.width==0?p._fill:p._stroke??p._fill,_t.width=0),_t.fill=Ve?at:dn,_t})}function Gw(i,e){let t=bt(e?.alignGaps,0);return(n,s,r,o)=>cr(n,s,(a,l,c,u,h,d,f,g,M,m,p)=>{[r,o]=$c(c,r,o);let v=a.pxRound,T=V=>v(d(V,u,m,g)),b=V=>v(f(V,h,p,M)),C,E,_;u.ori==0?(C=Qc,_=uo,E=Zg):(C=eu,_=ho,E=Jg);let A=u.dir*(u.ori==0?1:-1),B=T(l[A==1?r:o]),D=B,N=[],k=[];for(let V=A==1?r:o;V>=r&&V<=o;V+=A)if(c[V]!=null){let J=l[V],j=T(J);N.push(D=j),k.push(b(c[V]))}let G={stroke:i(N,k,C,_,E,v),fill:null,clip:null,band:null,gaps:null,flags:lo},L=G.stroke,[H,Y]=Sd(n,s);if(a.fill!=null||H!=0){let V=G.fill=new Path2D(L),le=a.fillTo(n,s,a.min,a.max,H),J=b(le);_(V,D,J),_(V,B,J)}if(!a.spanGaps){let V=[];V.push(...wd(l,c,r,o,A,T,t)),G.gaps=V=a.gaps(n,s,r,o,V),G.clip=jc(V,u.ori,g,M,m,p)}return Y!=0&&(G.band=Y==2?[gs(n,s,r,o,L,-1),gs(n,s,r,o,L,1)]:gs(n,s,r,o,L,Y)),G})}function Hw(i){return Gw(Ww,i)}function Ww(i,e,t,n,s,r){let o=i.length;if(o<2)return null;let a=new Path2D;if(t(a,i[0],e[0]),o==2)n(a,i[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=i[d+1]-i[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)s(a,i[d]+h[d]/3,e[d]+l[d]*h[d]/3,i[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,i[d+1],e[d+1])}return a}var ud=new Set;function pg(){for(let i of ud)i.syncRect(!0)}co&&(ar(wS,so,pg),ar(AS,so,pg,!0),ar(Xc,so,()=>{Rn.pxRatio=St}));var Xw=Qg(),qw=Kg();function mg(i,e,t,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>hd(r,o,e,t))}function Yw(i,e){return i.map((t,n)=>n==0?{}:hn({},e,t))}function hd(i,e,t,n){return hn({},e==0?t:n,i)}function e0(i,e,t){return e==null?oo:[e,t]}var $w=e0;function Zw(i,e,t){return e==null?oo:qc(e,t,gd,!0)}function t0(i,e,t,n){return e==null?oo:Zc(e,t,i.scales[n].log,!1)}var Jw=t0;function n0(i,e,t,n){return e==null?oo:md(e,t,i.scales[n].log,!1)}var Kw=n0;function jw(i,e,t,n,s){let r=Hn(Ym(i),Ym(e)),o=e-i,a=Pi(s/n*o,t);do{let l=t[a],c=n*l/o;if(c>=s&&r+(l<5?ks.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function gg(i){let e,t;return i=i.replace(/(\d+)px/,(n,s)=>(e=xn((t=+s)*St))+"px"),[i,e,t]}function Qw(i){i.show&&[i.font,i.labelFont].forEach(e=>{let t=Nt(e[2]*St,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Rn(i,e,t){let n={mode:bt(i.mode,1)},s=n.mode;function r(x,S,P,I){let z=S.valToPct(x);return I+P*(S.dir==-1?1-z:z)}function o(x,S,P,I){let z=S.valToPct(x);return I+P*(S.dir==-1?z:1-z)}function a(x,S,P,I){return S.ori==0?r(x,S,P,I):o(x,S,P,I)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;let c=n.root=pi(oS);if(i.id!=null&&(c.id=i.id),si(c,i.class),i.title){let x=pi(cS,c);x.textContent=i.title}let u=Ci("canvas"),h=n.ctx=u.getContext("2d"),d=pi(uS,c);ar("click",d,x=>{x.target===g&&(Ut!=xr||Gt!=_r)&&En.click(n,x)},!0);let f=n.under=pi(hS,d);d.appendChild(u);let g=n.over=pi(dS,d);i=ao(i);let M=+bt(i.pxAlign,1),m=dg(M);(i.plugins||[]).forEach(x=>{x.opts&&(i=x.opts(n,i)||i)});let p=i.ms||.001,v=n.series=s==1?mg(i.series||[],rg,ug,!1):Yw(i.series||[null],cg),T=n.axes=mg(i.axes||[],sg,ag,!0),b=n.scales={},C=n.bands=i.bands||[];C.forEach(x=>{x.fill=gt(x.fill||null),x.dir=bt(x.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,_={axes:Ki,series:dt},A=(i.drawOrder||["axes","series"]).map(x=>_[x]);function B(x){let S=x.distr==3?P=>ms(P>0?P:x.clamp(n,P,x.min,x.max,x.key)):x.distr==4?P=>jh(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let I=S(P),{_min:z,_max:Z}=x,oe=Z-z;return(I-z)/oe}}function D(x){let S=b[x];if(S==null){let P=(i.scales||ba)[x]||ba;if(P.from!=null){D(P.from);let I=hn({},b[P.from],P,{key:x});I.valToPct=B(I),b[x]=I}else{S=b[x]=hn({},x==E?Wg:Fw,P),S.key=x;let I=S.time,z=S.range,Z=Bs(z);if((x!=E||s==2&&!I)&&(Z&&(z[0]==null||z[1]==null)&&(z={min:z[0]==null?Wm:{mode:1,hard:z[0],soft:z[0]},max:z[1]==null?Wm:{mode:1,hard:z[1],soft:z[1]}},Z=!1),!Z&&Kc(z))){let oe=z;z=(fe,ye,Ne)=>ye==null?oo:qc(ye,Ne,oe)}S.range=gt(z||(I?$w:x==E?S.distr==3?Jw:S.distr==4?Kw:e0:S.distr==3?t0:S.distr==4?n0:Zw)),S.auto=gt(Z?!1:S.auto),S.clamp=gt(S.clamp||Dw),S._min=S._max=null,S.valToPct=B(S)}}}D("x"),D("y"),s==1&&v.forEach(x=>{D(x.scale)}),T.forEach(x=>{D(x.scale)});for(let x in i.scales)D(x);let N=b[E],k=N.distr,G,L;N.ori==0?(si(c,aS),G=r,L=o):(si(c,lS),G=o,L=r);let H={};for(let x in b){let S=b[x];(S.min!=null||S.max!=null)&&(H[x]={min:S.min,max:S.max},S.min=S.max=null)}let Y=i.tzDate||(x=>new Date(xn(x/p))),V=i.fmtDate||vd,le=p==1?aw(Y):uw(Y),J=tg(Y,eg(p==1?ow:cw,V)),j=ig(Y,ng(dw,V)),ie=[],de=n.legend=hn({},mw,i.legend),ue=n.cursor=hn({},bw,{drag:{y:s==2}},i.cursor),Q=de.show,me=ue.show,_e=de.markers;de.idxs=ie,_e.width=gt(_e.width),_e.dash=gt(_e.dash),_e.stroke=gt(_e.stroke),_e.fill=gt(_e.fill);let Te,Me,He,it=[],Ve=[],ut,at=!1,tt={};if(de.live){let x=v[1]?v[1].values:null;at=x!=null,ut=at?x(n,1,0):{_:0};for(let S in ut)tt[S]=fd}if(Q)if(Te=Ci("table",_S,c),He=Ci("tbody",null,Te),de.mount(n,Te),at){Me=Ci("thead",null,Te,He);let x=Ci("tr",null,Me);Ci("th",null,x);for(var Vt in ut)Ci("th",Im,x).textContent=Vt}else si(Te,yS),de.live&&si(Te,vS);let Dt={show:!0},tn={show:!1};function Ct(x,S){if(S==0&&(at||!de.live||s==2))return oo;let P=[],I=Ci("tr",bS,He,He.childNodes[S]);si(I,x.class),x.show||si(I,or);let z=Ci("th",null,I);if(_e.show){let fe=pi(MS,z);if(S>0){let ye=_e.width(n,S);ye&&(fe.style.border=ye+"px "+_e.dash(n,S)+" "+_e.stroke(n,S)),fe.style.background=_e.fill(n,S)}}let Z=pi(Im,z);x.label instanceof HTMLElement?Z.appendChild(x.label):Z.textContent=x.label,S>0&&(_e.show||(Z.style.color=x.width>0?_e.stroke(n,S):_e.fill(n,S)),_t("click",z,fe=>{if(ue._lock)return;Je(fe);let ye=v.indexOf(x);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ne=v.some((De,Ue)=>Ue>0&&Ue!=ye&&De.show);v.forEach((De,Ue)=>{Ue>0&&Fi(Ue,Ne?Ue==ye?Dt:tn:Dt,!0,an.setSeries)})}else Fi(ye,{show:!x.show},!0,an.setSeries)},!1),Ke&&_t(Fm,z,fe=>{ue._lock||(Je(fe),Fi(v.indexOf(x),yr,!0,an.setSeries))},!1));for(var oe in ut){let fe=Ci("td",SS,I);fe.textContent="--",P.push(fe)}return[I,P]}let vn=new Map;function _t(x,S,P,I=!0){let z=vn.get(S)||{},Z=ue.bind[x](n,S,P,I);Z&&(ar(x,S,z[x]=Z),vn.set(S,z))}function dn(x,S,P){let I=vn.get(S)||{};for(let z in I)(x==null||z==x)&&(rd(z,S,I[z]),delete I[z]);x==null&&vn.delete(S)}let qt=0,nn=0,U=0,Ce=0,qe=0,st=0,Se=qe,It=st,ze=U,Xe=Ce,R=0,y=0,W=0,ce=0;n.bbox={};let re=!1,xe=!1,ve=!1,ee=!1,ne=!1,pe=!1;function F(x,S,P){(P||x!=n.width||S!=n.height)&&se(x,S),lt(!1),ve=!0,xe=!0,Cn()}function se(x,S){n.width=qt=U=x,n.height=nn=Ce=S,qe=st=0,be(),Ge();let P=n.bbox;R=P.left=sr(qe*St,.5),y=P.top=sr(st*St,.5),W=P.width=sr(U*St,.5),ce=P.height=sr(Ce*St,.5)}let te=3;function we(){let x=!1,S=0;for(;!x;){S++;let P=pr(S),I=Di(S);x=S==te||P&&I,x||(se(n.width,n.height),xe=!0)}}function ge({width:x,height:S}){F(x,S)}n.setSize=ge;function be(){let x=!1,S=!1,P=!1,I=!1;T.forEach((z,Z)=>{if(z.show&&z._show){let{side:oe,_size:fe}=z,ye=oe%2,Ne=z.label!=null?z.labelSize:0,De=fe+Ne;De>0&&(ye?(U-=De,oe==3?(qe+=De,I=!0):P=!0):(Ce-=De,oe==0?(st+=De,x=!0):S=!0))}}),Li[0]=x,Li[1]=P,Li[2]=S,Li[3]=I,U-=gi[1]+gi[3],qe+=gi[3],Ce-=gi[2]+gi[0],st+=gi[0]}function Ge(){let x=qe+U,S=st+Ce,P=qe,I=st;function z(Z,oe){switch(Z){case 1:return x+=oe,x-oe;case 2:return S+=oe,S-oe;case 3:return P-=oe,P+oe;case 0:return I-=oe,I+oe}}T.forEach((Z,oe)=>{if(Z.show&&Z._show){let fe=Z.side;Z._pos=z(fe,Z._size),Z.label!=null&&(Z._lpos=z(fe,Z.labelSize))}})}if(ue.dataIdx==null){let x=ue.hover,S=x.skip=new Set(x.skip??[]);S.add(void 0);let P=x.prox=gt(x.prox),I=x.bias??=0;ue.dataIdx=(z,Z,oe,fe)=>{if(Z==0)return oe;let ye=oe,Ne=P(z,Z,oe,fe)??Lt,De=Ne>=0&&Ne<Lt,Ue=N.ori==0?U:Ce,nt=ue.left,Mt=e[0],vt=e[Z];if(S.has(vt[oe])){ye=null;let ft=null,$e=null,We;if(I==0||I==-1)for(We=oe;ft==null&&We-- >0;)S.has(vt[We])||(ft=We);if(I==0||I==1)for(We=oe;$e==null&&We++<vt.length;)S.has(vt[We])||($e=We);if(ft!=null||$e!=null)if(De){let Bt=ft==null?-1/0:G(Mt[ft],N,Ue,0),Zt=$e==null?1/0:G(Mt[$e],N,Ue,0),Sn=nt-Bt,Pt=Zt-nt;Sn<=Pt?Sn<=Ne&&(ye=ft):Pt<=Ne&&(ye=$e)}else ye=$e==null?ft:ft==null?$e:oe-ft<=$e-oe?ft:$e}else De&&_n(nt-G(Mt[oe],N,Ue,0))>Ne&&(ye=null);return ye}}let Je=x=>{ue.event=x};ue.idxs=ie,ue._lock=!1;let ae=ue.points;ae.show=gt(ae.show),ae.size=gt(ae.size),ae.stroke=gt(ae.stroke),ae.width=gt(ae.width),ae.fill=gt(ae.fill);let Oe=n.focus=hn({},i.focus||{alpha:.3},ue.focus),Ke=Oe.prox>=0,Re=Ke&&ae.one,rt=[],Ft=[],Dn=[];function mo(x,S){let P=ae.show(n,S);if(P instanceof HTMLElement)return si(P,xS),si(P,x.class),Yi(P,-10,-10,U,Ce),g.insertBefore(P,rt[S]),P}function hr(x,S){if(s==1||S>0){let P=s==1&&b[x.scale].time,I=x.value;x.value=P?Jm(I)?ig(Y,ng(I,V)):I||j:I||Iw,x.label=x.label||(P?Sw:Mw)}if(Re||S>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Xw||FS,x.fillTo=gt(x.fillTo||Uw),x.pxAlign=+bt(x.pxAlign,M),x.pxRound=dg(x.pxAlign),x.stroke=gt(x.stroke||null),x.fill=gt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=Lw(Hn(1,x.width),1),I=x.points=hn({},{size:P,width:Hn(1,P*.2),stroke:x.stroke,space:P*2,paths:qw,_stroke:null,_fill:null},x.points);I.show=gt(I.show),I.filter=gt(I.filter),I.fill=gt(I.fill),I.stroke=gt(I.stroke),I.paths=gt(I.paths),I.pxAlign=x.pxAlign}if(Q){let P=Ct(x,S);it.splice(S,0,P[0]),Ve.splice(S,0,P[1]),de.values.push(null)}if(me){ie.splice(S,0,null);let P=null;Re?S==0&&(P=mo(x,S)):S>0&&(P=mo(x,S)),rt.splice(S,0,P),Ft.splice(S,0,0),Dn.splice(S,0,0)}Mn("addSeries",S)}function ou(x,S){S=S??v.length,x=s==1?hd(x,S,rg,ug):hd(x,S,{},cg),v.splice(S,0,x),hr(v[S],S)}n.addSeries=ou;function Aa(x){if(v.splice(x,1),Q){de.values.splice(x,1),Ve.splice(x,1);let S=it.splice(x,1)[0];dn(null,S.firstChild),S.remove()}me&&(ie.splice(x,1),rt.splice(x,1)[0].remove(),Ft.splice(x,1),Dn.splice(x,1)),Mn("delSeries",x)}n.delSeries=Aa;let Li=[!1,!1,!1,!1];function $i(x,S){if(x._show=x.show,x.show){let P=x.side%2,I=b[x.scale];I==null&&(x.scale=P?v[1].scale:E,I=b[x.scale]);let z=I.time;x.size=gt(x.size),x.space=gt(x.space),x.rotate=gt(x.rotate),Bs(x.incrs)&&x.incrs.forEach(oe=>{!ks.has(oe)&&ks.set(oe,Ag(oe))}),x.incrs=gt(x.incrs||(I.distr==2?iw:z?p==1?rw:lw:rr)),x.splits=gt(x.splits||(z&&I.distr==1?le:I.distr==3?ad:I.distr==4?Ew:Aw)),x.stroke=gt(x.stroke),x.grid.stroke=gt(x.grid.stroke),x.ticks.stroke=gt(x.ticks.stroke),x.border.stroke=gt(x.border.stroke);let Z=x.values;x.values=Bs(Z)&&!Bs(Z[0])?gt(Z):z?Bs(Z)?tg(Y,eg(Z,V)):Jm(Z)?hw(Y,Z):Z||J:Z||ww,x.filter=gt(x.filter||(I.distr>=3&&I.log==10?Cw:I.distr==3&&I.log==2?Pw:Sg)),x.font=gg(x.font),x.labelFont=gg(x.labelFont),x._size=x.size(n,null,S,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(Li[S]=!0,x._el=pi(fS,d))}}function Zi(x,S,P,I){let[z,Z,oe,fe]=P,ye=S%2,Ne=0;return ye==0&&(fe||Z)&&(Ne=S==0&&!z||S==2&&!oe?xn(sg.size/3):0),ye==1&&(z||oe)&&(Ne=S==1&&!Z||S==3&&!fe?xn(ag.size/2):0),Ne}let go=n.padding=(i.padding||[Zi,Zi,Zi,Zi]).map(x=>gt(bt(x,Zi))),gi=n._padding=go.map((x,S)=>x(n,S,Li,0)),Yt,jt=null,Qt=null,Ni=s==1?v[0].idxs:null,$n=null,xs=!1;function xo(x,S){if(e=x??[],n.data=n._data=e,s==2){Yt=0;for(let P=1;P<v.length;P++)Yt+=e[P][0].length}else{e.length==0&&(n.data=n._data=e=[[]]),$n=e[0],Yt=$n.length;let P=e;if(k==2){P=e.slice();let I=P[0]=Array(Yt);for(let z=0;z<Yt;z++)I[z]=z}n._data=e=P}if(lt(!0),Mn("setData"),k==2&&(ve=!0),S!==!1){let P=N;P.auto(n,xs)?_o():ys(E,P.min,P.max),ee=ee||ue.left>=0,pe=!0,Cn()}}n.setData=xo;function _o(){xs=!0;let x,S;s==1&&(Yt>0?(jt=Ni[0]=0,Qt=Ni[1]=Yt-1,x=e[0][jt],S=e[0][Qt],k==2?(x=jt,S=Qt):x==S&&(k==3?[x,S]=Zc(x,x,N.log,!1):k==4?[x,S]=md(x,x,N.log,!1):N.time?S=x+xn(86400/p):[x,S]=qc(x,S,gd,!0))):(jt=Ni[0]=x=null,Qt=Ni[1]=S=null)),ys(E,x,S)}let dr,_s,fr,w,O,K,X,$,Ae,Pe;function Ee(x,S,P,I,z,Z){x??=Nm,P??=_d,I??="butt",z??=Nm,Z??="round",x!=dr&&(h.strokeStyle=dr=x),z!=_s&&(h.fillStyle=_s=z),S!=fr&&(h.lineWidth=fr=S),Z!=O&&(h.lineJoin=O=Z),I!=K&&(h.lineCap=K=I),P!=w&&h.setLineDash(w=P)}function Ie(x,S,P,I){S!=_s&&(h.fillStyle=_s=S),x!=X&&(h.font=X=x),P!=$&&(h.textAlign=$=P),I!=Ae&&(h.textBaseline=Ae=I)}function ke(x,S,P,I,z=0){if(I.length>0&&x.auto(n,xs)&&(S==null||S.min==null)){let Z=bt(jt,0),oe=bt(Qt,I.length-1),fe=P.min==null?CS(I,Z,oe,z,x.distr==3):[P.min,P.max];x.min=Ii(x.min,P.min=fe[0]),x.max=Hn(x.max,P.max=fe[1])}}let je={min:null,max:null};function ht(){for(let I in b){let z=b[I];H[I]==null&&(z.min==null||H[E]!=null&&z.auto(n,xs))&&(H[I]=je)}for(let I in b){let z=b[I];H[I]==null&&z.from!=null&&H[z.from]!=null&&(H[I]=je)}H[E]!=null&&lt(!0);let x={};for(let I in H){let z=H[I];if(z!=null){let Z=x[I]=ao(b[I],BS);if(z.min!=null)hn(Z,z);else if(I!=E||s==2)if(Yt==0&&Z.from==null){let oe=Z.range(n,null,null,I);Z.min=oe[0],Z.max=oe[1]}else Z.min=Lt,Z.max=-Lt}}if(Yt>0){v.forEach((I,z)=>{if(s==1){let Z=I.scale,oe=H[Z];if(oe==null)return;let fe=x[Z];if(z==0){let ye=fe.range(n,fe.min,fe.max,Z);fe.min=ye[0],fe.max=ye[1],jt=Pi(fe.min,e[0]),Qt=Pi(fe.max,e[0]),Qt-jt>1&&(e[0][jt]<fe.min&&jt++,e[0][Qt]>fe.max&&Qt--),I.min=$n[jt],I.max=$n[Qt]}else I.show&&I.auto&&ke(fe,oe,I,e[z],I.sorted);I.idxs[0]=jt,I.idxs[1]=Qt}else if(z>0&&I.show&&I.auto){let[Z,oe]=I.facets,fe=Z.scale,ye=oe.scale,[Ne,De]=e[z],Ue=x[fe],nt=x[ye];Ue!=null&&ke(Ue,H[fe],Z,Ne,Z.sorted),nt!=null&&ke(nt,H[ye],oe,De,oe.sorted),I.min=oe.min,I.max=oe.max}});for(let I in x){let z=x[I],Z=H[I];if(z.from==null&&(Z==null||Z.min==null)){let oe=z.range(n,z.min==Lt?null:z.min,z.max==-Lt?null:z.max,I);z.min=oe[0],z.max=oe[1]}}}for(let I in x){let z=x[I];if(z.from!=null){let Z=x[z.from];if(Z.min==null)z.min=z.max=null;else{let oe=z.range(n,Z.min,Z.max,I);z.min=oe[0],z.max=oe[1]}}}let S={},P=!1;for(let I in x){let z=x[I],Z=b[I];if(Z.min!=z.min||Z.max!=z.max){Z.min=z.min,Z.max=z.max;let oe=Z.distr;Z._min=oe==3?ms(Z.min):oe==4?jh(Z.min,Z.asinh):oe==100?Z.fwd(Z.min):Z.min,Z._max=oe==3?ms(Z.max):oe==4?jh(Z.max,Z.asinh):oe==100?Z.fwd(Z.max):Z.max,S[I]=P=!0}}if(P){v.forEach((I,z)=>{s==2?z>0&&S.y&&(I._paths=null):S[I.scale]&&(I._paths=null)});for(let I in S)ve=!0,Mn("setScale",I);me&&ue.left>=0&&(ee=pe=!0)}for(let I in H)H[I]=null}function Be(x){let S=od(jt-1,0,Yt-1),P=od(Qt+1,0,Yt-1);for(;x[S]==null&&S>0;)S--;for(;x[P]==null&&P<Yt-1;)P++;return[S,P]}function dt(){if(Yt>0){let x=v.some(S=>S._focus)&&Pe!=Oe.alpha;x&&(h.globalAlpha=Pe=Oe.alpha),v.forEach((S,P)=>{if(P>0&&S.show&&(Xt(P,!1),Xt(P,!0),S._paths==null)){let I=Pe;Pe!=S.alpha&&(h.globalAlpha=Pe=S.alpha);let z=s==2?[0,e[P][0].length-1]:Be(e[P]);S._paths=S.paths(n,P,z[0],z[1]),Pe!=I&&(h.globalAlpha=Pe=I)}}),v.forEach((S,P)=>{if(P>0&&S.show){let I=Pe;Pe!=S.alpha&&(h.globalAlpha=Pe=S.alpha),S._paths!=null&&Et(P,!1);{let z=S._paths!=null?S._paths.gaps:null,Z=S.points.show(n,P,jt,Qt,z),oe=S.points.filter(n,P,Z,z);(Z||oe)&&(S.points._paths=S.points.paths(n,P,jt,Qt,oe),Et(P,!0))}Pe!=I&&(h.globalAlpha=Pe=I),Mn("drawSeries",P)}}),x&&(h.globalAlpha=Pe=1)}}function Xt(x,S){let P=S?v[x].points:v[x];P._stroke=P.stroke(n,x),P._fill=P.fill(n,x)}function Et(x,S){let P=S?v[x].points:v[x],{stroke:I,fill:z,clip:Z,flags:oe,_stroke:fe=P._stroke,_fill:ye=P._fill,_width:Ne=P.width}=P._paths;Ne=Nt(Ne*St,3);let De=null,Ue=Ne%2/2;S&&ye==null&&(ye=Ne>0?"#fff":fe);let nt=P.pxAlign==1&&Ue>0;if(nt&&h.translate(Ue,Ue),!S){let Mt=R-Ne/2,vt=y-Ne/2,ft=W+Ne,$e=ce+Ne;De=new Path2D,De.rect(Mt,vt,ft,$e)}S?Fe(fe,Ne,P.dash,P.cap,ye,I,z,oe,Z):Tt(x,fe,Ne,P.dash,P.cap,ye,I,z,oe,De,Z),nt&&h.translate(-Ue,-Ue)}function Tt(x,S,P,I,z,Z,oe,fe,ye,Ne,De){let Ue=!1;ye!=0&&C.forEach((nt,Mt)=>{if(nt.series[0]==x){let vt=v[nt.series[1]],ft=e[nt.series[1]],$e=(vt._paths||ba).band;Bs($e)&&($e=nt.dir==1?$e[0]:$e[1]);let We,Bt=null;vt.show&&$e&&IS(ft,jt,Qt)?(Bt=nt.fill(n,Mt)||Z,We=vt._paths.clip):$e=null,Fe(S,P,I,z,Bt,oe,fe,ye,Ne,De,We,$e),Ue=!0}}),Ue||Fe(S,P,I,z,Z,oe,fe,ye,Ne,De)}let fn=lo|cd;function Fe(x,S,P,I,z,Z,oe,fe,ye,Ne,De,Ue){Ee(x,S,P,I,z),(ye||Ne||Ue)&&(h.save(),ye&&h.clip(ye),Ne&&h.clip(Ne)),Ue?(fe&fn)==fn?(h.clip(Ue),De&&h.clip(De),pt(z,oe),sn(x,Z,S)):fe&cd?(pt(z,oe),h.clip(Ue),sn(x,Z,S)):fe&lo&&(h.save(),h.clip(Ue),De&&h.clip(De),pt(z,oe),h.restore(),sn(x,Z,S)):(pt(z,oe),sn(x,Z,S)),(ye||Ne||Ue)&&h.restore()}function sn(x,S,P){P>0&&(S instanceof Map?S.forEach((I,z)=>{h.strokeStyle=dr=z,h.stroke(I)}):S!=null&&x&&h.stroke(S))}function pt(x,S){S instanceof Map?S.forEach((P,I)=>{h.fillStyle=_s=I,h.fill(P)}):S!=null&&x&&h.fill(S)}function Ji(x,S,P,I){let z=T[x],Z;if(I<=0)Z=[0,0];else{let oe=z._space=z.space(n,x,S,P,I),fe=z._incrs=z.incrs(n,x,S,P,I,oe);Z=jw(S,P,fe,I,oe)}return z._found=Z}function rn(x,S,P,I,z,Z,oe,fe,ye,Ne){let De=oe%2/2;M==1&&h.translate(De,De),Ee(fe,oe,ye,Ne,fe),h.beginPath();let Ue,nt,Mt,vt,ft=z+(I==0||I==3?-Z:Z);P==0?(nt=z,vt=ft):(Ue=z,Mt=ft);for(let $e=0;$e<x.length;$e++)S[$e]!=null&&(P==0?Ue=Mt=x[$e]:nt=vt=x[$e],h.moveTo(Ue,nt),h.lineTo(Mt,vt));h.stroke(),M==1&&h.translate(-De,-De)}function pr(x){let S=!0;return T.forEach((P,I)=>{if(!P.show)return;let z=b[P.scale];if(z.min==null){P._show&&(S=!1,P._show=!1,lt(!1));return}else P._show||(S=!1,P._show=!0,lt(!1));let Z=P.side,oe=Z%2,{min:fe,max:ye}=z,[Ne,De]=Ji(I,fe,ye,oe==0?U:Ce);if(De==0)return;let Ue=z.distr==2,nt=P._splits=P.splits(n,I,fe,ye,Ne,De,Ue),Mt=z.distr==2?nt.map(We=>$n[We]):nt,vt=z.distr==2?$n[nt[1]]-$n[nt[0]]:Ne,ft=P._values=P.values(n,P.filter(n,Mt,I,De,vt),I,De,vt);P._rotate=Z==2?P.rotate(n,ft,I,De):0;let $e=P._size;P._size=mi(P.size(n,ft,I,x)),$e!=null&&P._size!=$e&&(S=!1)}),S}function Di(x){let S=!0;return go.forEach((P,I)=>{let z=P(n,I,Li,x);z!=gi[I]&&(S=!1),gi[I]=z}),S}function Ki(){for(let x=0;x<T.length;x++){let S=T[x];if(!S.show||!S._show)continue;let P=S.side,I=P%2,z,Z,oe=S.stroke(n,x),fe=P==0||P==3?-1:1,[ye,Ne]=S._found;if(S.label!=null){let On=S.labelGap*fe,Kn=xn((S._lpos+On)*St);Ie(S.labelFont[0],oe,"center",P==2?"top":Lm),h.save(),I==1?(z=Z=0,h.translate(Kn,xn(y+ce/2)),h.rotate((P==3?-Wc:Wc)/2)):(z=xn(R+W/2),Z=Kn);let Gs=bg(S.label)?S.label(n,x,ye,Ne):S.label;h.fillText(Gs,z,Z),h.restore()}if(Ne==0)continue;let De=b[S.scale],Ue=I==0?W:ce,nt=I==0?R:y,Mt=S._splits,vt=De.distr==2?Mt.map(On=>$n[On]):Mt,ft=De.distr==2?$n[Mt[1]]-$n[Mt[0]]:ye,$e=S.ticks,We=S.border,Bt=$e.show?$e.size:0,Zt=xn(Bt*St),Sn=xn((S.alignTo==2?S._size-Bt-S.gap:S.gap)*St),Pt=S._rotate*-Wc/180,Jt=m(S._pos*St),Zn=(Zt+Sn)*fe,Un=Jt+Zn;Z=I==0?Un:0,z=I==1?Un:0;let li=S.font[0],xi=S.align==1?no:S.align==2?Zh:Pt>0?no:Pt<0?Zh:I==0?"center":P==3?Zh:no,Oi=Pt||I==1?"middle":P==2?"top":Lm;Ie(li,oe,xi,Oi);let Jn=S.font[1]*S.lineGap,ci=Mt.map(On=>m(a(On,De,Ue,nt))),_i=S._values;for(let On=0;On<_i.length;On++){let Kn=_i[On];if(Kn!=null){I==0?z=ci[On]:Z=ci[On],Kn=""+Kn;let Gs=Kn.indexOf(`
`)==-1?[Kn]:Kn.split(/\n/gm);for(let Bn=0;Bn<Gs.length;Bn++){let Jd=Gs[Bn];Pt?(h.save(),h.translate(z,Z+Bn*Jn),h.rotate(Pt),h.fillText(Jd,0,0),h.restore()):h.fillText(Jd,z,Z+Bn*Jn)}}}$e.show&&rn(ci,$e.filter(n,vt,x,Ne,ft),I,P,Jt,Zt,Nt($e.width*St,3),$e.stroke(n,x),$e.dash,$e.cap);let Bi=S.grid;Bi.show&&rn(ci,Bi.filter(n,vt,x,Ne,ft),I,I==0?2:1,I==0?y:R,I==0?ce:W,Nt(Bi.width*St,3),Bi.stroke(n,x),Bi.dash,Bi.cap),We.show&&rn([Jt],[1],I==0?1:0,I==0?1:2,I==1?y:R,I==1?ce:W,Nt(We.width*St,3),We.stroke(n,x),We.dash,We.cap)}Mn("drawAxes")}function lt(x){v.forEach((S,P)=>{P>0&&(S._paths=null,x&&(s==1?(S.min=null,S.max=null):S.facets.forEach(I=>{I.min=null,I.max=null})))})}let $t=!1,Fn=!1,Rt=[];function on(){Fn=!1;for(let x=0;x<Rt.length;x++)Mn(...Rt[x]);Rt.length=0}function Cn(){$t||(XS(Ld),$t=!0)}function Ea(x,S=!1){$t=!0,Fn=S,x(n),Ld(),S&&Rt.length>0&&queueMicrotask(on)}n.batch=Ea;function Ld(){if(re&&(ht(),re=!1),ve&&(we(),ve=!1),xe){if(zt(f,no,qe),zt(f,"top",st),zt(f,xa,U),zt(f,_a,Ce),zt(g,no,qe),zt(g,"top",st),zt(g,xa,U),zt(g,_a,Ce),zt(d,xa,qt),zt(d,_a,nn),u.width=xn(qt*St),u.height=xn(nn*St),T.forEach(({_el:x,_show:S,_size:P,_pos:I,side:z})=>{if(x!=null)if(S){let Z=z===3||z===0?P:0,oe=z%2==1;zt(x,oe?"left":"top",I-Z),zt(x,oe?"width":"height",P),zt(x,oe?"top":"left",oe?st:qe),zt(x,oe?"height":"width",oe?Ce:U),sd(x,or)}else si(x,or)}),dr=_s=fr=O=K=X=$=Ae=w=null,Pe=1,bo(!0),qe!=Se||st!=It||U!=ze||Ce!=Xe){lt(!1);let x=U/ze,S=Ce/Xe;if(me&&!ee&&ue.left>=0){ue.left*=x,ue.top*=S,mr&&Yi(mr,xn(ue.left),0,U,Ce),gr&&Yi(gr,0,xn(ue.top),U,Ce);for(let P=0;P<rt.length;P++){let I=rt[P];I!=null&&(Ft[P]*=x,Dn[P]*=S,Yi(I,mi(Ft[P]),mi(Dn[P]),U,Ce))}}if(Ot.show&&!ne&&Ot.left>=0&&Ot.width>0){Ot.left*=x,Ot.width*=x,Ot.top*=S,Ot.height*=S;for(let P in du)zt(vr,P,Ot[P])}Se=qe,It=st,ze=U,Xe=Ce}Mn("setSize"),xe=!1}qt>0&&nn>0&&(h.clearRect(0,0,u.width,u.height),Mn("drawClear"),A.forEach(x=>x()),Mn("draw")),Ot.show&&ne&&(Ta(Ot),ne=!1),me&&ee&&(Vs(null,!0,!1),ee=!1),de.show&&de.live&&pe&&(uu(),pe=!1),l||(l=!0,n.status=1,Mn("ready")),xs=!1,$t=!1}n.redraw=(x,S)=>{ve=S||!1,x!==!1?ys(E,N.min,N.max):Cn()};function au(x,S){let P=b[x];if(P.from==null){if(Yt==0){let I=P.range(n,S.min,S.max,x);S.min=I[0],S.max=I[1]}if(S.min>S.max){let I=S.min;S.min=S.max,S.max=I}if(Yt>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;x==E&&P.distr==2&&Yt>0&&(S.min=Pi(S.min,e[0]),S.max=Pi(S.max,e[0]),S.min==S.max&&S.max++),H[x]=S,re=!0,Cn()}}n.setScale=au;let lu,cu,mr,gr,Nd,Dd,xr,_r,Fd,Ud,Ut,Gt,vs=!1,En=ue.drag,yn=En.x,bn=En.y;me&&(ue.x&&(lu=pi(mS,g)),ue.y&&(cu=pi(gS,g)),N.ori==0?(mr=lu,gr=cu):(mr=cu,gr=lu),Ut=ue.left,Gt=ue.top);let Ot=n.select=hn({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),vr=Ot.show?pi(pS,Ot.over?g:f):null;function Ta(x,S){if(Ot.show){for(let P in x)Ot[P]=x[P],P in du&&zt(vr,P,x[P]);S!==!1&&Mn("setSelect")}}n.setSelect=Ta;function U0(x){if(v[x].show)Q&&sd(it[x],or);else if(Q&&si(it[x],or),me){let P=Re?rt[0]:rt[x];P!=null&&Yi(P,-10,-10,U,Ce)}}function ys(x,S,P){au(x,{min:S,max:P})}function Fi(x,S,P,I){S.focus!=null&&V0(x),S.show!=null&&v.forEach((z,Z)=>{Z>0&&(x==Z||x==null)&&(z.show=S.show,U0(Z),s==2?(ys(z.facets[0].scale,null,null),ys(z.facets[1].scale,null,null)):ys(z.scale,null,null),Cn())}),P!==!1&&Mn("setSeries",x,S),I&&Mo("setSeries",n,x,S)}n.setSeries=Fi;function O0(x,S){hn(C[x],S)}function B0(x,S){x.fill=gt(x.fill||null),x.dir=bt(x.dir,-1),S=S??C.length,C.splice(S,0,x)}function k0(x){x==null?C.length=0:C.splice(x,1)}n.addBand=B0,n.setBand=O0,n.delBand=k0;function z0(x,S){v[x].alpha=S,me&&rt[x]!=null&&(rt[x].style.opacity=S),Q&&it[x]&&(it[x].style.opacity=S)}let ji,bs,zs,yr={focus:!0};function V0(x){if(x!=zs){let S=x==null,P=Oe.alpha!=1;v.forEach((I,z)=>{if(s==1||z>0){let Z=S||z==0||z==x;I._focus=S?null:Z,P&&z0(z,Z?1:Oe.alpha)}}),zs=x,P&&Cn()}}Q&&Ke&&_t(Um,Te,x=>{ue._lock||(Je(x),zs!=null&&Fi(null,yr,!0,an.setSeries))});function Ui(x,S,P){let I=b[S];P&&(x=x/St-(I.ori==1?st:qe));let z=U;I.ori==1&&(z=Ce,x=z-x),I.dir==-1&&(x=z-x);let Z=I._min,oe=I._max,fe=x/z,ye=Z+(oe-Z)*fe,Ne=I.distr;return Ne==3?ro(10,ye):Ne==4?NS(ye,I.asinh):Ne==100?I.bwd(ye):ye}function G0(x,S){let P=Ui(x,E,S);return Pi(P,e[0],jt,Qt)}n.valToIdx=x=>Pi(x,e[0]),n.posToIdx=G0,n.posToVal=Ui,n.valToPos=(x,S,P)=>b[S].ori==0?r(x,b[S],P?W:U,P?R:0):o(x,b[S],P?ce:Ce,P?y:0),n.setCursor=(x,S,P)=>{Ut=x.left,Gt=x.top,Vs(null,S,P)};function Od(x,S){zt(vr,no,Ot.left=x),zt(vr,xa,Ot.width=S)}function Bd(x,S){zt(vr,"top",Ot.top=x),zt(vr,_a,Ot.height=S)}let vo=N.ori==0?Od:Bd,yo=N.ori==1?Od:Bd;function H0(){if(Q&&de.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&at)continue;let S=de.values[x],P=0;for(let I in S)Ve[x][P++].firstChild.nodeValue=S[I]}}function uu(x,S){if(x!=null&&(x.idxs?x.idxs.forEach((P,I)=>{ie[I]=P}):OS(x.idx)||ie.fill(x.idx),de.idx=ie[0]),Q&&de.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!at)&&W0(P,ie[P]);H0()}pe=!1,S!==!1&&Mn("setLegend")}n.setLegend=uu;function W0(x,S){let P=v[x],I=x==0&&k==2?$n:e[x],z;at?z=P.values(n,x,S)??tt:(z=P.value(n,S==null?null:I[S],x,S),z=z==null?tt:{_:z}),de.values[x]=z}function Vs(x,S,P){Fd=Ut,Ud=Gt,[Ut,Gt]=ue.move(n,Ut,Gt),ue.left=Ut,ue.top=Gt,me&&(mr&&Yi(mr,xn(Ut),0,U,Ce),gr&&Yi(gr,0,xn(Gt),U,Ce));let I,z=jt>Qt;ji=Lt,bs=null;let Z=N.ori==0?U:Ce,oe=N.ori==1?U:Ce;if(Ut<0||Yt==0||z){I=ue.idx=null;for(let fe=0;fe<v.length;fe++){let ye=rt[fe];ye!=null&&Yi(ye,-10,-10,U,Ce)}Ke&&Fi(null,yr,!0,x==null&&an.setSeries),de.live&&(ie.fill(I),pe=!0)}else{let fe,ye,Ne;s==1&&(fe=N.ori==0?Ut:Gt,ye=Ui(fe,E),I=ue.idx=Pi(ye,e[0],jt,Qt),Ne=G(e[0][I],N,Z,0));let De=-10,Ue=-10,nt=0,Mt=0,vt=!0,ft="",$e="";for(let We=s==2?1:0;We<v.length;We++){let Bt=v[We],Zt=ie[We],Sn=Zt==null?null:s==1?e[We][Zt]:e[We][1][Zt],Pt=ue.dataIdx(n,We,I,ye),Jt=Pt==null?null:s==1?e[We][Pt]:e[We][1][Pt];if(pe=pe||Jt!=Sn||Pt!=Zt,ie[We]=Pt,We>0&&Bt.show){let Zn=Pt==null?-10:Pt==I?Ne:G(s==1?e[0][Pt]:e[We][0][Pt],N,Z,0),Un=Jt==null?-10:L(Jt,s==1?b[Bt.scale]:b[Bt.facets[1].scale],oe,0);if(Ke&&Jt!=null){let li=N.ori==1?Ut:Gt,xi=_n(Oe.dist(n,We,Pt,Un,li));if(xi<ji){let Oi=Oe.bias;if(Oi!=0){let Jn=Ui(li,Bt.scale),ci=Jt>=0?1:-1,_i=Jn>=0?1:-1;_i==ci&&(_i==1?Oi==1?Jt>=Jn:Jt<=Jn:Oi==1?Jt<=Jn:Jt>=Jn)&&(ji=xi,bs=We)}else ji=xi,bs=We}}if(pe||Re){let li,xi;N.ori==0?(li=Zn,xi=Un):(li=Un,xi=Zn);let Oi,Jn,ci,_i,Bi,On,Kn=!0,Gs=ae.bbox;if(Gs!=null){Kn=!1;let Bn=Gs(n,We);ci=Bn.left,_i=Bn.top,Oi=Bn.width,Jn=Bn.height}else ci=li,_i=xi,Oi=Jn=ae.size(n,We);if(On=ae.fill(n,We),Bi=ae.stroke(n,We),Re)We==bs&&ji<=Oe.prox&&(De=ci,Ue=_i,nt=Oi,Mt=Jn,vt=Kn,ft=On,$e=Bi);else{let Bn=rt[We];Bn!=null&&(Ft[We]=ci,Dn[We]=_i,Hm(Bn,Oi,Jn,Kn),Vm(Bn,On,Bi),Yi(Bn,mi(ci),mi(_i),U,Ce))}}}}if(Re){let We=Oe.prox,Bt=zs==null?ji<=We:ji>We||bs!=zs;if(pe||Bt){let Zt=rt[0];Zt!=null&&(Ft[0]=De,Dn[0]=Ue,Hm(Zt,nt,Mt,vt),Vm(Zt,ft,$e),Yi(Zt,mi(De),mi(Ue),U,Ce))}}}if(Ot.show&&vs)if(x!=null){let[fe,ye]=an.scales,[Ne,De]=an.match,[Ue,nt]=x.cursor.sync.scales,Mt=x.cursor.drag;if(yn=Mt._x,bn=Mt._y,yn||bn){let{left:vt,top:ft,width:$e,height:We}=x.select,Bt=x.scales[Ue].ori,Zt=x.posToVal,Sn,Pt,Jt,Zn,Un,li=fe!=null&&Ne(fe,Ue),xi=ye!=null&&De(ye,nt);li&&yn?(Bt==0?(Sn=vt,Pt=$e):(Sn=ft,Pt=We),Jt=b[fe],Zn=G(Zt(Sn,Ue),Jt,Z,0),Un=G(Zt(Sn+Pt,Ue),Jt,Z,0),vo(Ii(Zn,Un),_n(Un-Zn))):vo(0,Z),xi&&bn?(Bt==1?(Sn=vt,Pt=$e):(Sn=ft,Pt=We),Jt=b[ye],Zn=L(Zt(Sn,nt),Jt,oe,0),Un=L(Zt(Sn+Pt,nt),Jt,oe,0),yo(Ii(Zn,Un),_n(Un-Zn))):yo(0,oe)}else fu()}else{let fe=_n(Fd-Nd),ye=_n(Ud-Dd);if(N.ori==1){let nt=fe;fe=ye,ye=nt}yn=En.x&&fe>=En.dist,bn=En.y&&ye>=En.dist;let Ne=En.uni;Ne!=null?yn&&bn&&(yn=fe>=Ne,bn=ye>=Ne,!yn&&!bn&&(ye>fe?bn=!0:yn=!0)):En.x&&En.y&&(yn||bn)&&(yn=bn=!0);let De,Ue;yn&&(N.ori==0?(De=xr,Ue=Ut):(De=_r,Ue=Gt),vo(Ii(De,Ue),_n(Ue-De)),bn||yo(0,oe)),bn&&(N.ori==1?(De=xr,Ue=Ut):(De=_r,Ue=Gt),yo(Ii(De,Ue),_n(Ue-De)),yn||vo(0,Z)),!yn&&!bn&&(vo(0,0),yo(0,0))}if(En._x=yn,En._y=bn,x==null){if(P){if(Zd!=null){let[fe,ye]=an.scales;an.values[0]=fe!=null?Ui(N.ori==0?Ut:Gt,fe):null,an.values[1]=ye!=null?Ui(N.ori==1?Ut:Gt,ye):null}Mo(Jh,n,Ut,Gt,U,Ce,I)}if(Ke){let fe=P&&an.setSeries,ye=Oe.prox;zs==null?ji<=ye&&Fi(bs,yr,!0,fe):ji>ye?Fi(null,yr,!0,fe):bs!=zs&&Fi(bs,yr,!0,fe)}}pe&&(de.idx=I,uu()),S!==!1&&Mn("setCursor")}let Ms=null;Object.defineProperty(n,"rect",{get(){return Ms==null&&bo(!1),Ms}});function bo(x=!1){x?Ms=null:(Ms=g.getBoundingClientRect(),Mn("syncRect",Ms))}function kd(x,S,P,I,z,Z,oe){ue._lock||vs&&x!=null&&x.movementX==0&&x.movementY==0||(hu(x,S,P,I,z,Z,oe,!1,x!=null),x!=null?Vs(null,!0,!0):Vs(S,!0,!1))}function hu(x,S,P,I,z,Z,oe,fe,ye){if(Ms==null&&bo(!1),Je(x),x!=null)P=x.clientX-Ms.left,I=x.clientY-Ms.top;else{if(P<0||I<0){Ut=-10,Gt=-10;return}let[Ne,De]=an.scales,Ue=S.cursor.sync,[nt,Mt]=Ue.values,[vt,ft]=Ue.scales,[$e,We]=an.match,Bt=S.axes[0].side%2==1,Zt=N.ori==0?U:Ce,Sn=N.ori==1?U:Ce,Pt=Bt?Z:z,Jt=Bt?z:Z,Zn=Bt?I:P,Un=Bt?P:I;if(vt!=null?P=$e(Ne,vt)?a(nt,b[Ne],Zt,0):-10:P=Zt*(Zn/Pt),ft!=null?I=We(De,ft)?a(Mt,b[De],Sn,0):-10:I=Sn*(Un/Jt),N.ori==1){let li=P;P=I,I=li}}ye&&(S==null||S.cursor.event.type==Jh)&&((P<=1||P>=U-1)&&(P=sr(P,U)),(I<=1||I>=Ce-1)&&(I=sr(I,Ce))),fe?(Nd=P,Dd=I,[xr,_r]=ue.move(n,P,I)):(Ut=P,Gt=I)}let du={width:0,height:0,left:0,top:0};function fu(){Ta(du,!1)}let zd,Vd,Gd,Hd;function Wd(x,S,P,I,z,Z,oe){vs=!0,yn=bn=En._x=En._y=!1,hu(x,S,P,I,z,Z,oe,!0,!1),x!=null&&(_t(Kh,nd,Xd,!1),Mo(Dm,n,xr,_r,U,Ce,null));let{left:fe,top:ye,width:Ne,height:De}=Ot;zd=fe,Vd=ye,Gd=Ne,Hd=De}function Xd(x,S,P,I,z,Z,oe){vs=En._x=En._y=!1,hu(x,S,P,I,z,Z,oe,!1,!0);let{left:fe,top:ye,width:Ne,height:De}=Ot,Ue=Ne>0||De>0,nt=zd!=fe||Vd!=ye||Gd!=Ne||Hd!=De;if(Ue&&nt&&Ta(Ot),En.setScale&&Ue&&nt){let Mt=fe,vt=Ne,ft=ye,$e=De;if(N.ori==1&&(Mt=ye,vt=De,ft=fe,$e=Ne),yn&&ys(E,Ui(Mt,E),Ui(Mt+vt,E)),bn)for(let We in b){let Bt=b[We];We!=E&&Bt.from==null&&Bt.min!=Lt&&ys(We,Ui(ft+$e,We),Ui(ft,We))}fu()}else ue.lock&&(ue._lock=!ue._lock,Vs(S,!0,x!=null));x!=null&&(dn(Kh,nd),Mo(Kh,n,Ut,Gt,U,Ce,null))}function X0(x,S,P,I,z,Z,oe){if(ue._lock)return;Je(x);let fe=vs;if(vs){let ye=!0,Ne=!0,De=10,Ue,nt;N.ori==0?(Ue=yn,nt=bn):(Ue=bn,nt=yn),Ue&&nt&&(ye=Ut<=De||Ut>=U-De,Ne=Gt<=De||Gt>=Ce-De),Ue&&ye&&(Ut=Ut<xr?0:U),nt&&Ne&&(Gt=Gt<_r?0:Ce),Vs(null,!0,!0),vs=!1}Ut=-10,Gt=-10,ie.fill(null),Vs(null,!0,!0),fe&&(vs=fe)}function qd(x,S,P,I,z,Z,oe){ue._lock||(Je(x),_o(),fu(),x!=null&&Mo(Om,n,Ut,Gt,U,Ce,null))}function Yd(){T.forEach(Qw),F(n.width,n.height,!0)}ar(Xc,so,Yd);let br={};br.mousedown=Wd,br.mousemove=kd,br.mouseup=Xd,br.dblclick=qd,br.setSeries=(x,S,P,I)=>{let z=an.match[2];P=z(n,S,P),P!=-1&&Fi(P,I,!0,!1)},me&&(_t(Dm,g,Wd),_t(Jh,g,kd),_t(Fm,g,x=>{Je(x),bo(!1)}),_t(Um,g,X0),_t(Om,g,qd),ud.add(n),n.syncRect=bo);let Ra=n.hooks=i.hooks||{};function Mn(x,S,P){Fn?Rt.push([x,S,P]):x in Ra&&Ra[x].forEach(I=>{I.call(null,n,S,P)})}(i.plugins||[]).forEach(x=>{for(let S in x.hooks)Ra[S]=(Ra[S]||[]).concat(x.hooks[S])});let $d=(x,S,P)=>P,an=hn({key:null,setSeries:!1,filters:{pub:$m,sub:$m},scales:[E,v[1]?v[1].scale:null],match:[Zm,Zm,$d],values:[null,null]},ue.sync);an.match.length==2&&an.match.push($d),ue.sync=an;let Zd=an.key,pu=Xg(Zd);function Mo(x,S,P,I,z,Z,oe){an.filters.pub(x,S,P,I,z,Z,oe)&&pu.pub(x,S,P,I,z,Z,oe)}pu.sub(n);function q0(x,S,P,I,z,Z,oe){an.filters.sub(x,S,P,I,z,Z,oe)&&br[x](null,S,P,I,z,Z,oe)}n.pub=q0;function Y0(){pu.unsub(n),ud.delete(n),vn.clear(),rd(Xc,so,Yd),c.remove(),Te?.remove(),Mn("destroy")}n.destroy=Y0;function mu(){Mn("init",i,e),xo(e||i.data,!1),H[E]?au(E,H[E]):_o(),ne=Ot.show&&(Ot.width>0||Ot.height>0),ee=pe=!0,F(i.width,i.height)}return v.forEach(hr),T.forEach($i),t?t instanceof HTMLElement?(t.appendChild(c),mu()):t(n,mu):mu(),n}Rn.assign=hn;Rn.fmtNum=xd;Rn.rangeNum=qc;Rn.rangeLog=Zc;Rn.rangeAsinh=md;Rn.orient=cr;Rn.pxRatio=St;Rn.join=WS;Rn.fmtDate=vd,Rn.tzDate=tw;Rn.sync=Xg;{Rn.addGap=Ow,Rn.clipGaps=jc;let i=Rn.paths={points:Kg};i.linear=Qg,i.stepped=zw,i.bars=Vw,i.spline=Hw}var e1={body:["1","2","3"],space:["x","y","z"],quaternion:["w","x","y","z"]};function i0(i,e){return i.columns.flatMap(t=>{let n=e.columns[t.name];if(n===void 0)return[];let s=t.name.startsWith("law_"),r=(s?t.name.slice(4):t.name).replaceAll("_"," "),o=s?`drift of ${r}`:t1(t.mathml)??r,a=e1[t.axes]??[],l=Array.from({length:t.width},(c,u)=>({label:t.width===1?o:`${o}${s1(a[u]??String(u+1))}`,values:s?n.map(h=>h-(n[0]??0)):n1(n,t.width,u)}));return[{...t,text:o,unit:vi(t.unit),components:l}]})}function t1(i){let e=So(i);return e!==""&&e.length<=4?e:null}function n1(i,e,t){return e===1?i:Float64Array.from({length:i.length/e},(n,s)=>i[e*s+t]??NaN)}var i1={1:"₁",2:"₂",3:"₃",4:"₄",5:"₅",6:"₆",x:"ₓ"};function s1(i){return i1[i]??`_${i}`}var r0=170;function o0(i){let e=new Set(o1(i)),t=he("div",{class:"lab-chips",role:"toolbar","aria-label":"Quantities"}),n=he("div",{class:"lab-plots"}),s=he("div",{},t,n),r=[],o=()=>i0(i.model,i.shown.value.motion),a=()=>o().filter(({name:d})=>e.has(d)),l=()=>{for(let{plot:d}of r)d.destroy();n.replaceChildren(),r=a().map(d=>{let f=he("figure",{class:"lab-plot","aria-label":`${d.meaning||d.name} over time`});n.append(f);let g=Math.max(240,n.clientWidth||600),M=r1(d,f);return{plot:a1(i,d,f,g),readings:M}}),c()},c=()=>{for(let{plot:d,readings:f}of r){Ed(d,i);let{times:g}=i.shown.value.motion,{index:M,share:m}=La(g,i.clock.time.value);f.forEach((p,v)=>{let T=d.data[v+1],b=(1-m)*(T?.[M]??NaN)+(m>0?m*(T?.[M+1]??NaN):0);p.textContent=Kt(b,4)})}},u=()=>{let d=a();if(d.length!==r.length)return l();d.forEach((f,g)=>r[g]?.plot.setData(l0(i,f))),c()};for(let d of o()){let f=d.text.length<=4?Qi(d.mathml):d.text;t.append(Hs(f,d.meaning||d.name,e.has(d.name),g=>{g?e.add(d.name):e.delete(d.name),l()}))}i.shown.after(u),i.clock.time.after(c),Ar(l);let h=0;return new ResizeObserver(()=>{if(n.clientWidth===h||n.clientWidth===0)return;let d=h===0;if(h=n.clientWidth,d)l();else for(let{plot:f}of r)f.setSize({width:h,height:r0})}).observe(n),{element:s,chosen:a}}function r1(i,e){let t=Tn(),n=he("figcaption",{class:"lab-curves"});return e.append(n),i.components.map(({label:s},r)=>{let o=he("span",{class:"lab-number"}),a=`border-top: 2.5px ${s0[r%s0.length]??"solid"} ${a0(t,r)}`;return n.append(he("span",{},he("i",{style:a}),`${s} = `,o)),o})}var s0=["solid","dashed","dotted","solid"];function a0(i,e){return i.components[e]??i.series[e%i.series.length]??i.ink}function o1(i){let e=i.model.columns.map(({name:n})=>n),t=["omega","gamma"].filter(n=>e.includes(n));return t.length>0?t:e.filter(n=>!n.startsWith("lambda")).slice(0,2)}function l0(i,e){return[i.shown.value.motion.times,...e.components.map(({values:t})=>t)]}function a1(i,e,t,n){let s=Tn(),r={stroke:s.quiet,font:"13px 'STIX Two Text', Georgia, serif",ticks:{stroke:s.line,width:1,size:4},grid:{stroke:s.line,width:.5}},o=[[],[7,3],[2,3],[8,3,2,3]],a=`${e.text}${e.unit?`  (${e.unit})`:""}`,l=new Rn({width:n,height:r0,legend:{show:!1},scales:{x:{time:!1}},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:6},focus:{prox:24}},axes:[{...r,size:30,values:(h,d)=>d.map(f=>Kt(f,6))},{...r,size:62,label:a,labelSize:22,labelFont:"italic 14px 'STIX Two Text', Georgia, serif",values:(h,d)=>d.map(f=>Kt(f,6))}],series:[{},...e.components.map(({label:h},d)=>({label:h,stroke:a0(s,d),width:1.5,dash:o[d%o.length]??[],points:{show:!1}}))],hooks:{draw:[h=>Ed(h,i)]}},l0(i,e),t),c=h=>{let{left:d}=l.over.getBoundingClientRect();i.clock.pause(),i.clock.seek(l.posToVal(h.clientX-d,"x"))};l.over.addEventListener("pointerdown",h=>{l.over.setPointerCapture(h.pointerId),c(h)}),l.over.addEventListener("pointermove",h=>{l.over.hasPointerCapture(h.pointerId)&&c(h)}),l.over.style.touchAction="pan-y";let u=he("div",{class:"lab-plot-now"});return l.over.append(u),Ed(l,i),l}function Ed(i,e){let t=i.over.querySelector(".lab-plot-now");t!==null&&(t.style.transform=`translateX(${i.valToPos(e.clock.time.value,"x").toFixed(2)}px)`)}var l1={play:"M7 4.5v15l12-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",first:"M6 5h2.4v14H6zM19 5v14L9.5 12z",undo:"M9 6V2.5L3 8l6 5.500V10h5a4 4 0 0 1 0 8H8v2.500h6a6.500 6.500 0 0 0 0-14.500z",redo:"M15 6V2.500L21 8l-6 5.500V10h-5a4 4 0 0 0 0 8h6v2.500h-6a6.500 6.500 0 0 1 0-14.500z",whole:"M4 4h6v2.200H6.200V10H4zM14 4h6v6h-2.200V6.200H14zM4 14h2.200v3.800H10V20H4zM17.800 14H20v6h-6v-2.200h3.800z",link:"M10.600 13.400a1 1 0 0 0 1.400 0l4.200-4.200a1.800 1.800 0 0 0-2.600-2.600l-1.700 1.700-1.500-1.500 1.700-1.700a4 4 0 0 1 5.600 5.600l-4.200 4.200a3.100 3.100 0 0 1-4.400 0zM13.400 10.600a1 1 0 0 0-1.400 0l-4.200 4.200a1.800 1.800 0 0 0 2.600 2.600l1.700-1.700 1.500 1.500-1.700 1.700a4 4 0 0 1-5.600-5.600l4.200-4.200a3.100 3.100 0 0 1 4.400 0z",help:"M11 16.500h2.200V19H11zM12.100 5C9.700 5 8 6.500 7.900 8.900h2.300c.1-1.100.8-1.800 1.900-1.800s1.800.7 1.800 1.600c0 .8-.4 1.200-1.300 1.900-1.200.9-1.700 1.700-1.600 3.300v.6h2.200v-.4c0-.9.3-1.300 1.400-2.100 1-.8 1.700-1.700 1.700-3.300C16.300 6.500 14.600 5 12.100 5z"},c0="http://www.w3.org/2000/svg";function u0(i){let e=document.createElementNS(c0,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","lab-icon");let t=document.createElementNS(c0,"path");return t.setAttribute("d",l1[i]),e.append(t),e}function fo(i,e,t){let n=document.createElement("button");return n.type="button",n.className="lab-icon-button",n.title=e,n.setAttribute("aria-label",e),n.append(u0(i)),n.addEventListener("click",t),n}function h0(i,e,t){i.title=t,i.setAttribute("aria-label",t),i.replaceChildren(u0(e))}function d0(i,e){let{clock:t}=i,n=fo("play","Play (space)",()=>t.toggle());n.classList.add("lab-play");let s=fo("first","To the start (Home)",()=>t.seek(0)),r=he("input",{type:"range",min:0,step:"any","aria-label":"Time",class:"lab-scrub"}),o=he("output",{class:"lab-time","aria-live":"off"}),a=he("select",{"aria-label":"Speed",title:"Speed ([ and ])"}),l=fo("undo","Undo (Ctrl+Z)",()=>{i.undo()}),c=fo("redo","Redo (Ctrl+Shift+Z)",()=>{i.redo()}),u=fo("whole","Full screen",e);r.addEventListener("input",()=>{t.pause(),t.seek(Number(r.value))}),a.addEventListener("change",()=>t.speed.value=Number(a.value)),t.speed.watch(g=>{let M=[...new Set([...wr,g])].sort((m,p)=>m-p);a.replaceChildren(...M.map(m=>{let p=he("option",{value:m},`${Kt(m,2)}×`);return p.selected=m===g,p}))}),t.playing.watch(g=>h0(n,g?"pause":"play",g?"Pause (space)":"Play (space)"));let h="s",d=()=>{let g=t.time.value,M=t.until<1?4:t.until<100?2:1;r.max=String(t.until),r.value=String(g),r.style.setProperty("--share",String(t.until>0?g/t.until:0));let m=`${g.toFixed(M)} ${h}`;o.textContent=`t = ${m}`,r.setAttribute("aria-valuetext",`${m} of ${t.until.toFixed(M)} ${h}`)};t.time.watch(d),i.shown.after(d),i.wanted.watch(()=>{l.disabled=!i.history.canUndo,c.disabled=!i.history.canRedo});let f=i.engine===null?null:he("span",{class:"lab-group"},l,c);return he("div",{class:"lab-transport",role:"toolbar","aria-label":"Playback"},s,n,r,o,he("label",{class:"lab-speed"},a),f,u)}function c1(i){return Math.log2(Math.max(1,i)/2)/4}function f0(i){return yf(za,c1(i))}function Td(i){return Number.isFinite(i)?`MEGNO ${Kt(i,3)}${i<2.5?", as on regular motions":i>4?", as on chaotic motions":""}`:"no indicator: the motion ends before"}var ai={left:62,right:14,top:10,bottom:42},nu=class{constructor(e,t,n,s){this.width=e;this.height=t;this.x=n;this.y=s}width;height;x;y;get innerWidth(){return Math.max(1,this.width-ai.left-ai.right)}get innerHeight(){return Math.max(1,this.height-ai.top-ai.bottom)}right(e){let[t,n]=this.x.range;return ai.left+(e-t)/(n-t)*this.innerWidth}down(e){let[t,n]=this.y.range;return ai.top+(n-e)/(n-t)*this.innerHeight}valueX(e){let[t,n]=this.x.range;return t+(e-ai.left)/this.innerWidth*(n-t)}valueY(e){let[t,n]=this.y.range;return n-(e-ai.top)/this.innerHeight*(n-t)}contains(e,t){return e>=ai.left&&e<=this.width-ai.right&&t>=ai.top&&t<=this.height-ai.bottom}};function Rd([i,e],t,n){return[t+(i-t)*n,t+(e-t)*n]}function m0(i,e,t){let{left:n,top:s}=ai,{innerWidth:r,innerHeight:o}=e;i.save(),i.font="13px 'STIX Two Text', 'Palatino Linotype', Georgia, serif",i.lineWidth=1,i.strokeStyle=t.quiet,i.beginPath(),i.moveTo(n-.5,s),i.lineTo(n-.5,s+o+.5),i.lineTo(n+r,s+o+.5),i.stroke(),i.fillStyle=t.ink,i.textAlign="center",i.textBaseline="top";for(let a of bu(...e.x.range,Math.max(2,r/90))){let l=e.right(a);p0(i,l,s+o,0,4),i.fillText(Kt(a,6),l,s+o+6)}i.textAlign="right",i.textBaseline="middle";for(let a of bu(...e.y.range,Math.max(2,o/55))){let l=e.down(a);p0(i,n-4,l,4,0),i.fillText(Kt(a,6),n-7,l)}i.font="italic 15px 'STIX Two Text', 'Palatino Linotype', Georgia, serif",i.textAlign="center",i.textBaseline="bottom",i.fillText(e.x.label,n+r/2,e.height-2),i.translate(14,s+o/2),i.rotate(-Math.PI/2),i.textBaseline="middle",i.fillText(e.y.label,0,0),i.restore()}function p0(i,e,t,n,s){i.beginPath(),i.moveTo(e,t),i.lineTo(e+n,t+s),i.stroke()}var u1=5,iu=class{constructor(e){this.acts=e;this.element=he("div",{class:"lab-sheet",tabindex:0,role:"application","aria-label":e.label},this.base,this.over,this.tip,this.spoken),this.bindPointer(),this.element.addEventListener("keydown",t=>this.key(t)),this.element.addEventListener("blur",()=>{this.cross=null,this.mark()}),new ResizeObserver(()=>this.paint()).observe(this.element),Ar(()=>this.repaint())}acts;element;boxing=!1;base=he("canvas",{"aria-hidden":!0});over=he("canvas",{"aria-hidden":!0});tip=he("div",{class:"lab-tip",hidden:!0,role:"tooltip"});spoken=he("span",{class:"lab-spoken",role:"status","aria-live":"polite"});x={range:[-1,1],label:""};y={range:[-1,1],label:""};cross=null;stroke=null;fingers=new Map;due=!1;get frame(){return new nu(this.element.clientWidth,this.element.clientHeight,this.x,this.y)}get pen(){return this.base.getContext("2d")}get canvas(){return this.base}setAxes(e,t){this.x=e,this.y=t,this.repaint()}setRanges(e,t){this.x={...this.x,range:e},this.y={...this.y,range:t},this.repaint(),this.acts.moved?.()}showAll(){let{x:e,y:t}=this.acts.whole();this.setRanges(e,t)}zoom(e,t=null){let n=t??this.cross??{x:po(this.x.range),y:po(this.y.range)};this.setRanges(Rd(this.x.range,n.x,e),Rd(this.y.range,n.y,e))}repaint(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due=!1,this.paint()}))}mark(){let{ratio:e}=xu(this.over),t=this.over.getContext("2d");if(t===null)return;let{frame:n}=this,s=Tn();if(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,n.width,n.height),this.acts.marks?.(t,n),t.strokeStyle=s.ink,t.lineWidth=1,this.cross!==null){let[r,o]=[n.right(this.cross.x),n.down(this.cross.y)];t.beginPath(),t.moveTo(r-12,o),t.lineTo(r+12,o),t.moveTo(r,o-12),t.lineTo(r,o+12),t.stroke()}if(this.stroke!==null){let{from:r,to:o,box:a}=this.stroke;t.setLineDash([5,3]),t.beginPath(),a?t.rect(r.right,r.down,o.right-r.right,o.down-r.down):(t.moveTo(r.right,r.down),t.lineTo(o.right,o.down)),t.stroke(),t.setLineDash([])}}paint(){if(this.element.clientWidth===0)return;let{ratio:e}=xu(this.base),{pen:t,frame:n}=this;t!==null&&(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,n.width,n.height),this.acts.paint(t,n,e),m0(t,n,Tn()),this.mark())}value(e,t){let{frame:n}=this;return{x:n.valueX(e),y:n.valueY(t)}}bindPointer(){let e=this.element,t=n=>{let{left:s,top:r}=e.getBoundingClientRect();return{right:n.clientX-s,down:n.clientY-r}};e.addEventListener("pointerdown",n=>{let s=t(n);this.frame.contains(s.right,s.down)&&(this.cross=null,this.fingers.set(n.pointerId,s),e.setPointerCapture(n.pointerId),this.fingers.size===1?this.stroke={from:s,to:s,box:this.boxing||n.shiftKey}:this.stroke=null)}),e.addEventListener("pointermove",n=>{let s=t(n);if(this.fingers.get(n.pointerId)===void 0)return this.point(s);if(this.fingers.size===2)return this.pinch(n.pointerId,s);this.fingers.set(n.pointerId,s),this.stroke!==null&&(this.stroke={...this.stroke,to:s}),this.mark()}),e.addEventListener("pointerup",n=>{if(!this.fingers.delete(n.pointerId))return;let{stroke:s}=this;if(this.stroke=null,this.mark(),s===null)return;let r=Math.hypot(s.to.right-s.from.right,s.to.down-s.from.down),[o,a]=[this.value(s.from.right,s.from.down),this.value(s.to.right,s.to.down)];r<u1?this.acts.click(o):s.box||this.acts.drag===void 0?this.setRanges(g0(o.x,a.x),g0(o.y,a.y)):this.acts.drag(o,a)}),e.addEventListener("pointercancel",n=>{this.fingers.delete(n.pointerId),this.stroke=null,this.mark()}),e.addEventListener("pointerleave",()=>this.tip.hidden=!0),e.addEventListener("dblclick",n=>n.preventDefault()),e.addEventListener("wheel",n=>{if(!e.matches(":focus-within")&&!n.ctrlKey)return;n.preventDefault();let{right:s,down:r}=t(n);this.zoom(Math.exp(.0015*n.deltaY),this.value(s,r))},{passive:!1})}pinch(e,t){let n=[...this.fingers].find(([a])=>a!==e)?.[1],s=this.fingers.get(e);if(this.fingers.set(e,t),n===void 0||s===void 0)return;let r=Math.hypot(s.right-n.right,s.down-n.down),o=Math.hypot(t.right-n.right,t.down-n.down);r>0&&o>0&&this.zoom(r/o,this.value(n.right,n.down))}point(e){let{frame:t}=this,n=t.contains(e.right,e.down)?this.acts.hover(this.value(e.right,e.down),t):null;if(this.mark(),this.tip.hidden=n===null,n===null)return;this.tip.textContent=n;let s=Math.min(e.right+14,t.width-this.tip.offsetWidth-4),r=e.down+16+this.tip.offsetHeight>t.height;this.tip.style.transform=`translate(${Math.max(0,s)}px, ${r?e.down-this.tip.offsetHeight-8:e.down+16}px)`}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let[t,n]=[this.x.range[1]-this.x.range[0],this.y.range[1]-this.y.range[0]],s=e.shiftKey?.1:.02,r=(l,c)=>{let u=this.cross??{x:po(this.x.range),y:po(this.y.range)};this.cross={x:u.x+l*s*t,y:u.y+c*s*n},this.spoken.textContent=this.acts.hover(this.cross,this.frame)??"",this.mark()},a={ArrowLeft:()=>r(-1,0),ArrowRight:()=>r(1,0),ArrowUp:()=>r(0,1),ArrowDown:()=>r(0,-1),Enter:()=>this.acts.click(this.cross??{x:po(this.x.range),y:po(this.y.range)}),"+":()=>this.zoom(1/1.3),"=":()=>this.zoom(1/1.3),"-":()=>this.zoom(1.3),0:()=>this.showAll(),...this.acts.keys}[e.key];a!==void 0&&(e.preventDefault(),a())}};function po([i,e]){return(i+e)/2}function g0(i,e){return i<e?[i,e]:[e,i]}function su(i,e){return i.quantities.findIndex(t=>t.name===e)}async function*v0(i,e,t,n,s,r,o,a){let[l,c]=[su(e,n.x),su(e,n.y)],u=e.quantities.length,h=s,d=0;for(let f=0;f<r;){let{on:g,value:M,direction:m}=n,p=await i.section({parameters:t,start:h,on:g,value:M,direction:m,points:Math.min(o,r-f),until:a-d}),v=p.rows.length/p.dimension;if(v>0){let T=await i.quantities(t,p.rows,p.dimension);d+=p.times.at(-1)??0,yield{x:x0(T,u,l,e),y:x0(T,u,c,e),time:d,end:p.end?.reason??null},h=p.rows.slice((v-1)*p.dimension)}if(p.end!==null||v===0){v===0&&(yield{x:new Float64Array(0),y:new Float64Array(0),time:d,end:p.end?.reason??"it does not cross the section"});return}f+=v}}function x0(i,e,t,n){let s=n.quantities[t]?.angle===!0;return Float64Array.from({length:i.length/e},(r,o)=>{let a=i[o*e+t]??NaN;return s?h1(a):a})}function h1(i){let e=Math.round(i/(2*Math.PI));return i-2*Math.PI*e}function y0(i,e,t,n){let s=0;for(let r=1;r<i.length;r++){let o=(i[r-1]??NaN)-e,a=(i[r]??NaN)-e,l=n?Math.floor(a/(2*Math.PI))-Math.floor(o/(2*Math.PI)):0,c=n?Math.sign(l):o<0&&a>=0?1:o>0&&a<=0?-1:0;c!==0&&(t===0||t===c)&&(s+=n?Math.abs(l):1)}return s}function b0(i){let[e,t]=[1/0,-1/0];for(let s=0;s<i.length;s++){let r=i[s]??NaN;r<e&&(e=r),r>t&&(t=r)}if(!(t>e))return e===1/0?0:e;let n=10**Math.floor(Math.log10((t-e)/2));return Number((Math.round((e+t)/2/n)*n).toPrecision(6))}function M0(i,e,t,n,s){let r=null,o=s*s;for(let a of i)for(let l=0;l<a.x.length;l++){let c=e(a.x[l]??NaN)-n.right,u=t(a.y[l]??NaN)-n.down,h=c*c+u*u;h<o&&([o,r]=[h,{orbit:a,index:l}])}return r}function Cd(i,e,t,n){return{...i,x:_0(i.x,e),y:_0(i.y,t),until:n}}function _0(i,e){let t=new Float64Array(i.length+e.length);return t.set(i),t.set(e,i.length),t}var d1=1e3,f1=12;function E0(i){let{engine:e,model:t}=i;return e===null||t.section===null?null:new Id(i,e,{...t.section})}var Id=class{constructor(e,t,n){this.lab=e;this.engine=t;this.chosen=n;this.sheet=new iu({label:"Poincaré section. Arrow keys move a cross, Enter starts an orbit there, plus and minus zoom, 0 shows all.",paint:(s,r,o)=>this.paint(s,r,o),click:s=>{this.start([s])},drag:(s,r)=>{this.start(p1(s,r,f1))},hover:(s,r)=>this.hover(s,r),marks:(s,r)=>this.marks(s,r),whole:()=>this.whole(),keys:{Backspace:()=>this.remove(this.list.at(-1)),Delete:()=>this.remove(this.list.at(-1))}}),this.element=he("div",{},this.tools(),this.sheet.element,this.key,this.entries),e.shown.after(()=>this.follow()),this.axes({x:[-1,1],y:[-1,1]})}lab;engine;chosen;element;sheet;list=[];points=1e3;byIndicator=!1;serial=0;era=0;longest=1/0;placed=!1;current="";hovered=null;visible=!1;value=he("input",{type:"text",inputmode:"decimal",class:"lab-field","aria-label":"Value on the section"});entries=he("div",{class:"lab-orbits",role:"group","aria-label":"Orbits"});key=he("div",{class:"lab-key",hidden:!0});shown(){this.visible=!0,this.follow()}orbits(){return this.list}setting(){return this.chosen}tools(){let{model:e}=this.lab,t=e.quantities.map(h=>({value:h.name,text:w0(h)})),n=e.wasm_tables?.section_quantities??e.quantities.map(({name:h})=>h),s=t.filter(({value:h})=>n.includes(h)),{chosen:r}=this,o=h=>{this.chosen={...this.chosen,...h},this.clear()},{value:a}=this;a.value=String(r.value),a.addEventListener("change",()=>{let h=Number(a.value.replace("−","-"));Number.isFinite(h)?o({value:h}):this.lab.say("The value on the section must be a number.",!0)});let l=[{value:"1",text:"rising"},{value:"-1",text:"falling"},{value:"0",text:"both"}],c=[200,1e3,5e3,2e4].map(h=>({value:String(h),text:String(h)})),u=(h,d,f)=>{let g=he("button",{type:"button",title:d},h);return g.addEventListener("click",f),g};return he("div",{class:"lab-tools",role:"toolbar","aria-label":"Section"},Mr("on",s,r.on,h=>o({on:h})),he("label",{class:"lab-choice"},"=",a),Mr("direction",l,String(r.direction),h=>o({direction:Number(h)})),Mr("across",t,r.x,h=>o({x:h})),Mr("up",t,r.y,h=>o({y:h})),Mr("points",c,String(this.points),h=>this.points=Number(h)),Hs("indicator","Colour orbits by MEGNO, an indicator of chaos",!1,h=>this.colourBy(h)),Hs("box","Drag a box to enlarge it (or Shift and drag)",!1,h=>this.sheet.boxing=h),u("+","Nearer (+)",()=>this.sheet.zoom(1/1.5)),u("−","Farther (−)",()=>this.sheet.zoom(1.5)),u("all","Show all points (0)",()=>this.sheet.showAll()),u("clear","Remove all orbits but that of the scene",()=>this.clear()))}quantity(e){return this.lab.model.quantities.find(t=>t.name===e)}axes({x:e,y:t}){let n=s=>{let r=this.quantity(s);if(r===void 0)return s;let o=vi(r.unit);return`${w0(r)}${o?`  (${o})`:""}`};this.sheet.setAxes({range:e,label:n(this.chosen.x)},{range:t,label:n(this.chosen.y)})}clear(){this.list=[],this.serial=0,this.era+=1,this.current="",this.follow(),this.entries.replaceChildren(),this.sheet.repaint()}follow(){let{state:e,experiment:t}=this.lab.shown.value;if(!this.visible||e===null)return;let n=JSON.stringify([t.parameters,Array.from(e)]);if(n===this.current)return;let s=this.list.some(r=>Pd(r.start,e))&&this.current.startsWith(`[${JSON.stringify(t.parameters)}`);if(this.current=n,s)return this.mark();this.list=[],this.serial=0,this.era+=1,this.open(e)}async open(e){let{era:t}=this,{motion:n,experiment:s}=this.lab.shown.value,{model:r}=this.lab,{states:o}=n;if(o===void 0)return void this.trace(e,!0);let a=su(r,this.chosen.on),l=await this.engine.quantities(s.parameters,o,o.length/n.times.length);if(t!==this.era)return;let c=r.quantities.length,u=Float64Array.from(n.times,(g,M)=>l[M*c+a]??NaN),h=r.quantities[a]?.angle===!0,d=()=>y0(u,this.chosen.value,this.chosen.direction,h);!this.placed&&d()<2&&(this.chosen={...this.chosen,value:b0(u)},this.value.value=String(this.chosen.value)),this.placed=!0;let f=n.times.at(-1)??1;this.longest=50*f*Math.max(this.points,1e3)/Math.max(1,d()),d()===0&&(this.longest=20*f),await this.trace(e,!0)}mark(){this.writeEntries(),this.sheet.mark()}async start(e){let{state:t,experiment:n}=this.lab.shown.value;if(t===null)return;let{era:s}=this,{on:r,value:o,direction:a,x:l,y:c}=this.chosen,u="";for(let h of e){let d=await this.engine.startOnLevel({parameters:n.parameters,reference:t,section:{on:r,value:o,direction:a,x:l,y:c},x:h.x,y:h.y});if(s!==this.era)return;if("message"in d){u=d.message;continue}let f=await this.trace(d.state,!1,h);if(s!==this.era)return;f!==null&&h===e.at(-1)&&this.play(f)}u!==""&&this.lab.say(A0(u),!0)}play(e){let{lab:t}=this,{parameters:n}=t.shown.value.experiment;this.current=JSON.stringify([n,Array.from(e.start)]),t.change({...t.wanted.value,start:{state:Array.from(e.start)}}),t.clock.seek(0),this.mark()}async trace(e,t,n=null){let{era:s}=this,{parameters:r}=this.lab.shown.value.experiment,o={start:e,x:new Float64Array(0),y:new Float64Array(0),number:this.serial,until:0,indicator:null};n!==null&&(o=Cd(o,Float64Array.of(n.x),Float64Array.of(n.y),0)),this.serial+=1,this.list.push(o);try{for await(let a of v0(this.engine,this.lab.model,r,this.chosen,e,this.points,d1,this.longest)){if(s!==this.era)return null;let l=this.list.indexOf(o);if(l<0)return null;let c=o.x.length;o=Cd(o,a.x,a.y,a.time),this.list[l]=o,t&&c===0?this.axes(this.whole()):this.add(o,c),a.end!==null&&a.x.length===0&&this.lab.say(`The motion has no point of this section: ${a.end}.`,!0)}}catch(a){return this.lab.say(A0(a instanceof Error?a.message:String(a)),!0),null}return this.writeEntries(),this.byIndicator&&this.judge(o),o}colourBy(e){this.byIndicator=e,this.key.hidden=!e;let t=he("i",{style:`background:linear-gradient(90deg,${za.join(",")})`});if(this.key.replaceChildren(he("span",{},"MEGNO 2, regular"),t,he("span",{},"32 and more, chaotic")),this.sheet.repaint(),this.writeEntries(),e)for(let n of this.list)this.judge(n)}async judge(e){if(e.indicator!==null||!(e.until>0))return;let{era:t}=this,{parameters:n}=this.lab.shown.value.experiment,s=Math.min(e.until,20*this.lab.model.until),r=await this.engine.indicator({parameters:n,start:e.start,until:s,kind:"megno"}),o=this.list.findIndex(l=>l.number===e.number),a=this.list[o];t!==this.era||a===void 0||(this.list[o]={...a,indicator:r},this.sheet.repaint(),this.writeEntries())}remove(e){this.list=this.list.filter(t=>t!==e),this.sheet.repaint(),this.writeEntries()}colour(e){if(this.byIndicator&&e.indicator!==null)return`rgb(${f0(e.indicator).join()})`;if(this.byIndicator)return Tn().quiet;let{series:t}=Tn();return t[e.number%t.length]??Tn().ink}paint(e,t,n){for(let s of this.list)S0(e,t,s,0,this.colour(s),n)}add(e,t){let{pen:n,frame:s}=this.sheet;n!==null&&S0(n,s,e,t,this.colour(e),Math.min(window.devicePixelRatio||1,2))}whole(){let e=t=>this.quantity(this.chosen[t])?.angle===!0?[-Math.PI,Math.PI]:of(this.list.flatMap(n=>Array.from(n[t])),.12);return{x:e("x"),y:e("y")}}hover(e,t){let n={right:t.right(e.x),down:t.down(e.y)},s=M0(this.list,l=>t.right(l),l=>t.down(l),n,9);if(this.hovered=s?.orbit??null,s===null)return null;let{model:r}=this.lab,o=r.state.slice(0,r.reduced).map(({name:l,mathml:c},u)=>`${So(c||l)} = ${Kt(s.orbit.start[u]??NaN)}`),{indicator:a}=s.orbit;return`starts at ${o.join(", ")}${a===null?"":`; ${Td(a)}`}`}marks(e,t){let n=(o,a)=>{o.x.length!==0&&(e.beginPath(),e.arc(t.right(o.x[0]??NaN),t.down(o.y[0]??NaN),a,0,2*Math.PI),e.stroke())};e.strokeStyle=Tn().ink,e.lineWidth=1.6;let{state:s}=this.lab.shown.value;for(let o of this.list)s!==null&&Pd(o.start,s)&&n(o,5);if(this.hovered===null)return;e.fillStyle=Tn().ink;let{hovered:r}=this;for(let o=0;o<r.x.length;o++){let[a,l]=[t.right(r.x[o]??NaN),t.down(r.y[o]??NaN)];t.contains(a,l)&&e.fillRect(a-1,l-1,2,2)}n(r,5)}writeEntries(){let{state:e}=this.lab.shown.value,t=this.list.slice(-40).map(n=>{let s=`Play orbit ${n.number+1}: ${n.x.length} points${n.indicator===null?"":`, ${Td(n.indicator)}`}`,r=e!==null&&Pd(n.start,e),o=he("button",{type:"button","aria-label":s,title:s,"aria-current":r?"true":null},he("i",{style:`background:${this.colour(n)}`}),String(n.number+1));return o.addEventListener("click",()=>this.play(n)),o});this.entries.replaceChildren(...t)}};function S0(i,e,t,n,s,r){let o=t.x.length>3e3?1.2:1.8,a=Math.max(1,Math.round(o*r))/r;i.fillStyle=s;for(let l=n;l<t.x.length;l++){let[c,u]=[e.right(t.x[l]??NaN),e.down(t.y[l]??NaN)];e.contains(c,u)&&i.fillRect(c-a/2,u-a/2,a,a)}}function p1(i,e,t){return Array.from({length:t},(n,s)=>{let r=s/(t-1);return{x:i.x+r*(e.x-i.x),y:i.y+r*(e.y-i.y)}})}function w0(i){return i.mathml?So(i.mathml):i.name}function Pd(i,e){if(i.length!==e.length)return!1;for(let t=0;t<i.length;t++)if(i[t]!==e[t])return!1;return!0}function A0(i){return i.endsWith(".")?i:`${i}.`}function wa(i){return{async motion(e){let t=await i("motion",e),n=Object.fromEntries(Object.entries(t.columns).map(([s,r])=>[s,ur(r)]));return{...t,columns:n,times:ur(t.times),states:ur(t.states)}},async section(e){let t=await i("section",e);return{...t,rows:ur(t.rows),times:ur(t.times)}},async quantities(e,t,n){return ur(await i("quantities",{parameters:e,rows:t,dimension:n}))},indicator:async e=>R0(await i("indicator",e)),startFrom:async e=>T0(await i("startFrom",e)),startOnLevel:async e=>T0(await i("startOnLevel",e)),bodyMesh:async e=>m1(await i("bodyMesh",{parameters:e}))}}function Sa(i){return ArrayBuffer.isView(i)?Array.from(i):Array.isArray(i)?i.map(Sa):i!==null&&typeof i=="object"?Object.fromEntries(Object.entries(i).map(([e,t])=>[e,Sa(t)])):i}function ur(i){return i instanceof Float64Array?i:Float64Array.from(i??[],R0)}function R0(i){return i??NaN}function m1(i){if(i===null||i.positions instanceof Float32Array)return i;let{positions:e,normals:t,indices:n,tones:s,hollow:r}=i;return{positions:Float32Array.from(e),normals:Float32Array.from(t),indices:Uint32Array.from(n),tones:Uint8Array.from(s),hollow:r}}function T0(i){return"message"in i?i:{state:ur(i.state)}}var C0='"use strict";(()=>{function W(r,t){let n=new Float64Array(3*r.length*t.length),e=0;for(let o=0;o<r.length;o++)for(let s=0;s<t.length;s++){let a=Math.sin(r[o]);n[e++]=a*Math.cos(t[s]),n[e++]=a*Math.sin(t[s]),n[e++]=Math.cos(r[o])}return n}function Y(r,t){let{theta:n,phi:e,hollow:o}=r,s=n.length,a=e.length,i=W(n,e),m=o?1:-1,u=s*a,c=u+2*(a+1),l=new Float32Array(3*c),h=new Float32Array(3*c);for(let f=0;f<3*u;f++)l[f]=t[f],h[f]=m*i[f];let y=[],g=[],b=(f,F,p,w)=>{ft(l,h,f,F,p)||([F,p]=[p,F]),y.push(f,F,p),g.push(w)},A=f=>Math.floor((e[f]+1e-9)/(Math.PI/2));for(let f=0;f+1<s;f++){let F=(n[f]+n[f+1])/2<Math.PI/2?1:0;for(let p=0;p<a;p++){let w=(p+1)%a,v=(A(p)+F)%2;b(f*a+p,f*a+w,(f+1)*a+w,v),b(f*a+p,(f+1)*a+w,(f+1)*a+p,v)}}for(let f of[!0,!1]){let F=(f?0:s-1)*a,p=u+(f?0:a+1),w=p+a,v=m*(f?1:-1);for(let d=0;d<a;d++){for(let M=0;M<3;M++){let E=l[3*(F+d)+M];l[3*(p+d)+M]=E,l[3*w+M]+=E/a}h[3*(p+d)+2]=v}h[3*w+2]=v;for(let d=0;d<a;d++)b(w,p+d,p+(d+1)%a,(A(d)+(f?1:0))%2)}return{positions:l,normals:h,indices:Uint32Array.from(y),tones:Uint8Array.from(g),hollow:o}}function ft(r,t,n,e,o){let s=[0,1,2].map(m=>r[3*e+m]-r[3*n+m]),a=[0,1,2].map(m=>r[3*o+m]-r[3*n+m]),i=0;for(let m=0;m<3;m++){let u=(m+1)%3,c=(m+2)%3,l=t[3*n+m]+t[3*e+m]+t[3*o+m];i+=(s[u]*a[c]-s[c]*a[u])*l}return i>=0}function G({rows:r,misses:t},n){let e=new Float64Array(n),o=[];return r.forEach((s,a)=>{let i=Float64Array.from(s),m=N(s);for(let l=0;l<2;l++)for(let h of o)R(i,h);let u=N(i);if(!(u>1e-9*m))return;for(let l=0;l<n;l++)i[l]/=u;let c=(t[a]-P(s,e))/u;for(let l=0;l<n;l++)e[l]+=c*i[l];o.push(i)}),e}function Z(r){let t=[];for(let n of r){let e=Float64Array.from(n),o=N(n);for(let a=0;a<2;a++)for(let i of t)R(e,i);let s=N(e);s>1e-9*o&&t.push(e.map(a=>a/s))}return t}function R(r,t){let n=P(r,t);for(let e=0;e<r.length;e++)r[e]-=n*t[e]}function P(r,t){let n=0;for(let e=0;e<r.length;e++)n+=r[e]*t[e];return n}function N(r){return Math.sqrt(P(r,r))}var K=1e-12,et=40,ht=1e-15,yt=4,pt=64;function nt(r,{parameters:t,inputs:n}){let{model:e,tables:o}=r,s=r.parameters(t),a=bt(r,s);if(a!==null)return{message:a};let i=Float64Array.from(e.start_inputs,l=>n[l.name]??l.value),m=i.findIndex(l=>!Number.isFinite(l));if(m>=0)return{message:`${e.start_inputs[m].name}: it must be a finite number`};let u;if(o.start===null){let l=dt(r,i,s);if("message"in l)return l;u=l.state}else{let l=o.motion.dimension,h=r.values(o.start,i,s);u=h.slice(0,l);let y=h.slice(l,l+o.excess.length),g=h.slice(l+y.length);for(let[b,{message:A,among:f}]of o.excess.entries()){let F=Math.max(...f.map(p=>Math.abs(i[p])));if(Math.abs(y[b])>K*F){let p=f.map(v=>H(g[v])).join(", ");return{message:A.replace("{excess}",z(y[b])).replace("{nearest}",p),nearest:g}}}if(!u.every(Number.isFinite))return{message:o.singular}}let c=rt(r,u,s);return c===null?{state:u}:{message:c}}function bt(r,t){let{model:n,tables:e}=r,o=t.findIndex(c=>!Number.isFinite(c));if(o>=0){let{name:c}=n.parameters[o];return`${n.name}: ${c} = ${H(t[o])} must be a finite number`}if(e.conditions_on_parameters.length===0)return null;let a=r.values(e.admissible,new Float64Array(e.admissible.inputs),t).findIndex(c=>!(c>0));if(a<0)return null;let{parameter:i,condition:m}=e.conditions_on_parameters[a],u=t[n.parameters.findIndex(c=>c.name===i)];return`${n.name}: ${i} = ${H(u)} is not admissible; ${m} must hold`}function rt(r,t,n){let{tables:e}=r;if(e.start_messages.length===0)return null;let o=Array.from(t).slice(0,e.guards.inputs),s=r.values(e.guards,o,n).findIndex(a=>!(a>0));return s<0?null:e.start_messages[s]}function dt(r,t,n){let{tables:e}=r,o=Float64Array.from(t);for(let{name:h,places:y}of e.directions){let g=Math.hypot(...y.map(b=>o[b]));if(g===0)return{message:`${h}: must not be zero, as it is a direction`};for(let b of y)o[b]/=g}let s=Float64Array.from(o),a=Array.from(s.keys()),i=st(r,s,n,a),m=1+Math.max(0,...o.map(Math.abs)),u=Math.max(0,...s.map((h,y)=>Math.abs(h-o[y])));if(i.done&&u<=K*m)return{state:s};let c=i.misses.reduce((h,y,g)=>Math.abs(y)>Math.abs(i.misses[h])?g:h,0),l=`start: the relation ${e.relation_texts[c]} = 0 is missed by ${z(i.misses[c])}`;return i.done?{message:`${l}; the nearest admissible state is shown`,nearest:s}:{message:l}}function st(r,t,n,e){let{phase_space:o,whole_relations:s}=r.tables,a=null;if(s===0)return{done:!0,misses:[]};let i=t.length;for(let m=0;m<et;m++){let u=r.values(o,t,n),c=Array.from(u.subarray(0,s));if(a??=c,!c.every(Number.isFinite))break;let l=c.map((b,A)=>Float64Array.from(e,f=>u[s+A*i+f])),h=G({rows:l,misses:c.map(b=>-b)},e.length);e.forEach((b,A)=>t[b]+=h[A]);let y=1+Math.max(...t.map(Math.abs));if(Math.max(...h.map(Math.abs))<=ht*y)return{done:gt(u,t,s),misses:a}}return{done:!1,misses:a??[]}}function gt(r,t,n){let e=t.length,o=1+Math.max(...t.map(Math.abs));for(let s=0;s<n;s++){let a=0;for(let i=0;i<e;i++)a+=Math.abs(r[n+s*e+i]);if(!(Math.abs(r[s])<=K*(1+a*o)))return!1}return!0}function ot(r,t){let{model:n,tables:e}=r,{section:o}=t,s=r.parameters(t.parameters),a=e.conditions.inputs,i=n.quantities.map(d=>d.name),m=[o.on,o.x,o.y].map(d=>i.indexOf(d)),u=[o.on,o.x,o.y].find((d,M)=>m[M]<0);if(u!==void 0)return{message:`${u}: no quantity of ${n.name}`};let c=e.relations+e.integrals.length,l=c+i.length,h=[...Array(c).keys(),...m.map(d=>c+d)],y=[...Array(c).fill(!1),...m.map(d=>n.quantities[d].angle)],g=d=>r.values(e.conditions,d,s),b=Float64Array.from(Array.from(t.reference).slice(0,a)),A=g(b),F=[...h.map((d,M)=>M<e.relations?0:A[d]).slice(0,c),o.value??0,t.x,t.y],p=D(r,b),w=(d,M)=>{let E=Float64Array.from(d);for(let T=0;T<et;T++){let L=g(E),O=h.map((x,k)=>tt(M[k],L[x],y[k])),_=h.map(x=>Float64Array.from({length:a},(k,X)=>L[l+x*a+X]*p[X])),I=_.map(x=>Math.sqrt(P(x,x))),$=Math.max(...O.map((x,k)=>Math.abs(x)/(I[k]+1e-300)));if(!Number.isFinite($))return null;if($<1e-14||T>6&&$<1e-12)return E;let j=G({rows:_,misses:O},a),S=Math.max(...j.map(Math.abs)),q=Math.min(1,.5/S);for(let x=0;x<a;x++)E[x]+=q*j[x]*p[x]}return null},v=h.length-1;for(let d=yt;d<=pt;d*=4){let M=b;for(let I=1;I<=d&&M!==null;I++){let $=F.map((j,S)=>{if(S<c||S>v)return j;let q=A[h[S]];return q+I/d*tt(j,q,y[S])});M=w(M,$)}if(M===null)continue;let E=g(M),T=r.values(e.rates,M,s),L=E.subarray(l+h[c]*a,l+(h[c]+1)*a),O=n.direction*P(Float64Array.from(L),T);if(o.direction*n.direction*O<0)continue;let _=rt(r,M,s);return _!==null?{message:_}:At(r,M,t.reference,s)}return{message:`no state on this level was found at ${o.x} = ${z(t.x)}, ${o.y} = ${z(t.y)}`}}function At(r,t,n,e){let{model:o,tables:s}=r,a=s.motion.dimension,i=n.length>=a?n:o.start,m=Float64Array.from({length:a},(c,l)=>l<t.length?t[l]:i[l]),u=Array.from({length:a-t.length},(c,l)=>t.length+l);return u.length>0&&!st(r,m,e,u).done?{message:`${o.name}: no attitude belongs to this state`}:{state:m}}function D(r,t){let n=new Float64Array(r.tables.conditions.inputs).fill(1),e=r.tables.groups.map(s=>Math.hypot(...s.map(a=>t[a]))),o=Math.max(...e);return r.tables.groups.forEach((s,a)=>{let i=e[a]>1e-10*o?e[a]:o>0?o:1;for(let m of s)n[m]=i}),n}function tt(r,t,n){let e=r-t;return n?e-2*Math.PI*Math.round(e/(2*Math.PI)):e}function H(r){return Number.isInteger(r)&&Math.abs(r)<1e16?r.toFixed(1):String(r)}function z(r){return String(Number(r.toPrecision(6)))}var U=200,at=.2,lt=1e-12;function ct(r,t){let{tables:n}=r,e=r.parameters(t.parameters),o=n.tangent.dimension/2,s=Float64Array.from(Array.from(t.start).slice(0,o)),a=Ft(r,s,e,t.until),i=Float64Array.from({length:o},(g,b)=>Math.cos(1+2.7*b)),m=t.kind==="lyapunov";if(J(r,s,e,a,m).length>=o)return NaN;it(i,J(r,s,e,a,m));let u=t.until/U,c=0,l=0,h=0,y=0;for(let g=1;g<=U;g++){let b=[...s,...i.map((F,p)=>F*a[p])],[A]=r.march(n.tangent,b,e,[u],1,lt);if(A.outcome!==0)return NaN;s=A.states.slice(0,o),i=A.states.slice(o).map((F,p)=>F/a[p]);let f=c;c+=Math.log(it(i,J(r,s,e,a,m))),l+=((c+f)/2-l)/g,h+=2*(c-l),g<=at*U&&(y=c)}return t.kind==="megno"?h/U:(c-y)/(t.until*(1-at))}function it(r,t){for(let e=0;e<2;e++)for(let o of t)R(r,o);let n=N(r);for(let e=0;e<r.length;e++)r[e]/=n;return n}function J(r,t,n,e,o){let{conditions:s,relations:a,integrals:i,rates:m}=r.tables,u=a+(o?i.length:0),c=t.length,l=s.outputs/(c+1),h=r.values(s,t,n),y=Array.from({length:u},(g,b)=>Float64Array.from(t,(A,f)=>h[l+b*c+f]*e[f]));return o&&y.push(r.values(m,t,n).map((g,b)=>g/e[b])),Z(y)}function Ft(r,t,n,e){let{tangent:o}=r.tables,s=t.length,a=Array.from({length:32},(c,l)=>(l+1)/320*e),i=[...t,...new Float64Array(s)],[m]=r.march(o,i,n,a,a.length,lt),u=D(r,t);for(let c=0;c<m.count;c++)D(r,m.states.subarray(2*s*c,2*s*c+s)).forEach((h,y)=>u[y]=Math.max(u[y],h));return u}function mt(r){let t=atob(r),n=new Uint8Array(t.length);for(let e=0;e<t.length;e++)n[e]=t.charCodeAt(e);return n}var Mt=65536,wt=10000000n,Q=1024,B=class r{constructor(t,n,e,o){this.model=t;this.tables=n;this.memory=e;this.functions=o}model;tables;memory;functions;at=Q;static async create(t){if(t.wasm===null||t.wasm_tables===null)throw new Error(`${t.title}: this page cannot compute`);let n=new WebAssembly.Memory({initial:16}),e=await WebAssembly.instantiate(mt(t.wasm),{env:{memory:n}});return new r(t,t.wasm_tables,n,e.instance.exports)}parameters(t){let n=new Set(this.model.parameters.map(e=>e.name));for(let e of Object.keys(t))if(!n.has(e)){let o=[...n].join(", ")||"none";throw new RangeError(`${this.model.name}: no parameter ${e}; it has ${o}`)}return Float64Array.from(this.model.parameters,e=>t[e.name]??e.value)}march(t,n,e,o,s,a){let i=n.length/t.dimension;this.at=Q;let m=this.put(n),u=this.put(e),c=this.put(o),l=this.room(i*s*t.dimension),h=this.room(i*s),y=this.room(i),g=this.room(i),b=this.room(i),A=this.room(i),f=this.room(t.work);this.doubles(l,i*s*t.dimension).fill(NaN),this.whole(y,i).fill(0n);let F=this.functions[t.name];return F(0n,BigInt(i),m,u,0n,c,BigInt(s),a,wt,l,h,y,g,b,A,f),Array.from({length:i},(p,w)=>{let v=Number(this.whole(y,i)[w]),d=s*t.dimension;return{states:this.doubles(l+8*w*d,v*t.dimension).slice(),moments:this.doubles(h+8*w*s,v).slice(),count:v,outcome:Number(this.whole(g,i)[w]),ended:this.doubles(b,i)[w],steps:Number(this.whole(A,i)[w])}})}values(t,n,e){let o=n.length/t.inputs;this.at=Q;let s=this.put(n),a=this.put(e),i=this.room(o*t.outputs),m=this.room(t.work);return this.functions[t.name](BigInt(o),s,a,i,m),this.doubles(i,o*t.outputs).slice()}put(t){let n=this.room(Math.max(t.length,1));return this.doubles(n,t.length).set(t),n}room(t){let n=this.at;this.at+=16*Math.ceil(t/2);let e=this.at-this.memory.buffer.byteLength;return e>0&&this.memory.grow(Math.ceil(e/Mt)),n}doubles(t,n){return new Float64Array(this.memory.buffer,t,n)}whole(t,n){return new BigInt64Array(this.memory.buffer,t,n)}};var V=class r{constructor(t,n){this.model=t;this.module=n}model;module;static async create(t){return new r(t,await B.create(t))}async motion({parameters:t,start:n,times:e}){let{model:o,module:s}=this,a=s.tables.motion,i=s.parameters(t),[m]=s.march(a,n,i,e,e.length,o.tolerance),{count:u,states:c}=m,l=s.values(s.tables.columns,c,i),h=s.tables.columns.outputs,y={},g=0;for(let A of o.columns){let f=new Float64Array(u*A.width);for(let F=0;F<u;F++)for(let p=0;p<A.width;p++)f[F*A.width+p]=l[F*h+g+p];y[A.name]=f,g+=A.width}return{times:Float64Array.from({length:u},(A,f)=>o.direction*e[f]),columns:y,states:c,end:this.end(m)}}async section(t){let{model:n,module:e}=this,{section:o,section_quantities:s}=e.tables,a=s.indexOf(t.on);if(a<0)throw new RangeError(`${t.on}: no quantity of a section; they are ${s.join(", ")}`);let i=e.parameters(t.parameters),m=new Float64Array(i.length+2+s.length);m.set(i),m[i.length]=t.value??0,m[i.length+1]=n.direction*t.direction,m[i.length+2+a]=1;let u=Array.from(t.start).slice(0,o.dimension),c=[t.until??1/0],[l]=e.march(o,u,m,c,t.points,n.tolerance),{states:h,moments:y}=l,g=y.map(b=>n.direction*b);return{rows:h,times:g,dimension:o.dimension,end:this.end(l)}}async quantities(t,n,e){let{module:o}=this,s=o.tables.quantities;return o.values(s,xt(n,e,s.inputs),o.parameters(t))}async indicator(t){return ct(this.module,t)}async startFrom(t){return nt(this.module,t)}async startOnLevel(t){return ot(this.module,t)}async bodyMesh(t){let{body:n}=this.model.scene,{contact:e,gamma:o}=this.module.tables;if(n===null||e===null)return null;let s=W(n.theta,n.phi),a=s.length/3,i=new Float64Array(a*e.inputs);for(let c=0;c<a;c++)for(let l=0;l<3;l++)i[c*e.inputs+o+l]=s[3*c+l];let m=this.module.values(e,i,this.module.parameters(t)),u=n.hollow?1:-1;for(let c=0;c<a;c++){let l=u*s[3*c+2];Math.abs(l)>1e-9&&(m[3*c+2]+=n.thickness*Math.sign(l))}return Y(n,m)}end({outcome:t,ended:n}){if(t===0)return null;let e=this.module.tables.reasons[t]??`outcome ${t}`;return{time:this.model.direction*n,reason:e}}};function xt(r,t,n){if(t===n)return r;let e=r.length/t,o=new Float64Array(e*n);for(let s=0;s<e;s++)o.set(r.subarray(s*t,s*t+n),s*n);return o}function ut(r,t,n){switch(t){case"quantities":{let{parameters:e,rows:o,dimension:s}=n;return r.quantities(e,vt(o),s)}case"bodyMesh":return r.bodyMesh(n.parameters);case"motion":case"section":case"indicator":case"startFrom":case"startOnLevel":return r[t](n);default:return Promise.reject(new Error(`There is no method ${t}.`))}}function vt(r){return r instanceof Float64Array?r:Float64Array.from(r??[],Et)}function Et(r){return r??NaN}var C=null;addEventListener("message",({data:r})=>{if(r.model!==void 0){C=V.create(r.model),C.catch(()=>{});return}let{id:t,method:n,argument:e}=r;(async()=>{try{if(C===null)throw new Error("The worker has no model.");postMessage({id:t,value:await ut(await C,n??"",e)})}catch(o){postMessage({id:t,message:o instanceof Error?o.message:String(o)})}})()});})();\n';function P0(i){let e=URL.createObjectURL(new Blob([C0],{type:"text/javascript"})),t=new Worker(e),n=new Map,s=0;return t.addEventListener("message",({data:o})=>{let a=n.get(o.id);n.delete(o.id),o.message!==void 0?a?.reject(new Error(o.message)):a?.resolve(o.value)}),t.addEventListener("error",o=>{for(let{reject:a}of n.values())a(new Error(o.message||"The computation failed."));n.clear()}),t.postMessage({model:{...i,recorded:null,experiment:""}}),{engine:wa((o,a)=>new Promise((l,c)=>{s+=1,n.set(s,{resolve:l,reject:c}),t.postMessage({id:s,method:o,argument:a})})),end(){t.terminate(),URL.revokeObjectURL(e);for(let{reject:o}of n.values())o(new Error("The computation was stopped."));n.clear()}}}function I0(i){let{model:e}=i;return i.kind!=="recorded"&&e.wasm!==null?P0(e).engine:i.kind==="http"?x1(i.address,i.token):i.kind==="widget"?_1(i.channel):null}function x1(i,e){return wa(async(t,n)=>{let s;try{s=await fetch(`${i}/api/${t}`,{method:"POST",headers:{"Content-Type":"application/json","X-Chaplygin-Token":e},body:JSON.stringify(Sa(n))})}catch{throw new Error("The lab does not answer; is it still running?")}return L0(await s.json())})}function L0(i){if(i.message!==void 0&&i.value===void 0)throw new Error(i.message);return i.value}function _1(i){let e=new Map,t=0;return i.on("msg:custom",n=>{let s=n,r=e.get(s.id??-1);e.delete(s.id??-1),r?.(s)}),wa(async(n,s)=>{t+=1;let r=t,o=new Promise(a=>e.set(r,a));return i.send({id:r,method:n,arguments:Sa(s)}),L0(await o)})}var N0='.uplot,.uplot *,.uplot *:before,.uplot *:after{box-sizing:border-box}.uplot{font-family:system-ui,-apple-system,Segoe UI,Roboto,Helvetica Neue,Arial,Noto Sans,sans-serif,"Apple Color Emoji","Segoe UI Emoji",Segoe UI Symbol,"Noto Color Emoji";line-height:1.5;width:min-content}.u-title{text-align:center;font-size:18px;font-weight:700}.u-wrap{position:relative;user-select:none}.u-over,.u-under{position:absolute}.u-under{overflow:hidden}.uplot canvas{display:block;position:relative;width:100%;height:100%}.u-axis{position:absolute}.u-legend{font-size:14px;margin:auto;text-align:center}.u-inline{display:block}.u-inline *{display:inline-block}.u-inline tr{margin-right:16px}.u-legend th{font-weight:600}.u-legend th>*{vertical-align:middle;display:inline-block}.u-legend .u-marker{width:1em;height:1em;margin-right:4px;background-clip:padding-box!important}.u-inline.u-live th:after{content:":";vertical-align:middle}.u-inline:not(.u-live) .u-value{display:none}.u-series>*{padding:4px}.u-series th{cursor:pointer}.u-legend .u-off>*{opacity:.3}.u-select{background:#00000012;position:absolute;pointer-events:none}.u-cursor-x,.u-cursor-y{position:absolute;left:0;top:0;pointer-events:none;will-change:transform}.u-hz .u-cursor-x,.u-vt .u-cursor-y{height:100%;border-right:1px dashed #607D8B}.u-hz .u-cursor-y,.u-vt .u-cursor-x{width:100%;border-bottom:1px dashed #607D8B}.u-cursor-pt{position:absolute;top:0;left:0;border-radius:50%;border:0 solid;pointer-events:none;will-change:transform;background-clip:padding-box!important}.u-axis.u-off,.u-select.u-off,.u-cursor-x.u-off,.u-cursor-y.u-off,.u-cursor-pt.u-off{display:none}.chaplygin-lab{--ink: #1f2730;--quiet: #66727d;--line: #d9dfe4;--faint: #eef1f4;--alarm: #b3475a;--paper: #ffffff;--box: #f6f8f9;--accent: #2f6690;--on-accent: #ffffff;--proven: #237055;--undecided: #8a6114;--thumb: #ffffff;color:var(--ink);font-family:STIX Two Text,"Libertinus Serif",Palatino Linotype,Palatino,Georgia,serif;line-height:1.4;container:lab / inline-size;position:relative}@media screen and (prefers-color-scheme:dark){.chaplygin-lab{--ink: #dde3e8;--quiet: #97a4af;--line: #36414b;--faint: #20282f;--alarm: #e58a99;--paper: #151a1f;--box: #1c2329;--accent: #79aede;--on-accent: #10161b;--proven: #63c39f;--undecided: #dba94a;--thumb: #dde3e8}}.chaplygin-lab *,.chaplygin-lab *:before{box-sizing:border-box}.chaplygin-lab.lab-live>.lab-still{display:none}.lab-root{display:grid;gap:.9rem;grid-template-columns:minmax(0,1fr);background:var(--paper);text-align:left}.lab-root:fullscreen{padding:.8rem;overflow:auto}.lab-root [hidden]{display:none!important}.lab-view{min-width:0}.lab-scene{position:relative;height:clamp(15rem,58cqi,min(64vh,46rem));border-radius:6px;touch-action:none;cursor:grab;user-select:none;-webkit-user-select:none;overflow:hidden}.lab-scene:active{cursor:grabbing}.lab-canvas{display:block;width:100%;height:100%}.lab-legend,.lab-note,.lab-timebar{position:absolute;font-size:.86rem;color:var(--quiet);pointer-events:none}.lab-legend{top:.3rem;left:.5rem;color:var(--ink);display:grid;gap:.1rem}.lab-legend div{display:flex;gap:.45rem;align-items:center}.lab-arrow{width:1.3rem;height:3px;border-radius:2px}.lab-note{right:.6rem;bottom:.3rem}.lab-timebar{left:.5rem;bottom:.3rem;display:flex;gap:.45rem;align-items:center}.lab-timebar i{width:clamp(4rem,16cqi,11rem);height:.5rem;border-radius:1px}.lab-number{font-variant-numeric:tabular-nums;white-space:nowrap}.lab-root button,.lab-root select,.lab-root input[type=text]{font:inherit;font-size:.9rem;color:var(--ink);background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.24rem .55rem;min-height:2rem}.lab-root button{cursor:pointer}.lab-root button:hover:not(:disabled){background:var(--box);border-color:var(--quiet)}.lab-root button:disabled{color:var(--quiet);opacity:.55;cursor:default}.lab-root button[aria-pressed=true],.lab-root button[aria-pressed=true]:hover{background:var(--accent);color:var(--on-accent);border-color:var(--accent)}.lab-root :focus-visible{outline:2.5px solid var(--accent);outline-offset:2px}.lab-scene:focus-visible{outline-offset:-2px}.lab-icon{width:1.15rem;height:1.15rem;fill:currentColor;display:block}.lab-root .lab-icon-button{padding:.35rem;display:inline-grid;place-items:center;min-width:2.1rem}.lab-root .lab-play{background:var(--accent);color:var(--on-accent);border-color:var(--accent);min-width:2.8rem}.lab-root .lab-play:hover:not(:disabled){background:var(--accent);filter:brightness(1.1)}.lab-transport{display:flex;align-items:center;gap:.5rem;padding:.45rem 0}.lab-group{display:inline-flex;gap:.3rem}.lab-time{font-variant-numeric:tabular-nums;white-space:nowrap;min-width:5.6em;font-size:.95rem}.lab-switches,.lab-chips,.lab-tools{display:flex;flex-wrap:wrap;gap:.35rem}.lab-switches button,.lab-chips button{border-radius:1rem;padding:.12rem .7rem}.lab-message{min-height:1.4em;margin:.35rem 0 0;color:var(--quiet);font-size:.92rem}.lab-message:empty{visibility:hidden}.lab-refused{color:var(--alarm)}.lab-hint{color:var(--quiet);font-size:.88rem;margin:.3rem 0}.lab-root input[type=range]{appearance:none;-webkit-appearance:none;background:none;flex:1;min-width:3rem;height:2rem;margin:0;cursor:pointer;accent-color:var(--accent)}.lab-root input[type=range]::-webkit-slider-runnable-track{height:4px;border-radius:2px;background:linear-gradient(90deg,var(--accent) calc(100% * var(--share, 0)),var(--line) 0)}.lab-root input[type=range]::-moz-range-track{height:4px;border-radius:2px;background:var(--line)}.lab-root input[type=range]::-moz-range-progress{height:4px;border-radius:2px;background:var(--accent)}.lab-root input[type=range]::-webkit-slider-thumb{-webkit-appearance:none;width:1.05rem;height:1.05rem;border-radius:50%;margin-top:calc(2px - .525rem);background:var(--thumb);border:2px solid var(--accent)}.lab-root input[type=range]::-moz-range-thumb{width:.85rem;height:.85rem;border-radius:50%;background:var(--thumb);border:2px solid var(--accent)}.lab-sliders{display:grid;gap:.4rem 2rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,19rem),1fr));align-items:start}.lab-sliders fieldset{border:0;padding:0;margin:0;min-width:0}.lab-sliders legend{padding:0;color:var(--quiet);font-size:.88rem}.lab-slider{display:grid;grid-template-columns:3.2rem minmax(0,1fr) auto;gap:.5rem;align-items:center}.lab-symbol{white-space:nowrap;overflow:hidden;text-overflow:ellipsis}.lab-value{display:inline-flex;align-items:baseline;gap:.3rem;min-width:9.3rem}.lab-root .lab-field{width:5.6rem;padding:.1rem .35rem;min-height:1.7rem;font-variant-numeric:tabular-nums;text-align:right}.lab-root .lab-field[aria-invalid=true]{border-color:var(--alarm)}.lab-unit{color:var(--quiet);font-size:.84rem;white-space:nowrap}.lab-deck{min-width:0}.lab-tabs{display:flex;gap:.2rem;border-bottom:1px solid var(--line);margin-bottom:.6rem;overflow-x:auto;scrollbar-width:none}.lab-root .lab-tabs button{border:0;border-bottom:3px solid transparent;border-radius:0;background:none;color:var(--quiet);padding:.3rem .6rem;white-space:nowrap;font-size:.98rem}.lab-root .lab-tabs button[aria-selected=true]{color:var(--ink);border-bottom-color:var(--accent)}.lab-root .lab-tabs :focus-visible{outline-offset:-3px}.lab-laws{list-style:none;margin:0;padding:0;display:grid;gap:.7rem 2rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,24rem),1fr))}.lab-laws p{margin:0}.lab-law-head{display:flex;flex-wrap:wrap;gap:.1rem .8rem;align-items:baseline}.lab-law-head strong{font-weight:600}.lab-source{color:var(--quiet);font-size:.86rem}.lab-verdict{white-space:nowrap;color:var(--quiet)}.lab-proven{color:var(--proven)}.lab-refuted{color:var(--alarm)}.lab-undecided{color:var(--undecided)}.lab-formula{overflow:auto hidden;padding:.15rem 0}.lab-law-numbers{color:var(--quiet);font-size:.9rem;display:flex;flex-wrap:wrap;gap:0 1.2rem}.lab-law-numbers .lab-number{color:var(--ink)}.lab-keys{border-collapse:collapse;font-size:.92rem}.lab-keys th{text-align:left;font-weight:400;padding:.12rem 1.2rem .12rem 0;white-space:nowrap}.lab-keys td{padding:.12rem 0}.lab-root kbd{font:inherit;font-variant-numeric:tabular-nums}.lab-plots{display:grid;gap:.4rem;margin-top:.5rem}.lab-plot{margin:0;min-width:0}.lab-plot-now{position:absolute;top:0;bottom:0;left:0;width:1.5px;margin-left:-.75px;background:var(--ink);opacity:.7;pointer-events:none}.lab-root .uplot{font-family:inherit}.lab-curves{display:flex;flex-wrap:wrap;gap:0 1.2rem;padding-left:62px;font-size:.88rem}.lab-curves span{white-space:nowrap}.lab-curves>span{min-width:7.2em}.lab-curves i{display:inline-block;width:1.4rem;vertical-align:middle;margin-right:.4rem}.lab-choice{display:inline-flex;align-items:center;gap:.35rem;font-size:.9rem;color:var(--quiet)}.lab-tools{align-items:center;gap:.4rem .8rem;margin-bottom:.5rem}.lab-sheet{position:relative;width:100%;height:clamp(17rem,76cqi,min(70vh,44rem));touch-action:none;cursor:crosshair}.lab-sheet canvas{position:absolute;inset:0;width:100%;height:100%;display:block}.lab-tip{position:absolute;z-index:2;pointer-events:none;background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.25rem .5rem;font-size:.84rem;max-width:17rem;box-shadow:0 2px 8px #0002}.lab-progress{width:8rem;accent-color:var(--accent)}.lab-key{display:flex;align-items:center;gap:.5rem;font-size:.86rem;color:var(--quiet);margin-top:.3rem}.lab-key i{flex:0 1 12rem;height:.55rem;border-radius:1px}@container lab (max-width: 560px){.lab-transport{flex-wrap:wrap}.lab-transport .lab-scrub{order:-1;flex-basis:100%}.lab-time{flex:1;text-align:center}.lab-switches{flex-wrap:nowrap;overflow-x:auto;scrollbar-width:none;padding-bottom:.2rem}.lab-switches button{flex:none}.lab-root .lab-icon-button{min-width:2.6rem;min-height:2.6rem}.lab-value{min-width:8.4rem}.lab-slider{grid-template-columns:2.6rem minmax(0,1fr) auto}.lab-curves{padding-left:0}}@container lab (min-width: 1100px){.lab-root{grid-template-columns:minmax(0,1.25fr) minmax(0,1fr);gap:1rem 1.6rem;align-items:start}.lab-scene{height:clamp(20rem,34cqi,72vh)}.lab-root>.lab-deck:last-child{grid-column:2;grid-row:1 / span 2}.lab-sheet{height:clamp(20rem,34cqi,72vh)}}@container lab (min-width: 2200px){.lab-root{font-size:1.35rem;grid-template-columns:minmax(0,1.5fr) minmax(0,1fr)}}@media(prefers-reduced-motion:reduce){.lab-root *{transition:none!important;animation:none!important}}@media print{.chaplygin-lab.lab-live>.lab-still{display:block}.lab-root{display:none}.chaplygin-lab:not(:has(>.lab-still))>.lab-root{display:block}.chaplygin-lab:not(:has(>.lab-still)) .lab-root>:not(.lab-view),.lab-transport,.lab-switches,.lab-message{display:none}}.lab-orbits{display:flex;flex-wrap:wrap;gap:.25rem;margin-top:.4rem}.lab-root .lab-orbits button{padding:0 .45rem;min-height:1.6rem;font-size:.82rem;display:inline-flex;gap:.3rem;align-items:center;border-radius:1rem}.lab-orbits i{width:.65rem;height:.65rem;border-radius:50%}.lab-root .lab-orbits button[aria-current=true]{border-color:var(--ink);box-shadow:inset 0 0 0 1px var(--ink)}.lab-spoken{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}';function D0(i){let e=i.getRootNode(),t=e instanceof ShadowRoot?e:document.head;if(t.querySelector("style[data-chaplygin-lab]")!==null)return;let n=document.createElement("style");n.dataset.chaplyginLab="",n.textContent=N0,t.append(n)}function ru(i,e){D0(i);let t=he("div",{class:"lab-root"});i.append(t);let n=null,s=y1(e).then(o=>{n=o,b1(i,t,o)});s.catch(o=>{t.replaceChildren(he("p",{class:"lab-message lab-refused",role:"alert"},o instanceof Error?o.message:String(o)))});let r=M1(s,()=>n);return window.chaplygin=r,r}async function y1(i){let{model:e}=i,t=I0(i),n=t===null?null:jd(location.hash,e),s=n?.experiment??Ws(e),r="";n===null&&location.hash.startsWith("#lab&")&&(r="The address asks for values that this system does not have; the page shows its own start.");let o;if(n===null&&e.recorded!==null?o={experiment:s,motion:wu(e),state:Float64Array.from(e.start),surface:Ba(e)}:o=await ka(e,t,s),typeof o=="string"){r=o;let l=await ka(e,t,Ws(e));if(typeof l=="string")throw new Error(l);o=l}let a=new Oa(e,t,o);return r!==""&&a.say(r,!0),a}function b1(i,e,t){let n=Am(t),s=i.querySelector(".lab-still");n!==null&&i.classList.add("lab-live");let r=()=>{document.fullscreenElement!==null?document.exitFullscreen():e.requestFullscreen().catch(()=>t.say("This browser shows no full screen here.",!0))},o=he("p",{class:"lab-message",role:"status","aria-live":"polite"});t.message.watch(m=>{o.textContent=m,o.classList.toggle("lab-refused",t.refused.value)});let a=n?.stage??null,l=Cm(t),u=[{name:"plots",title:"Over time",content:o0(t).element}],h=E0(t);h!==null&&u.push({name:"section",title:"Section",content:h.element,shown:()=>h.shown()});let d=[],f=uf(t);f!==null&&d.push({name:"experiment",title:"Start and parameters",content:f});let g=xf(t);g!==null&&d.push({name:"laws",title:"Laws",content:g}),d.push({name:"keys",title:"Keys",content:Rm()});let M=he("div",{class:"lab-view"},n?.element??null,d0(t,r),n?.switches??null,o);e.append(M,$h("Values",d).element,$h("Pictures",u).element),e.addEventListener("keydown",m=>{!(m.ctrlKey||m.metaKey)||m.key.toLowerCase()!=="z"||(m.preventDefault(),m.shiftKey?t.redo():t.undo())}),n===null&&s===null&&e.classList.add("lab-without-scene")}function M1(i,e){let t=()=>{let n=e();if(n===null)throw new Error("The page is not ready yet: wait for chaplygin.ready.");return n};return{ready:i,seek(n){t().clock.pause(),t().clock.seek(n)},pose:()=>wo(t().shown.value.motion,t().clock.time.value),async set({parameters:n,start:s}){let r=t(),o=r.wanted.value,a={...o,parameters:{...o.parameters,...n}};if(Array.isArray(s)?a.start={state:s}:s!==void 0&&(a.start={inputs:{..."inputs"in o.start?o.start.inputs:{},...s}}),!await r.change(a)&&r.refused.value)throw new Error(r.message.value)},async motion(n,s){let r=t(),{motion:o,state:a,experiment:l}=r.shown.value;if(r.engine===null||a===null)return F0(o.times,o.columns);let c={parameters:l.parameters,start:a,times:Pa(n,s)},u=await r.engine.motion(c);return F0(u.times,u.columns)},async section(n){let s=t(),{state:r,experiment:o}=s.shown.value;if(s.engine===null||r===null)throw new Error("This page shows a recorded motion and cannot compute a section.");let{rows:a,dimension:l}=await s.engine.section({parameters:o.parameters,start:r,...n});return Array.from({length:a.length/l},(c,u)=>Array.from(a.subarray(u*l,(u+1)*l)))},laws:()=>mf(t(),t().clock.time.value)}}function F0(i,e){let t=Object.entries(e).map(([n,s])=>[n,Array.from(s)]);return{time:Array.from(i),...Object.fromEntries(t)}}function S1(){for(let i of document.querySelectorAll(".chaplygin-lab")){let e=i.querySelector("script[type='application/json']");if(e===null||i.querySelector(".lab-root")!==null)continue;let t=JSON.parse(e.textContent??"");ru(i,w1(i,t))}}function w1(i,e){let{address:t,token:n}=i.dataset;return t!==void 0?{kind:"http",model:e,address:t,token:n??""}:{kind:e.wasm===null?"recorded":"wasm",model:e}}function A1({model:i,el:e}){let t=i.get("page");ru(e,{kind:"widget",model:typeof t=="string"?JSON.parse(t):t,channel:i})}return Q0(E1);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
