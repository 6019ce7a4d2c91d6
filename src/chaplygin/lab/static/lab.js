"use strict";var ChaplyginLab=(()=>{var td=Object.defineProperty;var Qb=Object.getOwnPropertyDescriptor;var ev=Object.getOwnPropertyNames;var tv=Object.prototype.hasOwnProperty;var nv=(n,e)=>{for(var t in e)td(n,t,{get:e[t],enumerable:!0})},iv=(n,e,t,i)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of ev(e))!tv.call(n,r)&&r!==t&&td(n,r,{get:()=>e[r],enumerable:!(i=Qb(e,r))||i.enumerable});return n};var rv=n=>iv(td({},"__esModule",{value:!0}),n);var O2={};nv(O2,{mount:()=>zb});function se(n,e={},...t){let i=document.createElement(n);for(let[r,s]of Object.entries(e))s===null||s===!1||i.setAttribute(r,s===!0?"":String(s));return i.append(...t.filter(r=>r!==null)),i}function Ls(n,e,t,i){let r=se("button",{type:"button","aria-label":e,title:e,"aria-pressed":String(t)},n);return r.addEventListener("click",()=>{let s=r.getAttribute("aria-pressed")!=="true";r.setAttribute("aria-pressed",String(s)),i(s)}),r}function or(n,e,t,i){let r=se("select",{"aria-label":n});for(let{value:s,text:o}of e){let a=se("option",{value:s},o);a.selected=s===t,r.append(a)}return r.addEventListener("change",()=>i(r.value)),se("label",{class:"lab-choice"},se("span",{},n),r)}function Pa(n,e){let t=URL.createObjectURL(e),i=se("a",{href:t,download:n});document.body.append(i),i.click(),i.remove(),setTimeout(()=>URL.revokeObjectURL(t),1e4)}function nd(n){let e=Math.min(window.devicePixelRatio||1,2),t=Math.max(1,Math.round(n.clientWidth*e)),i=Math.max(1,Math.round(n.clientHeight*e));return(n.width!==t||n.height!==i)&&(n.width=t,n.height=i),{width:t,height:i,ratio:e}}var sv="http://www.w3.org/1998/Math/MathML";function rs(n){let t=new DOMParser().parseFromString(n,"text/html").querySelector("math");return t===null?document.createTextNode(n):(Am(t),document.importNode(t,!0))}function si(n){let e=new DOMParser().parseFromString(n,"text/html");return Sm(e.querySelector("math")??e.body).trim()||n}function Sm(n){let e=[...n.children].map(Sm),[t="",i="",r=""]=e;switch(n.localName){case"msub":return t+Ql(i,vm);case"msup":return t+Ql(i,wm);case"msubsup":return t+Ql(i,vm)+Ql(r,wm);case"mfrac":return`${t}/${i}`;default:return e.length>0?e.join(""):n.textContent??""}}var ov="0123456789",vm="₀₁₂₃₄₅₆₇₈₉",wm="⁰¹²³⁴⁵⁶⁷⁸⁹";function Ql(n,e){return[...n].map(t=>e[ov.indexOf(t)]??t).join("")}function Am(n){for(let{name:e}of[...n.attributes])(e.startsWith("on")||e==="href")&&n.removeAttribute(e);for(let e of[...n.children])e.namespaceURI===sv?Am(e):e.remove()}var av="⁰¹²³⁴⁵⁶⁷⁸⁹";function St(n,e=4){if(Number.isNaN(n))return"–";if(!Number.isFinite(n))return n>0?"∞":"−∞";if(n===0)return"0";let t=Math.abs(n);if(t>=.001&&t<1e5)return Mm(n.toPrecision(e)).replace("-","−");let[i="",r="0"]=n.toExponential(e-1).split("e"),s=Mm(i).replace("-","−"),o=Number(r),a=o<0?"⁻":"",l=[...String(Math.abs(o))].map(c=>av[Number(c)]).join("");return`${s}·10${a}${l}`}function Mm(n){let e=n.includes("e")?String(Number(n)):n;return e.includes(".")?e.replace(/\.?0+$/,""):e}function ec(n){let e=10**Math.floor(Math.log10(n));return([5,2,1].find(i=>i*e<=n*(1+1e-9))??1)*e}function Lr(n,e=.05){let t=1/0,i=-1/0;for(let o of n)Number.isFinite(o)&&(o<t&&(t=o),o>i&&(i=o));if(t>i)return[-1,1];let r=Math.max(Math.abs(t),Math.abs(i));if(i-t<=1e-9*r||i===t){let o=r>0?.1*r:1;return[t-o,i+o]}let s=e*(i-t);return[t-s,i+s]}function xo(n,e,t){let i=(e-n)/Math.max(1,t);if(!(i>0))return[n];let r=ec(i);for(;(e-n)/r>1.35*t;)r=ec(2.5*r);let s=Math.ceil(n/r-1e-9),o=Math.floor(e/r+1e-9);return Array.from({length:o-s+1},(a,l)=>Number(((s+l)*r).toPrecision(12)))}var Tm={dark:!1,ink:"#1f2730",quiet:"#66727d",line:"#d9dfe4",paper:"#ffffff",alarm:"#bb5566",time:["#f6c667","#ec8f4d","#cf4f5b","#8a2a75","#3b1a68"],body:["#f4f1ea","#5b86ad"],shell:["#f0ece2","#a9bfd3"],seam:"#3d5a76",ground:["#f4f7fa","#b3bfcb"],grid:"#aab6c2",shadow:.34,components:["#004488","#bb5566","#d9a521"],series:["#332288","#cc6677","#117733","#ddaa33","#88ccee","#aa4499","#999933","#44aa99"]},lv={dark:!0,ink:"#dde3e8",quiet:"#97a4af",line:"#36414b",paper:"#151a1f",alarm:"#e58a99",time:["#f8d98c","#f2a65a","#e66f79","#b873d6","#8fa8ff"],body:["#f4f1ea","#5b86ad"],shell:["#dcd9d0","#8fa9c2"],seam:"#25394d",ground:["#5b6773","#2c353e"],grid:"#56636f",shadow:.6,components:["#6ea8e6","#e58a99","#e6bd52"],series:["#a497f3","#e58a99","#58b97b","#e6bd52","#88ccee","#d582c8","#c3c35c","#5cc4b2"]},Em=()=>typeof matchMedia=="function"?matchMedia("(prefers-color-scheme: dark)"):null;function Qt(){return Em()?.matches?lv:Tm}var bn=Tm;function yo(n){Em()?.addEventListener("change",n)}function tc(n){let e=Number.parseInt(n.slice(1),16);return[e>>16&255,e>>8&255,e&255]}function nc(n,e){let t=n.length-1,i=Math.min(Math.max(e,0),1)*t,r=Math.min(Math.floor(i),t-1),[s,o]=[tc(n[r]??"#000000"),tc(n[r+1]??"#000000")],a=i-r;return[0,1,2].map(l=>Math.round((s[l]??0)+a*((o[l]??0)-(s[l]??0))))}function Fs(){return Qt().dark?cv:uv}var cv=["#4f7cc4","#6a7fae","#7f8592","#93907f","#a99d74","#c3b369","#e1cc55","#fee838"],uv=["#00224e","#123570","#3b496c","#575d6d","#707173","#8a8678","#a59c74","#c3b369","#e1cc55","#fee838"];var hv={"-":"⁻",0:"⁰",1:"¹",2:"²",3:"³",4:"⁴",5:"⁵",6:"⁶",7:"⁷",8:"⁸",9:"⁹"};function Wn(n){return n==="1"||n==="unknown"?"":n.replace(/(?:\*\*|\^)\{?(-?\d+)\}?/g,(t,i)=>[...i].map(r=>hv[r]??r).join("")).replaceAll("*"," ").trim()}var ss="'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif";function ar(){return Number.parseFloat(getComputedStyle(document.documentElement).fontSize)||16}var dv={left:3.8,right:.9,top:.6,bottom:2.6},ic=class{constructor(e,t,i,r,s=16){this.width=e;this.height=t;this.x=i;this.y=r;this.letter=s;let{left:o,right:a,top:l,bottom:c}=dv;this.margin={left:o*s,right:a*s,top:l*s,bottom:c*s}}width;height;x;y;letter;margin;get innerWidth(){return Math.max(1,this.width-this.margin.left-this.margin.right)}get innerHeight(){return Math.max(1,this.height-this.margin.top-this.margin.bottom)}right(e){let[t,i]=this.x.range;return this.margin.left+(e-t)/(i-t)*this.innerWidth}down(e){let[t,i]=this.y.range;return this.margin.top+(i-e)/(i-t)*this.innerHeight}valueX(e){let[t,i]=this.x.range;return t+(e-this.margin.left)/this.innerWidth*(i-t)}valueY(e){let[t,i]=this.y.range;return i-(e-this.margin.top)/this.innerHeight*(i-t)}contains(e,t){return e>=this.margin.left&&e<=this.width-this.margin.right&&t>=this.margin.top&&t<=this.height-this.margin.bottom}};function id([n,e],t,i){return[t+(n-t)*i,t+(e-t)*i]}function Rm(n,e,t){let{margin:{left:i,top:r},letter:s}=e,{innerWidth:o,innerHeight:a}=e;n.save(),n.font=`${.8*s}px ${ss}`,n.lineWidth=1,n.strokeStyle=t.quiet,n.beginPath(),n.moveTo(i-.5,r),n.lineTo(i-.5,r+a+.5),n.lineTo(i+o,r+a+.5),n.stroke(),n.fillStyle=t.ink,n.textAlign="center",n.textBaseline="top";for(let l of xo(...e.x.range,Math.max(2,o/(5.6*s)))){let c=e.right(l);Cm(n,c,r+a,0,4),n.fillText(St(l,6),c,r+a+6)}n.textAlign="right",n.textBaseline="middle";for(let l of xo(...e.y.range,Math.max(2,a/(3.4*s)))){let c=e.down(l);Cm(n,i-4,c,4,0),n.fillText(St(l,6),i-7,c)}n.font=`italic ${.92*s}px ${ss}`,n.textAlign="center",n.textBaseline="bottom",n.fillText(e.x.label,i+o/2,e.height-2),n.translate(.85*s,r+a/2),n.rotate(-Math.PI/2),n.textBaseline="middle",n.fillText(e.y.label,0,0),n.restore()}function Cm(n,e,t,i,r){n.beginPath(),n.moveTo(e,t),n.lineTo(e+i,t+r),n.stroke()}var fv=5,os=class{constructor(e){this.acts=e;this.element=se("div",{class:"lab-sheet",tabindex:0,role:"application","aria-label":e.label},this.base,this.over,this.tip,this.spoken),this.bindPointer(),this.element.addEventListener("keydown",t=>this.key(t)),this.element.addEventListener("blur",()=>{this.cross=null,this.mark()}),new ResizeObserver(()=>this.paint()).observe(this.element),yo(()=>this.repaint())}acts;element;boxing=!1;base=se("canvas",{"aria-hidden":!0});over=se("canvas",{"aria-hidden":!0});tip=se("div",{class:"lab-tip",hidden:!0,role:"tooltip"});spoken=se("span",{class:"lab-spoken",role:"status","aria-live":"polite"});x={range:[-1,1],label:""};y={range:[-1,1],label:""};cross=null;stroke=null;fingers=new Map;due=!1;get frame(){return new ic(this.element.clientWidth,this.element.clientHeight,this.x,this.y,ar())}get pen(){return this.base.getContext("2d")}get canvas(){return this.base}setAxes(e,t){this.x=e,this.y=t,this.repaint()}setRanges(e,t){this.x={...this.x,range:e},this.y={...this.y,range:t},this.repaint(),this.acts.moved?.()}showAll(){let{x:e,y:t}=this.acts.whole();this.setRanges(e,t)}zoom(e,t=null){let i=t??this.cross??{x:_o(this.x.range),y:_o(this.y.range)};this.setRanges(id(this.x.range,i.x,e),id(this.y.range,i.y,e))}repaint(){this.due||(this.due=!0,requestAnimationFrame(()=>{this.due=!1,this.paint()}))}mark(){let{ratio:e}=nd(this.over),t=this.over.getContext("2d");if(t===null)return;let{frame:i}=this,r=Qt();if(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,i.width,i.height),this.acts.marks?.(t,i),t.strokeStyle=r.ink,t.lineWidth=1,this.cross!==null){let[s,o]=[i.right(this.cross.x),i.down(this.cross.y)];t.beginPath(),t.moveTo(s-12,o),t.lineTo(s+12,o),t.moveTo(s,o-12),t.lineTo(s,o+12),t.stroke()}if(this.stroke!==null){let{from:s,to:o,box:a}=this.stroke;t.setLineDash([5,3]),t.beginPath(),a?t.rect(s.right,s.down,o.right-s.right,o.down-s.down):(t.moveTo(s.right,s.down),t.lineTo(o.right,o.down)),t.stroke(),t.setLineDash([])}}paint(){if(this.element.clientWidth===0)return;let{ratio:e}=nd(this.base),{pen:t,frame:i}=this;t!==null&&(t.setTransform(e,0,0,e,0,0),t.clearRect(0,0,i.width,i.height),this.acts.paint(t,i,e),Rm(t,i,Qt()),this.mark())}value(e,t){let{frame:i}=this;return{x:i.valueX(e),y:i.valueY(t)}}bindPointer(){let e=this.element,t=i=>{let{left:r,top:s}=e.getBoundingClientRect();return{right:i.clientX-r,down:i.clientY-s}};e.addEventListener("pointerdown",i=>{let r=t(i);this.frame.contains(r.right,r.down)&&(this.cross=null,this.fingers.set(i.pointerId,r),e.setPointerCapture(i.pointerId),this.fingers.size===1?this.stroke={from:r,to:r,box:this.boxing||i.shiftKey}:this.stroke=null)}),e.addEventListener("pointermove",i=>{let r=t(i);if(this.fingers.get(i.pointerId)===void 0)return this.point(r);if(this.fingers.size===2)return this.pinch(i.pointerId,r);this.fingers.set(i.pointerId,r),this.stroke!==null&&(this.stroke={...this.stroke,to:r}),this.mark()}),e.addEventListener("pointerup",i=>{if(!this.fingers.delete(i.pointerId))return;let{stroke:r}=this;if(this.stroke=null,this.mark(),r===null)return;let s=Math.hypot(r.to.right-r.from.right,r.to.down-r.from.down),[o,a]=[this.value(r.from.right,r.from.down),this.value(r.to.right,r.to.down)];s<fv?this.acts.click(o):r.box||this.acts.drag===void 0?this.setRanges(Pm(o.x,a.x),Pm(o.y,a.y)):this.acts.drag(o,a)}),e.addEventListener("pointercancel",i=>{this.fingers.delete(i.pointerId),this.stroke=null,this.mark()}),e.addEventListener("pointerleave",()=>this.tip.hidden=!0),e.addEventListener("dblclick",i=>i.preventDefault()),e.addEventListener("wheel",i=>{if(!e.matches(":focus-within")&&!i.ctrlKey)return;i.preventDefault();let{right:r,down:s}=t(i);this.zoom(Math.exp(.0015*i.deltaY),this.value(r,s))},{passive:!1})}pinch(e,t){let i=[...this.fingers].find(([a])=>a!==e)?.[1],r=this.fingers.get(e);if(this.fingers.set(e,t),i===void 0||r===void 0)return;let s=Math.hypot(r.right-i.right,r.down-i.down),o=Math.hypot(t.right-i.right,t.down-i.down);s>0&&o>0&&this.zoom(s/o,this.value(i.right,i.down))}point(e){let{frame:t}=this,i=t.contains(e.right,e.down)?this.acts.hover(this.value(e.right,e.down),t):null;if(this.mark(),this.tip.hidden=i===null,i===null)return;this.tip.textContent=i;let r=Math.min(e.right+14,t.width-this.tip.offsetWidth-4),s=e.down+16+this.tip.offsetHeight>t.height;this.tip.style.transform=`translate(${Math.max(0,r)}px, ${s?e.down-this.tip.offsetHeight-8:e.down+16}px)`}key(e){if(e.ctrlKey||e.metaKey||e.altKey)return;let[t,i]=[this.x.range[1]-this.x.range[0],this.y.range[1]-this.y.range[0]],r=e.shiftKey?.1:.02,s=(l,c)=>{let u=this.cross??{x:_o(this.x.range),y:_o(this.y.range)};this.cross={x:u.x+l*r*t,y:u.y+c*r*i},this.spoken.textContent=this.acts.hover(this.cross,this.frame)??"",this.mark()},a={ArrowLeft:()=>s(-1,0),ArrowRight:()=>s(1,0),ArrowUp:()=>s(0,1),ArrowDown:()=>s(0,-1),Enter:()=>this.acts.click(this.cross??{x:_o(this.x.range),y:_o(this.y.range)}),"+":()=>this.zoom(1/1.3),"=":()=>this.zoom(1/1.3),"-":()=>this.zoom(1.3),0:()=>this.showAll(),...this.acts.keys}[e.key];a!==void 0&&(e.preventDefault(),a())}};function _o([n,e]){return(n+e)/2}function Pm(n,e){return n<e?[n,e]:[e,n]}function Im(n){let{bifurcation:e}=n.model;return e===null?null:new rd(n,e)}var rd=class{constructor(e,t){this.lab=e;this.diagram=t;this.sheet=new os({label:`Bifurcation diagram: ${t.x} across, ${t.y} up. Arrow keys move a cross, Enter shows a motion with these values.`,paint:(s,o)=>this.paint(s,o),click:s=>{this.start(s)},hover:(s,o)=>this.hover(s,o),marks:(s,o)=>this.marks(s,o),whole:()=>this.whole()}),this.element=se("div",{},this.sheet.element,se("p",{class:"lab-hint"},"Over each region the motions fill tori; on the curves lie the special motions. A click shows a motion with these values of the integrals; its ring is where the motion of the scene lies."));let{x:i,y:r}=this.whole();this.sheet.setAxes({range:i,label:this.label(t.x)},{range:r,label:this.label(t.y)}),e.shown.after(()=>{this.locate()})}lab;diagram;element;sheet;point=null;visible=!1;shown(){this.visible=!0,this.locate()}label(e){let t=this.lab.model.quantities.find(s=>s.name===e),i=t?.mathml?si(t.mathml):e,r=Wn(t?.unit??"1");return r?`${i}  (${r})`:i}whole(){let{curves:e}=this.diagram;return{x:Lr(e.flatMap(({x:t})=>t)),y:Lr(e.flatMap(({y:t})=>t))}}async locate(){let{engine:e,model:t}=this.lab,{state:i,experiment:r}=this.lab.shown.value;if(!this.visible||e===null||i===null)return;let s=await e.quantities(r.parameters,i.slice(0,t.reduced),t.reduced),o=a=>s[t.quantities.findIndex(l=>l.name===a)]??NaN;this.point={x:o(this.diagram.x),y:o(this.diagram.y)},this.sheet.mark()}paint(e,t){let i=Qt();e.save(),e.beginPath(),e.rect(t.right(t.x.range[0]),t.down(t.y.range[1]),t.innerWidth,t.innerHeight),e.clip(),this.diagram.curves.forEach(({x:r,y:s},o)=>{e.strokeStyle=i.series[o%i.series.length]??i.ink,e.lineWidth=1.8,e.setLineDash([[],[7,3],[2,3]][o%3]??[]),e.beginPath(),r.forEach((a,l)=>{let[c,u]=[t.right(a),t.down(s[l]??NaN)];l===0?e.moveTo(c,u):e.lineTo(c,u)}),e.stroke()}),e.restore()}marks(e,t){this.point!==null&&(e.strokeStyle=Qt().ink,e.fillStyle=Qt().paper,e.lineWidth=2,e.beginPath(),e.arc(t.right(this.point.x),t.down(this.point.y),5,0,2*Math.PI),e.fill(),e.stroke())}hover(e,t){let i=null;for(let{label:s,x:o,y:a}of this.diagram.curves)o.forEach((l,c)=>{let u=Math.hypot(t.right(l)-t.right(e.x),t.down(a[c]??NaN)-t.down(e.y));u<8&&(i===null||u<i.far)&&(i={label:s,far:u})});let r=`${si(this.label(this.diagram.x))} = ${St(e.x)}, ${this.label(this.diagram.y)} = ${St(e.y)}`;return i===null?r:`${r}: ${i.label}`}async start(e){let{engine:t,model:i}=this.lab,{state:r,experiment:s}=this.lab.shown.value;if(t===null||r===null)return this.lab.say("This page shows a recorded motion and cannot compute another.",!0);let o=await t.quantities(s.parameters,r.slice(0,i.reduced),i.reduced),{x:a,y:l}=this.diagram,c=i.quantities.findIndex(({name:f})=>f!==a&&f!==l),u=i.quantities[c];if(u===void 0)return;let h={on:u.name,value:o[c]??0,direction:0,x:a,y:l},d=await t.startOnLevel({parameters:s.parameters,reference:r,section:h,x:e.x,y:e.y});if("message"in d)return this.lab.say(`No motion with these values was found from the one in the scene: ${d.message}.`,!0);await this.lab.change({...this.lab.wanted.value,start:{state:Array.from(d.state)}}),this.lab.clock.seek(0)}};function sd(n){return Math.log2(Math.max(1,n)/2)/4}function Lm(n){return nc(Fs(),sd(n))}function Ia(n){return Number.isFinite(n)?`MEGNO ${St(n,3)}${n<2.5?", as on regular motions":n>4?", as on chaotic motions":""}`:"no indicator: the motion ends before"}var rc=1e3;function sc(n,e,t){let{low:i,high:r}=n,s=`${n.meaning||n.name}${n.unit&&n.unit!=="1"?`, ${n.unit}`:""}`,o=se("input",{type:"range",min:0,max:rc,step:1,"aria-label":s}),a=se("input",{type:"text",inputmode:"decimal","aria-label":`${s}, as a number`,class:"lab-field",size:9}),l=f=>{let m=r>i?(f-i)/(r-i):0;o.value=String(Math.round(rc*m)),o.style.setProperty("--share",String(Math.min(1,Math.max(0,m)))),o.setAttribute("aria-valuetext",`${St(f)} ${n.unit}`),document.activeElement!==a&&(a.value=Math.abs(f)<1e-12*(r-i)?"0":pv(f))},c=!1;o.addEventListener("input",()=>{c||e(),c=!0;let f=mv(i+Number(o.value)/rc*(r-i),r-i);l(f),t(f)}),o.addEventListener("change",()=>c=!1);let u=()=>{let f=Number(a.value.replace("−","-").replace(",","."));if(a.value.trim()===""||!Number.isFinite(f)){a.setAttribute("aria-invalid","true");return}a.removeAttribute("aria-invalid"),e(),t(f),l(f)};a.addEventListener("change",u),a.addEventListener("keydown",f=>f.stopPropagation()),l(n.value);let h=Wn(n.unit)===""?null:se("span",{class:"lab-unit"},Wn(n.unit));return{element:se("div",{class:"lab-slider",title:n.meaning||null},se("span",{class:"lab-symbol"},n.symbol),o,se("span",{class:"lab-value"},a,h)),set:l}}function pv(n){return String(Number(n.toPrecision(5)))}function mv(n,e){let t=10**Math.floor(Math.log10(e/rc));return Number((Math.round(n/t)*t).toPrecision(12))}function oc(n,e,t){let i=e??(n>0?0:n<0?2*n:-1),r=t??(n>0?2*n:n<0?0:1);return i<r?[Math.min(i,n),Math.max(r,n)]:[i,i+Math.max(1,Math.abs(i))]}var Fm='"use strict";(()=>{function H(r,t){let n=new Float64Array(3*r.length*t.length),e=0;for(let o=0;o<r.length;o++)for(let s=0;s<t.length;s++){let a=Math.sin(r[o]);n[e++]=a*Math.cos(t[s]),n[e++]=a*Math.sin(t[s]),n[e++]=Math.cos(r[o])}return n}function et(r,t){let{theta:n,phi:e,hollow:o}=r,s=n.length,a=e.length,i=H(n,e),m=o?1:-1,h=s*a,c=h+2*(a+1),l=new Float32Array(3*c),u=new Float32Array(3*c);for(let f=0;f<3*h;f++)l[f]=t[f],u[f]=m*i[f];let b=[],d=[],p=(f,A,g,v)=>{dt(l,u,f,A,g)||([A,g]=[g,A]),b.push(f,A,g),d.push(v)},y=f=>Math.floor((e[f]+1e-9)/(Math.PI/2));for(let f=0;f+1<s;f++){let A=(n[f]+n[f+1])/2<Math.PI/2?1:0;for(let g=0;g<a;g++){let v=(g+1)%a,F=(y(g)+A)%2;p(f*a+g,f*a+v,(f+1)*a+v,F),p(f*a+g,(f+1)*a+v,(f+1)*a+g,F)}}for(let f of[!0,!1]){let A=(f?0:s-1)*a,g=h+(f?0:a+1),v=g+a,F=m*(f?1:-1);for(let w=0;w<a;w++){for(let S=0;S<3;S++){let M=l[3*(A+w)+S];l[3*(g+w)+S]=M,l[3*v+S]+=M/a}u[3*(g+w)+2]=F}u[3*v+2]=F;for(let w=0;w<a;w++)p(v,g+w,g+(w+1)%a,(y(w)+(f?1:0))%2)}return{positions:l,normals:u,indices:Uint32Array.from(b),tones:Uint8Array.from(d),hollow:o}}function dt(r,t,n,e,o){let s=[0,1,2].map(m=>r[3*e+m]-r[3*n+m]),a=[0,1,2].map(m=>r[3*o+m]-r[3*n+m]),i=0;for(let m=0;m<3;m++){let h=(m+1)%3,c=(m+2)%3,l=t[3*n+m]+t[3*e+m]+t[3*o+m];i+=(s[h]*a[c]-s[c]*a[h])*l}return i>=0}function J({rows:r,misses:t},n){let e=new Float64Array(n),o=[];return r.forEach((s,a)=>{let i=Float64Array.from(s),m=T(s);for(let l=0;l<2;l++)for(let u of o)R(i,u);let h=T(i);if(!(h>1e-9*m))return;for(let l=0;l<n;l++)i[l]/=h;let c=(t[a]-N(s,e))/h;for(let l=0;l<n;l++)e[l]+=c*i[l];o.push(i)}),e}function j(r){let t=[];for(let n of r){let e=Float64Array.from(n),o=T(n);for(let a=0;a<2;a++)for(let i of t)R(e,i);let s=T(e);s>1e-9*o&&t.push(e.map(a=>a/s))}return t}function R(r,t){let n=N(r,t);for(let e=0;e<r.length;e++)r[e]-=n*t[e]}function N(r,t){let n=0;for(let e=0;e<r.length;e++)n+=r[e]*t[e];return n}function T(r){return Math.sqrt(N(r,r))}var X=1e-12,rt=40,pt=1e-15,bt=4,gt=64;function st(r,{parameters:t,inputs:n}){let{model:e,tables:o}=r,s=r.parameters(t),a=At(r,s);if(a!==null)return{message:a};let i=Float64Array.from(e.start_inputs,l=>n[l.name]??l.value),m=i.findIndex(l=>!Number.isFinite(l));if(m>=0)return{message:`${e.start_inputs[m].name}: it must be a finite number`};let h;if(o.start===null){let l=Ft(r,i,s);if("message"in l)return l;h=l.state}else{let l=o.motion.dimension,u=r.values(o.start,i,s);h=u.slice(0,l);let b=u.slice(l,l+o.excess.length),d=u.slice(l+b.length);for(let[p,{message:y,among:f}]of o.excess.entries()){let A=Math.max(...f.map(g=>Math.abs(i[g])));if(Math.abs(b[p])>X*A){let g=f.map(F=>Q(d[F])).join(", ");return{message:y.replace("{excess}",C(b[p])).replace("{nearest}",g),nearest:d}}}if(!h.every(Number.isFinite))return{message:o.singular}}let c=ot(r,h,s);return c===null?{state:h}:{message:c}}function At(r,t){let{model:n,tables:e}=r,o=t.findIndex(c=>!Number.isFinite(c));if(o>=0){let{name:c}=n.parameters[o];return`${n.name}: ${c} = ${Q(t[o])} must be a finite number`}if(e.conditions_on_parameters.length===0)return null;let a=r.values(e.admissible,new Float64Array(e.admissible.inputs),t).findIndex(c=>!(c>0));if(a<0)return null;let{parameter:i,condition:m}=e.conditions_on_parameters[a],h=t[n.parameters.findIndex(c=>c.name===i)];return`${n.name}: ${i} = ${Q(h)} is not admissible; ${m} must hold`}function ot(r,t,n){let{tables:e}=r;if(e.start_messages.length===0)return null;let o=Array.from(t).slice(0,e.guards.inputs),s=r.values(e.guards,o,n).findIndex(a=>!(a>0));return s<0?null:e.start_messages[s]}function Ft(r,t,n){let{tables:e}=r,o=Float64Array.from(t);for(let{name:u,places:b}of e.directions){let d=Math.hypot(...b.map(p=>o[p]));if(d===0)return{message:`${u}: must not be zero, as it is a direction`};for(let p of b)o[p]/=d}let s=Float64Array.from(o),a=Array.from(s.keys()),i=at(r,s,n,a),m=1+Math.max(0,...o.map(Math.abs)),h=Math.max(0,...s.map((u,b)=>Math.abs(u-o[b])));if(i.done&&h<=X*m)return{state:s};let c=i.misses.reduce((u,b,d)=>Math.abs(b)>Math.abs(i.misses[u])?d:u,0),l=`start: the relation ${e.relation_texts[c]} = 0 is missed by ${C(i.misses[c])}`;return i.done?{message:`${l}; the nearest admissible state is shown`,nearest:s}:{message:l}}function at(r,t,n,e){let{phase_space:o,whole_relations:s}=r.tables,a=null;if(s===0)return{done:!0,misses:[]};let i=t.length;for(let m=0;m<rt;m++){let h=r.values(o,t,n),c=Array.from(h.subarray(0,s));if(a??=c,!c.every(Number.isFinite))break;let l=c.map((p,y)=>Float64Array.from(e,f=>h[s+y*i+f])),u=J({rows:l,misses:c.map(p=>-p)},e.length);e.forEach((p,y)=>t[p]+=u[y]);let b=1+Math.max(...t.map(Math.abs));if(Math.max(...u.map(Math.abs))<=pt*b)return{done:Mt(h,t,s),misses:a}}return{done:!1,misses:a??[]}}function Mt(r,t,n){let e=t.length,o=1+Math.max(...t.map(Math.abs));for(let s=0;s<n;s++){let a=0;for(let i=0;i<e;i++)a+=Math.abs(r[n+s*e+i]);if(!(Math.abs(r[s])<=X*(1+a*o)))return!1}return!0}function wt(r,t,n){let{tables:e,model:o}=r,s=e.conditions.inputs,a=e.relations+e.integrals.length+o.quantities.length,i=d=>t.slice(a+d*s,a+(d+1)*s),m=[...Array(e.relations).keys()],h=e.integrals.map((d,p)=>({name:d,row:e.relations+p})),c=h.filter(({name:d})=>n.includes(d)),l=s-e.relations-3,u=[],b=j([...m,...c.map(({row:d})=>d)].map(i));for(let{row:d}of h.filter(p=>!c.includes(p))){let p=j([...b,i(d)]);p.length>b.length&&u.length<l&&u.push(d),b=p}return u}function it(r,t){let{model:n,tables:e}=r,{section:o}=t,s=r.parameters(t.parameters),a=e.conditions.inputs,i=n.quantities.map(M=>M.name),m=[o.on,o.x,o.y].map(M=>i.indexOf(M)),h=[o.on,o.x,o.y].find((M,x)=>m[x]<0);if(h!==void 0)return{message:`${h}: no quantity of ${n.name}`};let c=e.relations+e.integrals.length,l=c+i.length,u=M=>r.values(e.conditions,M,s),b=Float64Array.from(Array.from(t.reference).slice(0,a)),d=u(b),p=wt(r,d,[o.x,o.y]),y=e.relations+p.length,f=[...Array(e.relations).keys(),...p,...m.map(M=>c+M)],A=[...Array(y).fill(!1),...m.map(M=>n.quantities[M].angle)],v=[...f.map((M,x)=>x<e.relations?0:d[M]).slice(0,y),o.value??0,t.x,t.y],F=V(r,b),w=(M,x)=>{let k=Float64Array.from(M);for(let I=0;I<rt;I++){let z=u(k),B=f.map((E,O)=>nt(x[O],z[E],A[O])),_=f.map(E=>Float64Array.from({length:a},(O,tt)=>z[l+E*a+tt]*F[tt])),$=_.map(E=>Math.sqrt(N(E,E))),q=Math.max(...B.map((E,O)=>Math.abs(E)/($[O]+1e-300)));if(!Number.isFinite(q))return null;if(q<1e-14||I>6&&q<1e-12)return k;let L=J({rows:_,misses:B},a),P=Math.max(...L.map(Math.abs)),D=Math.min(1,.5/P);for(let E=0;E<a;E++)k[E]+=D*L[E]*F[E]}return null},S=f.length-1;for(let M=bt;M<=gt;M*=4){let x=b;for(let $=1;$<=M&&x!==null;$++){let q=v.map((L,P)=>{if(P<y||P>S)return L;let D=d[f[P]];return D+$/M*nt(L,D,A[P])});x=w(x,q)}if(x===null)continue;let k=u(x),I=r.values(e.rates,x,s),z=k.subarray(l+f[y]*a,l+(f[y]+1)*a),B=n.direction*N(Float64Array.from(z),I);if(o.direction*n.direction*B<0)continue;let _=ot(r,x,s);return _!==null?{message:_}:vt(r,x,t.reference,s)}return{message:`no state on this level was found at ${o.x} = ${C(t.x)}, ${o.y} = ${C(t.y)}`}}function vt(r,t,n,e){let{model:o,tables:s}=r,a=s.motion.dimension,i=n.length>=a?n:o.start,m=Float64Array.from({length:a},(c,l)=>l<t.length?t[l]:i[l]),h=Array.from({length:a-t.length},(c,l)=>t.length+l);return h.length>0&&!at(r,m,e,h).done?{message:`${o.name}: no attitude belongs to this state`}:{state:m}}function V(r,t){let n=new Float64Array(r.tables.conditions.inputs).fill(1),e=r.tables.groups.map(s=>Math.hypot(...s.map(a=>t[a]))),o=Math.max(...e);return r.tables.groups.forEach((s,a)=>{let i=e[a]>1e-10*o?e[a]:o>0?o:1;for(let m of s)n[m]=i}),n}function nt(r,t,n){let e=r-t;return n?e-2*Math.PI*Math.round(e/(2*Math.PI)):e}function Q(r){return Number.isInteger(r)&&Math.abs(r)<1e16?r.toFixed(1):String(r)}function C(r){return String(Number(r.toPrecision(6)))}var U=200,lt=.2,mt=1e-12,ct=32;function Y(r,t){let{tangent:n}=r.tables,e=n.dimension/2,o=t.kind==="lyapunov",s=new Float64Array(t.motions.length).fill(NaN),a=t.motions.map(({parameters:u,start:b})=>xt(r,r.parameters(u),Float64Array.from(b).slice(0,e),t.until,o)),i=[...a.keys()].filter(u=>a[u]!==null),m=[t.until/U],h=r.model.parameters.length,c=new Float64Array(a.length*2*e),l=new Float64Array(a.length*Math.max(h,1));for(let u=1;u<=U&&i.length>0;u++){i.forEach((d,p)=>{let{state:y,scales:f,deviation:A,values:g}=a[d],v=2*e*p;c.set(y,v);for(let F=0;F<e;F++)c[v+e+F]=A[F]*f[F];l.set(g,h*p)});let b=r.march(n,c.subarray(0,2*e*i.length),l.subarray(0,h*i.length),m,1,mt);i=i.filter((d,p)=>{let y=a[d],f=b[p];if(f.outcome!==0)return!1;y.state=f.states.subarray(0,e);for(let g=0;g<e;g++)y.deviation[g]=f.states[e+g]/y.scales[g];let A=y.total;return y.total+=Math.log(ut(y.deviation,ft(r,y,o))),y.mean+=((y.total+A)/2-y.mean)/u,y.sum+=2*(y.total-y.mean),u<=lt*U&&(y.settled=y.total),!0})}for(let u of i){let{total:b,settled:d,sum:p}=a[u],y=(b-d)/(t.until*(1-lt));s[u]=t.kind==="megno"?p/U:y}return s}function xt(r,t,n,e,o){let s=Float64Array.from(n,(h,c)=>Math.cos(1+2.7*c)),a=Et(r,n,t,e),i={values:t,state:n,scales:a,deviation:s,total:0,mean:0,sum:0,settled:0},m=ft(r,i,o);return m.length>=n.length?null:(ut(s,m),i)}function ut(r,t){for(let e=0;e<2;e++)for(let o of t)R(r,o);let n=T(r);for(let e=0;e<r.length;e++)r[e]/=n;return n}function ft(r,t,n){let{invariants:e,relations:o,integrals:s,rates:a}=r.tables,{state:i,values:m,scales:h}=t,c=i.length,l=o+s.length,u=n?l:o,b=u>0?r.values(e,i,m):i,d=Array.from({length:u},(p,y)=>{let f=b.slice(l+y*c,l+(y+1)*c);for(let A=0;A<c;A++)f[A]*=h[A];return f});if(n){let p=Float64Array.from(r.values(a,i,m));for(let y=0;y<c;y++)p[y]/=h[y];d.push(p)}return j(d)}function Et(r,t,n,e){let{tangent:o}=r.tables,s=t.length,a=Array.from({length:ct},(c,l)=>(l+1)/(10*ct)*e),i=new Float64Array(2*s);i.set(t);let[m]=r.march(o,i,n,a,a.length,mt),h=V(r,t);for(let c=0;c<m.count;c++){let l=V(r,m.states.subarray(2*s*c,2*s*c+s));for(let u=0;u<s;u++)h[u]=Math.max(h[u],l[u])}return h}function St(r){let t=atob(r),n=new Uint8Array(t.length);for(let e=0;e<t.length;e++)n[e]=t.charCodeAt(e);return n}async function ht(r){let t=new Blob([St(r)]).stream().pipeThrough(new DecompressionStream("deflate"));return new Response(t).arrayBuffer()}var Pt=65536,Tt=10000000n,Z=1024,W=class r{constructor(t,n,e,o){this.model=t;this.tables=n;this.memory=e;this.functions=o}model;tables;memory;functions;at=Z;static async create(t){if(t.wasm===null||t.wasm_tables===null)throw new Error(`${t.title}: this page cannot compute`);let n=new WebAssembly.Memory({initial:16}),e=await WebAssembly.instantiate(await ht(t.wasm),{env:{memory:n}});return new r(t,t.wasm_tables,n,e.instance.exports)}parameters(t){let n=new Set(this.model.parameters.map(e=>e.name));for(let e of Object.keys(t))if(!n.has(e)){let o=[...n].join(", ")||"none";throw new RangeError(`${this.model.name}: no parameter ${e}; it has ${o}`)}return Float64Array.from(this.model.parameters,e=>t[e.name]??e.value)}march(t,n,e,o,s,a){let i=n.length/t.dimension,m=e.length>t.parameters?BigInt(t.parameters):0n;this.at=Z;let h=this.put(n),c=this.put(e),l=this.put(o),u=this.room(i*s*t.dimension),b=this.room(i*s),d=this.room(i),p=this.room(i),y=this.room(i),f=this.room(i),A=this.room(t.work);this.doubles(u,i*s*t.dimension).fill(NaN),this.whole(d,i).fill(0n);let g=this.functions[t.name];return g(0n,BigInt(i),h,c,m,l,BigInt(s),a,Tt,u,b,d,p,y,f,A),Array.from({length:i},(v,F)=>{let w=Number(this.whole(d,i)[F]),S=s*t.dimension;return{states:this.doubles(u+8*F*S,w*t.dimension).slice(),moments:this.doubles(b+8*F*s,w).slice(),count:w,outcome:Number(this.whole(p,i)[F]),ended:this.doubles(y,i)[F],steps:Number(this.whole(f,i)[F])}})}values(t,n,e){let o=n.length/t.inputs;this.at=Z;let s=this.put(n),a=this.put(e),i=this.room(o*t.outputs),m=this.room(t.work);return this.functions[t.name](BigInt(o),s,a,i,m),this.doubles(i,o*t.outputs).slice()}put(t){let n=this.room(Math.max(t.length,1));return this.doubles(n,t.length).set(t),n}room(t){let n=this.at;this.at+=16*Math.ceil(t/2);let e=this.at-this.memory.buffer.byteLength;return e>0&&this.memory.grow(Math.ceil(e/Pt)),n}doubles(t,n){return new Float64Array(this.memory.buffer,t,n)}whole(t,n){return new BigInt64Array(this.memory.buffer,t,n)}};var G=class r{constructor(t,n){this.model=t;this.module=n}model;module;static async create(t){return new r(t,await W.create(t))}async motion({parameters:t,start:n,times:e}){let{model:o,module:s}=this,a=s.tables.motion,i=s.parameters(t),[m]=s.march(a,n,i,e,e.length,o.tolerance),{count:h,states:c}=m,l=s.values(s.tables.columns,c,i),u=s.tables.columns.outputs,b={},d=0;for(let y of o.columns){let f=new Float64Array(h*y.width);for(let A=0;A<h;A++)for(let g=0;g<y.width;g++)f[A*y.width+g]=l[A*u+d+g];b[y.name]=f,d+=y.width}return{times:Float64Array.from({length:h},(y,f)=>o.direction*e[f]),columns:b,states:c,end:this.end(m)}}async section(t){let{model:n,module:e}=this,{section:o,section_quantities:s}=e.tables,a=s.indexOf(t.on);if(a<0)throw new RangeError(`${t.on}: no quantity of a section; they are ${s.join(", ")}`);let i=e.parameters(t.parameters),m=new Float64Array(i.length+2+s.length);m.set(i),m[i.length]=t.value??0,m[i.length+1]=n.direction*t.direction,m[i.length+2+a]=1;let h=Array.from(t.start).slice(0,o.dimension),c=[t.until??1/0],[l]=e.march(o,h,m,c,t.points,n.section_tolerance),{states:u,moments:b}=l,d=b.map(p=>n.direction*p);return{rows:u,times:d,dimension:o.dimension,end:this.end(l)}}async quantities(t,n,e){let{module:o}=this,s=o.tables.quantities;return o.values(s,Nt(n,e,s.inputs),o.parameters(t))}async indicator(t){let{parameters:n,start:e,until:o,kind:s}=t,[a]=Y(this.module,{motions:[{parameters:n,start:e}],until:o,kind:s});return a}async indicators(t){return Y(this.module,t)}async startFrom(t){return st(this.module,t)}async startOnLevel(t){return it(this.module,t)}async bodyMesh(t){let{body:n}=this.model.scene,{contact:e,gamma:o}=this.module.tables;if(n===null||e===null)return null;let s=H(n.theta,n.phi),a=s.length/3,i=new Float64Array(a*e.inputs);for(let c=0;c<a;c++)for(let l=0;l<3;l++)i[c*e.inputs+o+l]=s[3*c+l];let m=this.module.values(e,i,this.module.parameters(t)),h=n.hollow?1:-1;for(let c=0;c<a;c++){let l=h*s[3*c+2];Math.abs(l)>1e-9&&(m[3*c+2]+=n.thickness*Math.sign(l))}return et(n,m)}end({outcome:t,ended:n}){if(t===0)return null;let e=this.module.tables.reasons[t]??`outcome ${t}`;return{time:this.model.direction*n,reason:e}}};function Nt(r,t,n){if(t===n)return r;let e=r.length/t,o=new Float64Array(e*n);for(let s=0;s<e;s++)o.set(r.subarray(s*t,s*t+n),s*n);return o}function yt(r,t,n){switch(t){case"quantities":{let{parameters:e,rows:o,dimension:s}=n;return r.quantities(e,o,s)}case"bodyMesh":return r.bodyMesh(n);case"motion":case"section":case"indicator":case"indicators":case"startFrom":case"startOnLevel":return r[t](n);default:return Promise.reject(new Error(`There is no method ${t}.`))}}var K=null;addEventListener("message",({data:r})=>{if(r.model!==void 0){K=G.create(r.model),K.catch(()=>{});return}let{id:t,method:n,argument:e}=r;(async()=>{try{if(K===null)throw new Error("The worker has no model.");postMessage({id:t,value:await yt(await K,n??"",e)})}catch(o){postMessage({id:t,message:o instanceof Error?o.message:String(o)})}})()});})();\n';function Nm(n){return{motion:async e=>await n("motion",e),section:async e=>await n("section",e),quantities:async(e,t,i)=>await n("quantities",{parameters:e,rows:t,dimension:i}),indicator:async e=>await n("indicator",e),indicators:async e=>await n("indicators",e),startFrom:async e=>await n("startFrom",e),startOnLevel:async e=>await n("startOnLevel",e),bodyMesh:async e=>await n("bodyMesh",e)}}function La(n){let e=URL.createObjectURL(new Blob([Fm],{type:"text/javascript"})),t=new Worker(e),i=new Map,r=0;return t.addEventListener("message",({data:o})=>{let a=i.get(o.id);i.delete(o.id),o.message!==void 0?a?.reject(new Error(o.message)):a?.resolve(o.value)}),t.addEventListener("error",o=>{for(let{reject:a}of i.values())a(new Error(o.message||"The computation failed."));i.clear()}),t.postMessage({model:{...n,recorded:null,experiment:""}}),{engine:Nm((o,a)=>new Promise((l,c)=>{r+=1,i.set(r,{resolve:l,reject:c}),t.postMessage({id:r,method:o,argument:a})})),busy:()=>i.size>0,end(){t.terminate(),URL.revokeObjectURL(e);for(let{reject:o}of i.values())o(new Error("The computation was stopped."));i.clear()}}}function Bm(){return Math.min(8,Math.max(1,(navigator.hardwareConcurrency||2)-1))}var ac=class{constructor(e){this.model=e}model;worker=null;get engine(){return this.worker??=La(this.model),this.worker.engine}renew(){this.worker?.busy()===!0&&(this.worker.end(),this.worker=null)}};function Dm(n,e=16){let t=[],i=1;for(;i*2<=e&&i*2<=n;)i*=2;for(let r=i;r>=1;r/=2)for(let s=0;s<n;s+=r)for(let o=0;o<n;o+=r)r<i&&s%(2*r)===0&&o%(2*r)===0||t.push({column:o,row:s,side:r});return t}function od([n,e],t,i){return n+(t+.5)/i*(e-n)}function ad(n,e){let t=n.filter(Number.isFinite).sort();return t.length===0?NaN:t[Math.min(t.length-1,Math.floor(e*t.length))]??NaN}var xv=2*Math.PI;function Um(n){let e=n.length-1;if(e<8)return NaN;let t=Float64Array.from({length:e},(a,l)=>{let c=((n[l+1]??NaN)-(n[l]??NaN))/xv;return c-Math.floor(c)}),i=yv(t);if(Number.isNaN(i))return NaN;let r=0,s=0;for(let a=0;a<e;a++){let l=(t[a]??NaN)-i,c=(a+.5)/e,u=Math.exp(-1/(c*(1-c)));r+=u*(l-Math.floor(l)+i),s+=u}let o=r/s;return o-Math.round(o)}function yv(n){let e=n.slice().sort(),t=Array.from(e,(o,a)=>(a+1<e.length?e[a+1]??0:(e[0]??0)+1)-o),i=t.reduce((o,a,l)=>a>(t[o]??0)?l:o,0),r=t[i]??0,s=t.reduce((o,a,l)=>l===i?o:Math.max(o,a),0);return!(r>=.02)||r<2*s?NaN:(e[(i+1)%e.length]??0)-r/2}var _v=8;async function ld(n,e,t,i,r){let{model:s,experiment:o,reference:a,section:l}=e;if(t.x===null||t.y===null){if(l===null)return{message:"There is no section."};let{on:b,value:g,direction:p}=l,_={parameters:o.parameters,reference:a,section:{on:b,value:g,direction:p,x:l.x,y:l.y},x:i,y:r},T=await n.startOnLevel(_);return"message"in T?T:{experiment:{...o,start:{state:Array.from(T.state)}},state:T.state}}let c=[[t.x,i],[t.y,r]],u=c.filter(([b])=>s.start_inputs.some(g=>g.name===b)),h={...o.parameters,...Object.fromEntries(c.filter(b=>!u.includes(b)))},{start:d}=o,f="state"in d&&u.length===0?d:{inputs:{..."inputs"in d?d.inputs:{},...Object.fromEntries(u)}},m="state"in f?{state:Float64Array.from(f.state)}:await n.startFrom({parameters:h,inputs:f.inputs});return"message"in m?m:{experiment:{...o,parameters:h,start:f},state:m.state}}async function bv(n,e,t,i){let r=await Promise.all(i.map(([h,d])=>ld(n,e,t,h,d))),{kind:s,until:o}=t;if(s==="rotation")return Promise.all(r.map(h=>vv(n,e,t,h)));let a=r.map((h,d)=>"message"in h?-1:d).filter(h=>h>=0),l=a.map(h=>{let{experiment:d,state:f}=r[h];return{parameters:d.parameters,start:f}}),c=await n.indicators({motions:l,until:o,kind:s}),u=r.map(()=>NaN);return a.forEach((h,d)=>u[h]=c[d]??NaN),u}async function vv(n,e,t,i){if("message"in i)return NaN;let{parameters:r}=i.experiment,{section:s,model:o}=e;if(s===null)return NaN;let a=o.quantities.findIndex(({name:d})=>d===s.x),{rows:l,dimension:c}=await n.section({parameters:r,start:i.state,on:s.on,value:s.value,direction:s.direction,points:300,until:t.until});if(l.length===0)return NaN;let u=await n.quantities(r,l,c),h=o.quantities.length;return Um(Float64Array.from({length:u.length/h},(d,f)=>u[f*h+a]??NaN))}function Om(n,e,t){let{size:i}=e,r=new Float64Array(i*i).fill(NaN),s=Dm(i),o=Array.from({length:Bm()},()=>La(n.model)),a=0,l=0,c=!1,u=async({engine:d})=>{for(;!c&&a<s.length;){let f=s.slice(a,a+_v);a+=f.length;let m=f.map(({column:g,row:p})=>[od(e.xRange,g,i),od(e.yRange,p,i)]),b=await bv(d,n,e,m).catch(()=>f.map(()=>NaN));if(c)return;f.forEach(({column:g,row:p},_)=>r[p*i+g]=b[_]??NaN),l+=f.length,t(f,l/s.length)}},h=()=>{c=!0;for(let d of o)d.end()};return{values:r,done:Promise.all(o.map(u)).then(h,h),stop:h}}var km=[{value:"megno",text:"MEGNO"},{value:"lyapunov",text:"Lyapunov exponent"},{value:"rotation",text:"rotation number"}];function zm(n,e){let{engine:t,model:i}=n;if(t===null||i.wasm===null)return null;let r=wv(n);return r.length<2&&e===null?null:new cd(n,r,e)}var cd=class{constructor(e,t,i){this.lab=e;this.choices=t;this.section=i;this.setting=this.opening(),this.sheet=new os({label:"Chart. Arrow keys move a cross, Enter shows the motion there, plus and minus change the range.",paint:(r,s)=>this.paint(r,s),click:r=>{this.show(r)},hover:r=>this.hover(r),whole:()=>this.wholeRange(),moved:()=>this.moved()}),this.go.addEventListener("click",()=>this.run===null?this.start():this.run.stop()),this.element=se("div",{},this.tools(),this.sheet.element,this.key),this.axes()}lab;choices;section;element;sheet;setting;drawn=null;run=null;go=se("button",{type:"button",class:"lab-button"},"Compute");bar=se("progress",{class:"lab-progress",max:1,value:0,"aria-label":"Share of the chart that is done",hidden:!0});key=se("div",{class:"lab-key"});due=0;shown(){this.sheet.repaint()}opening(){let{model:e}=this.lab,t=e.chart;if(t!==null)return{...t,size:100};let[i,r]=this.choices,s=this.section!==null,o=[0,1],{x:a,y:l}=s?this.sectionRange():{x:i?.range??o,y:r?.range??o};return{kind:"megno",x:s?null:i?.name??null,y:s?null:r?.name??null,xRange:a,yRange:l,size:100,until:Math.max(100,this.lab.model.until)}}tools(){let e=this.choices.map(({name:a,text:l})=>({value:a,text:l})),t=this.section===null?[]:[{value:"",text:"point of the section"}],{setting:i}=this,r=(a,l)=>or(a,[...t,...e],i[l]??"",c=>this.choose(l,c===""?null:c)),s=se("input",{type:"text",inputmode:"decimal",class:"lab-field","aria-label":"Time up to which each motion is followed",value:String(i.until)});s.addEventListener("change",()=>{let a=Number(s.value);a>0&&Number.isFinite(a)?this.setting={...this.setting,until:a}:this.lab.say("The time must be a positive number.",!0)});let o=this.section===null?km.slice(0,2):km;return se("div",{class:"lab-tools",role:"toolbar","aria-label":"Chart"},or("of",o,i.kind,a=>this.setting={...this.setting,kind:a}),r("across","x"),r("up","y"),se("label",{class:"lab-choice"},"to t =",s),or("points",[50,100,200,400].map(a=>({value:String(a),text:`${a} × ${a}`})),String(i.size),a=>this.setting={...this.setting,size:Number(a)}),this.go,this.bar)}choose(e,t){let i=e==="x"?"y":"x",r={...this.setting,[e]:t};t===null?r[i]=null:r[i]===null&&(r[i]=this.choices.find(a=>a.name!==t)?.name??null),this.setting=r;let{x:s,y:o}=this.wholeRange();this.setting={...this.setting,xRange:s,yRange:o};for(let[a,l]of["x","y"].entries()){let c=this.element.querySelectorAll(".lab-tools select")[a+1];c&&(c.value=this.setting[l]??"")}this.drawn=null,this.axes()}choice(e){return this.choices.find(t=>t.name===e)}wholeRange(){return this.setting.x===null?this.sectionRange():{x:this.choice(this.setting.x)?.range??[0,1],y:this.choice(this.setting.y)?.range??[0,1]}}sectionRange(){let e=this.section?.(),t=i=>this.lab.model.quantities.find(s=>s.name===i)?.angle===!0?[-Math.PI,Math.PI]:[-1,1];return{x:t(e?.x),y:t(e?.y)}}axes(){let e=(o,a)=>{let l=this.section?.();if(o!==null||l===void 0)return this.choice(o)?.text??"";let c=this.lab.model.quantities.find(u=>u.name===l[a]);return c?.mathml?si(c.mathml):l[a]},{x:t,y:i,xRange:r,yRange:s}=this.setting;this.sheet.setAxes({range:r,label:e(t,"x")},{range:s,label:e(i,"y")})}moved(){let{x:e,y:t}=this.sheet.frame;this.setting={...this.setting,xRange:e.range,yRange:t.range}}start(){let{state:e,experiment:t}=this.lab.shown.value;if(e===null)return;let i={...this.setting},r={model:this.lab.model,experiment:t,reference:e,section:this.section?.()??null},s=document.createElement("canvas");s.width=s.height=i.size,this.go.textContent="Stop",this.bar.hidden=!1,this.bar.value=0;let o=performance.now(),a=Om(r,i,(l,c)=>{this.bar.value=c;for(let{column:u,row:h,side:d}of l)this.block(u,h,d);this.due===0&&(this.due=window.setTimeout(()=>{this.due=0,this.colour()},60))});this.drawn={setting:i,ground:r,values:a.values,picture:s,scale:[0,1]},this.sides=new Uint8Array(i.size*i.size),this.run=a,a.done.then(()=>{this.run=null,this.go.textContent="Compute",this.bar.hidden=!0,this.colour();let l=(performance.now()-o)/1e3,c=a.values.reduce((u,h)=>u+(Number.isFinite(h)?1:0),0);this.lab.say(`${c} of ${a.values.length} points have a value; computed in ${St(l,3)} s.`)})}sides=new Uint8Array(0);block(e,t,i){let{drawn:r}=this;r!==null&&(this.sides[t*r.setting.size+e]=i)}colour(){let{drawn:e}=this;if(e===null)return;let{size:t,kind:i}=e.setting,r=e.picture.getContext("2d");if(r===null)return;e.scale=i==="megno"?[0,1]:[ad(e.values,.02),ad(e.values,.98)];let s=r.createImageData(t,t);for(let o of[16,8,4,2,1])for(let a=0;a<t;a+=o)for(let l=0;l<t;l+=o){if(this.sides[a*t+l]!==o)continue;let c=e.values[a*t+l]??NaN,u=Number.isFinite(c)?nc(Fs(),this.share(c)):null;for(let h=a;h<Math.min(t,a+o);h++)for(let d=l;d<Math.min(t,l+o);d++){let f=4*((t-1-h)*t+d);s.data.set(u===null?[0,0,0,0]:[...u,255],f)}}r.putImageData(s,0,0),this.writeKey(),this.sheet.repaint()}share(e){let{drawn:t}=this;if(t?.setting.kind==="megno")return sd(e);let[i,r]=t?.scale??[0,1];return r>i?(e-i)/(r-i):.5}writeKey(){let{drawn:e}=this;if(e===null)return;let[t,i]=e.setting.kind==="megno"?["MEGNO 2, regular","32 and more, chaotic"]:e.scale.map(s=>St(s,3)),r=se("i",{style:`background:linear-gradient(90deg,${Fs().join(",")})`});this.key.replaceChildren(se("span",{},t??""),r,se("span",{},i??""),se("span",{},"blank: no such motion"))}paint(e,t){let{drawn:i}=this;if(i===null){e.fillStyle=Qt().quiet,e.font=`${t.letter}px ${ss}`,e.textAlign="center",e.fillText("Choose the axes and press Compute",t.width/2,t.height/2);return}let{xRange:r,yRange:s}=i.setting,[o,a]=r.map(u=>t.right(u)),[l,c]=s.map(u=>t.down(u));e.save(),e.beginPath(),e.rect(t.right(t.x.range[0]),t.down(t.y.range[1]),t.innerWidth,t.innerHeight),e.clip(),e.imageSmoothingEnabled=!1,e.drawImage(i.picture,o,c,a-o,l-c),e.restore()}cell(e){let{drawn:t}=this;if(t===null)return null;let{size:i,xRange:r,yRange:s}=t.setting,o=Math.floor((e.x-r[0])/(r[1]-r[0])*i),a=Math.floor((e.y-s[0])/(s[1]-s[0])*i);return o<0||a<0||o>=i||a>=i?null:{index:a*i+o,x:e.x,y:e.y}}hover(e){let t=this.cell(e);if(t===null||this.drawn===null)return null;let i=this.drawn.values[t.index]??NaN,r=`${this.sheet.frame.x.label} = ${St(e.x)}, ${this.sheet.frame.y.label} = ${St(e.y)}`,{kind:s}=this.drawn.setting;return Number.isFinite(i)?`${r}: ${s==="megno"?Ia(i):s==="lyapunov"?`exponent ${St(i,3)}`:`rotation number ${St(i,6)}`}`:`${r}: no value`}async show(e){let{engine:t}=this.lab,{drawn:i}=this;if(t===null||i===null)return;let r=await ld(t,i.ground,i.setting,e.x,e.y);if("message"in r)return this.lab.say(r.message,!0);await this.lab.change({...r.experiment,until:this.lab.wanted.value.until}),this.lab.clock.seek(0)}};function wv({model:n}){let e=(r,s,o)=>{let a=r?si(r):s;return Wn(o)?`${a}  (${Wn(o)})`:a},t=n.start_inputs.map(({name:r,mathml:s,unit:o,value:a,low:l,high:c})=>({name:r,value:a,text:e(s,r,o),range:[l,c]})),i=n.parameters.filter(({fixed:r})=>!r).map(({name:r,mathml:s,unit:o,value:a,low:l,high:c})=>({name:r,value:a,text:e(s,r,o),range:oc(a,l,c)}));return[...t,...i]}function Ns(n){return{parameters:{},start:{inputs:{}},until:n.until}}function ud(n,e){return JSON.stringify(Vm(n))===JSON.stringify(Vm(e))}function Vm({parameters:n,start:e,until:t}){let i=r=>Object.entries(r).sort(([s],[o])=>s<o?-1:1);return[i(n),"state"in e?e.state:i(e.inputs),t]}function cc(n,e){return Float64Array.from({length:e},(t,i)=>n*i/Math.max(1,e-1))}function hd(n,e,t){let i=new URLSearchParams;for(let[s,o]of Object.entries(n.parameters))i.set(`p.${s}`,String(o));if("state"in n.start)i.set("state",n.start.state.join(" "));else for(let[s,o]of Object.entries(n.start.inputs))i.set(`s.${s}`,String(o));n.until!==e.until&&i.set("until",String(n.until));for(let[s,o]of Object.entries(t))i.set(s,o);let r=i.toString();return r===""?"":`#lab&${r}`}function Hm(n,e){if(!n.startsWith("#lab&"))return null;let t={parameters:{},inputs:{}},i=null,r=e.until,s={};for(let[a,l]of new URLSearchParams(n.slice(5))){let c=Number(l),u=a.slice(2);if(a.startsWith("p.")){if(!Number.isFinite(c)||!e.parameters.some(h=>h.name===u&&!h.fixed))return null;t.parameters[u]=c}else if(a.startsWith("s.")){if(!Number.isFinite(c)||!e.start_inputs.some(h=>h.name===u))return null;t.inputs[u]=c}else if(a==="state"){if(i=l.split(/[ +]/).map(Number),i.length!==e.state.length||!i.every(Number.isFinite))return null}else if(a==="until"){if(!(c>0)||!Number.isFinite(c))return null;r=c}else s[a]=l}let o=i===null?{inputs:t.inputs}:{state:i};return{experiment:{parameters:t.parameters,start:o,until:r},choices:s}}function dd(n,e,t,i){let{[e]:r,...s}=n;return t===i?s:{...s,[e]:t}}var lc=class{constructor(e=200){this.longest=e}longest;past=[];future=[];push(e){this.past.push(e),this.past.length>this.longest&&this.past.shift(),this.future=[]}undo(e){let t=this.past.pop();return t!==void 0&&this.future.push(e),t}redo(e){let t=this.future.pop();return t!==void 0&&this.past.push(e),t}get canUndo(){return this.past.length>0}get canRedo(){return this.future.length>0}};function uc(n,e){let t=n.length-1;if(t<=0||!(e>(n[0]??0)))return{index:0,share:0};if(e>=(n[t]??0))return{index:t,share:0};let i=0,r=t;for(;r-i>1;){let o=i+r>>1;(n[o]??0)<=e?i=o:r=o}let s=n[i]??0;return{index:i,share:(e-s)/((n[r]??0)-s)}}function mi(n,e,t,i){let r=n.columns[e];if(r===void 0)return null;let{index:s,share:o}=uc(n.times,i),a=(l,c)=>r[l*t+c]??NaN;return Array.from({length:t},(l,c)=>o===0?a(s,c):(1-o)*a(s,c)+o*a(s+1,c))}function Sv(n,e,t){let i=n[0]*e[0]+n[1]*e[1]+n[2]*e[2]+n[3]*e[3],r=i<0?-1:1;i=Math.min(1,Math.abs(i));let s=Math.acos(i),o=Math.sin(s),a=o>1e-9?Math.sin((1-t)*s)/o:1-t,l=(o>1e-9?Math.sin(t*s)/o:t)*r;return Av([a*n[0]+l*e[0],a*n[1]+l*e[1],a*n[2]+l*e[2],a*n[3]+l*e[3]])}function Av(n){let e=Math.hypot(...n)||1;return[n[0]/e,n[1]/e,n[2]/e,n[3]/e]}function bo(n,e){let[t,i,r,s]=n,o=2*(r*e[2]-s*e[1]),a=2*(s*e[0]-i*e[2]),l=2*(i*e[1]-r*e[0]);return[e[0]+t*o+r*l-s*a,e[1]+t*a+s*o-i*l,e[2]+t*l+i*a-r*o]}function Gm(n,e){return bo([n[0],-n[1],-n[2],-n[3]],e)}function Fa(n,e){let t=n.columns.attitude,{index:i,share:r}=uc(n.times,e),s=c=>[0,1,2,3].map(u=>t?.[4*c+u]??(u===0?1:0)),o=r===0?s(i):Sv(s(i),s(i+1),r),a=c=>mi(n,c,3,e),l=a("centre")??[0,0,0];return{t:Mv(n,e),attitude:o,centre:l,contact:a("contact")??l}}function Mv(n,e){let{times:t}=n;return Math.min(Math.max(e,t[0]??0),t[t.length-1]??0)}function as(n,e,t){let i=n.columns[e];if(i===void 0)return 0;for(let r=0;r<n.times.length;r++)for(let s=0;s<t;s++)if(!Number.isFinite(i[r*t+s]))return r;return n.times.length}function Na(n){let{start:e}=n.wanted.value;if("inputs"in e)return{...e.inputs};let{motion:t}=n.shown.value,i={};for(let{name:r}of n.model.start_inputs){let s=n.model.state.findIndex(a=>a.name===r),o=s>=0?e.state[s]:Tv(n,r,t.times[0]??0);o!==void 0&&Number.isFinite(o)&&(i[r]=o)}return i}function Tv(n,e,t){let i=e.lastIndexOf("_"),r=n.model.columns.find(o=>o.name===e||o.name===e.slice(0,i));if(r===void 0)return;let s=r.name===e?0:Number(e.slice(i+1))-1;return mi(n.shown.value.motion,r.name,r.width,t)?.[s]}function Xm(n){let{model:e}=n;if(n.engine===null)return null;let t=Ev(e),i=e.start_inputs.map(l=>{let c=sc({...l,symbol:qm(l)},()=>n.mark(),u=>{let h=Na(n),d=dd(h,l.name,u,t.inputs.get(l.name)??NaN);n.change({...n.wanted.value,start:{inputs:d}},!1)});return[l.name,c]}),r=e.parameters.filter(l=>!l.fixed).map(l=>{let[c,u]=oc(l.value,l.low,l.high),h=sc({...l,symbol:qm(l),low:c,high:u},()=>n.mark(),d=>{let f=n.wanted.value;n.change({...f,parameters:dd(f.parameters,l.name,d,l.value)},!1)});return[l.name,h]}),s=sc({name:"until",symbol:document.createTextNode("until"),meaning:"Duration of the motion",unit:"s",value:e.until,low:e.until/20,high:5*e.until},()=>n.mark(),l=>{l>0?n.change({...n.wanted.value,until:l},!1):n.say("The duration must be positive.",!0)}),o=se("p",{class:"lab-hint",hidden:!0},"This start was chosen in a section or chart; a slider takes it from here.");n.wanted.watch(l=>{for(let[c,u]of r)u.set(l.parameters[c]??t.parameters.get(c)??0);s.set(l.until)}),n.shown.watch(()=>{let l=Na(n);o.hidden=!("state"in n.wanted.value.start);for(let[c,u]of i)u.set(l[c]??t.inputs.get(c)??0)}),n.wanted.after(l=>{if(!("state"in l.start))for(let[c,u]of i)u.set(l.start.inputs[c]??t.inputs.get(c)??0)});let a=se("button",{type:"button",class:"lab-button"},"As at first");return a.addEventListener("click",()=>{n.change(Ns(e))}),se("div",{class:"lab-sliders"},Wm("Start",!0,i,o),Wm("Parameters",r.length<=6||innerWidth>620,r,null),se("details",{open:!0},se("summary",{},"Run"),s.element,a))}function Wm(n,e,t,i){return t.length===0?null:se("details",{open:e},se("summary",{},n),...t.map(([,r])=>r.element),i)}function qm({mathml:n,name:e}){return n?rs(n):document.createTextNode(e.replaceAll("_"," "))}function Ev(n){return{inputs:new Map(n.start_inputs.map(e=>[e.name,e.value])),parameters:new Map(n.parameters.map(e=>[e.name,e.value]))}}function $m(n,e,t,i){let r=n,s=[],o=(a,l,c)=>{for(let u of a){let h=Pv(r,u,c);if(h!==null){r=h;return}}s.push(`# ${l} = ${c} was set in the page; this file has no such entry`)};for(let{name:a,value:l}of e)o(Cv(a),a,l);for(let{name:a,value:l}of t)o(Rv(a),a,l);return i!==null&&o([{table:"run",key:"until",indices:[[]]}],"until",i),s.length>0?`${s.join(`
`)}

${r}`:r}function Cv(n){let e=[{table:"system.parameters",key:n,indices:[[]]},{table:"parameters",key:n,indices:[[]]}],t=(s,o,...a)=>[...e,{table:s,key:o,indices:a}],i=/^I_(\d)(\d)$/.exec(n);if(i){let[s,o]=[Number(i[1])-1,Number(i[2])-1];return t("body","inertia",[s,o],...s===o?[]:[[o,s]])}let r=/^I_(\d)$/.exec(n);return r?t("body","inertia",[Number(r[1])-1]):n==="m"?t("body","mass",[]):n==="g"?t("field","gravity",[]):n==="R"?t("body.shape","radius",[]):e}function Rv(n){let e=/^(.+)_(\d)$/.exec(n),t={table:"start",key:n,indices:[[]]};return e?[{table:"start",key:e[1]??n,indices:[[Number(e[2])-1]]},t]:[t]}function Pv(n,{table:e,key:t,indices:i},r){let s=n.split(`
`),o=s.findIndex(a=>a.trim()===`[${e}]`);if(o<0)return null;for(let a=o+1;a<s.length&&!(s[a]??"").trim().startsWith("[");a++){let l=/^(\s*(?:"[^"]*"|[\w.]+)\s*=\s*)(.*)$/.exec(s[a]??"");if(l===null||(l[1]??"").replace(/[\s="]/g,"")!==t)continue;let c=l[2]??"";for(let u of i)c=c===null?null:Iv(c,u,r);return c===null?null:(s[a]=(l[1]??"")+c,s.join(`
`))}return null}var fd=/[-+]?(?:\d[\d_]*\.?\d*(?:[eE][-+]?\d+)?|inf|nan)/;function Iv(n,e,t){if(e.length===0){let o=/^(\{.*?\bvalue\s*=\s*)([-+\d.eE_]+)(.*)$/.exec(n);return o?(o[1]??"")+String(t)+(o[3]??""):new RegExp(`^${fd.source}`).test(n)?n.replace(fd,String(t)):null}let i=e.length,r=new Array(i+1).fill(0),s=0;for(let o=0;o<n.length;o++){let a=n[o];if(a==="[")r[++s]=0;else if(a==="]")s-=1;else if(a===",")r[s]=(r[s]??0)+1;else if(s===i&&e.every((l,c)=>r[c+1]===l)){let l=fd.exec(n.slice(o));if(l===null||l.index!==0)continue;return n.slice(0,o)+String(t)+n.slice(o+l[0].length)}}return null}function _e(n){if(!n)throw new Error("Assertion failed.")}var Lv=Math.PI/180,YP=180/Math.PI;var pd=[1,0,0,0,1,0,0,0,1],Zm=(n,e,t)=>{let[i,r,,s,o]=n,a=Math.abs(i)*e+Math.abs(s)*t,l=Math.abs(r)*e+Math.abs(o)*t;return hc(hc(Ym(-e/2,-t/2),n),Ym(a/2,l/2))};var Km=n=>{let e=n*Lv,t=Math.round(Math.cos(e)),i=Math.round(Math.sin(e));return[t,i,0,-i,t,0,0,0,1]},Ym=(n,e)=>[1,0,0,0,1,0,n,e,1],Jm=(n,e)=>[n,0,0,0,e,0,0,0,1],hc=(n,e)=>{let t=new Array(9);for(let i=0;i<3;i++)for(let r=0;r<3;r++)t[3*i+r]=n[3*i]*e[r]+n[3*i+1]*e[3+r]+n[3*i+2]*e[6+r];return t};var lr=n=>n&&n[n.length-1],cr=n=>n>=0&&n<2**32,jm=n=>n>=-(2**31)&&n<2**31,Re=n=>{let e=0;for(;n.readBits(1)===0&&e<32;)e++;if(e>=32)throw new Error("Invalid exponential-Golomb code.");return(1<<e)-1+n.readBits(e)};var ur=n=>{let e=Re(n);return(e&1)===0?-(e>>1):e+1>>1};var cs=n=>n.constructor===Uint8Array?n:ArrayBuffer.isView(n)?new Uint8Array(n.buffer,n.byteOffset,n.byteLength):new Uint8Array(n),Bs=n=>n.constructor===DataView?n:ArrayBuffer.isView(n)?new DataView(n.buffer,n.byteOffset,n.byteLength):new DataView(n),Fv=typeof globalThis.TextEncoder<"u"?globalThis.TextEncoder:class{constructor(){this.encoding="utf-8"}encode(e=""){let t=new Uint8Array(3*e.length),i=0;for(let r=0;r<e.length;r++){let s=e.charCodeAt(r);if(s<128)t[i++]=s;else if(s<2048)t[i++]=192|s>>6,t[i++]=128|s&63;else if(s<55296||s>57343)t[i++]=224|s>>12,t[i++]=128|s>>6&63,t[i++]=128|s&63;else{let o=r+1<e.length?e.charCodeAt(r+1):0;s<56320&&o>=56320&&o<=57343?(s=65536+(s-55296<<10)+(o-56320),r++,t[i++]=240|s>>18,t[i++]=128|s>>12&63,t[i++]=128|s>>6&63,t[i++]=128|s&63):(t[i++]=239,t[i++]=191,t[i++]=189)}}return t.slice(0,i)}},KP=typeof globalThis.TextDecoder<"u"?globalThis.TextDecoder:class{constructor(e="utf-8"){let t=e.trim().toLowerCase();if(t==="utf-8"||t==="utf8"||t==="unicode-1-1-utf-8")this.encoding="utf-8";else if(t==="utf-16le"||t==="utf-16")this.encoding="utf-16le";else if(t==="utf-16be")this.encoding="utf-16be";else throw new RangeError(`The encoding label provided ('${e}') is invalid.`)}decode(e){let t=e?cs(e):new Uint8Array(0),i=[];if(this.encoding==="utf-8"){let s=t.length>=3&&t[0]===239&&t[1]===187&&t[2]===191?3:0;for(;s<t.length;){let o=t[s];if(o<128){i.push(o),s++;continue}let a,l;if(o>=194&&o<224)a=1,l=o&31;else if(o>=224&&o<240)a=2,l=o&15;else if(o>=240&&o<245)a=3,l=o&7;else{i.push(65533),s++;continue}let c=o===224?160:o===240?144:128,u=o===237?159:o===244?143:191,h=1;for(;h<=a;h++){let d=s+h<t.length?t[s+h]:0;if(d<c||d>u)break;l=l<<6|d&63,c=128,u=191}s+=h,h<=a?i.push(65533):l>=65536?(l-=65536,i.push(55296|l>>10,56320|l&1023)):i.push(l)}}else{let s=this.encoding==="utf-16le",o=s?255:254,a=s?254:255,l=t.length>=2&&t[0]===o&&t[1]===a?2:0;for(;l+1<t.length;){let c=s?t[l]|t[l+1]<<8:t[l]<<8|t[l+1];if(l+=2,c>=55296&&c<=56319){let u=l+1<t.length?s?t[l]|t[l+1]<<8:t[l]<<8|t[l+1]:-1;u>=56320&&u<=57343?(i.push(c,u),l+=2):i.push(65533)}else c>=56320&&c<=57343?i.push(65533):i.push(c)}l<t.length&&i.push(65533)}let r="";for(let s=0;s<i.length;s+=8192)r+=String.fromCharCode(...i.slice(s,s+8192));return r}};var Ei=new Fv;var Ba={bt709:1,bt470bg:5,smpte170m:6,bt2020:9,smpte432:12};var Da={bt709:1,smpte170m:6,linear:8,"iec61966-2-1":13,pq:16,hlg:18};var Ua={rgb:0,bt709:1,bt470bg:5,smpte170m:6,"bt2020-ncl":9};var Qm=n=>!n||n.primaries==null&&n.transfer==null&&n.matrix==null&&n.fullRange==null;var md=n=>n instanceof ArrayBuffer||typeof SharedArrayBuffer<"u"&&n instanceof SharedArrayBuffer||ArrayBuffer.isView(n),vo=class{constructor(){this.currentPromise=Promise.resolve(),this.pending=0}async acquire(){let e,t=new Promise(r=>{let s=!1;e=()=>{s||(r(),this.pending--,s=!0)}}),i=this.currentPromise;return this.currentPromise=t,this.pending++,await i,e}};var eg=()=>{let n,e;return{promise:new Promise((i,r)=>{n=i,e=r}),resolve:n,reject:e}};var wo=n=>{throw new Error(`Unexpected value: ${n}`)};var tg=(n,e,t,i)=>{t=t>>>0,t=t&16777215,i?(n.setUint8(e,t&255),n.setUint8(e+1,t>>>8&255),n.setUint8(e+2,t>>>16&255)):(n.setUint8(e,t>>>16&255),n.setUint8(e+1,t>>>8&255),n.setUint8(e+2,t&255))};var ng="und";var ig=n=>{let e=0;for(;n!==0;)n&=n-1,e++;return e},Nv=/^[a-z]{3}$/,rg=n=>Nv.test(n),gd=1e6*(1+Number.EPSILON);var sg=(n,e)=>{let t=n<0?-1:1;n=Math.abs(n);let i=0,r=1,s=1,o=0,a=n;for(;;){let l=Math.floor(a),c=l*s+i,u=l*o+r;if(u>e)return{num:t*s,den:o};if(i=s,r=o,s=c,o=u,a=1/(a-l),!isFinite(a))break}return{num:t*s,den:o}};var Bv=(async()=>{})().constructor,Oa=n=>n instanceof Bv||n instanceof Promise?!0:typeof n?.then=="function";var dc=function*(n){for(let e in n){let t=n[e];t!==void 0&&(yield{key:e,value:t})}};var og=n=>typeof n=="number"&&!Number.isNaN(n);var ag=n=>{_e(Number.isInteger(n.num)),_e(Number.isInteger(n.den)),_e(n.den!==0);let e=Math.abs(n.num),t=Math.abs(n.den);for(;t!==0;){let r=e%t;e=t,t=r}let i=e||1;return{num:n.num/i,den:n.den/i}};var fc=n=>Array.isArray(n)?n:[n],ls=class{constructor(){this._listeners=new Map}on(e,t,i){this._listeners.has(e)||this._listeners.set(e,new Set);let r={fn:t,once:i?.once??!1};return this._listeners.get(e).add(r),()=>{this._listeners.get(e)?.delete(r)}}_emit(...e){let[t,i]=e,r=this._listeners.get(t);if(r)for(let s of r){try{s.fn(i)}catch(o){console.error(o)}s.once&&r.delete(s)}}};var lg=n=>n!==null&&typeof n=="object"&&Object.getPrototypeOf(n)===Object.prototype&&Object.values(n).every(e=>typeof e=="string");var hr;(function(n){n[n.Silent=0]="Silent",n[n.Errors=1]="Errors",n[n.Warnings=2]="Warnings",n[n.Info=3]="Info"})(hr||(hr={}));var ei=class n{constructor(){}static get level(){return n._level}static set level(e){if(e!==hr.Silent&&e!==hr.Errors&&e!==hr.Warnings&&e!==hr.Info)throw new TypeError("Invalid log level. Use one of the values of the LogLevel enum.");n._level=e}static get _emitter(){return n._emitterInstance??=new ls}static on(e,t,i){return n._emitter.on(e,t,i)}static _error(...e){n._emitter._emit("error",e),n._level>=hr.Errors&&console.error(...e)}static _warn(...e){n._emitter._emit("warn",e),n._level>=hr.Warnings&&console.warn(...e)}static _info(...e){n._emitter._emit("info",e),n._level>=hr.Info&&console.info(...e)}};ei._level=hr.Info;ei._emitterInstance=null;var ka=class{constructor(e,t){if(this.data=e,this.mimeType=t,!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(typeof t!="string")throw new TypeError("mimeType must be a string.")}},xd=class{constructor(e,t,i,r){if(this.data=e,this.mimeType=t,this.name=i,this.description=r,!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(t!==void 0&&typeof t!="string")throw new TypeError("mimeType, when provided, must be a string.");if(i!==void 0&&typeof i!="string")throw new TypeError("name, when provided, must be a string.");if(r!==void 0&&typeof r!="string")throw new TypeError("description, when provided, must be a string.")}},cg=n=>{if(!n||typeof n!="object")throw new TypeError("tags must be an object.");if(n.title!==void 0&&typeof n.title!="string")throw new TypeError("tags.title, when provided, must be a string.");if(n.description!==void 0&&typeof n.description!="string")throw new TypeError("tags.description, when provided, must be a string.");if(n.artist!==void 0&&typeof n.artist!="string")throw new TypeError("tags.artist, when provided, must be a string.");if(n.album!==void 0&&typeof n.album!="string")throw new TypeError("tags.album, when provided, must be a string.");if(n.albumArtist!==void 0&&typeof n.albumArtist!="string")throw new TypeError("tags.albumArtist, when provided, must be a string.");if(n.trackNumber!==void 0&&(!Number.isInteger(n.trackNumber)||n.trackNumber<=0))throw new TypeError("tags.trackNumber, when provided, must be a positive integer.");if(n.tracksTotal!==void 0&&(!Number.isInteger(n.tracksTotal)||n.tracksTotal<=0))throw new TypeError("tags.tracksTotal, when provided, must be a positive integer.");if(n.discNumber!==void 0&&(!Number.isInteger(n.discNumber)||n.discNumber<=0))throw new TypeError("tags.discNumber, when provided, must be a positive integer.");if(n.discsTotal!==void 0&&(!Number.isInteger(n.discsTotal)||n.discsTotal<=0))throw new TypeError("tags.discsTotal, when provided, must be a positive integer.");if(n.genre!==void 0&&typeof n.genre!="string")throw new TypeError("tags.genre, when provided, must be a string.");if(n.date!==void 0&&(!(n.date instanceof Date)||Number.isNaN(n.date.getTime())))throw new TypeError("tags.date, when provided, must be a valid Date.");if(n.beatsPerMinute!==void 0&&(!Number.isInteger(n.beatsPerMinute)||n.beatsPerMinute<=0))throw new TypeError("tags.beatsPerMinute, when provided, must be a positive integer.");if(n.lyrics!==void 0&&typeof n.lyrics!="string")throw new TypeError("tags.lyrics, when provided, must be a string.");if(n.images!==void 0){if(!Array.isArray(n.images))throw new TypeError("tags.images, when provided, must be an array.");for(let e of n.images){if(!e||typeof e!="object")throw new TypeError("Each image in tags.images must be an object.");if(!(e.data instanceof Uint8Array))throw new TypeError("Each image.data must be a Uint8Array.");if(typeof e.mimeType!="string")throw new TypeError("Each image.mimeType must be a string.");if(!["coverFront","coverBack","unknown"].includes(e.kind))throw new TypeError("Each image.kind must be 'coverFront', 'coverBack', or 'unknown'.")}}if(n.comment!==void 0&&typeof n.comment!="string")throw new TypeError("tags.comment, when provided, must be a string.");if(n.raw!==void 0){if(!n.raw||typeof n.raw!="object")throw new TypeError("tags.raw, when provided, must be an object.");for(let e of Object.values(n.raw))if(e!==null&&typeof e!="string"&&!(Array.isArray(e)&&e.every(t=>typeof t=="string"))&&!(e instanceof Uint8Array)&&!(e instanceof ka)&&!(e instanceof xd)&&!lg(e))throw new TypeError("Each value in tags.raw must be a string, string array, Uint8Array, RichImageData, AttachedFile, Record<string, string>, or null.")}};var ug=n=>{if(!n||typeof n!="object")throw new TypeError("disposition must be an object.");if(n.default!==void 0&&typeof n.default!="boolean")throw new TypeError("disposition.default must be a boolean.");if(n.primary!==void 0&&typeof n.primary!="boolean")throw new TypeError("disposition.primary must be a boolean.");if(n.forced!==void 0&&typeof n.forced!="boolean")throw new TypeError("disposition.forced must be a boolean.");if(n.original!==void 0&&typeof n.original!="boolean")throw new TypeError("disposition.original must be a boolean.");if(n.commentary!==void 0&&typeof n.commentary!="boolean")throw new TypeError("disposition.commentary must be a boolean.");if(n.hearingImpaired!==void 0&&typeof n.hearingImpaired!="boolean")throw new TypeError("disposition.hearingImpaired must be a boolean.");if(n.visuallyImpaired!==void 0&&typeof n.visuallyImpaired!="boolean")throw new TypeError("disposition.visuallyImpaired must be a boolean.")};var Bn=class n{constructor(e){this.bytes=e,this.pos=0}seekToByte(e){this.pos=8*e}readBit(){let e=Math.floor(this.pos/8),t=this.bytes[e]??0,i=7-(this.pos&7),r=(t&1<<i)>>i;return this.pos++,r}readBits(e){if(e===1)return this.readBit();let t=0;for(let i=0;i<e;i++)t<<=1,t|=this.readBit();return t}writeBits(e,t){let i=this.pos+e;for(let r=this.pos;r<i;r++){let s=Math.floor(r/8),o=this.bytes[s],a=7-(r&7);o&=~(1<<a),o|=(t&1<<i-r-1)>>i-r-1<<a,this.bytes[s]=o}this.pos=i}copyBits(e,t){let i=0;for(i;i<e-7;i+=8)this.writeBits(8,t.readBits(8));let r=e-i;r>0&&this.writeBits(r,t.readBits(r))}readAlignedByte(){if(this.pos%8!==0)throw new Error("Bitstream is not byte-aligned.");let e=this.pos/8,t=this.bytes[e]??0;return this.pos+=8,t}skipBits(e){this.pos+=e}getBitsLeft(){return this.bytes.length*8-this.pos}clone(){let e=new n(this.bytes);return e.pos=this.pos,e}};var _d=[96e3,88200,64e3,48e3,44100,32e3,24e3,22050,16e3,12e3,11025,8e3,7350],bd=[-1,1,2,3,4,5,6,8];var fg=n=>{let e=n.objectType===5||n.objectType===29,t=n.objectType===29,i=e?n.outputSampleRate/2:n.outputSampleRate,r=t?1:n.outputNumberOfChannels,s=bd.indexOf(r);if(s===-1)throw new TypeError(`Unsupported number of channels: ${n.outputNumberOfChannels}`);let o=16;n.objectType>=32&&(o+=6),yd(i)===15&&(o+=24),e&&(o+=9,yd(n.outputSampleRate)===15&&(o+=24));let a=Math.ceil(o/8),l=new Uint8Array(a),c=new Bn(l);return hg(c,n.objectType),dg(c,i),c.writeBits(4,s),e&&(dg(c,n.outputSampleRate),hg(c,2)),c.writeBits(3,0),l},hg=(n,e)=>{e<32?n.writeBits(5,e):(n.writeBits(5,31),n.writeBits(6,e-32))},dg=(n,e)=>{let t=yd(e);n.writeBits(4,t),t===15&&n.writeBits(24,e)},yd=n=>{let e=_d.indexOf(n);return e===-1?15:e};var pg=[48e3,44100,32e3],mg=[24e3,22050,16e3];var Dv="1.61.0",pc=`Mediabunny v${Dv}`;var za;(function(n){n[n.NON_IDR_SLICE=1]="NON_IDR_SLICE",n[n.SLICE_DPA=2]="SLICE_DPA",n[n.SLICE_DPB=3]="SLICE_DPB",n[n.SLICE_DPC=4]="SLICE_DPC",n[n.IDR=5]="IDR",n[n.SEI=6]="SEI",n[n.SPS=7]="SPS",n[n.PPS=8]="PPS",n[n.AUD=9]="AUD",n[n.SPS_EXT=13]="SPS_EXT"})(za||(za={}));var dr;(function(n){n[n.RASL_N=8]="RASL_N",n[n.RASL_R=9]="RASL_R",n[n.BLA_W_LP=16]="BLA_W_LP",n[n.RSV_IRAP_VCL23=23]="RSV_IRAP_VCL23",n[n.VPS_NUT=32]="VPS_NUT",n[n.SPS_NUT=33]="SPS_NUT",n[n.PPS_NUT=34]="PPS_NUT",n[n.AUD_NUT=35]="AUD_NUT",n[n.PREFIX_SEI_NUT=39]="PREFIX_SEI_NUT",n[n.SUFFIX_SEI_NUT=40]="SUFFIX_SEI_NUT"})(dr||(dr={}));var mc=function*(n){let e=0,t=-1;for(;e<n.length-2;){let i=n.indexOf(0,e);if(i===-1||i>=n.length-2)break;e=i;let r=0;if(e+3<n.length&&n[e+1]===0&&n[e+2]===0&&n[e+3]===1?r=4:n[e+1]===0&&n[e+2]===1&&(r=3),r===0){e++;continue}t!==-1&&e>t&&(yield{offset:t,length:e-t}),t=e+r,e=t}t!==-1&&t<n.length&&(yield{offset:t,length:n.length-t})};var zv=n=>n&31,wd=n=>{let e=[],t=n.length;for(let i=0;i<t;i++)i+2<t&&n[i]===0&&n[i+1]===0&&n[i+2]===3?(e.push(0,0),i+=2):e.push(n[i]);return new Uint8Array(e)};var gI=new Uint8Array([0,0,0,1]);var Sg=(n,e)=>{let t=n.reduce((s,o)=>s+e+o.byteLength,0),i=new Uint8Array(t),r=0;for(let s of n){let o=new DataView(i.buffer,i.byteOffset,i.byteLength);switch(e){case 1:o.setUint8(r,s.byteLength);break;case 2:o.setUint16(r,s.byteLength,!1);break;case 3:tg(o,r,s.byteLength,!1);break;case 4:o.setUint32(r,s.byteLength,!1);break}r+=e,i.set(s,r),r+=s.byteLength}return i};var Ag=n=>{try{let e=[],t=[],i=[];for(let a of mc(n)){let l=n.subarray(a.offset,a.offset+a.length),c=zv(l[0]);c===za.SPS?e.push(l):c===za.PPS?t.push(l):c===za.SPS_EXT&&i.push(l)}if(e.length===0||t.length===0)return null;let r=e[0],s=Vv(r);_e(s!==null);let o=s.profileIdc===100||s.profileIdc===110||s.profileIdc===122||s.profileIdc===144;return{configurationVersion:1,avcProfileIndication:s.profileIdc,profileCompatibility:s.constraintFlags,avcLevelIndication:s.levelIdc,lengthSizeMinusOne:3,sequenceParameterSets:e,pictureParameterSets:t,chromaFormat:o?s.chromaFormatIdc:null,bitDepthLumaMinus8:o?s.bitDepthLumaMinus8:null,bitDepthChromaMinus8:o?s.bitDepthChromaMinus8:null,sequenceParameterSetExt:o?i:null}}catch(e){return ei._error("Error building AVC Decoder Configuration Record:",e),null}},Mg=n=>{let e=[];e.push(n.configurationVersion),e.push(n.avcProfileIndication),e.push(n.profileCompatibility),e.push(n.avcLevelIndication),e.push(252|n.lengthSizeMinusOne&3),e.push(224|n.sequenceParameterSets.length&31);for(let t of n.sequenceParameterSets){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}e.push(n.pictureParameterSets.length);for(let t of n.pictureParameterSets){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}if((n.avcProfileIndication===100||n.avcProfileIndication===110||n.avcProfileIndication===122||n.avcProfileIndication===144)&&n.chromaFormat!==null){_e(n.bitDepthLumaMinus8!==null),_e(n.bitDepthChromaMinus8!==null),_e(n.sequenceParameterSetExt!==null),e.push(252|n.chromaFormat&3),e.push(248|n.bitDepthLumaMinus8&7),e.push(248|n.bitDepthChromaMinus8&7),e.push(n.sequenceParameterSetExt.length);for(let t of n.sequenceParameterSetExt){let i=t.byteLength;e.push(i>>8),e.push(i&255);for(let r=0;r<i;r++)e.push(t[r])}}return new Uint8Array(e)};var Tg={1:{num:1,den:1},2:{num:12,den:11},3:{num:10,den:11},4:{num:16,den:11},5:{num:40,den:33},6:{num:24,den:11},7:{num:20,den:11},8:{num:32,den:11},9:{num:80,den:33},10:{num:18,den:11},11:{num:15,den:11},12:{num:64,den:33},13:{num:160,den:99},14:{num:4,den:3},15:{num:3,den:2},16:{num:2,den:1}},Vv=n=>{try{let e=wd(n),t=new Bn(e);if(t.skipBits(1),t.skipBits(2),t.readBits(5)!==7)return null;let r=t.readAlignedByte(),s=t.readAlignedByte(),o=t.readAlignedByte();Re(t);let a=1,l=0,c=0,u=0;if((r===100||r===110||r===122||r===244||r===44||r===83||r===86||r===118||r===128)&&(a=Re(t),a===3&&(u=t.readBits(1)),l=Re(t),c=Re(t),t.skipBits(1),t.readBits(1))){for(let W=0;W<(a!==3?8:12);W++)if(t.readBits(1)){let ae=W<6?16:64,X=8,J=8;for(let ee=0;ee<ae;ee++){if(J!==0){let ue=ur(t);J=(X+ue+256)%256}X=J===0?X:J}}}Re(t);let h=Re(t);if(h===0)Re(t);else if(h===1){t.skipBits(1),ur(t),ur(t);let V=Re(t);for(let W=0;W<V;W++)ur(t)}Re(t),t.skipBits(1);let d=Re(t),f=Re(t),m=16*(d+1),b=16*(f+1),g=m,p=b,_=t.readBits(1);if(_||t.skipBits(1),t.skipBits(1),t.readBits(1)){let V=Re(t),W=Re(t),z=Re(t),ae=Re(t),X,J;if((u===0?a:0)===0)X=1,J=2-_;else{let ue=a===3?1:2,he=a===1?2:1;X=ue,J=he*(2-_)}g-=X*(V+W),p-=J*(z+ae)}let w=2,C=2,E=2,x=0,M={num:1,den:1},O=null,N=null,I=null,U=null,H=t.pos;if(t.readBits(1)){if(t.readBits(1)){let ue=t.readBits(8);if(ue===255)M={num:t.readBits(16),den:t.readBits(16)};else{let he=Tg[ue];he&&(M=he)}}t.readBits(1)&&t.skipBits(1),t.readBits(1)&&(t.skipBits(3),x=t.readBits(1),t.readBits(1)&&(w=t.readBits(8),C=t.readBits(8),E=t.readBits(8))),t.readBits(1)&&(Re(t),Re(t)),t.readBits(1)&&(t.skipBits(32),t.skipBits(32),t.skipBits(1));let J=t.readBits(1);J&&gg(t);let ee=t.readBits(1);ee&&gg(t),(J||ee)&&t.skipBits(1),t.skipBits(1),I=t.pos,U=t.readBits(1),U&&(t.skipBits(1),Re(t),Re(t),Re(t),Re(t),O=Re(t),N=Re(t))}if(O===null){_e(N===null);let V=s&16;if((r===44||r===86||r===100||r===110||r===122||r===244)&&V)O=0,N=0;else{let W=d+1,z=f+1,ae=(2-_)*z,X=vd.find(ee=>ee.level>=o)??lr(vd),J=Math.min(Math.floor(X.maxDpbMbs/(W*ae)),16);O=J,N=J}}return _e(N!==null),{emulationUnpreventedBytes:e,profileIdc:r,constraintFlags:s,levelIdc:o,frameMbsOnlyFlag:_,chromaFormatIdc:a,bitDepthLumaMinus8:l,bitDepthChromaMinus8:c,codedWidth:m,codedHeight:b,displayWidth:g,displayHeight:p,pixelAspectRatio:M,colourPrimaries:w,matrixCoefficients:E,transferCharacteristics:C,fullRangeFlag:x,numReorderFrames:O,maxDecFrameBuffering:N,vuiParametersFlagBitOffset:H,bitstreamRestrictionFlagBitOffset:I,bitstreamRestrictionFlag:U}}catch(e){return ei._error("Error parsing AVC SPS:",e),null}},gg=n=>{let e=Re(n);n.skipBits(4),n.skipBits(4);for(let t=0;t<=e;t++)Re(n),Re(n),n.skipBits(1);n.skipBits(5),n.skipBits(5),n.skipBits(5),n.skipBits(5)};var xg=n=>n>>1&63,Hv=n=>{try{let e=new Bn(wd(n));e.skipBits(16),e.readBits(4);let t=e.readBits(3),i=e.readBits(1),{general_profile_space:r,general_tier_flag:s,general_profile_idc:o,general_profile_compatibility_flags:a,general_constraint_indicator_flags:l,general_level_idc:c}=Gv(e,t);Re(e);let u=Re(e),h=0;u===3&&(h=e.readBits(1));let d=Re(e),f=Re(e),m=d,b=f;if(e.readBits(1)){let U=Re(e),H=Re(e),L=Re(e),V=Re(e),W=1,z=1,ae=h===0?u:0;ae===1?(W=2,z=2):ae===2&&(W=2,z=1),m-=(U+H)*W,b-=(L+V)*z}let g=Re(e),p=Re(e);Re(e);let T=e.readBits(1)?0:t,w=0;for(let U=T;U<=t;U++)Re(e),w=Re(e),Re(e);Re(e),Re(e),Re(e),Re(e),Re(e),Re(e),e.readBits(1)&&e.readBits(1)&&Wv(e),e.skipBits(1),e.skipBits(1),e.readBits(1)&&(e.skipBits(4),e.skipBits(4),Re(e),Re(e),e.skipBits(1));let C=Re(e);if(qv(e,C),e.readBits(1)){let U=Re(e);for(let H=0;H<U;H++)Re(e),e.skipBits(1)}e.skipBits(1),e.skipBits(1);let E=2,x=2,M=2,O=0,N=0,I={num:1,den:1};if(e.readBits(1)){let U=$v(e,t);I=U.pixelAspectRatio,E=U.colourPrimaries,x=U.transferCharacteristics,M=U.matrixCoefficients,O=U.fullRangeFlag,N=U.minSpatialSegmentationIdc}return{displayWidth:m,displayHeight:b,pixelAspectRatio:I,colourPrimaries:E,transferCharacteristics:x,matrixCoefficients:M,fullRangeFlag:O,maxDecFrameBuffering:w+1,spsMaxSubLayersMinus1:t,spsTemporalIdNestingFlag:i,generalProfileSpace:r,generalTierFlag:s,generalProfileIdc:o,generalProfileCompatibilityFlags:a,generalConstraintIndicatorFlags:l,generalLevelIdc:c,chromaFormatIdc:u,bitDepthLumaMinus8:g,bitDepthChromaMinus8:p,minSpatialSegmentationIdc:N}}catch(e){return ei._error("Error parsing HEVC SPS:",e),null}},Eg=n=>{try{let e=[],t=[],i=[],r=[];for(let c of mc(n)){let u=n.subarray(c.offset,c.offset+c.length),h=xg(u[0]);h===dr.VPS_NUT?e.push(u):h===dr.SPS_NUT?t.push(u):h===dr.PPS_NUT?i.push(u):(h===dr.PREFIX_SEI_NUT||h===dr.SUFFIX_SEI_NUT)&&r.push(u)}if(t.length===0||i.length===0)return null;let s=Hv(t[0]);if(!s)return null;let o=0;if(i.length>0){let c=i[0],u=new Bn(wd(c));u.skipBits(16),Re(u),Re(u),u.skipBits(1),u.skipBits(1),u.skipBits(3),u.skipBits(1),u.skipBits(1),Re(u),Re(u),ur(u),u.skipBits(1),u.skipBits(1),u.readBits(1)&&Re(u),ur(u),ur(u),u.skipBits(1),u.skipBits(1),u.skipBits(1),u.skipBits(1);let h=u.readBits(1),d=u.readBits(1);!h&&!d?o=0:h&&!d?o=2:!h&&d?o=3:o=0}let a=[...e.length?[{arrayCompleteness:1,nalUnitType:dr.VPS_NUT,nalUnits:e}]:[],...t.length?[{arrayCompleteness:1,nalUnitType:dr.SPS_NUT,nalUnits:t}]:[],...i.length?[{arrayCompleteness:1,nalUnitType:dr.PPS_NUT,nalUnits:i}]:[],...r.length?[{arrayCompleteness:1,nalUnitType:xg(r[0][0]),nalUnits:r}]:[]];return{configurationVersion:1,generalProfileSpace:s.generalProfileSpace,generalTierFlag:s.generalTierFlag,generalProfileIdc:s.generalProfileIdc,generalProfileCompatibilityFlags:s.generalProfileCompatibilityFlags,generalConstraintIndicatorFlags:s.generalConstraintIndicatorFlags,generalLevelIdc:s.generalLevelIdc,minSpatialSegmentationIdc:s.minSpatialSegmentationIdc,parallelismType:o,chromaFormatIdc:s.chromaFormatIdc,bitDepthLumaMinus8:s.bitDepthLumaMinus8,bitDepthChromaMinus8:s.bitDepthChromaMinus8,avgFrameRate:0,constantFrameRate:0,numTemporalLayers:s.spsMaxSubLayersMinus1+1,temporalIdNested:s.spsTemporalIdNestingFlag,lengthSizeMinusOne:3,arrays:a}}catch(e){return ei._error("Error building HEVC Decoder Configuration Record:",e),null}},Gv=(n,e)=>{let t=n.readBits(2),i=n.readBits(1),r=n.readBits(5),s=0;for(let u=0;u<32;u++)s=s<<1|n.readBits(1);let o=new Uint8Array(6);for(let u=0;u<6;u++)o[u]=n.readBits(8);let a=n.readBits(8),l=[],c=[];for(let u=0;u<e;u++)l.push(n.readBits(1)),c.push(n.readBits(1));if(e>0)for(let u=e;u<8;u++)n.skipBits(2);for(let u=0;u<e;u++)l[u]&&n.skipBits(88),c[u]&&n.skipBits(8);return{general_profile_space:t,general_tier_flag:i,general_profile_idc:r,general_profile_compatibility_flags:s,general_constraint_indicator_flags:o,general_level_idc:a}},Wv=n=>{for(let e=0;e<4;e++)for(let t=0;t<(e===3?2:6);t++)if(!n.readBits(1))Re(n);else{let r=Math.min(64,1<<4+(e<<1));e>1&&ur(n);for(let s=0;s<r;s++)ur(n)}},qv=(n,e)=>{let t=[];for(let i=0;i<e;i++)t[i]=Xv(n,i,e,t)},Xv=(n,e,t,i)=>{let r=0,s=0,o=0;if(e!==0&&(s=n.readBits(1)),s){if(e===t){let l=Re(n);o=e-(l+1)}else o=e-1;n.readBits(1),Re(n);let a=i[o]??0;for(let l=0;l<=a;l++)n.readBits(1)||n.readBits(1);r=i[o]}else{let a=Re(n),l=Re(n);for(let c=0;c<a;c++)Re(n),n.readBits(1);for(let c=0;c<l;c++)Re(n),n.readBits(1);r=a+l}return r},$v=(n,e)=>{let t=2,i=2,r=2,s=0,o=0,a={num:1,den:1};if(n.readBits(1)){let l=n.readBits(8);if(l===255)a={num:n.readBits(16),den:n.readBits(16)};else{let c=Tg[l];c&&(a=c)}}return n.readBits(1)&&n.readBits(1),n.readBits(1)&&(n.readBits(3),s=n.readBits(1),n.readBits(1)&&(t=n.readBits(8),i=n.readBits(8),r=n.readBits(8))),n.readBits(1)&&(Re(n),Re(n)),n.readBits(1),n.readBits(1),n.readBits(1),n.readBits(1)&&(Re(n),Re(n),Re(n),Re(n)),n.readBits(1)&&(n.readBits(32),n.readBits(32),n.readBits(1)&&Re(n),n.readBits(1)&&Yv(n,!0,e)),n.readBits(1)&&(n.readBits(1),n.readBits(1),n.readBits(1),o=Re(n),Re(n),Re(n),Re(n),Re(n)),{pixelAspectRatio:a,colourPrimaries:t,transferCharacteristics:i,matrixCoefficients:r,fullRangeFlag:s,minSpatialSegmentationIdc:o}},Yv=(n,e,t)=>{let i=!1,r=!1,s=!1;e&&(i=n.readBits(1)===1,r=n.readBits(1)===1,(i||r)&&(s=n.readBits(1)===1,s&&(n.readBits(8),n.readBits(5),n.readBits(1),n.readBits(5)),n.readBits(4),n.readBits(4),s&&n.readBits(4),n.readBits(5),n.readBits(5),n.readBits(5)));for(let o=0;o<=t;o++){let a=n.readBits(1)===1,l=!0;a||(l=n.readBits(1)===1);let c=!1;l?Re(n):c=n.readBits(1)===1;let u=1;c||(u=Re(n)+1),i&&yg(n,u,s),r&&yg(n,u,s)}},yg=(n,e,t)=>{for(let i=0;i<e;i++)Re(n),Re(n),t&&(Re(n),Re(n)),n.readBits(1)},Cg=n=>{let e=[];e.push(n.configurationVersion),e.push((n.generalProfileSpace&3)<<6|(n.generalTierFlag&1)<<5|n.generalProfileIdc&31),e.push(n.generalProfileCompatibilityFlags>>>24&255),e.push(n.generalProfileCompatibilityFlags>>>16&255),e.push(n.generalProfileCompatibilityFlags>>>8&255),e.push(n.generalProfileCompatibilityFlags&255),e.push(...n.generalConstraintIndicatorFlags),e.push(n.generalLevelIdc&255),e.push(240|n.minSpatialSegmentationIdc>>8&15),e.push(n.minSpatialSegmentationIdc&255),e.push(252|n.parallelismType&3),e.push(252|n.chromaFormatIdc&3),e.push(248|n.bitDepthLumaMinus8&7),e.push(248|n.bitDepthChromaMinus8&7),e.push(n.avgFrameRate>>8&255),e.push(n.avgFrameRate&255),e.push((n.constantFrameRate&3)<<6|(n.numTemporalLayers&7)<<3|(n.temporalIdNested&1)<<2|n.lengthSizeMinusOne&3),e.push(n.arrays.length&255);for(let t of n.arrays){e.push((t.arrayCompleteness&1)<<7|0|t.nalUnitType&63),e.push(t.nalUnits.length>>8&255),e.push(t.nalUnits.length&255);for(let i of t.nalUnits){e.push(i.length>>8&255),e.push(i.length&255);for(let r=0;r<i.length;r++)e.push(i[r])}}return new Uint8Array(e)};var _g;(function(n){n[n.audAllowed=0]="audAllowed",n[n.beforeFirstVcl=1]="beforeFirstVcl",n[n.afterFirstVcl=2]="afterFirstVcl",n[n.eoBitstreamAllowed=3]="eoBitstreamAllowed",n[n.noMoreDataAllowed=4]="noMoreDataAllowed"})(_g||(_g={}));var Rg=n=>{let e=Bs(n),t=e.getUint8(9),i=e.getUint16(10,!0),r=e.getUint32(12,!0),s=e.getInt16(16,!0),o=e.getUint8(18),a=null;return o&&(a=n.subarray(19,21+t)),{outputChannelCount:t,preSkip:i,inputSampleRate:r,outputGain:s,channelMappingFamily:o,channelMappingTable:a}};var bg;(function(n){n[n.STREAMINFO=0]="STREAMINFO",n[n.VORBIS_COMMENT=4]="VORBIS_COMMENT",n[n.PICTURE=6]="PICTURE"})(bg||(bg={}));var Pg=n=>{if(n.length<7||n[0]!==11||n[1]!==119)return null;let e=new Bn(n);e.skipBits(16),e.skipBits(16);let t=e.readBits(2);if(t===3)return null;let i=e.readBits(6),r=e.readBits(5);if(r>8)return null;let s=e.readBits(3),o=e.readBits(3);(o&1)!==0&&o!==1&&e.skipBits(2),(o&4)!==0&&e.skipBits(2),o===2&&e.skipBits(2);let a=e.readBits(1),l=Math.floor(i/2);return{fscod:t,bsid:r,bsmod:s,acmod:o,lfeon:a,bitRateCode:l}},xI=[128,138,192,128,140,192,160,174,240,160,176,240,192,208,288,192,210,288,224,242,336,224,244,336,256,278,384,256,280,384,320,348,480,320,350,480,384,416,288*2,384,418,288*2,448,486,336*2,448,488,336*2,256*2,278*2,384*2,256*2,279*2,384*2,320*2,348*2,480*2,320*2,349*2,480*2,384*2,417*2,576*2,384*2,418*2,576*2,448*2,487*2,672*2,448*2,488*2,672*2,512*2,557*2,768*2,512*2,558*2,768*2,640*2,696*2,960*2,640*2,697*2,960*2,768*2,835*2,1152*2,768*2,836*2,1152*2,896*2,975*2,1344*2,896*2,976*2,1344*2,1024*2,1114*2,1536*2,1024*2,1115*2,1536*2,1152*2,1253*2,1728*2,1152*2,1254*2,1728*2,1280*2,1393*2,1920*2,1280*2,1394*2,1920*2];var yI=new Uint8Array([5,4,65,67,45,51]),_I=new Uint8Array([5,4,69,65,67,51]),Zv=[1,2,3,6],Ig=n=>{if(n.length<6||n[0]!==11||n[1]!==119)return null;let e=new Bn(n);e.skipBits(16);let t=e.readBits(2);if(e.skipBits(3),t!==0&&t!==2)return null;let i=e.readBits(11),r=e.readBits(2),s=0,o;r===3?(s=e.readBits(2),o=3):o=e.readBits(2);let a=e.readBits(3),l=e.readBits(1),c=e.readBits(5);if(c<11||c>16)return null;let u=Zv[o],h;return r<3?h=pg[r]/1e3:h=mg[s]/1e3,{dataRate:Math.round((i+1)*h/(u*16)),substreams:[{fscod:r,fscod2:s,bsid:c,bsmod:0,acmod:a,lfeon:l,numDepSub:0,chanLoc:0}]}};var Kv=1683496997,Jv=18,jv=10;var vg=32,Qv=20,ew=8,tw=[0,8e3,16e3,32e3,0,0,11025,22050,44100,0,0,12e3,24e3,48e3,96e3,192e3],nw=[32e3,56e3,64e3,96e3,112e3,128e3,192e3,224e3,256e3,32e4,384e3,448e3,512e3,576e3,64e4,768e3,96e4,1024e3,1152e3,128e4,1344e3,1408e3,1411200,1472e3,1536e3,192e4,2048e3,3072e3,384e4,0,0,0],iw=[16,16,20,20,0,24,24,0],wg=[1,2,2,2,2,3,3,4,4,5,6,6,6,7,8,8],rw=[1,2,2,2,2,3,18,19,6,7,518,323,83,519,582,535],sw=8;var ow=[32e3,44100,48e3,0],aw=[8e3,16e3,32e3,64e3,128e3,22050,44100,88200,176400,352800,12e3,24e3,48e3,96e3,192e3,384e3],lw=[512,1024,2048,4096],Lg=n=>{let e=cw(n),t=Bs(n),i=e?Math.ceil(e.frameSize/4)*4:0,r=null;for(;i+4<=n.length&&t.getUint32(i)===Kv;){let o=uw(n.subarray(i));if(!o)break;r??=o,i+=o.frameSize}if(e)return{frameSize:r?i:e.frameSize,sampleRate:e.sampleRate,numberOfChannels:e.numberOfChannels,sampleCount:e.sampleCount,channelLayout:e.channelLayout,pcmResolution:e.pcmResolution,bitRate:e.bitRate,core:e,hasExtensions:r!==null};if(!r?.asset)return null;let{asset:s}=r;return{frameSize:i,sampleRate:s.sampleRate,numberOfChannels:s.numberOfChannels,sampleCount:s.sampleCount,channelLayout:s.channelLayout,pcmResolution:s.pcmResolution,bitRate:0,core:null,hasExtensions:!0}};var cw=n=>{if(n.length<Jv||n[0]!==127||n[1]!==254||n[2]!==128||n[3]!==1)return null;let e=new Bn(n);if(e.skipBits(32),e.skipBits(1),e.readBits(5)!==vg-1)return null;let t=e.readBits(1),i=e.readBits(7)+1;if(i%ew!==0)return null;let r=e.readBits(14)+1;if(r<96)return null;let s=e.readBits(6);if(s>=wg.length)return null;let o=tw[e.readBits(4)];if(o===0)return null;let a=nw[e.readBits(5)];if(e.readBits(1)!==0)return null;e.skipBits(4),e.skipBits(5);let l=e.readBits(2);if(l===3)return null;e.skipBits(1),t&&e.skipBits(16),e.skipBits(7);let c=iw[e.readBits(3)];if(c===0)return null;let u=l!==0;return{frameSize:r,sampleRate:o,numberOfChannels:wg[s]+(u?1:0),sampleCount:i*vg,channelLayout:rw[s]|(u?sw:0),amode:s,lfePresent:u,bitRate:a,pcmResolution:c}},uw=n=>{if(n.length<jv||n[0]!==100||n[1]!==88||n[2]!==32||n[3]!==37)return null;let e=new Bn(n);e.skipBits(32),e.skipBits(8);let t=e.readBits(2),i=e.readBits(1),r=8+4*i,s=16+4*i;e.skipBits(r);let o=e.readBits(s)+1,a={frameSize:o,asset:null};if(!e.readBits(1))return a;let l=ow[e.readBits(2)],c=512*(e.readBits(3)+1);e.readBits(1)&&e.skipBits(36);let u=e.readBits(3)+1,h=e.readBits(3)+1,d=[];for(let p=0;p<u;p++)d.push(e.readBits(t+1));for(let p of d)e.skipBits(8*ig(p));if(e.readBits(1)){e.skipBits(2);let p=e.readBits(2)+1<<2,_=e.readBits(2)+1;e.skipBits(_*p)}for(let p=0;p<h;p++)e.skipBits(s);e.skipBits(9),e.skipBits(3),e.readBits(1)&&e.skipBits(4),e.readBits(1)&&e.skipBits(24),e.readBits(1)&&e.skipBits(8*(e.readBits(10)+1));let f=e.readBits(5)+1,m=aw[e.readBits(4)],b=e.readBits(8)+1,g=0;if(e.readBits(1)&&(b>2&&e.skipBits(1),b>6&&e.skipBits(1),e.readBits(1))){let p=e.readBits(2)+1<<2;g=e.readBits(p)}return l===0||e.getBitsLeft()<0?a:{frameSize:o,asset:{sampleRate:m,numberOfChannels:b,sampleCount:Math.round(c*m/l),channelLayout:g,pcmResolution:f}}};var Fg=n=>{let e=new Uint8Array(Qv),t=Bs(e);t.setUint32(0,n.sampleRate),t.setUint32(4,n.bitRate),t.setUint32(8,n.bitRate),e[12]=n.pcmResolution;let i=n.core&&!n.hasExtensions?1:0,r=new Bn(e);return r.seekToByte(13),r.writeBits(2,Math.max(lw.indexOf(n.sampleCount),0)),r.writeBits(5,i),r.writeBits(1,n.core?.lfePresent?1:0),r.writeBits(6,n.core?.amode??0),r.writeBits(14,n.core?n.core.frameSize-1:0),r.writeBits(1,0),r.writeBits(3,0),r.writeBits(16,n.channelLayout),r.writeBits(1,0),r.writeBits(1,0),r.writeBits(1,0),r.writeBits(5,0),e};var us=["avc","hevc","vp9","av1","vp8","prores"],fr=["pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be","pcm-u8","pcm-s8","ulaw","alaw"],gc=["aac","opus","mp3","vorbis","flac","ac3","eac3","dts"],So=[...gc,...fr],Ds=["webvtt"],vd=[{maxMacroblocks:99,maxBitrate:64e3,maxDpbMbs:396,level:10},{maxMacroblocks:396,maxBitrate:192e3,maxDpbMbs:900,level:11},{maxMacroblocks:396,maxBitrate:384e3,maxDpbMbs:2376,level:12},{maxMacroblocks:396,maxBitrate:768e3,maxDpbMbs:2376,level:13},{maxMacroblocks:396,maxBitrate:2e6,maxDpbMbs:2376,level:20},{maxMacroblocks:792,maxBitrate:4e6,maxDpbMbs:4752,level:21},{maxMacroblocks:1620,maxBitrate:4e6,maxDpbMbs:8100,level:22},{maxMacroblocks:1620,maxBitrate:1e7,maxDpbMbs:8100,level:30},{maxMacroblocks:3600,maxBitrate:14e6,maxDpbMbs:18e3,level:31},{maxMacroblocks:5120,maxBitrate:2e7,maxDpbMbs:20480,level:32},{maxMacroblocks:8192,maxBitrate:2e7,maxDpbMbs:32768,level:40},{maxMacroblocks:8192,maxBitrate:5e7,maxDpbMbs:32768,level:41},{maxMacroblocks:8704,maxBitrate:5e7,maxDpbMbs:34816,level:42},{maxMacroblocks:22080,maxBitrate:135e6,maxDpbMbs:110400,level:50},{maxMacroblocks:36864,maxBitrate:24e7,maxDpbMbs:184320,level:51},{maxMacroblocks:36864,maxBitrate:24e7,maxDpbMbs:184320,level:52},{maxMacroblocks:139264,maxBitrate:24e7,maxDpbMbs:696320,level:60},{maxMacroblocks:139264,maxBitrate:48e7,maxDpbMbs:696320,level:61},{maxMacroblocks:139264,maxBitrate:8e8,maxDpbMbs:696320,level:62}];var Va=["ap4x","ap4h","apch","apcn","apcs","apco"],Sd=["dtsc","dtsh","dtsl","dtse"];var Ng=n=>{let e=n.split("."),r=(1<<7)+1,s=Number(e[1]),o=e[2],a=Number(o.slice(0,-1)),l=(s<<5)+a,c=o.slice(-1)==="H"?1:0,u=Number(e[3]),h=u===8?0:1,d=u===12?1:0,f=e[4]?Number(e[4]):0,m=e[5]?Number(e[5][0]):1,b=e[5]?Number(e[5][1]):1,g=e[5]?Number(e[5][2]):0,p=(c<<7)+(h<<6)+(d<<5)+(f<<4)+(m<<3)+(b<<2)+g;return[r,l,p,0]};var Bg=/^pcm-([usf])(\d+)(be)?$/,Fr=n=>{if(_e(fr.includes(n)),n==="ulaw")return{dataType:"ulaw",sampleSize:1,littleEndian:!0,silentValue:255};if(n==="alaw")return{dataType:"alaw",sampleSize:1,littleEndian:!0,silentValue:213};let e=Bg.exec(n);_e(e);let t;e[1]==="u"?t="unsigned":e[1]==="s"?t="signed":t="float";let i=Number(e[2])/8,r=e[3]!=="be",s=n==="pcm-u8"?2**7:0;return{dataType:t,sampleSize:i,littleEndian:r,silentValue:s}},Dg=n=>n.startsWith("avc1")||n.startsWith("avc3")?"avc":n.startsWith("hev1")||n.startsWith("hvc1")?"hevc":n==="vp8"?"vp8":n.startsWith("vp09")?"vp9":n.startsWith("av01")?"av1":Va.includes(n)?"prores":n==="mp3"||n==="mp4a.69"||n==="mp4a.6B"||n==="mp4a.6b"||n==="mp4a.40.34"?"mp3":n.startsWith("mp4a.40.")||n==="mp4a.67"?"aac":n==="opus"||n==="Opus"?"opus":n==="vorbis"?"vorbis":n==="flac"?"flac":n==="ac-3"||n==="ac3"?"ac3":n==="ec-3"||n==="eac3"?"eac3":Sd.includes(n)?"dts":n==="ulaw"?"ulaw":n==="alaw"?"alaw":Bg.test(n)?n:n==="webvtt"?"webvtt":null;var hw=["avc1","avc3","hev1","hvc1","vp8","vp09","av01",...Va],dw=/^(avc1|avc3)\.[0-9a-fA-F]{6}$/,fw=/^(hev1|hvc1)\.(?:[ABC]?\d+)\.[0-9a-fA-F]{1,8}\.[LH]\d+(?:\.[0-9a-fA-F]{1,2}){0,6}$/,pw=/^vp09(?:\.\d{2}){3}(?:(?:\.\d{2}){5})?$/,mw=/^av01\.\d\.\d{2}[MH]\.\d{2}(?:\.\d\.\d{3}\.\d{2}\.\d{2}\.\d{2}\.\d)?$/,xc=(n,e)=>{if(!n)throw new TypeError("Video chunk metadata must be provided.");if(typeof n!="object")throw new TypeError("Video chunk metadata must be an object.");if(!n.decoderConfig)throw new TypeError("Video chunk metadata must include a decoder configuration.");if(typeof n.decoderConfig!="object")throw new TypeError("Video chunk metadata decoder configuration must be an object.");if(typeof n.decoderConfig.codec!="string")throw new TypeError("Video chunk metadata decoder configuration must specify a codec string.");if(!hw.some(t=>n.decoderConfig.codec.startsWith(t)))throw new TypeError("Video chunk metadata decoder configuration codec string must be a valid video codec string as specified in the Mediabunny Codec Registry.");if(!Number.isInteger(n.decoderConfig.codedWidth)||n.decoderConfig.codedWidth<=0)throw new TypeError("Video chunk metadata decoder configuration must specify a valid codedWidth (positive integer).");if(!Number.isInteger(n.decoderConfig.codedHeight)||n.decoderConfig.codedHeight<=0)throw new TypeError("Video chunk metadata decoder configuration must specify a valid codedHeight (positive integer).");if(n.decoderConfig.displayAspectWidth!==void 0&&(!Number.isInteger(n.decoderConfig.displayAspectWidth)||n.decoderConfig.displayAspectWidth<=0))throw new TypeError("Video chunk metadata decoder configuration displayAspectWidth, when defined, must be a positive integer.");if(n.decoderConfig.displayAspectHeight!==void 0&&(!Number.isInteger(n.decoderConfig.displayAspectHeight)||n.decoderConfig.displayAspectHeight<=0))throw new TypeError("Video chunk metadata decoder configuration displayAspectHeight, when defined, must be a positive integer.");if(n.decoderConfig.displayAspectWidth!==void 0!=(n.decoderConfig.displayAspectHeight!==void 0))throw new TypeError("Video chunk metadata decoder configuration must specify both displayAspectWidth and displayAspectHeight, or neither.");if(n.decoderConfig.description!==void 0&&!md(n.decoderConfig.description))throw new TypeError("Video chunk metadata decoder configuration description, when defined, must be an ArrayBuffer or an ArrayBuffer view.");if(n.decoderConfig.colorSpace!==void 0){let{colorSpace:t}=n.decoderConfig;if(typeof t!="object")throw new TypeError("Video chunk metadata decoder configuration colorSpace, when provided, must be an object.");let i=Object.keys(Ba);if(t.primaries!=null&&!i.includes(t.primaries))throw new TypeError(`Video chunk metadata decoder configuration colorSpace primaries, when defined, must be one of ${i.join(", ")}.`);let r=Object.keys(Da);if(t.transfer!=null&&!r.includes(t.transfer))throw new TypeError(`Video chunk metadata decoder configuration colorSpace transfer, when defined, must be one of ${r.join(", ")}.`);let s=Object.keys(Ua);if(t.matrix!=null&&!s.includes(t.matrix))throw new TypeError(`Video chunk metadata decoder configuration colorSpace matrix, when defined, must be one of ${s.join(", ")}.`);if(t.fullRange!=null&&typeof t.fullRange!="boolean")throw new TypeError("Video chunk metadata decoder configuration colorSpace fullRange, when defined, must be a boolean.")}if(n.decoderConfig.codec.startsWith("avc1")||n.decoderConfig.codec.startsWith("avc3")){if(!dw.test(n.decoderConfig.codec))throw new TypeError("Video chunk metadata decoder configuration codec string for AVC must be a valid AVC codec string as specified in Section 3.4 of RFC 6381.")}else if(n.decoderConfig.codec.startsWith("hev1")||n.decoderConfig.codec.startsWith("hvc1")){if(!fw.test(n.decoderConfig.codec))throw new TypeError("Video chunk metadata decoder configuration codec string for HEVC must be a valid HEVC codec string as specified in Section E.3 of ISO 14496-15.")}else if(n.decoderConfig.codec.startsWith("vp8")){if(n.decoderConfig.codec!=="vp8")throw new TypeError('Video chunk metadata decoder configuration codec string for VP8 must be "vp8".')}else if(n.decoderConfig.codec.startsWith("vp09")){if(!pw.test(n.decoderConfig.codec))throw new TypeError('Video chunk metadata decoder configuration codec string for VP9 must be a valid VP9 codec string as specified in Section "Codecs Parameter String" of https://www.webmproject.org/vp9/mp4/.')}else if(n.decoderConfig.codec.startsWith("av01")){if(!mw.test(n.decoderConfig.codec))throw new TypeError('Video chunk metadata decoder configuration codec string for AV1 must be a valid AV1 codec string as specified in Section "Codecs Parameter String" of https://aomediacodec.github.io/av1-isobmff/.')}else if(Va.some(t=>n.decoderConfig.codec.startsWith(t))&&!Va.some(t=>n.decoderConfig.codec===t))throw new TypeError(`Video chunk metadata decoder configuration codec string for ProRes must be one of the valid ProRes four-character codes: ${Va.join(", ")}.`);if(e!==null&&Dg(n.decoderConfig.codec)!==e)throw new TypeError(`Video chunk metadata decoder configuration codec string '${n.decoderConfig.codec}' does not fit to the track codec '${e}'.`)},gw=["mp4a","mp3","opus","vorbis","flac","ulaw","alaw","pcm","ac-3","ec-3","dts"],yc=(n,e)=>{if(!n)throw new TypeError("Audio chunk metadata must be provided.");if(typeof n!="object")throw new TypeError("Audio chunk metadata must be an object.");if(!n.decoderConfig)throw new TypeError("Audio chunk metadata must include a decoder configuration.");if(typeof n.decoderConfig!="object")throw new TypeError("Audio chunk metadata decoder configuration must be an object.");if(typeof n.decoderConfig.codec!="string")throw new TypeError("Audio chunk metadata decoder configuration must specify a codec string.");if(!gw.some(t=>n.decoderConfig.codec.startsWith(t)))throw new TypeError("Audio chunk metadata decoder configuration codec string must be a valid audio codec string as specified in the Mediabunny Codec Registry.");if(!Number.isInteger(n.decoderConfig.sampleRate)||n.decoderConfig.sampleRate<=0)throw new TypeError("Audio chunk metadata decoder configuration must specify a valid sampleRate (positive integer).");if(!Number.isInteger(n.decoderConfig.numberOfChannels)||n.decoderConfig.numberOfChannels<=0)throw new TypeError("Audio chunk metadata decoder configuration must specify a valid numberOfChannels (positive integer).");if(n.decoderConfig.description!==void 0&&!md(n.decoderConfig.description))throw new TypeError("Audio chunk metadata decoder configuration description, when defined, must be an ArrayBuffer or an ArrayBuffer view.");if(n.decoderConfig.codec.startsWith("mp4a")&&n.decoderConfig.codec!=="mp4a.69"&&n.decoderConfig.codec!=="mp4a.6B"&&n.decoderConfig.codec!=="mp4a.6b"){if(!["mp4a.40.2","mp4a.40.02","mp4a.40.5","mp4a.40.05","mp4a.40.29","mp4a.67"].includes(n.decoderConfig.codec))throw new TypeError("Audio chunk metadata decoder configuration codec string for AAC must be a valid AAC codec string as specified in https://www.w3.org/TR/webcodecs-aac-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("mp3")||n.decoderConfig.codec.startsWith("mp4a")){if(n.decoderConfig.codec!=="mp3"&&n.decoderConfig.codec!=="mp4a.69"&&n.decoderConfig.codec!=="mp4a.6B"&&n.decoderConfig.codec!=="mp4a.6b")throw new TypeError('Audio chunk metadata decoder configuration codec string for MP3 must be "mp3", "mp4a.69" or "mp4a.6B".')}else if(n.decoderConfig.codec.startsWith("opus")){if(n.decoderConfig.codec!=="opus")throw new TypeError('Audio chunk metadata decoder configuration codec string for Opus must be "opus".');if(n.decoderConfig.description&&n.decoderConfig.description.byteLength<18)throw new TypeError("Audio chunk metadata decoder configuration description, when specified, is expected to be an Identification Header as specified in Section 5.1 of RFC 7845.")}else if(n.decoderConfig.codec.startsWith("vorbis")){if(n.decoderConfig.codec!=="vorbis")throw new TypeError('Audio chunk metadata decoder configuration codec string for Vorbis must be "vorbis".');if(!n.decoderConfig.description)throw new TypeError("Audio chunk metadata decoder configuration for Vorbis must include a description, which is expected to adhere to the format described in https://www.w3.org/TR/webcodecs-vorbis-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("flac")){if(n.decoderConfig.codec!=="flac")throw new TypeError('Audio chunk metadata decoder configuration codec string for FLAC must be "flac".');if(!n.decoderConfig.description||n.decoderConfig.description.byteLength<42)throw new TypeError("Audio chunk metadata decoder configuration for FLAC must include a description, which is expected to adhere to the format described in https://www.w3.org/TR/webcodecs-flac-codec-registration/.")}else if(n.decoderConfig.codec.startsWith("ac-3")||n.decoderConfig.codec.startsWith("ac3")){if(n.decoderConfig.codec!=="ac-3")throw new TypeError('Audio chunk metadata decoder configuration codec string for AC-3 must be "ac-3".')}else if(n.decoderConfig.codec.startsWith("ec-3")||n.decoderConfig.codec.startsWith("eac3")){if(n.decoderConfig.codec!=="ec-3")throw new TypeError('Audio chunk metadata decoder configuration codec string for EC-3 must be "ec-3".')}else if(n.decoderConfig.codec.startsWith("dts")){if(!Sd.includes(n.decoderConfig.codec))throw new TypeError(`Audio chunk metadata decoder configuration codec string for DTS must be one of the following four-character codes: ${Sd.join(", ")}.`)}else if((n.decoderConfig.codec.startsWith("pcm")||n.decoderConfig.codec.startsWith("ulaw")||n.decoderConfig.codec.startsWith("alaw"))&&!fr.includes(n.decoderConfig.codec))throw new TypeError(`Audio chunk metadata decoder configuration codec string for PCM must be one of the supported PCM codecs (${fr.join(", ")}).`);if(e!==null&&Dg(n.decoderConfig.codec)!==e)throw new TypeError(`Audio chunk metadata decoder configuration codec string '${n.decoderConfig.codec}' does not fit to the track codec '${e}'.`)},Ug=n=>{if(!n)throw new TypeError("Subtitle metadata must be provided.");if(typeof n!="object")throw new TypeError("Subtitle metadata must be an object.");if(!n.config)throw new TypeError("Subtitle metadata must include a config object.");if(typeof n.config!="object")throw new TypeError("Subtitle metadata config must be an object.");if(typeof n.config.description!="string")throw new TypeError("Subtitle metadata config description must be a string.")};var Og=new Uint8Array(0),pr=class n{constructor(e,t,i,r,s=-1,o,a){if(this.data=e,this.type=t,this.timestamp=i,this.duration=r,this.sequenceNumber=s,e===Og&&o===void 0)throw new Error("Internal error: byteLength must be explicitly provided when constructing metadata-only packets.");if(o===void 0&&(o=e.byteLength),!(e instanceof Uint8Array))throw new TypeError("data must be a Uint8Array.");if(t!=="key"&&t!=="delta")throw new TypeError('type must be either "key" or "delta".');if(!Number.isFinite(i))throw new TypeError("timestamp must be a number.");if(!Number.isFinite(r)||r<0)throw new TypeError("duration must be a non-negative number.");if(!Number.isFinite(s))throw new TypeError("sequenceNumber must be a number.");if(!Number.isInteger(o)||o<0)throw new TypeError("byteLength must be a non-negative integer.");if(a!==void 0&&(typeof a!="object"||!a))throw new TypeError("sideData, when provided, must be an object.");if(a?.alpha!==void 0&&!(a.alpha instanceof Uint8Array))throw new TypeError("sideData.alpha, when provided, must be a Uint8Array.");if(a?.alphaByteLength!==void 0&&(!Number.isInteger(a.alphaByteLength)||a.alphaByteLength<0))throw new TypeError("sideData.alphaByteLength, when provided, must be a non-negative integer.");this.byteLength=o,this.sideData=a??{},this.sideData.alpha&&this.sideData.alphaByteLength===void 0&&(this.sideData.alphaByteLength=this.sideData.alpha.byteLength)}get isMetadataOnly(){return this.data===Og}get microsecondTimestamp(){return Math.trunc(gd*this.timestamp)}get microsecondDuration(){return Math.trunc(gd*this.duration)}toEncodedVideoChunk(){if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to a video chunk.");if(typeof EncodedVideoChunk>"u")throw new Error("EncodedVideoChunk is not available in this environment.");return new EncodedVideoChunk({data:this.data,type:this.type,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}alphaToEncodedVideoChunk(e=this.type){if(!this.sideData.alpha)throw new TypeError("This packet does not contain alpha side data.");if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to a video chunk.");if(typeof EncodedVideoChunk>"u")throw new Error("EncodedVideoChunk is not available in this environment.");return new EncodedVideoChunk({data:this.sideData.alpha,type:e,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}toEncodedAudioChunk(){if(this.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be converted to an audio chunk.");if(typeof EncodedAudioChunk>"u")throw new Error("EncodedAudioChunk is not available in this environment.");return new EncodedAudioChunk({data:this.data,type:this.type,timestamp:this.microsecondTimestamp,duration:this.microsecondDuration})}static fromEncodedChunk(e,t){if(!(e instanceof EncodedVideoChunk||e instanceof EncodedAudioChunk))throw new TypeError("chunk must be an EncodedVideoChunk or EncodedAudioChunk.");let i=new Uint8Array(e.byteLength);return e.copyTo(i),new n(i,e.type,e.timestamp/1e6,(e.duration??0)/1e6,void 0,void 0,t)}clone(e){if(e!==void 0&&(typeof e!="object"||e===null))throw new TypeError("options, when provided, must be an object.");if(e?.data!==void 0&&!(e.data instanceof Uint8Array))throw new TypeError("options.data, when provided, must be a Uint8Array.");if(e?.type!==void 0&&e.type!=="key"&&e.type!=="delta")throw new TypeError('options.type, when provided, must be either "key" or "delta".');if(e?.timestamp!==void 0&&!Number.isFinite(e.timestamp))throw new TypeError("options.timestamp, when provided, must be a number.");if(e?.duration!==void 0&&!Number.isFinite(e.duration))throw new TypeError("options.duration, when provided, must be a number.");if(e?.sequenceNumber!==void 0&&!Number.isFinite(e.sequenceNumber))throw new TypeError("options.sequenceNumber, when provided, must be a number.");if(e?.sideData!==void 0&&(typeof e.sideData!="object"||e.sideData===null))throw new TypeError("options.sideData, when provided, must be an object.");return new n(e?.data??this.data,e?.type??this.type,e?.timestamp??this.timestamp,e?.duration??this.duration,e?.sequenceNumber??this.sequenceNumber,this.byteLength,e?.sideData??this.sideData)}};var kg=n=>{let t=(n.hasVideo?"video/":n.hasAudio?"audio/":"application/")+(n.isQuickTime?"quicktime":"mp4");if(n.codecStrings.length>0){let i=[...new Set(n.codecStrings)];t+=`; codecs="${i.join(", ")}"`}return t};var _c=8,Ad=16;var zg=7,Vg=9,Md=n=>{let e=n.filePos,t=Hg(n,9),i=new Bn(t);if(i.readBits(12)!==4095||(i.skipBits(1),i.readBits(2)!==0))return null;let o=i.readBits(1),a=i.readBits(2)+1,l=i.readBits(4);if(l===15)return null;i.skipBits(1);let c=i.readBits(3);if(c===0)throw new Error("ADTS frames with channel configuration 0 are not supported.");i.skipBits(1),i.skipBits(1),i.skipBits(1),i.skipBits(1);let u=i.readBits(13);i.skipBits(11);let h=i.readBits(2)+1;if(h!==1)throw new Error("ADTS frames with more than one AAC frame are not supported.");let d=null;return o===1?n.filePos-=2:d=i.readBits(16),{objectType:a,samplingFrequencyIndex:l,channelConfiguration:c,frameLength:u,numberOfAacFrames:h,crcCheck:d,startPos:e}};var Ha=class n{constructor(e,t,i,r,s){this.bytes=e,this.view=t,this.offset=i,this.start=r,this.end=s,this.bufferPos=r-i}static tempFromBytes(e){return new n(e,Bs(e),0,0,e.length)}get length(){return this.end-this.start}get filePos(){return this.offset+this.bufferPos}set filePos(e){this.bufferPos=e-this.offset}get remainingLength(){return Math.max(this.end-this.filePos,0)}skip(e){this.bufferPos+=e}slice(e,t=this.end-e){if(e<this.start||e+t>this.end)throw new RangeError("Slicing outside of original slice.");return new n(this.bytes,this.view,this.offset,e,e+t)}},xw=(n,e)=>{if(n.filePos<n.start||n.filePos+e>n.end)throw new RangeError(`Tried reading [${n.filePos}, ${n.filePos+e}), but slice is [${n.start}, ${n.end}). This is likely an internal error, please report it alongside the file that caused it.`)},Hg=(n,e)=>{xw(n,e);let t=n.bytes.subarray(n.bufferPos,n.bufferPos+e);return n.bufferPos+=e,t};var bc=class{constructor(e){this.mutex=new vo,this.trackTimestampInfo=new WeakMap,this.output=e}onTrackClose(e){}validateTimestamp(e,t,i){let r=this.trackTimestampInfo.get(e);if(r){if(i&&(r.maxTimestampBeforeLastKeyPacket=r.maxTimestamp),r.maxTimestampBeforeLastKeyPacket!==null&&t<r.maxTimestampBeforeLastKeyPacket)throw new Error(`Timestamps cannot be smaller than the largest timestamp of the previous GOP (a GOP begins with a key packet and ends right before the next key packet). Got ${t}s, but largest timestamp is ${r.maxTimestampBeforeLastKeyPacket}s.`);r.maxTimestamp=Math.max(r.maxTimestamp,t)}else{if(!i)throw new Error("First packet must be a key packet.");r={maxTimestamp:t,maxTimestampBeforeLastKeyPacket:null},this.trackTimestampInfo.set(e,r)}}};var Td=/<(?:(\d{2}):)?(\d{2}):(\d{2}).(\d{3})>/g;var Gg=n=>{let e=Math.floor(n/36e5),t=Math.floor(n%(3600*1e3)/(60*1e3)),i=Math.floor(n%(60*1e3)/1e3),r=n%1e3;return e.toString().padStart(2,"0")+":"+t.toString().padStart(2,"0")+":"+i.toString().padStart(2,"0")+"."+r.toString().padStart(3,"0")};var Us=class{constructor(e){this.writer=e,this.helper=new Uint8Array(8),this.helperView=new DataView(this.helper.buffer),this.offsets=new WeakMap}writeU32(e){this.helperView.setUint32(0,e,!1),this.writer.write(this.helper.subarray(0,4))}writeU64(e){this.helperView.setUint32(0,Math.floor(e/2**32),!1),this.helperView.setUint32(4,e,!1),this.writer.write(this.helper.subarray(0,8))}writeAscii(e){for(let t=0;t<e.length;t++)this.helperView.setUint8(t%8,e.charCodeAt(t)),t%8===7&&this.writer.write(this.helper);e.length%8!==0&&this.writer.write(this.helper.subarray(0,e.length%8))}writeBox(e){if(this.offsets.set(e,this.writer.getPos()),e.contents&&!e.children)this.writeBoxHeader(e,e.size??e.contents.byteLength+8),this.writer.write(e.contents);else{let t=this.writer.getPos();if(this.writeBoxHeader(e,0),e.contents&&this.writer.write(e.contents),e.children)for(let s of e.children)s&&this.writeBox(s);let i=this.writer.getPos(),r=e.size??i-t;this.writer.seek(t),this.writeBoxHeader(e,r),this.writer.seek(i)}}writeBoxHeader(e,t){this.writeU32(e.largeSize?1:t),this.writeAscii(e.type),e.largeSize&&this.writeU64(t)}measureBoxHeader(e){return 8+(e.largeSize?8:0)}patchBox(e){let t=this.offsets.get(e);_e(t!==void 0);let i=this.writer.getPos();this.writer.seek(t),this.writeBox(e),this.writer.seek(i)}measureBox(e){if(e.contents&&!e.children)return this.measureBoxHeader(e)+e.contents.byteLength;{let t=this.measureBoxHeader(e);if(e.contents&&(t+=e.contents.byteLength),e.children)for(let i of e.children)i&&(t+=this.measureBox(i));return t}}},ht=new Uint8Array(8),Ri=new DataView(ht.buffer),rn=n=>[(n%256+256)%256],Ze=n=>(Ri.setUint16(0,n,!1),[ht[0],ht[1]]),Pd=n=>(Ri.setInt16(0,n,!1),[ht[0],ht[1]]),$g=n=>(Ri.setUint32(0,n,!1),[ht[1],ht[2],ht[3]]),fe=n=>(Ri.setUint32(0,n,!1),[ht[0],ht[1],ht[2],ht[3]]),xr=n=>(Ri.setInt32(0,n,!1),[ht[0],ht[1],ht[2],ht[3]]),zi=n=>(Ri.setUint32(0,Math.floor(n/2**32),!1),Ri.setUint32(4,n,!1),[ht[0],ht[1],ht[2],ht[3],ht[4],ht[5],ht[6],ht[7]]),Wg=n=>(Ri.setInt32(0,Math.floor(n/2**32),!1),Ri.setUint32(4,n,!1),[ht[0],ht[1],ht[2],ht[3],ht[4],ht[5],ht[6],ht[7]]),Yg=n=>(Ri.setInt16(0,2**8*n,!1),[ht[0],ht[1]]),Ci=n=>(Ri.setInt32(0,2**16*n,!1),[ht[0],ht[1],ht[2],ht[3]]),Ed=n=>(Ri.setInt32(0,2**30*n,!1),[ht[0],ht[1],ht[2],ht[3]]),Cd=(n,e)=>{let t=[],i=n;do{let r=i&127;i>>=7,t.length>0&&(r|=128),t.push(r),e!==void 0&&e--}while(i>0||e);return t.reverse()},Ut=(n,e=!1)=>{let t=Array(n.length).fill(null).map((i,r)=>n.charCodeAt(r));return e&&t.push(0),t},Zg=n=>[Ci(n[0]),Ci(n[1]),Ed(n[2]),Ci(n[3]),Ci(n[4]),Ed(n[5]),Ci(n[6]),Ci(n[7]),Ed(n[8])],We=(n,e,t)=>({type:n,contents:e&&new Uint8Array(e.flat(10)),children:t}),At=(n,e,t,i,r)=>We(n,[rn(e),$g(t),i??[]],r),Kg=n=>n.isQuickTime?We("ftyp",[Ut("qt  "),fe(512),Ut("qt  ")]):n.fragmented?n.cmaf?We("ftyp",[Ut("iso5"),fe(512),Ut("iso5"),Ut("iso6"),Ut("mp41"),Ut("cmfc"),Ut("dash")]):We("ftyp",[Ut("iso5"),fe(512),Ut("iso5"),Ut("iso6"),Ut("mp41")]):We("ftyp",[Ut("isom"),fe(512),Ut("isom"),n.holdsAvc?Ut("avc1"):[],Ut("mp41")]),Id=()=>We("styp",[Ut("iso5"),fe(0),Ut("iso5"),Ut("iso6"),Ut("mp41"),Ut("cmfc"),Ut("dash")]),Ld=(n,e)=>{let t=Math.max(0,n.minWrittenTimestamp),i=Math.max(0,n.maxWrittenEndTimestamp-t);return Number.isFinite(i)||(i=0),At("sidx",1,0,[fe(1),fe(oi),zi(zt(t,oi)),zi(0),Ze(0),Ze(1),fe(e&2147483647),fe(zt(i,oi)),fe(0)])},Ga=n=>({type:"mdat",largeSize:n}),Jg=n=>({type:"free",size:n}),Ao=n=>We("moov",void 0,[yw(n.creationTime,n.trackDatas),...n.trackDatas.map(e=>_w(e,n.creationTime)),n.isFragmented?sS(n.trackDatas):null,pS(n)]),yw=(n,e)=>{let t=Math.max(0,...e.map(o=>Math.max(0,zt(Os(o),oi)+zt(o.startTimestampOffset??0,oi)))),i=Math.max(0,...e.map(o=>o.track.id))+1,r=!cr(n)||!cr(t),s=r?zi:fe;return At("mvhd",+r,0,[s(n),s(n),fe(oi),s(t),Ci(1),Yg(1),Array(10).fill(0),Zg(pd),Array(24).fill(0),fe(i)])},_w=(n,e)=>{let t=o0(n),i=n.startTimestampOffset!==null&&n.startTimestampOffset!==0;return We("trak",void 0,[bw(n,e),i?vw(n):null,ww(n,e),t.name!==void 0?We("udta",void 0,[We("name",[...Ei.encode(t.name)])]):null])},bw=(n,e)=>{let t=Math.max(0,zt(Os(n),oi)+zt(n.startTimestampOffset??0,oi)),i=!cr(e)||!cr(t),r=i?zi:fe,s;if(n.type==="video"&&n.track.metadata.transformationMatrix)s=n.track.metadata.transformationMatrix;else if(n.type==="video"){let{rotation:l,flip:c}=n.track.metadata,u=hc(Km(l??0),Jm(c?-1:1,1));s=Zm(u,n.info.width,n.info.height)}else s=pd;let o=2;n.track.metadata.disposition?.default!==!1&&(o|=1);let a=n.type==="video"?0:n.type==="audio"?1:n.type==="subtitle"?2:wo(n);return At("tkhd",+i,o,[r(e),r(e),fe(n.track.id),fe(0),r(t),Array(8).fill(0),Ze(0),Ze(a),Yg(n.type==="audio"?1:0),Ze(0),Zg(s),Ci(n.type==="video"?n.info.width:0),Ci(n.type==="video"?n.info.height:0)])},vw=n=>{let e=n.startTimestampOffset;if(_e(e!==null),e>0){let t=zt(e,oi),i=zt(Os(n),oi),r=!cr(t)||!cr(i),s=r?zi:fe,o=r?Wg:xr;return We("edts",void 0,[At("elst",r?1:0,0,[fe(2),s(t),o(-1),Ci(1),s(i),o(0),Ci(1)])])}else{let t=zt(-e,n.timescale),i=Math.max(0,zt(Os(n),oi)+zt(e,oi)),r=!jm(t)||!cr(i),s=r?zi:fe,o=r?Wg:xr;return We("edts",void 0,[At("elst",r?1:0,0,[fe(1),s(i),o(t),Ci(1)])])}},ww=(n,e)=>We("mdia",void 0,[Sw(n,e),Fd(!0,Aw[n.type],Mw[n.type]),Tw(n)]),Sw=(n,e)=>{let t=zt(Os(n),n.timescale),i=!cr(e)||!cr(t),r=i?zi:fe;return At("mdhd",+i,0,[r(e),r(e),fe(n.timescale),r(t),Ze(s0(n.track.metadata.languageCode??ng)),Ze(0)])},Aw={video:"vide",audio:"soun",subtitle:"text"},Mw={video:"MediabunnyVideoHandler",audio:"MediabunnySoundHandler",subtitle:"MediabunnyTextHandler"},Fd=(n,e,t,i="\0\0\0\0")=>At("hdlr",0,0,[n?Ut("mhlr"):fe(0),Ut(e),Ut(i),fe(0),fe(0),Ut(t,!0)]),Tw=n=>We("minf",void 0,[Pw[n.type](),Iw(),Nw(n)]),Ew=()=>At("vmhd",0,1,[Ze(0),Ze(0),Ze(0),Ze(0)]),Cw=()=>At("smhd",0,0,[Ze(0),Ze(0)]),Rw=()=>At("nmhd",0,0),Pw={video:Ew,audio:Cw,subtitle:Rw},Iw=()=>We("dinf",void 0,[Lw()]),Lw=()=>At("dref",0,0,[fe(1)],[Fw()]),Fw=()=>At("url ",0,1),Nw=n=>{let e=n.compositionTimeOffsetTable.length>1||n.compositionTimeOffsetTable.some(t=>t.sampleCompositionTimeOffset!==0);return We("stbl",void 0,[Bw(n),jw(n),e?iS(n):null,e?rS(n):null,eS(n),tS(n),nS(n),Qw(n)])},Bw=n=>{let e;if(n.type==="video")e=Dw(yS(n.track.source._codec,n.info.decoderConfig.codec),n);else if(n.type==="audio"){let t=r0(n.track.source._codec,n.info.decoderConfig.codec,n.muxer.isQuickTime);_e(t),e=Hw(t,n)}else n.type==="subtitle"&&(e=Kw(vS[n.track.source._codec],n));return _e(e),At("stsd",0,0,[fe(1)],[e])},Dw=(n,e)=>We(n,[Array(6).fill(0),Ze(1),Ze(0),Ze(0),Array(12).fill(0),Ze(e.info.width),Ze(e.info.height),fe(4718592),fe(4718592),fe(0),Ze(1),rn(pc.length),Ut(pc),Array(31-pc.length).fill(0),Ze(e.info.hasAlphaChannel?32:24),Pd(65535)],[_S[e.track.source._codec]?.(e)??null,Uw(e),Qm(e.info.decoderConfig.colorSpace)?null:Ow(e),Nd(e)]),Nd=n=>n.avgBitrate===0&&n.maxBitrate===0?null:We("btrt",[fe(0),fe(n.maxBitrate),fe(n.avgBitrate)]),Uw=n=>n.info.pixelAspectRatio.num===n.info.pixelAspectRatio.den?null:We("pasp",[fe(n.info.pixelAspectRatio.num),fe(n.info.pixelAspectRatio.den)]),Ow=n=>{let e=n.info.decoderConfig.colorSpace;return We("colr",[Ut(n.muxer.isQuickTime?"nclc":"nclx"),Ze(e?.primaries!=null?Ba[e.primaries]:2),Ze(e?.transfer!=null?Da[e.transfer]:2),Ze(e?.matrix!=null?Ua[e.matrix]:2),n.muxer.isQuickTime?[]:rn((e?.fullRange?1:0)<<7)])},kw=n=>n.info.decoderConfig&&We("avcC",[...cs(n.info.decoderConfig.description)]),zw=n=>n.info.decoderConfig&&We("hvcC",[...cs(n.info.decoderConfig.description)]),qg=n=>{if(!n.info.decoderConfig)return null;let e=n.info.decoderConfig,t=e.codec.split("."),i=Number(t[1]),r=Number(t[2]),s=Number(t[3]),o=t[4]?Number(t[4]):1,a=t[8]?Number(t[8]):Number(e.colorSpace?.fullRange??0),l=(s<<4)+(o<<1)+a,c=t[5]?Number(t[5]):e.colorSpace?.primaries?Ba[e.colorSpace.primaries]:1,u=t[6]?Number(t[6]):e.colorSpace?.transfer?Da[e.colorSpace.transfer]:1,h=t[7]?Number(t[7]):e.colorSpace?.matrix?Ua[e.colorSpace.matrix]:1;return At("vpcC",1,0,[rn(i),rn(r),rn(l),rn(c),rn(u),rn(h),Ze(0)])},Vw=n=>We("av1C",Ng(n.info.decoderConfig.codec)),Hw=(n,e)=>{let t=0,i,r=16,s=fr.includes(e.track.source._codec);if(s){let o=e.track.source._codec,{sampleSize:a}=Fr(o);r=8*a,r>16&&(t=1)}if(e.muxer.isQuickTime&&(t=1),t===0)i=[Array(6).fill(0),Ze(1),Ze(t),Ze(0),fe(0),Ze(e.info.numberOfChannels),Ze(r),Ze(0),Ze(0),Ze(e.info.sampleRate<2**16?e.info.sampleRate:0),Ze(0)];else{let o=s?0:-2;i=[Array(6).fill(0),Ze(1),Ze(t),Ze(0),fe(0),Ze(e.info.numberOfChannels),Ze(Math.min(r,16)),Pd(o),Ze(0),Ze(e.info.sampleRate<2**16?e.info.sampleRate:0),Ze(0),s?[fe(1),fe(r/8),fe(e.info.numberOfChannels*r/8)]:[fe(0),fe(0),fe(0)],fe(2)]}return We(n,i,[bS(e.track.source._codec,e.muxer.isQuickTime)?.(e)??null,Nd(e)])},Rd=n=>{let e;switch(n.track.source._codec){case"aac":e=64;break;case"mp3":e=107;break;case"vorbis":e=221;break;default:throw new Error(`Unhandled audio codec: ${n.track.source._codec}`)}let t=[...rn(e),...rn(21),...$g(0),...fe(n.maxBitrate),...fe(n.avgBitrate)];if(n.info.decoderConfig.description){let i=cs(n.info.decoderConfig.description);t=[...t,...rn(5),...Cd(i.byteLength),...i]}return t=[...Ze(1),...rn(0),...rn(4),...Cd(t.length),...t,...rn(6),...rn(1),...rn(2)],t=[...rn(3),...Cd(t.length),...t],At("esds",0,0,t)},hs=n=>We("wave",void 0,[Gw(n),Ww(n),We("\0\0\0\0")]),Gw=n=>We("frma",[Ut(r0(n.track.source._codec,n.info.decoderConfig.codec,n.muxer.isQuickTime))]),Ww=n=>{let{littleEndian:e}=Fr(n.track.source._codec);return We("enda",[Ze(+e)])},qw=n=>{let e=n.info.numberOfChannels,t=3840,i=n.info.sampleRate,r=0,s=0,o=new Uint8Array(0),a=n.info.decoderConfig?.description;if(a){_e(a.byteLength>=18);let l=cs(a),c=Rg(l);e=c.outputChannelCount,t=c.preSkip,i=c.inputSampleRate,r=c.outputGain,s=c.channelMappingFamily,c.channelMappingTable&&(o=c.channelMappingTable)}return We("dOps",[rn(0),rn(e),Ze(t),fe(i),Pd(r),rn(s),...o])},Xw=n=>{let e=n.info.decoderConfig?.description;_e(e);let t=cs(e);return At("dfLa",0,0,[...t.subarray(4)])},mr=n=>{let{littleEndian:e,sampleSize:t}=Fr(n.track.source._codec),i=+e;return At("pcmC",0,0,[rn(i),rn(8*t)])},$w=n=>{_e(n.info.primingPacket);let e=Pg(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract AC-3 frame info from the audio packet. Ensure the packets contain valid AC-3 sync frames (as specified in ETSI TS 102 366).");let t=new Uint8Array(3),i=new Bn(t);return i.writeBits(2,e.fscod),i.writeBits(5,e.bsid),i.writeBits(3,e.bsmod),i.writeBits(3,e.acmod),i.writeBits(1,e.lfeon),i.writeBits(5,e.bitRateCode),i.writeBits(5,0),We("dac3",[...t])},Yw=n=>{_e(n.info.primingPacket);let e=Ig(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract E-AC-3 frame info from the audio packet. Ensure the packets contain valid E-AC-3 sync frames (as specified in ETSI TS 102 366).");let t=16;for(let o of e.substreams)t+=23,o.numDepSub>0?t+=9:t+=1;let i=Math.ceil(t/8),r=new Uint8Array(i),s=new Bn(r);s.writeBits(13,e.dataRate),s.writeBits(3,e.substreams.length-1);for(let o of e.substreams)s.writeBits(2,o.fscod),s.writeBits(5,o.bsid),s.writeBits(1,0),s.writeBits(1,0),s.writeBits(3,o.bsmod),s.writeBits(3,o.acmod),s.writeBits(1,o.lfeon),s.writeBits(3,0),s.writeBits(4,o.numDepSub),o.numDepSub>0?s.writeBits(9,o.chanLoc):s.writeBits(1,0);return We("dec3",[...r])},Zw=n=>{_e(n.info.primingPacket);let e=Lg(n.info.primingPacket.data);if(!e)throw new Error("Couldn't extract DTS frame info from the audio packet. Ensure the packets contain valid DTS frames as specified in ETSI TS 102 114.");return We("ddts",[...Fg(e)])},Kw=(n,e)=>We(n,[Array(6).fill(0),Ze(1)],[wS[e.track.source._codec](e),Nd(e)]),Jw=n=>We("vttC",[...Ei.encode(n.info.config.description)]);var jw=n=>At("stts",0,0,[fe(n.timeToSampleTable.length),n.timeToSampleTable.map(e=>[fe(e.sampleCount),fe(e.sampleDelta)])]),Qw=n=>{if(n.samples.every(t=>t.type==="key"))return null;let e=[...n.samples.entries()].filter(([,t])=>t.type==="key");return At("stss",0,0,[fe(e.length),e.map(([t])=>fe(t+1))])},eS=n=>At("stsc",0,0,[fe(n.compactlyCodedChunkTable.length),n.compactlyCodedChunkTable.map(e=>[fe(e.firstChunk),fe(e.samplesPerChunk),fe(1)])]),tS=n=>{if(n.type==="audio"&&n.info.requiresPcmTransformation){let{sampleSize:e}=Fr(n.track.source._codec);return At("stsz",0,0,[fe(e*n.info.numberOfChannels),fe(n.samples.reduce((t,i)=>t+zt(i.duration,n.timescale),0))])}return At("stsz",0,0,[fe(0),fe(n.samples.length),n.samples.map(e=>fe(e.size))])},nS=n=>n.finalizedChunks.length>0&&lr(n.finalizedChunks).offset>=2**32?At("co64",0,0,[fe(n.finalizedChunks.length),n.finalizedChunks.map(e=>zi(e.offset))]):At("stco",0,0,[fe(n.finalizedChunks.length),n.finalizedChunks.map(e=>fe(e.offset))]),iS=n=>At("ctts",1,0,[fe(n.compositionTimeOffsetTable.length),n.compositionTimeOffsetTable.map(e=>[fe(e.sampleCount),xr(e.sampleCompositionTimeOffset)])]),rS=n=>{let e=1/0,t=-1/0,i=1/0,r=-1/0;_e(n.compositionTimeOffsetTable.length>0),_e(n.samples.length>0);for(let o=0;o<n.compositionTimeOffsetTable.length;o++){let a=n.compositionTimeOffsetTable[o];e=Math.min(e,a.sampleCompositionTimeOffset),t=Math.max(t,a.sampleCompositionTimeOffset)}for(let o=0;o<n.samples.length;o++){let a=n.samples[o];i=Math.min(i,zt(a.timestamp,n.timescale)),r=Math.max(r,zt(a.timestamp+a.duration,n.timescale))}let s=Math.max(-e,0);return r>=2**31?null:At("cslg",0,0,[xr(s),xr(e),xr(t),xr(i),xr(r)])},sS=n=>We("mvex",void 0,n.map(oS)),oS=n=>At("trex",0,0,[fe(n.track.id),fe(1),fe(0),fe(0),fe(0)]),Bd=(n,e)=>We("moof",void 0,[aS(n),...e.map(lS)]),aS=n=>At("mfhd",0,0,[fe(n)]),jg=n=>{let e=0,t=0,i=0,r=0,s=n.type==="delta";return t|=+s,s?e|=1:e|=2,e<<24|t<<16|i<<8|r},lS=n=>We("traf",void 0,[cS(n),uS(n),hS(n)]),cS=n=>{_e(n.currentChunk);let e=0;e|=8,e|=16,e|=32,e|=131072;let t=n.currentChunk.samples[1]??n.currentChunk.samples[0],i={duration:t.timescaleUnitsToNextSample,size:t.size,flags:jg(t)};return At("tfhd",0,e,[fe(n.track.id),fe(i.duration),fe(i.size),fe(i.flags)])},uS=n=>(_e(n.currentChunk),At("tfdt",1,0,[zi(zt(n.currentChunk.startTimestamp,n.timescale))])),hS=n=>{_e(n.currentChunk);let e=n.currentChunk.samples.map(b=>b.timescaleUnitsToNextSample),t=n.currentChunk.samples.map(b=>b.size),i=n.currentChunk.samples.map(jg),r=n.currentChunk.samples.map(b=>zt(b.timestamp-b.decodeTimestamp,n.timescale)),s=new Set(e),o=new Set(t),a=new Set(i),l=new Set(r),c=a.size===2&&i[0]!==i[1],u=s.size>1,h=o.size>1,d=!c&&a.size>1,f=l.size>1||[...l].some(b=>b!==0),m=0;return m|=1,m|=4*+c,m|=256*+u,m|=512*+h,m|=1024*+d,m|=2048*+f,At("trun",1,m,[fe(n.currentChunk.samples.length),fe(n.currentChunk.offset-n.currentChunk.moofOffset||0),c?fe(i[0]):[],n.currentChunk.samples.map((b,g)=>[u?fe(e[g]):[],h?fe(t[g]):[],d?fe(i[g]):[],f?xr(r[g]):[]])])},Qg=n=>We("mfra",void 0,[...n.map(dS),fS()]),dS=n=>At("tfra",1,0,[fe(n.track.id),fe(63),fe(n.finalizedChunks.length),n.finalizedChunks.map(t=>[zi(zt(t.samples[0].timestamp,n.timescale)),zi(t.moofOffset),fe(t.trafIndex+1),fe(1),fe(1)])]),fS=()=>At("mfro",0,0,[fe(0)]),e0=()=>We("vtte"),t0=(n,e,t,i,r)=>We("vttc",void 0,[r!==null?We("vsid",[xr(r)]):null,t!==null?We("iden",[...Ei.encode(t)]):null,e!==null?We("ctim",[...Ei.encode(Gg(e))]):null,i!==null?We("sttg",[...Ei.encode(i)]):null,We("payl",[...Ei.encode(n)])]),n0=n=>We("vtta",[...Ei.encode(n)]),pS=n=>{let e=[],t=n.format._options.metadataFormat??"auto",i=n.output._metadataTags;if(t==="mdir"||t==="auto"&&!n.isQuickTime){let r=gS(i);r&&e.push(r)}else if(t==="mdta"){let r=xS(i);r&&e.push(r)}else(t==="udta"||t==="auto"&&n.isQuickTime)&&mS(e,n.output._metadataTags);return e.length===0?null:We("udta",void 0,e)},mS=(n,e)=>{for(let{key:t,value:i}of dc(e))switch(t){case"title":n.push(gr("©nam",i));break;case"description":n.push(gr("©des",i));break;case"artist":n.push(gr("©ART",i));break;case"album":n.push(gr("©alb",i));break;case"albumArtist":n.push(gr("albr",i));break;case"genre":n.push(gr("©gen",i));break;case"date":n.push(gr("©day",i.toISOString().slice(0,10)));break;case"comment":n.push(gr("©cmt",i));break;case"lyrics":n.push(gr("©lyr",i));break;case"raw":break;case"discNumber":case"discsTotal":case"trackNumber":case"tracksTotal":case"beatsPerMinute":case"images":break;default:wo(t)}if(e.raw)for(let t in e.raw){let i=e.raw[t];i==null||t.length!==4||n.some(r=>r.type===t)||(typeof i=="string"?n.push(gr(t,i)):i instanceof Uint8Array&&n.push(We(t,Array.from(i))))}},gr=(n,e)=>{let t=Ei.encode(e);return We(n,[Ze(t.length),Ze(s0("und")),Array.from(t)])},Xg={"image/jpeg":13,"image/png":14,"image/bmp":27},i0=(n,e)=>{let t=[];for(let{key:i,value:r}of dc(n))switch(i){case"title":t.push({key:e?"title":"©nam",value:ki(r)});break;case"description":t.push({key:e?"description":"©des",value:ki(r)});break;case"artist":t.push({key:e?"artist":"©ART",value:ki(r)});break;case"album":t.push({key:e?"album":"©alb",value:ki(r)});break;case"albumArtist":t.push({key:e?"album_artist":"aART",value:ki(r)});break;case"comment":t.push({key:e?"comment":"©cmt",value:ki(r)});break;case"genre":t.push({key:e?"genre":"©gen",value:ki(r)});break;case"beatsPerMinute":e||t.push({key:"tmpo",value:We("data",[fe(21),fe(0),Ze(r)])});break;case"lyrics":t.push({key:e?"lyrics":"©lyr",value:ki(r)});break;case"date":t.push({key:e?"date":"©day",value:ki(r.toISOString().slice(0,10))});break;case"images":for(let s of r)s.kind==="coverFront"&&t.push({key:"covr",value:We("data",[fe(Xg[s.mimeType]??0),fe(0),Array.from(s.data)])});break;case"trackNumber":if(e){let s=n.tracksTotal!==void 0?`${r}/${n.tracksTotal}`:r.toString();t.push({key:"track",value:ki(s)})}else t.push({key:"trkn",value:We("data",[fe(0),fe(0),Ze(0),Ze(r),Ze(n.tracksTotal??0),Ze(0)])});break;case"discNumber":e||t.push({key:"disc",value:We("data",[fe(0),fe(0),Ze(0),Ze(r),Ze(n.discsTotal??0),Ze(0)])});break;case"tracksTotal":case"discsTotal":break;case"raw":break;default:wo(i)}if(n.raw)for(let i in n.raw){let r=n.raw[i];r==null||!e&&i.length!==4||t.some(s=>s.key===i)||(typeof r=="string"?t.push({key:i,value:ki(r)}):r instanceof Uint8Array?t.push({key:i,value:We("data",[fe(0),fe(0),Array.from(r)])}):r instanceof ka&&t.push({key:i,value:We("data",[fe(Xg[r.mimeType]??0),fe(0),Array.from(r.data)])}))}return t},gS=n=>{let e=i0(n,!1);return e.length===0?null:At("meta",0,0,void 0,[Fd(!1,"mdir","","appl"),We("ilst",void 0,e.map(t=>We(t.key,void 0,[t.value])))])},xS=n=>{let e=i0(n,!0);return e.length===0?null:We("meta",void 0,[Fd(!1,"mdta",""),At("keys",0,0,[fe(e.length)],e.map(t=>We("mdta",[...Ei.encode(t.key)]))),We("ilst",void 0,e.map((t,i)=>{let r=String.fromCharCode(...fe(i+1));return We(r,void 0,[t.value])}))])},ki=n=>We("data",[fe(1),fe(0),...Ei.encode(n)]),yS=(n,e)=>{switch(n){case"avc":return e.startsWith("avc3")?"avc3":"avc1";case"hevc":return"hvc1";case"vp8":return"vp08";case"vp9":return"vp09";case"av1":return"av01";case"prores":return e}},_S={avc:kw,hevc:zw,vp8:qg,vp9:qg,av1:Vw,prores:null},r0=(n,e,t)=>{switch(n){case"aac":return"mp4a";case"mp3":return"mp4a";case"opus":return"Opus";case"vorbis":return"mp4a";case"flac":return"fLaC";case"ulaw":return"ulaw";case"alaw":return"alaw";case"pcm-u8":return"raw ";case"pcm-s8":return"sowt";case"ac3":return"ac-3";case"eac3":return"ec-3";case"dts":return e}if(t)switch(n){case"pcm-s16":return"sowt";case"pcm-s16be":return"twos";case"pcm-s24":return"in24";case"pcm-s24be":return"in24";case"pcm-s32":return"in32";case"pcm-s32be":return"in32";case"pcm-f32":return"fl32";case"pcm-f32be":return"fl32";case"pcm-f64":return"fl64";case"pcm-f64be":return"fl64"}else switch(n){case"pcm-s16":return"ipcm";case"pcm-s16be":return"ipcm";case"pcm-s24":return"ipcm";case"pcm-s24be":return"ipcm";case"pcm-s32":return"ipcm";case"pcm-s32be":return"ipcm";case"pcm-f32":return"fpcm";case"pcm-f32be":return"fpcm";case"pcm-f64":return"fpcm";case"pcm-f64be":return"fpcm"}},bS=(n,e)=>{switch(n){case"aac":return Rd;case"mp3":return Rd;case"opus":return qw;case"vorbis":return Rd;case"flac":return Xw;case"ac3":return $w;case"eac3":return Yw;case"dts":return Zw}if(e)switch(n){case"pcm-s24":return hs;case"pcm-s24be":return hs;case"pcm-s32":return hs;case"pcm-s32be":return hs;case"pcm-f32":return hs;case"pcm-f32be":return hs;case"pcm-f64":return hs;case"pcm-f64be":return hs}else switch(n){case"pcm-s16":return mr;case"pcm-s16be":return mr;case"pcm-s24":return mr;case"pcm-s24be":return mr;case"pcm-s32":return mr;case"pcm-s32be":return mr;case"pcm-f32":return mr;case"pcm-f32be":return mr;case"pcm-f64":return mr;case"pcm-f64be":return mr}return null},vS={webvtt:"wvtt"},wS={webvtt:Jw},s0=n=>{_e(n.length===3);let e=0;for(let t=0;t<3;t++)e<<=5,e+=n.charCodeAt(t)-96;return e};var ks=class{constructor(e,t){if(this.finalized=!1,this.started=!1,this.pos=0,this.trackedWrites=null,this.trackedStart=-1,this.trackedEnd=-1,e._writerAcquired)throw new Error("Can't have multiple Writers for the same Target.");this.target=e,e._setMonotonicity(t),e._writerAcquired=!0}start(){_e(!this.started),this.target._start(),this.started=!0}write(e){_e(this.started&&!this.finalized),this.maybeTrackWrites(e),this.target._write(e,this.pos),this.pos+=e.byteLength}seek(e){this.pos=e}getPos(){return this.pos}async flush(){return _e(this.started&&!this.finalized),this.target._flush()}async finalize(){_e(this.started&&!this.finalized),await this.target._finalize(),this.finalized=!0}maybeTrackWrites(e){if(!this.trackedWrites)return;let t=this.getPos();if(t<this.trackedStart){if(t+e.byteLength<=this.trackedStart)return;e=e.subarray(this.trackedStart-t),t=0}let i=t+e.byteLength-this.trackedStart,r=this.trackedWrites.byteLength;for(;r<i;)r*=2;if(r!==this.trackedWrites.byteLength){let s=new Uint8Array(r);s.set(this.trackedWrites,0),this.trackedWrites=s}this.trackedWrites.set(e,t-this.trackedStart),this.trackedEnd=Math.max(this.trackedEnd,t+e.byteLength)}startTrackingWrites(){this.trackedWrites=new Uint8Array(2**10),this.trackedStart=this.getPos(),this.trackedEnd=this.trackedStart}stopTrackingWrites(){if(!this.trackedWrites)throw new Error("Internal error: Can't get tracked writes since nothing was tracked.");let t={data:this.trackedWrites.subarray(0,this.trackedEnd-this.trackedStart),start:this.trackedStart,end:this.trackedEnd};return this.trackedWrites=null,t}};var gi=class extends ls{constructor(){super(...arguments),this._writerAcquired=!1,this._monotonicity=null,this.onwrite=null}_setMonotonicity(e){this._monotonicity!==!1&&(this._monotonicity=e)}_dispatchWrite(e,t){this.onwrite?.(e,t),this._emit("write",{start:e,end:t})}slice(e){if(!Number.isInteger(e)||e<0)throw new TypeError("offset must be a non-negative integer.");return new vc(this,e)}},Dd=2**16,Ud=2**32,Nr=class extends gi{constructor(e={}){if(super(),this.buffer=null,this._maxPos=0,!e||typeof e!="object")throw new TypeError("BufferTarget options, when provided, must be an object.");if(e.onFinalize!==void 0&&typeof e.onFinalize!="function")throw new TypeError("options.onFinalize, when provided, must be a function.");if(this._options=e,this._supportsResize="resize"in new ArrayBuffer(0),this._supportsResize)try{this._buffer=new ArrayBuffer(Dd,{maxByteLength:Ud})}catch{this._buffer=new ArrayBuffer(Dd),this._supportsResize=!1}else this._buffer=new ArrayBuffer(Dd);this._bytes=new Uint8Array(this._buffer)}_ensureSize(e){let t=this._buffer.byteLength;for(;t<e;)t*=2;if(t!==this._buffer.byteLength){if(t>Ud)throw new Error(`ArrayBuffer exceeded maximum size of ${Ud} bytes. Please consider using another target.`);if(this._supportsResize)this._buffer.resize(t);else{let i=new ArrayBuffer(t),r=new Uint8Array(i);r.set(this._bytes,0),this._buffer=i,this._bytes=r}}}_start(){}_write(e,t){this._ensureSize(t+e.byteLength),this._bytes.set(e,t),this._maxPos=Math.max(this._maxPos,t+e.byteLength),this._dispatchWrite(t,t+e.byteLength)}async _flush(){}async _finalize(){this.buffer=this._buffer.slice(0,this._maxPos),this._options.onFinalize&&await this._options.onFinalize(this.buffer),this._emit("finalized")}async _close(){}_getSlice(e,t){return this._bytes.slice(e,t)}},t3=2**24;var vc=class extends gi{constructor(e,t){super(),this._baseTarget=e,this._offset=t}_start(){}_write(e,t){this._baseTarget._write(e,this._offset+t),this._dispatchWrite(t,t+e.byteLength)}_flush(){return this._baseTarget._flush()}async _finalize(){this._emit("finalized")}async _close(){}_setMonotonicity(e){super._setMonotonicity(e),this._baseTarget._setMonotonicity(e)}},zs=class{constructor(e,t){if(this.rootPath=e,this.getTarget=t,typeof e!="string")throw new TypeError("rootPath must be a string.");if(typeof t!="function")throw new TypeError("getTarget must be a function.")}};var oi=57600,SS=2082844800,o0=n=>{let e={},t=n.track;return t.metadata.name!==void 0&&(e.name=t.metadata.name),e},zt=(n,e,t=!0)=>{let i=n*e;return t?Math.round(i):i},Os=n=>{if(n.samples.length===0)return 0;let e=1/0,t=-1/0;for(let i=0;i<n.samples.length;i++){let r=n.samples[i];r.timestamp<e&&(e=r.timestamp),r.timestamp+r.duration>t&&(t=r.timestamp+r.duration)}return e===1/0?0:t-e},wc=class extends bc{constructor(e,t){super(e),this.writer=null,this.boxWriter=null,this.initWriter=null,this.initBoxWriter=null,this.auxTarget=new Nr,this.auxWriter=new ks(this.auxTarget,!1),this.auxBoxWriter=new Us(this.auxWriter),this.mdat=null,this.ftypSize=null,this.trackDatas=[],this.allTracksKnown=eg(),this.creationTime=Math.floor(Date.now()/1e3)+SS,this.finalizedChunks=[],this.wroteFragmentedHeader=!1,this.nextFragmentNumber=1,this.maxWrittenTimestamp=-1/0,this.minWrittenTimestamp=1/0,this.maxWrittenEndTimestamp=-1/0,this.segmentHeaderSize=null,this.format=t,this.formatOptions={...t._options},this.isQuickTime=t instanceof To,this.isCmaf=t instanceof Mo,this.minimumFragmentDuration=this.formatOptions.minimumFragmentDuration??(t instanceof Mo?1/0:1),this.auxWriter.start()}async start(){let e=await this.mutex.acquire();if(this.isCmaf?(this.fastStart="fragmented",this.isFragmented=!0):(this.writer=await this.output._getRootWriter(i=>this.formatOptions.fastStart!==void 0?this.formatOptions.fastStart==="fragmented":i instanceof Nr),this.boxWriter=new Us(this.writer),this.fastStart=this.formatOptions.fastStart??(this.writer.target instanceof Nr?"in-memory":!1),this.isFragmented=this.fastStart==="fragmented"),this.isCmaf){if(!this.output._hasInitTarget())throw new Error("CMAF outputs require the initTarget field in OutputOptions to be set; the init segment will be written to it.");let i=await this.output._getInitTarget(),r=new ks(i,!0);r.start(),this.initWriter=r,this.initBoxWriter=new Us(r)}let t=this.output.tracks.some(i=>i.isVideoTrack()&&i.source._codec==="avc");{let i=this.initBoxWriter??this.boxWriter;if(_e(i),this.formatOptions.onFtyp&&i.writer.startTrackingWrites(),i.writeBox(Kg({isQuickTime:this.isQuickTime,holdsAvc:t,fragmented:this.isFragmented,cmaf:this.isCmaf})),this.formatOptions.onFtyp){let{data:r,start:s}=i.writer.stopTrackingWrites();this.formatOptions.onFtyp(r,s)}this.ftypSize=i.writer.getPos(),this.isCmaf&&await this.initWriter.flush()}if(this.fastStart!=="in-memory")if(this.fastStart==="reserve"){for(let i of this.output.tracks)if(i.metadata.maximumPacketCount===void 0)throw new Error("All tracks must specify maximumPacketCount in their metadata when using fastStart: 'reserve'.")}else this.isFragmented||(_e(this.writer),_e(this.boxWriter),this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat=Ga(!0),this.boxWriter.writeBox(this.mdat));await this.writer?.flush();for(let i of this.output.tracks)i.isVideoTrack()&&i.metadata.decoderConfig?this.getVideoTrackData(i,i.metadata.primingPacket??null,{decoderConfig:i.metadata.decoderConfig}):i.isAudioTrack()&&i.metadata.decoderConfig&&this.getAudioTrackData(i,i.metadata.primingPacket??null,{decoderConfig:i.metadata.decoderConfig});e()}allTracksAreKnown(){for(let e of this.output.tracks)if(!e.source._closed&&!this.trackDatas.some(t=>t.track===e))return!1;return!0}async getMimeType(){await this.allTracksKnown.promise;let e=this.trackDatas.map(t=>t.type==="video"||t.type==="audio"?t.info.decoderConfig.codec:{webvtt:"wvtt"}[t.track.source._codec]);return kg({isQuickTime:this.isQuickTime,hasVideo:this.trackDatas.some(t=>t.type==="video"),hasAudio:this.trackDatas.some(t=>t.type==="audio"),codecStrings:e})}getVideoTrackData(e,t,i){let r=this.trackDatas.find(f=>f.track===e);if(r)return r;xc(i,e.source._codec),_e(i),_e(i.decoderConfig);let s={...i.decoderConfig};_e(s.codedWidth!==void 0),_e(s.codedHeight!==void 0);let o=!1;if(e.source._codec==="avc"&&!s.description){if(!t)throw new Error("No AVC description provided; you must therefore provide a priming packet.");let f=Ag(t.data);if(!f)throw new Error("Couldn't extract an AVCDecoderConfigurationRecord from the AVC packet. Make sure the packets are in Annex B format (as specified in ITU-T-REC-H.264) when not providing a description, or provide a description (must be an AVCDecoderConfigurationRecord as specified in ISO 14496-15) and ensure the packets are in AVCC format.");s.description=Mg(f),o=!0}else if(e.source._codec==="hevc"&&!s.description){if(!t)throw new Error("No HEVC description provided; you must therefore provide a priming packet.");let f=Eg(t.data);if(!f)throw new Error("Couldn't extract an HEVCDecoderConfigurationRecord from the HEVC packet. Make sure the packets are in Annex B format (as specified in ITU-T-REC-H.265) when not providing a description, or provide a description (must be an HEVCDecoderConfigurationRecord as specified in ISO 14496-15) and ensure the packets are in HEVC format.");s.description=Cg(f),o=!0}let a=sg(1/(e.metadata.frameRate??oi),1e6).den,l=s.displayAspectWidth,c=s.displayAspectHeight,u=l===void 0||c===void 0?{num:1,den:1}:ag({num:l*s.codedHeight,den:c*s.codedWidth}),h=s.codec==="ap4h"||s.codec==="ap4x",d={muxer:this,track:e,type:"video",info:{width:s.codedWidth,height:s.codedHeight,pixelAspectRatio:u,decoderConfig:s,requiresAnnexBTransformation:o,hasAlphaChannel:h},timescale:a,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0};return this.trackDatas.push(d),this.trackDatas.sort((f,m)=>f.track.id-m.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),d}getAudioTrackData(e,t,i){let r=this.trackDatas.find(l=>l.track===e);if(r)return r;yc(i,e.source._codec),_e(i),_e(i.decoderConfig);let s={...i.decoderConfig},o=!1;if(e.source._codec==="aac"&&!s.description){if(!t)throw new Error("No AAC description provided; you must therefore provide a priming packet.");let l=Md(Ha.tempFromBytes(t.data));if(!l)throw new Error("Couldn't parse ADTS header from the AAC packet. Make sure the packets are in ADTS format (as specified in ISO 13818-7) when not providing a description, or provide a description (must be an AudioSpecificConfig as specified in ISO 14496-3) and ensure the packets are raw AAC data.");let c=_d[l.samplingFrequencyIndex],u=bd[l.channelConfiguration];if(c===void 0||u===void 0)throw new Error("Invalid ADTS frame header.");s.description=fg({objectType:l.objectType,outputSampleRate:c,outputNumberOfChannels:u}),o=!0}if(!t){if(e.source._codec==="ac3"||e.source._codec==="eac3")throw new Error("AC-3/E-AC-3 require a priming packet.");if(e.source._codec==="dts")throw new Error("DTS requires a priming packet.")}let a={muxer:this,track:e,type:"audio",info:{numberOfChannels:i.decoderConfig.numberOfChannels,sampleRate:i.decoderConfig.sampleRate,decoderConfig:s,requiresPcmTransformation:!this.isFragmented&&fr.includes(e.source._codec),expectedNextPcmPacketTimestamp:null,requiresAdtsStripping:o,primingPacket:t},timescale:s.sampleRate,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0};return this.trackDatas.push(a),this.trackDatas.sort((l,c)=>l.track.id-c.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),a}getSubtitleTrackData(e,t){let i=this.trackDatas.find(s=>s.track===e);if(i)return i;Ug(t),_e(t),_e(t.config);let r={muxer:this,track:e,type:"subtitle",info:{config:t.config},timescale:1e3,samples:[],sampleQueue:[],timestampProcessingQueue:[],timeToSampleTable:[],compositionTimeOffsetTable:[],lastTimescaleUnits:null,lastSample:null,startTimestampOffset:null,finalizedChunks:[],currentChunk:null,compactlyCodedChunkTable:[],closed:!1,avgBitrate:e.source._nominalBitrate??e.metadata.averageBitrate??0,maxBitrate:e.source._nominalBitrate??e.metadata.bitrate??0,lastCueEndTimestamp:null,cueQueue:[],nextSourceId:0,cueToSourceId:new WeakMap};return this.trackDatas.push(r),this.trackDatas.sort((s,o)=>s.track.id-o.track.id),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),r}async addEncodedVideoPacket(e,t,i){let r=await this.mutex.acquire();try{let s=this.getVideoTrackData(e,t,i),o=t.data;if(s.info.requiresAnnexBTransformation){let l=[...mc(o)].map(c=>o.subarray(c.offset,c.offset+c.length));if(l.length===0)throw new Error("Failed to transform packet data. Make sure all packets are provided in Annex B format, as specified in ITU-T-REC-H.264 and ITU-T-REC-H.265.");o=Sg(l,4)}this.validateTimestamp(s.track,t.timestamp,t.type==="key");let a=this.createSampleForTrack(s,o,t.timestamp,t.duration,t.type);await this.registerSample(s,a)}finally{r()}}async addEncodedAudioPacket(e,t,i){let r=await this.mutex.acquire();try{let s=this.getAudioTrackData(e,t,i),o=t.data;if(s.info.requiresAdtsStripping){let u=Md(Ha.tempFromBytes(o));if(!u)throw new Error("Expected ADTS frame, didn't get one.");let h=u.crcCheck===null?zg:Vg;o=o.subarray(h)}this.validateTimestamp(s.track,t.timestamp,t.type==="key");let a=t.timestamp,l=t.duration;if(s.info.requiresPcmTransformation){let h=Fr(s.info.decoderConfig.codec).sampleSize*s.info.numberOfChannels;if(l=o.byteLength/h/s.info.sampleRate,s.info.expectedNextPcmPacketTimestamp!==null){let d=a-s.info.expectedNextPcmPacketTimestamp;if(d<.01)a=s.info.expectedNextPcmPacketTimestamp;else{let f=await this.padWithSilence(s,s.info.expectedNextPcmPacketTimestamp,d);a=s.info.expectedNextPcmPacketTimestamp+f}}s.info.expectedNextPcmPacketTimestamp=a+l}let c=this.createSampleForTrack(s,o,a,l,t.type);await this.registerSample(s,c)}finally{r()}}async padWithSilence(e,t,i){let r=zt(i,e.timescale);if(i=r/e.timescale,r>0){let{sampleSize:s,silentValue:o}=Fr(e.info.decoderConfig.codec),a=r*e.info.numberOfChannels,l=new Uint8Array(s*a).fill(o),c=this.createSampleForTrack(e,new Uint8Array(l.buffer),t,i,"key");await this.registerSample(e,c)}return i}async addSubtitleCue(e,t,i){let r=await this.mutex.acquire();try{let s=this.getSubtitleTrackData(e,i);this.validateTimestamp(s.track,t.timestamp,!0),e.source._codec==="webvtt"&&(s.cueQueue.push(t),await this.processWebVTTCues(s,t.timestamp))}finally{r()}}async processWebVTTCues(e,t){for(;e.cueQueue.length>0;){e.lastCueEndTimestamp??=Math.min(0,e.cueQueue[0].timestamp);let i=new Set([]);for(let c of e.cueQueue)_e(c.timestamp<=t),_e(e.lastCueEndTimestamp<=c.timestamp+c.duration),i.add(Math.max(c.timestamp,e.lastCueEndTimestamp)),i.add(c.timestamp+c.duration);let r=[...i].sort((c,u)=>c-u),s=r[0],o=r[1]??s;if(t<o)break;if(e.lastCueEndTimestamp<s){this.auxWriter.seek(0);let c=e0();this.auxBoxWriter.writeBox(c);let u=this.auxTarget._getSlice(0,this.auxWriter.getPos()),h=this.createSampleForTrack(e,u,e.lastCueEndTimestamp,s-e.lastCueEndTimestamp,"key");await this.registerSample(e,h),e.lastCueEndTimestamp=s}this.auxWriter.seek(0);for(let c=0;c<e.cueQueue.length;c++){let u=e.cueQueue[c];if(u.timestamp>=o)break;Td.lastIndex=0;let h=Td.test(u.text),d=u.timestamp+u.duration,f=e.cueToSourceId.get(u);if(f===void 0&&o<d&&(f=e.nextSourceId++,e.cueToSourceId.set(u,f)),u.notes){let b=n0(u.notes);this.auxBoxWriter.writeBox(b)}let m=t0(u.text,h?s:null,u.identifier??null,u.settings??null,f??null);this.auxBoxWriter.writeBox(m),d===o&&e.cueQueue.splice(c--,1)}let a=this.auxTarget._getSlice(0,this.auxWriter.getPos()),l=this.createSampleForTrack(e,a,s,o-s,"key");await this.registerSample(e,l),e.lastCueEndTimestamp=o}}createSampleForTrack(e,t,i,r,s){return{timestamp:i,decodeTimestamp:i,duration:r,data:t,size:t.byteLength,type:s,timescaleUnitsToNextSample:zt(r,e.timescale)}}processTimestamps(e,t){if(e.timestampProcessingQueue.length===0)return;if(e.type==="audio"&&e.info.requiresPcmTransformation){_e(!this.isFragmented),e.startTimestampOffset??=e.timestampProcessingQueue[0].timestamp;let r=0;for(let s=0;s<e.timestampProcessingQueue.length;s++){let o=e.timestampProcessingQueue[s],a=zt(o.duration,e.timescale);r+=a}if(e.timeToSampleTable.length===0)e.timeToSampleTable.push({sampleCount:r,sampleDelta:1});else{let s=lr(e.timeToSampleTable);s.sampleCount+=r}e.timestampProcessingQueue.length=0;return}let i=e.timestampProcessingQueue.map(r=>r.timestamp).sort((r,s)=>r-s);this.isFragmented?e.startTimestampOffset??=Math.min(i[0],0):e.startTimestampOffset??=i[0];for(let r=0;r<e.timestampProcessingQueue.length;r++){let s=e.timestampProcessingQueue[r];s.decodeTimestamp=i[r];let o=zt(s.timestamp-s.decodeTimestamp,e.timescale),a=zt(s.duration,e.timescale);if(e.lastTimescaleUnits!==null){_e(e.lastSample);let l=zt(s.decodeTimestamp,e.timescale,!1),c=Math.round(l-e.lastTimescaleUnits);if(_e(c>=0),e.lastTimescaleUnits+=c,e.lastSample.timescaleUnitsToNextSample=c,!this.isFragmented){let u=lr(e.timeToSampleTable);if(_e(u),u.sampleCount===1){u.sampleDelta=c;let d=e.timeToSampleTable[e.timeToSampleTable.length-2];d&&d.sampleDelta===c&&(d.sampleCount++,e.timeToSampleTable.pop(),u=d)}else u.sampleDelta!==c&&(u.sampleCount--,e.timeToSampleTable.push(u={sampleCount:1,sampleDelta:c}));u.sampleDelta===a?u.sampleCount++:e.timeToSampleTable.push({sampleCount:1,sampleDelta:a});let h=lr(e.compositionTimeOffsetTable);_e(h),h.sampleCompositionTimeOffset===o?h.sampleCount++:e.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:o})}}else e.lastTimescaleUnits=zt(s.decodeTimestamp,e.timescale,!1),this.isFragmented||(e.timeToSampleTable.push({sampleCount:1,sampleDelta:a}),e.compositionTimeOffsetTable.push({sampleCount:1,sampleCompositionTimeOffset:o}));e.lastSample=s}if(e.timestampProcessingQueue.length=0,_e(e.lastSample),_e(e.lastTimescaleUnits!==null),t!==void 0&&e.lastSample.timescaleUnitsToNextSample===0){_e(t.type==="key");let r=zt(t.timestamp,e.timescale,!1),s=Math.round(r-e.lastTimescaleUnits);e.lastSample.timescaleUnitsToNextSample=s}}async registerSample(e,t){t.type==="key"&&this.processTimestamps(e,t),e.timestampProcessingQueue.push(t),this.isFragmented?(e.sampleQueue.push(t),await this.interleaveSamples()):this.fastStart==="reserve"?await this.registerSampleFastStartReserve(e,t):await this.addSampleToTrack(e,t)}async addSampleToTrack(e,t){if(!this.isFragmented&&(e.samples.push(t),this.fastStart==="reserve")){let r=e.track.metadata.maximumPacketCount;if(_e(r!==void 0),e.samples.length>r)throw new Error(`Track #${e.track.id} has already reached the maximum packet count (${r}). Either add less packets or increase the maximum packet count.`)}let i=!1;if(!e.currentChunk)i=!0;else{e.currentChunk.startTimestamp=Math.min(e.currentChunk.startTimestamp,t.timestamp);let r=t.timestamp-e.currentChunk.startTimestamp;if(this.isFragmented){let s=this.trackDatas.every(o=>{if(e===o)return t.type==="key";let a=o.sampleQueue[0];return a?a.type==="key":o.closed});r>=this.minimumFragmentDuration&&s&&t.timestamp>this.maxWrittenTimestamp&&(i=!0,await this.finalizeFragment())}else i=r>=.5}i&&(e.currentChunk&&await this.finalizeCurrentChunk(e),e.currentChunk={startTimestamp:t.timestamp,samples:[],offset:null,moofOffset:null,trafIndex:null}),_e(e.currentChunk),e.currentChunk.samples.push(t),this.isFragmented&&(this.maxWrittenTimestamp=Math.max(this.maxWrittenTimestamp,t.timestamp),this.maxWrittenEndTimestamp=Math.max(this.maxWrittenEndTimestamp,t.timestamp+t.duration),this.minWrittenTimestamp=Math.min(this.minWrittenTimestamp,t.timestamp))}async finalizeCurrentChunk(e){if(_e(!this.isFragmented),_e(this.writer),!e.currentChunk)return;e.finalizedChunks.push(e.currentChunk),this.finalizedChunks.push(e.currentChunk);let t=e.currentChunk.samples.length;if(e.type==="audio"&&e.info.requiresPcmTransformation&&(t=e.currentChunk.samples.reduce((i,r)=>i+zt(r.duration,e.timescale),0)),(e.compactlyCodedChunkTable.length===0||lr(e.compactlyCodedChunkTable).samplesPerChunk!==t)&&e.compactlyCodedChunkTable.push({firstChunk:e.finalizedChunks.length,samplesPerChunk:t}),this.fastStart==="in-memory"){e.currentChunk.offset=0;return}e.currentChunk.offset=this.writer.getPos();for(let i of e.currentChunk.samples)_e(i.data),this.writer.write(i.data),i.data=null;await this.writer.flush()}async interleaveSamples(e=!1){if(_e(this.isFragmented),!(!e&&!this.allTracksAreKnown()))e:for(;;){let t=null,i=1/0;for(let s of this.trackDatas){if(!e&&s.sampleQueue.length===0&&!s.closed)break e;s.sampleQueue.length>0&&s.sampleQueue[0].timestamp<i&&(t=s,i=s.sampleQueue[0].timestamp)}if(!t)break;let r=t.sampleQueue.shift();await this.addSampleToTrack(t,r)}}async finalizeFragment(e=!this.isCmaf){if(_e(this.isFragmented),!this.wroteFragmentedHeader){this.wroteFragmentedHeader=!0;let f=this.initBoxWriter??this.boxWriter;_e(f),this.formatOptions.onMoov&&f.writer.startTrackingWrites(),this.ensureOneEnabledTrack();let m=Ao(this);if(f.writeBox(m),this.formatOptions.onMoov){let{data:b,start:g}=f.writer.stopTrackingWrites();this.formatOptions.onMoov(b,g)}if(this.isCmaf){_e(this.initWriter),await this.initWriter.flush(),await this.initWriter.finalize(),this.writer=await this.output._getRootWriter(!0),this.boxWriter=new Us(this.writer);let b=this.boxWriter.measureBox(Id()),g=this.boxWriter.measureBox(Ld(this,0));this.segmentHeaderSize=b+g,this.writer.seek(this.segmentHeaderSize)}}_e(this.writer),_e(this.boxWriter);let t=this.trackDatas.filter(f=>f.currentChunk);if(t.length===0){e&&await this.writer.flush();return}let i=this.nextFragmentNumber++,r=Bd(i,t),s=this.writer.getPos(),o=s+this.boxWriter.measureBox(r),a=o+_c,l=1/0;for(let f=0;f<t.length;f++){let m=t[f];_e(m.currentChunk),_e(m.startTimestampOffset!==null),m.currentChunk.offset=a,m.currentChunk.moofOffset=s,m.currentChunk.trafIndex=f,m.currentChunk.startTimestamp-=m.startTimestampOffset;for(let b of m.currentChunk.samples)a+=b.size,b.timestamp-=m.startTimestampOffset,b.decodeTimestamp-=m.startTimestampOffset;l=Math.min(l,m.currentChunk.startTimestamp)}let c=a-o,u=c>=2**32;if(u)for(let f of t)f.currentChunk.offset+=Ad-_c;this.formatOptions.onMoof&&this.writer.startTrackingWrites();let h=Bd(i,t);if(this.boxWriter.writeBox(h),this.formatOptions.onMoof){let{data:f,start:m}=this.writer.stopTrackingWrites();this.formatOptions.onMoof(f,m,l)}_e(this.writer.getPos()===o),this.formatOptions.onMdat&&this.writer.startTrackingWrites();let d=Ga(u);d.size=c,this.boxWriter.writeBox(d),this.writer.seek(o+(u?Ad:_c));for(let f of t)for(let m of f.currentChunk.samples)this.writer.write(m.data),m.data=null;if(this.formatOptions.onMdat){let{data:f,start:m}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(f,m)}for(let f of t)f.finalizedChunks.push(f.currentChunk),this.finalizedChunks.push(f.currentChunk),f.currentChunk=null;e&&await this.writer.flush()}async registerSampleFastStartReserve(e,t){this.allTracksAreKnown()?(this.mdat||await this.createFastStartReserveMdat(),await this.addSampleToTrack(e,t)):e.sampleQueue.push(t)}async createFastStartReserveMdat(){_e(this.writer),_e(this.boxWriter),this.ensureOneEnabledTrack();let e=Ao(this),i=this.boxWriter.measureBox(e)+this.computeSampleTableSizeUpperBound()+4096;_e(this.ftypSize!==null),this.writer.seek(this.ftypSize+i),this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat=Ga(!0),this.boxWriter.writeBox(this.mdat);for(let r of this.trackDatas){for(let s of r.sampleQueue)await this.addSampleToTrack(r,s);r.sampleQueue.length=0}}computeSampleTableSizeUpperBound(){_e(this.fastStart==="reserve");let e=0;for(let t of this.trackDatas){let i=t.track.metadata.maximumPacketCount;_e(i!==void 0),e+=8*Math.ceil(2/3*i),e+=4*i,e+=8*Math.ceil(2/3*i),e+=12*Math.ceil(2/3*i),e+=4*i,e+=8*i}return e}async onTrackClose(e){let t=await this.mutex.acquire(),i=this.trackDatas.find(r=>r.track===e);i&&(i.closed=!0,i.type==="subtitle"&&e.source._codec==="webvtt"&&await this.processWebVTTCues(i,1/0),this.processTimestamps(i)),this.allTracksAreKnown()&&this.allTracksKnown.resolve(),this.isFragmented&&await this.interleaveSamples(),t()}ensureOneEnabledTrack(){for(let e of["video","audio","subtitle"]){let t=this.trackDatas.filter(r=>r.type===e);if(t.length===0)continue;if(!t.some(r=>r.track.metadata.disposition?.default!==!1)){let r=t[0];r.track.metadata.disposition={...r.track.metadata.disposition,default:!0}}}}async forceFragmentFinalization(){_e(this.isFragmented);let e=await this.mutex.acquire();try{for(let t of this.trackDatas)t.type==="subtitle"&&t.track.source._codec==="webvtt"&&await this.processWebVTTCues(t,1/0),this.processTimestamps(t);await this.interleaveSamples(!0),await this.finalizeFragment()}finally{e()}}async finalize(){let e=await this.mutex.acquire();this.allTracksKnown.resolve(),this.ensureOneEnabledTrack(),!this.mdat&&this.fastStart==="reserve"&&await this.createFastStartReserveMdat();for(let t of this.trackDatas)t.closed=!0,t.type==="subtitle"&&t.track.source._codec==="webvtt"&&await this.processWebVTTCues(t,1/0),this.processTimestamps(t);if(this.isFragmented)await this.interleaveSamples(!0),await this.finalizeFragment(!1);else for(let t of this.trackDatas){await this.finalizeCurrentChunk(t);let i=Os(t);if(i>0){let a=0;for(let l of t.samples)a+=l.size;t.avgBitrate=Math.round(8*a/i)}else t.avgBitrate=0;let r=0,s=0,o=0;for(let a=0;a<t.samples.length;a++){let l=t.samples[a];for(s+=l.size;l.decodeTimestamp-t.samples[r].decodeTimestamp>=1;)s-=t.samples[r].size,r++;o=Math.max(o,s)}if(t.maxBitrate=8*o,t.startTimestampOffset!==null)for(let a=0;a<t.samples.length;a++){let l=t.samples[a];l.timestamp-=t.startTimestampOffset,l.decodeTimestamp-=t.startTimestampOffset}}if(_e(this.writer),_e(this.boxWriter),this.fastStart==="in-memory"){this.mdat=Ga(!1);let t;for(let r=0;r<2;r++){let s=Ao(this),o=this.boxWriter.measureBox(s);t=this.boxWriter.measureBox(this.mdat);let a=this.writer.getPos()+o+t;for(let l of this.finalizedChunks){l.offset=a;for(let{data:c}of l.samples)_e(c),a+=c.byteLength,t+=c.byteLength}if(a<2**32)break;t>=2**32&&(this.mdat.largeSize=!0)}this.formatOptions.onMoov&&this.writer.startTrackingWrites();let i=Ao(this);if(this.boxWriter.writeBox(i),this.formatOptions.onMoov){let{data:r,start:s}=this.writer.stopTrackingWrites();this.formatOptions.onMoov(r,s)}this.formatOptions.onMdat&&this.writer.startTrackingWrites(),this.mdat.size=t,this.boxWriter.writeBox(this.mdat);for(let r of this.finalizedChunks)for(let s of r.samples)_e(s.data),this.writer.write(s.data),s.data=null;if(this.formatOptions.onMdat){let{data:r,start:s}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(r,s)}}else if(this.isFragmented)if(this.isCmaf){let t=this.segmentHeaderSize!==null?this.writer.getPos()-this.segmentHeaderSize:0;this.writer.seek(0),this.boxWriter.writeBox(Id()),this.boxWriter.writeBox(Ld(this,t))}else{let t=this.writer.getPos(),i=Qg(this.trackDatas);this.boxWriter.writeBox(i);let r=this.writer.getPos()-t;this.writer.seek(this.writer.getPos()-4),this.boxWriter.writeU32(r)}else{_e(this.mdat);let t=this.boxWriter.offsets.get(this.mdat);_e(t!==void 0);let i=this.writer.getPos()-t;if(this.mdat.size=i,this.mdat.largeSize=i>=2**32,this.boxWriter.patchBox(this.mdat),this.formatOptions.onMdat){let{data:s,start:o}=this.writer.stopTrackingWrites();this.formatOptions.onMdat(s,o)}let r=Ao(this);if(this.fastStart==="reserve"){_e(this.ftypSize!==null),this.writer.seek(this.ftypSize),this.formatOptions.onMoov&&this.writer.startTrackingWrites(),this.boxWriter.writeBox(r);let s=this.boxWriter.offsets.get(this.mdat)-this.writer.getPos();this.boxWriter.writeBox(Jg(s))}else this.formatOptions.onMoov&&this.writer.startTrackingWrites(),this.boxWriter.writeBox(r);if(this.formatOptions.onMoov){let{data:s,start:o}=this.writer.stopTrackingWrites();this.formatOptions.onMoov(s,o)}}e()}};var Eo=class{constructor(){this._connectedTrack=null,this._closingPromise=null,this._closed=!1,this._nominalBitrate=null}_ensureValidAdd(){if(!this._connectedTrack)throw new Error("Source is not connected to an output track.");if(this._connectedTrack.output.state==="canceled")throw new Error("Output has been canceled.");if(this._connectedTrack.output.state==="finalizing"||this._connectedTrack.output.state==="finalized")throw new Error("Output has been finalized.");if(this._connectedTrack.output.state==="pending")throw new Error("Output has not started.");if(this._closed)throw new Error("Source is closed.")}async _start(){}async _flushAndClose(e){}close(){if(this._closingPromise)return;let e=this._connectedTrack;if(!e)throw new Error("Cannot call close without connecting the source to an output track.");if(e.output.state==="pending")throw new Error("Cannot call close before output has been started.");this._closingPromise=(async()=>{await this._flushAndClose(!1),this._closed=!0,!(e.output.state==="finalizing"||e.output.state==="finalized")&&e.output._muxer.onTrackClose(e)})()}async _flushOrWaitForOngoingClose(e){return this._closingPromise??=(async()=>{await this._flushAndClose(e),this._closed=!0})()}},Co=class extends Eo{constructor(e){if(super(),!us.includes(e))throw new TypeError(`Invalid video codec '${e}'. Must be one of: ${us.join(", ")}.`);this._codec=e}},AS=(n,e)=>{if(n.metadata.hasOnlyKeyPackets&&e.type!=="key")throw new Error("Cannot add non-key packets to a hasOnlyKeyPackets video track.")},Wa=class extends Co{constructor(e){super(e)}add(e,t){if(!(e instanceof pr))throw new TypeError("packet must be an EncodedPacket.");if(e.isMetadataOnly)throw new TypeError("Metadata-only packets cannot be added.");if(t!==void 0&&(!t||typeof t!="object"))throw new TypeError("meta, when provided, must be an object.");return this._ensureValidAdd(),AS(this._connectedTrack,e),this._connectedTrack.output._muxer.addEncodedVideoPacket(this._connectedTrack,e,t)}};var qa=class extends Eo{constructor(e){if(super(),!So.includes(e))throw new TypeError(`Invalid audio codec '${e}'. Must be one of: ${So.join(", ")}.`);this._codec=e}};var Xa=class extends Eo{constructor(e){if(super(),!Ds.includes(e))throw new TypeError(`Invalid subtitle codec '${e}'. Must be one of: ${Ds.join(", ")}.`);this._codec=e}};var Ro=class{get supportsVideoRotationMetadata(){return this.supportsVideoTransformationMetadata}getSupportedVideoCodecs(){return this.getSupportedCodecs().filter(e=>us.includes(e))}getSupportedAudioCodecs(){return this.getSupportedCodecs().filter(e=>So.includes(e))}getSupportedSubtitleCodecs(){return this.getSupportedCodecs().filter(e=>Ds.includes(e))}_codecUnsupportedHint(e){return""}_isFragmentedIsobmff(){return!1}},Po=class extends Ro{constructor(e={}){if(!e||typeof e!="object")throw new TypeError("options must be an object.");if(e.fastStart!==void 0&&![!1,"in-memory","reserve","fragmented"].includes(e.fastStart))throw new TypeError("options.fastStart, when provided, must be false, 'in-memory', 'reserve', or 'fragmented'.");if(e.minimumFragmentDuration!==void 0&&(!og(e.minimumFragmentDuration)||e.minimumFragmentDuration<0))throw new TypeError("options.minimumFragmentDuration, when provided, must be a non-negative number.");if(e.onFtyp!==void 0&&typeof e.onFtyp!="function")throw new TypeError("options.onFtyp, when provided, must be a function.");if(e.onMoov!==void 0&&typeof e.onMoov!="function")throw new TypeError("options.onMoov, when provided, must be a function.");if(e.onMdat!==void 0&&typeof e.onMdat!="function")throw new TypeError("options.onMdat, when provided, must be a function.");if(e.onMoof!==void 0&&typeof e.onMoof!="function")throw new TypeError("options.onMoof, when provided, must be a function.");if(e.metadataFormat!==void 0&&!["mdir","mdta","udta","auto"].includes(e.metadataFormat))throw new TypeError("options.metadataFormat, when provided, must be either 'auto', 'mdir', 'mdta', or 'udta'.");super(),this._options=e}getSupportedTrackCounts(){return{video:{min:0,max:4294967295},audio:{min:0,max:4294967295},subtitle:{min:0,max:4294967295},total:{min:0,max:4294967295}}}get supportsVideoTransformationMetadata(){return!0}get supportsTimestampedMediaData(){return!0}get negativeTimestampSupport(){return"full"}_createMuxer(e){return new wc(e,this)}_isFragmentedIsobmff(){return this._options.fastStart==="fragmented"}},Io=class extends Po{constructor(e){super(e)}get _name(){return"MP4"}get fileExtension(){return".mp4"}get mimeType(){return"video/mp4"}getSupportedCodecs(){return[...us,...gc,"pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be",...Ds]}_codecUnsupportedHint(e){return new To().getSupportedCodecs().includes(e)?" Switching to MOV will grant support for this codec.":""}},Mo=class extends Po{constructor(e){super(e)}get _name(){return"CMAF"}get fileExtension(){return".m4s"}get mimeType(){return"video/mp4"}getSupportedCodecs(){return[...us,...gc,"pcm-s16","pcm-s16be","pcm-s24","pcm-s24be","pcm-s32","pcm-s32be","pcm-f32","pcm-f32be","pcm-f64","pcm-f64be",...Ds]}},To=class extends Po{constructor(e){super(e)}get _name(){return"MOV"}get fileExtension(){return".mov"}get mimeType(){return"video/quicktime"}getSupportedCodecs(){return[...us,...So]}_codecUnsupportedHint(e){return new Io().getSupportedCodecs().includes(e)?" Switching to MP4 will grant support for this codec.":""}};var a0=["video","audio","subtitle"],Lo=class n{constructor(e,t,i,r,s){this.id=e,this.output=t,this.type=i,this.source=r,this.metadata=s}isVideoTrack(){return this.type==="video"}isAudioTrack(){return this.type==="audio"}isSubtitleTrack(){return this.type==="subtitle"}canBePairedWith(e){if(!(e instanceof n))throw new TypeError("other must be an OutputTrack.");if(this===e)return!1;let t=fc(this.metadata.group),i=fc(e.metadata.group);for(let r of t)if(this.type!==e.type&&i.some(a=>r===a)||i.some(a=>r._pairedGroups.has(a)))return!0;return!1}},Sc=class extends Lo{constructor(e,t,i,r){super(e,t,"video",i,r)}},Ac=class extends Lo{constructor(e,t,i,r){super(e,t,"audio",i,r)}},Mc=class extends Lo{constructor(e,t,i,r){super(e,t,"subtitle",i,r)}},Fo=class n{constructor(){this._pairedGroups=new Set}pairWith(e){if(!(e instanceof n))throw new TypeError("other must be an OutputTrackGroup.");if(this===e)throw new TypeError("Cannot pair a group with itself.");this._pairedGroups.add(e),e._pairedGroups.add(this)}},Od=n=>{if(!n||typeof n!="object")throw new TypeError("metadata must be an object.");if(n.languageCode!==void 0&&!rg(n.languageCode))throw new TypeError("metadata.languageCode, when provided, must be a three-letter, ISO 639-2/T language code.");if(n.name!==void 0&&typeof n.name!="string")throw new TypeError("metadata.name, when provided, must be a string.");if(n.disposition!==void 0&&ug(n.disposition),n.maximumPacketCount!==void 0&&(!Number.isInteger(n.maximumPacketCount)||n.maximumPacketCount<0))throw new TypeError("metadata.maximumPacketCount, when provided, must be a non-negative integer.");if(n.bitrate!==void 0&&(!Number.isFinite(n.bitrate)||n.bitrate<0))throw new TypeError("metadata.bitrate, when provided, must be a non-negative number.");if(n.averageBitrate!==void 0&&(!Number.isFinite(n.averageBitrate)||n.averageBitrate<0))throw new TypeError("metadata.averageBitrate, when provided, must be a non-negative number.");if(n.group!==void 0&&!(n.group instanceof Fo)&&(!Array.isArray(n.group)||n.group.some(e=>!(e instanceof Fo))))throw new TypeError("metadata.group, when provided, must be an OutputTrackGroup instance or an array of OutputTrackGroup instances.")},$a=class extends ls{get target(){let e="Output.target cannot be used when using PathedTarget with an async callback. Use the 'target' event instead.";if(this._rootTargetPromise)throw new TypeError(e);let t=this._getRootTarget();if(Oa(t))throw new TypeError(e);return t}constructor(e){if(super(),this.state="pending",this.defaultTrackGroup=new Fo,this.tracks=[],this._onFinalize=null,this._unfinalizedTargets=new Set,this._rootWriterPromise=null,this._startPromise=null,this._cancelPromise=null,this._finalizePromise=null,this._mutex=new vo,this._metadataTags={},this._rootTarget=null,this._rootTargetPromise=null,this._firstMediaStreamTimestamp=null,!e||typeof e!="object")throw new TypeError("options must be an object.");if(!(e.format instanceof Ro))throw new TypeError("options.format must be an OutputFormat.");if(!(e.target instanceof gi||e.target instanceof zs))throw new TypeError("options.target must be a Target or a PathedTarget.");if(e.target instanceof gi&&this._rememberTarget(e.target),e.initTarget!==void 0&&!(e.initTarget instanceof gi)&&typeof e.initTarget!="function")throw new Error("options.initTarget, when provided, must be a Target or a function that returns or resolves to a Target.");if(e.onFinalize!==void 0&&typeof e.onFinalize!="function")throw new TypeError("options.onFinalize, when provided, must be a function.");this.format=e.format,this._target=e.target,this._onFinalize=e.onFinalize??null,this._initTarget=e.initTarget??null,this._initTarget instanceof gi&&this._rememberTarget(this._initTarget),this._muxer=e.format._createMuxer(this)}_getTargetValidated(e){_e(this._target instanceof zs);let t=this._target.getTarget(e),i=r=>{if(!(r instanceof gi))throw new TypeError("getTarget must return a Target.");return r};return Oa(t)?t.then(i):i(t)}async _getTarget(e){_e(this._target instanceof zs);let t=await this._getTargetValidated(e);return this._emit("target",{target:t,request:e,isRoot:e.isRoot}),this.state==="canceled"?await t._close():this._rememberTarget(t),t}_rememberTarget(e){this._unfinalizedTargets.add(e),e.on("finalized",()=>this._unfinalizedTargets.delete(e),{once:!0})}async _getInitTarget(){if(_e(this._initTarget!==null),this._initTarget instanceof gi)return this._initTarget;let e=await this._initTarget();return this.state==="canceled"?await e._close():this._rememberTarget(e),e}_hasInitTarget(){return this._initTarget!==null}_getRootTarget(){if(this._rootTarget)return this._rootTarget;if(this._rootTargetPromise)return this._rootTargetPromise;if(this._target instanceof gi)return this._emit("target",{target:this._target,request:null,isRoot:!0}),this._rootTarget=this._target,this._target;let e={path:this._target.rootPath,isRoot:!0,mimeType:this.format.mimeType},t=this._getTargetValidated(e),i=r=>(this.state==="canceled"?r._close():this._rememberTarget(r),this._emit("target",{target:r,request:e,isRoot:!0}),this._rootTarget=r,r);return Oa(t)?this._rootTargetPromise=t.then(i):i(t)}_getRootWriter(e){return this._rootWriterPromise??=(async()=>{let t=await this._getRootTarget(),i=new ks(t,typeof e=="boolean"?e:e(t));return i.start(),i})()}addVideoTrack(e,t={}){if(!(e instanceof Co))throw new TypeError("source must be a VideoSource.");if(Od(t),t.rotation!==void 0&&![0,90,180,270].includes(t.rotation))throw new TypeError(`Invalid video rotation: ${t.rotation}. Has to be 0, 90, 180 or 270.`);if(t.flip!==void 0&&typeof t.flip!="boolean")throw new TypeError("metadata.flip, when provided, must be a boolean.");if(t.transformationMatrix!==void 0&&(!Array.isArray(t.transformationMatrix)||t.transformationMatrix.length!==9||!t.transformationMatrix.every(r=>Number.isFinite(r))))throw new TypeError("metadata.transformationMatrix, when provided, must be an array of 9 finite numbers.");if(t.frameRate!==void 0&&(!Number.isFinite(t.frameRate)||t.frameRate<=0))throw new TypeError(`Invalid video frame rate: ${t.frameRate}. Must be a positive number.`);if(t.hasOnlyKeyPackets!==void 0&&typeof t.hasOnlyKeyPackets!="boolean")throw new TypeError("metadata.hasOnlyKeyPackets, when provided, must be a boolean.");if(t.canBeTransparent!==void 0&&typeof t.canBeTransparent!="boolean")throw new TypeError("metadata.canBeTransparent, when provided, must be a boolean.");if(t.decoderConfig!==void 0&&xc({decoderConfig:t.decoderConfig},e._codec),t.primingPacket!==void 0){if(!(t.primingPacket instanceof pr))throw new TypeError("metadata.primingPacket, when provided, must be an EncodedPacket.");if(t.decoderConfig===void 0)throw new TypeError("metadata.primingPacket can only be provided alongside metadata.decoderConfig.")}let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new Sc(this.tracks.length+1,this,e,i))}addAudioTrack(e,t={}){if(!(e instanceof qa))throw new TypeError("source must be an AudioSource.");if(Od(t),t.decoderConfig!==void 0&&yc({decoderConfig:t.decoderConfig},e._codec),t.primingPacket!==void 0){if(!(t.primingPacket instanceof pr))throw new TypeError("metadata.primingPacket, when provided, must be an EncodedPacket.");if(t.decoderConfig===void 0)throw new TypeError("metadata.primingPacket can only be provided alongside metadata.decoderConfig.")}let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new Ac(this.tracks.length+1,this,e,i))}addSubtitleTrack(e,t={}){if(!(e instanceof Xa))throw new TypeError("source must be a SubtitleSource.");Od(t);let i={...t};return i.group??=this.defaultTrackGroup,this._addTrack(new Mc(this.tracks.length+1,this,e,i))}setMetadataTags(e){if(cg(e),this.state!=="pending")throw new Error("Cannot set metadata tags after output has been started or canceled.");this._metadataTags=e}_addTrack(e){if(this.state!=="pending")throw new Error("Cannot add track after output has been started or canceled.");if(e.source._connectedTrack)throw new Error("Source is already used for a track.");let t=this.format.getSupportedTrackCounts(),i=this.tracks.reduce((o,a)=>o+(a.type===e.type?1:0),0),r=t[e.type].max;if(i===r)throw new Error(r===0?`${this.format._name} does not support ${e.type} tracks.`:`${this.format._name} does not support more than ${r} ${e.type} track${r===1?"":"s"}.`);let s=t.total.max;if(this.tracks.length===s)throw new Error(`${this.format._name} does not support more than ${s} tracks${s===1?"":"s"} in total.`);if(e.isVideoTrack()){let o=this.format.getSupportedVideoCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support video tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported video codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}else if(e.isAudioTrack()){let o=this.format.getSupportedAudioCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support audio tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported audio codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}else if(e.isSubtitleTrack()){let o=this.format.getSupportedSubtitleCodecs();if(o.length===0)throw new Error(`${this.format._name} does not support subtitle tracks.`+this.format._codecUnsupportedHint(e.source._codec));if(!o.includes(e.source._codec))throw new Error(`Codec '${e.source._codec}' cannot be contained within ${this.format._name}. Supported subtitle codecs are: ${o.map(a=>`'${a}'`).join(", ")}.`+this.format._codecUnsupportedHint(e.source._codec))}return this.tracks.push(e),e.source._connectedTrack=e,e}hasEnoughTracks(){let e=this.format.getSupportedTrackCounts();for(let i of a0){let r=this.tracks.reduce((o,a)=>o+(a.type===i?1:0),0),s=e[i].min;if(r<s)return!1}let t=e.total.min;return!(this.tracks.length<t)}async start(){let e=this.format.getSupportedTrackCounts();for(let i of a0){let r=this.tracks.reduce((o,a)=>o+(a.type===i?1:0),0),s=e[i].min;if(r<s)throw new Error(s===e[i].max?`${this.format._name} requires exactly ${s} ${i} track${s===1?"":"s"}.`:`${this.format._name} requires at least ${s} ${i} track${s===1?"":"s"}.`)}let t=e.total.min;if(this.tracks.length<t)throw new Error(t===e.total.max?`${this.format._name} requires exactly ${t} track${t===1?"":"s"}.`:`${this.format._name} requires at least ${t} track${t===1?"":"s"}.`);if(this.state==="canceled")throw new Error("Output has been canceled.");return this._startPromise?(ei._warn("Output has already been started."),this._startPromise):this._startPromise=(async()=>{this.state="started";let i=this._mutex.acquire();try{await this._muxer.start();let r=this.tracks.map(s=>s.source._start());await Promise.all(r)}finally{(await i)()}})()}getMimeType(){return this._muxer.getMimeType()}async cancel(){if(this.state==="canceled")return this._cancelPromise??void 0;if(this.state==="finalizing"||this.state==="finalized"){this.state==="finalized"&&ei._warn("Output has already been finalized.");return}return this._cancelPromise=(async()=>{this.state="canceled";let e=await this._mutex.acquire();try{let t=this.tracks.map(i=>i.source._flushOrWaitForOngoingClose(!0));await Promise.all(t),await Promise.all([...this._unfinalizedTargets].map(i=>i._close())),this._unfinalizedTargets.clear()}finally{e()}})()}async finalize(){if(this.state==="pending")throw new Error("Cannot finalize before starting.");if(this.state==="canceled")throw new Error("Cannot finalize after canceling.");return this._finalizePromise?(ei._warn("Output has already been finalized."),this._finalizePromise):this._finalizePromise=(async()=>{this.state="finalizing";let e=await this._mutex.acquire();try{let t=this.tracks.map(i=>i.source._flushOrWaitForOngoingClose(!1));if(await Promise.all(t),await this._muxer.finalize(),this._rootWriterPromise){let i=await this._rootWriterPromise;i.finalized||(await i.flush(),await i.finalize())}this._onFinalize&&await this._onFinalize(),this.state="finalized"}catch(t){throw this.state="canceled",t}finally{await Promise.all([...this._unfinalizedTargets].map(t=>t._close().catch(()=>{}))),this._unfinalizedTargets.clear(),e()}})()}};var l0=Symbol.for("mediabunny loaded");globalThis[l0]&&ei._error(`[WARNING]
Mediabunny was loaded twice. This will likely cause Mediabunny not to work correctly. Check if multiple dependencies are importing different versions of Mediabunny, or if something is being bundled incorrectly.`);globalThis[l0]=!0;var No=30,MS=[{codec:"avc1.640028",kind:"avc"},{codec:"avc1.42001f",kind:"avc"},{codec:"vp09.00.41.08",kind:"vp9"},{codec:"av01.0.08M.08",kind:"av1"}];async function u0(n){if(typeof VideoEncoder>"u")return{message:"This browser cannot write films; a picture and a 3D file can be had."};let[e,t]=[c0(n.width),c0(n.height)],i=await TS(e,t);if(i===null)return{message:"This browser has no encoder for films of this size."};let r=new Nr,s=new $a({format:new Io,target:r}),o=new Wa(i.kind);s.addVideoTrack(o,{frameRate:No}),await s.start();let a=null,l=Promise.resolve(),c=new VideoEncoder({output:(h,d)=>{l=l.then(()=>o.add(pr.fromEncodedChunk(h),d))},error:h=>a=h});c.configure(i.config);let u=Math.max(1,Math.round(n.duration*No));for(let h=0;h<u&&a===null;h++){if(!n.wanted())return c.close(),await s.cancel(),{message:"The film was stopped."};let d=new VideoFrame(await n.picture(h/No),{timestamp:Math.round(h*1e6/No),duration:Math.round(1e6/No)});for(c.encode(d,{keyFrame:h%60===0}),d.close(),n.progress((h+1)/u);c.encodeQueueSize>4;)await new Promise(f=>setTimeout(f,4))}return a===null&&await c.flush(),await l,a!==null?{message:`The browser's encoder failed: ${a.message}.`}:(await s.finalize(),new Blob([r.buffer??new ArrayBuffer(0)],{type:"video/mp4"}))}async function TS(n,e){for(let{codec:t,kind:i}of MS){let r={codec:t,width:n,height:e,bitrate:8*n*e,framerate:No};if(i==="avc"&&(r.avc={format:"avc"}),(await VideoEncoder.isConfigSupported(r).catch(()=>null))?.supported===!0)return{kind:i,config:r}}return null}function c0(n){return 2*Math.max(1,Math.round(n/2))}var ES=5126,CS=5125,kd=class{views=[];accessors=[];parts=[];length=0;add(e,t,i){let r={SCALAR:1,VEC3:3,VEC4:4}[t],s={bufferView:this.views.length,componentType:e instanceof Float32Array?ES:CS,count:e.length/r,type:t};if(i){let o=l=>Array.from({length:s.count},(c,u)=>e[u*r+l]??0),a=Array.from({length:r},(l,c)=>o(c));s.min=a.map(l=>l.reduce((c,u)=>Math.min(c,u),1/0)),s.max=a.map(l=>l.reduce((c,u)=>Math.max(c,u),-1/0))}return this.views.push({buffer:0,byteOffset:this.length,byteLength:e.byteLength}),this.parts.push(e),this.length+=e.byteLength,this.accessors.push(s)-1}bytes(){let e=new Uint8Array(this.length),t=0;for(let i of this.parts)e.set(new Uint8Array(i.buffer,i.byteOffset,i.byteLength),t),t+=i.byteLength;return e}};function h0(n,e,t){let i=new kd,r=i.add(e.positions,"VEC3",!0),s=i.add(e.normals,"VEC3",!1),o=[0,1].map(m=>{let b=[];e.tones.forEach((p,_)=>{p===m&&b.push(e.indices[3*_]??0,e.indices[3*_+1]??0,e.indices[3*_+2]??0)});let g=i.add(Uint32Array.from(b),"SCALAR",!1);return{attributes:{POSITION:r,NORMAL:s},indices:g,material:m}}),a=t.times.length,l=i.add(Float32Array.from(t.times),"SCALAR",!0),c=t.columns.centre,u=i.add(Float32Array.from({length:3*a},(m,b)=>c?.[b]??0),"VEC3",!1),h=i.add(RS(t,a),"VEC4",!1),d=e.hollow?bn.shell:bn.body,f={asset:{version:"2.0",generator:"chaplygin"},scene:0,scenes:[{name:n,nodes:[1]}],nodes:[{name:"body",mesh:0},{name:"space",children:[0],rotation:[-Math.SQRT1_2,0,0,Math.SQRT1_2]}],meshes:[{name:"body",primitives:o}],materials:d.map(m=>({pbrMetallicRoughness:{baseColorFactor:[...tc(m).map(PS),1],metallicFactor:0,roughnessFactor:.55},doubleSided:!0})),animations:[{name:"motion",samplers:[{input:l,output:u,interpolation:"LINEAR"},{input:l,output:h,interpolation:"LINEAR"}],channels:[{sampler:0,target:{node:0,path:"translation"}},{sampler:1,target:{node:0,path:"rotation"}}]}],accessors:i.accessors,bufferViews:i.views,buffers:[{byteLength:i.length}]};return IS(JSON.stringify(f),i.bytes())}function RS(n,e){let t=n.columns.attitude,i=new Float32Array(4*e),r=[0,0,0,1];for(let s=0;s<e;s++){let[o=1,a=0,l=0,c=0]=[0,1,2,3].map(h=>t?.[4*s+h]??(h===0?1:0)),u=a*(r[0]??0)+l*(r[1]??0)+c*(r[2]??0)+o*(r[3]??0)<0?-1:1;r=[u*a,u*l,u*c,u*o],i.set(r,4*s)}return i}function PS(n){let e=n/255;return e<=.04045?e/12.92:((e+.055)/1.055)**2.4}function IS(n,e){let t=new TextEncoder().encode(n),i=4*Math.ceil(t.length/4),r=4*Math.ceil(e.length/4),s=20+i+8+r,o=new Uint8Array(s),a=new DataView(o.buffer);return[1179937895,2,s,i,1313821514].forEach((c,u)=>a.setUint32(4*u,c,!0)),o.fill(32,20,20+i),o.set(t,20),a.setUint32(20+i,r,!0),a.setUint32(24+i,5130562,!0),o.set(e,28+i),o}var LS="'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif",Za=640,zn={left:70,right:16,top:30,height:190,gap:44};function d0(n,e,t){let i=zn.top+t.length*(zn.height+zn.gap)+8,r=e[e.length-1]??1,s=a=>zn.left+a/(r||1)*(Za-zn.left-zn.right),o=t.map(({label:a,unit:l,components:c},u)=>{let h=zn.top+u*(zn.height+zn.gap),[d,f]=Lr(c.flatMap(({values:_})=>Array.from(_))),m=_=>h+(f-_)/(f-d)*zn.height,b=c.map(({values:_},T)=>{let w=["","7 3","2 3"][T%3]??"",C=bn.components[T]??bn.series[T%bn.series.length]??bn.ink;return`<path d="${FS(e,_,s,m)}" fill="none" stroke="${C}" stroke-width="1.3"${w?` stroke-dasharray="${w}"`:""}/>`}),g=c.map(({label:_},T)=>{let w=zn.left+T*84,C=bn.components[T]??bn.series[T%bn.series.length]??bn.ink,E=["","7 3","2 3"][T%3]??"";return`<path d="M${w} ${h-10}h22" stroke="${C}" stroke-width="1.6"${E?` stroke-dasharray="${E}"`:""}/>${Ya(w+28,h-6,_,"start",!0)}`});return m0(s,m,[0,r],[d,f],h,zn.height,u===t.length-1?"t  (s)":"",`${a}${l?`  (${l})`:""}`)+b.join("")+(c.length>1?g.join(""):"")});return p0(n,Za,i,o.join(""))}function f0(n,e,t,i){let s=l=>zn.left+(l-e.range[0])/(e.range[1]-e.range[0])*(Za-zn.left-zn.right),o=l=>16+(t.range[1]-l)/(t.range[1]-t.range[0])*480,a=i.map(({x:l,y:c,colour:u})=>{let h=[];for(let d=0;d<l.length;d++){let[f,m]=[s(l[d]??NaN),o(c[d]??NaN)];f>=zn.left&&f<=Za-zn.right&&m>=16&&m<=496&&h.push(`M${f.toFixed(1)} ${m.toFixed(1)}h0`)}return`<path d="${h.join("")}" stroke="${u}" stroke-width="1.4" stroke-linecap="round"/>`});return p0(n,Za,546,m0(s,o,e.range,t.range,16,480,e.label,t.label)+a.join(""))}function p0(n,e,t,i){return`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${e} ${t}" width="${e}" height="${t}" role="img"><title>${g0(n)}</title><rect width="100%" height="100%" fill="#fff"/>${i}</svg>
`}function m0(n,e,t,i,r,s,o,a){let[l,c,u]=[n(t[0]),n(t[1]),r+s],h=[`<path d="M${l} ${r}V${u}H${c}" fill="none" stroke="${bn.quiet}" stroke-width="0.8"/>`];for(let f of xo(t[0],t[1],7)){let m=n(f).toFixed(1);h.push(`<path d="M${m} ${u}v4" stroke="${bn.quiet}" stroke-width="0.8"/>`,Ya(Number(m),u+17,St(f,6),"middle"))}for(let f of xo(i[0],i[1],Math.max(3,s/50))){let m=e(f);h.push(`<path d="M${l} ${m.toFixed(1)}h-4" stroke="${bn.quiet}" stroke-width="0.8"/>`,Ya(l-7,m+4,St(f,6),"end"))}o&&h.push(Ya((l+c)/2,u+36,o,"middle",!0));let d=r+s/2;return h.push(`<g transform="rotate(-90 16 ${d})">${Ya(16,d+4,a,"middle",!0)}</g>`),h.join("")}function Ya(n,e,t,i,r=!1){return`<text x="${n.toFixed(1)}" y="${e.toFixed(1)}" font-family="${LS.replaceAll('"',"'")}" font-size="${r?14:12.5}"${r?' font-style="italic"':""} text-anchor="${i}" fill="${bn.ink}">${g0(t)}</text>`}function FS(n,e,t,i){let r=[],s=!1;for(let o=0;o<n.length;o++){let a=e[o]??NaN;Number.isFinite(a)?(r.push(`${s?"L":"M"}${t(n[o]??0).toFixed(1)} ${i(a).toFixed(1)}`),s=!0):s=!1}return r.join("")}function g0(n){return n.replaceAll("&","&amp;").replaceAll("<","&lt;").replaceAll(">","&gt;").replaceAll('"',"&quot;")}var NS={body:["_1","_2","_3"],space:["_x","_y","_z"],quaternion:["_w","_x","_y","_z"]};function x0(n,e){let t=e.filter(({name:s})=>n.columns[s]!==void 0),i=["time (s)"];for(let{name:s,width:o,axes:a,unit:l}of t){let c=NS[a];for(let u=0;u<o;u++){let h=o===1?"":c?.[u]??`_${u+1}`;i.push(`${s}${h}${l==="1"?"":` (${l})`}`)}}let r=[i.map(_0).join(",")];return n.times.forEach((s,o)=>{let a=[String(s)];for(let{name:l,width:c}of t){let u=n.columns[l];for(let h=0;h<c;h++){let d=u?.[o*c+h]??NaN;a.push(Number.isFinite(d)?String(d):"")}}r.push(a.join(","))}),`${r.join(`
`)}
`}function y0(n,e){let t=[["orbit",...n].map(_0).join(",")];for(let{x:i,y:r,number:s}of e)i.forEach((o,a)=>t.push(`${s+1},${o},${r[a]??""}`));return`${t.join(`
`)}
`}function _0(n){return/[",\n]/.test(n)?`"${n.replaceAll('"','""')}"`:n}var BS=1280;function v0(n){let{lab:e,scene:t,plots:i,section:r,address:s}=n,{model:o}=e,a=o.name||"motion",l=se("div",{class:"lab-downloads"}),c=(h,d,f)=>{let m=se("button",{type:"button",class:"lab-button"},h);return m.addEventListener("click",()=>{Promise.resolve(f()).catch(b=>e.say(b instanceof Error?b.message:String(b),!0))}),l.append(se("div",{},m,se("span",{class:"lab-hint"},d))),m},u=(h,d,f="text/plain")=>Pa(h,new Blob([d],{type:`${f};charset=utf-8`}));return c("Copy the address","of this motion: parameters, start and instant are in it",async()=>{let h=s();await navigator.clipboard.writeText(h).then(()=>e.say("The address is on the clipboard."),()=>e.say(h))}),o.experiment!==""&&c("Experiment","a file that the program runs (TOML)",()=>u(`${a}.toml`,US(e))),c("Data","every sample of this motion (CSV)",()=>u(`${a}.csv`,x0(e.shown.value.motion,o.columns),"text/csv")),r!==null&&(c("Points of the section","as a table (CSV)",()=>{let{x:h,y:d}=r.setting();u(`${a}-section.csv`,y0([h,d],r.orbits()),"text/csv")}),c("Section","as a drawing (SVG)",()=>{let{x:h,y:d}=r.sheet.frame,f=r.orbits().map(m=>({...m,colour:bn.series[m.number%bn.series.length]??bn.ink}));u(`${a}-section.svg`,f0(o.title,h,d,f),"image/svg+xml")})),c("Plots","over time, as a drawing (SVG)",()=>{let h=i.chosen().map(d=>({...d,label:d.text,components:d.components.map(f=>({...f,label:si(f.label)}))}));u(`${a}-plots.svg`,d0(o.title,e.shown.value.motion.times,h),"image/svg+xml")}),t!==null&&DS(n,t,a,c),l}function DS({lab:n},e,t,i){let{stage:r}=e,s=()=>[e.element.clientWidth,e.element.clientHeight];i("Picture","of the scene now (PNG)",async()=>{let c=await r.sized(...s(),3,()=>r.picture(n.clock.time.value));e.refresh();let u=await new Promise(h=>c.toBlob(h,"image/png"));if(u===null)throw new Error("The browser could not write the picture.");Pa(`${t}.png`,u)});let o=!1,a=i("Film","of the whole motion at the chosen speed (MP4)",async()=>{if(o){o=!1;return}o=!0,n.clock.pause(),a.textContent="Stop the film";let[c,u]=s(),h=BS/Math.max(c,u),{until:d}=n.clock,f=d/n.clock.speed.value,[m,b]=[b0(c*h),b0(u*h)],g=n.clock.speed.value,p={width:m,height:b,duration:f,picture:T=>r.picture(Math.min(d,T*g)),progress:T=>n.say(`Film: ${Math.round(100*T)} of 100`),wanted:()=>o},_=await r.sized(m,b,1,()=>u0(p)).finally(()=>{o=!1,a.textContent="Film",e.refresh()});if("message"in _)return n.say(_.message,!0);Pa(`${t}.mp4`,_),n.say(`The film lasts ${f.toFixed(1)} s.`)}),{surface:l}=n.shown.value;l!==null&&i("Body in motion","for other 3D programs (glTF, GLB)",()=>{let{surface:c,motion:u}=n.shown.value;c!==null&&Pa(`${t}.glb`,new Blob([h0(n.model.title,c,u)],{type:"model/gltf-binary"}))})}function b0(n){return 2*Math.max(1,Math.round(n/2))}function US(n){let{model:e}=n,{experiment:t}=n.shown.value,i=r=>Object.entries(r).map(([s,o])=>({name:s,value:o}));return $m(e.experiment,i(t.parameters),i(Na(n)),t.until===e.until?null:t.until)}function OS(n,e){let t=new Float64Array(3*n.length*e.length),i=0;for(let r=0;r<n.length;r++)for(let s=0;s<e.length;s++){let o=Math.sin(n[r]);t[i++]=o*Math.cos(e[s]),t[i++]=o*Math.sin(e[s]),t[i++]=Math.cos(n[r])}return t}function w0(n,e){let{theta:t,phi:i,hollow:r}=n,s=t.length,o=i.length,a=OS(t,i),l=r?1:-1,c=s*o,u=c+2*(o+1),h=new Float32Array(3*u),d=new Float32Array(3*u);for(let p=0;p<3*c;p++)h[p]=e[p],d[p]=l*a[p];let f=[],m=[],b=(p,_,T,w)=>{kS(h,d,p,_,T)||([_,T]=[T,_]),f.push(p,_,T),m.push(w)},g=p=>Math.floor((i[p]+1e-9)/(Math.PI/2));for(let p=0;p+1<s;p++){let _=(t[p]+t[p+1])/2<Math.PI/2?1:0;for(let T=0;T<o;T++){let w=(T+1)%o,C=(g(T)+_)%2;b(p*o+T,p*o+w,(p+1)*o+w,C),b(p*o+T,(p+1)*o+w,(p+1)*o+T,C)}}for(let p of[!0,!1]){let _=(p?0:s-1)*o,T=c+(p?0:o+1),w=T+o,C=l*(p?1:-1);for(let E=0;E<o;E++){for(let x=0;x<3;x++){let M=h[3*(_+E)+x];h[3*(T+E)+x]=M,h[3*w+x]+=M/o}d[3*(T+E)+2]=C}d[3*w+2]=C;for(let E=0;E<o;E++)b(w,T+E,T+(E+1)%o,(g(E)+(p?1:0))%2)}return{positions:h,normals:d,indices:Uint32Array.from(f),tones:Uint8Array.from(m),hollow:r}}function kS(n,e,t,i,r){let s=[0,1,2].map(l=>n[3*i+l]-n[3*t+l]),o=[0,1,2].map(l=>n[3*r+l]-n[3*t+l]),a=0;for(let l=0;l<3;l++){let c=(l+1)%3,u=(l+2)%3,h=e[3*t+l]+e[3*i+l]+e[3*r+l];a+=(s[c]*o[u]-s[u]*o[c])*h}return a>=0}function zd(n){let e=atob(n),t=new Uint8Array(e.length);for(let i=0;i<e.length;i++)t[i]=e.charCodeAt(i);return t}function Vd(n){return new Float64Array(zd(n).buffer)}function Vs(n){return new Float32Array(zd(n).buffer)}function S0(n){return new Uint32Array(zd(n).buffer)}var Vi=class{constructor(e){this.current=e}current;watchers=new Set;get value(){return this.current}set value(e){if(!Object.is(e,this.current)){this.current=e;for(let t of[...this.watchers])t(e)}}watch(e){return e(this.current),this.after(e)}after(e){return this.watchers.add(e),()=>this.watchers.delete(e)}};function A0(n){let e=!1,t=null,i=async()=>{for(e=!0;t!==null;){let{argument:r,resolve:s,reject:o}=t;t=null;try{let a=await n(r);s(t===null?a:void 0)}catch(a){o(a)}}e=!1};return r=>new Promise((s,o)=>{t?.resolve(void 0),t={argument:r,resolve:s,reject:o},e||i()})}var Bo=[.02,.05,.1,.25,.5,1,2,5,10],Tc=class{time=new Vi(0);playing=new Vi(!1);speed=new Vi(1);end=1;frame=0;before=0;set until(e){this.end=e,this.time.value>e&&(this.time.value=e)}get until(){return this.end}play(){this.playing.value||(this.time.value>=this.end&&(this.time.value=0),this.playing.value=!0,this.before=0,this.frame=requestAnimationFrame(this.step))}pause(){this.playing.value&&(cancelAnimationFrame(this.frame),this.playing.value=!1)}toggle(){this.playing.value?this.pause():this.play()}seek(e){this.time.value=Math.min(Math.max(e,0),this.end)}changeSpeed(e){let t=Bo.findIndex(i=>i>=this.speed.value-1e-9);this.speed.value=Bo[Math.min(Math.max(t+e,0),Bo.length-1)]??1}step=e=>{if(!this.playing.value)return;let t=this.before===0?0:Math.min(.1,(e-this.before)/1e3);this.before=e;let i=this.time.value+t*this.speed.value;this.time.value=i>=this.end?0:i,this.frame=requestAnimationFrame(this.step)}};function M0(n){if(n>=4&&n<=90)return 1;let e=n<4?n/8:n/40;return Bo.reduce((t,i)=>Math.abs(Math.log(i/e))<Math.abs(Math.log(t/e))?i:t)}var Ec=class{constructor(e,t,i){this.model=e;this.engine=t;this.shown=new Vi(i),this.wanted=new Vi(i.experiment),this.compute=A0(r=>Rc(e,t,r)),this.clock.until=i.motion.times.at(-1)??0,this.clock.speed.value=M0(this.clock.until)}model;engine;clock=new Tc;shown;message=new Vi("");refused=new Vi(!1);history=new lc;wanted;compute;async change(e,t=!0){return ud(e,this.wanted.value)?!0:(t&&this.history.push(this.wanted.value),this.request(e))}mark(){this.history.push(this.wanted.value)}async undo(){let e=this.history.undo(this.wanted.value);e!==void 0&&await this.request(e)}async redo(){let e=this.history.redo(this.wanted.value);e!==void 0&&await this.request(e)}say(e,t=!1){this.refused.value=t,this.message.value=e}async request(e){this.wanted.value=e;let t;try{t=await this.compute(e)}catch(r){t=r instanceof Error?r.message:String(r)}if(t===void 0)return!1;if(typeof t=="string")return this.say(t,!0),!1;let i=t.motion.end;return this.say(i===null?"":`The motion ends at t = ${i.time.toPrecision(4)}: ${i.reason}.`,i!==null),this.clock.until=t.motion.times.at(-1)??0,this.shown.value=t,!0}};async function Rc(n,e,t){if(e===null)return n.recorded===null?"This page holds no motion and cannot compute one.":ud(t,Ns(n))?{experiment:t,motion:Hd(n),state:Float64Array.from(n.start),surface:Cc(n)}:"This page shows a recorded motion and cannot compute another.";let i=await zS(e,t);if("message"in i)return i.message;let{parameters:r,until:s}=t,[o,a]=await Promise.all([e.motion({parameters:r,start:i.state,times:cc(s,VS(n,s))}),e.bodyMesh(r)]);return{experiment:t,motion:o,state:i.state,surface:a??Cc(n)}}async function zS(n,e){let{start:t,parameters:i}=e;return"state"in t?{state:Float64Array.from(t.state)}:n.startFrom({parameters:i,inputs:t.inputs})}function VS(n,e){let t=Math.round((n.samples-1)*e/n.until)+1;return Math.min(20001,Math.max(601,n.samples,t))}function Hd(n){let e=n.recorded;if(e===null)return{times:new Float64Array(1),columns:{},end:null};let t=Object.fromEntries(Object.entries(e.columns).map(([i,r])=>[i,Vd(r)]));return{times:Vd(e.times),columns:t,end:e.end}}function Cc(n){let e=n.scene.body;return e===null?null:w0(e,Vs(e.positions))}var HS=[["proven","✓"],["refuted","✗"],["undecided","?"],["not tried","–"]];function T0(n,e){let{motion:t}=n.shown.value;return n.model.laws.map(({name:i,verdict:r,column:s})=>({name:i,verdict:r,value:s===null?null:mi(t,s,1,e)?.[0]??null,drift:s===null?null:E0(t,s)}))}function E0(n,e){let t=n.columns[e];if(t===void 0)return null;let i=t[0]??NaN,r=0;for(let s of t){let o=Math.abs(s-i);o>r&&(r=o)}return r}function GS({verdict:n,text:e}){let[t,i]=HS.find(([r])=>n.startsWith(r))??["undecided","?"];return se("span",{class:`lab-verdict lab-${t.replace(" ","-")}`,title:e},`${i} ${n}`)}function C0(n){let{laws:e,columns:t}=n.model;if(e.length===0)return null;let i=new Map(t.map(({name:o,unit:a})=>[o,Wn(a)])),r=e.map(o=>{let a=se("span",{class:"lab-number"}),l=se("span",{class:"lab-number"}),c=GS(o),u=o.column===null?null:se("p",{class:"lab-law-numbers"},se("span",{},"now ",a),se("span",{},"drift ",l)),h=se("li",{},se("p",{class:"lab-law-head"},se("strong",{},o.meaning||o.name),c,se("span",{class:"lab-source"},o.source)),se("div",{class:"lab-formula",tabindex:0,role:"group","aria-label":`Formula of ${o.meaning||o.name}`},rs(o.mathml)),u);return{law:o,value:a,away:l,made:h}}),s=()=>{for(let{law:o,value:a}of r){if(o.column===null)continue;let l=mi(n.shown.value.motion,o.column,1,n.clock.time.value)?.[0]??NaN;a.textContent=`${St(l,7)} ${i.get(o.column)??""}`}};return n.clock.time.after(s),n.shown.watch(({motion:o})=>{for(let{law:a,away:l}of r)a.column!==null&&(l.textContent=St(E0(o,a.column)??NaN,2));s()}),se("ul",{class:"lab-laws"},...r.map(({made:o})=>o))}function Ka(n,e,t,i){let r=0;for(let s=0;s+2<n.length;s+=3){let[o,a,l]=[n[s]??0,n[s+1]??0,n[s+2]??0],c=Math.hypot(o,a,l);c>0&&(r=Math.max(r,Math.acos(Math.min(1,Math.max(-1,e*l/c)))))}return r+t<i?r+t:Math.PI}function Ja(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i++){let r=n[i]??NaN,s=i%3;r<e[s]&&(e[s]=r),r>t[s]&&(t[s]=r)}return{low:e,high:t}}var R0=Math.PI/2-.02,Pc=30*Math.PI/180;function P0({azimuth:n,elevation:e}){let t=Math.cos(e);return[t*Math.cos(n),t*Math.sin(n),Math.sin(e)]}function I0(n){let e=P0(n);return n.target.map((t,i)=>t+n.distance*(e[i]??0))}function Ic(n,e,t){return{...n,azimuth:n.azimuth-Math.PI*e,elevation:Math.min(Math.max(n.elevation+Math.PI*t,-R0),R0)}}function ja(n,e){return{...n,distance:Math.min(Math.max(n.distance*e,.8),4e3)}}function Wd(n,e,t){let i=2*n.distance*Math.tan(Pc/2),{azimuth:r,elevation:s}=n,o=[-Math.sin(r),Math.cos(r),0],a=[-Math.sin(s)*Math.cos(r),-Math.sin(s)*Math.sin(r),Math.cos(s)];return{...n,target:n.target.map((l,c)=>l+i*(t*(a[c]??0)-e*(o[c]??0)))}}function Do(n,e,t,i){let s=P0({azimuth:e,elevation:t,distance:1,target:[0,0,0]}),o=[-Math.sin(e),Math.cos(e),0],a=[-Math.sin(t)*Math.cos(e),-Math.sin(t)*Math.sin(e),Math.cos(t)],l=Math.tan(Pc/2)*WS,c=l*i,u={x:0,y:0},h=1;for(let f=0;f<3;f++){let m={left:1/0,right:-1/0,low:1/0,high:-1/0},b=1;for(let g=0;g+2<n.length;g+=3){let p=[n[g]??0,n[g+1]??0,n[g+2]??0],[_,T,w]=[Gd(p,o)-u.x,Gd(p,a)-u.y,Gd(p,s)];b=Math.max(b,w+Math.max(Math.abs(_)/c,Math.abs(T)/l));let C=f===0?1:h/Math.max(1e-6,h-w);m.left=Math.min(m.left,_*C),m.right=Math.max(m.right,_*C),m.low=Math.min(m.low,T*C),m.high=Math.max(m.high,T*C)}if(h=b,f===2)break;u.x+=(m.left+m.right)/2,u.y+=(m.low+m.high)/2}let d=[0,1,2].map(f=>u.x*(o[f]??0)+u.y*(a[f]??0));return{azimuth:e,elevation:t,distance:h,target:d}}var WS=.92;function Gd(n,e){return n[0]*e[0]+n[1]*e[1]+n[2]*e[2]}function Lc(n){let e=Math.floor(n.length/3),[t,i]=[0,0];for(let h=0;h<e;h++)t+=(n[3*h]??0)/e,i+=(n[3*h+1]??0)/e;let[r,s,o]=[0,0,0];for(let h=0;h<e;h++){let[d,f]=[(n[3*h]??0)-t,(n[3*h+1]??0)-i];r+=d*d,s+=d*f,o+=f*f}if(!(r+o>0))return 0;let a=.5*Math.atan2(2*s,r-o),l=e-1,u=Math.cos(a)*((n[3*l]??0)-(n[0]??0))+Math.sin(a)*((n[3*l+1]??0)-(n[1]??0))<0?-1:1;return Math.atan2(-u*Math.cos(a),u*Math.sin(a))}var qS=10;function qd(n,e,t,i=1.6){let r=N0(n,e).map(c=>c/t),{support:s}=n,o=[...F0(L0(n,e,r,t)),...r];if(s?.kind==="sphere"){let c=Math.abs(s.radius)/t,{azimuth:u,elevation:h}=$S(r,s.inside),d=s.inside?Ka(r,-1,.3,1.75):Ka(r,1,Math.max(.12,.75/c),1.2);return Do([...o,...XS(c,s.inside,d)],u,h,i)}if(s?.kind==="mesh")return Do([...o,...Vs(s.positions).map(c=>c/t)],Lc(r)+.3,.5,i);if(s?.kind==="point"||s===null&&n.path===null)return Do(o,.6,.35,i);let a=Lc(r)+.42;if(!Xd(n,e))return Do(o,a,.5,i);let l=[...F0(L0(n,e,r,t).slice(0,3))].map((c,u)=>c+(u%3<2?1.1*Math.sign(c-(r[u%3]??0)):0));return Do(l,a,.5,i)}function L0(n,e,t,i){let r=as(e,"centre",3);return n.path!==null||r===0?t:(e.columns.centre??t).slice(0,3*r).map(s=>s/i)}function*F0(n){let e=n.length/3,t=Math.max(1,Math.floor(e/60));for(let i=0;i<e;i+=t)for(let r=0;r<8;r++)for(let s=0;s<3;s++)yield(n[3*i+s]??0)+(r>>s&1?.45:-.45)}function*XS(n,e,t){for(let i=1;i<=6;i++){let r=t*i/6;for(let s=0;s<24;s++){let o=Math.PI*s/12;yield n*Math.sin(r)*Math.cos(o),yield n*Math.sin(r)*Math.sin(o),yield(e?-1:1)*n*Math.cos(r)}}}function Xd(n,e){if(n.support?.kind!=="plane")return!1;let t=N0(n,e);if(t.length===0)return!1;let{low:i,high:r}=Ja(t);return Math.hypot(r[0]-i[0],r[1]-i[1])>qS*n.size}function $S(n,e){let t=[0,1,2].map(a=>{let l=0;for(let c=a;c<n.length;c+=3)l+=n[c]??0;return 3*l/Math.max(3,n.length)+.8*(n[n.length-3+a]??0)}),i=Math.hypot(...t)||1,r=Math.asin(Math.min(1,Math.max(-1,(t[2]??0)/i))),s=Math.hypot(t[0]??0,t[1]??0)<.35*i,o=s?Lc(n):Math.atan2(t[1]??0,t[0]??0)+.35;return e?{azimuth:o+(s?0:Math.PI),elevation:r<-.3?.62:.35}:{azimuth:o,elevation:Math.min(.6,Math.max(-.25,.6*r))}}function N0(n,e){if(n.path!==null)return Yd(n,e);let t=e.columns.contact?"contact":"centre",i=as(e,t,3),r=(e.columns[t]??new Float64Array(0)).slice(0,3*i);return r.length>0?r:new Float64Array(3)}function $d(n,e){if(n.length===0)return 3;let{low:t,high:i}=Ja(n);return 2.2+Math.hypot(i[0]-t[0],i[1]-t[1])/e}function Yd(n,e){let t=n.path??"",i=as(e,t,2),r=e.columns[t],s=new Float64Array(3*i);for(let o=0;o<i;o++)s.set([r?.[2*o]??0,r?.[2*o+1]??0,0],3*o);return s}function B0(n,e,t){let i=new Map,r=()=>{let[o,a]=[...i.values()];return o&&a?Math.hypot(o.x-a.x,o.y-a.y):0};n.addEventListener("pointerdown",o=>{i.set(o.pointerId,{x:o.clientX,y:o.clientY}),n.setPointerCapture(o.pointerId)}),n.addEventListener("pointermove",o=>{let a=i.get(o.pointerId);if(a===void 0)return;let l=n.clientHeight||1,c=(o.clientX-a.x)/l,u=(o.clientY-a.y)/l;if(i.size===2){let d=r();i.set(o.pointerId,{x:o.clientX,y:o.clientY});let f=r();d>0&&f>0&&(e.view=ja(e.view,d/f)),e.view=Wd(e.view,c/2,u/2),t(!0);return}i.set(o.pointerId,{x:o.clientX,y:o.clientY});let h=o.shiftKey||o.buttons===2||o.buttons===4;e.view=h?Wd(e.view,c,u):Ic(e.view,c,u),t(h)});let s=o=>{i.delete(o.pointerId)};n.addEventListener("pointerup",s),n.addEventListener("pointercancel",s),n.addEventListener("contextmenu",o=>o.preventDefault()),n.addEventListener("wheel",o=>{!n.matches(":focus-within")&&!o.ctrlKey||(o.preventDefault(),e.view=ja(e.view,Math.exp(.0015*o.deltaY)),t(!1))},{passive:!1})}var ox=0,Mf=1,ax=2;var Xs=1,lx=2,sa=3,ci=0,fn=1,Fi=2,$s=0,oa=1,Tf=2,Ef=3,Cf=4,cx=5;var Ys=100,ux=101,hx=102,dx=103,fx=104,px=200,mx=201,gx=202,xx=203,Rf=204,Pf=205,yx=206,_x=207,bx=208,vx=209,wx=210,Sx=211,Ax=212,Mx=213,Tx=214,tu=0,nu=1,iu=2,Jo=3,ru=4,su=5,ou=6,au=7,El=0,Ex=1,Cx=2,Sr=0,If=1,Lf=2,Ff=3,Nf=4,Bf=5,Df=6,Uf=7;var Of=300,Zs=301,aa=302,Fu=303,Nu=304,lu=1e3,_r=1001,cu=1002,On=1003,Rx=1004;var Cl=1005;var ii=1006,Bu=1007;var $r=1008;var ui=1009,kf=1010,zf=1011,la=1012,Du=1013,Xi=1014,$i=1015,Yi=1016,Uu=1017,Ou=1018,Ks=1020,Vf=35902,Hf=35899,Gf=1021,Wf=1022,Zi=1023,Vr=1026,Yr=1027,qf=1028,ku=1029,Ms=1030,zu=1031;var Vu=1033,Rl=33776,Pl=33777,Il=33778,Ll=33779,Hu=35840,Gu=35841,Wu=35842,qu=35843,Xu=36196,$u=37492,Yu=37496,Zu=37488,Ku=37489,Fl=37490,Ju=37491,ju=37808,Qu=37809,eh=37810,th=37811,nh=37812,ih=37813,rh=37814,sh=37815,oh=37816,ah=37817,lh=37818,ch=37819,uh=37820,hh=37821,dh=36492,fh=36494,ph=36495,mh=36283,gh=36284,Nl=36285,xh=36286;var rl=2300,uu=2301,Qc=2302,yf=2303,_f=2400,bf=2401,vf=2402;var Px=3200;var Bl=0,Ix=1,Zr="",_i="srgb",sl="srgb-linear",ol="linear",Lt="srgb";var eu=7680;var Lx=519,Fx=512,Nx=513,Bx=514,Xf=515,Dx=516,Ux=517,$f=518,Yf=519,Zf=35044;var Kf="300 es",Ii=2e3,jo=2001;function YS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function ZS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function al(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Ox(){let n=al("canvas");return n.style.display="block",n}var D0={},Qo=null;function ll(...n){let e="THREE."+n.shift();Qo?Qo("log",e,...n):console.log(e,...n)}function kx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function et(...n){n=kx(n);let e="THREE."+n.shift();if(Qo)Qo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function rt(...n){n=kx(n);let e="THREE."+n.shift();if(Qo)Qo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function il(...n){let e=n.join(" ");e in D0||(D0[e]=!0,et(...n))}function zx(n,e,t){return new Promise(function(i,r){function s(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:r();break;case n.TIMEOUT_EXPIRED:setTimeout(s,t);break;default:i()}}setTimeout(s,t)})}var Vx={[tu]:tu,[iu]:ou,[ru]:ru,[Jo]:su,[nu]:nu,[ou]:iu,[au]:au,[su]:Jo},br=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let r=i[e];if(r!==void 0){let s=r.indexOf(t);s!==-1&&r.splice(s,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let r=i.slice(0);for(let s=0,o=r.length;s<o;s++)r[s].call(this,e);e.target=null}}},qn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Zd=Math.PI/180,hu=180/Math.PI;function Js(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(qn[n&255]+qn[n>>8&255]+qn[n>>16&255]+qn[n>>24&255]+"-"+qn[e&255]+qn[e>>8&255]+"-"+qn[e>>16&15|64]+qn[e>>24&255]+"-"+qn[t&63|128]+qn[t>>8&255]+"-"+qn[t>>16&255]+qn[t>>24&255]+qn[i&255]+qn[i>>8&255]+qn[i>>16&255]+qn[i>>24&255]).toLowerCase()}function Mt(n,e,t){return Math.max(e,Math.min(t,n))}function KS(n,e){return(n%e+e)%e}function Kd(n,e,t){return(1-t)*n+t*e}function Hx(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function yh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Gx(n,e){if(e.constructor===Float32Array)return n;let t=yh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Wx(n,e){if(e.constructor===Float32Array)return n;let t=yh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var dt=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6],this.y=r[1]*t+r[4]*i+r[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),r=Math.sin(t),s=this.x-e.x,o=this.y-e.y;return this.x=s*i-o*r+e.x,this.y=s*r+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Li=class{constructor(e=0,t=0,i=0,r=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=r}static slerpFlat(e,t,i,r,s,o,a){let l=i[r+0],c=i[r+1],u=i[r+2],h=i[r+3],d=s[o+0],f=s[o+1],m=s[o+2],b=s[o+3];if(h!==b||l!==d||c!==f||u!==m){let g=l*d+c*f+u*m+h*b;g<0&&(d=-d,f=-f,m=-m,b=-b,g=-g);let p=1-a;if(g<.9995){let _=Math.acos(g),T=Math.sin(_);p=Math.sin(p*_)/T,a=Math.sin(a*_)/T,l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+b*a}else{l=l*p+d*a,c=c*p+f*a,u=u*p+m*a,h=h*p+b*a;let _=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=_,c*=_,u*=_,h*=_}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=h}static multiplyQuaternionsFlat(e,t,i,r,s,o){let a=i[r],l=i[r+1],c=i[r+2],u=i[r+3],h=s[o],d=s[o+1],f=s[o+2],m=s[o+3];return e[t]=a*m+u*h+l*f-c*d,e[t+1]=l*m+u*d+c*h-a*f,e[t+2]=c*m+u*f+a*d-l*h,e[t+3]=u*m-a*h-l*d-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,r){return this._x=e,this._y=t,this._z=i,this._w=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,r=e._y,s=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(r/2),h=a(s/2),d=l(i/2),f=l(r/2),m=l(s/2);switch(o){case"XYZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"YXZ":this._x=d*u*h+c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"ZXY":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h-d*f*m;break;case"ZYX":this._x=d*u*h-c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h+d*f*m;break;case"YZX":this._x=d*u*h+c*f*m,this._y=c*f*h+d*u*m,this._z=c*u*m-d*f*h,this._w=c*u*h-d*f*m;break;case"XZY":this._x=d*u*h-c*f*m,this._y=c*f*h-d*u*m,this._z=c*u*m+d*f*h,this._w=c*u*h+d*f*m;break;default:et("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,r=Math.sin(i);return this._x=e.x*r,this._y=e.y*r,this._z=e.z*r,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],r=t[4],s=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],h=t[10],d=i+a+h;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(u-l)*f,this._y=(s-c)*f,this._z=(o-r)*f}else if(i>a&&i>h){let f=2*Math.sqrt(1+i-a-h);this._w=(u-l)/f,this._x=.25*f,this._y=(r+o)/f,this._z=(s+c)/f}else if(a>h){let f=2*Math.sqrt(1+a-i-h);this._w=(s-c)/f,this._x=(r+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+h-i-a);this._w=(o-r)/f,this._x=(s+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(Mt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let r=Math.min(1,t/i);return this.slerp(e,r),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+r*c-s*l,this._y=r*u+o*l+s*a-i*c,this._z=s*u+o*c+i*l-r*a,this._w=o*u-i*a-r*l-s*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,r=e._y,s=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,r=-r,s=-s,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+r*t,this._z=this._z*l+s*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),r=Math.sqrt(1-i),s=Math.sqrt(i);return this.set(r*Math.sin(e),r*Math.cos(e),s*Math.sin(t),s*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},Y=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(U0.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(U0.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6]*r,this.y=s[1]*t+s[4]*i+s[7]*r,this.z=s[2]*t+s[5]*i+s[8]*r,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=e.elements,o=1/(s[3]*t+s[7]*i+s[11]*r+s[15]);return this.x=(s[0]*t+s[4]*i+s[8]*r+s[12])*o,this.y=(s[1]*t+s[5]*i+s[9]*r+s[13])*o,this.z=(s[2]*t+s[6]*i+s[10]*r+s[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,r=this.z,s=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*r-a*i),u=2*(a*t-s*r),h=2*(s*i-o*t);return this.x=t+l*c+o*h-a*u,this.y=i+l*u+a*c-s*h,this.z=r+l*h+s*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,r=this.z,s=e.elements;return this.x=s[0]*t+s[4]*i+s[8]*r,this.y=s[1]*t+s[5]*i+s[9]*r,this.z=s[2]*t+s[6]*i+s[10]*r,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,r=e.y,s=e.z,o=t.x,a=t.y,l=t.z;return this.x=r*l-s*a,this.y=s*o-i*l,this.z=i*a-r*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Jd.copy(this).projectOnVector(e),this.sub(Jd)}reflect(e){return this.sub(Jd.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(Mt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,r=this.z-e.z;return t*t+i*i+r*r}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let r=Math.sin(t)*e;return this.x=r*Math.sin(i),this.y=Math.cos(t)*e,this.z=r*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),r=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=r,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Jd=new Y,U0=new Li,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,r,s,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c)}set(e,t,i,r,s,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=r,u[2]=a,u[3]=t,u[4]=s,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],h=i[7],d=i[2],f=i[5],m=i[8],b=r[0],g=r[3],p=r[6],_=r[1],T=r[4],w=r[7],C=r[2],E=r[5],x=r[8];return s[0]=o*b+a*_+l*C,s[3]=o*g+a*T+l*E,s[6]=o*p+a*w+l*x,s[1]=c*b+u*_+h*C,s[4]=c*g+u*T+h*E,s[7]=c*p+u*w+h*x,s[2]=d*b+f*_+m*C,s[5]=d*g+f*T+m*E,s[8]=d*p+f*w+m*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*s*u+i*a*l+r*s*c-r*o*l}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=u*o-a*c,d=a*l-u*s,f=c*s-o*l,m=t*h+i*d+r*f;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/m;return e[0]=h*b,e[1]=(r*c-u*i)*b,e[2]=(a*i-r*o)*b,e[3]=d*b,e[4]=(u*t-r*l)*b,e[5]=(r*s-a*t)*b,e[6]=f*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*s)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,r,s,o,a){let l=Math.cos(s),c=Math.sin(s);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-r*c,r*l,-r*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return il("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(jd.makeScale(e,t)),this}rotate(e){return il("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(jd.makeRotation(-e)),this}translate(e,t){return il("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(jd.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<9;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},jd=new st,O0=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),k0=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function JS(){let n={enabled:!0,workingColorSpace:sl,spaces:{},convert:function(r,s,o){return this.enabled===!1||s===o||!s||!o||(this.spaces[s].transfer===Lt&&(r.r=zr(r.r),r.g=zr(r.g),r.b=zr(r.b)),this.spaces[s].primaries!==this.spaces[o].primaries&&(r.applyMatrix3(this.spaces[s].toXYZ),r.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Lt&&(r.r=Ko(r.r),r.g=Ko(r.g),r.b=Ko(r.b))),r},workingToColorSpace:function(r,s){return this.convert(r,this.workingColorSpace,s)},colorSpaceToWorking:function(r,s){return this.convert(r,s,this.workingColorSpace)},getPrimaries:function(r){return this.spaces[r].primaries},getTransfer:function(r){return r===Zr?ol:this.spaces[r].transfer},getToneMappingMode:function(r){return this.spaces[r].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(r,s=this.workingColorSpace){return r.fromArray(this.spaces[s].luminanceCoefficients)},define:function(r){Object.assign(this.spaces,r)},_getMatrix:function(r,s,o){return r.copy(this.spaces[o].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(r){return this.spaces[r].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(r=this.workingColorSpace){return this.spaces[r].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[sl]:{primaries:e,whitePoint:i,transfer:ol,toXYZ:O0,fromXYZ:k0,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:_i},outputColorSpaceConfig:{drawingBufferColorSpace:_i}},[_i]:{primaries:e,whitePoint:i,transfer:Lt,toXYZ:O0,fromXYZ:k0,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:_i}}}),n}var vt=JS();function zr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Ko(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Uo,du=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Uo===void 0&&(Uo=al("canvas")),Uo.width=e.width,Uo.height=e.height;let r=Uo.getContext("2d");e instanceof ImageData?r.putImageData(e,0,0):r.drawImage(e,0,0,e.width,e.height),i=Uo}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=al("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let r=i.getImageData(0,0,e.width,e.height),s=r.data;for(let o=0;o<s.length;o++)s[o]=zr(s[o]/255)*255;return i.putImageData(r,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(zr(t[i]/255)*255):t[i]=zr(t[i]);return{data:t,width:e.width,height:e.height}}else return et("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},jS=0,ea=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:jS++}),this.uuid=Js(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},r=this.data;if(r!==null){let s;if(Array.isArray(r)){s=[];for(let o=0,a=r.length;o<a;o++)r[o].isDataTexture?s.push(Qd(r[o].image)):s.push(Qd(r[o]))}else s=Qd(r);i.url=s}return t||(e.images[this.uuid]=i),i}};function Qd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?du.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(et("Texture: Unable to serialize Texture."),{})}var QS=0,ef=new Y,ai=class n extends br{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=_r,r=_r,s=ii,o=$r,a=Zi,l=ui,c=n.DEFAULT_ANISOTROPY,u=Zr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:QS++}),this.uuid=Js(),this.name="",this.source=new ea(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=r,this.magFilter=s,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new dt(0,0),this.repeat=new dt(1,1),this.center=new dt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ef).x}get height(){return this.source.getSize(ef).y}get depth(){return this.source.getSize(ef).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){et(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Texture.setValues(): property '${t}' does not exist.`);continue}r&&i&&r.isVector2&&i.isVector2||r&&i&&r.isVector3&&i.isVector3||r&&i&&r.isMatrix3&&i.isMatrix3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Of)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case lu:e.x=e.x-Math.floor(e.x);break;case _r:e.x=e.x<0?0:1;break;case cu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case lu:e.y=e.y-Math.floor(e.y);break;case _r:e.y=e.y<0?0:1;break;case cu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};ai.DEFAULT_IMAGE=null;ai.DEFAULT_MAPPING=Of;ai.DEFAULT_ANISOTROPY=1;var tn=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,r=1){this.x=e,this.y=t,this.z=i,this.w=r}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,r){return this.x=e,this.y=t,this.z=i,this.w=r,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,r=this.z,s=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*r+o[12]*s,this.y=o[1]*t+o[5]*i+o[9]*r+o[13]*s,this.z=o[2]*t+o[6]*i+o[10]*r+o[14]*s,this.w=o[3]*t+o[7]*i+o[11]*r+o[15]*s,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,r,s,l=e.elements,c=l[0],u=l[4],h=l[8],d=l[1],f=l[5],m=l[9],b=l[2],g=l[6],p=l[10];if(Math.abs(u-d)<.01&&Math.abs(h-b)<.01&&Math.abs(m-g)<.01){if(Math.abs(u+d)<.1&&Math.abs(h+b)<.1&&Math.abs(m+g)<.1&&Math.abs(c+f+p-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let T=(c+1)/2,w=(f+1)/2,C=(p+1)/2,E=(u+d)/4,x=(h+b)/4,M=(m+g)/4;return T>w&&T>C?T<.01?(i=0,r=.707106781,s=.707106781):(i=Math.sqrt(T),r=E/i,s=x/i):w>C?w<.01?(i=.707106781,r=0,s=.707106781):(r=Math.sqrt(w),i=E/r,s=M/r):C<.01?(i=.707106781,r=.707106781,s=0):(s=Math.sqrt(C),i=x/s,r=M/s),this.set(i,r,s,t),this}let _=Math.sqrt((g-m)*(g-m)+(h-b)*(h-b)+(d-u)*(d-u));return Math.abs(_)<.001&&(_=1),this.x=(g-m)/_,this.y=(h-b)/_,this.z=(d-u)/_,this.w=Math.acos((c+f+p-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=Mt(this.x,e.x,t.x),this.y=Mt(this.y,e.y,t.y),this.z=Mt(this.z,e.z,t.z),this.w=Mt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=Mt(this.x,e,t),this.y=Mt(this.y,e,t),this.z=Mt(this.z,e,t),this.w=Mt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Mt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},fu=class extends br{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ii,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new tn(0,0,e,t),this.scissorTest=!1,this.viewport=new tn(0,0,e,t),this.textures=[];let r=i.count;for(let s=0;s<r;s++)this.textures[s]=new ai({width:e,height:t,depth:i.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ii,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let r=0,s=this.textures.length;r<s;r++)this.textures[r].image.width=e,this.textures[r].image.height=t,this.textures[r].image.depth=i,this.textures[r].isData3DTexture!==!0&&(this.textures[r].isArrayTexture=this.textures[r].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let r=Object.assign({},e.textures[t].image);this.textures[t].source=new ea(r)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bi=class extends fu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},cl=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=On,this.minFilter=On,this.wrapR=_r,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var pu=class extends ai{constructor(e=null,t=1,i=1,r=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:r},this.magFilter=On,this.minFilter=On,this.wrapR=_r,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var en=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,r,s,o,a,l,c,u,h,d,f,m,b,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,r,s,o,a,l,c,u,h,d,f,m,b,g)}set(e,t,i,r,s,o,a,l,c,u,h,d,f,m,b,g){let p=this.elements;return p[0]=e,p[4]=t,p[8]=i,p[12]=r,p[1]=s,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=d,p[3]=f,p[7]=m,p[11]=b,p[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,r=1/Oo.setFromMatrixColumn(e,0).length(),s=1/Oo.setFromMatrixColumn(e,1).length(),o=1/Oo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*r,t[1]=i[1]*r,t[2]=i[2]*r,t[3]=0,t[4]=i[4]*s,t[5]=i[5]*s,t[6]=i[6]*s,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,r=e.y,s=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(r),c=Math.sin(r),u=Math.cos(s),h=Math.sin(s);if(e.order==="XYZ"){let d=o*u,f=o*h,m=a*u,b=a*h;t[0]=l*u,t[4]=-l*h,t[8]=c,t[1]=f+m*c,t[5]=d-b*c,t[9]=-a*l,t[2]=b-d*c,t[6]=m+f*c,t[10]=o*l}else if(e.order==="YXZ"){let d=l*u,f=l*h,m=c*u,b=c*h;t[0]=d+b*a,t[4]=m*a-f,t[8]=o*c,t[1]=o*h,t[5]=o*u,t[9]=-a,t[2]=f*a-m,t[6]=b+d*a,t[10]=o*l}else if(e.order==="ZXY"){let d=l*u,f=l*h,m=c*u,b=c*h;t[0]=d-b*a,t[4]=-o*h,t[8]=m+f*a,t[1]=f+m*a,t[5]=o*u,t[9]=b-d*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let d=o*u,f=o*h,m=a*u,b=a*h;t[0]=l*u,t[4]=m*c-f,t[8]=d*c+b,t[1]=l*h,t[5]=b*c+d,t[9]=f*c-m,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let d=o*l,f=o*c,m=a*l,b=a*c;t[0]=l*u,t[4]=b-d*h,t[8]=m*h+f,t[1]=h,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*h+m,t[10]=d-b*h}else if(e.order==="XZY"){let d=o*l,f=o*c,m=a*l,b=a*c;t[0]=l*u,t[4]=-h,t[8]=c*u,t[1]=d*h+b,t[5]=o*u,t[9]=f*h-m,t[2]=m*h-f,t[6]=a*u,t[10]=b*h+d}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(eA,e,tA)}lookAt(e,t,i){let r=this.elements;return xi.subVectors(e,t),xi.lengthSq()===0&&(xi.z=1),xi.normalize(),ds.crossVectors(i,xi),ds.lengthSq()===0&&(Math.abs(i.z)===1?xi.x+=1e-4:xi.z+=1e-4,xi.normalize(),ds.crossVectors(i,xi)),ds.normalize(),Fc.crossVectors(xi,ds),r[0]=ds.x,r[4]=Fc.x,r[8]=xi.x,r[1]=ds.y,r[5]=Fc.y,r[9]=xi.y,r[2]=ds.z,r[6]=Fc.z,r[10]=xi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,r=t.elements,s=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],h=i[5],d=i[9],f=i[13],m=i[2],b=i[6],g=i[10],p=i[14],_=i[3],T=i[7],w=i[11],C=i[15],E=r[0],x=r[4],M=r[8],O=r[12],N=r[1],I=r[5],U=r[9],H=r[13],L=r[2],V=r[6],W=r[10],z=r[14],ae=r[3],X=r[7],J=r[11],ee=r[15];return s[0]=o*E+a*N+l*L+c*ae,s[4]=o*x+a*I+l*V+c*X,s[8]=o*M+a*U+l*W+c*J,s[12]=o*O+a*H+l*z+c*ee,s[1]=u*E+h*N+d*L+f*ae,s[5]=u*x+h*I+d*V+f*X,s[9]=u*M+h*U+d*W+f*J,s[13]=u*O+h*H+d*z+f*ee,s[2]=m*E+b*N+g*L+p*ae,s[6]=m*x+b*I+g*V+p*X,s[10]=m*M+b*U+g*W+p*J,s[14]=m*O+b*H+g*z+p*ee,s[3]=_*E+T*N+w*L+C*ae,s[7]=_*x+T*I+w*V+C*X,s[11]=_*M+T*U+w*W+C*J,s[15]=_*O+T*H+w*z+C*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],h=e[6],d=e[10],f=e[14],m=e[3],b=e[7],g=e[11],p=e[15],_=l*f-c*d,T=a*f-c*h,w=a*d-l*h,C=o*f-c*u,E=o*d-l*u,x=o*h-a*u;return t*(b*_-g*T+p*w)-i*(m*_-g*C+p*E)+r*(m*T-b*C+p*x)-s*(m*w-b*E+g*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],r=e[8],s=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(s*u-a*l)+r*(s*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let r=this.elements;return e.isVector3?(r[12]=e.x,r[13]=e.y,r[14]=e.z):(r[12]=e,r[13]=t,r[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],r=e[2],s=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],h=e[9],d=e[10],f=e[11],m=e[12],b=e[13],g=e[14],p=e[15],_=t*a-i*o,T=t*l-r*o,w=t*c-s*o,C=i*l-r*a,E=i*c-s*a,x=r*c-s*l,M=u*b-h*m,O=u*g-d*m,N=u*p-f*m,I=h*g-d*b,U=h*p-f*b,H=d*p-f*g,L=_*H-T*U+w*I+C*N-E*O+x*M;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/L;return e[0]=(a*H-l*U+c*I)*V,e[1]=(r*U-i*H-s*I)*V,e[2]=(b*x-g*E+p*C)*V,e[3]=(d*E-h*x-f*C)*V,e[4]=(l*N-o*H-c*O)*V,e[5]=(t*H-r*N+s*O)*V,e[6]=(g*w-m*x-p*T)*V,e[7]=(u*x-d*w+f*T)*V,e[8]=(o*U-a*N+c*M)*V,e[9]=(i*N-t*U-s*M)*V,e[10]=(m*E-b*w+p*_)*V,e[11]=(h*w-u*E-f*_)*V,e[12]=(a*O-o*I-l*M)*V,e[13]=(t*I-i*O+r*M)*V,e[14]=(b*T-m*C-g*_)*V,e[15]=(u*C-h*T+d*_)*V,this}scale(e){let t=this.elements,i=e.x,r=e.y,s=e.z;return t[0]*=i,t[4]*=r,t[8]*=s,t[1]*=i,t[5]*=r,t[9]*=s,t[2]*=i,t[6]*=r,t[10]*=s,t[3]*=i,t[7]*=r,t[11]*=s,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],r=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,r))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),r=Math.sin(t),s=1-i,o=e.x,a=e.y,l=e.z,c=s*o,u=s*a;return this.set(c*o+i,c*a-r*l,c*l+r*a,0,c*a+r*l,u*a+i,u*l-r*o,0,c*l-r*a,u*l+r*o,s*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,r,s,o){return this.set(1,i,s,0,e,1,o,0,t,r,1,0,0,0,0,1),this}compose(e,t,i){let r=this.elements,s=t._x,o=t._y,a=t._z,l=t._w,c=s+s,u=o+o,h=a+a,d=s*c,f=s*u,m=s*h,b=o*u,g=o*h,p=a*h,_=l*c,T=l*u,w=l*h,C=i.x,E=i.y,x=i.z;return r[0]=(1-(b+p))*C,r[1]=(f+w)*C,r[2]=(m-T)*C,r[3]=0,r[4]=(f-w)*E,r[5]=(1-(d+p))*E,r[6]=(g+_)*E,r[7]=0,r[8]=(m+T)*x,r[9]=(g-_)*x,r[10]=(1-(d+b))*x,r[11]=0,r[12]=e.x,r[13]=e.y,r[14]=e.z,r[15]=1,this}decompose(e,t,i){let r=this.elements;e.x=r[12],e.y=r[13],e.z=r[14];let s=this.determinantAffine();if(s===0)return i.set(1,1,1),t.identity(),this;let o=Oo.set(r[0],r[1],r[2]).length(),a=Oo.set(r[4],r[5],r[6]).length(),l=Oo.set(r[8],r[9],r[10]).length();s<0&&(o=-o),Hi.copy(this);let c=1/o,u=1/a,h=1/l;return Hi.elements[0]*=c,Hi.elements[1]*=c,Hi.elements[2]*=c,Hi.elements[4]*=u,Hi.elements[5]*=u,Hi.elements[6]*=u,Hi.elements[8]*=h,Hi.elements[9]*=h,Hi.elements[10]*=h,t.setFromRotationMatrix(Hi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,r,s,o,a=Ii,l=!1){let c=this.elements,u=2*s/(t-e),h=2*s/(i-r),d=(t+e)/(t-e),f=(i+r)/(i-r),m,b;if(l)m=s/(o-s),b=o*s/(o-s);else if(a===Ii)m=-(o+s)/(o-s),b=-2*o*s/(o-s);else if(a===jo)m=-o/(o-s),b=-o*s/(o-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=h,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=m,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,r,s,o,a=Ii,l=!1){let c=this.elements,u=2/(t-e),h=2/(i-r),d=-(t+e)/(t-e),f=-(i+r)/(i-r),m,b;if(l)m=1/(o-s),b=o/(o-s);else if(a===Ii)m=-2/(o-s),b=-(o+s)/(o-s);else if(a===jo)m=-1/(o-s),b=-s/(o-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=h,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=m,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let r=0;r<16;r++)if(t[r]!==i[r])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Oo=new Y,Hi=new en,eA=new Y(0,0,0),tA=new Y(1,1,1),ds=new Y,Fc=new Y,xi=new Y,z0=new en,V0=new Li,vr=class n{constructor(e=0,t=0,i=0,r=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=r}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,r=this._order){return this._x=e,this._y=t,this._z=i,this._order=r,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let r=e.elements,s=r[0],o=r[4],a=r[8],l=r[1],c=r[5],u=r[9],h=r[2],d=r[6],f=r[10];switch(t){case"XYZ":this._y=Math.asin(Mt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,s)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Mt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,s),this._z=0);break;case"ZXY":this._x=Math.asin(Mt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-h,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,s));break;case"ZYX":this._y=Math.asin(-Mt(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(l,s)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Mt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,s)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Mt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,s)):(this._x=Math.atan2(-u,f),this._y=0);break;default:et("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return z0.makeRotationFromQuaternion(e),this.setFromRotationMatrix(z0,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return V0.setFromEuler(this),this.setFromQuaternion(V0,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};vr.DEFAULT_ORDER="XYZ";var ul=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},nA=0,H0=new Y,ko=new Li,Br=new en,Nc=new Y,Qa=new Y,iA=new Y,rA=new Li,G0=new Y(1,0,0),W0=new Y(0,1,0),q0=new Y(0,0,1),X0={type:"added"},sA={type:"removed"},zo={type:"childadded",child:null},tf={type:"childremoved",child:null},$n=class n extends br{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:nA++}),this.uuid=Js(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new Y,t=new vr,i=new Li,r=new Y(1,1,1);function s(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(s),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:r},modelViewMatrix:{value:new en},normalMatrix:{value:new st}}),this.matrix=new en,this.matrixWorld=new en,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ul,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ko.setFromAxisAngle(e,t),this.quaternion.multiply(ko),this}rotateOnWorldAxis(e,t){return ko.setFromAxisAngle(e,t),this.quaternion.premultiply(ko),this}rotateX(e){return this.rotateOnAxis(G0,e)}rotateY(e){return this.rotateOnAxis(W0,e)}rotateZ(e){return this.rotateOnAxis(q0,e)}translateOnAxis(e,t){return H0.copy(e).applyQuaternion(this.quaternion),this.position.add(H0.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(G0,e)}translateY(e){return this.translateOnAxis(W0,e)}translateZ(e){return this.translateOnAxis(q0,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Br.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Nc.copy(e):Nc.set(e,t,i);let r=this.parent;this.updateWorldMatrix(!0,!1),Qa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Br.lookAt(Qa,Nc,this.up):Br.lookAt(Nc,Qa,this.up),this.quaternion.setFromRotationMatrix(Br),r&&(Br.extractRotation(r.matrixWorld),ko.setFromRotationMatrix(Br),this.quaternion.premultiply(ko.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(rt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(X0),zo.child=e,this.dispatchEvent(zo),zo.child=null):rt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(sA),tf.child=e,this.dispatchEvent(tf),tf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Br.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Br.multiply(e.parent.matrixWorld)),e.applyMatrix4(Br),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(X0),zo.child=e,this.dispatchEvent(zo),zo.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,r=this.children.length;i<r;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let r=this.children;for(let s=0,o=r.length;s<o;s++)r[s].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qa,e,iA),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Qa,rA,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,r=e.z,s=this.matrix.elements;s[12]+=t-s[0]*t-s[4]*i-s[8]*r,s[13]+=i-s[1]*t-s[5]*i-s[9]*r,s[14]+=r-s[2]*t-s[6]*i-s[10]*r}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,r=t.length;i<r;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let r=this.parent;if(e===!0&&r!==null&&r.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let s=this.children;for(let o=0,a=s.length;o<a;o++)s[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let r={};r.uuid=this.uuid,r.type=this.type,r.name=this.name,r.castShadow=this.castShadow,r.receiveShadow=this.receiveShadow,r.visible=this.visible,r.frustumCulled=this.frustumCulled,r.renderOrder=this.renderOrder,r.static=this.static,r.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(r.userData=this.userData),r.layers=this.layers.mask,r.matrix=this.matrix.toArray(),r.up=this.up.toArray(),this.pivot!==null&&(r.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(r.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(r.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(r.type="InstancedMesh",r.count=this.count,r.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(r.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(r.type="BatchedMesh",r.perObjectFrustumCulled=this.perObjectFrustumCulled,r.sortObjects=this.sortObjects,r.drawRanges=this._drawRanges,r.reservedRanges=this._reservedRanges,r.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),r.instanceInfo=this._instanceInfo.map(a=>({...a})),r.availableInstanceIds=this._availableInstanceIds.slice(),r.availableGeometryIds=this._availableGeometryIds.slice(),r.nextIndexStart=this._nextIndexStart,r.nextVertexStart=this._nextVertexStart,r.geometryCount=this._geometryCount,r.maxInstanceCount=this._maxInstanceCount,r.maxVertexCount=this._maxVertexCount,r.maxIndexCount=this._maxIndexCount,r.geometryInitialized=this._geometryInitialized,r.matricesTexture=this._matricesTexture.toJSON(e),r.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(r.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(r.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(r.boundingBox=this.boundingBox.toJSON()));function s(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?r.background=this.background.toJSON():this.background.isTexture&&(r.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(r.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){r.geometry=s(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let h=l[c];s(e.shapes,h)}else s(e.shapes,l)}}if(this.isSkinnedMesh&&(r.bindMode=this.bindMode,r.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(e.skeletons,this.skeleton),r.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(s(e.materials,this.material[l]));r.material=a}else r.material=s(e.materials,this.material);if(this.children.length>0){r.children=[];for(let a=0;a<this.children.length;a++)r.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){r.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];r.animations.push(s(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),h=o(e.shapes),d=o(e.skeletons),f=o(e.animations),m=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),h.length>0&&(i.shapes=h),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),m.length>0&&(i.nodes=m)}return i.object=r,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let r=e.children[i];this.add(r.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$n.DEFAULT_UP=new Y(0,1,0);$n.DEFAULT_MATRIX_AUTO_UPDATE=!0;$n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var wn=class extends $n{constructor(){super(),this.isGroup=!0,this.type="Group"}},oA={type:"move"},ta=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new wn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new wn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new Y,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new Y),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new wn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new Y,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new Y,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let r=null,s=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let g=t.getJointPose(b,i),p=this._getHandJoint(c,b);g!==null&&(p.matrix.fromArray(g.transform.matrix),p.matrix.decompose(p.position,p.quaternion,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=g.radius),p.visible=g!==null}let u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],d=u.position.distanceTo(h.position),f=.02,m=.005;c.inputState.pinching&&d>f+m?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&d<=f-m&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(s=t.getPose(e.gripSpace,i),s!==null&&(l.matrix.fromArray(s.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,s.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(s.linearVelocity)):l.hasLinearVelocity=!1,s.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(s.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(r=t.getPose(e.targetRaySpace,i),r===null&&s!==null&&(r=s),r!==null&&(a.matrix.fromArray(r.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,r.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(r.linearVelocity)):a.hasLinearVelocity=!1,r.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(r.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(oA)))}return a!==null&&(a.visible=r!==null),l!==null&&(l.visible=s!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new wn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},qx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},fs={h:0,s:0,l:0},Bc={h:0,s:0,l:0};function nf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var je=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let r=e;r&&r.isColor?this.copy(r):typeof r=="number"?this.setHex(r):typeof r=="string"&&this.setStyle(r)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=_i){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,r=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,r),this}setHSL(e,t,i,r=vt.workingColorSpace){if(e=KS(e,1),t=Mt(t,0,1),i=Mt(i,0,1),t===0)this.r=this.g=this.b=i;else{let s=i<=.5?i*(1+t):i+t-i*t,o=2*i-s;this.r=nf(o,s,e+1/3),this.g=nf(o,s,e),this.b=nf(o,s,e-1/3)}return vt.colorSpaceToWorking(this,r),this}setStyle(e,t=_i){function i(s){s!==void 0&&parseFloat(s)<1&&et("Color: Alpha component of "+e+" will be ignored.")}let r;if(r=/^(\w+)\(([^\)]*)\)/.exec(e)){let s,o=r[1],a=r[2];switch(o){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,t);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,t);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,t);break;default:et("Color: Unknown color model "+e)}}else if(r=/^\#([A-Fa-f\d]+)$/.exec(e)){let s=r[1],o=s.length;if(o===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(s,16),t);et("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=_i){let i=qx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):et("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=zr(e.r),this.g=zr(e.g),this.b=zr(e.b),this}copyLinearToSRGB(e){return this.r=Ko(e.r),this.g=Ko(e.g),this.b=Ko(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=_i){return vt.workingToColorSpace(Xn.copy(this),e),Math.round(Mt(Xn.r*255,0,255))*65536+Math.round(Mt(Xn.g*255,0,255))*256+Math.round(Mt(Xn.b*255,0,255))}getHexString(e=_i){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Xn.copy(this),t);let i=Xn.r,r=Xn.g,s=Xn.b,o=Math.max(i,r,s),a=Math.min(i,r,s),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case i:l=(r-s)/h+(r<s?6:0);break;case r:l=(s-i)/h+2;break;case s:l=(i-r)/h+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Xn.copy(this),t),e.r=Xn.r,e.g=Xn.g,e.b=Xn.b,e}getStyle(e=_i){vt.workingToColorSpace(Xn.copy(this),e);let t=Xn.r,i=Xn.g,r=Xn.b;return e!==_i?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${r.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(r*255)})`}offsetHSL(e,t,i){return this.getHSL(fs),this.setHSL(fs.h+e,fs.s+t,fs.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(fs),e.getHSL(Bc);let i=Kd(fs.h,Bc.h,t),r=Kd(fs.s,Bc.s,t),s=Kd(fs.l,Bc.l,t);return this.setHSL(i,r,s),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,r=this.b,s=e.elements;return this.r=s[0]*t+s[3]*i+s[6]*r,this.g=s[1]*t+s[4]*i+s[7]*r,this.b=s[2]*t+s[5]*i+s[8]*r,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Xn=new je;je.NAMES=qx;var hl=class extends $n{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new vr,this.environmentIntensity=1,this.environmentRotation=new vr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Gi=new Y,Dr=new Y,rf=new Y,Ur=new Y,Vo=new Y,Ho=new Y,$0=new Y,sf=new Y,of=new Y,af=new Y,lf=new tn,cf=new tn,uf=new tn,xs=class n{constructor(e=new Y,t=new Y,i=new Y){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,r){r.subVectors(i,t),Gi.subVectors(e,t),r.cross(Gi);let s=r.lengthSq();return s>0?r.multiplyScalar(1/Math.sqrt(s)):r.set(0,0,0)}static getBarycoord(e,t,i,r,s){Gi.subVectors(r,t),Dr.subVectors(i,t),rf.subVectors(e,t);let o=Gi.dot(Gi),a=Gi.dot(Dr),l=Gi.dot(rf),c=Dr.dot(Dr),u=Dr.dot(rf),h=o*c-a*a;if(h===0)return s.set(0,0,0),null;let d=1/h,f=(c*l-a*u)*d,m=(o*u-a*l)*d;return s.set(1-f-m,m,f)}static containsPoint(e,t,i,r){return this.getBarycoord(e,t,i,r,Ur)===null?!1:Ur.x>=0&&Ur.y>=0&&Ur.x+Ur.y<=1}static getInterpolation(e,t,i,r,s,o,a,l){return this.getBarycoord(e,t,i,r,Ur)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(s,Ur.x),l.addScaledVector(o,Ur.y),l.addScaledVector(a,Ur.z),l)}static getInterpolatedAttribute(e,t,i,r,s,o){return lf.setScalar(0),cf.setScalar(0),uf.setScalar(0),lf.fromBufferAttribute(e,t),cf.fromBufferAttribute(e,i),uf.fromBufferAttribute(e,r),o.setScalar(0),o.addScaledVector(lf,s.x),o.addScaledVector(cf,s.y),o.addScaledVector(uf,s.z),o}static isFrontFacing(e,t,i,r){return Gi.subVectors(i,t),Dr.subVectors(e,t),Gi.cross(Dr).dot(r)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,r){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[r]),this}setFromAttributeAndIndices(e,t,i,r){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,r),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Gi.subVectors(this.c,this.b),Dr.subVectors(this.a,this.b),Gi.cross(Dr).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,r,s){return n.getInterpolation(e,this.a,this.b,this.c,t,i,r,s)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,r=this.b,s=this.c,o,a;Vo.subVectors(r,i),Ho.subVectors(s,i),sf.subVectors(e,i);let l=Vo.dot(sf),c=Ho.dot(sf);if(l<=0&&c<=0)return t.copy(i);of.subVectors(e,r);let u=Vo.dot(of),h=Ho.dot(of);if(u>=0&&h<=u)return t.copy(r);let d=l*h-u*c;if(d<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Vo,o);af.subVectors(e,s);let f=Vo.dot(af),m=Ho.dot(af);if(m>=0&&f<=m)return t.copy(s);let b=f*c-l*m;if(b<=0&&c>=0&&m<=0)return a=c/(c-m),t.copy(i).addScaledVector(Ho,a);let g=u*m-f*h;if(g<=0&&h-u>=0&&f-m>=0)return $0.subVectors(s,r),a=(h-u)/(h-u+(f-m)),t.copy(r).addScaledVector($0,a);let p=1/(g+b+d);return o=b*p,a=d*p,t.copy(i).addScaledVector(Vo,o).addScaledVector(Ho,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ys=class{constructor(e=new Y(1/0,1/0,1/0),t=new Y(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Wi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Wi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Wi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let s=i.getAttribute("position");if(t===!0&&s!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=s.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Wi):Wi.fromBufferAttribute(s,o),Wi.applyMatrix4(e.matrixWorld),this.expandByPoint(Wi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Dc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Dc.copy(i.boundingBox)),Dc.applyMatrix4(e.matrixWorld),this.union(Dc)}let r=e.children;for(let s=0,o=r.length;s<o;s++)this.expandByObject(r[s],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Wi),Wi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(el),Uc.subVectors(this.max,el),Go.subVectors(e.a,el),Wo.subVectors(e.b,el),qo.subVectors(e.c,el),ps.subVectors(Wo,Go),ms.subVectors(qo,Wo),Hs.subVectors(Go,qo);let t=[0,-ps.z,ps.y,0,-ms.z,ms.y,0,-Hs.z,Hs.y,ps.z,0,-ps.x,ms.z,0,-ms.x,Hs.z,0,-Hs.x,-ps.y,ps.x,0,-ms.y,ms.x,0,-Hs.y,Hs.x,0];return!hf(t,Go,Wo,qo,Uc)||(t=[1,0,0,0,1,0,0,0,1],!hf(t,Go,Wo,qo,Uc))?!1:(Oc.crossVectors(ps,ms),t=[Oc.x,Oc.y,Oc.z],hf(t,Go,Wo,qo,Uc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Wi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Wi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Or[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Or[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Or[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Or[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Or[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Or[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Or[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Or[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Or),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Or=[new Y,new Y,new Y,new Y,new Y,new Y,new Y,new Y],Wi=new Y,Dc=new ys,Go=new Y,Wo=new Y,qo=new Y,ps=new Y,ms=new Y,Hs=new Y,el=new Y,Uc=new Y,Oc=new Y,Gs=new Y;function hf(n,e,t,i,r){for(let s=0,o=n.length-3;s<=o;s+=3){Gs.fromArray(n,s);let a=r.x*Math.abs(Gs.x)+r.y*Math.abs(Gs.y)+r.z*Math.abs(Gs.z),l=e.dot(Gs),c=t.dot(Gs),u=i.dot(Gs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var vn=new Y,kc=new dt,aA=0,dn=class extends br{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:aA++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Zf,this.updateRanges=[],this.gpuType=$i,this.version=0,this._normalizationScale=e!==void 0?yh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let r=0,s=this.itemSize;r<s;r++)this.array[e+r]=t.array[i+r];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)kc.fromBufferAttribute(this,t),kc.applyMatrix3(e),this.setXY(t,kc.x,kc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix3(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix4(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyNormalMatrix(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.transformDirection(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=r,this.array[e+3]=s,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Gx(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Wx(e,this.array)}};var dl=class extends dn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var fl=class extends dn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Un=class extends dn{constructor(e,t,i){super(new Float32Array(e),t,i)}},lA=new ys,tl=new Y,df=new Y,na=class{constructor(e=new Y,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):lA.setFromPoints(e).getCenter(i);let r=0;for(let s=0,o=e.length;s<o;s++)r=Math.max(r,i.distanceToSquared(e[s]));return this.radius=Math.sqrt(r),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;tl.subVectors(e,this.center);let t=tl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),r=(i-this.radius)*.5;this.center.addScaledVector(tl,r/i),this.radius+=r}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(df.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(tl.copy(e.center).add(df)),this.expandByPoint(tl.copy(e.center).sub(df))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},cA=0,Pi=new en,ff=new $n,Xo=new Y,yi=new ys,nl=new ys,Dn=new Y,Vn=class n extends br{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:cA++}),this.uuid=Js(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(YS(e)?fl:dl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let s=new st().getNormalMatrix(e);i.applyNormalMatrix(s),i.needsUpdate=!0}let r=this.attributes.tangent;return r!==void 0&&(r.transformDirection(e),r.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Pi.makeRotationFromQuaternion(e),this.applyMatrix4(Pi),this}rotateX(e){return Pi.makeRotationX(e),this.applyMatrix4(Pi),this}rotateY(e){return Pi.makeRotationY(e),this.applyMatrix4(Pi),this}rotateZ(e){return Pi.makeRotationZ(e),this.applyMatrix4(Pi),this}translate(e,t,i){return Pi.makeTranslation(e,t,i),this.applyMatrix4(Pi),this}scale(e,t,i){return Pi.makeScale(e,t,i),this.applyMatrix4(Pi),this}lookAt(e){return ff.lookAt(e),ff.updateMatrix(),this.applyMatrix4(ff.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Xo).negate(),this.translate(Xo.x,Xo.y,Xo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let r=0,s=e.length;r<s;r++){let o=e[r];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Un(i,3))}else{let i=Math.min(e.length,t.count);for(let r=0;r<i;r++){let s=e[r];t.setXYZ(r,s.x,s.y,s.z||0)}e.length>t.count&&et("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ys);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new Y(-1/0,-1/0,-1/0),new Y(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,r=t.length;i<r;i++){let s=t[i];yi.setFromBufferAttribute(s),this.morphTargetsRelative?(Dn.addVectors(this.boundingBox.min,yi.min),this.boundingBox.expandByPoint(Dn),Dn.addVectors(this.boundingBox.max,yi.max),this.boundingBox.expandByPoint(Dn)):(this.boundingBox.expandByPoint(yi.min),this.boundingBox.expandByPoint(yi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&rt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new na);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new Y,1/0);return}if(e){let i=this.boundingSphere.center;if(yi.setFromBufferAttribute(e),t)for(let s=0,o=t.length;s<o;s++){let a=t[s];nl.setFromBufferAttribute(a),this.morphTargetsRelative?(Dn.addVectors(yi.min,nl.min),yi.expandByPoint(Dn),Dn.addVectors(yi.max,nl.max),yi.expandByPoint(Dn)):(yi.expandByPoint(nl.min),yi.expandByPoint(nl.max))}yi.getCenter(i);let r=0;for(let s=0,o=e.count;s<o;s++)Dn.fromBufferAttribute(e,s),r=Math.max(r,i.distanceToSquared(Dn));if(t)for(let s=0,o=t.length;s<o;s++){let a=t[s],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Dn.fromBufferAttribute(a,c),l&&(Xo.fromBufferAttribute(e,c),Dn.add(Xo)),r=Math.max(r,i.distanceToSquared(Dn))}this.boundingSphere.radius=Math.sqrt(r),isNaN(this.boundingSphere.radius)&&rt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){rt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,r=t.normal,s=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new dn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let O=0;O<i.count;O++)a[O]=new Y,l[O]=new Y;let u=new Y,h=new Y,d=new Y,f=new dt,m=new dt,b=new dt,g=new Y,p=new Y;function _(O,N,I){c[O]=c[N]=c[I]=1,u.fromBufferAttribute(i,O),h.fromBufferAttribute(i,N),d.fromBufferAttribute(i,I),f.fromBufferAttribute(s,O),m.fromBufferAttribute(s,N),b.fromBufferAttribute(s,I),h.sub(u),d.sub(u),m.sub(f),b.sub(f);let U=1/(m.x*b.y-b.x*m.y);isFinite(U)&&(g.copy(h).multiplyScalar(b.y).addScaledVector(d,-m.y).multiplyScalar(U),p.copy(d).multiplyScalar(m.x).addScaledVector(h,-b.x).multiplyScalar(U),a[O].add(g),a[N].add(g),a[I].add(g),l[O].add(p),l[N].add(p),l[I].add(p))}let T=this.groups;T.length===0&&(T=[{start:0,count:e.count}]);for(let O=0,N=T.length;O<N;++O){let I=T[O],U=I.start,H=I.count;for(let L=U,V=U+H;L<V;L+=3)_(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let w=new Y,C=new Y,E=new Y,x=new Y;function M(O){E.fromBufferAttribute(r,O),x.copy(E);let N=a[O];w.copy(N),w.sub(E.multiplyScalar(E.dot(N))).normalize(),C.crossVectors(x,N);let U=C.dot(l[O])<0?-1:1;o.setXYZW(O,w.x,w.y,w.z,U)}for(let O=0,N=i.count;O<N;++O)c[O]&&M(O);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new dn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let r=new Y,s=new Y,o=new Y,a=new Y,l=new Y,c=new Y,u=new Y,h=new Y;if(e)for(let d=0,f=e.count;d<f;d+=3){let m=e.getX(d+0),b=e.getX(d+1),g=e.getX(d+2);r.fromBufferAttribute(t,m),s.fromBufferAttribute(t,b),o.fromBufferAttribute(t,g),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),a.fromBufferAttribute(i,m),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(m,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let d=0,f=t.count;d<f;d+=3)r.fromBufferAttribute(t,d+0),s.fromBufferAttribute(t,d+1),o.fromBufferAttribute(t,d+2),u.subVectors(o,s),h.subVectors(r,s),u.cross(h),i.setXYZ(d+0,u.x,u.y,u.z),i.setXYZ(d+1,u.x,u.y,u.z),i.setXYZ(d+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Dn.fromBufferAttribute(e,t),Dn.normalize(),e.setXYZ(t,Dn.x,Dn.y,Dn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,h=a.normalized,d=new c.constructor(l.length*u),f=0,m=0;for(let b=0,g=l.length;b<g;b++){a.isInterleavedBufferAttribute?f=l[b]*a.data.stride+a.offset:f=l[b]*u;for(let p=0;p<u;p++)d[m++]=c[f++]}return new dn(d,u,h)}if(this.index===null)return et("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,r=this.attributes;for(let a in r){let l=r[a],c=e(l,i);t.setAttribute(a,c)}let s=this.morphAttributes;for(let a in s){let l=[],c=s[a];for(let u=0,h=c.length;u<h;u++){let d=c[u],f=e(d,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let r={},s=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let h=0,d=c.length;h<d;h++){let f=c[h];u.push(f.toJSON(e.data))}u.length>0&&(r[l]=u,s=!0)}s&&(e.data.morphAttributes=r,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let r=e.attributes;for(let c in r){let u=r[c];this.setAttribute(c,u.clone(t))}let s=e.morphAttributes;for(let c in s){let u=[],h=s[c];for(let d=0,f=h.length;d<f;d++)u.push(h[d].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},pl=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Zf,this.updateRanges=[],this.version=0,this.uuid=Js()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let r=0,s=this.stride;r<s;r++)this.array[e+r]=t.array[i+r];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Y0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),r=new this.constructor(i,this.stride);return r.setUsage(this.usage),r}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Y0(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Y0(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Js()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ti=new Y,ml=class n{constructor(e,t,i,r=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=r,this._normalizationScale=e!==void 0?yh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.applyMatrix4(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.applyNormalMatrix(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)ti.fromBufferAttribute(this,t),ti.transformDirection(e),this.setXYZ(t,ti.x,ti.y,ti.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this}setXYZW(e,t,i,r,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),r=this._normalize(r),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=r,this.data.array[e+3]=s,this}clone(e){if(e===void 0){ll("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return new dn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){ll("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let r=i*this.data.stride+this.offset;for(let s=0;s<this.itemSize;s++)t.push(this.data.array[r+s])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Gx(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Wx(e,this.data.array)}},pf=new Y,uA=new Y,hA=new st,qi=class{constructor(e=new Y(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,r){return this.normal.set(e,t,i),this.constant=r,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let r=pf.subVectors(i,t).cross(uA.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(r,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let r=e.delta(pf),s=this.normal.dot(r);if(s===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/s;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(r,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||hA.getNormalMatrix(e),r=this.coplanarPoint(pf).applyMatrix4(e),s=this.normal.applyMatrix3(i).normalize();return this.constant=-r.dot(s),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},dA=0,wr=class extends br{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:dA++}),this.uuid=Js(),this.name="",this.type="Material",this.blending=oa,this.side=ci,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Rf,this.blendDst=Pf,this.blendEquation=Ys,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new je(0,0,0),this.blendAlpha=0,this.depthFunc=Jo,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Lx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=eu,this.stencilZFail=eu,this.stencilZPass=eu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){et(`Material: parameter '${t}' has value of undefined.`);continue}let r=this[t];if(r===void 0){et(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}r&&r.isColor?r.set(i):r&&r.isVector2&&i&&i.isVector2||r&&r.isEuler&&i&&i.isEuler||r&&r.isVector3&&i&&i.isVector3?r.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function r(s){let o=[];for(let a in s){let l=s[a];delete l.metadata,o.push(l)}return o}if(t){let s=r(e.textures),o=r(e.images);s.length>0&&(i.textures=s),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new je().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new qi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new dt().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new dt().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let r=t.length;i=new Array(r);for(let s=0;s!==r;++s)i[s]=t[s].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var kr=new Y,mf=new Y,zc=new Y,Vc=new Y,mu=class{constructor(e=new Y,t=new Y(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,kr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=kr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(kr.copy(this.origin).addScaledVector(this.direction,t),kr.distanceToSquared(e))}distanceSqToSegment(e,t,i,r){mf.copy(e).add(t).multiplyScalar(.5),zc.copy(t).sub(e).normalize(),Vc.copy(this.origin).sub(mf);let s=e.distanceTo(t)*.5,o=-this.direction.dot(zc),a=Vc.dot(this.direction),l=-Vc.dot(zc),c=Vc.lengthSq(),u=Math.abs(1-o*o),h,d,f,m;if(u>0)if(h=o*l-a,d=o*a-l,m=s*u,h>=0)if(d>=-m)if(d<=m){let b=1/u;h*=b,d*=b,f=h*(h+o*d+2*a)+d*(o*h+d+2*l)+c}else d=s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d=-s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;else d<=-m?(h=Math.max(0,-(-o*s+a)),d=h>0?-s:Math.min(Math.max(-s,-l),s),f=-h*h+d*(d+2*l)+c):d<=m?(h=0,d=Math.min(Math.max(-s,-l),s),f=d*(d+2*l)+c):(h=Math.max(0,-(o*s+a)),d=h>0?s:Math.min(Math.max(-s,-l),s),f=-h*h+d*(d+2*l)+c);else d=o>0?-s:s,h=Math.max(0,-(o*d+a)),f=-h*h+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,h),r&&r.copy(mf).addScaledVector(zc,d),f}intersectSphere(e,t){if(e.radius<0)return null;kr.subVectors(e.center,this.origin);let i=kr.dot(this.direction),r=kr.dot(kr)-i*i,s=e.radius*e.radius;if(r>s)return null;let o=Math.sqrt(s-r),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,r,s,o,a,l,c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,d=this.origin;return c>=0?(i=(e.min.x-d.x)*c,r=(e.max.x-d.x)*c):(i=(e.max.x-d.x)*c,r=(e.min.x-d.x)*c),u>=0?(s=(e.min.y-d.y)*u,o=(e.max.y-d.y)*u):(s=(e.max.y-d.y)*u,o=(e.min.y-d.y)*u),i>o||s>r||((s>i||isNaN(i))&&(i=s),(o<r||isNaN(r))&&(r=o),h>=0?(a=(e.min.z-d.z)*h,l=(e.max.z-d.z)*h):(a=(e.max.z-d.z)*h,l=(e.min.z-d.z)*h),i>l||a>r)||((a>i||i!==i)&&(i=a),(l<r||r!==r)&&(r=l),r<0)?null:this.at(i>=0?i:r,t)}intersectsBox(e){return this.intersectBox(e,kr)!==null}intersectTriangle(e,t,i,r,s){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,h=e.x-o.x,d=e.y-o.y,f=e.z-o.z,m=t.x-o.x,b=t.y-o.y,g=t.z-o.z,p=i.x-o.x,_=i.y-o.y,T=i.z-o.z,w=Math.abs(l),C=Math.abs(c),E=Math.abs(u),x,M,O,N,I,U,H,L,V,W,z,ae;if(w>=C&&w>=E?(O=l,U=h,V=m,ae=p,l>=0?(x=c,M=u,N=d,I=f,H=b,L=g,W=_,z=T):(x=u,M=c,N=f,I=d,H=g,L=b,W=T,z=_)):C>=E?(O=c,U=d,V=b,ae=_,c>=0?(x=u,M=l,N=f,I=h,H=g,L=m,W=T,z=p):(x=l,M=u,N=h,I=f,H=m,L=g,W=p,z=T)):(O=u,U=f,V=g,ae=T,u>=0?(x=l,M=c,N=h,I=d,H=m,L=b,W=p,z=_):(x=c,M=l,N=d,I=h,H=b,L=m,W=_,z=p)),O===0)return null;let X=x/O,J=M/O,ee=1/O,ue=N-X*U,he=I-J*U,Q=H-X*V,ge=L-J*V,be=W-X*ae,Pe=z-J*ae,Ae=be*ge-Pe*Q,$e=ue*Pe-he*be,lt=Q*he-ge*ue;if(r){if(Ae<0||$e<0||lt<0)return null}else if((Ae<0||$e<0||lt<0)&&(Ae>0||$e>0||lt>0))return null;let qe=Ae+$e+lt;if(qe===0)return null;let gt=ee*(Ae*U+$e*V+lt*ae);return(qe>0?gt<0:gt>0)?null:this.at(gt/qe,s)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},_s=class extends wr{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=El,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Z0=new en,Ws=new mu,Hc=new na,K0=new Y,Gc=new Y,Wc=new Y,qc=new Y,gf=new Y,Xc=new Y,J0=new Y,$c=new Y,Et=class extends $n{constructor(e=new Vn,t=new _s){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let r=t[i[0]];if(r!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,o=r.length;s<o;s++){let a=r[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=s}}}}getVertexPosition(e,t){let i=this.geometry,r=i.attributes.position,s=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(r,e);let a=this.morphTargetInfluences;if(s&&a){Xc.set(0,0,0);for(let l=0,c=s.length;l<c;l++){let u=a[l],h=s[l];u!==0&&(gf.fromBufferAttribute(h,e),o?Xc.addScaledVector(gf,u):Xc.addScaledVector(gf.sub(t),u))}t.add(Xc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,r=this.material,s=this.matrixWorld;r!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Hc.copy(i.boundingSphere),Hc.applyMatrix4(s),Ws.copy(e.ray).recast(e.near),!(Hc.containsPoint(Ws.origin)===!1&&(Ws.intersectSphere(Hc,K0)===null||Ws.origin.distanceToSquared(K0)>(e.far-e.near)**2))&&(Z0.copy(s).invert(),Ws.copy(e.ray).applyMatrix4(Z0),!(i.boundingBox!==null&&Ws.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Ws)))}_computeIntersections(e,t,i){let r,s=this.geometry,o=this.material,a=s.index,l=s.attributes.position,c=s.attributes.uv,u=s.attributes.uv1,h=s.attributes.normal,d=s.groups,f=s.drawRange;if(a!==null)if(Array.isArray(o))for(let m=0,b=d.length;m<b;m++){let g=d[m],p=o[g.materialIndex],_=Math.max(g.start,f.start),T=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let w=_,C=T;w<C;w+=3){let E=a.getX(w),x=a.getX(w+1),M=a.getX(w+2);r=Yc(this,p,e,i,c,u,h,E,x,M),r&&(r.faceIndex=Math.floor(w/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,f.start),b=Math.min(a.count,f.start+f.count);for(let g=m,p=b;g<p;g+=3){let _=a.getX(g),T=a.getX(g+1),w=a.getX(g+2);r=Yc(this,o,e,i,c,u,h,_,T,w),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}else if(l!==void 0)if(Array.isArray(o))for(let m=0,b=d.length;m<b;m++){let g=d[m],p=o[g.materialIndex],_=Math.max(g.start,f.start),T=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let w=_,C=T;w<C;w+=3){let E=w,x=w+1,M=w+2;r=Yc(this,p,e,i,c,u,h,E,x,M),r&&(r.faceIndex=Math.floor(w/3),r.face.materialIndex=g.materialIndex,t.push(r))}}else{let m=Math.max(0,f.start),b=Math.min(l.count,f.start+f.count);for(let g=m,p=b;g<p;g+=3){let _=g,T=g+1,w=g+2;r=Yc(this,o,e,i,c,u,h,_,T,w),r&&(r.faceIndex=Math.floor(g/3),t.push(r))}}}};function fA(n,e,t,i,r,s,o,a){let l;if(e.side===fn?l=i.intersectTriangle(o,s,r,!0,a):l=i.intersectTriangle(r,s,o,e.side===ci,a),l===null)return null;$c.copy(a),$c.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo($c);return c<t.near||c>t.far?null:{distance:c,point:$c.clone(),object:n}}function Yc(n,e,t,i,r,s,o,a,l,c){n.getVertexPosition(a,Gc),n.getVertexPosition(l,Wc),n.getVertexPosition(c,qc);let u=fA(n,e,t,i,Gc,Wc,qc,J0);if(u){let h=new Y;xs.getBarycoord(J0,Gc,Wc,qc,h),r&&(u.uv=xs.getInterpolatedAttribute(r,a,l,c,h,new dt)),s&&(u.uv1=xs.getInterpolatedAttribute(s,a,l,c,h,new dt)),o&&(u.normal=xs.getInterpolatedAttribute(o,a,l,c,h,new Y),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new Y,materialIndex:0};xs.getNormal(Gc,Wc,qc,d.normal),u.face=d,u.barycoord=h}return u}var gu=class extends ai{constructor(e=null,t=1,i=1,r,s,o,a,l,c=On,u=On,h,d){super(null,o,a,l,c,u,r,s,h,d),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var qs=new na,pA=new dt(.5,.5),Zc=new Y,bs=class{constructor(e=new qi,t=new qi,i=new qi,r=new qi,s=new qi,o=new qi){this.planes=[e,t,i,r,s,o]}set(e,t,i,r,s,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(r),a[4].copy(s),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Ii,i=!1){let r=this.planes,s=e.elements,o=s[0],a=s[1],l=s[2],c=s[3],u=s[4],h=s[5],d=s[6],f=s[7],m=s[8],b=s[9],g=s[10],p=s[11],_=s[12],T=s[13],w=s[14],C=s[15];if(r[0].setComponents(c-o,f-u,p-m,C-_).normalize(),r[1].setComponents(c+o,f+u,p+m,C+_).normalize(),r[2].setComponents(c+a,f+h,p+b,C+T).normalize(),r[3].setComponents(c-a,f-h,p-b,C-T).normalize(),i)r[4].setComponents(l,d,g,w).normalize(),r[5].setComponents(c-l,f-d,p-g,C-w).normalize();else if(r[4].setComponents(c-l,f-d,p-g,C-w).normalize(),t===Ii)r[5].setComponents(c+l,f+d,p+g,C+w).normalize();else if(t===jo)r[5].setComponents(l,d,g,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),qs.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),qs.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(qs)}intersectsSprite(e){qs.center.set(0,0,0);let t=pA.distanceTo(e.center);return qs.radius=.7071067811865476+t,qs.applyMatrix4(e.matrixWorld),this.intersectsSphere(qs)}intersectsSphere(e){let t=this.planes,i=e.center,r=-e.radius;for(let s=0;s<6;s++)if(t[s].distanceToPoint(i)<r)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let r=t[i];if(Zc.x=r.normal.x>0?e.max.x:e.min.x,Zc.y=r.normal.y>0?e.max.y:e.min.y,Zc.z=r.normal.z>0?e.max.z:e.min.z,r.distanceToPoint(Zc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},j0=new en,xu=class n{constructor(){this.coordinateSystem=Ii,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let r=0;r<t.length;r++){let s=t[r];j0.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),i[r]===void 0&&(i[r]=new bs),i[r].setFromProjectionMatrix(j0,s.coordinateSystem,s.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let r=0;r<e._count;r++)t[r]===void 0&&(t[r]=new bs),t[r].copy(i[r]);return this._count=e._count,this}clone(){return new n().copy(this)}};var gl=class extends ai{constructor(e=[],t=Zs,i,r,s,o,a,l,c,u){super(e,t,i,r,s,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Hr=class extends ai{constructor(e,t,i=Xi,r,s,o,a=On,l=On,c,u=Vr,h=1){if(u!==Vr&&u!==Yr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:e,height:t,depth:h};super(d,r,s,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ea(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},xl=class extends Hr{constructor(e,t=Xi,i=Zs,r,s,o=On,a=On,l,c=Vr){let u={width:e,height:e,depth:1},h=[u,u,u,u,u,u];super(e,e,t,i,r,s,o,a,l,c),this.image=h,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},yl=class extends ai{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Gr=class n extends Vn{constructor(e=1,t=1,i=1,r=1,s=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:r,heightSegments:s,depthSegments:o};let a=this;r=Math.floor(r),s=Math.floor(s),o=Math.floor(o);let l=[],c=[],u=[],h=[],d=0,f=0;m("z","y","x",-1,-1,i,t,e,o,s,0),m("z","y","x",1,-1,i,t,-e,o,s,1),m("x","z","y",1,1,e,i,t,r,o,2),m("x","z","y",1,-1,e,i,-t,r,o,3),m("x","y","z",1,-1,e,t,i,r,s,4),m("x","y","z",-1,-1,e,t,-i,r,s,5),this.setIndex(l),this.setAttribute("position",new Un(c,3)),this.setAttribute("normal",new Un(u,3)),this.setAttribute("uv",new Un(h,2));function m(b,g,p,_,T,w,C,E,x,M,O){let N=w/x,I=C/M,U=w/2,H=C/2,L=E/2,V=x+1,W=M+1,z=0,ae=0,X=new Y;for(let J=0;J<W;J++){let ee=J*I-H;for(let ue=0;ue<V;ue++){let he=ue*N-U;X[b]=he*_,X[g]=ee*T,X[p]=L,c.push(X.x,X.y,X.z),X[b]=0,X[g]=0,X[p]=E>0?1:-1,u.push(X.x,X.y,X.z),h.push(ue/x),h.push(1-J/M),z+=1}}for(let J=0;J<M;J++)for(let ee=0;ee<x;ee++){let ue=d+ee+V*J,he=d+ee+V*(J+1),Q=d+(ee+1)+V*(J+1),ge=d+(ee+1)+V*J;l.push(ue,he,ge),l.push(he,Q,ge),ae+=6}a.addGroup(f,ae,O),f+=ae,d+=z}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Wr=class n extends Vn{constructor(e=1,t=1,i=1,r=32,s=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:e,radiusBottom:t,height:i,radialSegments:r,heightSegments:s,openEnded:o,thetaStart:a,thetaLength:l};let c=this;r=Math.floor(r),s=Math.floor(s);let u=[],h=[],d=[],f=[],m=0,b=[],g=i/2,p=0;_(),o===!1&&(e>0&&T(!0),t>0&&T(!1)),this.setIndex(u),this.setAttribute("position",new Un(h,3)),this.setAttribute("normal",new Un(d,3)),this.setAttribute("uv",new Un(f,2));function _(){let w=new Y,C=new Y,E=0,x=(t-e)/i;for(let M=0;M<=s;M++){let O=[],N=M/s,I=N*(t-e)+e;for(let U=0;U<=r;U++){let H=U/r,L=H*l+a,V=Math.sin(L),W=Math.cos(L);C.x=I*V,C.y=-N*i+g,C.z=I*W,h.push(C.x,C.y,C.z),w.set(V,x,W).normalize(),d.push(w.x,w.y,w.z),f.push(H,1-N),O.push(m++)}b.push(O)}for(let M=0;M<r;M++)for(let O=0;O<s;O++){let N=b[O][M],I=b[O+1][M],U=b[O+1][M+1],H=b[O][M+1];(e>0||O!==0)&&(u.push(N,I,H),E+=3),(t>0||O!==s-1)&&(u.push(I,U,H),E+=3)}c.addGroup(p,E,0),p+=E}function T(w){let C=m,E=new dt,x=new Y,M=0,O=w===!0?e:t,N=w===!0?1:-1;for(let U=1;U<=r;U++)h.push(0,g*N,0),d.push(0,N,0),f.push(.5,.5),m++;let I=m;for(let U=0;U<=r;U++){let L=U/r*l+a,V=Math.cos(L),W=Math.sin(L);x.x=O*W,x.y=g*N,x.z=O*V,h.push(x.x,x.y,x.z),d.push(0,N,0),E.x=V*.5+.5,E.y=W*.5*N+.5,f.push(E.x,E.y),m++}for(let U=0;U<r;U++){let H=C+U,L=I+U;w===!0?u.push(L,L+1,H):u.push(L+1,L,H),M+=3}c.addGroup(p,M,w===!0?1:2),p+=M}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radiusTop,e.radiusBottom,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}},_l=class n extends Wr{constructor(e=1,t=1,i=32,r=1,s=!1,o=0,a=Math.PI*2){super(0,e,t,i,r,s,o,a),this.type="ConeGeometry",this.parameters={radius:e,height:t,radialSegments:i,heightSegments:r,openEnded:s,thetaStart:o,thetaLength:a}}static fromJSON(e){return new n(e.radius,e.height,e.radialSegments,e.heightSegments,e.openEnded,e.thetaStart,e.thetaLength)}};var vs=class n extends Vn{constructor(e=1,t=1,i=1,r=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:r};let s=e/2,o=t/2,a=Math.floor(i),l=Math.floor(r),c=a+1,u=l+1,h=e/a,d=t/l,f=[],m=[],b=[],g=[];for(let p=0;p<u;p++){let _=p*d-o;for(let T=0;T<c;T++){let w=T*h-s;m.push(w,-_,0),b.push(0,0,1),g.push(T/a),g.push(1-p/l)}}for(let p=0;p<l;p++)for(let _=0;_<a;_++){let T=_+c*p,w=_+c*(p+1),C=_+1+c*(p+1),E=_+1+c*p;f.push(T,w,E),f.push(w,C,E)}this.setIndex(f),this.setAttribute("position",new Un(m,3)),this.setAttribute("normal",new Un(b,3)),this.setAttribute("uv",new Un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var qr=class n extends Vn{constructor(e=1,t=32,i=16,r=0,s=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:e,widthSegments:t,heightSegments:i,phiStart:r,phiLength:s,thetaStart:o,thetaLength:a},t=Math.max(3,Math.floor(t)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,u=[],h=new Y,d=new Y,f=[],m=[],b=[],g=[];for(let p=0;p<=i;p++){let _=[],T=p/i,w=o+T*a,C=e*Math.cos(w),E=Math.sqrt(e*e-C*C),x=0;p===0&&o===0?x=.5/t:p===i&&l===Math.PI&&(x=-.5/t);for(let M=0;M<=t;M++){let O=M/t,N=r+O*s;h.x=-E*Math.cos(N),h.y=C,h.z=E*Math.sin(N),m.push(h.x,h.y,h.z),d.copy(h).normalize(),b.push(d.x,d.y,d.z),g.push(O+x,1-T),_.push(c++)}u.push(_)}for(let p=0;p<i;p++)for(let _=0;_<t;_++){let T=u[p][_+1],w=u[p][_],C=u[p+1][_],E=u[p+1][_+1];(p!==0||o>0)&&f.push(T,w,E),(p!==i-1||l<Math.PI)&&f.push(w,C,E)}this.setIndex(f),this.setAttribute("position",new Un(m,3)),this.setAttribute("normal",new Un(b,3)),this.setAttribute("uv",new Un(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.radius,e.widthSegments,e.heightSegments,e.phiStart,e.phiLength,e.thetaStart,e.thetaLength)}};var bl=class extends wr{constructor(e){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new je(0),this.transparent=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.fog=e.fog,this}};function js(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let r=n[t][i];if(Q0(r))r.isRenderTargetTexture?(et("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=r.clone();else if(Array.isArray(r))if(Q0(r[0])){let s=[];for(let o=0,a=r.length;o<a;o++)s[o]=r[o].clone();e[t][i]=s}else e[t][i]=r.slice();else e[t][i]=r}}return e}function Yn(n){let e={};for(let t=0;t<n.length;t++){let i=js(n[t]);for(let r in i)e[r]=i[r]}return e}function Q0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function mA(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Jf(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var Xx={clone:js,merge:Yn},gA=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,xA=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,li=class extends wr{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gA,this.fragmentShader=xA,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=js(e.uniforms),this.uniformsGroups=mA(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let r in this.uniforms){let o=this.uniforms[r].value;o&&o.isTexture?t.uniforms[r]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[r]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[r]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[r]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[r]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[r]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[r]={type:"m4",value:o.toArray()}:t.uniforms[r]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let r in this.extensions)this.extensions[r]===!0&&(i[r]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let r=e.uniforms[i];switch(this.uniforms[i]={},r.type){case"t":this.uniforms[i].value=t[r.value]||null;break;case"c":this.uniforms[i].value=new je().setHex(r.value);break;case"v2":this.uniforms[i].value=new dt().fromArray(r.value);break;case"v3":this.uniforms[i].value=new Y().fromArray(r.value);break;case"v4":this.uniforms[i].value=new tn().fromArray(r.value);break;case"m3":this.uniforms[i].value=new st().fromArray(r.value);break;case"m4":this.uniforms[i].value=new en().fromArray(r.value);break;default:this.uniforms[i].value=r.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},yu=class extends li{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Xr=class extends wr{constructor(e){super(),this.isMeshPhongMaterial=!0,this.type="MeshPhongMaterial",this.color=new je(16777215),this.specular=new je(1118481),this.shininess=30,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Bl,this.normalScale=new dt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=El,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.specular.copy(e.specular),this.shininess=e.shininess,this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}};var vl=class extends wr{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new je(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new je(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Bl,this.normalScale=new dt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new vr,this.combine=El,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},_u=class extends wr{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Px,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},bu=class extends wr{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function $o(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Kc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ws=class{constructor(e,t,i,r){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=r!==void 0?r:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,r=t[i],s=t[i-1];e:{t:{let o;n:{i:if(!(e<r)){for(let a=i+2;;){if(r===void 0){if(e<s)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(s=r,r=t[++i],e<r)break t}o=t.length;break n}if(!(e>=s)){let a=t[1];e<a&&(i=2,s=a);for(let l=i-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(r=s,s=t[--i-1],e>=s)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(r=t[i],s=t[i-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(r===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,s,r)}return this.interpolate_(i,s,e,r)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,r=this.valueSize,s=e*r;for(let o=0;o!==r;++o)t[o]=i[s+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},vu=class extends ws{constructor(e,t,i,r){super(e,t,i,r),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:_f,endingEnd:_f}}intervalChanged_(e,t,i){let r=this.parameterPositions,s=e-2,o=e+1,a=r[s],l=r[o];if(a===void 0)switch(this.getSettings_().endingStart){case bf:s=e,a=2*t-i;break;case vf:s=r.length-2,a=t+r[s]-r[s+1];break;default:s=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case bf:o=e,l=2*i-t;break;case vf:o=1,l=i+r[1]-r[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=s*u,this._offsetNext=o*u}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,h=this._offsetNext,d=this._weightPrev,f=this._weightNext,m=(i-t)/(r-t),b=m*m,g=b*m,p=-d*g+2*d*b-d*m,_=(1+d)*g+(-1.5-2*d)*b+(-.5+d)*m+1,T=(-1-f)*g+(1.5+f)*b+.5*m,w=f*g-f*b;for(let C=0;C!==a;++C)s[C]=p*o[u+C]+_*o[c+C]+T*o[l+C]+w*o[h+C];return s}},wu=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(r-t),h=1-u;for(let d=0;d!==a;++d)s[d]=o[c+d]*h+o[l+d]*u;return s}},Su=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e){return this.copySampleValue_(e-1)}},Au=class extends ws{interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,h=this.outTangents;if(!u||!h){let m=(i-t)/(r-t),b=1-m;for(let g=0;g!==a;++g)s[g]=o[c+g]*b+o[l+g]*m;return s}let d=a*2,f=e-1;for(let m=0;m!==a;++m){let b=o[c+m],g=o[l+m],p=f*d+m*2,_=h[p],T=h[p+1],w=e*d+m*2,C=u[w],E=u[w+1],x=_A(i,t,_,C,r);s[m]=$x(x,b,T,E,g)}return s}};function $x(n,e,t,i,r){let s=1-n;return s*s*s*e+3*s*s*n*t+3*s*n*n*i+n*n*n*r}function yA(n,e,t,i,r){let s=1-n;return 3*s*s*(t-e)+6*s*n*(i-t)+3*n*n*(r-i)}function _A(n,e,t,i,r){let s=(n-e)/(r-e);for(let o=0;o<8;o++){let a=$x(s,e,t,i,r)-n;if(Math.abs(a)<1e-10)break;let l=yA(s,e,t,i,r);if(Math.abs(l)<1e-10)break;s=Math.max(0,Math.min(1,s-a/l))}return s}var vi=class{constructor(e,t,i,r){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=$o(t,this.TimeBufferType),this.values=$o(i,this.ValueBufferType),this.setInterpolation(r||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:$o(e.times,Array),values:$o(e.values,Array)};let r=e.getInterpolation();r!==e.DefaultInterpolation&&(i.interpolation=r),Kc(e.settings)&&(i.settings={inTangents:$o(e.settings.inTangents,Array),outTangents:$o(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Su(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new wu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new vu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Au(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case rl:t=this.InterpolantFactoryMethodDiscrete;break;case uu:t=this.InterpolantFactoryMethodLinear;break;case Qc:t=this.InterpolantFactoryMethodSmooth;break;case yf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return et("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return rl;case this.InterpolantFactoryMethodLinear:return uu;case this.InterpolantFactoryMethodSmooth:return Qc;case this.InterpolantFactoryMethodBezier:return yf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]+=e;Kc(this.settings)&&(ex(this.settings.inTangents,e),ex(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,r=t.length;i!==r;++i)t[i]*=e;Kc(this.settings)&&(tx(this.settings.inTangents,e),tx(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,r=i.length,s=0,o=r-1;for(;s!==r&&i[s]<e;)++s;for(;o!==-1&&i[o]>t;)--o;if(++o,s!==0||o!==r){s>=o&&(o=Math.max(o,1),s=o-1);let a=this.getValueSize();this.times=i.slice(s,o),this.values=this.values.slice(s*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(rt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,r=this.values,s=i.length;s===0&&(rt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==s;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){rt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){rt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(r!==void 0&&ZS(r))for(let a=0,l=r.length;a!==l;++a){let c=r[a];if(isNaN(c)){rt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),r=this.getInterpolation()===Qc,s=e.length-1,o=1;for(let a=1;a<s;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(r)l=!0;else{let h=a*i,d=h-i,f=h+i;for(let m=0;m!==i;++m){let b=t[h+m];if(b!==t[d+m]||b!==t[f+m]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let h=a*i,d=o*i;for(let f=0;f!==i;++f)t[d+f]=t[h+f]}++o}}if(s>0){e[o]=e[s];for(let a=s*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,r=new i(this.name,e,t);return r.createInterpolant=this.createInterpolant,Kc(this.settings)&&(r.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),r}};function ex(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function tx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}vi.prototype.ValueTypeName="";vi.prototype.TimeBufferType=Float32Array;vi.prototype.ValueBufferType=Float32Array;vi.prototype.DefaultInterpolation=uu;var Ss=class extends vi{constructor(e,t,i){super(e,t,i)}};Ss.prototype.ValueTypeName="bool";Ss.prototype.ValueBufferType=Array;Ss.prototype.DefaultInterpolation=rl;Ss.prototype.InterpolantFactoryMethodLinear=void 0;Ss.prototype.InterpolantFactoryMethodSmooth=void 0;var Mu=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Mu.prototype.ValueTypeName="color";var Tu=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Tu.prototype.ValueTypeName="number";var Eu=class extends ws{constructor(e,t,i,r){super(e,t,i,r)}interpolate_(e,t,i,r){let s=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(r-t),c=e*a;for(let u=c+a;c!==u;c+=4)Li.slerpFlat(s,0,o,c-a,o,c,l);return s}},wl=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}InterpolantFactoryMethodLinear(e){return new Eu(this.times,this.values,this.getValueSize(),e)}};wl.prototype.ValueTypeName="quaternion";wl.prototype.InterpolantFactoryMethodSmooth=void 0;var As=class extends vi{constructor(e,t,i){super(e,t,i)}};As.prototype.ValueTypeName="string";As.prototype.ValueBufferType=Array;As.prototype.DefaultInterpolation=rl;As.prototype.InterpolantFactoryMethodLinear=void 0;As.prototype.InterpolantFactoryMethodSmooth=void 0;var Cu=class extends vi{constructor(e,t,i,r){super(e,t,i,r)}};Cu.prototype.ValueTypeName="vector";var Ru=class{constructor(e,t,i){let r=this,s=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,s===!1&&r.onStart!==void 0&&r.onStart(u,o,a),s=!0},this.itemEnd=function(u){o++,r.onProgress!==void 0&&r.onProgress(u,o,a),o===a&&(s=!1,r.onLoad!==void 0&&r.onLoad())},this.itemError=function(u){r.onError!==void 0&&r.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,h){return c.push(u,h),this},this.removeHandler=function(u){let h=c.indexOf(u);return h!==-1&&c.splice(h,2),this},this.getHandler=function(u){for(let h=0,d=c.length;h<d;h+=2){let f=c[h],m=c[h+1];if(f.global&&(f.lastIndex=0),f.test(u))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Yx=new Ru,Pu=class{constructor(e){this.manager=e!==void 0?e:Yx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(r,s){i.load(e,r,t,s)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Pu.DEFAULT_MATERIAL_NAME="__DEFAULT";var Sl=class extends $n{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new je(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ia=class extends Sl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy($n.DEFAULT_UP),this.updateMatrix(),this.groundColor=new je(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},xf=new en,nx=new Y,ix=new Y,Iu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new dt(512,512),this.mapType=ui,this.map=null,this.mapPass=null,this.matrix=new en,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new bs,this._frameExtents=new dt(1,1),this._viewportCount=1,this._viewports=[new tn(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;nx.setFromMatrixPosition(e.matrixWorld),t.position.copy(nx),ix.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(ix),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,r){xf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(xf,e.coordinateSystem,e.reversedDepth);let s=this._frameExtents,o=r?r.z/s.x:1,a=r?r.w/s.y:1,l=r?r.x/s.x:0,c=r?r.y/s.y:0;e.coordinateSystem===jo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(xf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Jc=new Y,jc=new Li,yr=new Y,Al=class extends $n{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new en,this.projectionMatrix=new en,this.projectionMatrixInverse=new en,this.coordinateSystem=Ii,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Jc,jc,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Jc,jc,yr.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Jc,jc,yr),yr.x===1&&yr.y===1&&yr.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Jc,jc,yr.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},gs=new Y,rx=new dt,sx=new dt,ni=class extends Al{constructor(e=50,t=1,i=.1,r=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=r,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=hu*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Zd*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return hu*2*Math.atan(Math.tan(Zd*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){gs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(gs.x,gs.y).multiplyScalar(-e/gs.z),gs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(gs.x,gs.y).multiplyScalar(-e/gs.z)}getViewSize(e,t){return this.getViewBounds(e,rx,sx),t.subVectors(sx,rx)}setViewOffset(e,t,i,r,s,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Zd*.5*this.fov)/this.zoom,i=2*t,r=this.aspect*i,s=-.5*r,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;s+=o.offsetX*r/l,t-=o.offsetY*i/c,r*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(s+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+r,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ml=class extends Al{constructor(e=-1,t=1,i=1,r=-1,s=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=r,this.near=s,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,r,s,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=r,this.view.width=s,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,r=(this.top+this.bottom)/2,s=i-e,o=i+e,a=r+t,l=r-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=c*this.view.offsetX,o=s+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(s,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},wf=class extends Iu{constructor(){super(new Ml(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Tl=class extends Sl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($n.DEFAULT_UP),this.updateMatrix(),this.target=new $n,this.shadow=new wf}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Yo=-90,Zo=1,ra=class extends $n{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let r=new ni(Yo,Zo,e,t);r.layers=this.layers,this.add(r);let s=new ni(Yo,Zo,e,t);s.layers=this.layers,this.add(s);let o=new ni(Yo,Zo,e,t);o.layers=this.layers,this.add(o);let a=new ni(Yo,Zo,e,t);a.layers=this.layers,this.add(a);let l=new ni(Yo,Zo,e,t);l.layers=this.layers,this.add(l);let c=new ni(Yo,Zo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,r,s,o,a,l]=t;for(let c of t)this.remove(c);if(e===Ii)i.up.set(0,1,0),i.lookAt(1,0,0),r.up.set(0,1,0),r.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===jo)i.up.set(0,-1,0),i.lookAt(-1,0,0),r.up.set(0,-1,0),r.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:r}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[s,o,a,l,c,u]=this.children,h=e.getRenderTarget(),d=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),m=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,s),e.setRenderTarget(i,1,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,r),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(h,d,f),e.xr.enabled=m,i.texture.needsPMREMUpdate=!0}},Lu=class extends ni{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var jf="\\[\\]\\.:\\/",bA=new RegExp("["+jf+"]","g"),Qf="[^"+jf+"]",vA="[^"+jf.replace("\\.","")+"]",wA=/((?:WC+[\/:])*)/.source.replace("WC",Qf),SA=/(WCOD+)?/.source.replace("WCOD",vA),AA=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Qf),MA=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Qf),TA=new RegExp("^"+wA+SA+AA+MA+"$"),EA=["material","materials","bones","map"],Sf=class{constructor(e,t,i){let r=i||Zt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,r)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,r=this._bindings[i];r!==void 0&&r.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let r=this._targetGroup.nCachedObjects_,s=i.length;r!==s;++r)i[r].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Zt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(bA,"")}static parseTrackName(e){let t=TA.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},r=i.nodeName&&i.nodeName.lastIndexOf(".");if(r!==void 0&&r!==-1){let s=i.nodeName.substring(r+1);EA.indexOf(s)!==-1&&(i.nodeName=i.nodeName.substring(0,r),i.objectName=s)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(s){for(let o=0;o<s.length;o++){let a=s[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},r=i(e.children);if(r)return r}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)e[t++]=i[r]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let r=0,s=i.length;r!==s;++r)i[r]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,r=t.propertyName,s=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){et("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){rt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){rt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){rt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){rt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){rt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[r];if(o===void 0){let c=t.nodeName;rt("PropertyBinding: Trying to update property for track: "+c+"."+r+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(s!==void 0){if(r==="morphTargetInfluences"){if(!e.geometry){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[s]!==void 0&&(s=e.morphTargetDictionary[s])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=s}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=r;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Zt.Composite=Sf;Zt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Zt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Zt.prototype.GetterByBindingType=[Zt.prototype._getValue_direct,Zt.prototype._getValue_array,Zt.prototype._getValue_arrayElement,Zt.prototype._getValue_toArray];Zt.prototype.SetterByBindingTypeAndVersioning=[[Zt.prototype._setValue_direct,Zt.prototype._setValue_direct_setNeedsUpdate,Zt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_array,Zt.prototype._setValue_array_setNeedsUpdate,Zt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_arrayElement,Zt.prototype._setValue_arrayElement_setNeedsUpdate,Zt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Zt.prototype._setValue_fromArray,Zt.prototype._setValue_fromArray_setNeedsUpdate,Zt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var tF=new Float32Array(1);var Af=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,r){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,r)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,r){let s=this.elements;return s[0]=e,s[2]=t,s[1]=i,s[3]=r,this}};function ep(n,e,t,i){let r=CA(i);switch(t){case Gf:return n*e;case qf:return n*e/r.components*r.byteLength;case ku:return n*e/r.components*r.byteLength;case Ms:return n*e*2/r.components*r.byteLength;case zu:return n*e*2/r.components*r.byteLength;case Wf:return n*e*3/r.components*r.byteLength;case Zi:return n*e*4/r.components*r.byteLength;case Vu:return n*e*4/r.components*r.byteLength;case Rl:case Pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Il:case Ll:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Gu:case qu:return Math.max(n,16)*Math.max(e,8)/4;case Hu:case Wu:return Math.max(n,8)*Math.max(e,8)/2;case Xu:case $u:case Zu:case Ku:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Yu:case Fl:case Ju:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ju:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Qu:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case eh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case th:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case nh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case ih:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case rh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case sh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case oh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case lh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case ch:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case uh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case hh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case dh:case fh:case ph:return Math.ceil(n/4)*Math.ceil(e/4)*16;case mh:case gh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Nl:case xh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function CA(n){switch(n){case ui:case kf:return{byteLength:1,components:1};case la:case zf:case Yi:return{byteLength:2,components:1};case Uu:case Ou:return{byteLength:2,components:4};case Xi:case Du:case $i:return{byteLength:4,components:1};case Vf:case Hf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?et("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function gy(){let n=null,e=!1,t=null,i=null;function r(s,o){i=n.requestAnimationFrame(r),t(s,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(r),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(s){t=s},setContext:function(s){n=s}}}function PA(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,h=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function i(a,l,c){let u=l.array,h=l.updateRanges;if(n.bindBuffer(c,a),h.length===0)n.bufferSubData(c,0,u);else{h.sort((f,m)=>f.start-m.start);let d=0;for(let f=1;f<h.length;f++){let m=h[d],b=h[f];b.start<=m.start+m.count+1?m.count=Math.max(m.count,b.start+b.count-m.start):(++d,h[d]=b)}h.length=d+1;for(let f=0,m=h.length;f<m;f++){let b=h[f];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function r(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function s(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:r,remove:s,update:o}}var IA=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,LA=`#ifdef USE_ALPHAHASH
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
#endif`,FA=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,NA=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,BA=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,DA=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,UA=`#ifdef USE_AOMAP
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
#endif`,OA=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kA=`#ifdef USE_BATCHING
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
#endif`,zA=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,VA=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,HA=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,GA=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,WA=`#ifdef USE_IRIDESCENCE
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
#endif`,qA=`#ifdef USE_BUMPMAP
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
#endif`,XA=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,$A=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,YA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,ZA=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,KA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,JA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,jA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,QA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,eM=`#define PI 3.141592653589793
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
} // validated`,tM=`vec3 transformedNormal = objectNormal;
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
#endif`,nM=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iM=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,rM=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,sM=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,oM="gl_FragColor = linearToOutputTexel( gl_FragColor );",aM=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,lM=`#ifdef USE_ENVMAP
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
#endif`,cM=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,uM=`#ifdef USE_ENVMAP
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
#endif`,hM=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,dM=`#ifdef USE_ENVMAP
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
#endif`,fM=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pM=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mM=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gM=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,xM=`#ifdef USE_GRADIENTMAP
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
}`,yM=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,_M=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,bM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,vM=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,wM=`#ifdef USE_ENVMAP
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
#endif`,SM=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,AM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,MM=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,TM=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,EM=`PhysicalMaterial material;
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
#endif`,CM=`uniform sampler2D dfgLUT;
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
}`,RM=`
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
#endif`,PM=`#if defined( RE_IndirectDiffuse )
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
#endif`,IM=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,LM=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,FM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,NM=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,BM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,DM=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,UM=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,OM=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,kM=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,zM=`#if defined( USE_POINTS_UV )
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
#endif`,VM=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,HM=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,GM=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,WM=`#if defined( USE_MORPHCOLORS )
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
#endif`,qM=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,XM=`#ifdef USE_MORPHTARGETS
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
#endif`,$M=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,YM=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,ZM=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,KM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,JM=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,jM=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,QM=`#ifdef USE_NORMALMAP
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
#endif`,e1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,t1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,n1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,i1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,r1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,s1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,o1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,a1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,l1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,c1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,u1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,h1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,d1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,f1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,p1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,m1=`float getShadowMask() {
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
}`,g1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,x1=`#ifdef USE_SKINNING
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
#endif`,y1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,_1=`#ifdef USE_SKINNING
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
#endif`,b1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,v1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,w1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,S1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,A1=`#ifdef USE_TRANSMISSION
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
#endif`,M1=`#ifdef USE_TRANSMISSION
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
#endif`,T1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,E1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,C1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,R1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,P1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,I1=`uniform sampler2D t2D;
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
}`,L1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,F1=`uniform float backgroundBlurriness;
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
}`,N1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,B1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,D1=`#include <common>
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
}`,U1=`#if DEPTH_PACKING == 3200
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
}`,O1=`#define DISTANCE
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
}`,k1=`#define DISTANCE
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
}`,z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,V1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,H1=`uniform float scale;
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
}`,G1=`uniform vec3 diffuse;
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
}`,W1=`#include <common>
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
}`,q1=`uniform vec3 diffuse;
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
}`,X1=`#define LAMBERT
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
}`,$1=`#define LAMBERT
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
}`,Y1=`#define MATCAP
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
}`,Z1=`#define MATCAP
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
}`,K1=`#define NORMAL
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
}`,J1=`#define NORMAL
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
}`,j1=`#define PHONG
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
}`,Q1=`#define PHONG
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
}`,eT=`#define STANDARD
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
}`,tT=`#define STANDARD
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
}`,nT=`#define TOON
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
}`,iT=`#define TOON
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
}`,rT=`uniform float size;
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
}`,sT=`uniform vec3 diffuse;
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
}`,oT=`#include <common>
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
}`,aT=`uniform vec3 color;
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
}`,lT=`uniform float rotation;
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
}`,cT=`uniform vec3 diffuse;
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
}`,mt={alphahash_fragment:IA,alphahash_pars_fragment:LA,alphamap_fragment:FA,alphamap_pars_fragment:NA,alphatest_fragment:BA,alphatest_pars_fragment:DA,aomap_fragment:UA,aomap_pars_fragment:OA,batching_pars_vertex:kA,batching_vertex:zA,begin_vertex:VA,beginnormal_vertex:HA,bsdfs:GA,iridescence_fragment:WA,bumpmap_pars_fragment:qA,clipping_planes_fragment:XA,clipping_planes_pars_fragment:$A,clipping_planes_pars_vertex:YA,clipping_planes_vertex:ZA,color_fragment:KA,color_pars_fragment:JA,color_pars_vertex:jA,color_vertex:QA,common:eM,defaultnormal_vertex:tM,displacementmap_pars_vertex:nM,displacementmap_vertex:iM,emissivemap_fragment:rM,emissivemap_pars_fragment:sM,colorspace_fragment:oM,colorspace_pars_fragment:aM,envmap_fragment:lM,envmap_common_pars_fragment:cM,envmap_pars_fragment:uM,envmap_pars_vertex:hM,envmap_physical_pars_fragment:wM,envmap_vertex:dM,fog_vertex:fM,fog_pars_vertex:pM,fog_fragment:mM,fog_pars_fragment:gM,gradientmap_pars_fragment:xM,lightmap_pars_fragment:yM,lights_lambert_fragment:_M,lights_lambert_pars_fragment:bM,lights_pars_begin:vM,lights_toon_fragment:SM,lights_toon_pars_fragment:AM,lights_phong_fragment:MM,lights_phong_pars_fragment:TM,lights_physical_fragment:EM,lights_physical_pars_fragment:CM,lights_fragment_begin:RM,lights_fragment_maps:PM,lights_fragment_end:IM,lightprobes_pars_fragment:LM,logdepthbuf_fragment:FM,logdepthbuf_pars_fragment:NM,logdepthbuf_pars_vertex:BM,logdepthbuf_vertex:DM,map_fragment:UM,map_pars_fragment:OM,map_particle_fragment:kM,map_particle_pars_fragment:zM,metalnessmap_fragment:VM,metalnessmap_pars_fragment:HM,morphinstance_vertex:GM,morphcolor_vertex:WM,morphnormal_vertex:qM,morphtarget_pars_vertex:XM,morphtarget_vertex:$M,normal_fragment_begin:YM,normal_fragment_maps:ZM,normal_pars_fragment:KM,normal_pars_vertex:JM,normal_vertex:jM,normalmap_pars_fragment:QM,clearcoat_normal_fragment_begin:e1,clearcoat_normal_fragment_maps:t1,clearcoat_pars_fragment:n1,iridescence_pars_fragment:i1,opaque_fragment:r1,packing:s1,premultiplied_alpha_fragment:o1,project_vertex:a1,dithering_fragment:l1,dithering_pars_fragment:c1,roughnessmap_fragment:u1,roughnessmap_pars_fragment:h1,shadowmap_pars_fragment:d1,shadowmap_pars_vertex:f1,shadowmap_vertex:p1,shadowmask_pars_fragment:m1,skinbase_vertex:g1,skinning_pars_vertex:x1,skinning_vertex:y1,skinnormal_vertex:_1,specularmap_fragment:b1,specularmap_pars_fragment:v1,tonemapping_fragment:w1,tonemapping_pars_fragment:S1,transmission_fragment:A1,transmission_pars_fragment:M1,uv_pars_fragment:T1,uv_pars_vertex:E1,uv_vertex:C1,worldpos_vertex:R1,background_vert:P1,background_frag:I1,backgroundCube_vert:L1,backgroundCube_frag:F1,cube_vert:N1,cube_frag:B1,depth_vert:D1,depth_frag:U1,distance_vert:O1,distance_frag:k1,equirect_vert:z1,equirect_frag:V1,linedashed_vert:H1,linedashed_frag:G1,meshbasic_vert:W1,meshbasic_frag:q1,meshlambert_vert:X1,meshlambert_frag:$1,meshmatcap_vert:Y1,meshmatcap_frag:Z1,meshnormal_vert:K1,meshnormal_frag:J1,meshphong_vert:j1,meshphong_frag:Q1,meshphysical_vert:eT,meshphysical_frag:tT,meshtoon_vert:nT,meshtoon_frag:iT,points_vert:rT,points_frag:sT,shadow_vert:oT,shadow_frag:aT,sprite_vert:lT,sprite_frag:cT},Be={common:{diffuse:{value:new je(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new dt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new je(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new je(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new je(16777215)},opacity:{value:1},center:{value:new dt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},Mr={basic:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.fog]),vertexShader:mt.meshbasic_vert,fragmentShader:mt.meshbasic_frag},lambert:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new je(0)},envMapIntensity:{value:1}}]),vertexShader:mt.meshlambert_vert,fragmentShader:mt.meshlambert_frag},phong:{uniforms:Yn([Be.common,Be.specularmap,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,Be.lights,{emissive:{value:new je(0)},specular:{value:new je(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:mt.meshphong_vert,fragmentShader:mt.meshphong_frag},standard:{uniforms:Yn([Be.common,Be.envmap,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.roughnessmap,Be.metalnessmap,Be.fog,Be.lights,{emissive:{value:new je(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag},toon:{uniforms:Yn([Be.common,Be.aomap,Be.lightmap,Be.emissivemap,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.gradientmap,Be.fog,Be.lights,{emissive:{value:new je(0)}}]),vertexShader:mt.meshtoon_vert,fragmentShader:mt.meshtoon_frag},matcap:{uniforms:Yn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,Be.fog,{matcap:{value:null}}]),vertexShader:mt.meshmatcap_vert,fragmentShader:mt.meshmatcap_frag},points:{uniforms:Yn([Be.points,Be.fog]),vertexShader:mt.points_vert,fragmentShader:mt.points_frag},dashed:{uniforms:Yn([Be.common,Be.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:mt.linedashed_vert,fragmentShader:mt.linedashed_frag},depth:{uniforms:Yn([Be.common,Be.displacementmap]),vertexShader:mt.depth_vert,fragmentShader:mt.depth_frag},normal:{uniforms:Yn([Be.common,Be.bumpmap,Be.normalmap,Be.displacementmap,{opacity:{value:1}}]),vertexShader:mt.meshnormal_vert,fragmentShader:mt.meshnormal_frag},sprite:{uniforms:Yn([Be.sprite,Be.fog]),vertexShader:mt.sprite_vert,fragmentShader:mt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:mt.background_vert,fragmentShader:mt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:mt.backgroundCube_vert,fragmentShader:mt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:mt.cube_vert,fragmentShader:mt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:mt.equirect_vert,fragmentShader:mt.equirect_frag},distance:{uniforms:Yn([Be.common,Be.displacementmap,{referencePosition:{value:new Y},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:mt.distance_vert,fragmentShader:mt.distance_frag},shadow:{uniforms:Yn([Be.lights,Be.fog,{color:{value:new je(0)},opacity:{value:1}}]),vertexShader:mt.shadow_vert,fragmentShader:mt.shadow_frag}};Mr.physical={uniforms:Yn([Mr.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new dt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new je(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new dt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new je(0)},specularColor:{value:new je(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new dt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:mt.meshphysical_vert,fragmentShader:mt.meshphysical_frag};var _h={r:0,b:0,g:0},uT=new en,xy=new st;xy.set(-1,0,0,0,1,0,0,0,1);function hT(n,e,t,i,r,s){let o=new je(0),a=r===!0?0:1,l,c,u=null,h=0,d=null;function f(_){let T=_.isScene===!0?_.background:null;if(T&&T.isTexture){let w=_.backgroundBlurriness>0;T=e.get(T,w)}return T}function m(_){let T=!1,w=f(_);w===null?g(o,a):w&&w.isColor&&(g(w,1),T=!0);let C=n.xr.getEnvironmentBlendMode();C==="additive"?t.buffers.color.setClear(0,0,0,1,s):C==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,s),(n.autoClear||T)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(_,T){let w=f(T);w&&w.isCubeTexture?(c===void 0&&(c=new Et(new Gr(1,1,1),new li({name:"BackgroundCubeMaterial",uniforms:js(Mr.backgroundCube.uniforms),vertexShader:Mr.backgroundCube.vertexShader,fragmentShader:Mr.backgroundCube.fragmentShader,side:fn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(C,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=T.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(uT.makeRotationFromEuler(T.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(xy),c.material.toneMapped=vt.getTransfer(w.colorSpace)!==Lt,(u!==w||h!==w.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,u=w,h=w.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Et(new vs(2,2),new li({name:"BackgroundMaterial",uniforms:js(Mr.background.uniforms),vertexShader:Mr.background.vertexShader,fragmentShader:Mr.background.fragmentShader,side:ci,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=T.backgroundIntensity,l.material.toneMapped=vt.getTransfer(w.colorSpace)!==Lt,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(u!==w||h!==w.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,u=w,h=w.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,T){_.getRGB(_h,Jf(n)),t.buffers.color.setClear(_h.r,_h.g,_h.b,T,s)}function p(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,T=1){o.set(_),a=T,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:m,addToRenderList:b,dispose:p}}function dT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},r=d(null),s=r,o=!1;function a(I,U,H,L,V){let W=!1,z=h(I,L,H,U);s!==z&&(s=z,c(s.object)),W=f(I,L,H,V),W&&m(I,L,H,V),V!==null&&e.update(V,n.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,w(I,U,H,L),V!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(V).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function u(I){return n.deleteVertexArray(I)}function h(I,U,H,L){let V=L.wireframe===!0,W=i[U.id];W===void 0&&(W={},i[U.id]=W);let z=I.isInstancedMesh===!0?I.id:0,ae=W[z];ae===void 0&&(ae={},W[z]=ae);let X=ae[H.id];X===void 0&&(X={},ae[H.id]=X);let J=X[V];return J===void 0&&(J=d(l()),X[V]=J),J}function d(I){let U=[],H=[],L=[];for(let V=0;V<t;V++)U[V]=0,H[V]=0,L[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:U,enabledAttributes:H,attributeDivisors:L,object:I,attributes:{},index:null}}function f(I,U,H,L){let V=s.attributes,W=U.attributes,z=0,ae=H.getAttributes();for(let X in ae)if(ae[X].location>=0){let ee=V[X],ue=W[X];if(ue===void 0&&(X==="instanceMatrix"&&I.instanceMatrix&&(ue=I.instanceMatrix),X==="instanceColor"&&I.instanceColor&&(ue=I.instanceColor)),ee===void 0||ee.attribute!==ue||ue&&ee.data!==ue.data)return!0;z++}return s.attributesNum!==z||s.index!==L}function m(I,U,H,L){let V={},W=U.attributes,z=0,ae=H.getAttributes();for(let X in ae)if(ae[X].location>=0){let ee=W[X];ee===void 0&&(X==="instanceMatrix"&&I.instanceMatrix&&(ee=I.instanceMatrix),X==="instanceColor"&&I.instanceColor&&(ee=I.instanceColor));let ue={};ue.attribute=ee,ee&&ee.data&&(ue.data=ee.data),V[X]=ue,z++}s.attributes=V,s.attributesNum=z,s.index=L}function b(){let I=s.newAttributes;for(let U=0,H=I.length;U<H;U++)I[U]=0}function g(I){p(I,0)}function p(I,U){let H=s.newAttributes,L=s.enabledAttributes,V=s.attributeDivisors;H[I]=1,L[I]===0&&(n.enableVertexAttribArray(I),L[I]=1),V[I]!==U&&(n.vertexAttribDivisor(I,U),V[I]=U)}function _(){let I=s.newAttributes,U=s.enabledAttributes;for(let H=0,L=U.length;H<L;H++)U[H]!==I[H]&&(n.disableVertexAttribArray(H),U[H]=0)}function T(I,U,H,L,V,W,z){z===!0?n.vertexAttribIPointer(I,U,H,V,W):n.vertexAttribPointer(I,U,H,L,V,W)}function w(I,U,H,L){b();let V=L.attributes,W=H.getAttributes(),z=U.defaultAttributeValues;for(let ae in W){let X=W[ae];if(X.location>=0){let J=V[ae];if(J===void 0&&(ae==="instanceMatrix"&&I.instanceMatrix&&(J=I.instanceMatrix),ae==="instanceColor"&&I.instanceColor&&(J=I.instanceColor)),J!==void 0){let ee=J.normalized,ue=J.itemSize,he=e.get(J);if(he===void 0)continue;let Q=he.buffer,ge=he.type,be=he.bytesPerElement,Pe=ge===n.INT||ge===n.UNSIGNED_INT||J.gpuType===Du;if(J.isInterleavedBufferAttribute){let Ae=J.data,$e=Ae.isInterleavedBuffer===!0?Ae.stride:Ae.itemSize,lt=J.offset;if(Ae.isInstancedInterleavedBuffer||Ae.isInstancedBufferAttribute){for(let qe=0;qe<X.locationSize;qe++)p(X.location+qe,Ae.meshPerAttribute);I.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Ae.meshPerAttribute*Ae.count)}else for(let qe=0;qe<X.locationSize;qe++)g(X.location+qe);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let qe=0;qe<X.locationSize;qe++)T(X.location+qe,ue/X.locationSize,ge,ee,$e*be,(lt+ue/X.locationSize*qe)*be,Pe)}else{if(J.isInstancedBufferAttribute){for(let Ae=0;Ae<X.locationSize;Ae++)p(X.location+Ae,J.meshPerAttribute);I.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=J.meshPerAttribute*J.count)}else for(let Ae=0;Ae<X.locationSize;Ae++)g(X.location+Ae);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Ae=0;Ae<X.locationSize;Ae++)T(X.location+Ae,ue/X.locationSize,ge,ee,ue*be,ue/X.locationSize*Ae*be,Pe)}}else if(z!==void 0){let ee=z[ae];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(X.location,ee);break;case 3:n.vertexAttrib3fv(X.location,ee);break;case 4:n.vertexAttrib4fv(X.location,ee);break;default:n.vertexAttrib1fv(X.location,ee)}}}}_()}function C(){O();for(let I in i){let U=i[I];for(let H in U){let L=U[H];for(let V in L){let W=L[V];for(let z in W)u(W[z].object),delete W[z];delete L[V]}}delete i[I]}}function E(I){if(i[I.id]===void 0)return;let U=i[I.id];for(let H in U){let L=U[H];for(let V in L){let W=L[V];for(let z in W)u(W[z].object),delete W[z];delete L[V]}}delete i[I.id]}function x(I){for(let U in i){let H=i[U];for(let L in H){let V=H[L];if(V[I.id]===void 0)continue;let W=V[I.id];for(let z in W)u(W[z].object),delete W[z];delete V[I.id]}}}function M(I){for(let U in i){let H=i[U],L=I.isInstancedMesh===!0?I.id:0,V=H[L];if(V!==void 0){for(let W in V){let z=V[W];for(let ae in z)u(z[ae].object),delete z[ae];delete V[W]}delete H[L],Object.keys(H).length===0&&delete i[U]}}}function O(){N(),o=!0,s!==r&&(s=r,c(s.object))}function N(){r.geometry=null,r.program=null,r.wireframe=!1}return{setup:a,reset:O,resetDefaultState:N,dispose:C,releaseStatesOfGeometry:E,releaseStatesOfObject:M,releaseStatesOfProgram:x,initAttributes:b,enableAttribute:g,disableUnusedAttributes:_}}function fT(n,e,t){let i;function r(l){i=l}function s(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let d=0;for(let f=0;f<u;f++)d+=c[f];t.update(d,i,1)}this.setMode=r,this.render=s,this.renderInstances=o,this.renderMultiDraw=a}function pT(n,e,t,i){let r;function s(){if(r!==void 0)return r;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");r=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else r=0;return r}function o(x){return!(x!==Zi&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let M=x===Yi&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==ui&&x!==$i&&!M&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(et("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let h=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),d=t.logarithmicDepthBuffer===!0&&h===!1;t.reversedDepthBuffer===!0&&h===!1&&et("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&h===!0&&et("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),p=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),T=n.getParameter(n.MAX_VARYING_VECTORS),w=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),C=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:h,maxTextures:f,maxVertexTextures:m,maxTextureSize:b,maxCubemapSize:g,maxAttributes:p,maxVertexUniforms:_,maxVaryings:T,maxFragmentUniforms:w,maxSamples:C,samples:E}}function mT(n){let e=this,t=null,i=0,r=!1,s=!1,o=new qi,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,d){let f=h.length!==0||d||i!==0||r;return r=d,i=h.length,f},this.beginShadows=function(){s=!0,u(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(h,d){t=u(h,d,0)},this.setState=function(h,d,f){let m=h.clippingPlanes,b=h.clipIntersection,g=h.clipShadows,p=n.get(h);if(!r||m===null||m.length===0||s&&!g)s?u(null):c();else{let _=s?0:i,T=_*4,w=p.clippingState||null;l.value=w,w=u(m,d,T,f);for(let C=0;C!==T;++C)w[C]=t[C];p.clippingState=w,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(h,d,f,m){let b=h!==null?h.length:0,g=null;if(b!==0){if(g=l.value,m!==!0||g===null){let p=f+b*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<p)&&(g=new Float32Array(p));for(let T=0,w=f;T!==b;++T,w+=4)o.copy(h[T]).applyMatrix4(_,a),o.normal.toArray(g,w),g[w+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,g}}var Ol=class extends bi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},r=[i,i,i,i,i,i];this.texture=new gl(r),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},r=new Gr(5,5,5),s=new li({name:"CubemapFromEquirect",uniforms:js(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:fn,blending:$s});s.uniforms.tEquirect.value=t;let o=new Et(r,s),a=t.minFilter;return t.minFilter===$r&&(t.minFilter=ii),new ra(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,r=!0){let s=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,r);e.setRenderTarget(s)}},Zx=256,gT=3,xT=20,yy=256,_y=16,yT=3,_T=new Y,bT=new je,vh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ra(1,10,null),this._boxMesh=new Et(new Gr(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,r=100,s={}){let{size:o=256,position:a=_T}=s,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let h=l.autoClear,d=l.autoClearColor,f=l.autoClearDepth,m=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(bT));let g=new ra(i,r,u);return g.position.copy(a),g.update(l,e),l.autoClear=h,l.autoClearColor=d,l.autoClearDepth=f,l.autoClearStencil=m,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=jx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Jx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Zx,Hx(e))}_fromTexture(e,t){e.mapping===Zs||e.mapping===aa?this._setSize(e.image.length===0?Zx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Kx(e,!1,!1),i=Math.log2(e)-gT;for(let r=0;r<=i;r++)t.texture.mipmaps.push({width:e>>r,height:e>>r});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Kx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let r=this._boxMesh,s=this._cubeCamera;r.material=i,s.renderTarget=e,s.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),s.update(this._renderer,r),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Zs||e.mapping===aa?(this._cubemapMaterial===null&&(this._cubemapMaterial=jx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Jx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=vT(),this._integrationMaterial=wT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,r=this._ggxMaterial.uniforms;r.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(t/_y);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-yT)s.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(yy*Math.pow(a,4)))+.5:0;r.roughness.value=a,r.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=ST());let i=this._blurMaterial,r=i.uniforms,s=this._sourceTarget;r.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,r.envMap.value=s.texture,this._renderCube(e,0,i),r.envMap.value=e.texture,this._renderCube(s,0,i)}};function Kx(n,e,t){return new Ol(n,{minFilter:$r,generateMipmaps:e,type:Yi,colorSpace:sl,depthBuffer:t})}function kl(n,e,t){return new li({name:n,uniforms:e,vertexShader:mt.cube_vert,fragmentShader:t,side:fn,blending:$s,depthTest:!1,depthWrite:!1})}function vT(){return kl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${yy}u

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
	`)}function wT(){return kl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:_y}},`

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
	`)}function ST(){return kl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${xT}
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
	`)}function Jx(){return kl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function jx(){return kl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function AT(n){let e=new WeakMap,t=new WeakMap,i=null;function r(d,f=!1){return d==null?null:f?o(d):s(d)}function s(d){if(d&&d.isTexture){let f=d.mapping;if(f===Fu||f===Nu)if(e.has(d)){let m=e.get(d).texture;return a(m,d.mapping)}else{let m=d.image;if(m&&m.height>0){let b=new Ol(m.height);return b.fromEquirectangularTexture(n,d),e.set(d,b),d.addEventListener("dispose",c),a(b.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,m=f===Fu||f===Nu,b=f===Zs||f===aa;if(m||b){let g=t.get(d),p=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==p)return i===null&&(i=new vh(n)),g=m?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return m&&_&&_.height>0||b&&_&&l(_)?(i===null&&(i=new vh(n)),g=m?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,t.set(d,g),d.addEventListener("dispose",u),g.texture):null}}}return d}function a(d,f){return f===Fu?d.mapping=Zs:f===Nu&&(d.mapping=aa),d}function l(d){let f=0,m=6;for(let b=0;b<m;b++)d[b]!==void 0&&f++;return f===m}function c(d){let f=d.target;f.removeEventListener("dispose",c);let m=e.get(f);m!==void 0&&(e.delete(f),m.dispose())}function u(d){let f=d.target;f.removeEventListener("dispose",u);let m=t.get(f);m!==void 0&&(t.delete(f),m.dispose())}function h(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:r,dispose:h}}function MT(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let r=n.getExtension(i);return e[i]=r,r}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let r=t(i);return r===null&&il("WebGLRenderer: "+i+" extension not supported."),r}}}function TT(n,e,t,i){let r={},s=new WeakMap,o=new FinalizationRegistry(m=>delete r[m]);function a(m){l(m.target)}function l(m){m.index!==null&&e.remove(m.index);for(let g in m.attributes)e.remove(m.attributes[g]);m.removeEventListener("dispose",a),delete r[m.id],o.unregister(m);let b=s.get(m);b&&(e.remove(b),s.delete(m)),i.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,t.memory.geometries--}function c(m,b){return r[b.id]!==void 0||(b.addEventListener("dispose",a),r[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(m){let b=m.attributes;for(let g in b)e.update(b[g],n.ARRAY_BUFFER)}function h(m){let b=m.index,g=m.attributes.position,p=0;if(g===void 0)return;let _=b!==null?b.array.length:g.array.length/3-1,T=g.count>=65535?fl:dl,w=new T(Math.ceil(_/3)*6,1),C=w.array;if(b!==null){let x=b.array;p=b.version;for(let M=0,O=0;M<_;M+=3){let N=x[M+0],I=x[M+1],U=x[M+2];C[O++]=N,C[O++]=I,C[O++]=I,C[O++]=U,C[O++]=U,C[O++]=N}}else{p=g.version;for(let x=0,M=0;x<_;x+=3){let O=x+0,N=x+1,I=x+2;C[M++]=O,C[M++]=N,C[M++]=N,C[M++]=I,C[M++]=I,C[M++]=O}}w.version=p;let E=s.get(m);E&&e.remove(E),s.set(m,w)}function d(m){let b=s.get(m);if(b){let g=m.index;g!==null&&b.version<g.version&&h(m)}else h(m);return s.get(m)}function f(){for(let m in r){let b=r[m].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:d,dispose:f}}function ET(n,e,t){let i;function r(h){i=h}let s,o;function a(h){s=h.type,o=h.bytesPerElement}function l(h,d){n.drawElements(i,d,s,h*o),t.update(d,i,1)}function c(h,d,f){f!==0&&(n.drawElementsInstanced(i,d,s,h*o,f),t.update(d,i,f))}function u(h,d,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,s,h,0,f);let b=0;for(let g=0;g<f;g++)b+=d[g];t.update(b,i,1)}this.setMode=r,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function CT(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(s,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(s/3);break;case n.LINES:t.lines+=a*(s/2);break;case n.LINE_STRIP:t.lines+=a*(s-1);break;case n.LINE_LOOP:t.lines+=a*s;break;case n.POINTS:t.points+=a*s;break;default:rt("WebGLInfo: Unknown draw mode:",o);break}}function r(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:r,update:i}}function RT(n,e,t){let i=new WeakMap,r=new tn;function s(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0,d=i.get(a);if(d===void 0||d.count!==h){let O=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,m=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],p=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],T=0;f===!0&&(T=1),m===!0&&(T=2),b===!0&&(T=3);let w=a.attributes.position.count*T,C=1;w>e.maxTextureSize&&(C=Math.ceil(w/e.maxTextureSize),w=e.maxTextureSize);let E=new Float32Array(w*C*4*h),x=new cl(E,w,C,h);x.type=$i,x.needsUpdate=!0;let M=T*4;for(let N=0;N<h;N++){let I=g[N],U=p[N],H=_[N],L=w*C*4*N;for(let V=0;V<I.count;V++){let W=V*M;f===!0&&(r.fromBufferAttribute(I,V),E[L+W+0]=r.x,E[L+W+1]=r.y,E[L+W+2]=r.z,E[L+W+3]=0),m===!0&&(r.fromBufferAttribute(U,V),E[L+W+4]=r.x,E[L+W+5]=r.y,E[L+W+6]=r.z,E[L+W+7]=0),b===!0&&(r.fromBufferAttribute(H,V),E[L+W+8]=r.x,E[L+W+9]=r.y,E[L+W+10]=r.z,E[L+W+11]=H.itemSize===4?r.w:1)}}d={count:h,texture:x,size:new dt(w,C)},i.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let b=0;b<c.length;b++)f+=c[b];let m=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",m),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:s}}function PT(n,e,t,i,r){let s=new WeakMap;function o(c){let u=r.render.frame,h=c.geometry,d=e.get(c,h);if(s.get(d)!==u&&(e.update(d),s.set(d,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),s.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),s.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;s.get(f)!==u&&(f.update(),s.set(f,u))}return d}function a(){s=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var IT={[If]:"LINEAR_TONE_MAPPING",[Lf]:"REINHARD_TONE_MAPPING",[Ff]:"CINEON_TONE_MAPPING",[Nf]:"ACES_FILMIC_TONE_MAPPING",[Df]:"AGX_TONE_MAPPING",[Uf]:"NEUTRAL_TONE_MAPPING",[Bf]:"CUSTOM_TONE_MAPPING"};function LT(n,e,t,i,r,s){let o=new bi(e,t,{type:n,depthBuffer:r,stencilBuffer:s,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Vn;u.setAttribute("position",new Un([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Un([0,2,0,0,2,0],2));let h=new yu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Et(u,h),f=new Ml(-1,1,1,-1,0,1),m=null,b=null,g=!1,p,_=null,T=[],w=!1;this.setSize=function(C,E){o.setSize(C,E),a!==null&&a.setSize(C,E),l!==null&&l.setSize(C,E);for(let x=0;x<T.length;x++){let M=T[x];M.setSize&&M.setSize(C,E)}},this.setEffects=function(C){T=C,w=T.length>0&&T[0].isRenderPass===!0;let E=o.width,x=o.height;T.length>0&&a===null&&(a=new bi(E,x,{type:Yi,depthBuffer:!1,stencilBuffer:!1}),l=new bi(E,x,{type:Yi,depthBuffer:!1,stencilBuffer:!1}));let M=r===!0&&T.some(O=>O.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Hr(E,x),s===!0&&(c.format=Yr,c.type=Ks)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let O=0;O<T.length;O++){let N=T[O];N.setSize&&N.setSize(E,x),M&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(C,E){if(g||C.toneMapping===Sr&&T.length===0)return!1;if(_=E,E!==null){let x=E.width,M=E.height;(o.width!==x||o.height!==M)&&this.setSize(x,M)}return w===!1&&C.setRenderTarget(o),p=C.toneMapping,C.toneMapping=Sr,!0},this.hasRenderPass=function(){return w},this.end=function(C,E){C.toneMapping=p,g=!0;let x=o,M=a;for(let O=0;O<T.length;O++){let N=T[O];N.enabled!==!1&&(N.render(C,M,x,E),N.needsSwap!==!1&&(x=M,M=M===a?l:a))}if(m!==C.outputColorSpace||b!==C.toneMapping){m=C.outputColorSpace,b=C.toneMapping,h.defines={},vt.getTransfer(m)===Lt&&(h.defines.SRGB_TRANSFER="");let O=IT[b];O&&(h.defines[O]=""),h.needsUpdate=!0}h.uniforms.tDiffuse.value=x.texture,C.setRenderTarget(_),C.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),h.dispose()}}var by=new ai,vy=new Hr(1,1),wy=new xl(1),Sy=new cl,Ay=new pu,My=new gl,Qx=[],ey=[],ty=new Float32Array(16),ny=new Float32Array(9),iy=new Float32Array(4);function ua(n,e,t){let i=n[0];if(i<=0||i>0)return n;let r=e*t,s=Qx[r];if(s===void 0&&(s=new Float32Array(r),Qx[r]=s),e!==0){i.toArray(s,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(s,a)}return s}function Tn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function En(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Sh(n,e){let t=ey[e];t===void 0&&(t=new Int32Array(e),ey[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function FT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function NT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2fv(this.addr,e),En(t,e)}}function BT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Tn(t,e))return;n.uniform3fv(this.addr,e),En(t,e)}}function DT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4fv(this.addr,e),En(t,e)}}function UT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;iy.set(i),n.uniformMatrix2fv(this.addr,!1,iy),En(t,i)}}function OT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;ny.set(i),n.uniformMatrix3fv(this.addr,!1,ny),En(t,i)}}function kT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Tn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),En(t,e)}else{if(Tn(t,i))return;ty.set(i),n.uniformMatrix4fv(this.addr,!1,ty),En(t,i)}}function zT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function VT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2iv(this.addr,e),En(t,e)}}function HT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3iv(this.addr,e),En(t,e)}}function GT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4iv(this.addr,e),En(t,e)}}function WT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function qT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Tn(t,e))return;n.uniform2uiv(this.addr,e),En(t,e)}}function XT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Tn(t,e))return;n.uniform3uiv(this.addr,e),En(t,e)}}function $T(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Tn(t,e))return;n.uniform4uiv(this.addr,e),En(t,e)}}function Ah(n){return n.version===0&&(n.compareFunction=Yf,n.needsUpdate=!0),n}function YT(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_2D_SHADOW?s=Ah(vy):s=by,t.setTexture2D(e||s,r)}function ZT(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture3D(e||Ay,r)}function KT(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r);let s;this.type===n.SAMPLER_CUBE_SHADOW?s=Ah(wy):s=My,t.setTextureCube(e||s,r)}function JT(n,e,t){let i=this.cache,r=t.allocateTextureUnit();i[0]!==r&&(n.uniform1i(this.addr,r),i[0]=r),t.setTexture2DArray(e||Sy,r)}function jT(n){switch(n){case 5126:return FT;case 35664:return NT;case 35665:return BT;case 35666:return DT;case 35674:return UT;case 35675:return OT;case 35676:return kT;case 5124:case 35670:return zT;case 35667:case 35671:return VT;case 35668:case 35672:return HT;case 35669:case 35673:return GT;case 5125:return WT;case 36294:return qT;case 36295:return XT;case 36296:return $T;case 35678:case 36198:case 36298:case 36306:case 35682:return YT;case 35679:case 36299:case 36307:return ZT;case 35680:case 36300:case 36308:case 36293:return KT;case 36289:case 36303:case 36311:case 36292:return JT}}function QT(n,e){n.uniform1fv(this.addr,e)}function eE(n,e){let t=ua(e,this.size,2);n.uniform2fv(this.addr,t)}function tE(n,e){let t=ua(e,this.size,3);n.uniform3fv(this.addr,t)}function nE(n,e){let t=ua(e,this.size,4);n.uniform4fv(this.addr,t)}function iE(n,e){let t=ua(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function rE(n,e){let t=ua(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function sE(n,e){let t=ua(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function oE(n,e){n.uniform1iv(this.addr,e)}function aE(n,e){n.uniform2iv(this.addr,e)}function lE(n,e){n.uniform3iv(this.addr,e)}function cE(n,e){n.uniform4iv(this.addr,e)}function uE(n,e){n.uniform1uiv(this.addr,e)}function hE(n,e){n.uniform2uiv(this.addr,e)}function dE(n,e){n.uniform3uiv(this.addr,e)}function fE(n,e){n.uniform4uiv(this.addr,e)}function pE(n,e,t){let i=this.cache,r=e.length,s=Sh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ah(vy):o=by;for(let a=0;a!==r;++a)t.setTexture2D(e[a]||o,s[a])}function mE(n,e,t){let i=this.cache,r=e.length,s=Sh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));for(let o=0;o!==r;++o)t.setTexture3D(e[o]||Ay,s[o])}function gE(n,e,t){let i=this.cache,r=e.length,s=Sh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ah(wy):o=My;for(let a=0;a!==r;++a)t.setTextureCube(e[a]||o,s[a])}function xE(n,e,t){let i=this.cache,r=e.length,s=Sh(t,r);Tn(i,s)||(n.uniform1iv(this.addr,s),En(i,s));for(let o=0;o!==r;++o)t.setTexture2DArray(e[o]||Sy,s[o])}function yE(n){switch(n){case 5126:return QT;case 35664:return eE;case 35665:return tE;case 35666:return nE;case 35674:return iE;case 35675:return rE;case 35676:return sE;case 5124:case 35670:return oE;case 35667:case 35671:return aE;case 35668:case 35672:return lE;case 35669:case 35673:return cE;case 5125:return uE;case 36294:return hE;case 36295:return dE;case 36296:return fE;case 35678:case 36198:case 36298:case 36306:case 35682:return pE;case 35679:case 36299:case 36307:return mE;case 35680:case 36300:case 36308:case 36293:return gE;case 36289:case 36303:case 36311:case 36292:return xE}}var ip=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=jT(t.type)}},rp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=yE(t.type)}},sp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let r=this.seq;for(let s=0,o=r.length;s!==o;++s){let a=r[s];a.setValue(e,t[a.id],i)}}},tp=/(\w+)(\])?(\[|\.)?/g;function ry(n,e){n.seq.push(e),n.map[e.id]=e}function _E(n,e,t){let i=n.name,r=i.length;for(tp.lastIndex=0;;){let s=tp.exec(i),o=tp.lastIndex,a=s[1],l=s[2]==="]",c=s[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===r){ry(t,c===void 0?new ip(a,n,e):new rp(a,n,e));break}else{let h=t.map[a];h===void 0&&(h=new sp(a),ry(t,h)),t=h}}}var ca=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);_E(a,l,this)}let r=[],s=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?r.push(o):s.push(o);r.length>0&&(this.seq=r.concat(s))}setValue(e,t,i,r){let s=this.map[t];s!==void 0&&s.setValue(e,i,r)}setOptional(e,t,i){let r=t[i];r!==void 0&&this.setValue(e,i,r)}static upload(e,t,i,r){for(let s=0,o=t.length;s!==o;++s){let a=t[s],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,r)}}static seqWithValue(e,t){let i=[];for(let r=0,s=e.length;r!==s;++r){let o=e[r];o.id in t&&i.push(o)}return i}};function sy(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var bE=37297,vE=0;function wE(n,e){let t=n.split(`
`),i=[],r=Math.max(e-6,0),s=Math.min(e+6,t.length);for(let o=r;o<s;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var oy=new st;function SE(n){vt._getMatrix(oy,vt.workingColorSpace,n);let e=`mat3( ${oy.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case ol:return[e,"LinearTransferOETF"];case Lt:return[e,"sRGBTransferOETF"];default:return et("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function ay(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),s=(n.getShaderInfoLog(e)||"").trim();if(i&&s==="")return"";let o=/ERROR: 0:(\d+)/.exec(s);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+s+`

`+wE(n.getShaderSource(e),a)}else return s}function AE(n,e){let t=SE(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ME={[If]:"Linear",[Lf]:"Reinhard",[Ff]:"Cineon",[Nf]:"ACESFilmic",[Df]:"AgX",[Uf]:"Neutral",[Bf]:"Custom"};function TE(n,e){let t=ME[e];return t===void 0?(et("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var bh=new Y;function EE(){vt.getLuminanceCoefficients(bh);let n=bh.x.toFixed(4),e=bh.y.toFixed(4),t=bh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function CE(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ul).join(`
`)}function RE(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function PE(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let r=0;r<i;r++){let s=n.getActiveAttrib(e,r),o=s.name,a=1;s.type===n.FLOAT_MAT2&&(a=2),s.type===n.FLOAT_MAT3&&(a=3),s.type===n.FLOAT_MAT4&&(a=4),t[o]={type:s.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ul(n){return n!==""}function ly(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function cy(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var IE=/^[ \t]*#include +<([\w\d./]+)>/gm;function op(n){return n.replace(IE,LE)}function LE(n,e){let t=mt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return op(t)}var FE=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function uy(n){return n.replace(FE,NE)}function NE(n,e,t,i){let r="";for(let s=parseInt(e);s<parseInt(t);s++)r+=i.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return r}function hy(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var BE={[Xs]:"SHADOWMAP_TYPE_PCF",[sa]:"SHADOWMAP_TYPE_VSM"};function DE(n){return BE[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var UE={[aa]:"ENVMAP_MODE_REFRACTION"};function OE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":UE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kE={[El]:"ENVMAP_BLENDING_MULTIPLY",[Ex]:"ENVMAP_BLENDING_MIX",[Cx]:"ENVMAP_BLENDING_ADD"};function zE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kE[n.combine]||"ENVMAP_BLENDING_NONE"}function VE(n,e,t,i){let r=n.getContext(),s=t.defines,o=t.vertexShader,a=t.fragmentShader,l=DE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=OE(t),h=zE(t),d=CE(t),f=RE(s),m=r.createProgram(),b,g,p=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ul).join(`
`),b.length>0&&(b+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Ul).join(`
`),g.length>0&&(g+=`
`)):(b=[hy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ul).join(`
`),g=[hy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+h:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Sr?"#define TONE_MAPPING":"",t.toneMapping!==Sr?mt.tonemapping_pars_fragment:"",t.toneMapping!==Sr?TE("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",mt.colorspace_pars_fragment,AE("linearToOutputTexel",t.outputColorSpace),EE(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ul).join(`
`)),o=op(o),o=ly(o,t),o=cy(o,t),a=op(a),a=ly(a,t),a=cy(a,t),o=uy(o),a=uy(a),t.isRawShaderMaterial!==!0&&(p=`#version 300 es
`,b=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,g=["#define varying in",t.glslVersion===Kf?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Kf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=p+b+o,T=p+g+a,w=sy(r,r.VERTEX_SHADER,_),C=sy(r,r.FRAGMENT_SHADER,T);r.attachShader(m,w),r.attachShader(m,C),t.index0AttributeName!==void 0?r.bindAttribLocation(m,0,t.index0AttributeName):t.hasPositionAttribute===!0&&r.bindAttribLocation(m,0,"position"),r.linkProgram(m);function E(N){if(n.debug.checkShaderErrors){let I=r.getProgramInfoLog(m)||"",U=r.getShaderInfoLog(w)||"",H=r.getShaderInfoLog(C)||"",L=I.trim(),V=U.trim(),W=H.trim(),z=!0,ae=!0;if(r.getProgramParameter(m,r.LINK_STATUS)===!1)if(z=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(r,m,w,C);else{let X=ay(r,w,"vertex"),J=ay(r,C,"fragment");rt("WebGLProgram: Shader Error "+r.getError()+" - VALIDATE_STATUS "+r.getProgramParameter(m,r.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+L+`
`+X+`
`+J)}else L!==""?et("WebGLProgram: Program Info Log:",L):(V===""||W==="")&&(ae=!1);ae&&(N.diagnostics={runnable:z,programLog:L,vertexShader:{log:V,prefix:b},fragmentShader:{log:W,prefix:g}})}r.deleteShader(w),r.deleteShader(C),x=new ca(r,m),M=PE(r,m)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let M;this.getAttributes=function(){return M===void 0&&E(this),M};let O=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=r.getProgramParameter(m,bE)),O},this.destroy=function(){i.releaseStatesOfProgram(this),r.deleteProgram(m),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=vE++,this.cacheKey=e,this.usedTimes=1,this.program=m,this.vertexShader=w,this.fragmentShader=C,this}var HE=0,ap=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let r=this._getShaderCacheForMaterial(e);return r.has(t)===!1&&(r.add(t),t.usedTimes++),r.has(i)===!1&&(r.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new lp(e),t.set(e,i)),i}},lp=class{constructor(e){this.id=HE++,this.code=e,this.usedTimes=0}};function GE(n){return n===Ms||n===Fl||n===Nl}function WE(n,e,t,i,r,s){let o=new ul,a=new ap,l=new Set,c=[],u=new Map,h=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(x){return l.add(x),x===0?"uv":`uv${x}`}function m(x,M,O,N,I,U){let H=N.fog,L=I.geometry,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?N.environment:null,W=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,z=e.get(x.envMap||V,W),ae=d[x.type],X=i.precision;x.precision!==null&&(X=i.getMaxPrecision(x.precision),X!==x.precision&&et("WebGLProgram.getParameters:",x.precision,"not supported, using",X,"instead."));let J=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ee=J!==void 0?J.length:0,ue=0;L.morphAttributes.position!==void 0&&(ue=1),L.morphAttributes.normal!==void 0&&(ue=2),L.morphAttributes.color!==void 0&&(ue=3);let he,Q,ge,be;if(ae){let Ie=Mr[ae];he=Ie.vertexShader,Q=Ie.fragmentShader}else{he=x.vertexShader,Q=x.fragmentShader;let Ie=a.getVertexShaderStage(x),ut=a.getFragmentShaderStage(x);a.update(x,Ie,ut),ge=Ie.id,be=ut.id}let Pe=n.getRenderTarget(),Ae=n.state.buffers.depth.getReversed(),$e=I.isInstancedMesh===!0,lt=I.isBatchedMesh===!0,qe=!!x.map,gt=!!x.matcap,ft=!!z,ot=ft&&z.isPMREMTexture===!0,Jt=!!x.aoMap,Wt=!!x.lightMap,pn=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,Pn=!!x.displacementMap,Tt=!!x.emissiveMap,An=!!x.metalnessMap,sn=!!x.roughnessMap,mn=x.anisotropy>0,D=x.clearcoat>0,Le=x.diffuseRoughness>0,Je=x.dispersion>0,ct=x.retroreflectivity>0,Me=x.iridescence>0,Vt=x.sheen>0,Ge=x.transmission>0,Ke=mn&&!!x.anisotropyMap,R=D&&!!x.clearcoatMap,v=D&&!!x.clearcoatNormalMap,q=D&&!!x.clearcoatRoughnessMap,de=Le&&!!x.diffuseRoughnessMap,oe=Me&&!!x.iridescenceMap,ye=Me&&!!x.iridescenceThicknessMap,ve=Vt&&!!x.sheenColorMap,te=Vt&&!!x.sheenRoughnessMap,ie=!!x.specularMap,me=!!x.specularColorMap,B=!!x.specularIntensityMap,re=Ge&&!!x.transmissionMap,ne=Ge&&!!x.thicknessMap,Te=!!x.gradientMap,xe=!!x.alphaMap,Se=x.alphaTest>0,Xe=!!x.alphaHash,tt=!!x.extensions,ce=Sr;x.toneMapped&&(Pe===null||Pe.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze=ot?z.isCompressedCubeTexture?z.image[0].mipmaps:z.mipmaps:null,nt={shaderID:ae,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:Q,defines:x.defines,customVertexShaderID:ge,customFragmentShaderID:be,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:X,batching:lt,batchingColor:lt&&I._colorsTexture!==null,instancing:$e,instancingColor:$e&&I.instanceColor!==null,instancingMorph:$e&&I.morphTexture!==null,outputColorSpace:Pe===null?n.outputColorSpace:Pe.isXRRenderTarget===!0?Pe.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:qe,matcap:gt,envMap:ft,envMapMode:ft&&z.mapping,envMapPMREM:ot,envMapMaxLod:ot?ze.length-1:null,envMapSize:ot?ze[0].width:null,aoMap:Jt,lightMap:Wt,bumpMap:pn,normalMap:Ot,displacementMap:Pn,emissiveMap:Tt,normalMapObjectSpace:Ot&&x.normalMapType===Ix,normalMapTangentSpace:Ot&&x.normalMapType===Bl,packedNormalMap:Ot&&x.normalMapType===Bl&&GE(x.normalMap.format),metalnessMap:An,roughnessMap:sn,anisotropy:mn,anisotropyMap:Ke,clearcoat:D,clearcoatMap:R,clearcoatNormalMap:v,clearcoatRoughnessMap:q,diffuseRoughness:Le,diffuseRoughnessMap:de,dispersion:Je,retroreflection:ct,iridescence:Me,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:Vt,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:ie,specularColorMap:me,specularIntensityMap:B,transmission:Ge,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:x.transparent===!1&&x.blending===oa&&x.alphaToCoverage===!1,alphaMap:xe,alphaTest:Se,alphaHash:Xe,combine:x.combine,mapUv:qe&&f(x.map.channel),aoMapUv:Jt&&f(x.aoMap.channel),lightMapUv:Wt&&f(x.lightMap.channel),bumpMapUv:pn&&f(x.bumpMap.channel),normalMapUv:Ot&&f(x.normalMap.channel),displacementMapUv:Pn&&f(x.displacementMap.channel),emissiveMapUv:Tt&&f(x.emissiveMap.channel),metalnessMapUv:An&&f(x.metalnessMap.channel),roughnessMapUv:sn&&f(x.roughnessMap.channel),anisotropyMapUv:Ke&&f(x.anisotropyMap.channel),clearcoatMapUv:R&&f(x.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&f(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&f(x.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&f(x.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&f(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&f(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&f(x.sheenRoughnessMap.channel),specularMapUv:ie&&f(x.specularMap.channel),specularColorMapUv:me&&f(x.specularColorMap.channel),specularIntensityMapUv:B&&f(x.specularIntensityMap.channel),transmissionMapUv:re&&f(x.transmissionMap.channel),thicknessMapUv:ne&&f(x.thicknessMap.channel),alphaMapUv:xe&&f(x.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Ot||mn),vertexNormals:!!L.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!L.attributes.uv&&(qe||xe),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||L.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Ae,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:ue,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:U.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&O.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:qe&&x.map.isVideoTexture===!0&&vt.getTransfer(x.map.colorSpace)===Lt,decodeVideoTextureEmissive:Tt&&x.emissiveMap.isVideoTexture===!0&&vt.getTransfer(x.emissiveMap.colorSpace)===Lt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Fi,flipSided:x.side===fn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:tt&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&x.extensions.multiDraw===!0||lt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function b(x){let M=[];if(x.shaderID?M.push(x.shaderID):(M.push(x.customVertexShaderID),M.push(x.customFragmentShaderID)),x.defines!==void 0)for(let O in x.defines)M.push(O),M.push(x.defines[O]);return x.isRawShaderMaterial===!1&&(g(M,x),p(M,x),M.push(n.outputColorSpace)),M.push(x.customProgramCacheKey),M.join()}function g(x,M){x.push(M.precision),x.push(M.outputColorSpace),x.push(M.envMapMode),x.push(M.envMapPMREM),x.push(M.envMapMaxLod),x.push(M.envMapSize),x.push(M.mapUv),x.push(M.alphaMapUv),x.push(M.lightMapUv),x.push(M.aoMapUv),x.push(M.bumpMapUv),x.push(M.normalMapUv),x.push(M.displacementMapUv),x.push(M.emissiveMapUv),x.push(M.metalnessMapUv),x.push(M.roughnessMapUv),x.push(M.anisotropyMapUv),x.push(M.clearcoatMapUv),x.push(M.clearcoatNormalMapUv),x.push(M.clearcoatRoughnessMapUv),x.push(M.diffuseRoughnessMapUv),x.push(M.iridescenceMapUv),x.push(M.iridescenceThicknessMapUv),x.push(M.sheenColorMapUv),x.push(M.sheenRoughnessMapUv),x.push(M.specularMapUv),x.push(M.specularColorMapUv),x.push(M.specularIntensityMapUv),x.push(M.transmissionMapUv),x.push(M.thicknessMapUv),x.push(M.combine),x.push(M.fogExp2),x.push(M.sizeAttenuation),x.push(M.morphTargetsCount),x.push(M.numSunLights),x.push(M.numDirLights),x.push(M.numPointLights),x.push(M.numSpotLights),x.push(M.numSpotLightMaps),x.push(M.numHemiLights),x.push(M.numRectAreaLights),x.push(M.numSunLightShadows),x.push(M.numDirLightShadows),x.push(M.numPointLightShadows),x.push(M.numSpotLightShadows),x.push(M.numSpotLightShadowsWithMaps),x.push(M.numLightProbes),x.push(M.numLightProbeGrids),x.push(M.shadowMapType),x.push(M.toneMapping),x.push(M.numClippingPlanes),x.push(M.numClipIntersection),x.push(M.depthPacking)}function p(x,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function _(x){let M=d[x.type],O;if(M){let N=Mr[M];O=Xx.clone(N.uniforms)}else O=x.uniforms;return O}function T(x,M){let O=u.get(M);return O!==void 0?++O.usedTimes:(O=new VE(n,M,x,r),c.push(O),u.set(M,O)),O}function w(x){if(--x.usedTimes===0){let M=c.indexOf(x);c[M]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function C(x){a.remove(x)}function E(){a.dispose()}return{getParameters:m,getProgramCacheKey:b,getUniforms:_,acquireProgram:T,releaseProgram:w,releaseShaderCache:C,programs:c,dispose:E}}function qE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function r(o,a,l){n.get(o)[a]=l}function s(){n=new WeakMap}return{has:e,get:t,remove:i,update:r,dispose:s}}function XE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function dy(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function fy(){let n=[],e=0,t=[],i=[],r=[];function s(){e=0,t.length=0,i.length=0,r.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,m,b,g,p){let _=n[e];return _===void 0?(_={id:d.id,object:d,geometry:f,material:m,materialVariant:o(d),groupOrder:b,renderOrder:d.renderOrder,z:g,group:p},n[e]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=m,_.materialVariant=o(d),_.groupOrder=b,_.renderOrder=d.renderOrder,_.z=g,_.group=p),e++,_}function l(d,f,m,b,g,p,_){_.reversedDepth===!0&&(g=-g);let T=a(d,f,m,b,g,p);m.transmission>0?i.push(T):m.transparent===!0?r.push(T):t.push(T)}function c(d,f,m,b,g,p){let _=a(d,f,m,b,g,p);m.transmission>0?i.unshift(_):m.transparent===!0?r.unshift(_):t.unshift(_)}function u(d,f){t.length>1&&t.sort(d||XE),i.length>1&&i.sort(f||dy),r.length>1&&r.sort(f||dy)}function h(){for(let d=e,f=n.length;d<f;d++){let m=n[d];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:t,transmissive:i,transparent:r,init:s,push:l,unshift:c,finish:h,sort:u}}function $E(){let n=new WeakMap;function e(i,r){let s=n.get(i),o;return s===void 0?(o=new fy,n.set(i,[o])):r>=s.length?(o=new fy,s.push(o)):o=s[r],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function YE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new Y,color:new je};break;case"SpotLight":t={position:new Y,direction:new Y,color:new je,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new Y,color:new je,distance:0,decay:0};break;case"HemisphereLight":t={direction:new Y,skyColor:new je,groundColor:new je};break;case"RectAreaLight":t={color:new je,position:new Y,halfWidth:new Y,halfHeight:new Y};break}return n[e.id]=t,t}}}function ZE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new dt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var KE=0;function JE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function jE(n){let e=new YE,t=ZE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new Y);let r=new Y,s=new en,o=new en;function a(c){let u=0,h=0,d=0;for(let U=0;U<9;U++)i.probe[U].set(0,0,0);let f=0,m=0,b=0,g=0,p=0,_=0,T=0,w=0,C=0,E=0,x=0,M=0,O=0,N=0;c.sort(JE);for(let U=0,H=c.length;U<H;U++){let L=c[U],V=L.color,W=L.intensity,z=L.distance,ae=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===Ms?ae=L.shadow.map.texture:ae=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=V.r*W,h+=V.g*W,d+=V.b*W;else if(L.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(L.sh.coefficients[X],W);N++}else if(L.isSunLight){let X=e.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let J=L.shadow,ee=t.get(L);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize.copy(J.mapSize).multiply(J.getFrameExtents()),i.sunShadow[m]=ee,i.sunShadowMap[m]=ae;let ue=J.getViewportCount();for(let he=0;he<ue;he++)i.sunShadowMatrix[b+he]=J.getMatrix(he),i.sunShadowCascade[b+he]=J._cascadeData[he];b+=ue,m++}i.sun[f]=X,f++}else if(L.isDirectionalLight){let X=e.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let J=L.shadow,ee=t.get(L);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,i.directionalShadow[g]=ee,i.directionalShadowMap[g]=ae,i.directionalShadowMatrix[g]=L.shadow.matrix,C++}i.directional[g]=X,g++}else if(L.isSpotLight){let X=e.get(L);X.position.setFromMatrixPosition(L.matrixWorld),X.color.copy(V).multiplyScalar(W),X.distance=z,X.coneCos=Math.cos(L.angle),X.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),X.decay=L.decay,i.spot[_]=X;let J=L.shadow;if(L.map&&(i.spotLightMap[M]=L.map,M++,J.updateMatrices(L),L.castShadow&&O++),i.spotLightMatrix[_]=J.matrix,L.castShadow){let ee=t.get(L);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,i.spotShadow[_]=ee,i.spotShadowMap[_]=ae,x++}_++}else if(L.isRectAreaLight){let X=e.get(L);X.color.copy(V).multiplyScalar(W),X.halfWidth.set(L.width*.5,0,0),X.halfHeight.set(0,L.height*.5,0),i.rectArea[T]=X,T++}else if(L.isPointLight){let X=e.get(L);if(X.color.copy(L.color).multiplyScalar(L.intensity),X.distance=L.distance,X.decay=L.decay,L.castShadow){let J=L.shadow,ee=t.get(L);ee.shadowIntensity=J.intensity,ee.shadowBias=J.bias,ee.shadowNormalBias=J.normalBias,ee.shadowRadius=J.radius,ee.shadowMapSize=J.mapSize,ee.shadowCameraNear=J.camera.near,ee.shadowCameraFar=J.camera.far,i.pointShadow[p]=ee,i.pointShadowMap[p]=ae,i.pointShadowMatrix[p]=L.shadow.matrix,E++}i.point[p]=X,p++}else if(L.isHemisphereLight){let X=e.get(L);X.skyColor.copy(L.color).multiplyScalar(W),X.groundColor.copy(L.groundColor).multiplyScalar(W),i.hemi[w]=X,w++}}T>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Be.LTC_FLOAT_1,i.rectAreaLTC2=Be.LTC_FLOAT_2):(i.rectAreaLTC1=Be.LTC_HALF_1,i.rectAreaLTC2=Be.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=h,i.ambient[2]=d;let I=i.hash;(I.sunLength!==f||I.directionalLength!==g||I.pointLength!==p||I.spotLength!==_||I.rectAreaLength!==T||I.hemiLength!==w||I.numSunShadows!==m||I.numDirectionalShadows!==C||I.numPointShadows!==E||I.numSpotShadows!==x||I.numSpotMaps!==M||I.numLightProbes!==N)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=T,i.point.length=p,i.hemi.length=w,i.sunShadow.length=m,i.sunShadowMap.length=m,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=C,i.directionalShadowMap.length=C,i.directionalShadowMatrix.length=C,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+M-O,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=N,I.sunLength=f,I.directionalLength=g,I.pointLength=p,I.spotLength=_,I.rectAreaLength=T,I.hemiLength=w,I.numSunShadows=m,I.numDirectionalShadows=C,I.numPointShadows=E,I.numSpotShadows=x,I.numSpotMaps=M,I.numLightProbes=N,i.version=KE++)}function l(c,u){let h=0,d=0,f=0,m=0,b=0,g=0,p=u.matrixWorldInverse;for(let _=0,T=c.length;_<T;_++){let w=c[_];if(w.isSunLight){let C=i.sun[h];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(p),h++}else if(w.isDirectionalLight){let C=i.directional[d];C.direction.setFromMatrixPosition(w.matrixWorld),r.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(p),d++}else if(w.isSpotLight){let C=i.spot[m];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(p),C.direction.setFromMatrixPosition(w.matrixWorld),r.setFromMatrixPosition(w.target.matrixWorld),C.direction.sub(r),C.direction.transformDirection(p),m++}else if(w.isRectAreaLight){let C=i.rectArea[b];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(p),o.identity(),s.copy(w.matrixWorld),s.premultiply(p),o.extractRotation(s),C.halfWidth.set(w.width*.5,0,0),C.halfHeight.set(0,w.height*.5,0),C.halfWidth.applyMatrix4(o),C.halfHeight.applyMatrix4(o),b++}else if(w.isPointLight){let C=i.point[f];C.position.setFromMatrixPosition(w.matrixWorld),C.position.applyMatrix4(p),f++}else if(w.isHemisphereLight){let C=i.hemi[g];C.direction.setFromMatrixPosition(w.matrixWorld),C.direction.transformDirection(p),g++}}}return{setup:a,setupView:l,state:i}}function py(n){let e=new jE(n),t=[],i=[],r=[];function s(h){u.camera=h,t.length=0,i.length=0,r.length=0}function o(h){h.isLightProbeGrid?r.push(h):t.push(h)}function a(h){i.push(h)}function l(){e.setup(t),r.sort((h,d)=>h.priority-d.priority||h.id-d.id)}function c(h){e.setupView(t,h)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:r,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QE(n){let e=new WeakMap;function t(r,s=0){let o=e.get(r),a;return o===void 0?(a=new py(n),e.set(r,[a])):s>=o.length?(a=new py(n),o.push(a)):a=o[s],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var eC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,tC=`uniform sampler2D shadow_pass;
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
}`,nC=[new Y(1,0,0),new Y(-1,0,0),new Y(0,1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1)],iC=[new Y(0,-1,0),new Y(0,-1,0),new Y(0,0,1),new Y(0,0,-1),new Y(0,-1,0),new Y(0,-1,0)],my=new en,Dl=new Y,np=new Y;function rC(n,e,t){let i=new bs,r=new dt,s=new dt,o=new tn,a=new _u,l=new bu,c={},u=t.maxTextureSize,h={[ci]:fn,[fn]:ci,[Fi]:Fi},d=new li({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new dt},radius:{value:4}},vertexShader:eC,fragmentShader:tC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let m=new Vn;m.setAttribute("position",new dn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Et(m,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xs;let p=this.type;this.render=function(E,x,M){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===lx&&(et("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Xs);let O=n.getRenderTarget(),N=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),U=n.state;U.setBlending($s),U.buffers.depth.getReversed()===!0?U.buffers.color.setClear(0,0,0,0):U.buffers.color.setClear(1,1,1,1),U.buffers.depth.setTest(!0),U.setScissorTest(!1);let H=p!==this.type;H&&x.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(V=>V.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,V=E.length;L<V;L++){let W=E[L],z=W.shadow;if(z===void 0){et("WebGLShadowMap:",W,"has no shadow.");continue}if(z.autoUpdate===!1&&z.needsUpdate===!1)continue;r.copy(z.mapSize);let ae=z.getFrameExtents();r.multiply(ae),s.copy(z.mapSize),(r.x>u||r.y>u)&&(r.x>u&&(s.x=Math.floor(u/ae.x),r.x=s.x*ae.x,z.mapSize.x=s.x),r.y>u&&(s.y=Math.floor(u/ae.y),r.y=s.y*ae.y,z.mapSize.y=s.y));let X=n.state.buffers.depth.getReversed();if(z.camera._reversedDepth=X,z.map===null||H===!0){if(z.map!==null&&(z.map.depthTexture!==null&&(z.map.depthTexture.dispose(),z.map.depthTexture=null),z.map.dispose()),this.type===sa){if(W.isPointLight){et("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}z.map=new bi(r.x,r.y,{format:Ms,type:Yi,minFilter:ii,magFilter:ii,generateMipmaps:!1}),z.map.texture.name=W.name+".shadowMap",z.map.depthTexture=new Hr(r.x,r.y,$i),z.map.depthTexture.name=W.name+".shadowMapDepth",z.map.depthTexture.format=Vr,z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=On,z.map.depthTexture.magFilter=On}else W.isPointLight?(z.map=new Ol(r.x),z.map.depthTexture=new xl(r.x,Xi)):(z.map=new bi(r.x,r.y),z.map.depthTexture=new Hr(r.x,r.y,Xi)),z.map.depthTexture.name=W.name+".shadowMap",z.map.depthTexture.format=Vr,this.type===Xs?(z.map.depthTexture.compareFunction=X?$f:Xf,z.map.depthTexture.minFilter=ii,z.map.depthTexture.magFilter=ii):(z.map.depthTexture.compareFunction=null,z.map.depthTexture.minFilter=On,z.map.depthTexture.magFilter=On);z.camera.updateProjectionMatrix()}z.map.isWebGLCubeRenderTarget!==!0&&(z.map.width!==r.x||z.map.height!==r.y)&&z.map.setSize(r.x,r.y);let J=z.map.isWebGLCubeRenderTarget?6:z.getViewportCount();W.isPointLight!==!0&&z.updateMatrices(W,M);let ee=(z.camera.layers.mask&4294967294)!==0?z.camera.layers:M.layers;for(let ue=0;ue<J;ue++){let he=z.getCamera(ue);if(W.isPointLight){let Q=z.camera,ge=z.matrix,be=W.distance||Q.far;be!==Q.far&&(Q.far=be,Q.updateProjectionMatrix()),Dl.setFromMatrixPosition(W.matrixWorld),Q.position.copy(Dl),np.copy(Q.position),np.add(nC[ue]),Q.up.copy(iC[ue]),Q.lookAt(np),Q.updateMatrixWorld(),ge.makeTranslation(-Dl.x,-Dl.y,-Dl.z),my.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),z._frustum.setFromProjectionMatrix(my,Q.coordinateSystem,Q.reversedDepth)}if(z.map.isWebGLCubeRenderTarget)n.setRenderTarget(z.map,ue),n.clear();else{ue===0&&(n.setRenderTarget(z.map),n.clear());let Q=z.getViewport(ue);o.set(s.x*Q.x,s.y*Q.y,s.x*Q.z,s.y*Q.w),U.viewport(o)}i=z.getFrustum(ue),w(x,M,he,W,ee,this.type)}z.isPointLightShadow!==!0&&this.type===sa&&_(z,M),z.needsUpdate=!1}p=this.type,g.needsUpdate=!1,n.setRenderTarget(O,N,I)};function _(E,x){let M=e.update(b);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new bi(r.x,r.y,{format:Ms,type:Yi}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(x,null,M,d,b,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(x,null,M,f,b,null)}function T(E,x,M,O){let N=null,I=M.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(I!==void 0)N=I;else if(N=M.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let U=N.uuid,H=x.uuid,L=c[U];L===void 0&&(L={},c[U]=L);let V=L[H];V===void 0&&(V=N.clone(),L[H]=V,x.addEventListener("dispose",C)),N=V}if(N.visible=x.visible,N.wireframe=x.wireframe,O===sa?N.side=x.shadowSide!==null?x.shadowSide:x.side:N.side=x.shadowSide!==null?x.shadowSide:h[x.side],N.alphaMap=x.alphaMap,N.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,N.map=x.map,N.clipShadows=x.clipShadows,N.clippingPlanes=x.clippingPlanes,N.clipIntersection=x.clipIntersection,N.displacementMap=x.displacementMap,N.displacementScale=x.displacementScale,N.displacementBias=x.displacementBias,N.wireframeLinewidth=x.wireframeLinewidth,N.linewidth=x.linewidth,M.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let U=n.properties.get(N);U.light=M}return N}function w(E,x,M,O,N,I){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&I===sa)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,E.matrixWorld);let L=e.update(E),V=E.material;if(Array.isArray(V)){let W=L.groups;for(let z=0,ae=W.length;z<ae;z++){let X=W[z],J=V[X.materialIndex];if(J&&J.visible){let ee=T(E,J,O,I);E.onBeforeShadow(n,E,x,M,L,ee,X),n.renderBufferDirect(M,null,L,ee,E,X),E.onAfterShadow(n,E,x,M,L,ee,X)}}}else if(V.visible){let W=T(E,V,O,I);E.onBeforeShadow(n,E,x,M,L,W,null),n.renderBufferDirect(M,null,L,W,E,null),E.onAfterShadow(n,E,x,M,L,W,null)}}let H=E.children;for(let L=0,V=H.length;L<V;L++)w(H[L],x,M,O,N,I)}function C(E){E.target.removeEventListener("dispose",C);for(let M in c){let O=c[M],N=E.target.uuid;N in O&&(O[N].dispose(),delete O[N])}}}function sC(n,e){function t(){let B=!1,re=new tn,ne=null,Te=new tn(0,0,0,0);return{setMask:function(xe){ne!==xe&&!B&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){B=xe},setClear:function(xe,Se,Xe,tt,ce){ce===!0&&(xe*=tt,Se*=tt,Xe*=tt),re.set(xe,Se,Xe,tt),Te.equals(re)===!1&&(n.clearColor(xe,Se,Xe,tt),Te.copy(re))},reset:function(){B=!1,ne=null,Te.set(-1,0,0,0)}}}function i(){let B=!1,re=!1,ne=null,Te=null,xe=null;return{setReversed:function(Se){if(re!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let tt=xe;xe=null,this.setClear(tt)}},getReversed:function(){return re},setTest:function(Se){Se?Ae(n.DEPTH_TEST):$e(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!B&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(re&&(Se=Vx[Se]),Te!==Se){switch(Se){case tu:n.depthFunc(n.NEVER);break;case nu:n.depthFunc(n.ALWAYS);break;case iu:n.depthFunc(n.LESS);break;case Jo:n.depthFunc(n.LEQUAL);break;case ru:n.depthFunc(n.EQUAL);break;case su:n.depthFunc(n.GEQUAL);break;case ou:n.depthFunc(n.GREATER);break;case au:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=Se}},setLocked:function(Se){B=Se},setClear:function(Se){xe!==Se&&(xe=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){B=!1,ne=null,Te=null,xe=null,re=!1}}}function r(){let B=!1,re=null,ne=null,Te=null,xe=null,Se=null,Xe=null,tt=null,ce=null;return{setTest:function(ze){B||(ze?Ae(n.STENCIL_TEST):$e(n.STENCIL_TEST))},setMask:function(ze){re!==ze&&!B&&(n.stencilMask(ze),re=ze)},setFunc:function(ze,nt,Ie){(ne!==ze||Te!==nt||xe!==Ie)&&(n.stencilFunc(ze,nt,Ie),ne=ze,Te=nt,xe=Ie)},setOp:function(ze,nt,Ie){(Se!==ze||Xe!==nt||tt!==Ie)&&(n.stencilOp(ze,nt,Ie),Se=ze,Xe=nt,tt=Ie)},setLocked:function(ze){B=ze},setClear:function(ze){ce!==ze&&(n.clearStencil(ze),ce=ze)},reset:function(){B=!1,re=null,ne=null,Te=null,xe=null,Se=null,Xe=null,tt=null,ce=null}}}let s=new t,o=new i,a=new r,l={},c=new WeakMap,u={},h={},d={},f=new WeakMap,m=[],b=null,g=!1,p=null,_=null,T=null,w=null,C=null,E=null,x=null,M=new je(0,0,0),O=0,N=!1,I=null,U=null,H=null,L=null,V=null,W=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),z=!1,ae=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(X)[1]),z=ae>=1):X.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),z=ae>=2);let J=null,ee={},ue=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),Q=new tn().fromArray(ue),ge=new tn().fromArray(he);function be(B,re,ne,Te){let xe=new Uint8Array(4),Se=n.createTexture();n.bindTexture(B,Se),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ne;Xe++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Se}let Pe={};Pe[n.TEXTURE_2D]=be(n.TEXTURE_2D,n.TEXTURE_2D,1),Pe[n.TEXTURE_CUBE_MAP]=be(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Pe[n.TEXTURE_2D_ARRAY]=be(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Pe[n.TEXTURE_3D]=be(n.TEXTURE_3D,n.TEXTURE_3D,1,1),s.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Ae(n.DEPTH_TEST),o.setFunc(Jo),pn(!1),Ot(Mf),Ae(n.CULL_FACE),Jt($s);function Ae(B){u[B]!==!0&&(n.enable(B),u[B]=!0)}function $e(B){u[B]!==!1&&(n.disable(B),u[B]=!1)}function lt(B,re){return d[B]!==re?(n.bindFramebuffer(B,re),d[B]=re,B===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=re),B===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=re),!0):!1}function qe(B,re){let ne=m,Te=!1;if(B){ne=f.get(re),ne===void 0&&(ne=[],f.set(re,ne));let xe=B.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Xe=xe.length;Se<Xe;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=xe.length,Te=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ne)}function gt(B){return b!==B?(n.useProgram(B),b=B,!0):!1}let ft={[Ys]:n.FUNC_ADD,[ux]:n.FUNC_SUBTRACT,[hx]:n.FUNC_REVERSE_SUBTRACT};ft[dx]=n.MIN,ft[fx]=n.MAX;let ot={[px]:n.ZERO,[mx]:n.ONE,[gx]:n.SRC_COLOR,[Rf]:n.SRC_ALPHA,[wx]:n.SRC_ALPHA_SATURATE,[bx]:n.DST_COLOR,[yx]:n.DST_ALPHA,[xx]:n.ONE_MINUS_SRC_COLOR,[Pf]:n.ONE_MINUS_SRC_ALPHA,[vx]:n.ONE_MINUS_DST_COLOR,[_x]:n.ONE_MINUS_DST_ALPHA,[Sx]:n.CONSTANT_COLOR,[Ax]:n.ONE_MINUS_CONSTANT_COLOR,[Mx]:n.CONSTANT_ALPHA,[Tx]:n.ONE_MINUS_CONSTANT_ALPHA};function Jt(B,re,ne,Te,xe,Se,Xe,tt,ce,ze){if(B===$s){g===!0&&($e(n.BLEND),g=!1);return}if(g===!1&&(Ae(n.BLEND),g=!0),B!==cx){if(B!==p||ze!==N){if((_!==Ys||C!==Ys)&&(n.blendEquation(n.FUNC_ADD),_=Ys,C=Ys),ze)switch(B){case oa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tf:n.blendFunc(n.ONE,n.ONE);break;case Ef:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Cf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:rt("WebGLState: Invalid blending: ",B);break}else switch(B){case oa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Tf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Ef:rt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Cf:rt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:rt("WebGLState: Invalid blending: ",B);break}T=null,w=null,E=null,x=null,M.set(0,0,0),O=0,p=B,N=ze}return}xe=xe||re,Se=Se||ne,Xe=Xe||Te,(re!==_||xe!==C)&&(n.blendEquationSeparate(ft[re],ft[xe]),_=re,C=xe),(ne!==T||Te!==w||Se!==E||Xe!==x)&&(n.blendFuncSeparate(ot[ne],ot[Te],ot[Se],ot[Xe]),T=ne,w=Te,E=Se,x=Xe),(tt.equals(M)===!1||ce!==O)&&(n.blendColor(tt.r,tt.g,tt.b,ce),M.copy(tt),O=ce),p=B,N=!1}function Wt(B,re){B.side===Fi?$e(n.CULL_FACE):Ae(n.CULL_FACE);let ne=B.side===fn;re&&(ne=!ne),pn(ne),B.blending===oa&&B.transparent===!1?Jt($s):Jt(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),s.setMask(B.colorWrite);let Te=B.stencilWrite;a.setTest(Te),Te&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),Tt(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Ae(n.SAMPLE_ALPHA_TO_COVERAGE):$e(n.SAMPLE_ALPHA_TO_COVERAGE)}function pn(B){I!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),I=B)}function Ot(B){B!==ox?(Ae(n.CULL_FACE),B!==U&&(B===Mf?n.cullFace(n.BACK):B===ax?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):$e(n.CULL_FACE),U=B}function Pn(B){B!==H&&(z&&n.lineWidth(B),H=B)}function Tt(B,re,ne){B?(Ae(n.POLYGON_OFFSET_FILL),(L!==re||V!==ne)&&(L=re,V=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):$e(n.POLYGON_OFFSET_FILL)}function An(B){B?Ae(n.SCISSOR_TEST):$e(n.SCISSOR_TEST)}function sn(B){B===void 0&&(B=n.TEXTURE0+W-1),J!==B&&(n.activeTexture(B),J=B)}function mn(B,re,ne){ne===void 0&&(J===null?ne=n.TEXTURE0+W-1:ne=J);let Te=ee[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ee[ne]=Te),(Te.type!==B||Te.texture!==re)&&(J!==ne&&(n.activeTexture(ne),J=ne),n.bindTexture(B,re||Pe[B]),Te.type=B,Te.texture=re)}function D(){let B=ee[J];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Le(){try{n.compressedTexImage2D(...arguments)}catch(B){rt("WebGLState:",B)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(B){rt("WebGLState:",B)}}function ct(){try{n.texSubImage2D(...arguments)}catch(B){rt("WebGLState:",B)}}function Me(){try{n.texSubImage3D(...arguments)}catch(B){rt("WebGLState:",B)}}function Vt(){try{n.compressedTexSubImage2D(...arguments)}catch(B){rt("WebGLState:",B)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(B){rt("WebGLState:",B)}}function Ke(){try{n.texStorage2D(...arguments)}catch(B){rt("WebGLState:",B)}}function R(){try{n.texStorage3D(...arguments)}catch(B){rt("WebGLState:",B)}}function v(){try{n.texImage2D(...arguments)}catch(B){rt("WebGLState:",B)}}function q(){try{n.texImage3D(...arguments)}catch(B){rt("WebGLState:",B)}}function de(B){return h[B]!==void 0?h[B]:n.getParameter(B)}function oe(B,re){h[B]!==re&&(n.pixelStorei(B,re),h[B]=re)}function ye(B){Q.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),Q.copy(B))}function ve(B){ge.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),ge.copy(B))}function te(B,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(B);Te===void 0&&(Te=n.getUniformBlockIndex(re,B.name),n.uniformBlockBinding(re,Te,Te),ne.set(B,Te))}function ie(B,re,ne){let xe=c.get(re).get(B);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function me(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},h={},J=null,ee={},d={},l={},f=new WeakMap,m=[],b=null,g=!1,p=null,_=null,T=null,w=null,C=null,E=null,x=null,M=new je(0,0,0),O=0,N=!1,I=null,U=null,H=null,L=null,V=null,Q.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),s.reset(),o.reset(),a.reset()}return{buffers:{color:s,depth:o,stencil:a},enable:Ae,disable:$e,bindFramebuffer:lt,drawBuffers:qe,useProgram:gt,setBlending:Jt,setMaterial:Wt,setFlipSided:pn,setCullFace:Ot,setLineWidth:Pn,setPolygonOffset:Tt,setScissorTest:An,activeTexture:sn,bindTexture:mn,unbindTexture:D,compressedTexImage2D:Le,compressedTexImage3D:Je,texImage2D:v,texImage3D:q,pixelStorei:oe,getParameter:de,updateUBOMapping:te,uniformBlockBinding:ie,texStorage2D:Ke,texStorage3D:R,texSubImage2D:ct,texSubImage3D:Me,compressedTexSubImage2D:Vt,compressedTexSubImage3D:Ge,scissor:ye,viewport:ve,reset:me}}function oC(n,e,t,i,r,s,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new dt,u=new WeakMap,h=new Set,d,f=new WeakMap,m=new Set,b=new FinalizationRegistry(R=>m.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function p(R,v){return g?new OffscreenCanvas(R,v):al("canvas")}function _(R,v,q){let de=1,oe=Ke(R);if((oe.width>q||oe.height>q)&&(de=q/Math.max(oe.width,oe.height)),de<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(de*oe.width),ve=Math.floor(de*oe.height);d===void 0&&(d=p(ye,ve));let te=v?p(ye,ve):d;return te.width=ye,te.height=ve,te.getContext("2d").drawImage(R,0,0,ye,ve),et("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+ve+")."),te}else return"data"in R&&et("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function T(R){return R.generateMipmaps}function w(R){n.generateMipmap(R)}function C(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(R,v,q,de,oe,ye=!1){if(R!==null){if(n[R]!==void 0)return n[R];et("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;de&&(ve=e.get("EXT_texture_norm16"),ve||et("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=v;if(v===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),q===n.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),v===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),v===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),q===n.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),v===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),v===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),v===n.RGB&&(q===n.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),q===n.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),v===n.RGBA){let ie=ye?ol:vt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=ie===Lt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),q===n.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,v){let q;return R?v===null||v===Xi||v===Ks?q=n.DEPTH24_STENCIL8:v===$i?q=n.DEPTH32F_STENCIL8:v===la&&(q=n.DEPTH24_STENCIL8,et("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Xi||v===Ks?q=n.DEPTH_COMPONENT24:v===$i?q=n.DEPTH_COMPONENT32F:v===la&&(q=n.DEPTH_COMPONENT16),q}function M(R,v){return T(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==ii?Math.log2(Math.max(v.width,v.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?v.mipmaps.length:1}function O(R){let v=new WeakRef(R);i.get(R).__ref=v,m.add(v),b.register(R,v,v)}function N(R){let v=i.get(R).__ref;v!==void 0&&(m.delete(v),b.unregister(v))}function I(R){H(R.target)}function U(R){L(R.target)}function H(R){R.removeEventListener("dispose",I),N(R),W(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&h.delete(R)}function L(R){R.removeEventListener("dispose",U),N(R),ae(R)}function V(){for(let R of m){let v=R.deref();v!==void 0&&(v.isRenderTarget===!0?L(v):H(v))}m.clear(),h.clear()}function W(R){let v=i.get(R);if(v.__webglInit===void 0)return;let q=R.source,de=f.get(q);if(de){let oe=de[v.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&z(R),Object.keys(de).length===0&&f.delete(q)}i.remove(R)}function z(R){let v=i.get(R);n.deleteTexture(v.__webglTexture);let q=R.source,de=f.get(q);delete de[v.__cacheKey],o.memory.textures--}function ae(R){let v=i.get(R);v.__depthDisposeCallback&&v.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&H(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(v.__webglFramebuffer[oe]))for(let ye=0;ye<v.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(v.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(v.__webglFramebuffer[oe]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[oe])}else{if(Array.isArray(v.__webglFramebuffer))for(let oe=0;oe<v.__webglFramebuffer.length;oe++)n.deleteFramebuffer(v.__webglFramebuffer[oe]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let oe=0;oe<v.__webglColorRenderbuffer.length;oe++)v.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[oe]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let de=R.textures;for(let oe=0,ye=de.length;oe<ye;oe++){let ve=i.get(de[oe]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(de[oe])}i.remove(R)}let X=0;function J(){X=0}function ee(){return X}function ue(R){X=R}function he(){let R=X;return R>=r.maxTextures&&et("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+r.maxTextures),X+=1,R}function Q(R){let v=[];return v.push(R.wrapS),v.push(R.wrapT),v.push(R.wrapR||0),v.push(R.magFilter),v.push(R.minFilter),v.push(R.anisotropy),v.push(R.internalFormat),v.push(R.format),v.push(R.type),v.push(R.generateMipmaps),v.push(R.mipmapsAutoUpdate),v.push(R.premultiplyAlpha),v.push(R.flipY),v.push(R.unpackAlignment),v.push(R.colorSpace),v.join()}function ge(R,v){let q=i.get(R);if(R.isVideoTexture&&Vt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let de=R.image;if(de===null)et("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)et("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(q,R,v);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+v)}function be(R,v){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,v);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+v)}function Pe(R,v){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,v);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+v)}function Ae(R,v){let q=i.get(R);if(R.version>0&&q.__version!==R.version){pn(q,R,v);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+v)}let $e={[lu]:n.REPEAT,[_r]:n.CLAMP_TO_EDGE,[cu]:n.MIRRORED_REPEAT},lt={[On]:n.NEAREST,[Rx]:n.NEAREST_MIPMAP_NEAREST,[Cl]:n.NEAREST_MIPMAP_LINEAR,[ii]:n.LINEAR,[Bu]:n.LINEAR_MIPMAP_NEAREST,[$r]:n.LINEAR_MIPMAP_LINEAR},qe={[Fx]:n.NEVER,[Yf]:n.ALWAYS,[Nx]:n.LESS,[Xf]:n.LEQUAL,[Bx]:n.EQUAL,[$f]:n.GEQUAL,[Dx]:n.GREATER,[Ux]:n.NOTEQUAL};function gt(R,v){if(v.type===$i&&e.has("OES_texture_float_linear")===!1&&(v.magFilter===ii||v.magFilter===Bu||v.magFilter===Cl||v.magFilter===$r||v.minFilter===ii||v.minFilter===Bu||v.minFilter===Cl||v.minFilter===$r)&&et("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,$e[v.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,$e[v.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,$e[v.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,lt[v.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,lt[v.minFilter]),v.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,qe[v.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===On||v.minFilter!==Cl&&v.minFilter!==$r||v.type===$i&&e.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,r.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function ft(R,v){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,v.addEventListener("dispose",I),O(v));let de=v.source,oe=f.get(de);oe===void 0&&(oe={},f.set(de,oe));let ye=Q(v);if(ye!==R.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ye].usedTimes++;let ve=oe[R.__cacheKey];ve!==void 0&&(oe[R.__cacheKey].usedTimes--,ve.usedTimes===0&&z(v)),R.__cacheKey=ye,R.__webglTexture=oe[ye].texture}return q}function ot(R,v,q){return Math.floor(Math.floor(R/q)/v)}function Jt(R,v,q,de){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,q,de,v.data);else{ye.sort((B,re)=>B.start-re.start);let ve=0;for(let B=1;B<ye.length;B++){let re=ye[ve],ne=ye[B],Te=re.start+re.count,xe=ot(ne.start,v.width,4),Se=ot(re.start,v.width,4);ne.start<=Te+1&&xe===Se&&ot(ne.start+ne.count-1,v.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++ve,ye[ve]=ne)}ye.length=ve+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),ie=t.getParameter(n.UNPACK_SKIP_PIXELS),me=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let B=0,re=ye.length;B<re;B++){let ne=ye[B],Te=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),Se=Te%v.width,Xe=Math.floor(Te/v.width),tt=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Se,Xe,tt,ce,q,de,v.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,ie),t.pixelStorei(n.UNPACK_SKIP_ROWS,me)}}function Wt(R,v,q){let de=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(de=n.TEXTURE_3D);let oe=ft(R,v),ye=v.source;t.bindTexture(de,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(ye);if(ye.version!==ve.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),ze=v.colorSpace===Zr?null:vt.getPrimaries(v.colorSpace),nt=v.colorSpace===Zr||ce===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let ie=_(v.image,!1,r.maxTextureSize);ie=Ge(v,ie);let me=s.convert(v.format,v.colorSpace),B=s.convert(v.type),re=E(v.internalFormat,me,B,v.normalized,v.colorSpace,v.isVideoTexture);gt(de,v);let ne,Te=v.mipmaps,xe=v.isVideoTexture!==!0,Se=ve.__version===void 0||oe===!0,Xe=ye.dataReady,tt=M(v,ie);if(v.isDepthTexture)re=x(v.format===Yr,v.type),Se&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,ie.width,ie.height):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,me,B,null));else if(v.isDataTexture)if(Te.length>0){xe&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,Te[0].width,Te[0].height);for(let ce=0,ze=Te.length;ce<ze;ce++)ne=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,me,B,ne.data);v.generateMipmaps=!1}else xe?(Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,ie.width,ie.height),Xe&&Jt(v,ie,me,B)):t.texImage2D(n.TEXTURE_2D,0,re,ie.width,ie.height,0,me,B,ie.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){xe&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,Te[0].width,Te[0].height,ie.depth);for(let ce=0,ze=Te.length;ce<ze;ce++)if(ne=Te[ce],v.format!==Zi)if(me!==null)if(xe){if(Xe)if(v.layerUpdates.size>0){let nt=ep(ne.width,ne.height,v.format,v.type);for(let Ie of v.layerUpdates){let ut=ne.data.subarray(Ie*nt/ne.data.BYTES_PER_ELEMENT,(Ie+1)*nt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ie,ne.width,ne.height,1,me,ut)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,ne.data,0,0);else et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,ie.depth,me,B,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,ie.depth,0,me,B,ne.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{xe&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,Te[0].width,Te[0].height);for(let ce=0,ze=Te.length;ce<ze;ce++)ne=Te[ce],v.format!==Zi?me!==null?xe?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,me,B,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,me,B,ne.data)}else if(v.isDataArrayTexture)if(xe){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,ie.width,ie.height,ie.depth),Xe)if(v.layerUpdates.size>0){let ce=ep(ie.width,ie.height,v.format,v.type);for(let ze of v.layerUpdates){let nt=ie.data.subarray(ze*ce/ie.data.BYTES_PER_ELEMENT,(ze+1)*ce/ie.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,ie.width,ie.height,1,me,B,nt)}v.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,ie.width,ie.height,ie.depth,me,B,ie.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,ie.width,ie.height,ie.depth,0,me,B,ie.data);else if(v.isData3DTexture)xe?(Se&&t.texStorage3D(n.TEXTURE_3D,tt,re,ie.width,ie.height,ie.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,ie.width,ie.height,ie.depth,me,B,ie.data)):t.texImage3D(n.TEXTURE_3D,0,re,ie.width,ie.height,ie.depth,0,me,B,ie.data);else if(v.isFramebufferTexture){if(Se)if(xe)t.texStorage2D(n.TEXTURE_2D,tt,re,ie.width,ie.height);else{let ce=ie.width,ze=ie.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,re,ce,ze,0,me,B,null),ce>>=1,ze>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),ie.parentNode!==ce){ce.appendChild(ie),h.add(v),ce.onpaint=ze=>{let nt=ze.changedElements;for(let Ie of h)nt.includes(Ie.image)&&(Ie.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,ie);else{let nt=n.RGBA,Ie=n.RGBA,ut=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Ie,ut,ie)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&Se){let ce=Ke(Te[0]);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}for(let ce=0,ze=Te.length;ce<ze;ce++)ne=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,me,B,ne):t.texImage2D(n.TEXTURE_2D,ce,re,me,B,ne);v.generateMipmaps=!1}else if(xe){if(Se){let ce=Ke(ie);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,me,B,ie)}else t.texImage2D(n.TEXTURE_2D,0,re,me,B,ie);T(v)&&v.mipmapsAutoUpdate===!0&&w(de),ve.__version=ye.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function pn(R,v,q){if(v.image.length!==6)return;let de=ft(R,v),oe=v.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(oe);if(oe.version!==ye.__version||de===!0){t.activeTexture(n.TEXTURE0+q);let ve=vt.getPrimaries(vt.workingColorSpace),te=v.colorSpace===Zr?null:vt.getPrimaries(v.colorSpace),ie=v.colorSpace===Zr||ve===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,ie);let me=v.isCompressedTexture||v.image[0].isCompressedTexture,B=v.image[0]&&v.image[0].isDataTexture,re=[];for(let Ie=0;Ie<6;Ie++)!me&&!B?re[Ie]=_(v.image[Ie],!0,r.maxCubemapSize):re[Ie]=B?v.image[Ie].image:v.image[Ie],re[Ie]=Ge(v,re[Ie]);let ne=re[0],Te=s.convert(v.format,v.colorSpace),xe=s.convert(v.type),Se=E(v.internalFormat,Te,xe,v.normalized,v.colorSpace),Xe=v.isVideoTexture!==!0,tt=ye.__version===void 0||de===!0,ce=oe.dataReady,ze=M(v,ne);gt(n.TEXTURE_CUBE_MAP,v);let nt;if(v.isDepthTexture){if(Se=x(v.format===Yr,v.type),tt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,ne.width,ne.height,0,Te,xe,null)}else if(me){Xe&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,ne.width,ne.height);for(let Ie=0;Ie<6;Ie++){nt=re[Ie].mipmaps;for(let ut=0;ut<nt.length;ut++){let qt=nt[ut];v.format!==Zi?Te!==null?Xe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,qt.width,qt.height,Te,qt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Se,qt.width,qt.height,0,qt.data):et("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,0,0,qt.width,qt.height,Te,xe,qt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut,Se,qt.width,qt.height,0,Te,xe,qt.data)}}}else{if(nt=v.mipmaps,Xe&&tt){nt.length>0&&ze++;let Ie=Ke(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(B){Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,re[Ie].width,re[Ie].height,Te,xe,re[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,re[Ie].width,re[Ie].height,0,Te,xe,re[Ie].data);for(let ut=0;ut<nt.length;ut++){let Zn=nt[ut].image[Ie].image;Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Zn.width,Zn.height,Te,xe,Zn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Se,Zn.width,Zn.height,0,Te,xe,Zn.data)}}else{Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Te,xe,re[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Se,Te,xe,re[Ie]);for(let ut=0;ut<nt.length;ut++){let qt=nt[ut];Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,0,0,Te,xe,qt.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,ut+1,Se,Te,xe,qt.image[Ie])}}}T(v)&&v.mipmapsAutoUpdate===!0&&w(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function Ot(R,v,q,de,oe,ye){let ve=s.convert(q.format,q.colorSpace),te=s.convert(q.type),ie=E(q.internalFormat,ve,te,q.normalized,q.colorSpace),me=i.get(v),B=i.get(q);if(B.__renderTarget=v,!me.__hasExternalTextures){let re=Math.max(1,v.width>>ye),ne=Math.max(1,v.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,ie,re,ne,v.depth,0,ve,te,null):t.texImage2D(oe,ye,ie,re,ne,0,ve,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,oe,B.__webglTexture,0,ct(v)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,oe,B.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Pn(R,v,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),v.depthBuffer){let de=v.depthTexture,oe=de&&de.isDepthTexture?de.type:null,ye=x(v.stencilBuffer,oe),ve=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(v),ye,v.width,v.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(v),ye,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,ye,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let de=v.textures;for(let oe=0;oe<de.length;oe++){let ye=de[oe],ve=s.convert(ye.format,ye.colorSpace),te=s.convert(ye.type),ie=E(ye.internalFormat,ve,te,ye.normalized,ye.colorSpace);Me(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(v),ie,v.width,v.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(v),ie,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,ie,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Tt(R,v,q){let de=v.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(v.depthTexture);oe.__renderTarget=v;let ye=de?v.depthTexture.image[0]:v.depthTexture.image;(!oe.__webglTexture||ye.width!==v.width||ye.height!==v.height)&&(ye.width=v.width,ye.height=v.height,v.depthTexture.needsUpdate=!0),de?Ae(v.depthTexture,0):ge(v.depthTexture,0);let ve=oe.__webglTexture,te=ct(v),ie=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,me=v.depthTexture.format===Yr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===Vr)Me(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ve,0);else if(v.depthTexture.format===Yr)Me(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,me,ie,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,me,ie,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function An(R){let v=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==R.depthTexture){let de=R.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),de){let oe=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,de.removeEventListener("dispose",oe)};de.addEventListener("dispose",oe),v.__depthDisposeCallback=oe}v.__boundDepthTexture=de}if(R.depthTexture&&!v.__autoAllocateDepthBuffer)if(q)for(let de=0;de<6;de++)Tt(v.__webglFramebuffer[de],R,de);else R.texture.mipmaps.length>0?Tt(v.__webglFramebuffer[0],R,0):Tt(v.__webglFramebuffer,R,0);else if(q){v.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[de]),v.__webglDepthbuffer[de]===void 0)v.__webglDepthbuffer[de]=n.createRenderbuffer(),Pn(v.__webglDepthbuffer[de],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=v.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),Pn(v.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function sn(R,v,q){let de=i.get(R);v!==void 0&&Ot(de.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&An(R)}function mn(R){let v=R.texture,q=i.get(R),de=i.get(v);R.addEventListener("dispose",U),O(R);let oe=R.textures,ye=R.isWebGLCubeRenderTarget===!0,ve=oe.length>1;if(ve||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=v.version,o.memory.textures++),ye){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(v.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let ie=0;ie<v.mipmaps.length;ie++)q.__webglFramebuffer[te][ie]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(v.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<v.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ve)for(let te=0,ie=oe.length;te<ie;te++){let me=i.get(oe[te]);me.__webglTexture===void 0&&(me.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let ie=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let me=s.convert(ie.format,ie.colorSpace),B=s.convert(ie.type),re=E(ie.internalFormat,me,B,ie.normalized,ie.colorSpace,R.isXRRenderTarget===!0),ne=ct(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Pn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),gt(n.TEXTURE_CUBE_MAP,v);for(let te=0;te<6;te++)if(v.mipmaps.length>0)for(let ie=0;ie<v.mipmaps.length;ie++)Ot(q.__webglFramebuffer[te][ie],R,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,ie);else Ot(q.__webglFramebuffer[te],R,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);T(v)?w(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,ie=oe.length;te<ie;te++){let me=oe[te],B=i.get(me),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,B.__webglTexture),gt(re,me),Ot(q.__webglFramebuffer,R,me,n.COLOR_ATTACHMENT0+te,re,0),T(me)&&w(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,de.__webglTexture),gt(te,v),v.mipmaps.length>0)for(let ie=0;ie<v.mipmaps.length;ie++)Ot(q.__webglFramebuffer[ie],R,v,n.COLOR_ATTACHMENT0,te,ie);else Ot(q.__webglFramebuffer,R,v,n.COLOR_ATTACHMENT0,te,0);T(v)?w(te):v.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&An(R)}function D(R){let v=R.textures;for(let q=0,de=v.length;q<de;q++){let oe=v[q];if(T(oe)&&oe.mipmapsAutoUpdate===!0){let ye=C(R),ve=i.get(oe).__webglTexture;t.bindTexture(ye,ve),w(ye),t.unbindTexture()}}}let Le=[];function Je(R){if(R.samples>0){if(Me(R)===!1){let v=R.textures,q=R.width,de=R.height,oe=n.COLOR_BUFFER_BIT,ye=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),te=v.length>1;if(te)for(let me=0;me<v.length;me++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let me=0;me<v.length;me++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let B=i.get(v[me]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,q,de,0,0,q,de,oe,n.NEAREST),l===!0&&(Le.length=0,Le.push(n.COLOR_ATTACHMENT0+me),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Le.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Le))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let me=0;me<v.length;me++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.RENDERBUFFER,ve.__webglColorRenderbuffer[me]);let B=i.get(v[me]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+me,n.TEXTURE_2D,B,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let v=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function ct(R){return Math.min(r.maxSamples,R.samples)}function Me(R){let v=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Vt(R){let v=o.render.frame;u.get(R)!==v&&(u.set(R,v),R.update())}function Ge(R,v){let q=R.colorSpace,de=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==sl&&q!==Zr&&(vt.getTransfer(q)===Lt?(de!==Zi||oe!==ui)&&et("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):rt("WebGLTextures: Unsupported texture color space:",q)),v}function Ke(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=J,this.getTextureUnits=ee,this.setTextureUnits=ue,this.setTexture2D=ge,this.setTexture2DArray=be,this.setTexture3D=Pe,this.setTextureCube=Ae,this.rebindTextures=sn,this.setupRenderTarget=mn,this.updateRenderTargetMipmap=D,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=An,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=Me,this.dispose=V}function aC(n,e){function t(i,r=Zr){let s,o=vt.getTransfer(r);if(i===ui)return n.UNSIGNED_BYTE;if(i===Uu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Ou)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Vf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Hf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===kf)return n.BYTE;if(i===zf)return n.SHORT;if(i===la)return n.UNSIGNED_SHORT;if(i===Du)return n.INT;if(i===Xi)return n.UNSIGNED_INT;if(i===$i)return n.FLOAT;if(i===Yi)return n.HALF_FLOAT;if(i===Gf)return n.ALPHA;if(i===Wf)return n.RGB;if(i===Zi)return n.RGBA;if(i===Vr)return n.DEPTH_COMPONENT;if(i===Yr)return n.DEPTH_STENCIL;if(i===qf)return n.RED;if(i===ku)return n.RED_INTEGER;if(i===Ms)return n.RG;if(i===zu)return n.RG_INTEGER;if(i===Vu)return n.RGBA_INTEGER;if(i===Rl||i===Pl||i===Il||i===Ll)if(o===Lt)if(s=e.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(i===Rl)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Pl)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Il)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Ll)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=e.get("WEBGL_compressed_texture_s3tc"),s!==null){if(i===Rl)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Pl)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Il)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Ll)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Hu||i===Gu||i===Wu||i===qu)if(s=e.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(i===Hu)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Gu)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Wu)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===qu)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Xu||i===$u||i===Yu||i===Zu||i===Ku||i===Fl||i===Ju)if(s=e.get("WEBGL_compressed_texture_etc"),s!==null){if(i===Xu||i===$u)return o===Lt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(i===Yu)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(i===Zu)return s.COMPRESSED_R11_EAC;if(i===Ku)return s.COMPRESSED_SIGNED_R11_EAC;if(i===Fl)return s.COMPRESSED_RG11_EAC;if(i===Ju)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===ju||i===Qu||i===eh||i===th||i===nh||i===ih||i===rh||i===sh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh)if(s=e.get("WEBGL_compressed_texture_astc"),s!==null){if(i===ju)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Qu)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===eh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===th)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===nh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ih)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===rh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===sh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===oh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ah)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===lh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===ch)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===uh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===hh)return o===Lt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===dh||i===fh||i===ph)if(s=e.get("EXT_texture_compression_bptc"),s!==null){if(i===dh)return o===Lt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===fh)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ph)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===mh||i===gh||i===Nl||i===xh)if(s=e.get("EXT_texture_compression_rgtc"),s!==null){if(i===mh)return s.COMPRESSED_RED_RGTC1_EXT;if(i===gh)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Nl)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===xh)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Ks?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var lC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cC=`
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

}`,cp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new yl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new li({vertexShader:lC,fragmentShader:cC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Et(new vs(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},up=class extends br{constructor(e,t){super();let i=this,r=null,s=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,d=null,f=null,m=null,b=typeof XRWebGLBinding<"u",g=new cp,p={},_=t.getContextAttributes(),T=null,w=null,C=[],E=[],x=new dt,M=null,O=null,N=new ni;N.viewport=new tn;let I=new ni;I.viewport=new tn;let U=[N,I],H=new Lu,L=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let ge=C[Q];return ge===void 0&&(ge=new ta,C[Q]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(Q){let ge=C[Q];return ge===void 0&&(ge=new ta,C[Q]=ge),ge.getGripSpace()},this.getHand=function(Q){let ge=C[Q];return ge===void 0&&(ge=new ta,C[Q]=ge),ge.getHandSpace()};function W(Q){let ge=E.indexOf(Q.inputSource);if(ge===-1)return;let be=C[ge];be!==void 0&&(be.update(Q.inputSource,Q.frame,c||o),be.dispatchEvent({type:Q.type,data:Q.inputSource}))}function z(){r.removeEventListener("select",W),r.removeEventListener("selectstart",W),r.removeEventListener("selectend",W),r.removeEventListener("squeeze",W),r.removeEventListener("squeezestart",W),r.removeEventListener("squeezeend",W),r.removeEventListener("end",z),r.removeEventListener("inputsourceschange",ae);for(let Q=0;Q<C.length;Q++){let ge=E[Q];ge!==null&&(E[Q]=null,C[Q].disconnect(ge))}L=null,V=null,g.reset();for(let Q in p)delete p[Q];if(e.setRenderTarget(T),f=null,d=null,h=null,r=null,w=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(M),e.setSize(x.width,x.height,!1),O!==null){let Q=O.camera;Q.fov=O.fov,Q.zoom=O.zoom,Q.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){s=Q,i.isPresenting===!0&&et("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&et("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return h===null&&b&&(h=new XRWebGLBinding(r,t)),h},this.getFrame=function(){return m},this.getSession=function(){return r},this.setSession=async function(Q){if(r=Q,r!==null){if(T=e.getRenderTarget(),r.addEventListener("select",W),r.addEventListener("selectstart",W),r.addEventListener("selectend",W),r.addEventListener("squeeze",W),r.addEventListener("squeezestart",W),r.addEventListener("squeezeend",W),r.addEventListener("end",z),r.addEventListener("inputsourceschange",ae),_.xrCompatible!==!0&&await t.makeXRCompatible(),M=e.getPixelRatio(),e.getSize(x),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let be=null,Pe=null,Ae=null;_.depth&&(Ae=_.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,be=_.stencil?Yr:Vr,Pe=_.stencil?Ks:Xi);let $e={colorFormat:t.RGBA8,depthFormat:Ae,scaleFactor:s};h=this.getBinding(),d=h.createProjectionLayer($e),r.updateRenderState({layers:[d]}),e.setPixelRatio(1),e.setSize(d.textureWidth,d.textureHeight,!1),w=new bi(d.textureWidth,d.textureHeight,{format:Zi,type:ui,depthTexture:new Hr(d.textureWidth,d.textureHeight,Pe,void 0,void 0,void 0,void 0,void 0,void 0,be),stencilBuffer:_.stencil,colorSpace:e.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let be={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:s};f=new XRWebGLLayer(r,t,be),r.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),w=new bi(f.framebufferWidth,f.framebufferHeight,{format:Zi,type:ui,colorSpace:e.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await r.requestReferenceSpace(a),he.setContext(r),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(r!==null)return r.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ae(Q){for(let ge=0;ge<Q.removed.length;ge++){let be=Q.removed[ge],Pe=E.indexOf(be);Pe>=0&&(E[Pe]=null,C[Pe].disconnect(be))}for(let ge=0;ge<Q.added.length;ge++){let be=Q.added[ge],Pe=E.indexOf(be);if(Pe===-1){for(let $e=0;$e<C.length;$e++)if($e>=E.length){E.push(be),Pe=$e;break}else if(E[$e]===null){E[$e]=be,Pe=$e;break}if(Pe===-1)break}let Ae=C[Pe];Ae&&Ae.connect(be)}}function X(Q,ge){ge===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(ge.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(r===null)return;let ge=Q.near,be=Q.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(be=g.depthFar)),H.near=I.near=N.near=ge,H.far=I.far=N.far=be,(L!==H.near||V!==H.far)&&(r.updateRenderState({depthNear:H.near,depthFar:H.far}),L=H.near,V=H.far),H.layers.mask=Q.layers.mask|6,N.layers.mask=H.layers.mask&-5,I.layers.mask=H.layers.mask&-3;let Pe=Q.parent,Ae=H.cameras;X(H,Pe);for(let $e=0;$e<Ae.length;$e++)X(Ae[$e],Pe);H.projectionMatrix.copy(N.projectionMatrix),H.projectionMatrixInverse.copy(N.projectionMatrixInverse),O===null&&Q.isPerspectiveCamera&&(O={camera:Q,fov:Q.fov,zoom:Q.zoom}),J(Q,H,Pe)};function J(Q,ge,be){be===null?Q.matrix.copy(ge.matrixWorld):(Q.matrix.copy(be.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(ge.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(ge.projectionMatrix),Q.projectionMatrixInverse.copy(ge.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=hu*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(d===null&&f===null))return l},this.setFoveation=function(Q){l=Q,d!==null&&(d.fixedFoveation=Q),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=Q)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(H)},this.getCameraTexture=function(Q){return p[Q]};let ee=null;function ue(Q,ge){if(u=ge.getViewerPose(c||o),m=ge,u!==null){let be=u.views;f!==null&&(e.setRenderTargetFramebuffer(w,f.framebuffer),e.setRenderTarget(w));let Pe=!1;be.length!==H.cameras.length&&(H.cameras.length=0,Pe=!0);for(let qe=0;qe<be.length;qe++){let gt=be[qe],ft=null;if(f!==null)ft=f.getViewport(gt);else{let Jt=h.getViewSubImage(d,gt);ft=Jt.viewport,qe===0&&(e.setRenderTargetTextures(w,Jt.colorTexture,Jt.depthStencilTexture),e.setRenderTarget(w))}let ot=U[qe];ot===void 0&&(ot=new ni,ot.layers.enable(qe),ot.viewport=new tn,U[qe]=ot),ot.matrix.fromArray(gt.transform.matrix),ot.matrix.decompose(ot.position,ot.quaternion,ot.scale),ot.projectionMatrix.fromArray(gt.projectionMatrix),ot.projectionMatrixInverse.copy(ot.projectionMatrix).invert(),ot.viewport.set(ft.x,ft.y,ft.width,ft.height),qe===0&&(H.matrix.copy(ot.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),Pe===!0&&H.cameras.push(ot)}let Ae=r.enabledFeatures;if(Ae&&Ae.includes("depth-sensing")&&r.depthUsage=="gpu-optimized"&&b){h=i.getBinding();let qe=h.getDepthInformation(be[0]);qe&&qe.isValid&&qe.texture&&g.init(qe,r.renderState)}if(Ae&&Ae.includes("camera-access")&&b){e.state.unbindTexture(),h=i.getBinding();for(let qe=0;qe<be.length;qe++){let gt=be[qe].camera;if(gt){let ft=p[gt];ft||(ft=new yl,p[gt]=ft);let ot=h.getCameraImage(gt);ft.sourceTexture=ot}}}}for(let be=0;be<C.length;be++){let Pe=E[be],Ae=C[be];Pe!==null&&Ae!==void 0&&Ae.update(Pe,ge,c||o)}ee&&ee(Q,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),m=null}let he=new gy;he.setAnimationLoop(ue),this.setAnimationLoop=function(Q){ee=Q},this.dispose=function(){}}},uC=new en,Ty=new st;Ty.set(-1,0,0,0,1,0,0,0,1);function hC(n,e){function t(g,p){g.matrixAutoUpdate===!0&&g.updateMatrix(),p.value.copy(g.matrix)}function i(g,p){p.color.getRGB(g.fogColor.value,Jf(n)),p.isFog?(g.fogNear.value=p.near,g.fogFar.value=p.far):p.isFogExp2&&(g.fogDensity.value=p.density)}function r(g,p,_,T,w){p.isNodeMaterial?p.uniformsNeedUpdate=!1:p.isMeshBasicMaterial?s(g,p):p.isMeshLambertMaterial?(s(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshToonMaterial?(s(g,p),h(g,p)):p.isMeshPhongMaterial?(s(g,p),u(g,p),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)):p.isMeshStandardMaterial?(s(g,p),d(g,p),p.isMeshPhysicalMaterial&&f(g,p,w)):p.isMeshMatcapMaterial?(s(g,p),m(g,p)):p.isMeshDepthMaterial?s(g,p):p.isMeshDistanceMaterial?(s(g,p),b(g,p)):p.isMeshNormalMaterial?s(g,p):p.isLineBasicMaterial?(o(g,p),p.isLineDashedMaterial&&a(g,p)):p.isPointsMaterial?l(g,p,_,T):p.isSpriteMaterial?c(g,p):p.isShadowMaterial?(g.color.value.copy(p.color),g.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function s(g,p){g.opacity.value=p.opacity,p.color&&g.diffuse.value.copy(p.color),p.emissive&&g.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.bumpMap&&(g.bumpMap.value=p.bumpMap,t(p.bumpMap,g.bumpMapTransform),g.bumpScale.value=p.bumpScale,p.side===fn&&(g.bumpScale.value*=-1)),p.normalMap&&(g.normalMap.value=p.normalMap,t(p.normalMap,g.normalMapTransform),g.normalScale.value.copy(p.normalScale),p.side===fn&&g.normalScale.value.negate()),p.displacementMap&&(g.displacementMap.value=p.displacementMap,t(p.displacementMap,g.displacementMapTransform),g.displacementScale.value=p.displacementScale,g.displacementBias.value=p.displacementBias),p.emissiveMap&&(g.emissiveMap.value=p.emissiveMap,t(p.emissiveMap,g.emissiveMapTransform)),p.specularMap&&(g.specularMap.value=p.specularMap,t(p.specularMap,g.specularMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest);let _=e.get(p),T=_.envMap,w=_.envMapRotation;T&&(g.envMap.value=T,g.envMapRotation.value.setFromMatrix4(uC.makeRotationFromEuler(w)).transpose(),T.isCubeTexture&&T.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Ty),g.reflectivity.value=p.reflectivity,g.ior.value=p.ior,g.refractionRatio.value=p.refractionRatio),p.lightMap&&(g.lightMap.value=p.lightMap,g.lightMapIntensity.value=p.lightMapIntensity,t(p.lightMap,g.lightMapTransform)),p.aoMap&&(g.aoMap.value=p.aoMap,g.aoMapIntensity.value=p.aoMapIntensity,t(p.aoMap,g.aoMapTransform))}function o(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform))}function a(g,p){g.dashSize.value=p.dashSize,g.totalSize.value=p.dashSize+p.gapSize,g.scale.value=p.scale}function l(g,p,_,T){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.size.value=p.size*_,g.scale.value=T*.5,p.map&&(g.map.value=p.map,t(p.map,g.uvTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function c(g,p){g.diffuse.value.copy(p.color),g.opacity.value=p.opacity,g.rotation.value=p.rotation,p.map&&(g.map.value=p.map,t(p.map,g.mapTransform)),p.alphaMap&&(g.alphaMap.value=p.alphaMap,t(p.alphaMap,g.alphaMapTransform)),p.alphaTest>0&&(g.alphaTest.value=p.alphaTest)}function u(g,p){g.specular.value.copy(p.specular),g.shininess.value=Math.max(p.shininess,1e-4)}function h(g,p){p.gradientMap&&(g.gradientMap.value=p.gradientMap)}function d(g,p){g.metalness.value=p.metalness,p.metalnessMap&&(g.metalnessMap.value=p.metalnessMap,t(p.metalnessMap,g.metalnessMapTransform)),g.roughness.value=p.roughness,p.roughnessMap&&(g.roughnessMap.value=p.roughnessMap,t(p.roughnessMap,g.roughnessMapTransform)),p.envMap&&(g.envMapIntensity.value=p.envMapIntensity)}function f(g,p,_){g.ior.value=p.ior,p.diffuseRoughness>0&&(g.diffuseRoughness.value=p.diffuseRoughness,p.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=p.diffuseRoughnessMap,t(p.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),p.sheen>0&&(g.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),g.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(g.sheenColorMap.value=p.sheenColorMap,t(p.sheenColorMap,g.sheenColorMapTransform)),p.sheenRoughnessMap&&(g.sheenRoughnessMap.value=p.sheenRoughnessMap,t(p.sheenRoughnessMap,g.sheenRoughnessMapTransform))),p.clearcoat>0&&(g.clearcoat.value=p.clearcoat,g.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(g.clearcoatMap.value=p.clearcoatMap,t(p.clearcoatMap,g.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,t(p.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(g.clearcoatNormalMap.value=p.clearcoatNormalMap,t(p.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===fn&&g.clearcoatNormalScale.value.negate())),p.dispersion>0&&(g.dispersion.value=p.dispersion),p.retroreflectivity>0&&(g.retroreflectivity.value=p.retroreflectivity),p.iridescence>0&&(g.iridescence.value=p.iridescence,g.iridescenceIOR.value=p.iridescenceIOR,g.iridescenceThicknessMinimum.value=p.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=p.iridescenceThicknessMaximum,p.iridescenceMap&&(g.iridescenceMap.value=p.iridescenceMap,t(p.iridescenceMap,g.iridescenceMapTransform)),p.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=p.iridescenceThicknessMap,t(p.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),p.transmission>0&&(g.transmission.value=p.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),p.transmissionMap&&(g.transmissionMap.value=p.transmissionMap,t(p.transmissionMap,g.transmissionMapTransform)),g.thickness.value=p.thickness,p.thicknessMap&&(g.thicknessMap.value=p.thicknessMap,t(p.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=p.attenuationDistance,g.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(g.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(g.anisotropyMap.value=p.anisotropyMap,t(p.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=p.specularIntensity,g.specularColor.value.copy(p.specularColor),p.specularColorMap&&(g.specularColorMap.value=p.specularColorMap,t(p.specularColorMap,g.specularColorMapTransform)),p.specularIntensityMap&&(g.specularIntensityMap.value=p.specularIntensityMap,t(p.specularIntensityMap,g.specularIntensityMapTransform))}function m(g,p){p.matcap&&(g.matcap.value=p.matcap)}function b(g,p){let _=e.get(p).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:r}}function dC(n,e,t,i){let r={},s={};function o(_,T){let w=T.program;i.uniformBlockBinding(_,w,r[_.id])}function a(_,T){let w=r[_.id];w===void 0&&(m(_),w=l(_),r[_.id]=w,_.addEventListener("dispose",g));let C=T.program;i.updateUBOMapping(_,C);let E=e.render.frame;s[_.id]!==E&&(c(_),s[_.id]=E)}function l(_){let T=n.createBuffer(),w=_.__size,C=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,T),n.bufferData(n.UNIFORM_BUFFER,w,C),n.bindBuffer(n.UNIFORM_BUFFER,null),T}function c(_){let T=r[_.id],w=_.uniforms,C=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,T);for(let E=0,x=w.length;E<x;E++){let M=w[E];if(Array.isArray(M))for(let O=0,N=M.length;O<N;O++)u(M[O],E,O,C);else u(M,E,0,C)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(_,T,w,C){if(d(_,T,w,C)===!0){let E=_.__offset,x=_.value;if(Array.isArray(x)){let M=0;for(let O=0;O<x.length;O++){let N=x[O],I=b(N,!0);h(N,_.__data,M),M+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else h(x,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,_.__data)}}function h(_,T,w){typeof _=="number"||typeof _=="boolean"?T[w]=_:_.isMatrix3?(T[w]=_.elements[0],T[w+1]=_.elements[1],T[w+2]=_.elements[2],T[w+3]=0,T[w+4]=_.elements[3],T[w+5]=_.elements[4],T[w+6]=_.elements[5],T[w+7]=0,T[w+8]=_.elements[6],T[w+9]=_.elements[7],T[w+10]=_.elements[8],T[w+11]=0):ArrayBuffer.isView(_)?T.set(_.subarray(0,T.length-w),w):_.toArray(T,w)}function d(_,T,w,C){let E=_.value,x=T+"_"+w;if(Array.isArray(E)){C[x]===void 0&&(C[x]=[]);let M=C[x],O=!1;for(let N=0;N<E.length;N++)f(E[N],M,N)===!0&&(O=!0);return O}return f(E,C,x)}function f(_,T,w){if(T[w]===void 0)return typeof _=="number"||typeof _=="boolean"?T[w]=_:ArrayBuffer.isView(_)?T[w]=_.slice():T[w]=_.clone(),!0;{let C=T[w];if(typeof _=="number"||typeof _=="boolean"){if(C!==_)return T[w]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(C.equals(_)===!1)return C.copy(_),!0}}return!1}function m(_){let T=_.uniforms,w=0,C=16;for(let x=0,M=T.length;x<M;x++){let O=Array.isArray(T[x])?T[x]:[T[x]];for(let N=0,I=O.length;N<I;N++){let U=O[N],H=Array.isArray(U.value)?U.value:[U.value],L=Array.isArray(T[x])||Array.isArray(U.value),V=w;for(let z=0,ae=H.length;z<ae;z++){let X=H[z],J=b(X,L),ee=w%C,ue=ee%J.boundary,he=ee+ue;w+=ue,he!==0&&C-he<J.storage&&(w+=C-he),z===0&&(V=w),w+=J.storage}let W=U.type==="int"?Int32Array:U.type==="uint"?Uint32Array:Float32Array;U.__data=new W((w-V)/Float32Array.BYTES_PER_ELEMENT),U.__offset=V}}let E=w%C;return E>0&&(w+=C-E),_.__size=w,_.__cache={},this}function b(_,T){let w={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(w.boundary=4,w.storage=4):_.isVector2?(w.boundary=8,w.storage=8):_.isVector3||_.isColor?(w.boundary=16,w.storage=12):_.isVector4?(w.boundary=16,w.storage=16):_.isMatrix3?(w.boundary=16,w.storage=48):_.isMatrix4?(w.boundary=16,w.storage=64):_.isTexture?et("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(w.boundary=16,w.storage=_.byteLength):et("WebGLRenderer: Unsupported uniform value type.",_),T===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function g(_){let T=_.target;T.removeEventListener("dispose",g),n.deleteBuffer(r[T.id]),delete r[T.id],delete s[T.id]}function p(){for(let _ in r)n.deleteBuffer(r[_]);r={},s={}}return{bind:o,update:a,dispose:p}}var fC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ar=null;function pC(){return Ar===null&&(Ar=new gu(fC,16,16,Ms,Yi),Ar.name="DFG_LUT",Ar.minFilter=ii,Ar.magFilter=ii,Ar.wrapS=_r,Ar.wrapT=_r,Ar.generateMipmaps=!1,Ar.needsUpdate=!0),Ar}var wh=class{constructor(e={}){let{canvas:t=Ox(),context:i=null,depth:r=!0,stencil:s=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:d=!1,outputBufferType:f=ui}=e;this.isWebGLRenderer=!0;let m;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=i.getContextAttributes().alpha}else m=o;let b=f,g=new Set([Vu,zu,ku]),p=new Set([ui,Xi,la,Ks,Uu,Ou]),_=new Uint32Array(4),T=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},C=null,E=null,x=[],M=[],O=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Sr,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,I=!1,U=null,H=null,L=null,V=null;this._outputColorSpace=_i;let W=0,z=0,ae=null,X=-1,J=null,ee=new tn,ue=new tn,he=null,Q=new je(0),ge=0,be=t.width,Pe=t.height,Ae=1,$e=null,lt=null,qe=new tn(0,0,be,Pe),gt=new tn(0,0,be,Pe),ft=!1,ot=new bs,Jt=new xu,Wt=!1,pn=!1,Ot=new en,Pn=new Y,Tt=new tn,An={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},sn=!1;function mn(){return ae===null?Ae:1}let D=i;function Le(A,k){return t.getContext(A,k)}let Je,ct,Me,Vt,Ge,Ke,R,v,q,de,oe,ye,ve,te,ie,me,B,re,ne,Te,xe,Se,Xe;try{let A={alpha:!0,depth:r,stencil:s,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),D===null){let k="webgl2";if(D=Le(k,A),D===null)throw Le(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(A){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),rt("WebGLRenderer: "+A.message),A}function tt(){Je=new MT(D),Je.init(),xe=new aC(D,Je),ct=new pT(D,Je,e,xe),Me=new sC(D,Je),ct.reversedDepthBuffer&&d&&Me.buffers.depth.setReversed(!0),H=D.createFramebuffer(),L=D.createFramebuffer(),V=D.createFramebuffer(),Vt=new CT(D),Ge=new qE,Ke=new oC(D,Je,Me,Ge,ct,xe,Vt),R=new AT(N),v=new PA(D),Se=new dT(D,v),q=new TT(D,v,Vt,Se),de=new PT(D,q,v,Se,Vt),re=new RT(D,ct,Ke),ie=new mT(Ge),oe=new WE(N,R,Je,ct,Se,ie),ye=new hC(N,Ge),ve=new $E,te=new QE(Je),B=new hT(N,R,Me,de,m,l),me=new rC(N,de,ct),Xe=new dC(D,Vt,ct,Me),ne=new fT(D,Je,Vt),Te=new ET(D,Je,Vt),Vt.programs=oe.programs,N.capabilities=ct,N.extensions=Je,N.properties=Ge,N.renderLists=ve,N.shadowMap=me,N.state=Me,N.info=Vt}b!==ui&&(O=new LT(b,t.width,t.height,a,r,s));let ce=new up(N,D);this.xr=ce,this.getContext=function(){return D},this.getContextAttributes=function(){return D.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return Ae},this.setPixelRatio=function(A){A!==void 0&&(Ae=A,this.setSize(be,Pe,!1))},this.getSize=function(A){return A.set(be,Pe)},this.setSize=function(A,k,j=!0){if(ce.isPresenting){et("WebGLRenderer: Can't change size while VR device is presenting.");return}be=A,Pe=k,t.width=Math.floor(A*Ae),t.height=Math.floor(k*Ae),j===!0&&(t.style.width=A+"px",t.style.height=k+"px"),O!==null&&O.setSize(t.width,t.height),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set(be*Ae,Pe*Ae).floor()},this.setDrawingBufferSize=function(A,k,j){be=A,Pe=k,Ae=j,t.width=Math.floor(A*j),t.height=Math.floor(k*j),this.setViewport(0,0,A,k)},this.setEffects=function(A){if(b===ui){rt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let k=0;k<A.length;k++)if(A[k].isOutputPass===!0){et("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ee)},this.getViewport=function(A){return A.copy(qe)},this.setViewport=function(A,k,j,$){A.isVector4?qe.set(A.x,A.y,A.z,A.w):qe.set(A,k,j,$),Me.viewport(ee.copy(qe).multiplyScalar(mn()).round())},this.getScissor=function(A){return A.copy(gt)},this.setScissor=function(A,k,j,$){A.isVector4?gt.set(A.x,A.y,A.z,A.w):gt.set(A,k,j,$),Me.scissor(ue.copy(gt).multiplyScalar(mn()).round())},this.getScissorTest=function(){return ft},this.setScissorTest=function(A){Me.setScissorTest(ft=A)},this.setOpaqueSort=function(A){$e=A},this.setTransparentSort=function(A){lt=A},this.getClearColor=function(A){return A.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(A=!0,k=!0,j=!0){let $=0;if(A){let Z=!1;if(ae!==null){let Ee=ae.texture.format;Z=g.has(Ee)}if(Z){let Ee=ae.texture.type,Fe=p.has(Ee),Ce=B.getClearColor(),Ne=B.getClearAlpha(),He=Ce.r,it=Ce.g,xt=Ce.b;Fe?(_[0]=He,_[1]=it,_[2]=xt,_[3]=Ne,D.clearBufferuiv(D.COLOR,0,_)):(T[0]=He,T[1]=it,T[2]=xt,T[3]=Ne,D.clearBufferiv(D.COLOR,0,T))}else $|=D.COLOR_BUFFER_BIT}k&&($|=D.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&($|=D.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),$!==0&&D.clear($)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),U=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),B.dispose(),ve.dispose(),te.dispose(),Ke.dispose(),Ge.dispose(),R.dispose(),de.dispose(),q.dispose(),Se.dispose(),Xe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Zl),ce.removeEventListener("sessionend",Qi),Er.stop()};function ze(A){A.preventDefault(),ll("WebGLRenderer: Context Lost."),I=!0}function nt(){ll("WebGLRenderer: Context Restored."),I=!1;let A=Vt.autoReset,k=me.enabled,j=me.autoUpdate,$=me.needsUpdate,Z=me.type;tt(),Vt.autoReset=A,me.enabled=k,me.autoUpdate=j,me.needsUpdate=$,me.type=Z}function Ie(A){rt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ut(A){let k=A.target;k.removeEventListener("dispose",ut),qt(k)}function qt(A){Zn(A),Ge.remove(A)}function Zn(A){let k=Ge.get(A).programs;k!==void 0&&(k.forEach(function(j){oe.releaseProgram(j)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,j,$,Z,Ee){k===null&&(k=An);let Fe=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ce=Ma(A,k,j,$,Z);Me.setMaterial($,Fe);let Ne=j.index,He=1;if($.wireframe===!0){if(Ne=q.getWireframeAttribute(j),Ne===void 0)return;He=2}let it=j.drawRange,xt=j.attributes.position,Ve=it.start*He,yt=(it.start+it.count)*He;Ee!==null&&(Ve=Math.max(Ve,Ee.start*He),yt=Math.min(yt,(Ee.start+Ee.count)*He)),Ne!==null?(Ve=Math.max(Ve,0),yt=Math.min(yt,Ne.count)):xt!=null&&(Ve=Math.max(Ve,0),yt=Math.min(yt,xt.count));let nn=yt-Ve;if(nn<0||nn===1/0)return;Se.setup(Z,$,Ce,j,Ne);let Nt,Bt=ne;if(Ne!==null&&(Nt=v.get(Ne),Bt=Te,Bt.setIndex(Nt)),Z.isMesh)$.wireframe===!0?(Me.setLineWidth($.wireframeLinewidth*mn()),Bt.setMode(D.LINES)):Bt.setMode(D.TRIANGLES);else if(Z.isLine){let Mn=$.linewidth;Mn===void 0&&(Mn=1),Me.setLineWidth(Mn*mn()),Z.isLineSegments?Bt.setMode(D.LINES):Z.isLineLoop?Bt.setMode(D.LINE_LOOP):Bt.setMode(D.LINE_STRIP)}else Z.isPoints?Bt.setMode(D.POINTS):Z.isSprite&&Bt.setMode(D.TRIANGLES);if(Z.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Bt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Mn=Z._multiDrawStarts,Oe=Z._multiDrawCounts,gn=Z._multiDrawCount,bt=Ne?v.get(Ne).bytesPerElement:1,Rr=Ge.get($).currentProgram.getUniforms();for(let xn=0;xn<gn;xn++)Rr.setValue(D,"_gl_DrawID",xn),Bt.render(Mn[xn]/bt,Oe[xn])}else if(Z.isInstancedMesh)Bt.renderInstances(Ve,nn,Z.count);else if(j.isInstancedBufferGeometry){let Mn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Oe=Math.min(j.instanceCount,Mn);Bt.renderInstances(Ve,nn,Oe)}else Bt.render(Ve,nn)};function wa(A,k,j,$){U!==null&&A.isNodeMaterial&&U.setObject($,A),Wt===!0&&ie.setState(A,j,!1),A.transparent===!0&&A.side===Fi&&A.forceSinglePass===!1?(A.side=fn,A.needsUpdate=!0,er(A,k,$),A.side=ci,A.needsUpdate=!0,er(A,k,$),A.side=Fi):er(A,k,$)}this.compile=function(A,k,j=null){j===null&&(j=A),U!==null&&U.renderStart(A,k,j),E=te.get(j),E.init(k),M.push(E),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),A!==j&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(E.pushLight(Z),Z.castShadow&&E.pushShadow(Z))}),E.setupLights(),U!==null&&U.updateLights(E.state.lightsArray),pn=this.localClippingEnabled,Wt=ie.init(this.clippingPlanes,pn),Wt===!0&&ie.setGlobalState(this.clippingPlanes,k),U!==null&&me.render(E.state.shadowsArray,j,k);let $=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ee=Z.material;if(Ee)if(Array.isArray(Ee))for(let Fe=0;Fe<Ee.length;Fe++){let Ce=Ee[Fe];wa(Ce,j,k,Z),$.add(Ce)}else wa(Ee,j,k,Z),$.add(Ee)}),E=M.pop(),U!==null&&U.renderEnd(),$},this.compileAsync=function(A,k,j=null){let $=this.compile(A,k,j);return new Promise(Z=>{function Ee(){if($.forEach(function(Fe){let Ne=Ge.get(Fe).currentProgram;(Ne===void 0||Ne.isReady())&&$.delete(Fe)}),$.size===0){Z(A);return}setTimeout(Ee,10)}Je.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let so=null;function qh(A){so&&so(A)}function Zl(){Er.stop()}function Qi(){Er.start()}let Er=new gy;Er.setAnimationLoop(qh),typeof self<"u"&&Er.setContext(self),this.setAnimationLoop=function(A){so=A,ce.setAnimationLoop(A),A===null?Er.stop():Er.start()},ce.addEventListener("sessionstart",Zl),ce.addEventListener("sessionend",Qi),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){rt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;U!==null&&U.renderStart(A,k);let j=ce.enabled===!0&&ce.isPresenting===!0,$=O!==null&&(ae===null||j)&&O.begin(N,ae);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(k),k=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(N,A,k,ae),E=te.get(A,M.length),E.init(k),E.state.textureUnits=Ke.getTextureUnits(),M.push(E),Ot.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Jt.setFromArrayCamera(k):ot.setFromProjectionMatrix(Ot,Ii,k.reversedDepth),pn=this.localClippingEnabled,Wt=ie.init(this.clippingPlanes,pn),C=ve.get(A,x.length),C.init(),x.push(C),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Fe=N.xr.getDepthSensingMesh();Fe!==null&&Cr(Fe,k,-1/0,N.sortObjects)}Cr(A,k,0,N.sortObjects),C.finish(),U!==null&&U.updateLights(E.state.lightsArray),N.sortObjects===!0&&C.sort($e,lt),sn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,sn&&B.addToRenderList(C,A),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&ie.beginShadows();let Z=E.state.shadowsArray;if(me.render(Z,A,k),Wt===!0&&ie.endShadows(),($&&O.hasRenderPass())===!1){let Fe=C.opaque,Ce=C.transmissive;if(E.setupLights(),k.isArrayCamera){let Ne=k.cameras;if(Ce.length>0)for(let He=0,it=Ne.length;He<it;He++){let xt=Ne[He];Di(Fe,Ce,A,xt)}sn&&B.render(A);for(let He=0,it=Ne.length;He<it;He++){let xt=Ne[He];Sa(C,A,xt,xt.viewport)}}else Ce.length>0&&Di(Fe,Ce,A,k),sn&&B.render(A),Sa(C,A,k)}ae!==null&&z===0&&(Ke.updateMultisampleRenderTarget(ae),Ke.updateRenderTargetMipmap(ae)),$&&O.end(N),A.isScene===!0&&A.onAfterRender(N,A,k),Se.resetDefaultState(),X=-1,J=null,M.pop(),M.length>0?(E=M[M.length-1],Ke.setTextureUnits(E.state.textureUnits),Wt===!0&&ie.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?C=x[x.length-1]:C=null,U!==null&&U.renderEnd()};function Cr(A,k,j,$){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLight)E.pushLight(A),A.castShadow&&E.pushShadow(A);else if(A.isSprite){let Fe=k.isArrayCamera?Jt:ot;if(!A.frustumCulled||A.intersectsFrustum(Fe)){$&&Tt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ot);let Ce=de.update(A),Ne=A.material;Ne.visible&&C.push(A,Ce,Ne,j,Tt.z,null,k)}}else if(A.isMesh||A.isLine||A.isPoints){let Fe=k.isArrayCamera?Jt:ot;if(!A.frustumCulled||A.intersectsFrustum(Fe)){let Ce=de.update(A),Ne=A.material;if($&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),Tt.copy(A.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),Tt.copy(Ce.boundingSphere.center)),Tt.applyMatrix4(A.matrixWorld).applyMatrix4(Ot)),Array.isArray(Ne)){let He=Ce.groups;for(let it=0,xt=He.length;it<xt;it++){let Ve=He[it],yt=Ne[Ve.materialIndex];yt&&yt.visible&&C.push(A,Ce,yt,j,Tt.z,Ve,k)}}else Ne.visible&&C.push(A,Ce,Ne,j,Tt.z,null,k)}}}let Ee=A.children;for(let Fe=0,Ce=Ee.length;Fe<Ce;Fe++)Cr(Ee[Fe],k,j,$)}function Sa(A,k,j,$){let{opaque:Z,transmissive:Ee,transparent:Fe}=A;E.setupLightsView(j),Wt===!0&&ie.setGlobalState(N.clippingPlanes,j),$&&Me.viewport(ee.copy($)),Z.length>0&&on(Z,k,j),Ee.length>0&&on(Ee,k,j),Fe.length>0&&on(Fe,k,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Di(A,k,j,$){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[$.id]===void 0){let Ve=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[$.id]=new bi(1,1,{generateMipmaps:!0,type:Ve?Yi:ui,minFilter:$r,samples:Math.max(4,ct.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ee=E.state.transmissionRenderTarget[$.id],Fe=$.viewport||ee;Ee.setSize(Fe.z*N.transmissionResolutionScale,Fe.w*N.transmissionResolutionScale);let Ce=N.getRenderTarget(),Ne=N.getActiveCubeFace(),He=N.getActiveMipmapLevel();N.setRenderTarget(Ee),N.getClearColor(Q),ge=N.getClearAlpha(),ge<1&&N.setClearColor(16777215,.5),N.clear(),sn&&B.render(j);let it=N.toneMapping;N.toneMapping=Sr;let xt=$.viewport;if($.viewport!==void 0&&($.viewport=void 0),E.setupLightsView($),Wt===!0&&ie.setGlobalState(N.clippingPlanes,$),on(A,j,$),Ke.updateMultisampleRenderTarget(Ee),Ke.updateRenderTargetMipmap(Ee),Je.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let yt=0,nn=k.length;yt<nn;yt++){let Nt=k[yt],{object:Bt,geometry:Mn,material:Oe,group:gn}=Nt;if(Oe.side===Fi&&Bt.layers.test($.layers)){let bt=Oe.side;Oe.side=fn,Oe.needsUpdate=!0,un(Bt,j,$,Mn,Oe,gn),Oe.side=bt,Oe.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ke.updateMultisampleRenderTarget(Ee),Ke.updateRenderTargetMipmap(Ee))}N.setRenderTarget(Ce,Ne,He),N.setClearColor(Q,ge),xt!==void 0&&($.viewport=xt),N.toneMapping=it}function on(A,k,j){let $=k.isScene===!0?k.overrideMaterial:null;for(let Z=0,Ee=A.length;Z<Ee;Z++){let Fe=A[Z],{object:Ce,geometry:Ne,group:He}=Fe,it=Fe.material;it.allowOverride===!0&&$!==null&&(it=$),Ce.layers.test(j.layers)&&un(Ce,k,j,Ne,it,He)}}function un(A,k,j,$,Z,Ee){U!==null&&Z.isNodeMaterial&&U.setObject(A,Z),A.onBeforeRender(N,k,j,$,Z,Ee),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(N,k,j,$,A,Ee),Z.transparent===!0&&Z.side===Fi&&Z.forceSinglePass===!1?(Z.side=fn,Z.needsUpdate=!0,N.renderBufferDirect(j,k,$,Z,A,Ee),Z.side=ci,Z.needsUpdate=!0,N.renderBufferDirect(j,k,$,Z,A,Ee),Z.side=Fi):N.renderBufferDirect(j,k,$,Z,A,Ee),A.onAfterRender(N,k,j,$,Z,Ee)}function hn(A){let k=0;for(let j of A)j.texture!==null&&k++;return k}function er(A,k,j){k.isScene!==!0&&(k=An);let $=Ge.get(A),Z=E.state.lights,Ee=E.state.shadowsArray,Fe=Z.state.version,Ce=oe.getParameters(A,Z.state,Ee,k,j,E.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ce),He=$.programs;$.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?k.environment:null,$.fog=k.fog;let it=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;$.envMap=R.get(A.envMap||$.environment,it),$.envMapRotation=$.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ut),He=new Map,$.programs=He,$.programVariants=new Map);let xt=He.get(Ne);if(xt!==void 0){if($.currentProgram===xt&&$.lightsStateVersion===Fe)return Aa(A,Ce),xt}else Ce.uniforms=oe.getUniforms(A),U!==null&&A.isNodeMaterial&&U.build(A,j,Ce),A.onBeforeCompile(Ce,N),xt=oe.acquireProgram(Ce,Ne),He.set(Ne,xt),$.uniforms=Ce.uniforms;let Ve=$.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ve.clippingPlanes=ie.uniform),Aa(A,Ce),$.needsLights=Qr(A),$.lightsStateVersion=Fe,$.needsLights&&(Ve.ambientLightColor.value=Z.state.ambient,Ve.lightProbe.value=Z.state.probe,Ve.sunLights.value=Z.state.sun,Ve.sunLightShadows.value=Z.state.sunShadow,Ve.directionalLights.value=Z.state.directional,Ve.directionalLightShadows.value=Z.state.directionalShadow,Ve.spotLights.value=Z.state.spot,Ve.spotLightShadows.value=Z.state.spotShadow,Ve.rectAreaLights.value=Z.state.rectArea,Ve.ltc_1.value=Z.state.rectAreaLTC1,Ve.ltc_2.value=Z.state.rectAreaLTC2,Ve.pointLights.value=Z.state.point,Ve.pointLightShadows.value=Z.state.pointShadow,Ve.hemisphereLights.value=Z.state.hemi,Ve.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ve.sunShadowCascade.value=Z.state.sunShadowCascade,Ve.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ve.spotLightMatrix.value=Z.state.spotLightMatrix,Ve.spotLightMap.value=Z.state.spotLightMap,Ve.pointShadowMatrix.value=Z.state.pointShadowMatrix),$.numLightProbeGrids=hn(E.state.lightProbeGridArray),$.currentProgram=xt,$.uniformsList=null,xt}function hi(A,k,j,$,Z){let Ee=Ge.get(A),Fe=Ee.currentProgram.id+","+$+","+Z,Ce=Ee.programVariants.get(Fe);return Ce===void 0?(Ce=er(A,k,j),Ee.programVariants.set(Fe,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=$,Ee.toneMapping=Z),Ce}function jr(A){if(A.uniformsList===null){let k=A.currentProgram.getUniforms();A.uniformsList=ca.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function Aa(A,k){let j=Ge.get(A);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function Ma(A,k,j,$,Z){k.isScene!==!0&&(k=An),Ke.resetTextureUnits();let Ee=k.fog,Fe=$.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial?k.environment:null,Ce=ae===null?N.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:vt.workingColorSpace,Ne=$.isMeshStandardMaterial||$.isMeshLambertMaterial&&!$.envMap||$.isMeshPhongMaterial&&!$.envMap,He=R.get($.envMap||Fe,Ne),it=$.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,xt=!!j.attributes.tangent&&(!!$.normalMap||$.anisotropy>0),Ve=!!j.morphAttributes.position,yt=!!j.morphAttributes.normal,nn=!!j.morphAttributes.color,Nt=Sr;$.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(Nt=N.toneMapping);let Bt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Mn=Bt!==void 0?Bt.length:0,Oe=Ge.get($),gn=E.state.lights;if(Wt===!0&&(pn===!0||A!==J)){let Dt=A===J&&$.id===X;ie.setState($,A,Dt)}let bt=!1,Rr=!1;$.version===Oe.__version?Oe.needsLights&&Oe.lightsStateVersion!==gn.state.version||Z.isBatchedMesh&&Oe.batching===!1||!Z.isBatchedMesh&&Oe.batching===!0||Z.isBatchedMesh&&Oe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Oe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Oe.instancing===!1||!Z.isInstancedMesh&&Oe.instancing===!0||Z.isSkinnedMesh&&Oe.skinning===!1||!Z.isSkinnedMesh&&Oe.skinning===!0||Z.isInstancedMesh&&Oe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Oe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Oe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Oe.instancingMorph===!1&&Z.morphTexture!==null||Oe.envMap!==He||$.fog===!0&&Oe.fog!==Ee||Oe.numClippingPlanes!==void 0&&(Oe.numClippingPlanes!==ie.numPlanes||Oe.numIntersection!==ie.numIntersection)||Oe.vertexAlphas!==it||Oe.vertexTangents!==xt||Oe.morphTargets!==Ve||Oe.morphNormals!==yt||Oe.morphColors!==nn||Oe.morphTargetsCount!==Mn||Oe.numLightProbeGrids!==hn(E.state.lightProbeGridArray)?bt=!0:(Oe.outputColorSpace!==Ce||Oe.toneMapping!==Nt)&&(Rr=!0):(bt=!0,Oe.__version=$.version);let xn=Oe.currentProgram;(bt===!0||Rr===!0)&&(xn=Rr===!0?hi($,k,Z,Ce,Nt):er($,k,Z),U&&$.isNodeMaterial&&U.onUpdateProgram($,xn,Oe));let lo=!1,tr=!1,Pr=!1,pt=xn.getUniforms(),an=Oe.uniforms;if(Me.useProgram(xn.program)&&(lo=!0,tr=!0,Pr=!0),$.id!==X&&(X=$.id,tr=!0),lo||J!==A){Me.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),pt.setValue(D,"projectionMatrix",A.projectionMatrix),pt.setValue(D,"viewMatrix",A.matrixWorldInverse);let yn=pt.map.cameraPosition;yn!==void 0&&yn.setValue(D,Pn.setFromMatrixPosition(A.matrixWorld)),ct.logarithmicDepthBuffer&&pt.setValue(D,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),($.isMeshPhongMaterial||$.isMeshToonMaterial||$.isMeshLambertMaterial||$.isMeshBasicMaterial||$.isMeshStandardMaterial||$.isShaderMaterial)&&pt.setValue(D,"isOrthographic",A.isOrthographicCamera===!0),J!==A&&(J=A,tr=!0,Pr=!0)}if(Oe.needsLights&&(gn.state.sunShadowMap.length>0&&pt.setValue(D,"sunShadowMap",gn.state.sunShadowMap,Ke),gn.state.directionalShadowMap.length>0&&pt.setValue(D,"directionalShadowMap",gn.state.directionalShadowMap,Ke),gn.state.spotShadowMap.length>0&&pt.setValue(D,"spotShadowMap",gn.state.spotShadowMap,Ke),gn.state.pointShadowMap.length>0&&pt.setValue(D,"pointShadowMap",gn.state.pointShadowMap,Ke)),Z.isSkinnedMesh){pt.setOptional(D,Z,"bindMatrix"),pt.setOptional(D,Z,"bindMatrixInverse");let Dt=Z.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),pt.setValue(D,"boneTexture",Dt.boneTexture,Ke))}Z.isBatchedMesh&&(pt.setOptional(D,Z,"batchingTexture"),pt.setValue(D,"batchingTexture",Z._matricesTexture,Ke),pt.setOptional(D,Z,"batchingIdTexture"),pt.setValue(D,"batchingIdTexture",Z._indirectTexture,Ke),pt.setOptional(D,Z,"batchingColorTexture"),Z._colorsTexture!==null&&pt.setValue(D,"batchingColorTexture",Z._colorsTexture,Ke));let Kn=j.morphAttributes;if((Kn.position!==void 0||Kn.normal!==void 0||Kn.color!==void 0)&&re.update(Z,j,xn),(tr||Oe.receiveShadow!==Z.receiveShadow)&&(Oe.receiveShadow=Z.receiveShadow,pt.setValue(D,"receiveShadow",Z.receiveShadow)),($.isMeshStandardMaterial||$.isMeshLambertMaterial||$.isMeshPhongMaterial)&&$.envMap===null&&k.environment!==null&&(an.envMapIntensity.value=k.environmentIntensity),an.dfgLUT!==void 0&&(an.dfgLUT.value=pC()),tr){if(pt.setValue(D,"toneMappingExposure",N.toneMappingExposure),Oe.needsLights&&oo(an,Pr),Ee&&$.fog===!0&&ye.refreshFogUniforms(an,Ee),ye.refreshMaterialUniforms(an,$,Ae,Pe,E.state.transmissionRenderTarget[A.id]),Oe.needsLights&&Oe.numLightProbeGrids>0){let Dt=w,yn=0;for(let Gn of E.state.lightProbeGridArray)Gn.texture!==null&&(Dt.textures[yn]=Gn.texture,Dt.min[yn]=Gn.boundingBox.min,Dt.max[yn]=Gn.boundingBox.max,Dt.resolution[yn]=Gn.resolution,yn++);for(let Gn in Dt)Dt[Gn].length=yn;an.probesSH.value=Dt.textures,an.probesMin.value=Dt.min,an.probesMax.value=Dt.max,an.probesResolution.value=Dt.resolution}ca.upload(D,jr(Oe),an,Ke)}if($.isShaderMaterial&&$.uniformsNeedUpdate===!0&&(ca.upload(D,jr(Oe),an,Ke),$.uniformsNeedUpdate=!1),$.isSpriteMaterial&&pt.setValue(D,"center",Z.center),pt.setValue(D,"modelViewMatrix",Z.modelViewMatrix),pt.setValue(D,"normalMatrix",Z.normalMatrix),pt.setValue(D,"modelMatrix",Z.matrixWorld),$.uniformsGroups!==void 0){let Dt=$.uniformsGroups;for(let yn=0,Gn=Dt.length;yn<Gn;yn++){let Kl=Dt[yn];Xe.update(Kl,xn),Xe.bind(Kl,xn)}}return xn}function oo(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.sunLights.needsUpdate=k,A.sunLightShadows.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function Qr(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return W},this.getActiveMipmapLevel=function(){return z},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(A,k,j){let $=Ge.get(A);$.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,$.__autoAllocateDepthBuffer===!1&&($.__useRenderToTexture=!1),Ge.get(A.texture).__webglTexture=k,Ge.get(A.depthTexture).__webglTexture=$.__autoAllocateDepthBuffer?void 0:j,$.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,k){let j=Ge.get(A);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(A,k=0,j=0){ae=A,W=k,z=j;let $=null,Z=!1,Ee=!1;if(A){let Ce=Ge.get(A);if(Ce.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(D.FRAMEBUFFER,Ce.__webglFramebuffer),ee.copy(A.viewport),ue.copy(A.scissor),he=A.scissorTest,Me.viewport(ee),Me.scissor(ue),Me.setScissorTest(he),X=-1;return}else if(Ce.__webglFramebuffer===void 0)Ke.setupRenderTarget(A);else if(Ce.__hasExternalTextures)Ke.rebindTextures(A,Ge.get(A.texture).__webglTexture,Ge.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let it=A.depthTexture;if(Ce.__boundDepthTexture!==it){if(it!==null&&Ge.has(it)&&(A.width!==it.image.width||A.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ke.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let He=Ge.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[k])?$=He[k][j]:$=He[k],Z=!0):A.samples>0&&Ke.useMultisampledRTT(A)===!1?$=Ge.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?$=He[j]:$=He,ee.copy(A.viewport),ue.copy(A.scissor),he=A.scissorTest}else ee.copy(qe).multiplyScalar(Ae).floor(),ue.copy(gt).multiplyScalar(Ae).floor(),he=ft;if(j!==0&&($=H),Me.bindFramebuffer(D.FRAMEBUFFER,$)&&Me.drawBuffers(A,$),Me.viewport(ee),Me.scissor(ue),Me.setScissorTest(he),Z){let Ce=Ge.get(A.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ce.__webglTexture,j)}else if(Ee){let Ce=k;for(let Ne=0;Ne<A.textures.length;Ne++){let He=Ge.get(A.textures[Ne]);D.framebufferTextureLayer(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0+Ne,He.__webglTexture,j,Ce)}}else if(A!==null&&j!==0){let Ce=Ge.get(A.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,Ce.__webglTexture,j)}X=-1};function ao(A){let k=Ge.get(A);return(k.__readFormat!==A.format||k.__readType!==A.type)&&(k.__readFormat=A.format,k.__readType=A.type,k.__formatReadable=ct.textureFormatReadable(A.format),k.__typeReadable=ct.textureTypeReadable(A.type)),k}this.readRenderTargetPixels=function(A,k,j,$,Z,Ee,Fe,Ce=0){if(!(A&&A.isWebGLRenderTarget)){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ne=Ne[Fe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Me.bindFramebuffer(D.FRAMEBUFFER,Ne);try{let He=A.textures[Ce],it=He.format,xt=He.type;A.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+Ce);let Ve=ao(He);if(Ve.__formatReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-$&&j>=0&&j<=A.height-Z&&D.readPixels(k,j,$,Z,xe.convert(it),xe.convert(xt),Ee)}finally{let He=ae!==null?Ge.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(D.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,k,j,$,Z,Ee,Fe,Ce=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Fe!==void 0&&(Ne=Ne[Fe],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(k>=0&&k<=A.width-$&&j>=0&&j<=A.height-Z){Me.bindFramebuffer(D.FRAMEBUFFER,Ne);let He=A.textures[Ce],it=He.format,xt=He.type;A.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+Ce);let Ve=ao(He);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let yt=D.createBuffer();D.bindBuffer(D.PIXEL_PACK_BUFFER,yt),D.bufferData(D.PIXEL_PACK_BUFFER,Ee.byteLength,D.STREAM_READ),D.readPixels(k,j,$,Z,xe.convert(it),xe.convert(xt),0),D.bindBuffer(D.PIXEL_PACK_BUFFER,null);let nn=ae!==null?Ge.get(ae).__webglFramebuffer:null;Me.bindFramebuffer(D.FRAMEBUFFER,nn);let Nt=D.fenceSync(D.SYNC_GPU_COMMANDS_COMPLETE,0);return D.flush(),await zx(D,Nt,4),D.bindBuffer(D.PIXEL_PACK_BUFFER,yt),D.getBufferSubData(D.PIXEL_PACK_BUFFER,0,Ee),D.bindBuffer(D.PIXEL_PACK_BUFFER,null),D.deleteBuffer(yt),D.deleteSync(Nt),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,k=null,j=0){let $=Math.pow(2,-j),Z=Math.floor(A.image.width*$),Ee=Math.floor(A.image.height*$),Fe=k!==null?k.x:0,Ce=k!==null?k.y:0;Ke.setTexture2D(A,0),D.copyTexSubImage2D(D.TEXTURE_2D,j,0,0,Fe,Ce,Z,Ee),Me.unbindTexture()},this.copyTextureToTexture=function(A,k,j=null,$=null,Z=0,Ee=0){let Fe,Ce,Ne,He,it,xt,Ve,yt,nn,Nt=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(j!==null)Fe=j.max.x-j.min.x,Ce=j.max.y-j.min.y,Ne=j.isBox3?j.max.z-j.min.z:1,He=j.min.x,it=j.min.y,xt=j.isBox3?j.min.z:0;else{let pt=Math.pow(2,-Z);Fe=Math.floor(Nt.width*pt),Ce=Math.floor(Nt.height*pt),A.isDataArrayTexture?Ne=Nt.depth:A.isData3DTexture?Ne=Math.floor(Nt.depth*pt):Ne=1,He=0,it=0,xt=0}$!==null?(Ve=$.x,yt=$.y,nn=$.z):(Ve=0,yt=0,nn=0);let Bt=xe.convert(k.format),Mn=xe.convert(k.type),Oe;k.isData3DTexture?(Ke.setTexture3D(k,0),Oe=D.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Ke.setTexture2DArray(k,0),Oe=D.TEXTURE_2D_ARRAY):(Ke.setTexture2D(k,0),Oe=D.TEXTURE_2D),Me.activeTexture(D.TEXTURE0),Me.pixelStorei(D.UNPACK_FLIP_Y_WEBGL,k.flipY),Me.pixelStorei(D.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Me.pixelStorei(D.UNPACK_ALIGNMENT,k.unpackAlignment);let gn=Me.getParameter(D.UNPACK_ROW_LENGTH),bt=Me.getParameter(D.UNPACK_IMAGE_HEIGHT),Rr=Me.getParameter(D.UNPACK_SKIP_PIXELS),xn=Me.getParameter(D.UNPACK_SKIP_ROWS),lo=Me.getParameter(D.UNPACK_SKIP_IMAGES);Me.pixelStorei(D.UNPACK_ROW_LENGTH,Nt.width),Me.pixelStorei(D.UNPACK_IMAGE_HEIGHT,Nt.height),Me.pixelStorei(D.UNPACK_SKIP_PIXELS,He),Me.pixelStorei(D.UNPACK_SKIP_ROWS,it),Me.pixelStorei(D.UNPACK_SKIP_IMAGES,xt);let tr=A.isDataArrayTexture||A.isData3DTexture,Pr=k.isDataArrayTexture||k.isData3DTexture;if(A.isDepthTexture){let pt=Ge.get(A),an=Ge.get(k),Kn=Ge.get(pt.__renderTarget),Dt=Ge.get(an.__renderTarget);Me.bindFramebuffer(D.READ_FRAMEBUFFER,Kn.__webglFramebuffer),Me.bindFramebuffer(D.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let yn=0;yn<Ne;yn++)tr&&(D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Ge.get(A).__webglTexture,Z,xt+yn),D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Ge.get(k).__webglTexture,Ee,nn+yn)),D.blitFramebuffer(He,it,He+Fe,it+Ce,Ve,yt,Ve+Fe,yt+Ce,D.DEPTH_BUFFER_BIT,D.NEAREST);Me.bindFramebuffer(D.READ_FRAMEBUFFER,null),Me.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||Ge.has(A)){let pt=Ge.get(A),an=Ge.get(k);Me.bindFramebuffer(D.READ_FRAMEBUFFER,L),Me.bindFramebuffer(D.DRAW_FRAMEBUFFER,V);for(let Kn=0;Kn<Ne;Kn++)tr?D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,pt.__webglTexture,Z,xt+Kn):D.framebufferTexture2D(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,pt.__webglTexture,Z),Pr?D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,an.__webglTexture,Ee,nn+Kn):D.framebufferTexture2D(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,an.__webglTexture,Ee),Z!==0?D.blitFramebuffer(He,it,He+Fe,it+Ce,Ve,yt,Ve+Fe,yt+Ce,D.COLOR_BUFFER_BIT,D.NEAREST):Pr?D.copyTexSubImage3D(Oe,Ee,Ve,yt,nn+Kn,He,it,Fe,Ce):D.copyTexSubImage2D(Oe,Ee,Ve,yt,He,it,Fe,Ce);Me.bindFramebuffer(D.READ_FRAMEBUFFER,null),Me.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else Pr?A.isDataTexture||A.isData3DTexture?D.texSubImage3D(Oe,Ee,Ve,yt,nn,Fe,Ce,Ne,Bt,Mn,Nt.data):k.isCompressedArrayTexture?D.compressedTexSubImage3D(Oe,Ee,Ve,yt,nn,Fe,Ce,Ne,Bt,Nt.data):D.texSubImage3D(Oe,Ee,Ve,yt,nn,Fe,Ce,Ne,Bt,Mn,Nt):A.isDataTexture?D.texSubImage2D(D.TEXTURE_2D,Ee,Ve,yt,Fe,Ce,Bt,Mn,Nt.data):A.isCompressedTexture?D.compressedTexSubImage2D(D.TEXTURE_2D,Ee,Ve,yt,Nt.width,Nt.height,Bt,Nt.data):D.texSubImage2D(D.TEXTURE_2D,Ee,Ve,yt,Fe,Ce,Bt,Mn,Nt);Me.pixelStorei(D.UNPACK_ROW_LENGTH,gn),Me.pixelStorei(D.UNPACK_IMAGE_HEIGHT,bt),Me.pixelStorei(D.UNPACK_SKIP_PIXELS,Rr),Me.pixelStorei(D.UNPACK_SKIP_ROWS,xn),Me.pixelStorei(D.UNPACK_SKIP_IMAGES,lo),Ee===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&D.generateMipmap(Oe),Me.unbindTexture()},this.initRenderTarget=function(A){Ge.get(A).__webglFramebuffer===void 0&&Ke.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ke.setTextureCube(A,0):A.isData3DTexture?Ke.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ke.setTexture2DArray(A,0):Ke.setTexture2D(A,0),Me.unbindTexture()},this.resetState=function(){W=0,z=0,ae=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ii}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};function Mh(n,e,t,i){let r=t<2?t:(t-1)*i+1,s=new Float64Array(3*r),o=new Float64Array(r),a=(c,u)=>e[3*c+u]??0,l=(c,u)=>{let h=Math.max(0,c-1),d=Math.min(t-1,c+1),f=(n[d]??0)-(n[h]??0);return f>0?(a(d,u)-a(h,u))/f:0};for(let c=0;c<r;c++){let u=Math.min(Math.floor(c/i),Math.max(0,t-2)),h=c/i-u,d=n[u]??0,f=t>1?(n[u+1]??0)-d:0;o[c]=d+h*f;for(let m=0;m<3;m++)s[3*c+m]=t<2||h===0?a(u,m):mC(a(u,m),a(u+1,m),f*l(u,m),f*l(u+1,m),h)}return{points:s,times:o,lengths:gC(s)}}function mC(n,e,t,i,r){let s=1-r;return s*s*(1+2*r)*n+r*r*(3-2*r)*e+r*s*s*t-r*r*s*i}function gC(n){let e=new Float64Array(n.length/3);for(let t=1;t<e.length;t++){let i=Math.hypot((n[3*t]??0)-(n[3*t-3]??0),(n[3*t+1]??0)-(n[3*t-2]??0),(n[3*t+2]??0)-(n[3*t-1]??0));e[t]=(e[t-1]??0)+i}return e}var xC=new Wr(1,1,1,14).translate(0,.5,0),yC=new _l(1,1,20).translate(0,.5,0),_C=new Y(0,1,0),Th=class{group=new wn;parts=[];thickness=1;constructor(e){for(let t of[!1,!0]){let i=new _s({color:e,transparent:t,opacity:t?.35:1,depthTest:!t,depthWrite:!t}),r=new Et(xC,i),s=new Et(yC,i);r.renderOrder=s.renderOrder=t?10:2,this.parts.push({shaft:r,head:s}),this.group.add(r,s)}}set(e,t){let i=t.length();if(this.group.visible=Number.isFinite(i)&&i>1e-9,!this.group.visible)return;this.group.position.copy(e),this.group.quaternion.copy(new Li().setFromUnitVectors(_C,t.clone().divideScalar(i)));let r=Math.min(this.thickness,.25*i),s=Math.min(5*r,.6*i);for(let{shaft:o,head:a}of this.parts)o.scale.set(r,i-s,r),a.scale.set(2.6*r,s,2.6*r),a.position.y=i-s}dispose(){for(let{shaft:e}of this.parts)e.material.dispose()}};var zl=class{group=new wn;materials=[];middle=new Y;constructor(e,t){let{hollow:i}=e;for(let r of i?[fn,ci]:[Fi]){let s=bC(this.middle,r,i,t),o=new Et(new Vn,s);o.castShadow=!i,o.renderOrder=r===fn?0:i?8:1,this.materials.push(s),this.group.add(o)}this.reshape(e)}reshape(e){let{low:t,high:i}=Ja(e.positions);this.middle.set(...t).add(new Y(...i)).multiplyScalar(.5);for(let r of this.group.children){if(!(r instanceof Et))continue;r.geometry.dispose();let s=new Vn;s.setAttribute("position",new dn(e.positions,3)),s.setAttribute("normal",new dn(e.normals,3)),s.setIndex(new dn(e.indices,1)),r.geometry=s}}set glass(e){for(let t of this.materials)t.userData.wall!==!0&&(t.opacity=e?.4:1,t.transparent=e,t.depthWrite=!e,t.needsUpdate=!0)}dispose(){for(let e of this.group.children)e instanceof Et&&e.geometry.dispose();for(let e of this.materials)e.dispose()}};function bC(n,e,t,i){let r=t&&e===ci,s=new Xr({color:16777215,specular:new je(3356733),shininess:42,side:e,transparent:r,opacity:r?.16:1,depthWrite:!r});s.userData.wall=r;let o=t?i.shell:i.body;return s.onBeforeCompile=a=>{a.uniforms.uMiddle={value:n},a.uniforms.uFirst={value:new je(o[0])},a.uniforms.uSecond={value:new je(o[1])},a.uniforms.uSeam={value:new je(i.seam)},a.vertexShader=a.vertexShader.replace("#include <common>",`#include <common>
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
        #include <opaque_fragment>`)},s}function Ry(n,e){let t=new wn,i=new li({transparent:!0,depthWrite:!1,uniforms:{colour:{value:new je(e.grid)},spacing:{value:n},middle:{value:new Y},reach:{value:1}},vertexShader:`varying vec2 vPlace;
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
      }`}),r=new Et(new vs(1,1),i),s=new Et(new vs(1,1),new bl({opacity:e.shadow,depthWrite:!1}));s.receiveShadow=!0,r.renderOrder=-2,s.renderOrder=-1,r.frustumCulled=s.frustumCulled=!1,t.add(r,s);let o=[r,s].map(a=>a.geometry.getAttribute("position"));return{group:t,spacing:n,around(a,l,c,u){Ey(o[0],a,l),Ey(o[1],c,u),(i.uniforms.middle?.value).set(...a);let h=i.uniforms.reach;h&&(h.value=l)}}}function Ey(n,[e,t],i){if(n!==void 0){for(let r=0;r<4;r++)n.setXYZ(r,e+i*(r%2?1:-1),t+i*(r<2?1:-1),0);n.needsUpdate=!0}}function Py(n,e,t,i){let r=t>=Math.PI,s=e&&!r?Math.PI-t:0,o=new qr(n,128,80,0,2*Math.PI,s,r?Math.PI:t);o.rotateX(Math.PI/2);let a=(t>.8?15:5)*(Math.PI/180);return Fy(o,e,Ly.graticule(a),i)}function Iy(n,e,t){let i=new Vn;return i.setAttribute("position",new dn(n.positions,3)),i.setAttribute("normal",new dn(n.normals,3)),i.setIndex(new dn(n.indices,1)),Fy(i,!1,Ly.planes(e),t)}var Ly={graticule:n=>`
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
    float lines = max(ink.x, max(ink.y, ink.z));`};function Fy(n,e,t,i){let r=new wn,[s,o]=e?[fn,ci]:[ci,fn],a=new Et(n,Cy(s,1,t,i));a.receiveShadow=!0,a.renderOrder=-2;let l=new Et(n,Cy(o,.14,t,i));return l.renderOrder=9,r.add(a,l),{group:r,spacing:0,around:()=>{}}}function Cy(n,e,t,i){let r=e<1,s=new vl({color:i.ground[0],side:n,transparent:r,opacity:e,depthWrite:!r});return s.onBeforeCompile=o=>{o.uniforms.uLine={value:new je(i.grid)},o.vertexShader=o.vertexShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vOwn = position;
vTurn = normalize(normal);`),o.fragmentShader=o.fragmentShader.replace("#include <common>",`#include <common>
varying vec3 vOwn;
varying vec3 vTurn;
uniform vec3 uLine;`).replace("#include <color_fragment>",`${t}
        diffuseColor.rgb = mix(diffuseColor.rgb, uLine, 0.7 * lines);
        ${r?"diffuseColor.a = mix(diffuseColor.a, 0.4, 0.6 * lines);":""}`)},s.customProgramCacheKey=()=>t+String(r),s}function Ny(n,e){return e!==null&&n.positions.length===e.positions.length&&n.positions.every((t,i)=>t===e.positions[i])}function hp(n,e){let t=n.columns[e];if(t===void 0)return 0;let i=0;for(let r=0;r+2<t.length;r+=3){let s=Math.hypot(t[r]??0,t[r+1]??0,t[r+2]??0);s>i&&(i=s)}return i}function By(n){let[e,t]=[1/0,-1/0];for(let s=0;s<n.length;s++)e=Math.min(e,n[s]??e),t=Math.max(t,n[s]??t);let i=(t-e)/12,r=10**Math.floor(Math.log10(i));return([1,2,5,10].find(s=>s*r>=i*(1-1e-9))??10)*r}var Eh=class{constructor(e,t,i){this.mark=t;let r=new Xr({color:i.dark?"#8fa6bb":"#33424f",specular:2236962}),s=new Xr({color:i.body[1],specular:2236962}),o=new Xr({color:i.body[0],specular:2236962});for(let a of e){let l=new wn;for(let c of vC(a.kind,t,{dark:r,rod:s,joint:o}))c.castShadow=!0,l.add(c);this.parts.push({link:a,group:l}),this.group.add(l)}}mark;group=new wn;parts=[];at(e,t){for(let{link:i,group:r}of this.parts){let s=i.kind==="rod"?4:i.kind==="point"?2:3,o=mi(e,i.column,s,t);if(r.visible=o!==null&&o.every(Number.isFinite),o===null)continue;let[a=0,l=0,c=0,u=0]=o;if(i.kind==="rod"){let h=Math.hypot(c-a,u-l);r.position.set((a+c)/2,(l+u)/2,.5*this.mark),r.rotation.z=Math.atan2(u-l,c-a),r.scale.x=h}else r.position.set(a,l,0),r.rotation.z=i.kind==="point"?0:c}}};function vC(n,e,{dark:t,rod:i,joint:r}){let s=e/2;switch(n){case"rod":return[new Et(new Gr(1,.14*e,.1*e),i)];case"wheel":return[dp(s,.3*e,0,t)];case"axle":{let o=new Et(new Wr(.06*e,.06*e,1.1*e,12),i);return o.position.z=.75*s,[o,dp(.75*s,.24*e,.55*e,t),dp(.75*s,.24*e,-.55*e,t)]}case"blade":{let o=new Et(new Gr(1.3*e,.06*e,.45*e),t);return o.position.z=.225*e,[o]}case"point":{let o=new Et(new qr(.16*e,24,16),r);return o.position.z=.5*e,[o]}}}function dp(n,e,t,i){let r=new Et(new Wr(n,n,e,32),i);return r.position.set(0,t,n),r}var fp=5,wC=`
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
}`,SC=`
uniform vec3 scale[${fp}];
uniform vec2 span;
uniform vec2 now;
uniform float tail;
uniform float before;
uniform float after;
varying vec2 vMark;
void main() {
  float share = clamp((vMark.x - span.x) / (span.y - span.x), 0.0, 1.0) * ${(fp-1).toFixed(1)};
  vec3 colour = scale[0];
  for (int k = 1; k < ${fp}; k++) colour = mix(colour, scale[k], clamp(share - float(k - 1), 0.0, 1.0));
  float alpha = vMark.x <= now.x ? before : after;
  if (vMark.x <= now.x) alpha *= 1.0 - smoothstep(0.6 * tail, tail, now.y - vMark.y);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(colour, alpha);
  #include <colorspace_fragment>
}`,Vl=class{mesh;curve;constructor(e,t,i){this.curve=e;let r=e.times.length,s=Dy(e),o=new li({vertexShader:wC,fragmentShader:SC,transparent:!0,depthWrite:!1,uniforms:{screen:{value:new dt(1,1)},width:{value:t.width},lift:{value:4e-4},scale:{value:i.map(a=>new je(a))},span:{value:new dt(e.times[0]??0,Math.max(e.times[r-1]??1,(e.times[0]??0)+1e-12))},now:{value:new dt(1/0,0)},tail:{value:t.tail},before:{value:t.before},after:{value:t.after}}});this.mesh=new Et(s,o),this.mesh.frustumCulled=!1,this.mesh.renderOrder=4}at(e){let{times:t,lengths:i}=this.curve,r=0,s=t.length-1;for(;s-r>1;){let c=r+s>>1;(t[c]??0)<=e?r=c:s=c}let o=e>=(t[s]??0)?s:r;if(this.uniform("now").set(e,i[o]??0),this.uniform("after")>0)return;let a=(i[o]??0)-this.uniform("tail"),l=o;for(;l>0&&(i[l]??0)>a;)l-=1;this.mesh.geometry.setDrawRange(6*l,6*(o-l+1))}reshape(e){this.curve=e,this.mesh.geometry.dispose(),this.mesh.geometry=Dy(e);let t=e.times[0]??0;this.uniform("span").set(t,Math.max(e.times.at(-1)??1,t+1e-12))}resize(e,t){this.uniform("screen").set(e,t)}dispose(){this.mesh.geometry.dispose(),this.mesh.material.dispose()}uniform(e){return this.mesh.material.uniforms[e]?.value}},pp=12;function Dy({points:n,times:e,lengths:t}){let i=Math.max(0,e.length-1),r=new Float32Array(4*pp*i),s=new Uint32Array(6*i);for(let c=0;c<i;c++){for(let u=0;u<4;u++){let h=pp*(4*c+u);r.set(n.subarray(3*c,3*c+6),h),r.set([u&1,u&2?1:-1,e[c]??0,t[c]??0,e[c+1]??0,t[c+1]??0],h+6)}s.set([0,1,2,2,1,3].map(u=>4*c+u),6*c)}let o=new Vn,a=new pl(r,pp),l=(c,u,h)=>{o.setAttribute(c,new ml(a,u,h))};return l("position",3,0),l("to",3,3),l("corner",2,6),l("fromMark",2,8),l("toMark",2,10),o.setIndex(new dn(s,1)),o}function mp(n,e,t=32,i=64){let r=[],s=[],o=[];for(let a=0;a<=t;a++){let l=Math.PI*a/t;for(let c=0;c<i;c++){let u=2*Math.PI*c/i,h=[Math.sin(l)*Math.cos(u),Math.sin(l)*Math.sin(u),Math.cos(l)],d=h.map((g,p)=>g/(n[p]??1)),f=Math.hypot(...d);if(r.push(...bo(e,h.map((g,p)=>g*(n[p]??1)))),s.push(...bo(e,d.map(g=>g/f))),a===t)continue;let[m,b]=[a*i+c,a*i+(c+1)%i];o.push(m,m+i,b+i,m,b+i,b)}}return{positions:Float32Array.from(r),normals:Float32Array.from(s),indices:Uint32Array.from(o),hollow:!1}}var AC=6.3,MC=.9,Uy=1200,Ch=class{constructor(e,t,i,r,s){this.canvas=e;this.scene=t;this.surface=i;this.motion=r;this.shown=s;this.size=t.size>0?t.size:1,this.renderer=new wh({canvas:e,antialias:!0,alpha:!0,powerPreference:"high-performance"}),this.renderer.shadowMap.enabled=!0,this.renderer.shadowMap.type=Xs,this.camera.up.set(0,0,1),this.metres.scale.setScalar(1/this.size),this.world.add(this.metres,this.lamp,this.lamp.target),this.metres.add(this.bodyFrame),this.view=qd(t,r,this.size),this.lamp.castShadow=!0,this.lamp.shadow.mapSize.set(1024,1024),this.lamp.shadow.radius=5,this.lamp.shadow.bias=-2e-4,this.lamp.shadow.normalBias=.01;let o=1.6;Object.assign(this.lamp.shadow.camera,{left:-o,right:o,top:o,bottom:-o,near:.5,far:14}),this.build()}canvas;scene;surface;motion;shown;view;size;renderer;camera=new ni(Pc*180/Math.PI,1,.05,500);world=new hl;metres=new wn;lamp=new Tl(16777215,2.1);bodyFrame=new wn;colours=Qt();body=null;ground=null;linkage=null;path=null;trace=null;arrows=new Map;inertia=null;centreMark=null;reach=4;width=1;height=1;setMotion(e,t){this.motion=e;let i=this.surface;if(this.surface=t,this.path===null||this.trace===null!=!this.leavesTrace||e.columns.attitude===void 0)return this.build();t!==null&&!Ny(t,i)&&this.body?.reshape(t);let r=this.curveOf("contact");this.reach=$d(this.scene.path!==null?this.planPath().points:r.points,this.size),this.scene.support?.kind==="sphere"&&(this.ground!==null&&this.metres.remove(this.ground.group),this.buildGround(r.points)),this.path.reshape(this.scene.path!==null?this.planPath():r),this.trace?.reshape(this.traceOnBody());for(let{name:s,column:o}of this.scene.vectors){let a=this.arrows.get(s);a!==void 0&&(a.scale=hp(e,o)||a.scale)}}get leavesTrace(){let{columns:e}=this.motion;return this.body!==null&&e.contact!==void 0&&e.attitude!==void 0}get spacing(){return this.ground?.spacing??0}recolour(){this.colours=Qt(),this.build()}reset(){this.view=qd(this.scene,this.motion,this.size,this.width/this.height)}zoom(e){this.view=ja(this.view,e)}vectorScale(e){return this.arrows.get(e)?.scale??0}resize(e,t,i=Math.min(window.devicePixelRatio||1,2)){if(e<1||t<1)return;let r=this.width===1;this.width=e,this.height=t,this.renderer.setPixelRatio(i),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.path?.resize(e,t),this.trace?.resize(e,t),r&&this.reset()}draw(e){if(this.width===1)return;let t=Fa(this.motion,e);this.place(t),this.shown.follow&&this.follow(t);let i=new Y(...this.view.target);this.camera.position.set(...I0(this.view)),this.camera.near=Math.max(.02,this.view.distance/60),this.camera.far=this.view.distance+6*this.reach+60,this.camera.updateProjectionMatrix(),this.camera.lookAt(i);let r=this.view.target.map(l=>l*this.size),s=Math.min(Math.max(this.reach,2),.62*this.view.distance),o=this.placeOf(t);this.ground?.around(r,s*this.size,o,1.7*this.size);let a=new Y(...o).divideScalar(this.size);this.lamp.target.position.copy(a),this.lamp.position.copy(a).add(this.lampDirection().multiplyScalar(6)),this.renderer.render(this.world,this.camera)}async sized(e,t,i,r){let[s,o]=[this.width,this.height];this.resize(e,t,i);try{return await r()}finally{this.resize(s,o)}}picture(e){this.draw(e);let t=document.createElement("canvas");t.width=this.canvas.width,t.height=this.canvas.height;let i=t.getContext("2d");return i!==null&&(i.fillStyle=this.colours.paper,i.fillRect(0,0,t.width,t.height),i.drawImage(this.canvas,0,0)),t}dispose(){this.clear(),this.renderer.dispose()}lampDirection(){let{azimuth:e}=this.view,t=new Y(-Math.sin(e),Math.cos(e),0),i=new Y(Math.cos(e),Math.sin(e),0);return t.multiplyScalar(-.35).addScaledVector(i,.2).add(new Y(0,0,1)).normalize()}follow(e){let[t,i,r]=this.placeOf(e);this.view={...this.view,target:[t/this.size,i/this.size,r/this.size]}}placeOf(e){let{path:t}=this.scene;if(t===null)return e.centre;let[i=0,r=0]=mi(this.motion,t,2,e.t)??[];return[i,r,0]}clear(){this.body?.dispose(),this.path?.dispose(),this.trace?.dispose();for(let{arrow:e}of this.arrows.values())e.dispose();this.arrows.clear(),this.bodyFrame.clear(),this.metres.clear(),this.metres.add(this.bodyFrame);for(let e of this.world.children.filter(t=>t instanceof ia))this.world.remove(e);this.body=this.ground=this.linkage=this.path=this.trace=this.inertia=this.centreMark=null}build(){this.clear();let{scene:e,colours:t,motion:i}=this;this.world.add(new ia(16777215,t.dark?8226964:12174027,1.5)),this.buildBody();let r=this.curveOf("contact");this.buildGround(r.points),e.links.length>0&&(this.linkage=new Eh(e.links,.2*this.size,t),this.metres.add(this.linkage.group)),this.path=new Vl(e.path!==null?this.planPath():r,{width:3,before:1,after:.16,tail:1/0},t.time),this.metres.add(this.path.mesh),this.leavesTrace&&(this.trace=new Vl(this.traceOnBody(),{width:2.2,before:1,after:0,tail:AC*this.size},t.time),this.bodyFrame.add(this.trace.mesh));for(let[s,o]of e.vectors.entries()){let a=hp(i,o.column);if(!(a>0))continue;let l=new Th(t.components[s%3]??t.ink);this.arrows.set(o.name,{arrow:l,scale:a}),this.metres.add(l.group)}this.path.resize(this.width,this.height),this.trace?.resize(this.width,this.height)}buildBody(){let{scene:e,colours:t}=this,i=e.inertia_axes,r=this.surface;if(!(this.motion.columns.attitude!==void 0))return;let o=i?.5*this.size/Math.max(...i):0,a=i?.map(c=>c*o),l=r??(a?mp(a,e.inertia_turn):null);if(l!==null&&(this.body=new zl(l,t),this.bodyFrame.add(this.body.group)),a&&r!==null){let c=a.map(h=>.8*h),u=new zl(mp(c,e.inertia_turn),{...t,body:["#efd9a4","#c77d4f"]});this.inertia=new Et,this.inertia.add(u.group),this.bodyFrame.add(this.inertia)}this.centreMark=new Et(new qr(.028*this.size,24,16),new _s({color:t.alarm,depthTest:!1,transparent:!0})),this.centreMark.renderOrder=11,this.bodyFrame.add(this.centreMark)}buildGround(e){let{scene:t,colours:i,size:r}=this;this.reach=$d(t.path!==null?this.planPath().points:e,r);let s=t.support??(t.path===null?null:{kind:"plane"});if(!(s===null||s.kind==="point")){if(s.kind==="plane")this.ground=Ry(ec(Math.max(.5,this.reach/16)*r),i);else if(s.kind==="sphere"){let o=Math.hypot(e[0]??NaN,e[1]??NaN,e[2]??NaN)||Math.abs(s.radius),a=s.inside?.3:Math.max(.12,.75*r/o),c=this.surface?.hollow===!0?Math.PI:Ka(e,s.inside?-1:1,a,s.inside?1.75:1.2);this.ground=Py(o,s.inside,c,i)}else{let o=Vs(s.positions),a={positions:o,normals:Vs(s.normals),indices:S0(s.indices)};this.ground=Iy(a,By(o),i)}this.metres.add(this.ground.group)}}curveOf(e){let t=this.motion.columns[e]?e:"centre",i=as(this.motion,t,3),r=Math.max(1,Math.min(6,Math.ceil(Uy/Math.max(1,i))));return Mh(this.motion.times,this.motion.columns[t]??new Float64Array(0),i,r)}planPath(){let e=Yd(this.scene,this.motion);return Mh(this.motion.times,e,e.length/3,4)}traceOnBody(){let{motion:e}=this,t=Math.min(as(e,"contact",3),as(e,"attitude",4)),i=new Float64Array(3*t);for(let r=0;r<t;r++){let s=e.times[r]??0,{attitude:o,centre:a,contact:l}=Fa(e,s),c=l.map((u,h)=>u-(a[h]??0));i.set(Gm(o,c),3*r)}return Mh(e.times,i,t,Math.max(1,Math.min(6,Math.ceil(Uy/Math.max(1,t)))))}place(e){let{shown:t}=this,[i,r,s,o]=e.attitude;this.bodyFrame.position.set(...e.centre),this.bodyFrame.quaternion.set(r,s,o,i),this.body!==null&&(this.body.glass=t.inertia&&this.inertia!==null||t.centre),this.inertia!==null&&(this.inertia.visible=t.inertia),this.centreMark!==null&&(this.centreMark.visible=t.centre),this.linkage?.at(this.motion,e.t);for(let[a,l]of[[this.path,t.trace],[this.trace,t.traceOnBody]])a!==null&&(a.mesh.visible=l,a.at(e.t));for(let a of this.scene.vectors){let l=this.arrows.get(a.name);if(l===void 0)continue;let c=mi(this.motion,a.column,3,e.t);if(l.arrow.group.visible=t.vectors.has(a.name)&&c!==null,!l.arrow.group.visible||c===null)continue;let u=a.axes==="body"?bo(e.attitude,c):c,h=MC*this.size/l.scale;l.arrow.thickness=.0026*this.view.distance*this.size;let d=a.at==="contact"?e.contact:e.centre;l.arrow.set(new Y(...d),new Y(...u).multiplyScalar(h))}}};function Oy(n){let{scene:e}=n.model,t=n.shown.value;if(!TC(n))return null;let i=se("canvas",{class:"lab-canvas","aria-hidden":!0}),r=se("div",{class:"lab-legend"}),s=se("div",{class:"lab-note"}),o=se("div",{class:"lab-timebar","aria-hidden":!0}),a=se("div",{class:"lab-scene",tabindex:0,role:"application","aria-label":`${n.model.title}: the motion in space. Arrow keys turn the view, plus and minus zoom, space plays, question mark lists all keys.`},i,r,o,s),l={trace:!0,traceOnBody:!0,inertia:!1,centre:!1,follow:Xd(e,t.motion),vectors:new Set(e.vectors.filter(({column:g})=>g==="omega").map(({name:g})=>g))},c;try{c=new Ch(i,e,t.surface,t.motion,l)}catch{return null}let u=0,h=()=>{u===0&&(u=requestAnimationFrame(()=>{u=0,c.draw(n.clock.time.value),f()}))},d=new Map,f=()=>{let{motion:g}=n.shown.value;for(let p of e.vectors){let _=mi(g,p.column,3,n.clock.time.value),T=d.get(p.name);T&&_&&(T.textContent=`${St(Math.hypot(..._),3)} ${Wn(p.unit)}`)}},m=()=>{d.clear();let g=Qt();r.replaceChildren(...e.vectors.flatMap((_,T)=>{if(!l.vectors.has(_.name))return[];let w=se("span",{class:"lab-number"});d.set(_.name,w);let C=se("span",{class:"lab-arrow",style:`background:${g.components[T%3]??""}`});return[se("div",{},C,ky(_),w)]}));let p=n.clock.until;o.replaceChildren(se("span",{},"t = 0"),se("i",{style:`background:linear-gradient(90deg,${g.time.join(",")})`}),se("span",{},`${St(p)} s`)),s.textContent=c.spacing>0?`grid ${St(c.spacing)} m`:""},b=EC(n,c,l,()=>{m(),h()});return B0(a,c,g=>{g&&b.dispatchEvent(new CustomEvent("unfollow")),h()}),CC(a,n,c,b,h),new ResizeObserver(()=>{c.resize(a.clientWidth,a.clientHeight),c.draw(n.clock.time.value)}).observe(a),n.clock.time.after(h),n.shown.after(({motion:g,surface:p})=>{c.setMotion(g,p),m(),h()}),yo(()=>{c.recolour(),m(),h()}),m(),h(),{element:a,stage:c,switches:b,refresh:h}}function TC(n){let{columns:e}=n.shown.value.motion;return e.attitude!==void 0||n.model.scene.path!==null||e.contact!==void 0}function ky(n){return n.mathml?rs(n.mathml):document.createTextNode(n.name)}function EC(n,e,t,i){let{scene:r}=n.model,s=se("div",{class:"lab-switches",role:"toolbar","aria-label":"What is shown"}),o=(c,u,h,d,f)=>{let m=Ls(c,`${u} (${h})`,d,b=>{f(b),i()});return m.dataset.key=h,s.append(m),m},a=o("follow","Keep the body in the middle","f",t.follow,c=>t.follow=c);s.addEventListener("unfollow",()=>{t.follow=!1,a.setAttribute("aria-pressed","false")}),o("path","Path on the ground","p",t.trace,c=>t.trace=c),r.path===null&&o("trace","Trace of the contact on the body","t",t.traceOnBody,c=>t.traceOnBody=c),r.vectors.forEach((c,u)=>{if(e.vectorScale(c.name)===0)return;let h=t.vectors.has(c.name);o(ky(c),`Vector ${c.name}`,String(u+1),h,d=>{let f=new Set(t.vectors);d?f.add(c.name):f.delete(c.name),t.vectors=f})}),r.inertia_axes!==null&&r.body!==null&&o("inertia","Inertia ellipsoid","i",t.inertia,c=>t.inertia=c),r.path===null&&o("centre","Centre of mass","c",t.centre,c=>t.centre=c);let l=se("button",{type:"button",title:"Whole view (r)","data-key":"r"},"whole view");return l.addEventListener("click",()=>{e.reset(),i()}),s.append(l),s}var zy=[["space","play or pause"],["← →, ↑ ↓","turn the view"],[", .","one sample back, on"],["Home, End","to the start, to the end"],["[ ]","slower, faster"],["+ −","nearer, farther"],["f","keep the body in the middle"],["p, t","path on the ground, trace on the body"],["1 2 3","vectors"],["i, c","inertia ellipsoid, centre of mass"],["r","whole view"],["Ctrl+Z, Ctrl+Shift+Z","undo, redo"]];function CC(n,e,t,i,r){let{clock:s}=e,o=(u,h)=>{t.view=Ic(t.view,u,h),r()},a=u=>{t.zoom(u),r()},l=u=>{let{times:h}=e.shown.value.motion;s.pause(),s.seek(s.time.value+u*((h[1]??0)-(h[0]??0)))},c={" ":()=>s.toggle(),ArrowLeft:()=>o(-.04,0),ArrowRight:()=>o(.04,0),ArrowUp:()=>o(0,-.04),ArrowDown:()=>o(0,.04),",":()=>l(-1),".":()=>l(1),Home:()=>s.seek(0),End:()=>s.seek(s.until),"[":()=>s.changeSpeed(-1),"]":()=>s.changeSpeed(1),"+":()=>a(1/1.15),"=":()=>a(1/1.15),"-":()=>a(1.15)};n.addEventListener("keydown",u=>{if(u.ctrlKey||u.metaKey||u.altKey)return;let h=c[u.key],d=i.querySelector(`[data-key="${CSS.escape(u.key.toLowerCase())}"]`);h===void 0&&d===null||(u.preventDefault(),h!==void 0?h():d?.click())})}function Vy(){let n=zy.map(([e,t])=>se("tr",{},se("th",{scope:"row"},se("kbd",{},e)),se("td",{},t)));return se("div",{},se("p",{class:"lab-hint"},"Keys act while the scene, a section or a chart has the focus: click into it, or go there with Tab. With the pointer: drag turns, Shift and drag moves, the wheel zooms; with two fingers as usual."),se("table",{class:"lab-keys"},...n))}function Hy(n){return n.shown.after(({experiment:e})=>{let t=hd(e,n.model,{});try{history.replaceState(history.state,"",t===""?location.pathname+location.search:t)}catch{}}),()=>{let e=n.clock.time.value,t=e>0?{t:String(Number(e.toPrecision(6)))}:{},i=hd(n.shown.value.experiment,n.model,t);return(location.href.split("#")[0]??"")+(i||"")}}var Gy=0;function gp(n,e,t=()=>{}){Gy+=1;let i=se("div",{role:"tablist","aria-label":n,class:"lab-tabs"}),r=[],s=e.map(({name:a,title:l,content:c})=>{let u=`lab-${Gy}-${a}`,h=se("button",{type:"button",role:"tab",id:`${u}-tab`,"aria-controls":u},l),d=se("div",{role:"tabpanel",id:u,"aria-labelledby":`${u}-tab`,class:`lab-panel lab-panel-${a}`},c);return i.append(h),r.push(d),h}),o=(a,l)=>{s.forEach((u,h)=>{let d=h===a;u.setAttribute("aria-selected",String(d)),u.tabIndex=d?0:-1;let f=r[h];f&&(f.hidden=!d)}),l&&s[a]?.focus();let c=e[a];c!==void 0&&(c.shown?.(),t(c.name))};return s.forEach((a,l)=>a.addEventListener("click",()=>o(l,!1))),i.addEventListener("keydown",a=>{let l=s.findIndex(h=>h===document.activeElement),u={ArrowRight:l+1,ArrowLeft:l-1,Home:0,End:s.length-1}[a.key];u!==void 0&&(a.preventDefault(),o((u+s.length)%s.length,!0))}),o(0,!1),{element:se("section",{class:"lab-deck","aria-label":n},i,...r),select:a=>{let l=e.findIndex(c=>c.name===a);l>=0&&o(l,!1)}}}var RC="uplot",PC="u-hz",IC="u-vt",LC="u-title",FC="u-wrap",NC="u-under",BC="u-over",DC="u-axis",to="u-off",UC="u-select",OC="u-cursor-x",kC="u-cursor-y",zC="u-cursor-pt",VC="u-legend",HC="u-live",GC="u-inline",WC="u-series",qC="u-marker",Wy="u-label",XC="u-value",Gl="width",Wl="height";var qy="bottom",ha="left",xp="right",Np="#000",Xy=Np+"0",yp="mousemove",$y="mousedown",_p="mouseup",Yy="mouseenter",Zy="mouseleave",Ky="dblclick",$C="resize",YC="scroll",Jy="change",Fh="dppxchange",Bp="--",ya=typeof window<"u",Ap=ya?document:null,fa=ya?window:null,ZC=ya?navigator:null,It,Rh;function Mp(){let n=devicePixelRatio;It!=n&&(It=n,Rh&&Ep(Jy,Rh,Mp),Rh=matchMedia(`(min-resolution: ${It-.001}dppx) and (max-resolution: ${It+.001}dppx)`),no(Jy,Rh,Mp),fa.dispatchEvent(new CustomEvent(Fh)))}function wi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Tp(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Ki(n,e,t,i){let r=Ap.createElement(n);return e!=null&&wi(r,e),t?.insertBefore(r,i),r}function Ni(n,e){return Ki("div",n,e)}var jy=new WeakMap;function Tr(n,e,t,i,r){let s="translate("+e+"px,"+t+"px)",o=jy.get(n);s!=o&&(n.style.transform=s,jy.set(n,s),e<0||t<0||e>i||t>r?wi(n,to):Tp(n,to))}var Qy=new WeakMap;function e_(n,e,t){let i=e+t,r=Qy.get(n);i!=r&&(Qy.set(n,i),n.style.background=e,n.style.borderColor=t)}var t_=new WeakMap;function n_(n,e,t,i){let r=e+""+t,s=t_.get(n);r!=s&&(t_.set(n,r),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Dp={passive:!0},KC={...Dp,capture:!0};function no(n,e,t,i){e.addEventListener(n,t,i?KC:Dp)}function Ep(n,e,t,i){e.removeEventListener(n,t,Dp)}ya&&Mp();function Ji(n,e,t,i){let r;t=t||0,i=i||e.length-1;let s=i<=2147483647;for(;i-t>1;)r=s?t+i>>1:Si((t+i)/2),e[r]<n?t=r:i=r;return n-e[t]<=e[i]-n?t:i}function P_(n){return(t,i,r)=>{let s=-1,o=-1;for(let a=i;a<=r;a++)if(n(t[a])){s=a;break}for(let a=r;a>=i;a--)if(n(t[a])){o=a;break}return[s,o]}}var I_=n=>n!=null,L_=n=>n!=null&&n>0,Dh=P_(I_),JC=P_(L_);function jC(n,e,t,i=0,r=!1){let s=r?JC:Dh,o=r?L_:I_;[e,t]=s(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Ht,l??-Ht]}function Uh(n,e,t,i){let r=s_(n),s=s_(e);n==e&&(r==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Kr:F_,a=r==1?Si:Bi,l=s==1?Bi:Si,c=a(o(Rn(n))),u=l(o(Rn(e))),h=pa(t,c),d=pa(t,u);return t==10&&(c<0&&(h=Gt(h,-c)),u<0&&(d=Gt(d,-u))),i||t==2?(n=h*r,e=d*s):(n=U_(n,h),e=Oh(e,d)),[n,e]}function Up(n,e,t,i){let r=Uh(n,e,t,i);return n==0&&(r[0]=0),e==0&&(r[1]=0),r}var Op=.1,i_={mode:3,pad:Op},Xl={pad:0,soft:null,mode:0},QC={min:Xl,max:Xl};function Nh(n,e,t,i){return kh(t)?r_(n,e,t):(Xl.pad=t,Xl.soft=i?0:null,Xl.mode=i?3:0,r_(n,e,QC))}function Rt(n,e){return n??e}function eR(n,e,t){for(e=Rt(e,0),t=Rt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function r_(n,e,t){let i=t.min,r=t.max,s=Rt(i.pad,0),o=Rt(r.pad,0),a=Rt(i.hard,-Ht),l=Rt(r.hard,Ht),c=Rt(i.soft,Ht),u=Rt(r.soft,-Ht),h=Rt(i.mode,0),d=Rt(r.mode,0),f=e-n,m=Kr(f),b=ri(Rn(n),Rn(e)),g=Kr(b),p=Rn(g-m);(f<1e-24||p>10)&&(f=0,(n==0||e==0)&&(f=1e-24,h==2&&c!=Ht&&(s=0),d==2&&u!=-Ht&&(o=0)));let _=f||b||1e3,T=Kr(_),w=pa(10,Si(T)),C=_*(f==0?n==0?.1:1:s),E=Gt(U_(n-C,w/10),24),x=n>=c&&(h==1||h==3&&E<=c||h==2&&E>=c)?c:Ht,M=ri(a,E<x&&n>=x?x:ji(x,E)),O=_*(f==0?e==0?.1:1:o),N=Gt(Oh(e+O,w/10),24),I=e<=u&&(d==1||d==3&&N>=u||d==2&&N<=u)?u:-Ht,U=ji(l,N>I&&e<=I?I:ri(I,N));return M==U&&M==0&&(U=100),[M,U]}var tR=new Intl.NumberFormat(ya?ZC.language:"en-US"),kp=n=>tR.format(n),Ai=Math,Lh=Ai.PI,Rn=Ai.abs,Si=Ai.floor,Cn=Ai.round,Bi=Ai.ceil,ji=Ai.min,ri=Ai.max,pa=Ai.pow,s_=Ai.sign,Kr=Ai.log10,F_=Ai.log2,nR=(n,e=1)=>Ai.sinh(n)*e,bp=(n,e=1)=>Ai.asinh(n/e),Ht=1/0;function o_(n){return(Kr((n^n>>31)-(n>>31))|0)+1}function Cp(n,e,t){return ji(ri(n,e),t)}function N_(n){return typeof n=="function"}function wt(n){return N_(n)?n:()=>n}var iR=()=>{},B_=n=>n,D_=(n,e)=>e,rR=n=>null,a_=n=>!0,l_=(n,e)=>n==e,sR=/\.\d*?(?=9{6,}|0{6,})/gm,io=n=>{if(k_(n)||Es.has(n))return n;let e=`${n}`,t=e.match(sR);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[r,s]=e.split("e");return+`${io(r)}e${s}`}return Gt(n,i)};function Qs(n,e){return io(Gt(io(n/e))*e)}function Oh(n,e){return io(Bi(io(n/e))*e)}function U_(n,e){return io(Si(io(n/e))*e)}function Gt(n,e=0){if(k_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Cn(i)/t}var Es=new Map;function O_(n){return((""+n).split(".")[1]||"").length}function Yl(n,e,t,i){let r=[],s=i.map(O_);for(let o=e;o<t;o++){let a=Rn(o),l=Gt(pa(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,h=(o>=0?0:a)+(o>=s[c]?0:s[c]),d=n==10?u:Gt(u,h);r.push(d),Es.set(d,h)}}return r}var $l={},zp=[],ma=[null,null],Ts=Array.isArray,k_=Number.isInteger,oR=n=>n===void 0;function c_(n){return typeof n=="string"}function kh(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function aR(n){return n!=null&&typeof n=="object"}var lR=Object.getPrototypeOf(Uint8Array),z_="__proto__";function ga(n,e=kh){let t;if(Ts(n)){let i=n.find(r=>r!=null);if(Ts(i)||e(i)){t=Array(n.length);for(let r=0;r<n.length;r++)t[r]=ga(n[r],e)}else t=n.slice()}else if(n instanceof lR)t=n.slice();else if(e(n)){t={};for(let i in n)i!=z_&&(t[i]=ga(n[i],e))}else t=n;return t}function Sn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let r in i)r!=z_&&(kh(n[r])?Sn(n[r],ga(i[r])):n[r]=ga(i[r]))}return n}var cR=0,uR=1,hR=2;function dR(n,e,t){for(let i=0,r,s=-1;i<e.length;i++){let o=e[i];if(o>s){for(r=o-1;r>=0&&n[r]==null;)n[r--]=null;for(r=o+1;r<t&&n[r]==null;)n[s=r++]=null}}}function fR(n,e){if(gR(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return xR(o[0])||(o=mR(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],r=i[0].length,s=new Map;for(let o=0;o<r;o++)s.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(r).fill(void 0),d=e?e[o][c]:uR,f=[];for(let m=0;m<u.length;m++){let b=u[m],g=s.get(l[m]);b===null?d!=cR&&(h[g]=b,d==hR&&f.push(g)):h[g]=b}dR(h,f,r),i.push(h)}}return i}var pR=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function mR(n){let e=n[0],t=e.length,i=Array(t);for(let s=0;s<i.length;s++)i[s]=s;i.sort((s,o)=>e[s]-e[o]);let r=[];for(let s=0;s<n.length;s++){let o=n[s],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];r.push(a)}return r}function gR(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let r=n[i][0];if(r.length!=t)return!1;if(r!=e){for(let s=0;s<t;s++)if(r[s]!=e[s])return!1}}return!0}function xR(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,r=t-1;for(;i<=r&&n[i]==null;)i++;for(;r>=i&&n[r]==null;)r--;if(r<=i)return!0;let s=ri(1,Si((r-i+1)/e));for(let o=n[i],a=i+s;a<=r;a+=s){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var V_=["January","February","March","April","May","June","July","August","September","October","November","December"],H_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function G_(n){return n.slice(0,3)}var yR=H_.map(G_),_R=V_.map(G_),bR={MMMM:V_,MMM:_R,WWWW:H_,WWW:yR};function Hl(n){return(n<10?"0":"")+n}function vR(n){return(n<10?"00":n<100?"0":"")+n}var wR={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Hl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Hl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Hl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Hl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Hl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>vR(n.getMilliseconds())};function Vp(n,e){e=e||bR;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,r;for(;r=i.exec(n);)t.push(r[0][0]=="{"?wR[r[1]]:r[0]);return s=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](s,e);return o}}var SR=new Intl.DateTimeFormat().resolvedOptions().timeZone;function AR(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==SR?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var W_=n=>n%1==0,Bh=[1,2,2.5,5],MR=Yl(10,-32,0,Bh),q_=Yl(10,0,32,Bh),TR=q_.filter(W_),eo=MR.concat(q_),Hp=`
`,X_="{YYYY}",u_=Hp+X_,$_="{M}/{D}",ql=Hp+$_,Ph=ql+"/{YY}",Y_="{aa}",ER="{h}:{mm}",da=ER+Y_,h_=Hp+da,d_=":{ss}",Ft=null;function Z_(n){let e=n*1e3,t=e*60,i=t*60,r=i*24,s=r*30,o=r*365,l=(n==1?Yl(10,0,3,Bh).filter(W_):Yl(10,-3,0,Bh)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,r,r*2,r*3,r*4,r*5,r*6,r*7,r*8,r*9,r*10,r*15,s,s*2,s*3,s*4,s*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,X_,Ft,Ft,Ft,Ft,Ft,Ft,1],[r*28,"{MMM}",u_,Ft,Ft,Ft,Ft,Ft,1],[r,$_,u_,Ft,Ft,Ft,Ft,Ft,1],[i,"{h}"+Y_,Ph,Ft,ql,Ft,Ft,Ft,1],[t,da,Ph,Ft,ql,Ft,Ft,Ft,1],[e,d_,Ph+" "+da,Ft,ql+" "+da,Ft,h_,Ft,1],[n,d_+".{fff}",Ph+" "+da,Ft,ql+" "+da,Ft,h_,Ft,1]];function u(h){return(d,f,m,b,g,p)=>{let _=[],T=g>=o,w=g>=s&&g<o,C=h(m),E=Gt(C*n,3),x=vp(C.getFullYear(),T?0:C.getMonth(),w||T?1:C.getDate()),M=Gt(x*n,3);if(w||T){let O=w?g/s:0,N=T?g/o:0,I=E==M?E:Gt(vp(x.getFullYear()+N,x.getMonth()+O,1)*n,3),U=new Date(Cn(I/n)),H=U.getFullYear(),L=U.getMonth();for(let V=0;I<=b;V++){let W=vp(H+N*V,L+O*V,1),z=W-h(Gt(W*n,3));I=Gt((+W+z)*n,3),I<=b&&_.push(I)}}else{let O=g>=r?r:g,N=Si(m)-Si(E),I=M+N+Oh(E-M,O);_.push(I);let U=h(I),H=U.getHours()+U.getMinutes()/t+U.getSeconds()/i,L=g/i,V=d.axes[f]._space,W=p/V;for(;I=Gt(I+g,n==1?0:3),!(I>b);)if(L>1){let z=Si(Gt(H+L,6))%24,J=h(I).getHours()-z;J>1&&(J=-1),I-=J*i,H=(H+L)%24;let ee=_[_.length-1];Gt((I-ee)/g,3)*W>=.7&&_.push(I)}else _.push(I)}return _}}return[l,c,u]}var[CR,RR,PR]=Z_(1),[IR,LR,FR]=Z_(.001);Yl(2,-53,53,[1]);function f_(n,e){return n.map(t=>t.map((i,r)=>r==0||r==8||i==null?i:e(r==1||t[8]==0?i:t[1]+i)))}function p_(n,e){return(t,i,r,s,o)=>{let a=e.find(m=>o>=m[0])||e[e.length-1],l,c,u,h,d,f;return i.map(m=>{let b=n(m),g=b.getFullYear(),p=b.getMonth(),_=b.getDate(),T=b.getHours(),w=b.getMinutes(),C=b.getSeconds(),E=g!=l&&a[2]||p!=c&&a[3]||_!=u&&a[4]||T!=h&&a[5]||w!=d&&a[6]||C!=f&&a[7]||a[1];return l=g,c=p,u=_,h=T,d=w,f=C,E(b)})}}function NR(n,e){let t=Vp(e);return(i,r,s,o,a)=>r.map(l=>t(n(l)))}function vp(n,e,t){return new Date(n,e,t)}function m_(n,e){return e(n)}var BR="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function g_(n,e){return(t,i,r,s)=>s==null?Bp:e(n(i))}function DR(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function UR(n,e){return n.series[e].fill(n,e)}var OR={show:!0,live:!0,isolate:!1,mount:iR,markers:{show:!0,width:2,stroke:DR,fill:UR,dash:"solid"},idx:null,idxs:null,values:[]};function kR(n,e){let t=n.cursor.points,i=Ni(),r=t.size(n,e);Kt(i,Gl,r),Kt(i,Wl,r);let s=r/-2;Kt(i,"marginLeft",s),Kt(i,"marginTop",s);let o=t.width(n,e,r);return o&&Kt(i,"borderWidth",o),i}function zR(n,e){let t=n.series[e].points;return t._fill||t._stroke}function VR(n,e){let t=n.series[e].points;return t._stroke||t._fill}function HR(n,e){return n.series[e].points.size}var wp=[0,0];function GR(n,e,t){return wp[0]=e,wp[1]=t,wp}function Ih(n,e,t,i=!0){return r=>{r.button==0&&(!i||r.target==e)&&t(r)}}function Sp(n,e,t,i=!0){return r=>{(!i||r.target==e)&&t(r)}}var WR={show:!0,x:!0,y:!0,lock:!1,move:GR,points:{one:!1,show:kR,size:HR,width:0,stroke:VR,fill:zR},bind:{mousedown:Ih,mouseup:Ih,click:Ih,dblclick:Ih,mousemove:Sp,mouseleave:Sp,mouseenter:Sp},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,r)=>i-r,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},K_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Gp=Sn({},K_,{filter:D_}),J_=Sn({},Gp,{size:10}),j_=Sn({},K_,{show:!1}),Wp='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Q_="bold "+Wp,eb=1.5,x_={show:!0,scale:"x",stroke:Np,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Q_,side:2,grid:Gp,ticks:J_,border:j_,font:Wp,lineGap:eb,rotate:0},qR="Value",XR="Time",y_={show:!0,scale:"x",auto:!1,sorted:1,min:Ht,max:-Ht,idxs:[]};function $R(n,e,t,i,r){return e.map(s=>s==null?"":kp(s))}function YR(n,e,t,i,r,s,o){let a=[],l=Es.get(r)||0;t=o?t:Gt(Oh(t,r),l);for(let c=t;c<=i;c=Gt(c+r,l))a.push(Object.is(c,-0)?0:c);return a}function Rp(n,e,t,i,r,s,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Kr:F_,u=Si(c(t));r=pa(l,u),l==10&&(r=eo[Ji(r,eo)]);let h=t,d=r*l;l==10&&(d=eo[Ji(d,eo)]);do a.push(h),h=h+r,l==10&&!Es.has(h)&&(h=Gt(h,Es.get(r))),h>=d&&(r=h,d=r*l,l==10&&(d=eo[Ji(d,eo)]));while(h<=i);return a}function ZR(n,e,t,i,r,s,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Rp(n,e,ri(l,t),i,r):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Rp(n,e,ri(l,-i),-t,r):[l]).reverse().map(d=>-d).concat(u,c)}var tb=/./,KR=/[12357]/,JR=/[125]/,__=/1/,Pp=(n,e,t,i)=>n.map((r,s)=>e==4&&r==0||s%i==0&&t.test(r.toExponential()[r<0?1:0])?r:null);function jR(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=n.scales[o],l=n.valToPos,c=s._space,u=l(10,o),h=l(9,o)-u>=c?tb:l(7,o)-u>=c?KR:l(5,o)-u>=c?JR:__;if(h==__){let d=Rn(l(1,o)-u);if(d<c)return Pp(e.slice().reverse(),a.distr,h,Bi(c/d)).reverse()}return Pp(e,a.distr,h,1)}function QR(n,e,t,i,r){let s=n.axes[t],o=s.scale,a=s._space,l=n.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Pp(e.slice().reverse(),3,tb,Bi(a/c)).reverse():e}function e2(n,e,t,i){return i==null?Bp:e==null?"":kp(e)}var b_={show:!0,scale:"y",stroke:Np,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Q_,side:3,grid:Gp,ticks:J_,border:j_,font:Wp,lineGap:eb,rotate:0};function t2(n,e){let t=3+(n||1)*2;return Gt(t*e,3)}function n2(n,e){let{scale:t,idxs:i}=n.series[0],r=n._data[0],s=n.valToPos(r[i[0]],t,!0),o=n.valToPos(r[i[1]],t,!0),a=Rn(o-s),l=n.series[e],c=a/(l.points.space*It);return i[1]-i[0]<=c}var v_={scale:null,auto:!0,sorted:0,min:Ht,max:-Ht},nb=(n,e,t,i,r)=>r,w_={show:!0,auto:!0,sorted:0,gaps:nb,alpha:1,facets:[Sn({},v_,{scale:"x"}),Sn({},v_,{scale:"y"})]},S_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:nb,alpha:1,points:{show:n2,filter:null},values:null,min:Ht,max:-Ht,idxs:[],path:null,clip:null};function i2(n,e,t,i,r){return t/10}var ib={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},r2=Sn({},ib,{time:!1,ori:1}),A_={};function rb(n,e){let t=A_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(r=>r!=i)},pub(i,r,s,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=r&&t.plots[u].pub(i,r,s,o,a,l,c)}},n!=null&&(A_[n]=t)),t}var xa=1,Ip=2;function ro(n,e,t){let i=n.mode,r=n.series[e],s=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=s[0],c=i==2?s[1]:s[e],u=i==2?o[r.facets[0].scale]:o[n.series[0].scale],h=i==2?o[r.facets[1].scale]:o[r.scale],d=a.left,f=a.top,m=a.width,b=a.height,g=n.valToPosH,p=n.valToPosV;return u.ori==0?t(r,l,c,u,h,g,p,d,f,m,b,Vh,_a,Gh,ob,lb):t(r,l,c,u,h,p,g,f,d,b,m,Hh,ba,$p,ab,cb)}function qp(n,e){let t=0,i=0,r=Rt(n.bands,zp);for(let s=0;s<r.length;s++){let o=r[s];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function s2(n,e,t,i,r){let s=n.mode,o=n.series[e],a=s==2?o.facets[1].scale:o.scale,l=n.scales[a];return r==-1?l.min:r==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Jr(n,e,t,i,r,s){return ro(n,e,(o,a,l,c,u,h,d,f,m,b,g)=>{let p=o.pxRound,_=c.dir*(c.ori==0?1:-1),T=c.ori==0?_a:ba,w,C;_==1?(w=t,C=i):(w=i,C=t);let E=p(h(a[w],c,b,f)),x=p(d(l[w],u,g,m)),M=p(h(a[C],c,b,f)),O=p(d(s==1?u.max:u.min,u,g,m)),N=new Path2D(r);return T(N,M,O),T(N,E,O),T(N,E,x),N})}function zh(n,e,t,i,r,s){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Gh:$p,l=t;for(let h=0;h<n.length;h++){let d=n[h];if(d[1]>d[0]){let f=d[0]-l;f>0&&a(o,l,i,f,i+s),l=d[1]}}let c=t+r-l,u=10;c>0&&a(o,l,i-u/2,c,i+s+u)}return o}function o2(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Xp(n,e,t,i,r,s,o){let a=[],l=n.length;for(let c=r==1?t:i;c>=t&&c<=i;c+=r)if(e[c]===null){let h=c,d=c;if(r==1)for(;++c<=i&&e[c]===null;)d=c;else for(;--c>=t&&e[c]===null;)d=c;let f=s(n[h]),m=d==h?f:s(n[d]),b=h-r;f=o<=0&&b>=0&&b<l?s(n[b]):f;let p=d+r;m=o>=0&&p>=0&&p<l?s(n[p]):m,m>=f&&a.push([f,m])}return a}function M_(n){return n==0?B_:n==1?Cn:e=>Qs(e,n)}function sb(n){let e=n==0?Vh:Hh,t=n==0?(r,s,o,a,l,c)=>{r.arcTo(s,o,a,l,c)}:(r,s,o,a,l,c)=>{r.arcTo(o,s,l,a,c)},i=n==0?(r,s,o,a,l)=>{r.rect(s,o,a,l)}:(r,s,o,a,l)=>{r.rect(o,s,l,a)};return(r,s,o,a,l,c=0,u=0)=>{c==0&&u==0?i(r,s,o,a,l):(c=ji(c,a/2,l/2),u=ji(u,a/2,l/2),e(r,s+c,o),t(r,s+a,o,s+a,o+l,c),t(r,s+a,o+l,s,o+l,u),t(r,s,o+l,s,o,u),t(r,s,o,s+a,o,c),r.closePath())}}var Vh=(n,e,t)=>{n.moveTo(e,t)},Hh=(n,e,t)=>{n.moveTo(t,e)},_a=(n,e,t)=>{n.lineTo(e,t)},ba=(n,e,t)=>{n.lineTo(t,e)},Gh=sb(0),$p=sb(1),ob=(n,e,t,i,r,s)=>{n.arc(e,t,i,r,s)},ab=(n,e,t,i,r,s)=>{n.arc(t,e,i,r,s)},lb=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(e,t,i,r,s,o)},cb=(n,e,t,i,r,s,o)=>{n.bezierCurveTo(t,e,r,i,o,s)};function ub(n){return(e,t,i,r,s)=>ro(e,t,(o,a,l,c,u,h,d,f,m,b,g)=>{let{pxRound:p,points:_}=o,T,w;c.ori==0?(T=Vh,w=ob):(T=Hh,w=ab);let C=Gt(_.width*It,3),E=(_.size-_.width)/2*It,x=Gt(E*2,3),M=new Path2D,O=new Path2D,{left:N,top:I,width:U,height:H}=e.bbox;Gh(O,N-x,I-x,U+x*2,H+x*2);let L=V=>{if(l[V]!=null){let W=p(h(a[V],c,b,f)),z=p(d(l[V],u,g,m));T(M,W+E,z),w(M,W,z,E,0,Lh*2)}};if(s)s.forEach(L);else for(let V=i;V<=r;V++)L(V);return{stroke:C>0?M:null,fill:M,clip:O,flags:xa|Ip}})}function hb(n){return(e,t,i,r,s,o)=>{i!=r&&(s!=i&&o!=i&&n(e,t,i),s!=r&&o!=r&&n(e,t,r),n(e,t,o))}}var a2=hb(_a),l2=hb(ba);function db(n){let e=Rt(n?.alignGaps,0);return(t,i,r,s)=>ro(t,i,(o,a,l,c,u,h,d,f,m,b,g)=>{[r,s]=Dh(l,r,s);let p=o.pxRound,_=H=>p(h(H,c,b,f)),T=H=>p(d(H,u,g,m)),w,C;c.ori==0?(w=_a,C=a2):(w=ba,C=l2);let E=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},M=x.stroke,O=!1;if(s-r>=b*4){let H=he=>t.posToVal(he,c.key,!0),L=null,V=null,W,z,ae,X=_(a[E==1?r:s]),J=_(a[r]),ee=_(a[s]),ue=H(E==1?J+1:ee-1);for(let he=E==1?r:s;he>=r&&he<=s;he+=E){let Q=a[he],be=(E==1?Q<ue:Q>ue)?X:_(Q),Pe=l[he];be==X?Pe!=null?(z=Pe,L==null?(w(M,be,T(z)),W=L=V=z):z<L?L=z:z>V&&(V=z)):Pe===null&&(O=!0):(L!=null&&C(M,X,T(L),T(V),T(W),T(z)),Pe!=null?(z=Pe,w(M,be,T(z)),L=V=W=z):(L=V=null,Pe===null&&(O=!0)),X=be,ue=H(X+E))}L!=null&&L!=V&&ae!=X&&C(M,X,T(L),T(V),T(W),T(z))}else for(let H=E==1?r:s;H>=r&&H<=s;H+=E){let L=l[H];L===null?O=!0:L!=null&&w(M,_(a[H]),T(L))}let[I,U]=qp(t,i);if(o.fill!=null||I!=0){let H=x.fill=new Path2D(M),L=o.fillTo(t,i,o.min,o.max,I),V=T(L),W=_(a[r]),z=_(a[s]);E==-1&&([z,W]=[W,z]),w(H,z,V),w(H,W,V)}if(!o.spanGaps){let H=[];O&&H.push(...Xp(a,l,r,s,E,_,e)),x.gaps=H=o.gaps(t,i,r,s,H),x.clip=zh(H,c.ori,f,m,b,g)}return U!=0&&(x.band=U==2?[Jr(t,i,r,s,M,-1),Jr(t,i,r,s,M,1)]:Jr(t,i,r,s,M,U)),x})}function c2(n){let e=Rt(n.align,1),t=Rt(n.ascDesc,!1),i=Rt(n.alignGaps,0),r=Rt(n.extend,!1);return(s,o,a,l)=>ro(s,o,(c,u,h,d,f,m,b,g,p,_,T)=>{[a,l]=Dh(h,a,l);let w=c.pxRound,{left:C,width:E}=s.bbox,x=J=>w(m(J,d,_,g)),M=J=>w(b(J,f,T,p)),O=d.ori==0?_a:ba,N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:xa},I=N.stroke,U=d.dir*(d.ori==0?1:-1),H=M(h[U==1?a:l]),L=x(u[U==1?a:l]),V=L,W=L;r&&e==-1&&(W=C,O(I,W,H)),O(I,L,H);for(let J=U==1?a:l;J>=a&&J<=l;J+=U){let ee=h[J];if(ee==null)continue;let ue=x(u[J]),he=M(ee);e==1?O(I,ue,H):O(I,V,he),O(I,ue,he),H=he,V=ue}let z=V;r&&e==1&&(z=C+E,O(I,z,H));let[ae,X]=qp(s,o);if(c.fill!=null||ae!=0){let J=N.fill=new Path2D(I),ee=c.fillTo(s,o,c.min,c.max,ae),ue=M(ee);O(J,z,ue),O(J,W,ue)}if(!c.spanGaps){let J=[];J.push(...Xp(u,h,a,l,U,x,i));let ee=c.width*It/2,ue=t||e==1?ee:-ee,he=t||e==-1?-ee:ee;J.forEach(Q=>{Q[0]+=ue,Q[1]+=he}),N.gaps=J=c.gaps(s,o,a,l,J),N.clip=zh(J,d.ori,g,p,_,T)}return X!=0&&(N.band=X==2?[Jr(s,o,a,l,I,-1),Jr(s,o,a,l,I,1)]:Jr(s,o,a,l,I,X)),N})}function T_(n,e,t,i,r,s,o=Ht){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Rn(n[l]-n[a]);u<c&&(c=u,o=Rn(t(n[l],i,r,s)-t(n[a],i,r,s)))}a=l}}return o}function u2(n){n=n||$l;let e=Rt(n.size,[.6,Ht,1]),t=n.align||0,i=n.gap||0,r=n.radius;r=r==null?[0,0]:typeof r=="number"?[r,0]:r;let s=wt(r),o=1-e[0],a=Rt(e[1],Ht),l=Rt(e[2],1),c=Rt(n.disp,$l),u=Rt(n.each,f=>{}),{fill:h,stroke:d}=c;return(f,m,b,g)=>ro(f,m,(p,_,T,w,C,E,x,M,O,N,I)=>{let U=p.pxRound,H=t,L=i*It,V=a*It,W=l*It,z,ae;w.ori==0?[z,ae]=s(f,m):[ae,z]=s(f,m);let X=w.dir*(w.ori==0?1:-1),J=w.ori==0?Gh:$p,ee=w.ori==0?u:(Le,Je,ct,Me,Vt,Ge,Ke)=>{u(Le,Je,ct,Vt,Me,Ke,Ge)},ue=Rt(f.bands,zp).find(Le=>Le.series[0]==m),he=ue!=null?ue.dir:0,Q=p.fillTo(f,m,p.min,p.max,he),ge=U(x(Q,C,I,O)),be,Pe,Ae,$e=N,lt=U(p.width*It),qe=!1,gt=null,ft=null,ot=null,Jt=null;h!=null&&(lt==0||d!=null)&&(qe=!0,gt=h.values(f,m,b,g),ft=new Map,new Set(gt).forEach(Le=>{Le!=null&&ft.set(Le,new Path2D)}),lt>0&&(ot=d.values(f,m,b,g),Jt=new Map,new Set(ot).forEach(Le=>{Le!=null&&Jt.set(Le,new Path2D)})));let{x0:Wt,size:pn}=c;if(Wt!=null&&pn!=null){H=1,_=Wt.values(f,m,b,g),Wt.unit==2&&(_=_.map(ct=>f.posToVal(M+ct*N,w.key,!0)));let Le=pn.values(f,m,b,g);pn.unit==2?Pe=Le[0]*N:Pe=E(Le[0],w,N,M)-E(0,w,N,M),$e=T_(_,T,E,w,N,M,$e),Ae=$e-Pe+L}else $e=T_(_,T,E,w,N,M,$e),Ae=$e*o+L,Pe=$e-Ae;Ae<1&&(Ae=0),lt>=Pe/2&&(lt=0),Ae<5&&(U=B_);let Ot=Ae>0,Pn=$e-Ae-(Ot?lt:0);Pe=U(Cp(Pn,W,V)),be=(H==0?Pe/2:H==X?0:Pe)-H*X*((H==0?L/2:0)+(Ot?lt/2:0));let Tt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},An=qe?null:new Path2D,sn=null;if(ue!=null)sn=f.data[ue.series[1]];else{let{y0:Le,y1:Je}=c;Le!=null&&Je!=null&&(T=Je.values(f,m,b,g),sn=Le.values(f,m,b,g))}let mn=z*Pe,D=ae*Pe;for(let Le=X==1?b:g;Le>=b&&Le<=g;Le+=X){let Je=T[Le];if(Je==null)continue;if(sn!=null){let q=sn[Le]??0;if(Je-q==0)continue;ge=x(q,C,I,O)}let ct=w.distr!=2||c!=null?_[Le]:Le,Me=E(ct,w,N,M),Vt=x(Rt(Je,Q),C,I,O),Ge=U(Me-be),Ke=U(ri(Vt,ge)),R=U(ji(Vt,ge)),v=Ke-R;if(Je!=null){let q=Je<0?D:mn,de=Je<0?mn:D;qe?(lt>0&&ot[Le]!=null&&J(Jt.get(ot[Le]),Ge,R+Si(lt/2),Pe,ri(0,v-lt),q,de),gt[Le]!=null&&J(ft.get(gt[Le]),Ge,R+Si(lt/2),Pe,ri(0,v-lt),q,de)):J(An,Ge,R+Si(lt/2),Pe,ri(0,v-lt),q,de),ee(f,m,Le,Ge-lt/2,R,Pe+lt,v)}}return lt>0?Tt.stroke=qe?Jt:An:qe||(Tt._fill=p.width==0?p._fill:p._stroke??p._fill,Tt.width=0),Tt.fill=qe?ft:An,Tt})}function h2(n,e){let t=Rt(e?.alignGaps,0);return(i,r,s,o)=>ro(i,r,(a,l,c,u,h,d,f,m,b,g,p)=>{[s,o]=Dh(c,s,o);let _=a.pxRound,T=z=>_(d(z,u,g,m)),w=z=>_(f(z,h,p,b)),C,E,x;u.ori==0?(C=Vh,x=_a,E=lb):(C=Hh,x=ba,E=cb);let M=u.dir*(u.ori==0?1:-1),O=T(l[M==1?s:o]),N=O,I=[],U=[];for(let z=M==1?s:o;z>=s&&z<=o;z+=M)if(c[z]!=null){let X=l[z],J=T(X);I.push(N=J),U.push(w(c[z]))}let H={stroke:n(I,U,C,x,E,_),fill:null,clip:null,band:null,gaps:null,flags:xa},L=H.stroke,[V,W]=qp(i,r);if(a.fill!=null||V!=0){let z=H.fill=new Path2D(L),ae=a.fillTo(i,r,a.min,a.max,V),X=w(ae);x(z,N,X),x(z,O,X)}if(!a.spanGaps){let z=[];z.push(...Xp(l,c,s,o,M,T,t)),H.gaps=z=a.gaps(i,r,s,o,z),H.clip=zh(z,u.ori,m,b,g,p)}return W!=0&&(H.band=W==2?[Jr(i,r,s,o,L,-1),Jr(i,r,s,o,L,1)]:Jr(i,r,s,o,L,W)),H})}function d2(n){return h2(f2,n)}function f2(n,e,t,i,r,s){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let d=0;d<o-1;d++)u[d]=e[d+1]-e[d],h[d]=n[d+1]-n[d],c[d]=u[d]/h[d];l[0]=c[0];for(let d=1;d<o-1;d++)c[d]===0||c[d-1]===0||c[d-1]>0!=c[d]>0?l[d]=0:(l[d]=3*(h[d-1]+h[d])/((2*h[d]+h[d-1])/c[d-1]+(h[d]+2*h[d-1])/c[d]),isFinite(l[d])||(l[d]=0));l[o-1]=c[o-2];for(let d=0;d<o-1;d++)r(a,n[d]+h[d]/3,e[d]+l[d]*h[d]/3,n[d+1]-h[d]/3,e[d+1]-l[d+1]*h[d]/3,n[d+1],e[d+1])}return a}var Lp=new Set;function E_(){for(let n of Lp)n.syncRect(!0)}ya&&(no($C,fa,E_),no(YC,fa,E_,!0),no(Fh,fa,()=>{Hn.pxRatio=It}));var p2=db(),m2=ub();function C_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((s,o)=>Fp(s,o,e,t))}function g2(n,e){return n.map((t,i)=>i==0?{}:Sn({},e,t))}function Fp(n,e,t,i){return Sn({},e==0?t:i,n)}function fb(n,e,t){return e==null?ma:[e,t]}var x2=fb;function y2(n,e,t){return e==null?ma:Nh(e,t,Op,!0)}function pb(n,e,t,i){return e==null?ma:Uh(e,t,n.scales[i].log,!1)}var _2=pb;function mb(n,e,t,i){return e==null?ma:Up(e,t,n.scales[i].log,!1)}var b2=mb;function v2(n,e,t,i,r){let s=ri(o_(n),o_(e)),o=e-n,a=Ji(r/i*o,t);do{let l=t[a],c=i*l/o;if(c>=r&&s+(l<5?Es.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function R_(n){let e,t;return n=n.replace(/(\d+)px/,(i,r)=>(e=Cn((t=+r)*It))+"px"),[n,e,t]}function w2(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Gt(e[2]*It,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Hn(n,e,t){let i={mode:Rt(n.mode,1)},r=i.mode;function s(y,S,P,F){let G=S.valToPct(y);return F+P*(S.dir==-1?1-G:G)}function o(y,S,P,F){let G=S.valToPct(y);return F+P*(S.dir==-1?G:1-G)}function a(y,S,P,F){return S.ori==0?s(y,S,P,F):o(y,S,P,F)}i.valToPosH=s,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ni(RC);if(n.id!=null&&(c.id=n.id),wi(c,n.class),n.title){let y=Ni(LC,c);y.textContent=n.title}let u=Ki("canvas"),h=i.ctx=u.getContext("2d"),d=Ni(FC,c);no("click",d,y=>{y.target===m&&(Xt!=ho||jt!=fo)&&kn.click(i,y)},!0);let f=i.under=Ni(NC,d);d.appendChild(u);let m=i.over=Ni(BC,d);n=ga(n);let b=+Rt(n.pxAlign,1),g=M_(b);(n.plugins||[]).forEach(y=>{y.opts&&(n=y.opts(i,n)||n)});let p=n.ms||.001,_=i.series=r==1?C_(n.series||[],y_,S_,!1):g2(n.series||[null],w_),T=i.axes=C_(n.axes||[],x_,b_,!0),w=i.scales={},C=i.bands=n.bands||[];C.forEach(y=>{y.fill=wt(y.fill||null),y.dir=Rt(y.dir,-1)});let E=r==2?_[1].facets[0].scale:_[0].scale,x={axes:Pr,series:yt},M=(n.drawOrder||["axes","series"]).map(y=>x[y]);function O(y){let S=y.distr==3?P=>Kr(P>0?P:y.clamp(i,P,y.min,y.max,y.key)):y.distr==4?P=>bp(P,y.asinh):y.distr==100?P=>y.fwd(P):P=>P;return P=>{let F=S(P),{_min:G,_max:K}=y,le=K-G;return(F-G)/le}}function N(y){let S=w[y];if(S==null){let P=(n.scales||$l)[y]||$l;if(P.from!=null){N(P.from);let F=Sn({},w[P.from],P,{key:y});F.valToPct=O(F),w[y]=F}else{S=w[y]=Sn({},y==E?ib:r2,P),S.key=y;let F=S.time,G=S.range,K=Ts(G);if((y!=E||r==2&&!F)&&(K&&(G[0]==null||G[1]==null)&&(G={min:G[0]==null?i_:{mode:1,hard:G[0],soft:G[0]},max:G[1]==null?i_:{mode:1,hard:G[1],soft:G[1]}},K=!1),!K&&kh(G))){let le=G;G=(pe,we,De)=>we==null?ma:Nh(we,De,le)}S.range=wt(G||(F?x2:y==E?S.distr==3?_2:S.distr==4?b2:fb:S.distr==3?pb:S.distr==4?mb:y2)),S.auto=wt(K?!1:S.auto),S.clamp=wt(S.clamp||i2),S._min=S._max=null,S.valToPct=O(S)}}}N("x"),N("y"),r==1&&_.forEach(y=>{N(y.scale)}),T.forEach(y=>{N(y.scale)});for(let y in n.scales)N(y);let I=w[E],U=I.distr,H,L;I.ori==0?(wi(c,PC),H=s,L=o):(wi(c,IC),H=o,L=s);let V={};for(let y in w){let S=w[y];(S.min!=null||S.max!=null)&&(V[y]={min:S.min,max:S.max},S.min=S.max=null)}let W=n.tzDate||(y=>new Date(Cn(y/p))),z=n.fmtDate||Vp,ae=p==1?PR(W):FR(W),X=p_(W,f_(p==1?RR:LR,z)),J=g_(W,m_(BR,z)),ee=[],ue=i.legend=Sn({},OR,n.legend),he=i.cursor=Sn({},WR,{drag:{y:r==2}},n.cursor),Q=ue.show,ge=he.show,be=ue.markers;ue.idxs=ee,be.width=wt(be.width),be.dash=wt(be.dash),be.stroke=wt(be.stroke),be.fill=wt(be.fill);let Pe,Ae,$e,lt=[],qe=[],gt,ft=!1,ot={};if(ue.live){let y=_[1]?_[1].values:null;ft=y!=null,gt=ft?y(i,1,0):{_:0};for(let S in gt)ot[S]=Bp}if(Q)if(Pe=Ki("table",VC,c),$e=Ki("tbody",null,Pe),ue.mount(i,Pe),ft){Ae=Ki("thead",null,Pe,$e);let y=Ki("tr",null,Ae);Ki("th",null,y);for(var Jt in gt)Ki("th",Wy,y).textContent=Jt}else wi(Pe,GC),ue.live&&wi(Pe,HC);let Wt={show:!0},pn={show:!1};function Ot(y,S){if(S==0&&(ft||!ue.live||r==2))return ma;let P=[],F=Ki("tr",WC,$e,$e.childNodes[S]);wi(F,y.class),y.show||wi(F,to);let G=Ki("th",null,F);if(be.show){let pe=Ni(qC,G);if(S>0){let we=be.width(i,S);we&&(pe.style.border=we+"px "+be.dash(i,S)+" "+be.stroke(i,S)),pe.style.background=be.fill(i,S)}}let K=Ni(Wy,G);y.label instanceof HTMLElement?K.appendChild(y.label):K.textContent=y.label,S>0&&(be.show||(K.style.color=y.width>0?be.stroke(i,S):be.fill(i,S)),Tt("click",G,pe=>{if(he._lock)return;tt(pe);let we=_.indexOf(y);if((pe.ctrlKey||pe.metaKey)!=ue.isolate){let De=_.some((Ue,ke)=>ke>0&&ke!=we&&Ue.show);_.forEach((Ue,ke)=>{ke>0&&nr(ke,De?ke==we?Wt:pn:Wt,!0,_n.setSeries)})}else nr(we,{show:!y.show},!0,_n.setSeries)},!1),nt&&Tt(Yy,G,pe=>{he._lock||(tt(pe),nr(_.indexOf(y),mo,!0,_n.setSeries))},!1));for(var le in gt){let pe=Ki("td",XC,F);pe.textContent="--",P.push(pe)}return[F,P]}let Pn=new Map;function Tt(y,S,P,F=!0){let G=Pn.get(S)||{},K=he.bind[y](i,S,P,F);K&&(no(y,S,G[y]=K),Pn.set(S,G))}function An(y,S,P){let F=Pn.get(S)||{};for(let G in F)(y==null||G==y)&&(Ep(G,S,F[G]),delete F[G]);y==null&&Pn.delete(S)}let sn=0,mn=0,D=0,Le=0,Je=0,ct=0,Me=Je,Vt=ct,Ge=D,Ke=Le,R=0,v=0,q=0,de=0;i.bbox={};let oe=!1,ye=!1,ve=!1,te=!1,ie=!1,me=!1;function B(y,S,P){(P||y!=i.width||S!=i.height)&&re(y,S),pt(!1),ve=!0,ye=!0,Gn()}function re(y,S){i.width=sn=D=y,i.height=mn=Le=S,Je=ct=0,Se(),Xe();let P=i.bbox;R=P.left=Qs(Je*It,.5),v=P.top=Qs(ct*It,.5),q=P.width=Qs(D*It,.5),de=P.height=Qs(Le*It,.5)}let ne=3;function Te(){let y=!1,S=0;for(;!y;){S++;let P=lo(S),F=tr(S);y=S==ne||P&&F,y||(re(i.width,i.height),ye=!0)}}function xe({width:y,height:S}){B(y,S)}i.setSize=xe;function Se(){let y=!1,S=!1,P=!1,F=!1;T.forEach((G,K)=>{if(G.show&&G._show){let{side:le,_size:pe}=G,we=le%2,De=G.label!=null?G.labelSize:0,Ue=pe+De;Ue>0&&(we?(D-=Ue,le==3?(Je+=Ue,F=!0):P=!0):(Le-=Ue,le==0?(ct+=Ue,y=!0):S=!0))}}),Qi[0]=y,Qi[1]=P,Qi[2]=S,Qi[3]=F,D-=Di[1]+Di[3],Je+=Di[3],Le-=Di[2]+Di[0],ct+=Di[0]}function Xe(){let y=Je+D,S=ct+Le,P=Je,F=ct;function G(K,le){switch(K){case 1:return y+=le,y-le;case 2:return S+=le,S-le;case 3:return P-=le,P+le;case 0:return F-=le,F+le}}T.forEach((K,le)=>{if(K.show&&K._show){let pe=K.side;K._pos=G(pe,K._size),K.label!=null&&(K._lpos=G(pe,K.labelSize))}})}if(he.dataIdx==null){let y=he.hover,S=y.skip=new Set(y.skip??[]);S.add(void 0);let P=y.prox=wt(y.prox),F=y.bias??=0;he.dataIdx=(G,K,le,pe)=>{if(K==0)return le;let we=le,De=P(G,K,le,pe)??Ht,Ue=De>=0&&De<Ht,ke=I.ori==0?D:Le,at=he.left,Pt=e[0],Ct=e[K];if(S.has(Ct[le])){we=null;let _t=null,Qe=null,Ye;if(F==0||F==-1)for(Ye=le;_t==null&&Ye-- >0;)S.has(Ct[Ye])||(_t=Ye);if(F==0||F==1)for(Ye=le;Qe==null&&Ye++<Ct.length;)S.has(Ct[Ye])||(Qe=Ye);if(_t!=null||Qe!=null)if(Ue){let Yt=_t==null?-1/0:H(Pt[_t],I,ke,0),ln=Qe==null?1/0:H(Pt[Qe],I,ke,0),Nn=at-Yt,kt=ln-at;Nn<=kt?Nn<=De&&(we=_t):kt<=De&&(we=Qe)}else we=Qe==null?_t:_t==null?Qe:le-_t<=Qe-le?_t:Qe}else Ue&&Rn(at-H(Pt[le],I,ke,0))>De&&(we=null);return we}}let tt=y=>{he.event=y};he.idxs=ee,he._lock=!1;let ce=he.points;ce.show=wt(ce.show),ce.size=wt(ce.size),ce.stroke=wt(ce.stroke),ce.width=wt(ce.width),ce.fill=wt(ce.fill);let ze=i.focus=Sn({},n.focus||{alpha:.3},he.focus),nt=ze.prox>=0,Ie=nt&&ce.one,ut=[],qt=[],Zn=[];function wa(y,S){let P=ce.show(i,S);if(P instanceof HTMLElement)return wi(P,zC),wi(P,y.class),Tr(P,-10,-10,D,Le),m.insertBefore(P,ut[S]),P}function so(y,S){if(r==1||S>0){let P=r==1&&w[y.scale].time,F=y.value;y.value=P?c_(F)?g_(W,m_(F,z)):F||J:F||e2,y.label=y.label||(P?XR:qR)}if(Ie||S>0){y.width=y.width==null?1:y.width,y.paths=y.paths||p2||rR,y.fillTo=wt(y.fillTo||s2),y.pxAlign=+Rt(y.pxAlign,b),y.pxRound=M_(y.pxAlign),y.stroke=wt(y.stroke||null),y.fill=wt(y.fill||null),y._stroke=y._fill=y._paths=y._focus=null;let P=t2(ri(1,y.width),1),F=y.points=Sn({},{size:P,width:ri(1,P*.2),stroke:y.stroke,space:P*2,paths:m2,_stroke:null,_fill:null},y.points);F.show=wt(F.show),F.filter=wt(F.filter),F.fill=wt(F.fill),F.stroke=wt(F.stroke),F.paths=wt(F.paths),F.pxAlign=y.pxAlign}if(Q){let P=Ot(y,S);lt.splice(S,0,P[0]),qe.splice(S,0,P[1]),ue.values.push(null)}if(ge){ee.splice(S,0,null);let P=null;Ie?S==0&&(P=wa(y,S)):S>0&&(P=wa(y,S)),ut.splice(S,0,P),qt.splice(S,0,0),Zn.splice(S,0,0)}Fn("addSeries",S)}function qh(y,S){S=S??_.length,y=r==1?Fp(y,S,y_,S_):Fp(y,S,{},w_),_.splice(S,0,y),so(_[S],S)}i.addSeries=qh;function Zl(y){if(_.splice(y,1),Q){ue.values.splice(y,1),qe.splice(y,1);let S=lt.splice(y,1)[0];An(null,S.firstChild),S.remove()}ge&&(ee.splice(y,1),ut.splice(y,1)[0].remove(),qt.splice(y,1),Zn.splice(y,1)),Fn("delSeries",y)}i.delSeries=Zl;let Qi=[!1,!1,!1,!1];function Er(y,S){if(y._show=y.show,y.show){let P=y.side%2,F=w[y.scale];F==null&&(y.scale=P?_[1].scale:E,F=w[y.scale]);let G=F.time;y.size=wt(y.size),y.space=wt(y.space),y.rotate=wt(y.rotate),Ts(y.incrs)&&y.incrs.forEach(le=>{!Es.has(le)&&Es.set(le,O_(le))}),y.incrs=wt(y.incrs||(F.distr==2?TR:G?p==1?CR:IR:eo)),y.splits=wt(y.splits||(G&&F.distr==1?ae:F.distr==3?Rp:F.distr==4?ZR:YR)),y.stroke=wt(y.stroke),y.grid.stroke=wt(y.grid.stroke),y.ticks.stroke=wt(y.ticks.stroke),y.border.stroke=wt(y.border.stroke);let K=y.values;y.values=Ts(K)&&!Ts(K[0])?wt(K):G?Ts(K)?p_(W,f_(K,z)):c_(K)?NR(W,K):K||X:K||$R,y.filter=wt(y.filter||(F.distr>=3&&F.log==10?jR:F.distr==3&&F.log==2?QR:D_)),y.font=R_(y.font),y.labelFont=R_(y.labelFont),y._size=y.size(i,null,S,0),y._space=y._rotate=y._incrs=y._found=y._splits=y._values=null,y._size>0&&(Qi[S]=!0,y._el=Ni(DC,d))}}function Cr(y,S,P,F){let[G,K,le,pe]=P,we=S%2,De=0;return we==0&&(pe||K)&&(De=S==0&&!G||S==2&&!le?Cn(x_.size/3):0),we==1&&(G||le)&&(De=S==1&&!K||S==3&&!pe?Cn(b_.size/2):0),De}let Sa=i.padding=(n.padding||[Cr,Cr,Cr,Cr]).map(y=>wt(Rt(y,Cr))),Di=i._padding=Sa.map((y,S)=>y(i,S,Qi,0)),on,un=null,hn=null,er=r==1?_[0].idxs:null,hi=null,jr=!1;function Aa(y,S){if(e=y??[],i.data=i._data=e,r==2){on=0;for(let P=1;P<_.length;P++)on+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),hi=e[0],on=hi.length;let P=e;if(U==2){P=e.slice();let F=P[0]=Array(on);for(let G=0;G<on;G++)F[G]=G}i._data=e=P}if(pt(!0),Fn("setData"),U==2&&(ve=!0),S!==!1){let P=I;P.auto(i,jr)?Ma():ts(E,P.min,P.max),te=te||he.left>=0,me=!0,Gn()}}i.setData=Aa;function Ma(){jr=!0;let y,S;r==1&&(on>0?(un=er[0]=0,hn=er[1]=on-1,y=e[0][un],S=e[0][hn],U==2?(y=un,S=hn):y==S&&(U==3?[y,S]=Uh(y,y,I.log,!1):U==4?[y,S]=Up(y,y,I.log,!1):I.time?S=y+Cn(86400/p):[y,S]=Nh(y,S,Op,!0))):(un=er[0]=y=null,hn=er[1]=S=null)),ts(E,y,S)}let oo,Qr,ao,A,k,j,$,Z,Ee,Fe;function Ce(y,S,P,F,G,K){y??=Xy,P??=zp,F??="butt",G??=Xy,K??="round",y!=oo&&(h.strokeStyle=oo=y),G!=Qr&&(h.fillStyle=Qr=G),S!=ao&&(h.lineWidth=ao=S),K!=k&&(h.lineJoin=k=K),F!=j&&(h.lineCap=j=F),P!=A&&h.setLineDash(A=P)}function Ne(y,S,P,F){S!=Qr&&(h.fillStyle=Qr=S),y!=$&&(h.font=$=y),P!=Z&&(h.textAlign=Z=P),F!=Ee&&(h.textBaseline=Ee=F)}function He(y,S,P,F,G=0){if(F.length>0&&y.auto(i,jr)&&(S==null||S.min==null)){let K=Rt(un,0),le=Rt(hn,F.length-1),pe=P.min==null?jC(F,K,le,G,y.distr==3):[P.min,P.max];y.min=ji(y.min,P.min=pe[0]),y.max=ri(y.max,P.max=pe[1])}}let it={min:null,max:null};function xt(){for(let F in w){let G=w[F];V[F]==null&&(G.min==null||V[E]!=null&&G.auto(i,jr))&&(V[F]=it)}for(let F in w){let G=w[F];V[F]==null&&G.from!=null&&V[G.from]!=null&&(V[F]=it)}V[E]!=null&&pt(!0);let y={};for(let F in V){let G=V[F];if(G!=null){let K=y[F]=ga(w[F],aR);if(G.min!=null)Sn(K,G);else if(F!=E||r==2)if(on==0&&K.from==null){let le=K.range(i,null,null,F);K.min=le[0],K.max=le[1]}else K.min=Ht,K.max=-Ht}}if(on>0){_.forEach((F,G)=>{if(r==1){let K=F.scale,le=V[K];if(le==null)return;let pe=y[K];if(G==0){let we=pe.range(i,pe.min,pe.max,K);pe.min=we[0],pe.max=we[1],un=Ji(pe.min,e[0]),hn=Ji(pe.max,e[0]),hn-un>1&&(e[0][un]<pe.min&&un++,e[0][hn]>pe.max&&hn--),F.min=hi[un],F.max=hi[hn]}else F.show&&F.auto&&He(pe,le,F,e[G],F.sorted);F.idxs[0]=un,F.idxs[1]=hn}else if(G>0&&F.show&&F.auto){let[K,le]=F.facets,pe=K.scale,we=le.scale,[De,Ue]=e[G],ke=y[pe],at=y[we];ke!=null&&He(ke,V[pe],K,De,K.sorted),at!=null&&He(at,V[we],le,Ue,le.sorted),F.min=le.min,F.max=le.max}});for(let F in y){let G=y[F],K=V[F];if(G.from==null&&(K==null||K.min==null)){let le=G.range(i,G.min==Ht?null:G.min,G.max==-Ht?null:G.max,F);G.min=le[0],G.max=le[1]}}}for(let F in y){let G=y[F];if(G.from!=null){let K=y[G.from];if(K.min==null)G.min=G.max=null;else{let le=G.range(i,K.min,K.max,F);G.min=le[0],G.max=le[1]}}}let S={},P=!1;for(let F in y){let G=y[F],K=w[F];if(K.min!=G.min||K.max!=G.max){K.min=G.min,K.max=G.max;let le=K.distr;K._min=le==3?Kr(K.min):le==4?bp(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?Kr(K.max):le==4?bp(K.max,K.asinh):le==100?K.fwd(K.max):K.max,S[F]=P=!0}}if(P){_.forEach((F,G)=>{r==2?G>0&&S.y&&(F._paths=null):S[F.scale]&&(F._paths=null)});for(let F in S)ve=!0,Fn("setScale",F);ge&&he.left>=0&&(te=me=!0)}for(let F in V)V[F]=null}function Ve(y){let S=Cp(un-1,0,on-1),P=Cp(hn+1,0,on-1);for(;y[S]==null&&S>0;)S--;for(;y[P]==null&&P<on-1;)P++;return[S,P]}function yt(){if(on>0){let y=_.some(S=>S._focus)&&Fe!=ze.alpha;y&&(h.globalAlpha=Fe=ze.alpha),_.forEach((S,P)=>{if(P>0&&S.show&&(nn(P,!1),nn(P,!0),S._paths==null)){let F=Fe;Fe!=S.alpha&&(h.globalAlpha=Fe=S.alpha);let G=r==2?[0,e[P][0].length-1]:Ve(e[P]);S._paths=S.paths(i,P,G[0],G[1]),Fe!=F&&(h.globalAlpha=Fe=F)}}),_.forEach((S,P)=>{if(P>0&&S.show){let F=Fe;Fe!=S.alpha&&(h.globalAlpha=Fe=S.alpha),S._paths!=null&&Nt(P,!1);{let G=S._paths!=null?S._paths.gaps:null,K=S.points.show(i,P,un,hn,G),le=S.points.filter(i,P,K,G);(K||le)&&(S.points._paths=S.points.paths(i,P,un,hn,le),Nt(P,!0))}Fe!=F&&(h.globalAlpha=Fe=F),Fn("drawSeries",P)}}),y&&(h.globalAlpha=Fe=1)}}function nn(y,S){let P=S?_[y].points:_[y];P._stroke=P.stroke(i,y),P._fill=P.fill(i,y)}function Nt(y,S){let P=S?_[y].points:_[y],{stroke:F,fill:G,clip:K,flags:le,_stroke:pe=P._stroke,_fill:we=P._fill,_width:De=P.width}=P._paths;De=Gt(De*It,3);let Ue=null,ke=De%2/2;S&&we==null&&(we=De>0?"#fff":pe);let at=P.pxAlign==1&&ke>0;if(at&&h.translate(ke,ke),!S){let Pt=R-De/2,Ct=v-De/2,_t=q+De,Qe=de+De;Ue=new Path2D,Ue.rect(Pt,Ct,_t,Qe)}S?Oe(pe,De,P.dash,P.cap,we,F,G,le,K):Bt(y,pe,De,P.dash,P.cap,we,F,G,le,Ue,K),at&&h.translate(-ke,-ke)}function Bt(y,S,P,F,G,K,le,pe,we,De,Ue){let ke=!1;we!=0&&C.forEach((at,Pt)=>{if(at.series[0]==y){let Ct=_[at.series[1]],_t=e[at.series[1]],Qe=(Ct._paths||$l).band;Ts(Qe)&&(Qe=at.dir==1?Qe[0]:Qe[1]);let Ye,Yt=null;Ct.show&&Qe&&eR(_t,un,hn)?(Yt=at.fill(i,Pt)||K,Ye=Ct._paths.clip):Qe=null,Oe(S,P,F,G,Yt,le,pe,we,De,Ue,Ye,Qe),ke=!0}}),ke||Oe(S,P,F,G,K,le,pe,we,De,Ue)}let Mn=xa|Ip;function Oe(y,S,P,F,G,K,le,pe,we,De,Ue,ke){Ce(y,S,P,F,G),(we||De||ke)&&(h.save(),we&&h.clip(we),De&&h.clip(De)),ke?(pe&Mn)==Mn?(h.clip(ke),Ue&&h.clip(Ue),bt(G,le),gn(y,K,S)):pe&Ip?(bt(G,le),h.clip(ke),gn(y,K,S)):pe&xa&&(h.save(),h.clip(ke),Ue&&h.clip(Ue),bt(G,le),h.restore(),gn(y,K,S)):(bt(G,le),gn(y,K,S)),(we||De||ke)&&h.restore()}function gn(y,S,P){P>0&&(S instanceof Map?S.forEach((F,G)=>{h.strokeStyle=oo=G,h.stroke(F)}):S!=null&&y&&h.stroke(S))}function bt(y,S){S instanceof Map?S.forEach((P,F)=>{h.fillStyle=Qr=F,h.fill(P)}):S!=null&&y&&h.fill(S)}function Rr(y,S,P,F){let G=T[y],K;if(F<=0)K=[0,0];else{let le=G._space=G.space(i,y,S,P,F),pe=G._incrs=G.incrs(i,y,S,P,F,le);K=v2(S,P,pe,F,le)}return G._found=K}function xn(y,S,P,F,G,K,le,pe,we,De){let Ue=le%2/2;b==1&&h.translate(Ue,Ue),Ce(pe,le,we,De,pe),h.beginPath();let ke,at,Pt,Ct,_t=G+(F==0||F==3?-K:K);P==0?(at=G,Ct=_t):(ke=G,Pt=_t);for(let Qe=0;Qe<y.length;Qe++)S[Qe]!=null&&(P==0?ke=Pt=y[Qe]:at=Ct=y[Qe],h.moveTo(ke,at),h.lineTo(Pt,Ct));h.stroke(),b==1&&h.translate(-Ue,-Ue)}function lo(y){let S=!0;return T.forEach((P,F)=>{if(!P.show)return;let G=w[P.scale];if(G.min==null){P._show&&(S=!1,P._show=!1,pt(!1));return}else P._show||(S=!1,P._show=!0,pt(!1));let K=P.side,le=K%2,{min:pe,max:we}=G,[De,Ue]=Rr(F,pe,we,le==0?D:Le);if(Ue==0)return;let ke=G.distr==2,at=P._splits=P.splits(i,F,pe,we,De,Ue,ke),Pt=G.distr==2?at.map(Ye=>hi[Ye]):at,Ct=G.distr==2?hi[at[1]]-hi[at[0]]:De,_t=P._values=P.values(i,P.filter(i,Pt,F,Ue,Ct),F,Ue,Ct);P._rotate=K==2?P.rotate(i,_t,F,Ue):0;let Qe=P._size;P._size=Bi(P.size(i,_t,F,y)),Qe!=null&&P._size!=Qe&&(S=!1)}),S}function tr(y){let S=!0;return Sa.forEach((P,F)=>{let G=P(i,F,Qi,y);G!=Di[F]&&(S=!1),Di[F]=G}),S}function Pr(){for(let y=0;y<T.length;y++){let S=T[y];if(!S.show||!S._show)continue;let P=S.side,F=P%2,G,K,le=S.stroke(i,y),pe=P==0||P==3?-1:1,[we,De]=S._found;if(S.label!=null){let jn=S.labelGap*pe,pi=Cn((S._lpos+jn)*It);Ne(S.labelFont[0],le,"center",P==2?"top":qy),h.save(),F==1?(G=K=0,h.translate(pi,Cn(v+de/2)),h.rotate((P==3?-Lh:Lh)/2)):(G=Cn(R+q/2),K=pi);let Is=N_(S.label)?S.label(i,y,we,De):S.label;h.fillText(Is,G,K),h.restore()}if(De==0)continue;let Ue=w[S.scale],ke=F==0?q:de,at=F==0?R:v,Pt=S._splits,Ct=Ue.distr==2?Pt.map(jn=>hi[jn]):Pt,_t=Ue.distr==2?hi[Pt[1]]-hi[Pt[0]]:we,Qe=S.ticks,Ye=S.border,Yt=Qe.show?Qe.size:0,ln=Cn(Yt*It),Nn=Cn((S.alignTo==2?S._size-Yt-S.gap:S.gap)*It),kt=S._rotate*-Lh/180,cn=g(S._pos*It),di=(ln+Nn)*pe,Jn=cn+di;K=F==0?Jn:0,G=F==1?Jn:0;let Mi=S.font[0],Ui=S.align==1?ha:S.align==2?xp:kt>0?ha:kt<0?xp:F==0?"center":P==3?xp:ha,rr=kt||F==1?"middle":P==2?"top":qy;Ne(Mi,le,Ui,rr);let fi=S.font[1]*S.lineGap,Ti=Pt.map(jn=>g(a(jn,Ue,ke,at))),Oi=S._values;for(let jn=0;jn<Oi.length;jn++){let pi=Oi[jn];if(pi!=null){F==0?G=Ti[jn]:K=Ti[jn],pi=""+pi;let Is=pi.indexOf(`
`)==-1?[pi]:pi.split(/\n/gm);for(let Qn=0;Qn<Is.length;Qn++){let bm=Is[Qn];kt?(h.save(),h.translate(G,K+Qn*fi),h.rotate(kt),h.fillText(bm,0,0),h.restore()):h.fillText(bm,G,K+Qn*fi)}}}Qe.show&&xn(Ti,Qe.filter(i,Ct,y,De,_t),F,P,cn,ln,Gt(Qe.width*It,3),Qe.stroke(i,y),Qe.dash,Qe.cap);let sr=S.grid;sr.show&&xn(Ti,sr.filter(i,Ct,y,De,_t),F,F==0?2:1,F==0?v:R,F==0?de:q,Gt(sr.width*It,3),sr.stroke(i,y),sr.dash,sr.cap),Ye.show&&xn([cn],[1],F==0?1:0,F==0?1:2,F==1?v:R,F==1?de:q,Gt(Ye.width*It,3),Ye.stroke(i,y),Ye.dash,Ye.cap)}Fn("drawAxes")}function pt(y){_.forEach((S,P)=>{P>0&&(S._paths=null,y&&(r==1?(S.min=null,S.max=null):S.facets.forEach(F=>{F.min=null,F.max=null})))})}let an=!1,Kn=!1,Dt=[];function yn(){Kn=!1;for(let y=0;y<Dt.length;y++)Fn(...Dt[y]);Dt.length=0}function Gn(){an||(pR(nm),an=!0)}function Kl(y,S=!1){an=!0,Kn=S,y(i),nm(),S&&Dt.length>0&&queueMicrotask(yn)}i.batch=Kl;function nm(){if(oe&&(xt(),oe=!1),ve&&(Te(),ve=!1),ye){if(Kt(f,ha,Je),Kt(f,"top",ct),Kt(f,Gl,D),Kt(f,Wl,Le),Kt(m,ha,Je),Kt(m,"top",ct),Kt(m,Gl,D),Kt(m,Wl,Le),Kt(d,Gl,sn),Kt(d,Wl,mn),u.width=Cn(sn*It),u.height=Cn(mn*It),T.forEach(({_el:y,_show:S,_size:P,_pos:F,side:G})=>{if(y!=null)if(S){let K=G===3||G===0?P:0,le=G%2==1;Kt(y,le?"left":"top",F-K),Kt(y,le?"width":"height",P),Kt(y,le?"top":"left",le?ct:Je),Kt(y,le?"height":"width",le?Le:D),Tp(y,to)}else wi(y,to)}),oo=Qr=ao=k=j=$=Z=Ee=A=null,Fe=1,Ca(!0),Je!=Me||ct!=Vt||D!=Ge||Le!=Ke){pt(!1);let y=D/Ge,S=Le/Ke;if(ge&&!te&&he.left>=0){he.left*=y,he.top*=S,co&&Tr(co,Cn(he.left),0,D,Le),uo&&Tr(uo,0,Cn(he.top),D,Le);for(let P=0;P<ut.length;P++){let F=ut[P];F!=null&&(qt[P]*=y,Zn[P]*=S,Tr(F,Bi(qt[P]),Bi(Zn[P]),D,Le))}}if($t.show&&!ie&&$t.left>=0&&$t.width>0){$t.left*=y,$t.width*=y,$t.top*=S,$t.height*=S;for(let P in Jh)Kt(po,P,$t[P])}Me=Je,Vt=ct,Ge=D,Ke=Le}Fn("setSize"),ye=!1}sn>0&&mn>0&&(h.clearRect(0,0,u.width,u.height),Fn("drawClear"),M.forEach(y=>y()),Fn("draw")),$t.show&&ie&&(Jl($t),ie=!1),ge&&te&&(Ps(null,!0,!1),te=!1),ue.show&&ue.live&&me&&(Zh(),me=!1),l||(l=!0,i.status=1,Fn("ready")),jr=!1,an=!1}i.redraw=(y,S)=>{ve=S||!1,y!==!1?ts(E,I.min,I.max):Gn()};function Xh(y,S){let P=w[y];if(P.from==null){if(on==0){let F=P.range(i,S.min,S.max,y);S.min=F[0],S.max=F[1]}if(S.min>S.max){let F=S.min;S.min=S.max,S.max=F}if(on>1&&S.min!=null&&S.max!=null&&S.max-S.min<1e-16)return;y==E&&P.distr==2&&on>0&&(S.min=Ji(S.min,e[0]),S.max=Ji(S.max,e[0]),S.min==S.max&&S.max++),V[y]=S,oe=!0,Gn()}}i.setScale=Xh;let $h,Yh,co,uo,im,rm,ho,fo,sm,om,Xt,jt,es=!1,kn=he.drag,In=kn.x,Ln=kn.y;ge&&(he.x&&($h=Ni(OC,m)),he.y&&(Yh=Ni(kC,m)),I.ori==0?(co=$h,uo=Yh):(co=Yh,uo=$h),Xt=he.left,jt=he.top);let $t=i.select=Sn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),po=$t.show?Ni(UC,$t.over?m:f):null;function Jl(y,S){if($t.show){for(let P in y)$t[P]=y[P],P in Jh&&Kt(po,P,y[P]);S!==!1&&Fn("setSelect")}}i.setSelect=Jl;function Vb(y){if(_[y].show)Q&&Tp(lt[y],to);else if(Q&&wi(lt[y],to),ge){let P=Ie?ut[0]:ut[y];P!=null&&Tr(P,-10,-10,D,Le)}}function ts(y,S,P){Xh(y,{min:S,max:P})}function nr(y,S,P,F){S.focus!=null&&Xb(y),S.show!=null&&_.forEach((G,K)=>{K>0&&(y==K||y==null)&&(G.show=S.show,Vb(K),r==2?(ts(G.facets[0].scale,null,null),ts(G.facets[1].scale,null,null)):ts(G.scale,null,null),Gn())}),P!==!1&&Fn("setSeries",y,S),F&&Ra("setSeries",i,y,S)}i.setSeries=nr;function Hb(y,S){Sn(C[y],S)}function Gb(y,S){y.fill=wt(y.fill||null),y.dir=Rt(y.dir,-1),S=S??C.length,C.splice(S,0,y)}function Wb(y){y==null?C.length=0:C.splice(y,1)}i.addBand=Gb,i.setBand=Hb,i.delBand=Wb;function qb(y,S){_[y].alpha=S,ge&&ut[y]!=null&&(ut[y].style.opacity=S),Q&&lt[y]&&(lt[y].style.opacity=S)}let Ir,ns,Rs,mo={focus:!0};function Xb(y){if(y!=Rs){let S=y==null,P=ze.alpha!=1;_.forEach((F,G)=>{if(r==1||G>0){let K=S||G==0||G==y;F._focus=S?null:K,P&&qb(G,K?1:ze.alpha)}}),Rs=y,P&&Gn()}}Q&&nt&&Tt(Zy,Pe,y=>{he._lock||(tt(y),Rs!=null&&nr(null,mo,!0,_n.setSeries))});function ir(y,S,P){let F=w[S];P&&(y=y/It-(F.ori==1?ct:Je));let G=D;F.ori==1&&(G=Le,y=G-y),F.dir==-1&&(y=G-y);let K=F._min,le=F._max,pe=y/G,we=K+(le-K)*pe,De=F.distr;return De==3?pa(10,we):De==4?nR(we,F.asinh):De==100?F.bwd(we):we}function $b(y,S){let P=ir(y,E,S);return Ji(P,e[0],un,hn)}i.valToIdx=y=>Ji(y,e[0]),i.posToIdx=$b,i.posToVal=ir,i.valToPos=(y,S,P)=>w[S].ori==0?s(y,w[S],P?q:D,P?R:0):o(y,w[S],P?de:Le,P?v:0),i.setCursor=(y,S,P)=>{Xt=y.left,jt=y.top,Ps(null,S,P)};function am(y,S){Kt(po,ha,$t.left=y),Kt(po,Gl,$t.width=S)}function lm(y,S){Kt(po,"top",$t.top=y),Kt(po,Wl,$t.height=S)}let Ta=I.ori==0?am:lm,Ea=I.ori==1?am:lm;function Yb(){if(Q&&ue.live)for(let y=r==2?1:0;y<_.length;y++){if(y==0&&ft)continue;let S=ue.values[y],P=0;for(let F in S)qe[y][P++].firstChild.nodeValue=S[F]}}function Zh(y,S){if(y!=null&&(y.idxs?y.idxs.forEach((P,F)=>{ee[F]=P}):oR(y.idx)||ee.fill(y.idx),ue.idx=ee[0]),Q&&ue.live){for(let P=0;P<_.length;P++)(P>0||r==1&&!ft)&&Zb(P,ee[P]);Yb()}me=!1,S!==!1&&Fn("setLegend")}i.setLegend=Zh;function Zb(y,S){let P=_[y],F=y==0&&U==2?hi:e[y],G;ft?G=P.values(i,y,S)??ot:(G=P.value(i,S==null?null:F[S],y,S),G=G==null?ot:{_:G}),ue.values[y]=G}function Ps(y,S,P){sm=Xt,om=jt,[Xt,jt]=he.move(i,Xt,jt),he.left=Xt,he.top=jt,ge&&(co&&Tr(co,Cn(Xt),0,D,Le),uo&&Tr(uo,0,Cn(jt),D,Le));let F,G=un>hn;Ir=Ht,ns=null;let K=I.ori==0?D:Le,le=I.ori==1?D:Le;if(Xt<0||on==0||G){F=he.idx=null;for(let pe=0;pe<_.length;pe++){let we=ut[pe];we!=null&&Tr(we,-10,-10,D,Le)}nt&&nr(null,mo,!0,y==null&&_n.setSeries),ue.live&&(ee.fill(F),me=!0)}else{let pe,we,De;r==1&&(pe=I.ori==0?Xt:jt,we=ir(pe,E),F=he.idx=Ji(we,e[0],un,hn),De=H(e[0][F],I,K,0));let Ue=-10,ke=-10,at=0,Pt=0,Ct=!0,_t="",Qe="";for(let Ye=r==2?1:0;Ye<_.length;Ye++){let Yt=_[Ye],ln=ee[Ye],Nn=ln==null?null:r==1?e[Ye][ln]:e[Ye][1][ln],kt=he.dataIdx(i,Ye,F,we),cn=kt==null?null:r==1?e[Ye][kt]:e[Ye][1][kt];if(me=me||cn!=Nn||kt!=ln,ee[Ye]=kt,Ye>0&&Yt.show){let di=kt==null?-10:kt==F?De:H(r==1?e[0][kt]:e[Ye][0][kt],I,K,0),Jn=cn==null?-10:L(cn,r==1?w[Yt.scale]:w[Yt.facets[1].scale],le,0);if(nt&&cn!=null){let Mi=I.ori==1?Xt:jt,Ui=Rn(ze.dist(i,Ye,kt,Jn,Mi));if(Ui<Ir){let rr=ze.bias;if(rr!=0){let fi=ir(Mi,Yt.scale),Ti=cn>=0?1:-1,Oi=fi>=0?1:-1;Oi==Ti&&(Oi==1?rr==1?cn>=fi:cn<=fi:rr==1?cn<=fi:cn>=fi)&&(Ir=Ui,ns=Ye)}else Ir=Ui,ns=Ye}}if(me||Ie){let Mi,Ui;I.ori==0?(Mi=di,Ui=Jn):(Mi=Jn,Ui=di);let rr,fi,Ti,Oi,sr,jn,pi=!0,Is=ce.bbox;if(Is!=null){pi=!1;let Qn=Is(i,Ye);Ti=Qn.left,Oi=Qn.top,rr=Qn.width,fi=Qn.height}else Ti=Mi,Oi=Ui,rr=fi=ce.size(i,Ye);if(jn=ce.fill(i,Ye),sr=ce.stroke(i,Ye),Ie)Ye==ns&&Ir<=ze.prox&&(Ue=Ti,ke=Oi,at=rr,Pt=fi,Ct=pi,_t=jn,Qe=sr);else{let Qn=ut[Ye];Qn!=null&&(qt[Ye]=Ti,Zn[Ye]=Oi,n_(Qn,rr,fi,pi),e_(Qn,jn,sr),Tr(Qn,Bi(Ti),Bi(Oi),D,Le))}}}}if(Ie){let Ye=ze.prox,Yt=Rs==null?Ir<=Ye:Ir>Ye||ns!=Rs;if(me||Yt){let ln=ut[0];ln!=null&&(qt[0]=Ue,Zn[0]=ke,n_(ln,at,Pt,Ct),e_(ln,_t,Qe),Tr(ln,Bi(Ue),Bi(ke),D,Le))}}}if($t.show&&es)if(y!=null){let[pe,we]=_n.scales,[De,Ue]=_n.match,[ke,at]=y.cursor.sync.scales,Pt=y.cursor.drag;if(In=Pt._x,Ln=Pt._y,In||Ln){let{left:Ct,top:_t,width:Qe,height:Ye}=y.select,Yt=y.scales[ke].ori,ln=y.posToVal,Nn,kt,cn,di,Jn,Mi=pe!=null&&De(pe,ke),Ui=we!=null&&Ue(we,at);Mi&&In?(Yt==0?(Nn=Ct,kt=Qe):(Nn=_t,kt=Ye),cn=w[pe],di=H(ln(Nn,ke),cn,K,0),Jn=H(ln(Nn+kt,ke),cn,K,0),Ta(ji(di,Jn),Rn(Jn-di))):Ta(0,K),Ui&&Ln?(Yt==1?(Nn=Ct,kt=Qe):(Nn=_t,kt=Ye),cn=w[we],di=L(ln(Nn,at),cn,le,0),Jn=L(ln(Nn+kt,at),cn,le,0),Ea(ji(di,Jn),Rn(Jn-di))):Ea(0,le)}else jh()}else{let pe=Rn(sm-im),we=Rn(om-rm);if(I.ori==1){let at=pe;pe=we,we=at}In=kn.x&&pe>=kn.dist,Ln=kn.y&&we>=kn.dist;let De=kn.uni;De!=null?In&&Ln&&(In=pe>=De,Ln=we>=De,!In&&!Ln&&(we>pe?Ln=!0:In=!0)):kn.x&&kn.y&&(In||Ln)&&(In=Ln=!0);let Ue,ke;In&&(I.ori==0?(Ue=ho,ke=Xt):(Ue=fo,ke=jt),Ta(ji(Ue,ke),Rn(ke-Ue)),Ln||Ea(0,le)),Ln&&(I.ori==1?(Ue=ho,ke=Xt):(Ue=fo,ke=jt),Ea(ji(Ue,ke),Rn(ke-Ue)),In||Ta(0,K)),!In&&!Ln&&(Ta(0,0),Ea(0,0))}if(kn._x=In,kn._y=Ln,y==null){if(P){if(_m!=null){let[pe,we]=_n.scales;_n.values[0]=pe!=null?ir(I.ori==0?Xt:jt,pe):null,_n.values[1]=we!=null?ir(I.ori==1?Xt:jt,we):null}Ra(yp,i,Xt,jt,D,Le,F)}if(nt){let pe=P&&_n.setSeries,we=ze.prox;Rs==null?Ir<=we&&nr(ns,mo,!0,pe):Ir>we?nr(null,mo,!0,pe):ns!=Rs&&nr(ns,mo,!0,pe)}}me&&(ue.idx=F,Zh()),S!==!1&&Fn("setCursor")}let is=null;Object.defineProperty(i,"rect",{get(){return is==null&&Ca(!1),is}});function Ca(y=!1){y?is=null:(is=m.getBoundingClientRect(),Fn("syncRect",is))}function cm(y,S,P,F,G,K,le){he._lock||es&&y!=null&&y.movementX==0&&y.movementY==0||(Kh(y,S,P,F,G,K,le,!1,y!=null),y!=null?Ps(null,!0,!0):Ps(S,!0,!1))}function Kh(y,S,P,F,G,K,le,pe,we){if(is==null&&Ca(!1),tt(y),y!=null)P=y.clientX-is.left,F=y.clientY-is.top;else{if(P<0||F<0){Xt=-10,jt=-10;return}let[De,Ue]=_n.scales,ke=S.cursor.sync,[at,Pt]=ke.values,[Ct,_t]=ke.scales,[Qe,Ye]=_n.match,Yt=S.axes[0].side%2==1,ln=I.ori==0?D:Le,Nn=I.ori==1?D:Le,kt=Yt?K:G,cn=Yt?G:K,di=Yt?F:P,Jn=Yt?P:F;if(Ct!=null?P=Qe(De,Ct)?a(at,w[De],ln,0):-10:P=ln*(di/kt),_t!=null?F=Ye(Ue,_t)?a(Pt,w[Ue],Nn,0):-10:F=Nn*(Jn/cn),I.ori==1){let Mi=P;P=F,F=Mi}}we&&(S==null||S.cursor.event.type==yp)&&((P<=1||P>=D-1)&&(P=Qs(P,D)),(F<=1||F>=Le-1)&&(F=Qs(F,Le))),pe?(im=P,rm=F,[ho,fo]=he.move(i,P,F)):(Xt=P,jt=F)}let Jh={width:0,height:0,left:0,top:0};function jh(){Jl(Jh,!1)}let um,hm,dm,fm;function pm(y,S,P,F,G,K,le){es=!0,In=Ln=kn._x=kn._y=!1,Kh(y,S,P,F,G,K,le,!0,!1),y!=null&&(Tt(_p,Ap,mm,!1),Ra($y,i,ho,fo,D,Le,null));let{left:pe,top:we,width:De,height:Ue}=$t;um=pe,hm=we,dm=De,fm=Ue}function mm(y,S,P,F,G,K,le){es=kn._x=kn._y=!1,Kh(y,S,P,F,G,K,le,!1,!0);let{left:pe,top:we,width:De,height:Ue}=$t,ke=De>0||Ue>0,at=um!=pe||hm!=we||dm!=De||fm!=Ue;if(ke&&at&&Jl($t),kn.setScale&&ke&&at){let Pt=pe,Ct=De,_t=we,Qe=Ue;if(I.ori==1&&(Pt=we,Ct=Ue,_t=pe,Qe=De),In&&ts(E,ir(Pt,E),ir(Pt+Ct,E)),Ln)for(let Ye in w){let Yt=w[Ye];Ye!=E&&Yt.from==null&&Yt.min!=Ht&&ts(Ye,ir(_t+Qe,Ye),ir(_t,Ye))}jh()}else he.lock&&(he._lock=!he._lock,Ps(S,!0,y!=null));y!=null&&(An(_p,Ap),Ra(_p,i,Xt,jt,D,Le,null))}function Kb(y,S,P,F,G,K,le){if(he._lock)return;tt(y);let pe=es;if(es){let we=!0,De=!0,Ue=10,ke,at;I.ori==0?(ke=In,at=Ln):(ke=Ln,at=In),ke&&at&&(we=Xt<=Ue||Xt>=D-Ue,De=jt<=Ue||jt>=Le-Ue),ke&&we&&(Xt=Xt<ho?0:D),at&&De&&(jt=jt<fo?0:Le),Ps(null,!0,!0),es=!1}Xt=-10,jt=-10,ee.fill(null),Ps(null,!0,!0),pe&&(es=pe)}function gm(y,S,P,F,G,K,le){he._lock||(tt(y),Ma(),jh(),y!=null&&Ra(Ky,i,Xt,jt,D,Le,null))}function xm(){T.forEach(w2),B(i.width,i.height,!0)}no(Fh,fa,xm);let go={};go.mousedown=pm,go.mousemove=cm,go.mouseup=mm,go.dblclick=gm,go.setSeries=(y,S,P,F)=>{let G=_n.match[2];P=G(i,S,P),P!=-1&&nr(P,F,!0,!1)},ge&&(Tt($y,m,pm),Tt(yp,m,cm),Tt(Yy,m,y=>{tt(y),Ca(!1)}),Tt(Zy,m,Kb),Tt(Ky,m,gm),Lp.add(i),i.syncRect=Ca);let jl=i.hooks=n.hooks||{};function Fn(y,S,P){Kn?Dt.push([y,S,P]):y in jl&&jl[y].forEach(F=>{F.call(null,i,S,P)})}(n.plugins||[]).forEach(y=>{for(let S in y.hooks)jl[S]=(jl[S]||[]).concat(y.hooks[S])});let ym=(y,S,P)=>P,_n=Sn({key:null,setSeries:!1,filters:{pub:a_,sub:a_},scales:[E,_[1]?_[1].scale:null],match:[l_,l_,ym],values:[null,null]},he.sync);_n.match.length==2&&_n.match.push(ym),he.sync=_n;let _m=_n.key,Qh=rb(_m);function Ra(y,S,P,F,G,K,le){_n.filters.pub(y,S,P,F,G,K,le)&&Qh.pub(y,S,P,F,G,K,le)}Qh.sub(i);function Jb(y,S,P,F,G,K,le){_n.filters.sub(y,S,P,F,G,K,le)&&go[y](null,S,P,F,G,K,le)}i.pub=Jb;function jb(){Qh.unsub(i),Lp.delete(i),Pn.clear(),Ep(Fh,fa,xm),c.remove(),Pe?.remove(),Fn("destroy")}i.destroy=jb;function ed(){Fn("init",n,e),Aa(e||n.data,!1),V[E]?Xh(E,V[E]):Ma(),ie=$t.show&&($t.width>0||$t.height>0),te=me=!0,B(n.width,n.height)}return _.forEach(so),T.forEach(Er),t?t instanceof HTMLElement?(t.appendChild(c),ed()):t(i,ed):ed(),i}Hn.assign=Sn;Hn.fmtNum=kp;Hn.rangeNum=Nh;Hn.rangeLog=Uh;Hn.rangeAsinh=Up;Hn.orient=ro;Hn.pxRatio=It;Hn.join=fR;Hn.fmtDate=Vp,Hn.tzDate=AR;Hn.sync=rb;{Hn.addGap=o2,Hn.clipGaps=zh;let n=Hn.paths={points:ub};n.linear=db,n.stepped=c2,n.bars=u2,n.spline=d2}var S2={body:["1","2","3"],space:["x","y","z"],quaternion:["w","x","y","z"]};function gb(n,e){return n.columns.flatMap(t=>{let i=e.columns[t.name];if(i===void 0)return[];let r=t.name.startsWith("law_"),s=(r?t.name.slice(4):t.name).replaceAll("_"," "),o=r?`drift of ${s}`:A2(t.mathml)??s,a=S2[t.axes]??[],l=Array.from({length:t.width},(c,u)=>({label:t.width===1?o:`${o}${E2(a[u]??String(u+1))}`,values:r?i.map(h=>h-(i[0]??0)):M2(i,t.width,u)}));return[{...t,text:o,unit:Wn(t.unit),components:l}]})}function A2(n){let e=si(n);return e!==""&&e.length<=4?e:null}function M2(n,e,t){return e===1?n:Float64Array.from({length:n.length/e},(i,r)=>n[e*r+t]??NaN)}var T2={1:"₁",2:"₂",3:"₃",4:"₄",5:"₅",6:"₆",x:"ₓ"};function E2(n){return T2[n]??`_${n}`}var yb=10.5;function _b(n){let e=new Set(R2(n)),t=se("div",{class:"lab-chips",role:"toolbar","aria-label":"Quantities"}),i=se("div",{class:"lab-plots"}),r=se("div",{},t,i),s=[],o=()=>gb(n.model,n.shown.value.motion),a=()=>o().filter(({name:d})=>e.has(d)),l=()=>{for(let{plot:d}of s)d.destroy();i.replaceChildren(),s=a().map(d=>{let f=se("figure",{class:"lab-plot","aria-label":`${d.meaning||d.name} over time`});i.append(f);let m=Math.max(240,i.clientWidth||600),b=C2(d,f);return{plot:P2(n,d,f,m),readings:b}}),c()},c=()=>{for(let{plot:d,readings:f}of s){Yp(d,n);let{times:m}=n.shown.value.motion,{index:b,share:g}=uc(m,n.clock.time.value);f.forEach((p,_)=>{let T=d.data[_+1],w=(1-g)*(T?.[b]??NaN)+(g>0?g*(T?.[b+1]??NaN):0);p.textContent=St(w,4)})}},u=()=>{let d=a();if(d.length!==s.length)return l();d.forEach((f,m)=>s[m]?.plot.setData(vb(n,f))),c()};for(let d of o()){let f=d.text.length<=4?rs(d.mathml):d.text;t.append(Ls(f,d.meaning||d.name,e.has(d.name),m=>{m?e.add(d.name):e.delete(d.name),l()}))}n.shown.after(u),n.clock.time.after(c),yo(l);let h=0;return new ResizeObserver(()=>{if(i.clientWidth===h||i.clientWidth===0)return;let d=h===0;if(h=i.clientWidth,d)l();else for(let{plot:f}of s)f.setSize({width:h,height:Math.round(yb*ar())})}).observe(i),{element:r,chosen:a}}function C2(n,e){let t=Qt(),i=se("figcaption",{class:"lab-curves"});return e.append(i),n.components.map(({label:r},s)=>{let o=se("span",{class:"lab-number"}),a=`border-top: 2.5px ${xb[s%xb.length]??"solid"} ${bb(t,s)}`;return i.append(se("span",{},se("i",{style:a}),`${r} = `,o)),o})}var xb=["solid","dashed","dotted","solid"];function bb(n,e){return n.components[e]??n.series[e%n.series.length]??n.ink}function R2(n){let e=n.model.columns.map(({name:i})=>i),t=["omega","gamma"].filter(i=>e.includes(i));return t.length>0?t:e.filter(i=>!i.startsWith("lambda")).slice(0,2)}function vb(n,e){return[n.shown.value.motion.times,...e.components.map(({values:t})=>t)]}function P2(n,e,t,i){let r=Qt(),s={stroke:r.quiet,font:`${.8*ar()}px ${ss}`,ticks:{stroke:r.line,width:1,size:4},grid:{stroke:r.line,width:.5}},o=[[],[7,3],[2,3],[8,3,2,3]],a=`${e.text}${e.unit?`  (${e.unit})`:""}`,l=new Hn({width:i,height:Math.round(yb*ar()),legend:{show:!1},scales:{x:{time:!1}},cursor:{y:!1,drag:{x:!1,y:!1},points:{size:6},focus:{prox:24}},axes:[{...s,size:1.9*ar(),values:(h,d)=>d.map(f=>St(f,6))},{...s,size:3.9*ar(),label:a,labelSize:1.4*ar(),labelFont:`italic ${.88*ar()}px ${ss}`,values:(h,d)=>d.map(f=>St(f,6))}],series:[{},...e.components.map(({label:h},d)=>({label:h,stroke:bb(r,d),width:1.5,dash:o[d%o.length]??[],points:{show:!1}}))],hooks:{draw:[h=>Yp(h,n)]}},vb(n,e),t),c=h=>{let{left:d}=l.over.getBoundingClientRect();n.clock.pause(),n.clock.seek(l.posToVal(h.clientX-d,"x"))};l.over.addEventListener("pointerdown",h=>{l.over.setPointerCapture(h.pointerId),c(h)}),l.over.addEventListener("pointermove",h=>{l.over.hasPointerCapture(h.pointerId)&&c(h)}),l.over.style.touchAction="pan-y";let u=se("div",{class:"lab-plot-now"});return l.over.append(u),Yp(l,n),l}function Yp(n,e){let t=n.over.querySelector(".lab-plot-now");t!==null&&(t.style.transform=`translateX(${n.valToPos(e.clock.time.value,"x").toFixed(2)}px)`)}var I2={play:"M7 4.5v15l12-7.5z",pause:"M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",first:"M6 5h2.4v14H6zM19 5v14L9.5 12z",undo:"M9 6V2.5L3 8l6 5.500V10h5a4 4 0 0 1 0 8H8v2.500h6a6.500 6.500 0 0 0 0-14.500z",redo:"M15 6V2.500L21 8l-6 5.500V10h-5a4 4 0 0 0 0 8h6v2.500h-6a6.500 6.500 0 0 1 0-14.500z",whole:"M4 4h6v2.200H6.200V10H4zM14 4h6v6h-2.200V6.200H14zM4 14h2.200v3.800H10V20H4zM17.800 14H20v6h-6v-2.200h3.800z",link:"M10.600 13.400a1 1 0 0 0 1.400 0l4.200-4.200a1.800 1.800 0 0 0-2.600-2.600l-1.700 1.700-1.500-1.500 1.700-1.700a4 4 0 0 1 5.600 5.600l-4.200 4.200a3.100 3.100 0 0 1-4.400 0zM13.400 10.600a1 1 0 0 0-1.400 0l-4.200 4.200a1.800 1.800 0 0 0 2.600 2.600l1.700-1.700 1.500 1.500-1.700 1.700a4 4 0 0 1-5.600-5.600l4.200-4.200a3.100 3.100 0 0 1 4.400 0z",help:"M11 16.500h2.200V19H11zM12.100 5C9.700 5 8 6.500 7.900 8.900h2.300c.1-1.100.8-1.800 1.900-1.800s1.800.7 1.800 1.600c0 .8-.4 1.200-1.300 1.900-1.200.9-1.700 1.700-1.600 3.300v.6h2.200v-.4c0-.9.3-1.300 1.400-2.100 1-.8 1.700-1.700 1.700-3.300C16.300 6.500 14.600 5 12.100 5z"},wb="http://www.w3.org/2000/svg";function Sb(n){let e=document.createElementNS(wb,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true"),e.setAttribute("class","lab-icon");let t=document.createElementNS(wb,"path");return t.setAttribute("d",I2[n]),e.append(t),e}function va(n,e,t){let i=document.createElement("button");return i.type="button",i.className="lab-icon-button",i.title=e,i.setAttribute("aria-label",e),i.append(Sb(n)),i.addEventListener("click",t),i}function Ab(n,e,t){n.title=t,n.setAttribute("aria-label",t),n.replaceChildren(Sb(e))}function Mb(n,e){let{clock:t}=n,i=va("play","Play (space)",()=>t.toggle());i.classList.add("lab-play");let r=va("first","To the start (Home)",()=>t.seek(0)),s=se("input",{type:"range",min:0,step:"any","aria-label":"Time",class:"lab-scrub"}),o=se("output",{class:"lab-time","aria-live":"off"}),a=se("select",{"aria-label":"Speed",title:"Speed ([ and ])"}),l=va("undo","Undo (Ctrl+Z)",()=>{n.undo()}),c=va("redo","Redo (Ctrl+Shift+Z)",()=>{n.redo()}),u=va("whole","Full screen",e);s.addEventListener("input",()=>{t.pause(),t.seek(Number(s.value))}),a.addEventListener("change",()=>t.speed.value=Number(a.value)),t.speed.watch(m=>{let b=[...new Set([...Bo,m])].sort((g,p)=>g-p);a.replaceChildren(...b.map(g=>{let p=se("option",{value:g},`${St(g,2)}×`);return p.selected=g===m,p}))}),t.playing.watch(m=>Ab(i,m?"pause":"play",m?"Pause (space)":"Play (space)"));let h="s",d=()=>{let m=t.time.value,b=t.until<1?4:t.until<100?2:1;s.max=String(t.until),s.value=String(m),s.style.setProperty("--share",String(t.until>0?m/t.until:0));let g=`${m.toFixed(b)} ${h}`;o.textContent=`t = ${g}`,s.setAttribute("aria-valuetext",`${g} of ${t.until.toFixed(b)} ${h}`)};t.time.watch(d),n.shown.after(d),n.wanted.watch(()=>{l.disabled=!n.history.canUndo,c.disabled=!n.history.canRedo});let f=n.engine===null?null:se("span",{class:"lab-group"},l,c);return se("div",{class:"lab-transport",role:"toolbar","aria-label":"Playback"},r,i,s,o,se("label",{class:"lab-speed"},a),f,u)}function Cs(n,e){return n.quantities.findIndex(t=>t.name===e)}async function*Eb(n,e,t,i,r,s,o){let[a,l]=[Cs(e,i.x),Cs(e,i.y)],c=e.quantities.length,u=r,h=0,d=250;for(let f=0;f<s;){let{on:m,value:b,direction:g}=i,p=performance.now(),_=await n.section({parameters:t,start:u,on:m,value:b,direction:g,points:Math.min(d,s-f),until:o-h}),T=_.rows.length/_.dimension;if(T>0){let C=await n.quantities(t,_.rows,_.dimension);h+=_.times.at(-1)??0,yield{x:Tb(C,c,a,e),y:Tb(C,c,l,e),rows:_.rows,time:h,end:_.end?.reason??null},u=_.rows.slice((T-1)*_.dimension)}if(_.end!==null||T===0){T===0&&(yield{x:new Float64Array(0),y:new Float64Array(0),rows:_.rows,time:h,end:_.end?.reason??"it does not cross the section"});return}f+=T;let w=60/Math.max(1,performance.now()-p);d=Math.round(Math.min(5e3,Math.max(50,d*w)))}}function Tb(n,e,t,i){let r=i.quantities[t]?.angle===!0;return Float64Array.from({length:n.length/e},(s,o)=>{let a=n[o*e+t]??NaN;return r?L2(a):a})}function L2(n){let e=Math.round(n/(2*Math.PI));return n-2*Math.PI*e}function Cb(n,e,t,i){let r=0;for(let s=1;s<n.length;s++){let o=(n[s-1]??NaN)-e,a=(n[s]??NaN)-e,l=i?Math.floor(a/(2*Math.PI))-Math.floor(o/(2*Math.PI)):0,c=i?Math.sign(l):o<0&&a>=0?1:o>0&&a<=0?-1:0;c!==0&&(t===0||t===c)&&(r+=i?Math.abs(l):1)}return r}function Rb(n){let[e,t]=[1/0,-1/0];for(let r=0;r<n.length;r++){let s=n[r]??NaN;s<e&&(e=s),s>t&&(t=s)}if(!(t>e))return e===1/0?0:e;let i=10**Math.floor(Math.log10((t-e)/2));return Number((Math.round((e+t)/2/i)*i).toPrecision(6))}function Pb(n,e,t,i,r){let s=null,o=r*r;for(let a of n)for(let l=0;l<a.x.length;l++){let c=e(a.x[l]??NaN)-i.right,u=t(a.y[l]??NaN)-i.down,h=c*c+u*u;h<o&&([o,s]=[h,{orbit:a,index:l}])}return s}function Kp(n,e){return{...n,x:Zp(n.x,e.x),y:Zp(n.y,e.y),rows:Zp(n.rows,e.rows),until:e.time}}function Ib(n,e,t,i,r){let s=null,o=1/0;for(let{x:a,y:l,rows:c}of n){let u=c.length/e,h=a.length-u;for(let d=0;d<u;d++){let f=Math.hypot(((a[h+d]??NaN)-t.x)/i,((l[h+d]??NaN)-t.y)/r);f<o&&(o=f,s=c.subarray(d*e,(d+1)*e))}}return s}function Zp(n,e){let t=new Float64Array(n.length+e.length);return t.set(n),t.set(e,n.length),t}function Jp(n,e,t,i,r,s){let o=t.x.length>3e3?1.2:1.8,a=Math.max(1,Math.round(o*s))/s;n.fillStyle=r;for(let l=i;l<t.x.length;l++){let[c,u]=[e.right(t.x[l]??NaN),e.down(t.y[l]??NaN)];e.contains(c,u)&&n.fillRect(c-a/2,u-a/2,a,a)}}function jp(n,e){let[t,i]=Lr(e?n.map(r=>Math.abs(Math.tan(r/2))):n,0);return i-t>1e-6*Math.max(Math.abs(t),Math.abs(i))&&new Set(n).size>2}function Fb(n,e,t){return Array.from({length:t},(i,r)=>{let s=r/(t-1);return{x:n.x+s*(e.x-n.x),y:n.y+s*(e.y-n.y)}})}function Qp(n){return n.mathml?si(n.mathml):n.name}function Wh(n,e){if(n.length!==e.length)return!1;for(let t=0;t<n.length;t++)if(n[t]!==e[t])return!1;return!0}function em(n){return n.endsWith(".")?n:`${n}.`}var Lb=5;function Nb(n,e,t,i){let r={on:e.on,value:e.value,count:i(e.on,e.value)};if(r.count>=Lb)return e;let s=n.state.slice(0,n.reduced).map(({name:c})=>c).filter(c=>Cs(n,c)>=0),o=[e.on,...s].filter(c=>n.wasm_tables?.section_quantities.includes(c)??!0).flatMap(c=>[0,Rb(t(c))].map(u=>({on:c,value:u,count:i(c,u)}))),a=o.find(({count:c})=>c>=Lb)??o.reduce((c,u)=>u.count>c.count?u:c,r),l={...e,on:a.on,value:a.value};for(let c of["x","y"]){if(l[c]!==l.on)continue;let u=s.find(h=>![l.on,l.x,l.y].includes(h));u!==void 0&&(l={...l,[c]:u})}return l}var F2=12;function Bb(n){let{engine:e,model:t}=n;return e===null||t.section===null?null:new tm(n,new ac(t),{...t.section})}var tm=class{constructor(e,t,i){this.lab=e;this.engines=t;this.chosen=i;this.sheet=new os({label:"Poincaré section. Arrow keys move a cross, Enter starts an orbit there, plus and minus zoom, 0 shows all.",paint:(r,s,o)=>this.paint(r,s,o),click:r=>{this.start([r])},drag:(r,s)=>{this.start(Fb(r,s,F2))},hover:(r,s)=>this.hover(r,s),marks:(r,s)=>this.marks(r,s),whole:()=>this.whole(),keys:{Backspace:()=>this.remove(this.list.at(-1)),Delete:()=>this.remove(this.list.at(-1))}}),this.element=se("div",{},this.tools(),this.sheet.element,this.key,this.entries),e.shown.after(()=>this.follow()),this.axes({x:[-1,1],y:[-1,1]})}lab;engines;chosen;element;sheet;list=[];points=1e3;byIndicator=!1;serial=0;era=0;longest=1/0;placed=!1;current="";hovered=null;visible=!1;value=se("input",{type:"text",inputmode:"decimal",class:"lab-field","aria-label":"Value on the section"});entries=se("div",{class:"lab-orbits",role:"group","aria-label":"Orbits"});key=se("div",{class:"lab-key",hidden:!0});shown(){this.visible=!0,this.follow()}orbits(){return this.list}setting(){return this.chosen}tools(){let{model:e}=this.lab,t=e.quantities.map(h=>({value:h.name,text:Qp(h)})),i=e.wasm_tables?.section_quantities??e.quantities.map(({name:h})=>h),r=t.filter(({value:h})=>i.includes(h)),{chosen:s}=this,o=h=>{this.chosen={...this.chosen,...h},this.clear()},{value:a}=this;a.value=String(s.value),a.addEventListener("change",()=>{let h=Number(a.value.replace("−","-"));Number.isFinite(h)?o({value:h}):this.lab.say("The value on the section must be a number.",!0)});let l=[{value:"1",text:"rising"},{value:"-1",text:"falling"},{value:"0",text:"both"}],c=[200,1e3,5e3,2e4].map(h=>({value:String(h),text:String(h)})),u=(h,d,f)=>{let m=se("button",{type:"button",title:d},h);return m.addEventListener("click",f),m};return se("div",{class:"lab-tools",role:"toolbar","aria-label":"Section"},or("on",r,s.on,h=>o({on:h})),se("label",{class:"lab-choice"},"=",a),or("direction",l,String(s.direction),h=>o({direction:Number(h)})),or("across",t,s.x,h=>o({x:h})),or("up",t,s.y,h=>o({y:h})),or("points",c,String(this.points),h=>this.points=Number(h)),Ls("indicator","Colour orbits by MEGNO, an indicator of chaos",!1,h=>this.colourBy(h)),Ls("box","Drag a box to enlarge it (or Shift and drag)",!1,h=>this.sheet.boxing=h),u("+","Nearer (+)",()=>this.sheet.zoom(1/1.5)),u("−","Farther (−)",()=>this.sheet.zoom(1.5)),u("all","Show all points (0)",()=>this.sheet.showAll()),u("clear","Remove all orbits but that of the scene",()=>this.clear()))}quantity(e){return this.lab.model.quantities.find(t=>t.name===e)}axes({x:e,y:t}){let i=r=>{let s=this.quantity(r);if(s===void 0)return r;let o=Wn(s.unit);return`${Qp(s)}${o?`  (${o})`:""}`};this.sheet.setAxes({range:e,label:i(this.chosen.x)},{range:t,label:i(this.chosen.y)})}clear(){this.list=[],this.serial=0,this.next(),this.current="",this.follow(),this.entries.replaceChildren(),this.sheet.repaint()}follow(){let{state:e,experiment:t}=this.lab.shown.value;if(!this.visible||e===null)return;let i=JSON.stringify([t.parameters,Array.from(e)]);if(i===this.current)return;let r=this.list.some(s=>Wh(s.start,e))&&this.current.startsWith(`[${JSON.stringify(t.parameters)}`);if(this.current=i,r)return this.mark();this.list=[],this.serial=0,this.next(),this.open(e)}async open(e){let{era:t}=this,{motion:i,experiment:r}=this.lab.shown.value,{model:s}=this.lab,{states:o}=i;if(o===void 0)return void this.trace(e,!0);let a=await this.engines.engine.quantities(r.parameters,o,o.length/i.times.length);if(t!==this.era)return;let l=s.quantities.length,c=b=>{let g=Cs(s,b);return Float64Array.from(i.times,(p,_)=>a[_*l+g]??NaN)},u=(b,g)=>Cb(c(b),g,this.chosen.direction,s.quantities[Cs(s,b)]?.angle===!0),h=!this.placed;this.placed=!0,h&&(this.chosen=Nb(s,this.chosen,c,u),this.axes({x:[-1,1],y:[-1,1]}),this.writeSetting());let d=i.times.at(-1)??1,f=u(this.chosen.on,this.chosen.value);this.longest=f===0?20*d:5*d*Math.max(this.points,1e3)/f;let m=await this.trace(e,!0);m!==null&&h&&this.spread(m)}writeSetting(){let{on:e,value:t,x:i,y:r}=this.chosen;this.value.value=String(t);for(let[s,o]of[["on",e],["across",i],["up",r]]){let a=this.element.querySelector(`select[aria-label="${s}"]`);a&&(a.value=o)}}spread(e){let{model:t}=this.lab;for(let i of["x","y"]){let r=e[i];if(r.length<3||jp(r,this.quantity(this.chosen[i])?.angle===!0))continue;let s=this.chosen[i==="x"?"y":"x"],o=t.state.slice(0,t.reduced).map(({name:l})=>l),a=o.findIndex((l,c)=>[this.chosen.on,s].includes(l)||Cs(t,l)<0?!1:jp(Float64Array.from({length:e.rows.length/t.reduced},(u,h)=>e.rows[h*t.reduced+c]??NaN),!1));if(!(a<0)){this.chosen={...this.chosen,[i]:o[a]??this.chosen[i]},this.writeSetting(),this.clear();return}}}next(){this.era+=1,this.engines.renew()}mark(){this.writeEntries(),this.sheet.mark()}async start(e){let{state:t,experiment:i}=this.lab.shown.value;if(t===null)return;let{era:r}=this,{on:s,value:o,direction:a,x:l,y:c}=this.chosen,u="";for(let h of e){let[[d,f],[m,b]]=[this.sheet.frame.x.range,this.sheet.frame.y.range],g=Ib(this.list,this.lab.model.reduced,h,f-d,b-m),p=await this.engines.engine.startOnLevel({parameters:i.parameters,reference:g??t,section:{on:s,value:o,direction:a,x:l,y:c},x:h.x,y:h.y}).catch(()=>null);if(r!==this.era||p===null)return;if("message"in p){u=p.message;continue}if(h===e.at(-1)&&this.play(p.state),await this.trace(p.state,!1,h),r!==this.era)return}u!==""&&this.lab.say(em(u),!0)}play(e){let{lab:t}=this,{parameters:i}=t.shown.value.experiment;this.current=JSON.stringify([i,Array.from(e)]),t.change({...t.wanted.value,start:{state:Array.from(e)}}),t.clock.seek(0),this.mark()}async trace(e,t,i=null){let{era:r}=this,{parameters:s}=this.lab.shown.value.experiment,o={start:e,x:new Float64Array(0),y:new Float64Array(0),rows:new Float64Array(0),number:this.serial,until:0,indicator:null};i!==null&&(o=Kp(o,{x:Float64Array.of(i.x),y:Float64Array.of(i.y),rows:o.rows,time:0})),this.serial+=1,this.list.push(o),this.writeEntries();try{for await(let a of Eb(this.engines.engine,this.lab.model,s,this.chosen,e,this.points,this.longest)){if(r!==this.era)return null;let l=this.list.indexOf(o);if(l<0)return null;let c=o.x.length;o=Kp(o,a),this.list[l]=o,t&&c===0?this.axes(this.whole()):this.add(o,c),a.end!==null&&a.x.length===0&&this.lab.say(`The motion has no point of this section: ${a.end}.`,!0)}}catch(a){return r!==this.era||this.lab.say(em(a instanceof Error?a.message:String(a)),!0),null}return this.writeEntries(),this.byIndicator&&this.judge(o),o}colourBy(e){this.byIndicator=e,this.key.hidden=!e;let t=se("i",{style:`background:linear-gradient(90deg,${Fs().join(",")})`});if(this.key.replaceChildren(se("span",{},"MEGNO 2, regular"),t,se("span",{},"32 and more, chaotic")),this.sheet.repaint(),this.writeEntries(),e)for(let i of this.list)this.judge(i)}async judge(e){if(e.indicator!==null||!(e.until>0))return;let{era:t}=this,{parameters:i}=this.lab.shown.value.experiment,r=Math.min(e.until,20*this.lab.model.until),s=await this.engines.engine.indicator({parameters:i,start:e.start,until:r,kind:"megno"}).catch(()=>null);if(s===null)return;let o=this.list.findIndex(l=>l.number===e.number),a=this.list[o];t!==this.era||a===void 0||(this.list[o]={...a,indicator:s},this.sheet.repaint(),this.writeEntries())}remove(e){this.list=this.list.filter(t=>t!==e),this.sheet.repaint(),this.writeEntries()}colour(e){if(this.byIndicator&&e.indicator!==null)return`rgb(${Lm(e.indicator).join()})`;if(this.byIndicator)return Qt().quiet;let{series:t}=Qt();return t[e.number%t.length]??Qt().ink}paint(e,t,i){for(let r of this.list)Jp(e,t,r,0,this.colour(r),i)}add(e,t){let{pen:i,frame:r}=this.sheet;i!==null&&Jp(i,r,e,t,this.colour(e),Math.min(window.devicePixelRatio||1,2))}whole(){let e=t=>this.quantity(this.chosen[t])?.angle===!0?[-Math.PI,Math.PI]:Lr(this.list.flatMap(i=>Array.from(i[t])),.12);return{x:e("x"),y:e("y")}}hover(e,t){let i={right:t.right(e.x),down:t.down(e.y)},r=Pb(this.list,l=>t.right(l),l=>t.down(l),i,9);if(this.hovered=r?.orbit??null,r===null)return null;let{model:s}=this.lab,o=s.state.slice(0,s.reduced).map(({name:l,mathml:c},u)=>`${si(c||l)} = ${St(r.orbit.start[u]??NaN)}`),{indicator:a}=r.orbit;return`starts at ${o.join(", ")}${a===null?"":`; ${Ia(a)}`}`}marks(e,t){let i=(o,a)=>{o.x.length!==0&&(e.beginPath(),e.arc(t.right(o.x[0]??NaN),t.down(o.y[0]??NaN),a,0,2*Math.PI),e.stroke())};e.strokeStyle=Qt().ink,e.lineWidth=1.6;let{state:r}=this.lab.shown.value;for(let o of this.list)r!==null&&Wh(o.start,r)&&i(o,5);if(this.hovered===null)return;e.fillStyle=Qt().ink;let{hovered:s}=this;for(let o=0;o<s.x.length;o++){let[a,l]=[t.right(s.x[o]??NaN),t.down(s.y[o]??NaN)];t.contains(a,l)&&e.fillRect(a-1,l-1,2,2)}i(s,5)}writeEntries(){let{state:e}=this.lab.shown.value,t=this.list.slice(-40).map(i=>{let r=`Play orbit ${i.number+1}: ${i.x.length} points${i.indicator===null?"":`, ${Ia(i.indicator)}`}`,s=e!==null&&Wh(i.start,e),o=se("button",{type:"button","aria-label":r,title:r,"aria-current":s?"true":null},se("i",{style:`background:${this.colour(i)}`}),String(i.number+1));return o.addEventListener("click",()=>this.play(i.start)),o});this.entries.replaceChildren(...t)}};function Db({model:n}){return n.wasm===null?null:La(n).engine}var Ub='.uplot,.uplot *,.uplot *:before,.uplot *:after{box-sizing:border-box}.uplot{font-family:system-ui,-apple-system,Segoe UI,Roboto,Helvetica Neue,Arial,Noto Sans,sans-serif,"Apple Color Emoji","Segoe UI Emoji",Segoe UI Symbol,"Noto Color Emoji";line-height:1.5;width:min-content}.u-title{text-align:center;font-size:18px;font-weight:700}.u-wrap{position:relative;user-select:none}.u-over,.u-under{position:absolute}.u-under{overflow:hidden}.uplot canvas{display:block;position:relative;width:100%;height:100%}.u-axis{position:absolute}.u-legend{font-size:14px;margin:auto;text-align:center}.u-inline{display:block}.u-inline *{display:inline-block}.u-inline tr{margin-right:16px}.u-legend th{font-weight:600}.u-legend th>*{vertical-align:middle;display:inline-block}.u-legend .u-marker{width:1em;height:1em;margin-right:4px;background-clip:padding-box!important}.u-inline.u-live th:after{content:":";vertical-align:middle}.u-inline:not(.u-live) .u-value{display:none}.u-series>*{padding:4px}.u-series th{cursor:pointer}.u-legend .u-off>*{opacity:.3}.u-select{background:#00000012;position:absolute;pointer-events:none}.u-cursor-x,.u-cursor-y{position:absolute;left:0;top:0;pointer-events:none;will-change:transform}.u-hz .u-cursor-x,.u-vt .u-cursor-y{height:100%;border-right:1px dashed #607D8B}.u-hz .u-cursor-y,.u-vt .u-cursor-x{width:100%;border-bottom:1px dashed #607D8B}.u-cursor-pt{position:absolute;top:0;left:0;border-radius:50%;border:0 solid;pointer-events:none;will-change:transform;background-clip:padding-box!important}.u-axis.u-off,.u-select.u-off,.u-cursor-x.u-off,.u-cursor-y.u-off,.u-cursor-pt.u-off{display:none}.chaplygin-lab{--ink: #1f2730;--quiet: #66727d;--line: #d9dfe4;--faint: #eef1f4;--alarm: #b3475a;--paper: #ffffff;--box: #f6f8f9;--accent: #2f6690;--on-accent: #ffffff;--proven: #237055;--undecided: #8a6114;--thumb: #ffffff;color:var(--ink);font-family:STIX Two Text,"Libertinus Serif",Palatino Linotype,Palatino,Georgia,serif;line-height:1.4;container:lab / inline-size;position:relative}@media screen and (prefers-color-scheme:dark){.chaplygin-lab{--ink: #dde3e8;--quiet: #97a4af;--line: #36414b;--faint: #20282f;--alarm: #e58a99;--paper: #151a1f;--box: #1c2329;--accent: #79aede;--on-accent: #10161b;--proven: #63c39f;--undecided: #dba94a;--thumb: #dde3e8}}.chaplygin-lab *,.chaplygin-lab *:before{box-sizing:border-box}.chaplygin-lab.lab-live>.chaplygin-still{display:none}.lab-root{display:grid;gap:.9rem;grid-template-columns:minmax(0,1fr);background:var(--paper);text-align:left}.lab-root:fullscreen{padding:.8rem;overflow:auto}.lab-root [hidden]{display:none!important}.lab-view{min-width:0}.lab-scene{position:relative;height:clamp(15rem,58cqi,min(64vh,46rem));border-radius:6px;touch-action:none;cursor:grab;user-select:none;-webkit-user-select:none;overflow:hidden}.lab-scene:active{cursor:grabbing}.lab-canvas{display:block;width:100%;height:100%}.lab-legend,.lab-note,.lab-timebar{position:absolute;font-size:.86rem;color:var(--quiet);pointer-events:none}.lab-legend{top:.3rem;left:.5rem;color:var(--ink);display:grid;gap:.1rem}.lab-legend div{display:flex;gap:.45rem;align-items:center}.lab-arrow,.lab-timebar i{print-color-adjust:exact;-webkit-print-color-adjust:exact}.lab-arrow{width:1.3rem;height:3px;border-radius:2px}.lab-note{right:.6rem;bottom:.3rem}.lab-timebar{left:.5rem;bottom:.3rem;display:flex;gap:.45rem;align-items:center}.lab-timebar i{width:clamp(4rem,16cqi,11rem);height:.5rem;border-radius:1px}.lab-number{font-variant-numeric:tabular-nums;white-space:nowrap}.lab-root button,.lab-root select,.lab-root input[type=text]{font:inherit;font-size:.9rem;color:var(--ink);background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.24rem .55rem;min-height:2rem}.lab-root button{cursor:pointer}.lab-root button:hover:not(:disabled){background:var(--box);border-color:var(--quiet)}.lab-root button:disabled{color:var(--quiet);opacity:.55;cursor:default}.lab-root button[aria-pressed=true],.lab-root button[aria-pressed=true]:hover{background:var(--accent);color:var(--on-accent);border-color:var(--accent)}.lab-root :focus-visible{outline:2.5px solid var(--accent);outline-offset:2px}.lab-scene:focus-visible{outline-offset:-2px}.lab-icon{width:1.15rem;height:1.15rem;fill:currentColor;display:block}.lab-root .lab-icon-button{padding:.35rem;display:inline-grid;place-items:center;min-width:2.1rem}.lab-root .lab-play{background:var(--accent);color:var(--on-accent);border-color:var(--accent);min-width:2.8rem}.lab-root .lab-play:hover:not(:disabled){background:var(--accent);filter:brightness(1.1)}.lab-transport{display:flex;align-items:center;gap:.5rem;padding:.45rem 0}.lab-group{display:inline-flex;gap:.3rem}.lab-time{font-variant-numeric:tabular-nums;white-space:nowrap;min-width:5.6em;font-size:.95rem}.lab-switches,.lab-chips,.lab-tools{display:flex;flex-wrap:wrap;gap:.35rem}.lab-switches button,.lab-chips button{border-radius:1rem;padding:.12rem .7rem}.lab-message{min-height:1.4em;margin:.35rem 0 0;color:var(--quiet);font-size:.92rem}.lab-message:empty{visibility:hidden}.lab-refused{color:var(--alarm)}.lab-hint{color:var(--quiet);font-size:.88rem;margin:.3rem 0}.lab-root input[type=range]{appearance:none;-webkit-appearance:none;background:none;flex:1;min-width:3rem;height:2rem;margin:0;cursor:pointer;accent-color:var(--accent)}.lab-root input[type=range]::-webkit-slider-runnable-track{height:4px;border-radius:2px;background:linear-gradient(90deg,var(--accent) calc(100% * var(--share, 0)),var(--line) 0)}.lab-root input[type=range]::-moz-range-track{height:4px;border-radius:2px;background:var(--line)}.lab-root input[type=range]::-moz-range-progress{height:4px;border-radius:2px;background:var(--accent)}.lab-root input[type=range]::-webkit-slider-thumb{-webkit-appearance:none;width:1.05rem;height:1.05rem;border-radius:50%;margin-top:calc(2px - .525rem);background:var(--thumb);border:2px solid var(--accent)}.lab-root input[type=range]::-moz-range-thumb{width:.85rem;height:.85rem;border-radius:50%;background:var(--thumb);border:2px solid var(--accent)}.lab-sliders{columns:19rem 3;column-gap:2rem}.lab-sliders summary{color:var(--quiet);font-size:.9rem;cursor:pointer;width:fit-content;break-after:avoid}.lab-sliders>*+*{margin-top:.5rem}.lab-slider{display:flex;gap:.5rem;align-items:center;break-inside:avoid}.lab-symbol{white-space:nowrap;flex:0 0 3.2rem}.lab-value{display:inline-flex;align-items:baseline;gap:.3rem;min-width:9.3rem}.lab-root .lab-field{width:5.6rem;padding:.1rem .35rem;min-height:1.7rem;font-variant-numeric:tabular-nums;text-align:right}.lab-root .lab-field[aria-invalid=true]{border-color:var(--alarm)}.lab-unit{color:var(--quiet);font-size:.84rem;white-space:nowrap}.lab-deck{min-width:0}.lab-tabs{display:flex;gap:.2rem;border-bottom:1px solid var(--line);margin-bottom:.6rem;overflow-x:auto;scrollbar-width:none}.lab-root .lab-tabs button{border:0;border-bottom:3px solid transparent;border-radius:0;background:none;color:var(--quiet);padding:.3rem .6rem;white-space:nowrap;font-size:.98rem}.lab-root .lab-tabs button[aria-selected=true]{color:var(--ink);border-bottom-color:var(--accent)}.lab-root .lab-tabs :focus-visible{outline-offset:-3px}.lab-laws{list-style:none;margin:0;padding:0;columns:24rem 3;column-gap:2rem}.lab-laws li{break-inside:avoid;padding-bottom:.7rem}.lab-laws p{margin:0}.lab-law-head{display:flex;flex-wrap:wrap;gap:.1rem .8rem;align-items:baseline}.lab-law-head strong{font-weight:600}.lab-source{color:var(--quiet);font-size:.86rem}.lab-verdict{white-space:nowrap;color:var(--quiet)}.lab-proven{color:var(--proven)}.lab-refuted{color:var(--alarm)}.lab-undecided{color:var(--undecided)}.lab-formula{overflow:auto hidden;padding:.15rem 0}.lab-law-numbers{color:var(--quiet);font-size:.9rem;display:flex;flex-wrap:wrap;gap:0 1.2rem}.lab-law-numbers .lab-number{color:var(--ink)}.lab-keys{border-collapse:collapse;font-size:.92rem}.lab-keys th{text-align:left;font-weight:400;padding:.12rem 1.2rem .12rem 0;white-space:nowrap}.lab-keys td{padding:.12rem 0}.lab-root kbd{font:inherit;font-variant-numeric:tabular-nums}.lab-plots{display:grid;gap:.4rem;margin-top:.5rem}.lab-plot{margin:0;min-width:0}.lab-plot-now{position:absolute;top:0;bottom:0;left:0;width:1.5px;margin-left:-.75px;background:var(--ink);opacity:.7;pointer-events:none}.lab-root .uplot{font-family:inherit}.lab-curves{display:flex;flex-wrap:wrap;gap:0 1.2rem;padding-left:62px;font-size:.88rem}.lab-curves span{white-space:nowrap}.lab-curves>span{min-width:7.2em}.lab-curves i{display:inline-block;width:1.4rem;vertical-align:middle;margin-right:.4rem}.lab-choice{display:inline-flex;align-items:center;gap:.35rem;font-size:.9rem;color:var(--quiet)}.lab-tools{align-items:center;gap:.4rem .8rem;margin-bottom:.5rem}.lab-sheet{position:relative;width:100%;height:clamp(17rem,76cqi,min(70vh,44rem));touch-action:none;cursor:crosshair}.lab-sheet canvas{position:absolute;inset:0;width:100%;height:100%;display:block}.lab-tip{position:absolute;z-index:2;pointer-events:none;background:var(--paper);border:1px solid var(--line);border-radius:5px;padding:.25rem .5rem;font-size:.84rem;max-width:17rem;box-shadow:0 2px 8px #0002}.lab-progress{width:8rem;accent-color:var(--accent)}.lab-key{display:flex;align-items:center;gap:.5rem;font-size:.86rem;color:var(--quiet);margin-top:.3rem}.lab-key i{flex:0 1 12rem;height:.55rem;border-radius:1px}@container lab (max-width: 560px){.lab-transport{flex-wrap:wrap}.lab-root .lab-transport .lab-scrub{order:-1;flex:1 0 100%}.lab-time{flex:1;text-align:center}.lab-switches{flex-wrap:nowrap;overflow-x:auto;scrollbar-width:none;padding-bottom:.2rem}.lab-switches button{flex:none}.lab-root .lab-icon-button{min-width:2.6rem;min-height:2.6rem}.lab-value{min-width:8.4rem}.lab-symbol{flex-basis:2.6rem}.lab-curves{padding-left:0}}@container lab (min-width: 1100px){.lab-root{grid-template-columns:minmax(0,1.25fr) minmax(0,1fr);gap:1rem 1.6rem;align-items:start}.lab-scene{height:clamp(20rem,34cqi,72vh)}.lab-root>.lab-deck:last-child{grid-column:2;grid-row:1 / span 2}.lab-sheet{height:clamp(20rem,34cqi,72vh)}}@media(prefers-reduced-motion:reduce){.lab-root *{transition:none!important;animation:none!important}}@media print{.chaplygin-lab.lab-live>.chaplygin-still{display:block}.lab-root{display:none}.chaplygin-lab:not(:has(>.chaplygin-still:not(:empty)))>.lab-root{display:block}.chaplygin-lab:not(:has(>.chaplygin-still:not(:empty))) .lab-root>:not(.lab-view),.lab-transport,.lab-switches,.lab-message{display:none}}.lab-orbits{display:flex;flex-wrap:wrap;gap:.25rem;margin-top:.4rem}.lab-root .lab-orbits button{padding:0 .45rem;min-height:1.6rem;font-size:.82rem;display:inline-flex;gap:.3rem;align-items:center;border-radius:1rem}.lab-orbits i{width:.65rem;height:.65rem;border-radius:50%}.lab-root .lab-orbits button[aria-current=true]{border-color:var(--ink);box-shadow:inset 0 0 0 1px var(--ink)}.lab-spoken{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}.lab-downloads{columns:20rem 3;column-gap:1.6rem}.lab-downloads div{break-inside:avoid;padding-bottom:.4rem;display:flex;gap:.7rem;align-items:center}.lab-root .lab-downloads button{min-width:10.5rem}';function Ob(n){let e=n.getRootNode(),t=e instanceof ShadowRoot?e:document.head;if(t.querySelector("style[data-chaplygin-lab]")!==null)return;let i=document.createElement("style");i.dataset.chaplyginLab="",i.textContent=Ub,t.append(i)}function zb(n,e){Ob(n);let t=se("div",{class:"lab-root"});n.append(t);let i=null,r=B2(e).then(o=>{i=o,D2(n,t,o)});r.catch(o=>{t.replaceChildren(se("p",{class:"lab-message lab-refused",role:"alert"},o instanceof Error?o.message:String(o)))});let s=U2(r,()=>i);return window.chaplygin=s,s}async function B2(n){let{model:e}=n,t=Db(n),i=t===null?null:Hm(location.hash,e),r=i?.experiment??Ns(e),s="";i===null&&location.hash.startsWith("#lab&")&&(s="The address asks for values that this system does not have; the page shows its own start.");let o;if(i===null&&e.recorded!==null?o={experiment:r,motion:Hd(e),state:Float64Array.from(e.start),surface:Cc(e)}:o=await Rc(e,t,r),typeof o=="string"){s=o;let c=await Rc(e,t,Ns(e));if(typeof c=="string")throw new Error(c);o=c}let a=new Ec(e,t,o);s!==""&&a.say(s,!0);let l=Number(i?.choices.t);return Number.isFinite(l)&&a.clock.seek(l),a}function D2(n,e,t){let i=Oy(t);i!==null&&n.classList.add("lab-live");let r=()=>{document.fullscreenElement!==null?document.exitFullscreen():e.requestFullscreen().catch(()=>t.say("This browser shows no full screen here.",!0))},s=se("p",{class:"lab-message",role:"status","aria-live":"polite"});t.message.watch(g=>{s.textContent=g,s.classList.toggle("lab-refused",t.refused.value)});let o=_b(t),a=[{name:"plots",title:"Over time",content:o.element}],l=Bb(t);l!==null&&a.push({name:"section",title:"Section",content:l.element,shown:()=>l.shown()});let c=zm(t,l===null?null:()=>l.setting());c!==null&&a.push({name:"chart",title:"Chart",content:c.element,shown:()=>c.shown()});let u=Im(t);u!==null&&a.push({name:"bifurcation",title:"Bifurcation diagram",content:u.element,shown:()=>u.shown()});let h=[],d=Xm(t);d!==null&&h.push({name:"experiment",title:"Start and parameters",content:d});let f=C0(t);f!==null&&h.push({name:"laws",title:"Laws",content:f});let m=v0({lab:t,scene:i,plots:o,section:l,address:Hy(t)});h.push({name:"downloads",title:"Save",content:m},{name:"keys",title:"Keys",content:Vy()});let b=se("div",{class:"lab-view"},i?.element??null,Mb(t,r),i?.switches??null,s);e.append(b,gp("Values",h).element,gp("Pictures",a).element),e.addEventListener("keydown",g=>{!(g.ctrlKey||g.metaKey)||g.key.toLowerCase()!=="z"||(g.preventDefault(),g.shiftKey?t.redo():t.undo())}),i===null&&t.shown.value.motion.columns.attitude!==void 0&&t.message.value===""&&t.say("This browser draws no scene, as it offers no WebGL; everything else works.")}function U2(n,e){let t=()=>{let i=e();if(i===null)throw new Error("The page is not ready yet: wait for chaplygin.ready.");return i};return{ready:n,seek(i){t().clock.pause(),t().clock.seek(i)},pose:()=>Fa(t().shown.value.motion,t().clock.time.value),async set({parameters:i,start:r}){let s=t(),o=s.wanted.value,a={...o,parameters:{...o.parameters,...i}};if(Array.isArray(r)?a.start={state:r}:r!==void 0&&(a.start={inputs:{..."inputs"in o.start?o.start.inputs:{},...r}}),!await s.change(a)&&s.refused.value)throw new Error(s.message.value)},async motion(i,r){let s=t(),{motion:o,state:a,experiment:l}=s.shown.value;if(s.engine===null||a===null)return kb(o.times,o.columns);let c={parameters:l.parameters,start:a,times:cc(i,r)},u=await s.engine.motion(c);return kb(u.times,u.columns)},async section(i){let r=t(),{state:s,experiment:o}=r.shown.value;if(r.engine===null||s===null)throw new Error("This page shows a recorded motion and cannot compute a section.");let{rows:a,dimension:l}=await r.engine.section({parameters:o.parameters,start:s,...i});return Array.from({length:a.length/l},(c,u)=>Array.from(a.subarray(u*l,(u+1)*l)))},laws:()=>T0(t(),t().clock.time.value)}}function kb(n,e){let t=Object.entries(e).map(([i,r])=>[i,Array.from(r)]);return{time:Array.from(n),...Object.fromEntries(t)}}return rv(O2);})();
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
