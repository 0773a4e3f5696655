function Em(i,t,e){Object.defineProperty(window,"tolman",{value:Object.freeze({get rows(){return i().rows.count},get newestFrame(){return i().rows.frame(i().rows.count-1)},get shownFrame(){return i().frame},get imageFrame(){return i().picture?.frame??NaN},get mode(){return i().mode},get live(){return i().live},get graph(){const{experiences:s,links:r,loops:o,version:a}=i().graph;return{experiences:s,links:r,loops:o,version:a}},get map(){return{zoom:t.zoom,centre:t.centre,dimension:t.dimension,renders:t.renders}},get fps(){return e()},get dropped(){return i().dropped},get nodes(){return document.getElementsByTagName("*").length},row(s){const{rows:r}=i();return Object.fromEntries(r.names.map(o=>[o,r.value(s,o)]))}})})}function Yt(i){const t=document.getElementById(i);if(t===null)throw new Error(`no element #${i}`);return t}function so(i){const t=document.querySelector(`[data-testid="${i}"]`);if(t===null)throw new Error(`no element for ${i}`);return t}function me(i,t){i.textContent!==t&&(i.textContent=t)}function tn(i,t,e){i.getAttribute(t)!==e&&i.setAttribute(t,e)}function ye(i,t={},e=""){const n=document.createElement(i);for(const[s,r]of Object.entries(t))n.setAttribute(s,r);return e!==""&&(n.textContent=e),n}class Da{constructor(t){this.canvas=t,this.width=0,this.height=0;const e=t.getContext("2d");if(e===null)throw new Error("no 2-D canvas");this.context=e}fit(){const t=this.canvas.clientWidth,e=this.canvas.clientHeight,n=window.devicePixelRatio,[s,r]=[Math.round(t*n),Math.round(e*n)];return this.canvas.width===s&&this.canvas.height===r?!1:([this.canvas.width,this.canvas.height]=[s,r],[this.width,this.height]=[t,e],!0)}clear(){const t=window.devicePixelRatio;return this.context.setTransform(t,0,0,t,0,0),this.context.clearRect(0,0,this.width,this.height),this.context}}function wm(i){const t=new Map(i.flatMap(e=>e.keys.map(n=>[n,e])));document.addEventListener("keydown",e=>{if(e.ctrlKey||e.metaKey||e.altKey||document.querySelector("dialog[open]")!==null)return;const n=t.get(e.key);n===void 0||Tm(e)||(e.preventDefault(),n.act(e))}),bm(i)}function Tm(i){const t=i.target;return i.key===" "?t.matches("button, input[type=checkbox]"):t.matches("#events")&&["ArrowUp","ArrowDown","Home","End"].includes(i.key)}function bm(i){const t=i.map(({shown:e,meaning:n})=>{const s=ye("tr"),r=ye("td");return r.append(...e.split(" ").map(o=>ye("kbd",{},o))),s.append(r,ye("td",{},n)),s});Yt("keys").replaceChildren(...t)}const Am=["ink","soft","faint","line","panel","well","blue","orange","green","vermilion","purple","sky","grey","accent","truth"],_d="tolman.theme";class Rm{constructor(t){this.changed=t,this.system=matchMedia("(prefers-color-scheme: dark)"),this.chosen=null,this.chosen=Cm(),this.system.addEventListener("change",()=>this.apply()),this.colours_=this.show()}get name(){return this.chosen??(this.system.matches?"dark":"light")}get colours(){return this.colours_}toggle(){this.chosen=this.name==="dark"?"light":"dark";try{localStorage.setItem(_d,this.chosen)}catch{}this.apply()}apply(){this.colours_=this.show(),this.changed()}show(){document.documentElement.dataset.theme=this.name;const t=getComputedStyle(document.documentElement),e=Am.map(n=>[n,t.getPropertyValue(`--${n}`).trim()]);return Object.fromEntries(e)}}function Cm(){try{const i=localStorage.getItem(_d);return i==="light"||i==="dark"?i:null}catch{return null}}class vd{constructor(t){this.window=t,this.times=[],this.counts=[]}note(t,e){this.times.push(e),this.counts.push(t),this.forget(e)}rate(t){if(this.forget(t),this.times.length<2)return 0;const e=Math.max(t,this.times[this.times.length-1])-this.times[0],n=this.counts[this.counts.length-1]-this.counts[0];return e>0?n/e:0}forget(t){let e=0;for(;e<this.times.length&&this.times[e]<t-this.window;)++e;e>0&&(this.times.splice(0,e),this.counts.splice(0,e))}}const Pm={u8:{size:1,make:(i,t,e)=>new Uint8Array(i,t,e)},i32:{size:4,make:(i,t,e)=>new Int32Array(i,t,e)},f32:{size:4,make:(i,t,e)=>new Float32Array(i,t,e)},f64:{size:8,make:(i,t,e)=>new Float64Array(i,t,e)}};class ii extends Error{}function ho(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)}function xd(i){if(i.byteLength<4)throw new ii("message shorter than its length field");const t=new DataView(i).getUint32(0,!0);if(4+t>i.byteLength)throw new ii("header longer than the message");const e=Dm(new Uint8Array(i,4,t)),n=e.type;if(typeof n!="string")throw new ii("header without a type");const s=Math.ceil((4+t)/8)*8;return{type:n,header:e,arrays:Lm(i,s,e.arrays)}}function Dm(i){let t;try{t=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(i))}catch{throw new ii("header is not JSON")}if(!ho(t))throw new ii("header is not an object");return t}function Lm(i,t,e){const n=new Map;if(e===void 0)return n;if(!Array.isArray(e))throw new ii('"arrays" is not a list');for(const s of e){if(!ho(s))throw new ii("an array is not described by an object");const r=s.name;if(typeof r!="string")throw new ii("an array without a name");n.set(r,Um(i,t,r,s))}return n}function Um(i,t,e,n){const s=Pm[String(n.dtype)],r=n.shape,o=n.offset;if(s===void 0)throw new ii(`array ${e}: unknown dtype`);if(!Array.isArray(r)||!r.every(eu))throw new ii(`array ${e}: shape`);if(!eu(o)||o%8!==0)throw new ii(`array ${e}: offset`);const a=r.reduce((l,c)=>l*c,1);if(t+o+a*s.size>i.byteLength)throw new ii(`array ${e} reaches beyond the message`);return{shape:r,values:s.make(i,t+o,a)}}function eu(i){return typeof i=="number"&&Number.isInteger(i)&&i>=0}function In(i,t=NaN){return typeof i=="number"?i:t}function Ps(i,t=""){return typeof i=="string"?i:t}function Ql(i){return Array.isArray(i)?i:[]}function Nm(i){const t=i.camera;return{name:Ps(i.name,"run"),directory:Ps(i.directory),description:Ps(i.description),frames:In(i.frames,-1),hasTruth:i.has_truth===!0,live:i.live===!0,camera:ho(t)?{width:In(t.width,0),height:In(t.height,0),baseline:In(t.baseline,0)}:null,stages:Ql(i.stages).filter(e=>typeof e=="string"),columns:Ql(i.row).map(e=>ho(e)?Ps(e.name):""),rows:In(i.rows,0),newest:In(i.newest,-1)}}function Md(i,t){const e=i.arrays.get("rows");return!(e?.values instanceof Float64Array)||e.shape.length!==2?null:{from:t,columns:e.shape[1]??0,values:e.values}}function Im(i){return Ql(i).filter(ho).map(t=>({frame:In(t.frame,-1),level:Ps(t.level,"info"),source:Ps(t.source),message:Ps(t.message)}))}function Fm(i){const t=[];for(const[e,n]of i.arrays)e.startsWith("cells.")&&n.values instanceof Float32Array&&t.push({name:e.slice(6),shape:n.shape,values:n.values});return t}function Sd(i){const{header:t,arrays:e}=i,n=e.get("image")?.values,s=e.get("points")?.values;return{frame:In(t.frame,-1),image:n instanceof Uint8Array&&n.length>0?n:null,points:s instanceof Float32Array?s:null,pointsFrame:In(t.points_frame,-1),cells:Fm(i),rows:Md(i,In(t.rows_from,0)),events:Im(t.events),dropped:In(t.dropped,0),clients:In(t.clients,0)}}function yd({header:i,arrays:t}){const e=t.get("experience")?.values,n=t.get("experience_frame")?.values,s=t.get("link")?.values,r=t.get("link_kind")?.values;return{version:In(i.version,0),frame:In(i.frame,-1),experience:e instanceof Float32Array?e:new Float32Array,experienceFrame:n instanceof Int32Array?n:new Int32Array,link:s instanceof Int32Array?s:new Int32Array,linkKind:r instanceof Uint8Array?r:new Uint8Array}}const Ed=1e4;async function rh(i){const t=await fetch(i,{cache:"no-store"});if(t.status===404)return null;if(!t.ok)throw new Error(`${i}: ${t.status}`);return xd(await t.arrayBuffer())}async function nu(i,t){const e=Math.min(t,Ed),n=await rh(`/api/history?from=${i}&count=${e}`);return n&&Md(n,Number(n.header.from??i))}async function Om(i){const t=await rh(`/api/frame/${i}`);return t&&Sd(t)}async function km(){const i=await rh("/api/graph");return i&&yd(i)}function Bm(i){return`/api/template/${i}`}const iu=.5,zm=10;function Hm(i){return Math.min(zm,i*2)}class Vm{constructor(t,e){this.address=t,this.listener=e,this.socket=null,this.wait=iu,this.live=!0,this.ended=!1}open(){this.ended=!1,this.listener.state("connecting",0);const t=new WebSocket(this.address);t.binaryType="arraybuffer",this.socket=t,t.onopen=()=>{this.live||this.say(),this.listener.state("open",0)},t.onmessage=e=>this.receive(e.data),t.onclose=()=>this.closed()}setFlow(t){this.live!==t&&(this.live=t,this.say())}say(){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify({type:"flow",live:this.live}))}receive(t){if(!(t instanceof ArrayBuffer))return;const e=xd(t);e.type==="hello"&&(this.wait=iu),e.type==="end"&&(this.ended=!0),this.listener.message(e)}closed(){if(this.socket=null,this.ended){this.listener.state("ended",0);return}const t=this.wait;this.wait=Hm(t),this.listener.state("waiting",t),setTimeout(()=>this.open(),t*1e3)}}const su=1e3,Gm=2e4;class Wm{constructor(){this.logged=[],this.moments=[],this.seen=new Set,this.scanned=0,this.edition_=0}get edition(){return this.edition_}get count(){return this.logged.length+this.moments.length}clear(){this.logged=[],this.moments=[],this.seen.clear(),this.scanned=0,++this.edition_}add(t){for(const e of t){const n=`${e.frame} ${e.source} ${e.message}`;this.seen.has(n)||(this.seen.add(n),this.logged.push(e),++this.edition_)}this.logged.length>su&&(this.logged.splice(0,this.logged.length-su),this.seen=new Set(this.logged.map(e=>`${e.frame} ${e.source} ${e.message}`)))}scan(t){for(;this.scanned<t.count;++this.scanned)for(const e of Xm(t,this.scanned))this.moments.length<Gm&&this.moments.push(e),++this.edition_}newest(t,e){return[...ru(this.logged,t,e),...ru(this.moments,t,e)].sort((s,r)=>r.frame-s.frame).slice(0,e)}}function ru(i,t,e){const n=[];for(let s=i.length-1;s>=0&&n.length<e;--s){const r=i[s];r.frame<=t&&n.push(r)}return n}function Xm(i,t){const e=[],n=i.frame(t),s=(u,h,f)=>e.push({frame:n,level:u,source:h,message:f}),r=i.value(t,"tracking"),o=i.value(t-1,"tracking");if(r===2&&o!==2&&s("warning","odometry","tracking lost"),r===1&&o===2&&s("info","odometry","tracking again"),i.value(t,"action")!==2)return e;const a=i.value(t,"experience"),l=i.value(t,"template_id"),c=l>=0?` by template ${l}`:"";return s("loop","cells",`loop to experience ${a}${c}`),e}const Ym=24;class qm{constructor(t,e,n){this.fetchFrame=t,this.arrived=e,this.failed=n,this.kept=new Map,this.busy=!1,this.next=null}get loading(){return this.busy}clear(){this.kept.clear(),this.next=null}keep(t){(t.image!==null||t.cells.length>0)&&this.remember(t.frame,t)}want(t){const e=this.kept.get(t);if(e!==void 0){this.next=null,this.remember(t,e),this.arrived(t,e);return}this.next=t,this.busy||this.fetchNext()}remember(t,e){this.kept.delete(t),this.kept.set(t,e);for(const n of this.kept.keys()){if(this.kept.size<=Ym)break;this.kept.delete(n)}}async fetchNext(){for(this.busy=!0;this.next!==null;){const t=this.next;this.next=null;try{const e=await this.fetchFrame(t);e!==null&&this.remember(t,e),this.arrived(t,e)}catch(e){this.failed(e)}}this.busy=!1}}class $m{constructor(){this.message=null,this.loops_=0,this.edition_=0}get experiences(){return this.message?this.message.experience.length/4:0}get links(){return this.message?this.message.linkKind.length:0}get loops(){return this.loops_}get version(){return this.message?.version??-1}get frame(){return this.message?.frame??-1}get edition(){return this.edition_}replace(t){t&&this.message&&t.frame<this.message.frame||this.set(t)}clear(){this.set(null)}position(t){const e=this.message?.experience??Km,n=4*t;return[e[n]??NaN,e[n+1]??NaN,e[n+2]??NaN]}madeAt(t){return this.message?.experienceFrame[t]??-1}ends(t){const e=this.message?.link;return[e?.[2*t]??-1,e?.[2*t+1]??-1]}isLoop(t){return this.message?.linkKind[t]===1}set(t){this.message=t,this.loops_=t?t.linkKind.reduce((e,n)=>e+(n===1?1:0),0):0,++this.edition_}}const Km=new Float32Array;class ou{constructor(t,e,n){this.store=t,this.fetchRows=e,this.loaded=n,this.busy=!1,this.wanted=0}get loading(){return this.busy}async catchUp(t){if(this.wanted=Math.max(this.wanted,t),!this.busy){this.busy=!0;try{for(;this.store.count<this.wanted;){const e=this.store.count,n=await this.fetchRows(e,Math.min(this.wanted-e,Ed));if(n!==null&&this.store.add(n),this.loaded(),this.store.count===e)break}}finally{this.busy=!1}}}}class Zm{constructor(t){this.changed=t,this.shown=null,this.next=null,this.busy=!1}get picture(){return this.shown}clear(){this.next=null,this.shown?.bitmap.close(),this.shown=null}dropAfter(t){(this.shown?.frame??t)>t&&this.clear()}decode(t){t.image===null||t.frame===this.shown?.frame||(this.next=t,this.busy||this.work())}async work(){for(this.busy=!0;this.next?.image;){const{image:t,frame:e}=this.next;this.next=null;const n=new Blob([t.slice()],{type:"image/jpeg"}),s=await createImageBitmap(n).catch(()=>null);s!==null&&(this.shown?.bitmap.close(),this.shown={frame:e,bitmap:s},this.changed())}this.busy=!1}}const rl=[1,2,5,10,50],jm=.25;class Jm{constructor(){this.mode_="live",this.row_=-1,this.clock=0,this.speed_=1}get mode(){return this.mode_}get row(){return this.row_}get speed(){return this.speed_}reset(){this.mode_="live",this.row_=-1}grow(t){return this.mode_!=="live"||this.row_===t-1?!1:(this.row_=t-1,!0)}follow(t){this.mode_="live",this.row_=t-1}pause(){this.mode_="paused"}seek(t,e){this.mode_="paused",this.row_=Math.max(0,Math.min(e-1,Math.round(t)))}play(t,e){this.row_>=e-1&&(this.row_=0),this.clock=t[this.row_]??0,this.mode_="playing"}cycleSpeed(){const t=rl.findIndex(e=>e===this.speed_);this.speed_=rl[(t+1)%rl.length]??1}tick(t,e,n){if(this.mode_!=="playing")return!1;this.clock+=Math.min(t,jm)*this.speed_;const s=this.row_;for(;this.row_+1<n&&(e[this.row_+1]??1/0)<=this.clock;)++this.row_;return this.row_>=n-1&&(this.mode_="paused"),this.row_!==s||this.mode_==="paused"}}const ol=1024;class au{constructor(t){this.names=t,this.columns=new Map,this.early=[],this.capacity=ol,this.length=0,this.templates_=new Int32Array(ol),this.firstRows=[];for(const e of t)this.columns.set(e,new Float64Array(ol))}get count(){return this.length}get gap(){return this.early.length>0?this.length:-1}column(t){return this.columns.get(t)??Qm}value(t,e){return t<0||t>=this.length?NaN:this.columns.get(e)?.[t]??NaN}templates(t){return t>=0&&t<this.length?this.templates_[t]??0:0}frameOfTemplate(t){return this.frame(this.firstRows[t]??-1)}frame(t){return this.value(t,"frame")}rowOfFrame(t){const e=this.column("frame");let n=0,s=this.length;for(;n<s;){const r=n+s>>1;(e[r]??1/0)<=t?n=r+1:s=r}return n-1}add(t){if(t.columns!==this.names.length)throw new Error("rows with other columns");const e=this.length;for(this.early.push(t),this.early.sort((n,s)=>n.from-s.from);this.early.length>0&&this.early[0].from<=this.length;)this.append(this.early.shift());return this.length>e}append(t){const e=Math.floor(t.values.length/t.columns),n=this.length-t.from;if(n>=e)return;this.reserve(t.from+e),this.names.forEach((r,o)=>{const a=this.column(r);for(let l=n;l<e;++l)a[t.from+l]=t.values[l*t.columns+o]});const s=this.length;this.length=t.from+e,this.countTemplates(s)}countTemplates(t){const e=this.column("template_id");let n=t>0?this.templates_[t-1]:0;for(let s=t;s<this.length;++s){const r=e[s];r!==void 0&&r+1>n&&(n=r+1,this.firstRows[r]=s),this.templates_[s]=n}}reserve(t){if(t<=this.capacity)return;for(;this.capacity<t;)this.capacity*=2;for(const[n,s]of this.columns){const r=new Float64Array(this.capacity);r.set(s),this.columns.set(n,r)}const e=new Int32Array(this.capacity);e.set(this.templates_),this.templates_=e}}const Qm=new Float64Array;class tg{constructor(t,e){this.changed=e,this.player=new Jm,this.trouble=null,this.info=null,this.rows=new au([]),this.loader=new ou(this.rows,nu,()=>{}),this.graph=new $m,this.events=new Wm,this.rate=new vd(5),this.message=null,this.link="connecting",this.live=!1,this.endState="",this.dropped=0,this.streamed=0,this.graphAsked=!1,this.frames=new qm(Om,(n,s)=>this.stored(n,s),()=>this.lostServer()),this.pictures=new Zm(e),this.connection=new Vm(t,{message:n=>this.receive(n),state:(n,s)=>this.linkChanged(n,s)})}open(){this.connection.open()}view(t){const e=Math.min(this.player.row,this.rows.count-1);return{info:this.info,rows:this.rows,row:e,frame:this.rows.frame(e),message:this.message,picture:this.pictures.picture,graph:this.graph,events:this.events,mode:this.player.mode,speed:this.player.speed,live:this.live,loading:this.loader.loading,link:this.link,rate:this.live?this.rate.rate(performance.now()/1e3):NaN,dropped:this.dropped,colours:t}}get count(){return this.rows.count}get isLive(){return this.live}get end(){return this.endState}seek(t){this.rows.count!==0&&(this.player.seek(t,this.rows.count),this.shownChanged())}seekFrame(t){this.seek(this.rows.rowOfFrame(t))}follow(){this.player.follow(this.rows.count),this.shownChanged()}toggle(){this.player.mode!=="paused"?this.player.pause():this.player.play(this.rows.column("stamp_s"),this.rows.count),this.shownChanged()}tick(t){const e=this.rows.column("stamp_s");if(!this.player.tick(t,e,this.rows.count))return;this.live&&this.player.mode==="paused"?this.follow():this.shownChanged()}receive(t){t.type==="hello"?this.greet(Nm(t.header)):t.type==="frame"?this.frame(Sd(t)):t.type==="graph"?this.graph.replace(yd(t)):t.type==="end"&&this.finish(String(t.header.state??"finished")),this.changed()}greet(t){this.info!==null&&this.info.name===t.name&&this.info.directory===t.directory&&t.rows>=this.rows.count&&t.columns.join()===this.rows.names.join()||this.restart(t),this.info=t,this.live=t.live,this.endState="",this.trouble=null,this.dropped=0,this.connection.setFlow(this.player.mode==="live"),this.catchUp(t.rows)}restart(t){this.rows=new au(t.columns),this.loader=new ou(this.rows,nu,()=>this.grown()),this.graph.clear(),this.events.clear(),this.frames.clear(),this.player.reset(),this.message=null,this.pictures.clear(),this.graphAsked=!1}async catchUp(t){try{await this.loader.catchUp(t)}catch{this.lostServer();return}this.grown();const e=this.rows.count-1;this.rows.value(e,"experiences")>0&&this.graph.experiences===0&&!this.graphAsked&&(this.graphAsked=!0,this.graph.replace(await km().catch(()=>null)),this.changed()),this.message===null&&e>=0&&this.shownChanged()}frame(t){if(this.dropped=t.dropped,this.events.add(t.events),this.frames.keep(t),t.rows!==null){const e=t.rows.values.length/t.rows.columns,n=t.rows.from+e;this.streamed+=e,this.rows.add(t.rows),this.rows.gap>=0&&this.catchUp(n)}this.rate.note(this.streamed,performance.now()/1e3),this.player.mode==="live"&&this.show(t),this.grown()}grown(){this.events.scan(this.rows),this.player.grow(this.rows.count),this.changed()}finish(t){this.live=!1,this.endState=t}shownChanged(){const{mode:t,row:e}=this.player;this.connection.setFlow(t==="live");const n=t==="live"&&this.live&&this.message!==null;e>=0&&!n&&this.frames.want(this.rows.frame(e)),this.changed()}stored(t,e){this.trouble?.kind==="no_frames"&&(this.trouble=null);const n=this.player.mode==="live"&&(this.message?.frame??-1)>t;!n&&!e?.image&&this.pictures.dropAfter(t),e!==null&&!n&&(this.events.add(e.events),this.show(e)),this.changed()}show(t){this.message=t,this.pictures.decode(t)}lostServer(){(this.link==="ended"||this.endState!=="")&&(this.trouble={kind:"no_frames",until:0}),this.changed()}linkChanged(t,e){this.link=t,t==="waiting"&&(this.trouble={kind:"gone",until:performance.now()+1e3*e}),this.changed()}}const Do=[[68,1,84],[71,44,122],[59,81,139],[44,113,142],[33,144,141],[39,173,129],[92,200,99],[170,220,50],[253,231,37]];function La(i){const e=(i>0?Math.min(i,1):0)*(Do.length-1),n=Math.min(Math.floor(e),Do.length-2),s=e-n,r=Do[n],o=Do[n+1],a=l=>Math.round((1-s)*r[l]+s*o[l]);return[a(0),a(1),a(2)]}function oh([i,t,e]){return`rgb(${i} ${t} ${e})`}function eg(i,t=0){return Array.from({length:i},(e,n)=>oh(La(t+(1-t)*n/Math.max(1,i-1))))}function wd(){const i=new Uint8ClampedArray(1024);for(let t=0;t<256;++t)i.set([...La(t/255),255],4*t);return i}function lu(i,{near:t,far:e}){if(!(i>0))return 0;const n=Math.log(e/i)/Math.log(e/t);return Math.max(0,Math.min(1,n))}const Cr="–";function ni(i){return Number.isFinite(i)?Math.round(i).toString():Cr}function xa(i,t){if(!Number.isFinite(i))return Cr;const e=i.toFixed(t);return Number(e)===0?e.replace("-",""):e}function uo(i){if(!Number.isFinite(i))return Cr;const t=Math.abs(i);return xa(i,t>=100?0:t>=10?1:t>=.1||t===0?2:3)}function Td(i){return Number.isFinite(i)?`${xa(i*180/Math.PI,1)}°`:Cr}function tc(i){return i>=1e3?`${Number(i.toPrecision(6))/1e3} km`:`${Number(i.toPrecision(3))} m`}function ng(i){if(!Number.isFinite(i))return Cr;const t=Math.floor(i/60);return`${t}:${(i-60*t).toFixed(1).padStart(4,"0")}`}const ig=["initialising","tracking","lost"],sg=["none","novel","familiar"],rg=["stay","create","loop"];function ec(i,t){return i[t]??Cr}function og(i,t){const e=Math.max(1,Math.ceil(i/t)),n=[];for(let s=0;s<i;s+=e)n.push(s);return i>0&&n[n.length-1]!==i-1&&n.push(i-1),n}function ag(i,t,e){const n=i.slice(Math.max(0,t),e).filter(Number.isFinite).sort();if(n.length===0)return NaN;const s=n.length>>1,r=n[s];return n.length%2===1?r:(n[s-1]+r)/2}function cu(i,t){const e=Float64Array.from(i).filter(n=>Number.isFinite(n)&&n>0).sort();return e.length===0?NaN:e[Math.min(e.length-1,Math.floor(t*e.length))]}function Ua(i){const t=10**Math.floor(Math.log10(i)+1e-12),e=i/t;return t*(e>=5-1e-9?5:e>=2-1e-9?2:1)}function hu(i){const t=Ua(i);if(t>=i*(1-1e-9))return t;const e=Math.round(t/10**Math.floor(Math.log10(t)+1e-12));return t*(e===2?2.5:2)}class lg{constructor(){this.range_=null}get range(){return this.range_}clear(){this.range_=null}include(t){const e=new Float32Array(t.length/4);for(let o=0;o<e.length;++o)e[o]=t[4*o+2];const n=Ua(1/cu(e,.98)),s=hu(1/cu(e,.04));if(!Number.isFinite(n)||!Number.isFinite(s)||n>=s)return;const r=this.range_;this.range_=r?{near:Math.min(r.near,n),far:Math.max(r.far,s)}:{near:n,far:s}}ticks(){if(this.range_===null)return[];const{near:t,far:e}=this.range_,n=[];for(let s=t;s<=e*1.001;s=hu(s*1.01))n.push(s);return n}}const uu=eg(64,.12),Lo=2.4;class cg{constructor(){this.surface=new Da(Yt("camera")),this.empty=Yt("camera-empty"),this.legend=Yt("depth"),this.count=so("points"),this.note=Yt("points-note"),this.depths=new lg,this.picture=null,this.points=null}update(t){const e=t.message?.points?t.message:null;return!this.surface.fit()&&this.picture===t.picture&&this.points===e||(this.picture=t.picture,this.points=e,this.empty.hidden=t.picture!==null||e!==null,e?.points&&(this.depths.include(e.points),this.drawLegend()),this.describe(e),this.draw(t)),!1}describe(t){me(this.count,t?.points?String(t.points.length/4):"–");const e=t!==null&&t.pointsFrame!==t.frame;me(this.note,e?` of frame ${t.pointsFrame}`:"")}draw(t){const[e,n]=[t.info?.camera?.width||t.picture?.bitmap.width||0,t.info?.camera?.height||t.picture?.bitmap.height||0],s=this.surface.clear();if(e===0||n===0)return;this.surface.canvas.parentElement?.style.setProperty("--shape",String(e/n));const r=Math.min(this.surface.width/e,this.surface.height/n);s.translate((this.surface.width-e*r)/2,(this.surface.height-n*r)/2),t.picture&&(s.imageSmoothingQuality="high",s.drawImage(t.picture.bitmap,0,0,e*r,n*r)),this.drawPoints(s,r)}drawPoints(t,e){const n=this.points?.points,s=this.depths.range;if(!(!n||s===null))for(let r=0;r+3<n.length;r+=4){const o=lu(1/n[r+2],s);t.fillStyle=uu[Math.round(o*(uu.length-1))];const a=n[r]*e-Lo/2,l=n[r+1]*e-Lo/2;t.fillRect(a,l,Lo,Lo)}}drawLegend(){const t=this.depths.range;if(t===null)return;const e=`${t.near} ${t.far}`;if(this.legend.dataset.range===e)return;this.legend.dataset.range=e;const n=[1,.75,.5,.25,0].map(s=>oh(La(.12+.88*s)));this.legend.style.background=`linear-gradient(to right, ${n.join(", ")})`,this.legend.replaceChildren(...hg(this.depths.ticks()).map(s=>{const r=`left: ${(100*(1-lu(s,t))).toFixed(2)}%`;return ye("span",{style:r},tc(s))}))}}function hg(i){if(i.length<=7)return i;const t=Math.ceil((i.length-1)/6);return i.filter((e,n)=>n%t===0)}const bd=["integrator","calibration","injected","estimate"];function ug(i){const t=new Map(i.map(r=>[r.name,r])),e=[],n=[],s=pg(t);for(const r of i){if(!r.name.endsWith(".activity")||r.values.length===0)continue;const o=r.name.slice(0,-9);for(const a of fg(o,r)){const l=a.shape.length,c=dg(t,o,l),u=c.length>0?c:mg(s,l);(l===1?e:n).push({...a,bumps:u,inUnits:c.length===0})}}return{rings:e,sheets:n}}function fg(i,{shape:t,values:e}){if(t.length===1||t.length===2)return[{module:i,shape:t,activity:e}];if(t.length!==3)return[];const[n,s,r]=t,o=s*r,a=new Float32Array(n),l=new Float32Array(o);for(let c=0;c<e.length;++c){const u=e[c];a[Math.floor(c/o)]+=u,l[c%o]+=u}return[{module:`${i}, all places`,shape:[n],activity:a},{module:`${i}, all headings`,shape:[s,r],activity:l}]}function dg(i,t,e){const n=[];for(const s of bd){const r=i.get(`${t}.${s}`)?.values;if(r===void 0||r.length!==e+1)continue;const o=Array.from(r.subarray(0,e));n.push({kind:s,mean:o,precision:r[e]})}return n}function pg(i){for(const[t,e]of i)if(!(!t.endsWith(".estimate")||e.values.length!==3)&&!i.has(t.replace(/estimate$/,"activity")))return e;return null}function mg(i,t){if(i===null)return[];const[e,n,s]=i.values;return[{kind:"estimate",mean:t===1?[s]:[e,n],precision:NaN}]}class gg{constructor(){this.products=0,this.squares=0}get period(){return this.squares>0?this.products/this.squares:NaN}note({shape:t,activity:e,bumps:n,inUnits:s}){const r=n.find(l=>l.kind==="estimate");if(r===void 0||t.length!==2)return;const[o,a]=t;if(s){[this.products,this.squares]=[a,1];return}this.add(r.mean[0]??NaN,fu(e,a,l=>l%a)),this.add(r.mean[1]??NaN,fu(e,o,l=>Math.floor(l/a)))}add(t,e){!(e>.05&&e<.95)||!Number.isFinite(t)||(this.products+=t*e,this.squares+=e*e)}}function fu(i,t,e){let[n,s]=[0,0];for(let o=0;o<i.length;++o){const a=2*Math.PI*e(o)/t;n+=i[o]*Math.cos(a),s+=i[o]*Math.sin(a)}const r=Math.atan2(s,n)/(2*Math.PI);return r<0?r+1:r}function ah(i){return{integrator:i.orange,calibration:i.sky,injected:i.vermilion,estimate:i.ink}}const nc=2*Math.PI,_g={integrator:0,calibration:1,injected:2};function vg(i,t,e){const n=i.clear(),s=Math.min(i.width,i.height)/2;n.translate(i.width/2,i.height/2),n.rotate(-Math.PI/2),n.scale(1,-1);const r=s-23,o=r*.62;xg(n,t.activity,o,r),Mg(n,t,o-5,e),Sg(n,t,o-16,e),yg(i,s,e)}function xg(i,t,e,n){const s=t.reduce((o,a)=>Math.max(o,a),1e-9),r=.46*nc/t.length;for(let o=0;o<t.length;++o){const a=o*nc/t.length;i.beginPath(),i.arc(0,0,n,a-r,a+r),i.arc(0,0,e,a+r,a-r,!0),i.closePath(),i.fillStyle=oh(La(t[o]/s)),i.fill()}}function Mg(i,t,e,n){const s=t.bumps.reduce((o,a)=>a.kind==="estimate"?Math.max(o,a.precision):o,0),r=ah(n);for(const o of t.bumps){if(o.kind==="estimate"||!(o.precision>0))continue;const a=e-5*_g[o.kind],l=o.mean[0]??NaN,c=Math.min(Math.PI,1/Math.sqrt(o.precision)),u=s>0?Math.min(1,o.precision/s):1;i.beginPath(),i.arc(0,0,a,l-c,l+c),i.strokeStyle=r[o.kind],i.globalAlpha=.35+.65*u,i.lineWidth=3.5,i.lineCap="round",i.stroke(),i.globalAlpha=1}}function Sg(i,t,e,n){const s=t.bumps.find(c=>c.kind==="estimate");if(s===void 0)return;const r=t.inUnits?nc/t.activity.length:1,o=(s.mean[0]??0)*r,[a,l]=[Math.cos(o),Math.sin(o)];i.fillStyle=n.ink,i.beginPath(),i.moveTo(e*a,e*l),i.lineTo(-.16*e*a-.2*e*l,-.16*e*l+.2*e*a),i.lineTo(-.16*e*a+.2*e*l,-.16*e*l-.2*e*a),i.closePath(),i.fill()}function yg(i,t,e){const{context:n}=i,s=window.devicePixelRatio;n.setTransform(s,0,0,s,0,0),n.translate(i.width/2,i.height/2),n.fillStyle=e.soft,n.font="10px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle";const r=t-11;n.fillText("0°",0,-r),n.fillText("90°",-r,0),n.fillText("180°",0,r),n.fillText("270°",r,0)}const Eg=wd(),wg=14;function Tg({shape:i,activity:t}){const[e,n]=i,s=new ImageData(e,n),r=t.reduce((o,a)=>Math.max(o,a),1e-9);for(let o=0;o<e;++o)for(let a=0;a<n;++a){const l=Math.max(0,Math.min(1,t[o*n+a]/r)),c=4*Math.round(255*l),u=4*((n-1-a)*e+(e-1-o));for(let h=0;h<4;++h)s.data[u+h]=Eg[c+h]}return s}class bg{constructor(){this.small=document.createElement("canvas")}draw(t,e,n,s){const r=t.clear(),o=Math.min(t.width,t.height)-2*wg,a=(t.width-o)/2,l=(t.height-o)/2,c=Tg(e);[this.small.width,this.small.height]=[c.width,c.height],this.small.getContext("2d")?.putImageData(c,0,0),r.imageSmoothingEnabled=!1,r.drawImage(this.small,a,l,o,o),r.save(),r.beginPath(),r.rect(a,l,o,o),r.clip();for(const u of e.bumps)Ag(r,u,{left:a,top:l,side:o,period:n},e,s);r.restore(),Pg(r,a,l,o,s)}}function Ag(i,t,{left:e,top:n,side:s,period:r},{shape:o},a){if(!Number.isFinite(r)||t.precision<=0)return;const l=.5/o[1],c=e+s*(1-(t.mean[1]??NaN)/r-l),u=n+s*(1-(t.mean[0]??NaN)/r-l),h=Math.min(s/2,s/(r*Math.sqrt(t.precision)));for(const f of[-s,0,s])for(const p of[-s,0,s])t.kind==="estimate"?Cg(i,c+f,u+p):Rg(i,c+f,u+p,h,ah(a)[t.kind])}function Rg(i,t,e,n,s){i.beginPath(),i.arc(t,e,Math.max(3,n),0,2*Math.PI),i.strokeStyle=s,i.lineWidth=2,i.stroke()}function Cg(i,t,e){for(const[n,s]of[["#000c",3.5],["#fff",1.6]])i.beginPath(),i.moveTo(t-6,e),i.lineTo(t+6,e),i.moveTo(t,e-6),i.lineTo(t,e+6),i.strokeStyle=n,i.lineWidth=s,i.stroke()}function Pg(i,t,e,n,s){i.fillStyle=s.soft,i.font="10px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle",i.fillText("← y",t+n/2,e+n+8),i.save(),i.translate(t-8,e+n/2),i.rotate(-Math.PI/2),i.fillText("x →",0,0),i.restore()}/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const lh="180",zi={ROTATE:0,DOLLY:1,PAN:2},ls={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Dg=0,du=1,Lg=2,Ad=1,Ug=2,Oi=3,hs=0,Fn=1,Ei=2,Hi=0,mr=1,pu=2,mu=3,gu=4,Ng=5,As=100,Ig=101,Fg=102,Og=103,kg=104,Bg=200,zg=201,Hg=202,Vg=203,ic=204,sc=205,Gg=206,Wg=207,Xg=208,Yg=209,qg=210,$g=211,Kg=212,Zg=213,jg=214,rc=0,oc=1,ac=2,vr=3,lc=4,cc=5,hc=6,uc=7,Rd=0,Jg=1,Qg=2,cs=0,t_=1,e_=2,n_=3,i_=4,s_=5,r_=6,o_=7,Cd=300,xr=301,Mr=302,fc=303,dc=304,Na=306,Ma=1e3,Ds=1001,pc=1002,On=1003,a_=1004,Uo=1005,wi=1006,al=1007,Ls=1008,bi=1009,Pd=1010,Dd=1011,fo=1012,ch=1013,Ns=1014,Bi=1015,yo=1016,hh=1017,uh=1018,po=1020,Ld=35902,Ud=35899,Nd=1021,Id=1022,si=1023,mo=1026,go=1027,Fd=1028,fh=1029,Od=1030,dh=1031,ph=1033,fa=33776,da=33777,pa=33778,ma=33779,mc=35840,gc=35841,_c=35842,vc=35843,xc=36196,Mc=37492,Sc=37496,yc=37808,Ec=37809,wc=37810,Tc=37811,bc=37812,Ac=37813,Rc=37814,Cc=37815,Pc=37816,Dc=37817,Lc=37818,Uc=37819,Nc=37820,Ic=37821,Fc=36492,Oc=36494,kc=36495,Bc=36283,zc=36284,Hc=36285,Vc=36286,l_=3200,c_=3201,h_=0,u_=1,as="",Xn="srgb",Sr="srgb-linear",Sa="linear",Ae="srgb",Zs=7680,_u=519,f_=512,d_=513,p_=514,kd=515,m_=516,g_=517,__=518,v_=519,vu=35044,xu="300 es",Ti=2e3,ya=2001;class Bs{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){const n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){const n=this._listeners;if(n===void 0)return;const s=n[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){const e=this._listeners;if(e===void 0)return;const n=e[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const gn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ga=Math.PI/180,Gc=180/Math.PI;function Pr(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(gn[i&255]+gn[i>>8&255]+gn[i>>16&255]+gn[i>>24&255]+"-"+gn[t&255]+gn[t>>8&255]+"-"+gn[t>>16&15|64]+gn[t>>24&255]+"-"+gn[e&63|128]+gn[e>>8&255]+"-"+gn[e>>16&255]+gn[e>>24&255]+gn[n&255]+gn[n>>8&255]+gn[n>>16&255]+gn[n>>24&255]).toLowerCase()}function oe(i,t,e){return Math.max(t,Math.min(e,i))}function x_(i,t){return(i%t+t)%t}function ll(i,t,e){return(1-e)*i+e*t}function Gr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Un(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}const M_={DEG2RAD:ga};class Rt{constructor(t=0,e=0){Rt.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(oe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Is{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3];const f=r[o+0],p=r[o+1],_=r[o+2],x=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=p,t[e+2]=_,t[e+3]=x;return}if(h!==x||l!==f||c!==p||u!==_){let m=1-a;const d=l*f+c*p+u*_+h*x,w=d>=0?1:-1,T=1-d*d;if(T>Number.EPSILON){const U=Math.sqrt(T),D=Math.atan2(U,d*w);m=Math.sin(m*D)/U,a=Math.sin(a*D)/U}const S=a*w;if(l=l*m+f*S,c=c*m+p*S,u=u*m+_*S,h=h*m+x*S,m===1-a){const U=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=U,c*=U,u*=U,h*=U}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],p=r[o+2],_=r[o+3];return t[e]=a*_+u*h+l*p-c*f,t[e+1]=l*_+u*f+c*h-a*p,t[e+2]=c*_+u*p+a*f-l*h,t[e+3]=u*_-a*h-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),p=l(s/2),_=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"YXZ":this._x=f*u*h+c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"ZXY":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h-f*p*_;break;case"ZYX":this._x=f*u*h-c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h+f*p*_;break;case"YZX":this._x=f*u*h+c*p*_,this._y=c*p*h+f*u*_,this._z=c*u*_-f*p*h,this._w=c*u*h-f*p*_;break;case"XZY":this._x=f*u*h-c*p*_,this._y=c*p*h-f*u*_,this._z=c*u*_+f*p*h,this._w=c*u*h+f*p*_;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){const p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(u-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(n>a&&n>h){const p=2*Math.sqrt(1+n-a-h);this._w=(u-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>h){const p=2*Math.sqrt(1+a-n-h);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+u)/p}else{const p=2*Math.sqrt(1+h-n-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+u)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(oe(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const p=1-e;return this._w=p*o+e*this._w,this._x=p*n+e*this._x,this._y=p*s+e*this._y,this._z=p*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class z{constructor(t=0,e=0,n=0){z.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Mu.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Mu.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return cl.copy(this).projectOnVector(t),this.sub(cl)}reflect(t){return this.sub(cl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(oe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const cl=new z,Mu=new Is;class ie{constructor(t,e,n,s,r,o,a,l,c){ie.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],p=n[5],_=n[8],x=s[0],m=s[3],d=s[6],w=s[1],T=s[4],S=s[7],U=s[2],D=s[5],N=s[8];return r[0]=o*x+a*w+l*U,r[3]=o*m+a*T+l*D,r[6]=o*d+a*S+l*N,r[1]=c*x+u*w+h*U,r[4]=c*m+u*T+h*D,r[7]=c*d+u*S+h*N,r[2]=f*x+p*w+_*U,r[5]=f*m+p*T+_*D,r[8]=f*d+p*S+_*N,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,p=c*r-o*l,_=e*h+n*f+s*p;if(_===0)return this.set(0,0,0,0,0,0,0,0,0);const x=1/_;return t[0]=h*x,t[1]=(s*c-u*n)*x,t[2]=(a*n-s*o)*x,t[3]=f*x,t[4]=(u*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(n*l-c*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(hl.makeScale(t,e)),this}rotate(t){return this.premultiply(hl.makeRotation(-t)),this}translate(t,e){return this.premultiply(hl.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const hl=new ie;function Bd(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Ea(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function S_(){const i=Ea("canvas");return i.style.display="block",i}const Su={};function _o(i){i in Su||(Su[i]=!0,console.warn(i))}function y_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}const yu=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Eu=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function E_(){const i={enabled:!0,workingColorSpace:Sr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=Vi(s.r),s.g=Vi(s.g),s.b=Vi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=gr(s.r),s.g=gr(s.g),s.b=gr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===as?Sa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return _o("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return _o("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[Sr]:{primaries:t,whitePoint:n,transfer:Sa,toXYZ:yu,fromXYZ:Eu,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Xn},outputColorSpaceConfig:{drawingBufferColorSpace:Xn}},[Xn]:{primaries:t,whitePoint:n,transfer:Ae,toXYZ:yu,fromXYZ:Eu,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Xn}}}),i}const pe=E_();function Vi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function gr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let js;class w_{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{js===void 0&&(js=Ea("canvas")),js.width=t.width,js.height=t.height;const s=js.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=js}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Ea("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Vi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Vi(e[n]/255)*255):e[n]=Vi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let T_=0;class mh{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:T_++}),this.uuid=Pr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){const e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(ul(s[o].image)):r.push(ul(s[o]))}else r=ul(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function ul(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?w_.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let b_=0;const fl=new z;class xn extends Bs{constructor(t=xn.DEFAULT_IMAGE,e=xn.DEFAULT_MAPPING,n=Ds,s=Ds,r=wi,o=Ls,a=si,l=bi,c=xn.DEFAULT_ANISOTROPY,u=as){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:b_++}),this.uuid=Pr(),this.name="",this.source=new mh(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Rt(0,0),this.repeat=new Rt(1,1),this.center=new Rt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(fl).x}get height(){return this.source.getSize(fl).y}get depth(){return this.source.getSize(fl).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Cd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Ma:t.x=t.x-Math.floor(t.x);break;case Ds:t.x=t.x<0?0:1;break;case pc:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Ma:t.y=t.y-Math.floor(t.y);break;case Ds:t.y=t.y<0?0:1;break;case pc:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}xn.DEFAULT_IMAGE=null;xn.DEFAULT_MAPPING=Cd;xn.DEFAULT_ANISOTROPY=1;class Ye{constructor(t=0,e=0,n=0,s=1){Ye.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],p=l[5],_=l[9],x=l[2],m=l[6],d=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-x)<.01&&Math.abs(_-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+x)<.1&&Math.abs(_+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,S=(p+1)/2,U=(d+1)/2,D=(u+f)/4,N=(h+x)/4,k=(_+m)/4;return T>S&&T>U?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=D/n,r=N/n):S>U?S<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),n=D/s,r=k/s):U<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),n=N/r,s=k/r),this.set(n,s,r,e),this}let w=Math.sqrt((m-_)*(m-_)+(h-x)*(h-x)+(f-u)*(f-u));return Math.abs(w)<.001&&(w=1),this.x=(m-_)/w,this.y=(h-x)/w,this.z=(f-u)/w,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this.w=oe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this.w=oe(this.w,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class A_ extends Bs{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:wi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e);const s={width:t,height:e,depth:n.depth},r=new xn(s);this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){const e={minFilter:wi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;const s=Object.assign({},t.textures[e].image);this.textures[e].source=new mh(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Fs extends A_{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class zd extends xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=Ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class R_ extends xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=On,this.minFilter=On,this.wrapR=Ds,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Dr{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(li.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(li.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=li.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,li):li.fromBufferAttribute(r,o),li.applyMatrix4(t.matrixWorld),this.expandByPoint(li);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),No.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),No.copy(n.boundingBox)),No.applyMatrix4(t.matrixWorld),this.union(No)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,li),li.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Wr),Io.subVectors(this.max,Wr),Js.subVectors(t.a,Wr),Qs.subVectors(t.b,Wr),tr.subVectors(t.c,Wr),Qi.subVectors(Qs,Js),ts.subVectors(tr,Qs),vs.subVectors(Js,tr);let e=[0,-Qi.z,Qi.y,0,-ts.z,ts.y,0,-vs.z,vs.y,Qi.z,0,-Qi.x,ts.z,0,-ts.x,vs.z,0,-vs.x,-Qi.y,Qi.x,0,-ts.y,ts.x,0,-vs.y,vs.x,0];return!dl(e,Js,Qs,tr,Io)||(e=[1,0,0,0,1,0,0,0,1],!dl(e,Js,Qs,tr,Io))?!1:(Fo.crossVectors(Qi,ts),e=[Fo.x,Fo.y,Fo.z],dl(e,Js,Qs,tr,Io))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,li).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(li).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Di[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Di[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Di[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Di[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Di[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Di[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Di[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Di[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Di),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}}const Di=[new z,new z,new z,new z,new z,new z,new z,new z],li=new z,No=new Dr,Js=new z,Qs=new z,tr=new z,Qi=new z,ts=new z,vs=new z,Wr=new z,Io=new z,Fo=new z,xs=new z;function dl(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){xs.fromArray(i,r);const a=s.x*Math.abs(xs.x)+s.y*Math.abs(xs.y)+s.z*Math.abs(xs.z),l=t.dot(xs),c=e.dot(xs),u=n.dot(xs);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const C_=new Dr,Xr=new z,pl=new z;class Eo{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):C_.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Xr.subVectors(t,this.center);const e=Xr.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Xr,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(pl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Xr.copy(t.center).add(pl)),this.expandByPoint(Xr.copy(t.center).sub(pl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}}const Li=new z,ml=new z,Oo=new z,es=new z,gl=new z,ko=new z,_l=new z;class Ia{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Li)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Li.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Li.copy(this.origin).addScaledVector(this.direction,e),Li.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){ml.copy(t).add(e).multiplyScalar(.5),Oo.copy(e).sub(t).normalize(),es.copy(this.origin).sub(ml);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Oo),a=es.dot(this.direction),l=-es.dot(Oo),c=es.lengthSq(),u=Math.abs(1-o*o);let h,f,p,_;if(u>0)if(h=o*l-a,f=o*a-l,_=r*u,h>=0)if(f>=-_)if(f<=_){const x=1/u;h*=x,f*=x,p=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;else f<=-_?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c):f<=_?(h=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),p=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),p=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(ml).addScaledVector(Oo,f),p}intersectSphere(t,e){Li.subVectors(t.center,this.origin);const n=Li.dot(this.direction),s=Li.dot(Li)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Li)!==null}intersectTriangle(t,e,n,s,r){gl.subVectors(e,t),ko.subVectors(n,t),_l.crossVectors(gl,ko);let o=this.direction.dot(_l),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;es.subVectors(this.origin,t);const l=a*this.direction.dot(ko.crossVectors(es,ko));if(l<0)return null;const c=a*this.direction.dot(gl.cross(es));if(c<0||l+c>o)return null;const u=-a*es.dot(_l);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Xe{constructor(t,e,n,s,r,o,a,l,c,u,h,f,p,_,x,m){Xe.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,p,_,x,m)}set(t,e,n,s,r,o,a,l,c,u,h,f,p,_,x,m){const d=this.elements;return d[0]=t,d[4]=e,d[8]=n,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=u,d[10]=h,d[14]=f,d[3]=p,d[7]=_,d[11]=x,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Xe().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/er.setFromMatrixColumn(t,0).length(),r=1/er.setFromMatrixColumn(t,1).length(),o=1/er.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,p=o*h,_=a*u,x=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=p+_*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=_+p*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,p=l*h,_=c*u,x=c*h;e[0]=f+x*a,e[4]=_*a-p,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=p*a-_,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,p=l*h,_=c*u,x=c*h;e[0]=f-x*a,e[4]=-o*h,e[8]=_+p*a,e[1]=p+_*a,e[5]=o*u,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,p=o*h,_=a*u,x=a*h;e[0]=l*u,e[4]=_*c-p,e[8]=f*c+x,e[1]=l*h,e[5]=x*c+f,e[9]=p*c-_,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,p=o*c,_=a*l,x=a*c;e[0]=l*u,e[4]=x-f*h,e[8]=_*h+p,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=p*h+_,e[10]=f-x*h}else if(t.order==="XZY"){const f=o*l,p=o*c,_=a*l,x=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+x,e[5]=o*u,e[9]=p*h-_,e[2]=_*h-p,e[6]=a*u,e[10]=x*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(P_,t,D_)}lookAt(t,e,n){const s=this.elements;return Vn.subVectors(t,e),Vn.lengthSq()===0&&(Vn.z=1),Vn.normalize(),ns.crossVectors(n,Vn),ns.lengthSq()===0&&(Math.abs(n.z)===1?Vn.x+=1e-4:Vn.z+=1e-4,Vn.normalize(),ns.crossVectors(n,Vn)),ns.normalize(),Bo.crossVectors(Vn,ns),s[0]=ns.x,s[4]=Bo.x,s[8]=Vn.x,s[1]=ns.y,s[5]=Bo.y,s[9]=Vn.y,s[2]=ns.z,s[6]=Bo.z,s[10]=Vn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],p=n[13],_=n[2],x=n[6],m=n[10],d=n[14],w=n[3],T=n[7],S=n[11],U=n[15],D=s[0],N=s[4],k=s[8],b=s[12],E=s[1],C=s[5],G=s[9],H=s[13],$=s[2],W=s[6],j=s[10],Y=s[14],J=s[3],ot=s[7],at=s[11],_t=s[15];return r[0]=o*D+a*E+l*$+c*J,r[4]=o*N+a*C+l*W+c*ot,r[8]=o*k+a*G+l*j+c*at,r[12]=o*b+a*H+l*Y+c*_t,r[1]=u*D+h*E+f*$+p*J,r[5]=u*N+h*C+f*W+p*ot,r[9]=u*k+h*G+f*j+p*at,r[13]=u*b+h*H+f*Y+p*_t,r[2]=_*D+x*E+m*$+d*J,r[6]=_*N+x*C+m*W+d*ot,r[10]=_*k+x*G+m*j+d*at,r[14]=_*b+x*H+m*Y+d*_t,r[3]=w*D+T*E+S*$+U*J,r[7]=w*N+T*C+S*W+U*ot,r[11]=w*k+T*G+S*j+U*at,r[15]=w*b+T*H+S*Y+U*_t,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],p=t[14],_=t[3],x=t[7],m=t[11],d=t[15];return _*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*p-n*l*p)+x*(+e*l*p-e*c*f+r*o*f-s*o*p+s*c*u-r*l*u)+m*(+e*c*h-e*a*p-r*o*h+n*o*p+r*a*u-n*c*u)+d*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],p=t[11],_=t[12],x=t[13],m=t[14],d=t[15],w=h*m*c-x*f*c+x*l*p-a*m*p-h*l*d+a*f*d,T=_*f*c-u*m*c-_*l*p+o*m*p+u*l*d-o*f*d,S=u*x*c-_*h*c+_*a*p-o*x*p-u*a*d+o*h*d,U=_*h*l-u*x*l-_*a*f+o*x*f+u*a*m-o*h*m,D=e*w+n*T+s*S+r*U;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const N=1/D;return t[0]=w*N,t[1]=(x*f*r-h*m*r-x*s*p+n*m*p+h*s*d-n*f*d)*N,t[2]=(a*m*r-x*l*r+x*s*c-n*m*c-a*s*d+n*l*d)*N,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*p-n*l*p)*N,t[4]=T*N,t[5]=(u*m*r-_*f*r+_*s*p-e*m*p-u*s*d+e*f*d)*N,t[6]=(_*l*r-o*m*r-_*s*c+e*m*c+o*s*d-e*l*d)*N,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*p+e*l*p)*N,t[8]=S*N,t[9]=(_*h*r-u*x*r-_*n*p+e*x*p+u*n*d-e*h*d)*N,t[10]=(o*x*r-_*a*r+_*n*c-e*x*c-o*n*d+e*a*d)*N,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*p-e*a*p)*N,t[12]=U*N,t[13]=(u*x*s-_*h*s+_*n*f-e*x*f-u*n*m+e*h*m)*N,t[14]=(_*a*s-o*x*s-_*n*l+e*x*l+o*n*m-e*a*m)*N,t[15]=(o*h*s-u*a*s+u*n*l-e*h*l-o*n*f+e*a*f)*N,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,p=r*u,_=r*h,x=o*u,m=o*h,d=a*h,w=l*c,T=l*u,S=l*h,U=n.x,D=n.y,N=n.z;return s[0]=(1-(x+d))*U,s[1]=(p+S)*U,s[2]=(_-T)*U,s[3]=0,s[4]=(p-S)*D,s[5]=(1-(f+d))*D,s[6]=(m+w)*D,s[7]=0,s[8]=(_+T)*N,s[9]=(m-w)*N,s[10]=(1-(f+x))*N,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let r=er.set(s[0],s[1],s[2]).length();const o=er.set(s[4],s[5],s[6]).length(),a=er.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],ci.copy(this);const c=1/r,u=1/o,h=1/a;return ci.elements[0]*=c,ci.elements[1]*=c,ci.elements[2]*=c,ci.elements[4]*=u,ci.elements[5]*=u,ci.elements[6]*=u,ci.elements[8]*=h,ci.elements[9]*=h,ci.elements[10]*=h,e.setFromRotationMatrix(ci),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ti,l=!1){const c=this.elements,u=2*r/(e-t),h=2*r/(n-s),f=(e+t)/(e-t),p=(n+s)/(n-s);let _,x;if(l)_=r/(o-r),x=o*r/(o-r);else if(a===Ti)_=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ya)_=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ti,l=!1){const c=this.elements,u=2/(e-t),h=2/(n-s),f=-(e+t)/(e-t),p=-(n+s)/(n-s);let _,x;if(l)_=1/(o-r),x=o/(o-r);else if(a===Ti)_=-2/(o-r),x=-(o+r)/(o-r);else if(a===ya)_=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=_,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const er=new z,ci=new Xe,P_=new z(0,0,0),D_=new z(1,1,1),ns=new z,Bo=new z,Vn=new z,wu=new Xe,Tu=new Is;class Xi{constructor(t=0,e=0,n=0,s=Xi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(oe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-oe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(oe(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-oe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(oe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-oe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,p),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return wu.makeRotationFromQuaternion(t),this.setFromRotationMatrix(wu,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Tu.setFromEuler(this),this.setFromQuaternion(Tu,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Xi.DEFAULT_ORDER="XYZ";class Hd{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let L_=0;const bu=new z,nr=new Is,Ui=new Xe,zo=new z,Yr=new z,U_=new z,N_=new Is,Au=new z(1,0,0),Ru=new z(0,1,0),Cu=new z(0,0,1),Pu={type:"added"},I_={type:"removed"},ir={type:"childadded",child:null},vl={type:"childremoved",child:null};class Rn extends Bs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:L_++}),this.uuid=Pr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Rn.DEFAULT_UP.clone();const t=new z,e=new Xi,n=new Is,s=new z(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new ie}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=Rn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Hd,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return nr.setFromAxisAngle(t,e),this.quaternion.multiply(nr),this}rotateOnWorldAxis(t,e){return nr.setFromAxisAngle(t,e),this.quaternion.premultiply(nr),this}rotateX(t){return this.rotateOnAxis(Au,t)}rotateY(t){return this.rotateOnAxis(Ru,t)}rotateZ(t){return this.rotateOnAxis(Cu,t)}translateOnAxis(t,e){return bu.copy(t).applyQuaternion(this.quaternion),this.position.add(bu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Au,t)}translateY(t){return this.translateOnAxis(Ru,t)}translateZ(t){return this.translateOnAxis(Cu,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ui.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?zo.copy(t):zo.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),Yr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ui.lookAt(Yr,zo,this.up):Ui.lookAt(zo,Yr,this.up),this.quaternion.setFromRotationMatrix(Ui),s&&(Ui.extractRotation(s.matrixWorld),nr.setFromRotationMatrix(Ui),this.quaternion.premultiply(nr.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Pu),ir.child=t,this.dispatchEvent(ir),ir.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(I_),vl.child=t,this.dispatchEvent(vl),vl.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ui.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ui.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ui),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Pu),ir.child=t,this.dispatchEvent(ir),ir.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yr,t,U_),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Yr,N_,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),p=o(t.animations),_=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),p.length>0&&(n.animations=p),_.length>0&&(n.nodes=_)}return n.object=s,n;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}Rn.DEFAULT_UP=new z(0,1,0);Rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const hi=new z,Ni=new z,xl=new z,Ii=new z,sr=new z,rr=new z,Du=new z,Ml=new z,Sl=new z,yl=new z,El=new Ye,wl=new Ye,Tl=new Ye;class di{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),hi.subVectors(t,e),s.cross(hi);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){hi.subVectors(s,e),Ni.subVectors(n,e),xl.subVectors(t,e);const o=hi.dot(hi),a=hi.dot(Ni),l=hi.dot(xl),c=Ni.dot(Ni),u=Ni.dot(xl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,p=(c*l-a*u)*f,_=(o*u-a*l)*f;return r.set(1-p-_,_,p)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Ii)===null?!1:Ii.x>=0&&Ii.y>=0&&Ii.x+Ii.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Ii)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ii.x),l.addScaledVector(o,Ii.y),l.addScaledVector(a,Ii.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return El.setScalar(0),wl.setScalar(0),Tl.setScalar(0),El.fromBufferAttribute(t,e),wl.fromBufferAttribute(t,n),Tl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(El,r.x),o.addScaledVector(wl,r.y),o.addScaledVector(Tl,r.z),o}static isFrontFacing(t,e,n,s){return hi.subVectors(n,e),Ni.subVectors(t,e),hi.cross(Ni).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return hi.subVectors(this.c,this.b),Ni.subVectors(this.a,this.b),hi.cross(Ni).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return di.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return di.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return di.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return di.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return di.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;sr.subVectors(s,n),rr.subVectors(r,n),Ml.subVectors(t,n);const l=sr.dot(Ml),c=rr.dot(Ml);if(l<=0&&c<=0)return e.copy(n);Sl.subVectors(t,s);const u=sr.dot(Sl),h=rr.dot(Sl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(sr,o);yl.subVectors(t,r);const p=sr.dot(yl),_=rr.dot(yl);if(_>=0&&p<=_)return e.copy(r);const x=p*c-l*_;if(x<=0&&c>=0&&_<=0)return a=c/(c-_),e.copy(n).addScaledVector(rr,a);const m=u*_-p*h;if(m<=0&&h-u>=0&&p-_>=0)return Du.subVectors(r,s),a=(h-u)/(h-u+(p-_)),e.copy(s).addScaledVector(Du,a);const d=1/(m+x+f);return o=x*d,a=f*d,e.copy(n).addScaledVector(sr,o).addScaledVector(rr,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const Vd={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},is={h:0,s:0,l:0},Ho={h:0,s:0,l:0};function bl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class Me{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Xn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,pe.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=pe.workingColorSpace){return this.r=t,this.g=e,this.b=n,pe.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=pe.workingColorSpace){if(t=x_(t,1),e=oe(e,0,1),n=oe(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=bl(o,r,t+1/3),this.g=bl(o,r,t),this.b=bl(o,r,t-1/3)}return pe.colorSpaceToWorking(this,s),this}setStyle(t,e=Xn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Xn){const n=Vd[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Vi(t.r),this.g=Vi(t.g),this.b=Vi(t.b),this}copyLinearToSRGB(t){return this.r=gr(t.r),this.g=gr(t.g),this.b=gr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Xn){return pe.workingToColorSpace(_n.copy(this),t),Math.round(oe(_n.r*255,0,255))*65536+Math.round(oe(_n.g*255,0,255))*256+Math.round(oe(_n.b*255,0,255))}getHexString(t=Xn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=pe.workingColorSpace){pe.workingToColorSpace(_n.copy(this),e);const n=_n.r,s=_n.g,r=_n.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=pe.workingColorSpace){return pe.workingToColorSpace(_n.copy(this),e),t.r=_n.r,t.g=_n.g,t.b=_n.b,t}getStyle(t=Xn){pe.workingToColorSpace(_n.copy(this),t);const e=_n.r,n=_n.g,s=_n.b;return t!==Xn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(is),this.setHSL(is.h+t,is.s+e,is.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(is),t.getHSL(Ho);const n=ll(is.h,Ho.h,e),s=ll(is.s,Ho.s,e),r=ll(is.l,Ho.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const _n=new Me;Me.NAMES=Vd;let F_=0;class Lr extends Bs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:F_++}),this.uuid=Pr(),this.name="",this.type="Material",this.blending=mr,this.side=hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ic,this.blendDst=sc,this.blendEquation=As,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Me(0,0,0),this.blendAlpha=0,this.depthFunc=vr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=_u,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Zs,this.stencilZFail=Zs,this.stencilZPass=Zs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==mr&&(n.blending=this.blending),this.side!==hs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==ic&&(n.blendSrc=this.blendSrc),this.blendDst!==sc&&(n.blendDst=this.blendDst),this.blendEquation!==As&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==vr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==_u&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Zs&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Zs&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Zs&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}}class yr extends Lr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Me(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Xi,this.combine=Rd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const $e=new z,Vo=new Rt;let O_=0;class vn{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:O_++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=vu,this.updateRanges=[],this.gpuType=Bi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Vo.fromBufferAttribute(this,e),Vo.applyMatrix3(t),this.setXY(e,Vo.x,Vo.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix3(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix4(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyNormalMatrix(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.transformDirection(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Gr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Un(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Gr(e,this.array)),e}setX(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Gr(e,this.array)),e}setY(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Gr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Gr(e,this.array)),e}setW(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array),r=Un(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==vu&&(t.usage=this.usage),t}}class Gd extends vn{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class Wd extends vn{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class Cn extends vn{constructor(t,e,n){super(new Float32Array(t),e,n)}}let k_=0;const Qn=new Xe,Al=new Rn,or=new z,Gn=new Dr,qr=new Dr,un=new z;class Pn extends Bs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:k_++}),this.uuid=Pr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Bd(t)?Wd:Gd)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new ie().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return Qn.makeRotationFromQuaternion(t),this.applyMatrix4(Qn),this}rotateX(t){return Qn.makeRotationX(t),this.applyMatrix4(Qn),this}rotateY(t){return Qn.makeRotationY(t),this.applyMatrix4(Qn),this}rotateZ(t){return Qn.makeRotationZ(t),this.applyMatrix4(Qn),this}translate(t,e,n){return Qn.makeTranslation(t,e,n),this.applyMatrix4(Qn),this}scale(t,e,n){return Qn.makeScale(t,e,n),this.applyMatrix4(Qn),this}lookAt(t){return Al.lookAt(t),Al.updateMatrix(),this.applyMatrix4(Al.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(or).negate(),this.translate(or.x,or.y,or.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(n,3))}else{const n=Math.min(t.length,e.count);for(let s=0;s<n;s++){const r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Dr);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];Gn.setFromBufferAttribute(r),this.morphTargetsRelative?(un.addVectors(this.boundingBox.min,Gn.min),this.boundingBox.expandByPoint(un),un.addVectors(this.boundingBox.max,Gn.max),this.boundingBox.expandByPoint(un)):(this.boundingBox.expandByPoint(Gn.min),this.boundingBox.expandByPoint(Gn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Eo);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){const n=this.boundingSphere.center;if(Gn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];qr.setFromBufferAttribute(a),this.morphTargetsRelative?(un.addVectors(Gn.min,qr.min),Gn.expandByPoint(un),un.addVectors(Gn.max,qr.max),Gn.expandByPoint(un)):(Gn.expandByPoint(qr.min),Gn.expandByPoint(qr.max))}Gn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)un.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(un));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)un.fromBufferAttribute(a,c),l&&(or.fromBufferAttribute(t,c),un.add(or)),s=Math.max(s,n.distanceToSquared(un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new vn(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let k=0;k<n.count;k++)a[k]=new z,l[k]=new z;const c=new z,u=new z,h=new z,f=new Rt,p=new Rt,_=new Rt,x=new z,m=new z;function d(k,b,E){c.fromBufferAttribute(n,k),u.fromBufferAttribute(n,b),h.fromBufferAttribute(n,E),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,b),_.fromBufferAttribute(r,E),u.sub(c),h.sub(c),p.sub(f),_.sub(f);const C=1/(p.x*_.y-_.x*p.y);isFinite(C)&&(x.copy(u).multiplyScalar(_.y).addScaledVector(h,-p.y).multiplyScalar(C),m.copy(h).multiplyScalar(p.x).addScaledVector(u,-_.x).multiplyScalar(C),a[k].add(x),a[b].add(x),a[E].add(x),l[k].add(m),l[b].add(m),l[E].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let k=0,b=w.length;k<b;++k){const E=w[k],C=E.start,G=E.count;for(let H=C,$=C+G;H<$;H+=3)d(t.getX(H+0),t.getX(H+1),t.getX(H+2))}const T=new z,S=new z,U=new z,D=new z;function N(k){U.fromBufferAttribute(s,k),D.copy(U);const b=a[k];T.copy(b),T.sub(U.multiplyScalar(U.dot(b))).normalize(),S.crossVectors(D,b);const C=S.dot(l[k])<0?-1:1;o.setXYZW(k,T.x,T.y,T.z,C)}for(let k=0,b=w.length;k<b;++k){const E=w[k],C=E.start,G=E.count;for(let H=C,$=C+G;H<$;H+=3)N(t.getX(H+0)),N(t.getX(H+1)),N(t.getX(H+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new vn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,p=n.count;f<p;f++)n.setXYZ(f,0,0,0);const s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,p=t.count;f<p;f+=3){const _=t.getX(f+0),x=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,_),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,_),l.fromBufferAttribute(n,x),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(_,a.x,a.y,a.z),n.setXYZ(x,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)un.fromBufferAttribute(t,e),un.normalize(),t.setXYZ(e,un.x,un.y,un.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let p=0,_=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*u;for(let d=0;d<u;d++)f[_++]=c[p++]}return new vn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new Pn,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],p=t(f,n);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const p=c[h];u.push(p.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone());const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,p=h.length;f<p;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Lu=new Xe,Ms=new Ia,Go=new Eo,Uu=new z,Wo=new z,Xo=new z,Yo=new z,Rl=new z,qo=new z,Nu=new z,$o=new z;class qn extends Rn{constructor(t=new Pn,e=new yr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){qo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Rl.fromBufferAttribute(h,t),o?qo.addScaledVector(Rl,u):qo.addScaledVector(Rl.sub(e),u))}e.add(qo)}return e}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Go.copy(n.boundingSphere),Go.applyMatrix4(r),Ms.copy(t.ray).recast(t.near),!(Go.containsPoint(Ms.origin)===!1&&(Ms.intersectSphere(Go,Uu)===null||Ms.origin.distanceToSquared(Uu)>(t.far-t.near)**2))&&(Lu.copy(r).invert(),Ms.copy(t.ray).applyMatrix4(Lu),!(n.boundingBox!==null&&Ms.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ms)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const m=f[_],d=o[m.materialIndex],w=Math.max(m.start,p.start),T=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let S=w,U=T;S<U;S+=3){const D=a.getX(S),N=a.getX(S+1),k=a.getX(S+2);s=Ko(this,d,t,n,c,u,h,D,N,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let m=_,d=x;m<d;m+=3){const w=a.getX(m),T=a.getX(m+1),S=a.getX(m+2);s=Ko(this,o,t,n,c,u,h,w,T,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let _=0,x=f.length;_<x;_++){const m=f[_],d=o[m.materialIndex],w=Math.max(m.start,p.start),T=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let S=w,U=T;S<U;S+=3){const D=S,N=S+1,k=S+2;s=Ko(this,d,t,n,c,u,h,D,N,k),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const _=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let m=_,d=x;m<d;m+=3){const w=m,T=m+1,S=m+2;s=Ko(this,o,t,n,c,u,h,w,T,S),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function B_(i,t,e,n,s,r,o,a){let l;if(t.side===Fn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===hs,a),l===null)return null;$o.copy(a),$o.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo($o);return c<e.near||c>e.far?null:{distance:c,point:$o.clone(),object:i}}function Ko(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,Wo),i.getVertexPosition(l,Xo),i.getVertexPosition(c,Yo);const u=B_(i,t,e,n,Wo,Xo,Yo,Nu);if(u){const h=new z;di.getBarycoord(Nu,Wo,Xo,Yo,h),s&&(u.uv=di.getInterpolatedAttribute(s,a,l,c,h,new Rt)),r&&(u.uv1=di.getInterpolatedAttribute(r,a,l,c,h,new Rt)),o&&(u.normal=di.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new z,materialIndex:0};di.getNormal(Wo,Xo,Yo,f.normal),u.face=f,u.barycoord=h}return u}class wo extends Pn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,p=0;_("z","y","x",-1,-1,n,e,t,o,r,0),_("z","y","x",1,-1,n,e,-t,o,r,1),_("x","z","y",1,1,t,n,e,s,o,2),_("x","z","y",1,-1,t,n,-e,s,o,3),_("x","y","z",1,-1,t,e,n,s,r,4),_("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(u,3)),this.setAttribute("uv",new Cn(h,2));function _(x,m,d,w,T,S,U,D,N,k,b){const E=S/N,C=U/k,G=S/2,H=U/2,$=D/2,W=N+1,j=k+1;let Y=0,J=0;const ot=new z;for(let at=0;at<j;at++){const _t=at*C-H;for(let Mt=0;Mt<W;Mt++){const gt=Mt*E-G;ot[x]=gt*w,ot[m]=_t*T,ot[d]=$,c.push(ot.x,ot.y,ot.z),ot[x]=0,ot[m]=0,ot[d]=D>0?1:-1,u.push(ot.x,ot.y,ot.z),h.push(Mt/N),h.push(1-at/k),Y+=1}}for(let at=0;at<k;at++)for(let _t=0;_t<N;_t++){const Mt=f+_t+W*at,gt=f+_t+W*(at+1),ee=f+(_t+1)+W*(at+1),jt=f+(_t+1)+W*at;l.push(Mt,gt,jt),l.push(gt,ee,jt),J+=6}a.addGroup(p,J,b),p+=J,f+=Y}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new wo(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function Er(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function bn(i){const t={};for(let e=0;e<i.length;e++){const n=Er(i[e]);for(const s in n)t[s]=n[s]}return t}function z_(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function Xd(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:pe.workingColorSpace}const H_={clone:Er,merge:bn};var V_=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,G_=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class Yi extends Lr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=V_,this.fragmentShader=G_,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Er(t.uniforms),this.uniformsGroups=z_(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class Yd extends Rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=Ti,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const ss=new z,Iu=new Rt,Fu=new Rt;class Yn extends Yd{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Gc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(ga*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Gc*2*Math.atan(Math.tan(ga*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){ss.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(ss.x,ss.y).multiplyScalar(-t/ss.z),ss.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(ss.x,ss.y).multiplyScalar(-t/ss.z)}getViewSize(t,e){return this.getViewBounds(t,Iu,Fu),e.subVectors(Fu,Iu)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(ga*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const ar=-90,lr=1;class W_ extends Rn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Yn(ar,lr,t,e);s.layers=this.layers,this.add(s);const r=new Yn(ar,lr,t,e);r.layers=this.layers,this.add(r);const o=new Yn(ar,lr,t,e);o.layers=this.layers,this.add(o);const a=new Yn(ar,lr,t,e);a.layers=this.layers,this.add(a);const l=new Yn(ar,lr,t,e);l.layers=this.layers,this.add(l);const c=new Yn(ar,lr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Ti)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ya)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),_=t.xr.enabled;t.xr.enabled=!1;const x=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=x,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,p),t.xr.enabled=_,n.texture.needsPMREMUpdate=!0}}class qd extends xn{constructor(t=[],e=xr,n,s,r,o,a,l,c,u){super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class X_ extends Fs{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new qd(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new wo(5,5,5),r=new Yi({name:"CubemapFromEquirect",uniforms:Er(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Fn,blending:Hi});r.uniforms.tEquirect.value=e;const o=new qn(s,r),a=e.minFilter;return e.minFilter===Ls&&(e.minFilter=wi),new W_(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}class fr extends Rn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const Y_={type:"move"};class Cl{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new fr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new fr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new fr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const x of t.hand.values()){const m=e.getJointPose(x,n),d=this._getHandJoint(c,x);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.rotation,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),p=.02,_=.005;c.inputState.pinching&&f>p+_?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-_&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Y_)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new fr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}class $d extends Rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Xi,this.environmentIntensity=1,this.environmentRotation=new Xi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}}class q_ extends xn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=On,u=On,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const Pl=new z,$_=new z,K_=new ie;class rs{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Pl.subVectors(n,e).cross($_.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Pl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||K_.getNormalMatrix(t),s=this.coplanarPoint(Pl).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Ss=new Eo,Z_=new Rt(.5,.5),Zo=new z;class Kd{constructor(t=new rs,e=new rs,n=new rs,s=new rs,r=new rs,o=new rs){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ti,n=!1){const s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],p=r[7],_=r[8],x=r[9],m=r[10],d=r[11],w=r[12],T=r[13],S=r[14],U=r[15];if(s[0].setComponents(c-o,p-u,d-_,U-w).normalize(),s[1].setComponents(c+o,p+u,d+_,U+w).normalize(),s[2].setComponents(c+a,p+h,d+x,U+T).normalize(),s[3].setComponents(c-a,p-h,d-x,U-T).normalize(),n)s[4].setComponents(l,f,m,S).normalize(),s[5].setComponents(c-l,p-f,d-m,U-S).normalize();else if(s[4].setComponents(c-l,p-f,d-m,U-S).normalize(),e===Ti)s[5].setComponents(c+l,p+f,d+m,U+S).normalize();else if(e===ya)s[5].setComponents(l,f,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ss.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ss.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ss)}intersectsSprite(t){Ss.center.set(0,0,0);const e=Z_.distanceTo(t.center);return Ss.radius=.7071067811865476+e,Ss.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ss)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(Zo.x=s.normal.x>0?t.max.x:t.min.x,Zo.y=s.normal.y>0?t.max.y:t.min.y,Zo.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Zo)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class Zd extends Lr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Me(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const wa=new z,Ta=new z,Ou=new Xe,$r=new Ia,jo=new Eo,Dl=new z,ku=new z;class j_ extends Rn{constructor(t=new Pn,e=new Zd){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)wa.fromBufferAttribute(e,s-1),Ta.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=wa.distanceTo(Ta);t.setAttribute("lineDistance",new Cn(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),jo.copy(n.boundingSphere),jo.applyMatrix4(s),jo.radius+=r,t.ray.intersectsSphere(jo)===!1)return;Ou.copy(s).invert(),$r.copy(t.ray).applyMatrix4(Ou);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){const p=Math.max(0,o.start),_=Math.min(u.count,o.start+o.count);for(let x=p,m=_-1;x<m;x+=c){const d=u.getX(x),w=u.getX(x+1),T=Jo(this,t,$r,l,d,w,x);T&&e.push(T)}if(this.isLineLoop){const x=u.getX(_-1),m=u.getX(p),d=Jo(this,t,$r,l,x,m,_-1);d&&e.push(d)}}else{const p=Math.max(0,o.start),_=Math.min(f.count,o.start+o.count);for(let x=p,m=_-1;x<m;x+=c){const d=Jo(this,t,$r,l,x,x+1,x);d&&e.push(d)}if(this.isLineLoop){const x=Jo(this,t,$r,l,_-1,p,_-1);x&&e.push(x)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Jo(i,t,e,n,s,r,o){const a=i.geometry.attributes.position;if(wa.fromBufferAttribute(a,s),Ta.fromBufferAttribute(a,r),e.distanceSqToSegment(wa,Ta,Dl,ku)>n)return;Dl.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(Dl);if(!(c<t.near||c>t.far))return{distance:c,point:ku.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}const Bu=new z,zu=new z;class J_ extends j_{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Bu.fromBufferAttribute(e,s),zu.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Bu.distanceTo(zu);t.setAttribute("lineDistance",new Cn(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class jd extends Lr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new Me(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const Hu=new Xe,Wc=new Ia,Qo=new Eo,ta=new z;class Q_ extends Rn{constructor(t=new Pn,e=new jd){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Qo.copy(n.boundingSphere),Qo.applyMatrix4(s),Qo.radius+=r,t.ray.intersectsSphere(Qo)===!1)return;Hu.copy(s).invert(),Wc.copy(t.ray).applyMatrix4(Hu);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){const f=Math.max(0,o.start),p=Math.min(c.count,o.start+o.count);for(let _=f,x=p;_<x;_++){const m=c.getX(_);ta.fromBufferAttribute(h,m),Vu(ta,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let _=f,x=p;_<x;_++)ta.fromBufferAttribute(h,_),Vu(ta,_,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function Vu(i,t,e,n,s,r,o){const a=Wc.distanceSqToPoint(i);if(a<e){const l=new z;Wc.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class t0 extends xn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class Jd extends xn{constructor(t,e,n=Ns,s,r,o,a=On,l=On,c,u=mo,h=1){if(u!==mo&&u!==go)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new mh(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}class Qd extends xn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}}class Ai{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(t,e){const n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){const e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){const e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){const t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;const e=[];let n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){const n=this.getLengths();let s=0;const r=n.length;let o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);const u=n[s],f=n[s+1]-u,p=(o-u)/f;return(s+p)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);const o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Rt:new z);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){const n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){const n=new z,s=[],r=[],o=[],a=new z,l=new Xe;for(let p=0;p<=t;p++){const _=p/t;s[p]=this.getTangentAt(_,new z)}r[0]=new z,o[0]=new z;let c=Number.MAX_VALUE;const u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=t;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();const _=Math.acos(oe(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,_))}o[p].crossVectors(s[p],r[p])}if(e===!0){let p=Math.acos(oe(r[0].dot(r[t]),-1,1));p/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(p=-p);for(let _=1;_<=t;_++)r[_].applyMatrix4(l.makeRotationAxis(s[_],p*_)),o[_].crossVectors(s[_],r[_])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){const t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}}class gh extends Ai{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Rt){const n=e,s=Math.PI*2;let r=this.aEndAngle-this.aStartAngle;const o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);const a=this.aStartAngle+t*r;let l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){const u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*u-p*h+this.aX,c=f*h+p*u+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){const t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}}class e0 extends gh{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}}function _h(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,p=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,p*=u,s(o,a,f,p)},calc:function(r){const o=r*r,a=o*r;return i+t*r+e*o+n*a}}}const ea=new z,Ll=new _h,Ul=new _h,Nl=new _h;class n0 extends Ai{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new z){const n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t;let a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(ea.subVectors(s[0],s[1]).add(s[0]),c=ea);const h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(ea.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=ea),this.curveType==="centripetal"||this.curveType==="chordal"){const p=this.curveType==="chordal"?.5:.25;let _=Math.pow(c.distanceToSquared(h),p),x=Math.pow(h.distanceToSquared(f),p),m=Math.pow(f.distanceToSquared(u),p);x<1e-4&&(x=1),_<1e-4&&(_=x),m<1e-4&&(m=x),Ll.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,_,x,m),Ul.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,_,x,m),Nl.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,_,x,m)}else this.curveType==="catmullrom"&&(Ll.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),Ul.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),Nl.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(Ll.calc(l),Ul.calc(l),Nl.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){const t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){const s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(new z().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}}function Gu(i,t,e,n,s){const r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function i0(i,t){const e=1-i;return e*e*t}function s0(i,t){return 2*(1-i)*i*t}function r0(i,t){return i*i*t}function ro(i,t,e,n){return i0(i,t)+s0(i,e)+r0(i,n)}function o0(i,t){const e=1-i;return e*e*e*t}function a0(i,t){const e=1-i;return 3*e*e*i*t}function l0(i,t){return 3*(1-i)*i*i*t}function c0(i,t){return i*i*i*t}function oo(i,t,e,n,s){return o0(i,t)+a0(i,e)+l0(i,n)+c0(i,s)}class tp extends Ai{constructor(t=new Rt,e=new Rt,n=new Rt,s=new Rt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Rt){const n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(oo(t,s.x,r.x,o.x,a.x),oo(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}}class h0 extends Ai{constructor(t=new z,e=new z,n=new z,s=new z){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new z){const n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(oo(t,s.x,r.x,o.x,a.x),oo(t,s.y,r.y,o.y,a.y),oo(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}}class ep extends Ai{constructor(t=new Rt,e=new Rt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Rt){const n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Rt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class u0 extends Ai{constructor(t=new z,e=new z){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new z){const n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new z){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class np extends Ai{constructor(t=new Rt,e=new Rt,n=new Rt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Rt){const n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ro(t,s.x,r.x,o.x),ro(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class f0 extends Ai{constructor(t=new z,e=new z,n=new z){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new z){const n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(ro(t,s.x,r.x,o.x),ro(t,s.y,r.y,o.y),ro(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class ip extends Ai{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Rt){const n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(Gu(a,l.x,c.x,u.x,h.x),Gu(a,l.y,c.y,u.y,h.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(s.clone())}return this}toJSON(){const t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){const s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(new Rt().fromArray(s))}return this}}var Wu=Object.freeze({__proto__:null,ArcCurve:e0,CatmullRomCurve3:n0,CubicBezierCurve:tp,CubicBezierCurve3:h0,EllipseCurve:gh,LineCurve:ep,LineCurve3:u0,QuadraticBezierCurve:np,QuadraticBezierCurve3:f0,SplineCurve:ip});class d0 extends Ai{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(t){this.curves.push(t)}closePath(){const t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){const n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Wu[n](e,t))}return this}getPoint(t,e){const n=t*this.getLength(),s=this.getCurveLengths();let r=0;for(;r<s.length;){if(s[r]>=n){const o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){const t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;const t=[];let e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){const e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){const e=[];let n;for(let s=0,r=this.curves;s<r.length;s++){const o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){const u=l[c];n&&n.equals(u)||(e.push(u),n=u)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){const s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this}toJSON(){const t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){const s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){const s=t.curves[e];this.curves.push(new Wu[s.type]().fromJSON(s))}return this}}class Xu extends d0{constructor(t){super(),this.type="Path",this.currentPoint=new Rt,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){const n=new ep(this.currentPoint.clone(),new Rt(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){const r=new np(this.currentPoint.clone(),new Rt(t,e),new Rt(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){const a=new tp(this.currentPoint.clone(),new Rt(t,e),new Rt(n,s),new Rt(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){const e=[this.currentPoint.clone()].concat(t),n=new ip(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){const a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){const c=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(t+c,e+u,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){const c=new gh(t,e,n,s,r,o,a,l);if(this.curves.length>0){const h=c.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(c);const u=c.getPoint(1);return this.currentPoint.copy(u),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){const t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}}class sp extends Xu{constructor(t){super(t),this.uuid=Pr(),this.type="Shape",this.holes=[]}getPointsHoles(t){const e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){const s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){const t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){const s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){const s=t.holes[e];this.holes.push(new Xu().fromJSON(s))}return this}}function p0(i,t,e=2){const n=t&&t.length,s=n?t[0]*e:i.length;let r=rp(i,0,s,e,!0);const o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=x0(i,t,r,e)),i.length>80*e){a=1/0,l=1/0;let u=-1/0,h=-1/0;for(let f=e;f<s;f+=e){const p=i[f],_=i[f+1];p<a&&(a=p),_<l&&(l=_),p>u&&(u=p),_>h&&(h=_)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return vo(r,o,e,a,l,c,0),o}function rp(i,t,e,n,s){let r;if(s===P0(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=Yu(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=Yu(o/n|0,i[o],i[o+1],r);return r&&wr(r,r.next)&&(Mo(r),r=r.next),r}function Os(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(wr(e,e.next)||Ve(e.prev,e,e.next)===0)){if(Mo(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function vo(i,t,e,n,s,r,o){if(!i)return;!o&&r&&w0(i,n,s,r);let a=i;for(;i.prev!==i.next;){const l=i.prev,c=i.next;if(r?g0(i,n,s,r):m0(i)){t.push(l.i,i.i,c.i),Mo(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=_0(Os(i),t),vo(i,t,e,n,s,r,2)):o===2&&v0(i,t,e,n,s,r):vo(Os(i),t,e,n,s,r,1);break}}}function m0(i){const t=i.prev,e=i,n=i.next;if(Ve(t,e,n)>=0)return!1;const s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,u=Math.min(s,r,o),h=Math.min(a,l,c),f=Math.max(s,r,o),p=Math.max(a,l,c);let _=n.next;for(;_!==t;){if(_.x>=u&&_.x<=f&&_.y>=h&&_.y<=p&&Jr(s,a,r,l,o,c,_.x,_.y)&&Ve(_.prev,_,_.next)>=0)return!1;_=_.next}return!0}function g0(i,t,e,n){const s=i.prev,r=i,o=i.next;if(Ve(s,r,o)>=0)return!1;const a=s.x,l=r.x,c=o.x,u=s.y,h=r.y,f=o.y,p=Math.min(a,l,c),_=Math.min(u,h,f),x=Math.max(a,l,c),m=Math.max(u,h,f),d=Xc(p,_,t,e,n),w=Xc(x,m,t,e,n);let T=i.prevZ,S=i.nextZ;for(;T&&T.z>=d&&S&&S.z<=w;){if(T.x>=p&&T.x<=x&&T.y>=_&&T.y<=m&&T!==s&&T!==o&&Jr(a,u,l,h,c,f,T.x,T.y)&&Ve(T.prev,T,T.next)>=0||(T=T.prevZ,S.x>=p&&S.x<=x&&S.y>=_&&S.y<=m&&S!==s&&S!==o&&Jr(a,u,l,h,c,f,S.x,S.y)&&Ve(S.prev,S,S.next)>=0))return!1;S=S.nextZ}for(;T&&T.z>=d;){if(T.x>=p&&T.x<=x&&T.y>=_&&T.y<=m&&T!==s&&T!==o&&Jr(a,u,l,h,c,f,T.x,T.y)&&Ve(T.prev,T,T.next)>=0)return!1;T=T.prevZ}for(;S&&S.z<=w;){if(S.x>=p&&S.x<=x&&S.y>=_&&S.y<=m&&S!==s&&S!==o&&Jr(a,u,l,h,c,f,S.x,S.y)&&Ve(S.prev,S,S.next)>=0)return!1;S=S.nextZ}return!0}function _0(i,t){let e=i;do{const n=e.prev,s=e.next.next;!wr(n,s)&&ap(n,e,e.next,s)&&xo(n,s)&&xo(s,n)&&(t.push(n.i,e.i,s.i),Mo(e),Mo(e.next),e=i=s),e=e.next}while(e!==i);return Os(e)}function v0(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&A0(o,a)){let l=lp(o,a);o=Os(o,o.next),l=Os(l,l.next),vo(o,t,e,n,s,r,0),vo(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function x0(i,t,e,n){const s=[];for(let r=0,o=t.length;r<o;r++){const a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=rp(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(b0(c))}s.sort(M0);for(let r=0;r<s.length;r++)e=S0(s[r],e);return e}function M0(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){const n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function S0(i,t){const e=y0(i,t);if(!e)return t;const n=lp(e,i);return Os(n,n.next),Os(e,e.next)}function y0(i,t){let e=t;const n=i.x,s=i.y;let r=-1/0,o;if(wr(i,e))return e;do{if(wr(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){const h=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(h<=n&&h>r&&(r=h,o=e.x<e.next.x?e:e.next,h===n))return o}e=e.next}while(e!==t);if(!o)return null;const a=o,l=o.x,c=o.y;let u=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&op(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){const h=Math.abs(s-e.y)/(n-e.x);xo(e,i)&&(h<u||h===u&&(e.x>o.x||e.x===o.x&&E0(o,e)))&&(o=e,u=h)}e=e.next}while(e!==a);return o}function E0(i,t){return Ve(i.prev,i,t.prev)<0&&Ve(t.next,i,i.next)<0}function w0(i,t,e,n){let s=i;do s.z===0&&(s.z=Xc(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,T0(s)}function T0(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function Xc(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function b0(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function op(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function Jr(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&op(i,t,e,n,s,r,o,a)}function A0(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!R0(i,t)&&(xo(i,t)&&xo(t,i)&&C0(i,t)&&(Ve(i.prev,i,t.prev)||Ve(i,t.prev,t))||wr(i,t)&&Ve(i.prev,i,i.next)>0&&Ve(t.prev,t,t.next)>0)}function Ve(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function wr(i,t){return i.x===t.x&&i.y===t.y}function ap(i,t,e,n){const s=ia(Ve(i,t,e)),r=ia(Ve(i,t,n)),o=ia(Ve(e,n,i)),a=ia(Ve(e,n,t));return!!(s!==r&&o!==a||s===0&&na(i,e,t)||r===0&&na(i,n,t)||o===0&&na(e,i,n)||a===0&&na(e,t,n))}function na(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function ia(i){return i>0?1:i<0?-1:0}function R0(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&ap(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function xo(i,t){return Ve(i.prev,i,i.next)<0?Ve(i,t,i.next)>=0&&Ve(i,i.prev,t)>=0:Ve(i,t,i.prev)<0||Ve(i,i.next,t)<0}function C0(i,t){let e=i,n=!1;const s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function lp(i,t){const e=Yc(i.i,i.x,i.y),n=Yc(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function Yu(i,t,e,n){const s=Yc(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Mo(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function Yc(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function P0(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}class D0{static triangulate(t,e,n=2){return p0(t,e,n)}}class ao{static area(t){const e=t.length;let n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return ao.area(t)<0}static triangulateShape(t,e){const n=[],s=[],r=[];qu(t),$u(n,t);let o=t.length;e.forEach(qu);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,$u(n,e[l]);const a=D0.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}}function qu(i){const t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function $u(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}class Fa extends Pn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,p=[],_=[],x=[],m=[];for(let d=0;d<u;d++){const w=d*f-o;for(let T=0;T<c;T++){const S=T*h-r;_.push(S,-w,0),x.push(0,0,1),m.push(T/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let w=0;w<a;w++){const T=w+c*d,S=w+c*(d+1),U=w+1+c*(d+1),D=w+1+c*d;p.push(T,S,D),p.push(S,U,D)}this.setIndex(p),this.setAttribute("position",new Cn(_,3)),this.setAttribute("normal",new Cn(x,3)),this.setAttribute("uv",new Cn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Fa(t.width,t.height,t.widthSegments,t.heightSegments)}}class vh extends Pn{constructor(t=new sp([new Rt(0,.5),new Rt(-.5,-.5),new Rt(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};const n=[],s=[],r=[],o=[];let a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let u=0;u<t.length;u++)c(t[u]),this.addGroup(a,l,u),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Cn(s,3)),this.setAttribute("normal",new Cn(r,3)),this.setAttribute("uv",new Cn(o,2));function c(u){const h=s.length/3,f=u.extractPoints(e);let p=f.shape;const _=f.holes;ao.isClockWise(p)===!1&&(p=p.reverse());for(let m=0,d=_.length;m<d;m++){const w=_[m];ao.isClockWise(w)===!0&&(_[m]=w.reverse())}const x=ao.triangulateShape(p,_);for(let m=0,d=_.length;m<d;m++){const w=_[m];p=p.concat(w)}for(let m=0,d=p.length;m<d;m++){const w=p[m];s.push(w.x,w.y,0),r.push(0,0,1),o.push(w.x,w.y)}for(let m=0,d=x.length;m<d;m++){const w=x[m],T=w[0]+h,S=w[1]+h,U=w[2]+h;n.push(T,S,U),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){const t=super.toJSON(),e=this.parameters.shapes;return L0(e,t)}static fromJSON(t,e){const n=[];for(let s=0,r=t.shapes.length;s<r;s++){const o=e[t.shapes[s]];n.push(o)}return new vh(n,t.curveSegments)}}function L0(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){const s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}class ba extends Pn{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new z,h=new z,f=new z;for(let p=0;p<=n;p++)for(let _=0;_<=s;_++){const x=_/s*r,m=p/n*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(x),h.y=(t+e*Math.cos(m))*Math.sin(x),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(x),u.y=t*Math.sin(x),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(_/s),c.push(p/n)}for(let p=1;p<=n;p++)for(let _=1;_<=s;_++){const x=(s+1)*p+_-1,m=(s+1)*(p-1)+_-1,d=(s+1)*(p-1)+_,w=(s+1)*p+_;o.push(x,m,w),o.push(m,d,w)}this.setIndex(o),this.setAttribute("position",new Cn(a,3)),this.setAttribute("normal",new Cn(l,3)),this.setAttribute("uv",new Cn(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new ba(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class U0 extends Lr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=l_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class N0 extends Lr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}class cp extends Yd{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}class I0 extends Yn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}}class Ku{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=oe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(oe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class F0 extends Bs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}}function Zu(i,t,e,n){const s=O0(n);switch(e){case Nd:return i*t;case Fd:return i*t/s.components*s.byteLength;case fh:return i*t/s.components*s.byteLength;case Od:return i*t*2/s.components*s.byteLength;case dh:return i*t*2/s.components*s.byteLength;case Id:return i*t*3/s.components*s.byteLength;case si:return i*t*4/s.components*s.byteLength;case ph:return i*t*4/s.components*s.byteLength;case fa:case da:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case pa:case ma:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case gc:case vc:return Math.max(i,16)*Math.max(t,8)/4;case mc:case _c:return Math.max(i,8)*Math.max(t,8)/2;case xc:case Mc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Sc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case yc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Ec:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case wc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Tc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case bc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Ac:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Rc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Cc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Pc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Dc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Lc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Uc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Nc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case Ic:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Fc:case Oc:case kc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Bc:case zc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Hc:case Vc:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function O0(i){switch(i){case bi:case Pd:return{byteLength:1,components:1};case fo:case Dd:case yo:return{byteLength:2,components:1};case hh:case uh:return{byteLength:2,components:4};case Ns:case ch:case Bi:return{byteLength:4,components:1};case Ld:case Ud:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:lh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=lh);/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function hp(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function k0(i){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let p;if(c instanceof Float32Array)p=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=i.HALF_FLOAT:p=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=i.SHORT;else if(c instanceof Uint32Array)p=i.UNSIGNED_INT;else if(c instanceof Int32Array)p=i.INT;else if(c instanceof Int8Array)p=i.BYTE;else if(c instanceof Uint8Array)p=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){const u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((p,_)=>p.start-_.start);let f=0;for(let p=1;p<h.length;p++){const _=h[f],x=h[p];x.start<=_.start+_.count+1?_.count=Math.max(_.count,x.start+x.count-_.start):(++f,h[f]=x)}h.length=f+1;for(let p=0,_=h.length;p<_;p++){const x=h[p];i.bufferSubData(c,x.start*u.BYTES_PER_ELEMENT,u,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var B0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,z0=`#ifdef USE_ALPHAHASH
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
#endif`,H0=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,V0=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,G0=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,W0=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,X0=`#ifdef USE_AOMAP
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
#endif`,Y0=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,q0=`#ifdef USE_BATCHING
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
	vec3 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 ).rgb;
	}
#endif`,$0=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,K0=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Z0=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,j0=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,J0=`#ifdef USE_IRIDESCENCE
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
#endif`,Q0=`#ifdef USE_BUMPMAP
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
#endif`,tv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,ev=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,nv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,iv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,sv=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,rv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,ov=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,av=`#if defined( USE_COLOR_ALPHA )
	vColor = vec4( 1.0 );
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec3( 1.0 );
#endif
#ifdef USE_COLOR
	vColor *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.xyz *= instanceColor.xyz;
#endif
#ifdef USE_BATCHING_COLOR
	vec3 batchingColor = getBatchingColor( getIndirectIndex( gl_DrawID ) );
	vColor.xyz *= batchingColor.xyz;
#endif`,lv=`#define PI 3.141592653589793
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
vec3 inverseTransformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( vec4( dir, 0.0 ) * matrix ).xyz );
}
mat3 transposeMat3( const in mat3 m ) {
	mat3 tmp;
	tmp[ 0 ] = vec3( m[ 0 ].x, m[ 1 ].x, m[ 2 ].x );
	tmp[ 1 ] = vec3( m[ 0 ].y, m[ 1 ].y, m[ 2 ].y );
	tmp[ 2 ] = vec3( m[ 0 ].z, m[ 1 ].z, m[ 2 ].z );
	return tmp;
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
} // validated`,cv=`#ifdef ENVMAP_TYPE_CUBE_UV
	#define cubeUV_minMipLevel 4.0
	#define cubeUV_minTileSize 16.0
	float getFace( vec3 direction ) {
		vec3 absDirection = abs( direction );
		float face = - 1.0;
		if ( absDirection.x > absDirection.z ) {
			if ( absDirection.x > absDirection.y )
				face = direction.x > 0.0 ? 0.0 : 3.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		} else {
			if ( absDirection.z > absDirection.y )
				face = direction.z > 0.0 ? 2.0 : 5.0;
			else
				face = direction.y > 0.0 ? 1.0 : 4.0;
		}
		return face;
	}
	vec2 getUV( vec3 direction, float face ) {
		vec2 uv;
		if ( face == 0.0 ) {
			uv = vec2( direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 1.0 ) {
			uv = vec2( - direction.x, - direction.z ) / abs( direction.y );
		} else if ( face == 2.0 ) {
			uv = vec2( - direction.x, direction.y ) / abs( direction.z );
		} else if ( face == 3.0 ) {
			uv = vec2( - direction.z, direction.y ) / abs( direction.x );
		} else if ( face == 4.0 ) {
			uv = vec2( - direction.x, direction.z ) / abs( direction.y );
		} else {
			uv = vec2( direction.x, direction.y ) / abs( direction.z );
		}
		return 0.5 * ( uv + 1.0 );
	}
	vec3 bilinearCubeUV( sampler2D envMap, vec3 direction, float mipInt ) {
		float face = getFace( direction );
		float filterInt = max( cubeUV_minMipLevel - mipInt, 0.0 );
		mipInt = max( mipInt, cubeUV_minMipLevel );
		float faceSize = exp2( mipInt );
		highp vec2 uv = getUV( direction, face ) * ( faceSize - 2.0 ) + 1.0;
		if ( face > 2.0 ) {
			uv.y += faceSize;
			face -= 3.0;
		}
		uv.x += face * faceSize;
		uv.x += filterInt * 3.0 * cubeUV_minTileSize;
		uv.y += 4.0 * ( exp2( CUBEUV_MAX_MIP ) - faceSize );
		uv.x *= CUBEUV_TEXEL_WIDTH;
		uv.y *= CUBEUV_TEXEL_HEIGHT;
		#ifdef texture2DGradEXT
			return texture2DGradEXT( envMap, uv, vec2( 0.0 ), vec2( 0.0 ) ).rgb;
		#else
			return texture2D( envMap, uv ).rgb;
		#endif
	}
	#define cubeUV_r0 1.0
	#define cubeUV_m0 - 2.0
	#define cubeUV_r1 0.8
	#define cubeUV_m1 - 1.0
	#define cubeUV_r4 0.4
	#define cubeUV_m4 2.0
	#define cubeUV_r5 0.305
	#define cubeUV_m5 3.0
	#define cubeUV_r6 0.21
	#define cubeUV_m6 4.0
	float roughnessToMip( float roughness ) {
		float mip = 0.0;
		if ( roughness >= cubeUV_r1 ) {
			mip = ( cubeUV_r0 - roughness ) * ( cubeUV_m1 - cubeUV_m0 ) / ( cubeUV_r0 - cubeUV_r1 ) + cubeUV_m0;
		} else if ( roughness >= cubeUV_r4 ) {
			mip = ( cubeUV_r1 - roughness ) * ( cubeUV_m4 - cubeUV_m1 ) / ( cubeUV_r1 - cubeUV_r4 ) + cubeUV_m1;
		} else if ( roughness >= cubeUV_r5 ) {
			mip = ( cubeUV_r4 - roughness ) * ( cubeUV_m5 - cubeUV_m4 ) / ( cubeUV_r4 - cubeUV_r5 ) + cubeUV_m4;
		} else if ( roughness >= cubeUV_r6 ) {
			mip = ( cubeUV_r5 - roughness ) * ( cubeUV_m6 - cubeUV_m5 ) / ( cubeUV_r5 - cubeUV_r6 ) + cubeUV_m5;
		} else {
			mip = - 2.0 * log2( 1.16 * roughness );		}
		return mip;
	}
	vec4 textureCubeUV( sampler2D envMap, vec3 sampleDir, float roughness ) {
		float mip = clamp( roughnessToMip( roughness ), cubeUV_m0, CUBEUV_MAX_MIP );
		float mipF = fract( mip );
		float mipInt = floor( mip );
		vec3 color0 = bilinearCubeUV( envMap, sampleDir, mipInt );
		if ( mipF == 0.0 ) {
			return vec4( color0, 1.0 );
		} else {
			vec3 color1 = bilinearCubeUV( envMap, sampleDir, mipInt + 1.0 );
			return vec4( mix( color0, color1, mipF ), 1.0 );
		}
	}
#endif`,hv=`vec3 transformedNormal = objectNormal;
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
	#ifdef FLIP_SIDED
		transformedTangent = - transformedTangent;
	#endif
#endif`,uv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,fv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,dv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,pv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,mv="gl_FragColor = linearToOutputTexel( gl_FragColor );",gv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_v=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * vec3( flipEnvMap * reflectVec.x, reflectVec.yz ) );
	#else
		vec4 envColor = vec4( 0.0 );
	#endif
	#ifdef ENVMAP_BLENDING_MULTIPLY
		outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_MIX )
		outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
	#elif defined( ENVMAP_BLENDING_ADD )
		outgoingLight += envColor.xyz * specularStrength * reflectivity;
	#endif
#endif`,vv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,xv=`#ifdef USE_ENVMAP
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
#endif`,Mv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Sv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,yv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ev=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,wv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Tv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,bv=`#ifdef USE_GRADIENTMAP
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
}`,Av=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Rv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Cv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Pv=`uniform bool receiveShadow;
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
	vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
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
#endif`,Dv=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 worldNormal = inverseTransformDirection( normal, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * worldNormal, 1.0 );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_CUBE_UV
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, roughness * roughness) );
			reflectVec = inverseTransformDirection( reflectVec, viewMatrix );
			vec4 envMapColor = textureCubeUV( envMap, envMapRotation * reflectVec, roughness );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_CUBE_UV
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
#endif`,Lv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Uv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Nv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Iv=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Fv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb * ( 1.0 - metalnessFactor );
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.0525 );material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
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
	material.specularColor = mix( min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = mix( vec3( 0.04 ), diffuseColor.rgb, metalnessFactor );
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
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.0525 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
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
	material.sheenRoughness = clamp( sheenRoughness, 0.07, 1.0 );
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
#endif`,Ov=`struct PhysicalMaterial {
	vec3 diffuseColor;
	float roughness;
	vec3 specularColor;
	float specularF90;
	float dispersion;
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
		vec3 iridescenceF0;
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
		float v = 0.5 / ( gv + gl );
		return saturate(v);
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
		float roughness = material.clearcoatRoughness;
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
	vec3 f0 = material.specularColor;
	float f90 = material.specularF90;
	float roughness = material.roughness;
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
		float V = V_GGX_SmithCorrelated_Anisotropic( material.alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( material.alphaT, alpha, dotNH, dotTH, dotBH );
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
	mat3 mat = mInv * transposeMat3( mat3( T1, T2, N ) );
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
	float a = roughness < 0.25 ? -339.2 * r2 + 161.4 * roughness - 25.9 : -8.48 * r2 + 14.3 * roughness - 9.95;
	float b = roughness < 0.25 ? 44.0 * r2 - 23.7 * roughness + 3.26 : 1.97 * r2 - 3.27 * roughness + 0.72;
	float DG = exp( a * dotNV + b ) + ( roughness < 0.25 ? 0.0 : 0.1 * ( roughness - 0.25 ) );
	return saturate( DG * RECIPROCAL_PI );
}
vec2 DFGApprox( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	const vec4 c0 = vec4( - 1, - 0.0275, - 0.572, 0.022 );
	const vec4 c1 = vec4( 1, 0.0425, 1.04, - 0.04 );
	vec4 r = roughness * c0 + c1;
	float a004 = min( r.x * r.x, exp2( - 9.28 * dotNV ) ) * r.x + r.y;
	vec2 fab = vec2( - 1.04, 1.04 ) * a004 + r.zw;
	return fab;
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	vec2 fab = DFGApprox( normal, viewDir, roughness );
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	vec2 fab = DFGApprox( normal, viewDir, roughness );
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
		vec3 fresnel = ( material.specularColor * t2.x + ( vec3( 1.0 ) - material.specularColor ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseColor * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
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
	#endif
	reflectedLight.directSpecular += irradiance * BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
	#endif
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.iridescence, material.iridescenceFresnel, material.roughness, singleScattering, multiScattering );
	#else
		computeMultiscattering( geometryNormal, geometryViewDir, material.specularColor, material.specularF90, material.roughness, singleScattering, multiScattering );
	#endif
	vec3 totalScattering = singleScattering + multiScattering;
	vec3 diffuse = material.diffuseColor * ( 1.0 - max( max( totalScattering.r, totalScattering.g ), totalScattering.b ) );
	reflectedLight.indirectSpecular += radiance * singleScattering;
	reflectedLight.indirectSpecular += multiScattering * cosineWeightedIrradiance;
	reflectedLight.indirectDiffuse += diffuse * cosineWeightedIrradiance;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,kv=`
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
		material.iridescenceFresnel = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		material.iridescenceF0 = Schlick_to_F0( material.iridescenceFresnel, 1.0, dotNVi );
	}
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
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS )
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
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Bv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD ) && defined( ENVMAP_TYPE_CUBE_UV )
		iblIrradiance += getIBLIrradiance( geometryNormal );
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		radiance += getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		radiance += getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,zv=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Hv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Vv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Wv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Xv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Yv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,qv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,$v=`#if defined( USE_POINTS_UV )
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
#endif`,Kv=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Zv=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,jv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Jv=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,Qv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,tx=`#ifdef USE_MORPHTARGETS
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
#endif`,ex=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,nx=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
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
	#if defined( DOUBLE_SIDED ) && ! defined( FLAT_SHADED )
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,ix=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,sx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,rx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ox=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,ax=`#ifdef USE_NORMALMAP
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
#endif`,lx=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,cx=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,hx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,ux=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,fx=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,dx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
	return depth * ( near - far ) - near;
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	return ( near * far ) / ( ( far - near ) * depth - far );
}`,px=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,mx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,gx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,_x=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,vx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,xx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Mx=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
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
		uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
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
		uniform sampler2D pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
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
	float texture2DCompare( sampler2D depths, vec2 uv, float compare ) {
		float depth = unpackRGBAToDepth( texture2D( depths, uv ) );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			return step( depth, compare );
		#else
			return step( compare, depth );
		#endif
	}
	vec2 texture2DDistribution( sampler2D shadow, vec2 uv ) {
		return unpackRGBATo2Half( texture2D( shadow, uv ) );
	}
	float VSMShadow( sampler2D shadow, vec2 uv, float compare ) {
		float occlusion = 1.0;
		vec2 distribution = texture2DDistribution( shadow, uv );
		#ifdef USE_REVERSED_DEPTH_BUFFER
			float hard_shadow = step( distribution.x, compare );
		#else
			float hard_shadow = step( compare, distribution.x );
		#endif
		if ( hard_shadow != 1.0 ) {
			float distance = compare - distribution.x;
			float variance = max( 0.00000, distribution.y * distribution.y );
			float softness_probability = variance / (variance + distance * distance );			softness_probability = clamp( ( softness_probability - 0.3 ) / ( 0.95 - 0.3 ), 0.0, 1.0 );			occlusion = clamp( max( hard_shadow, softness_probability ), 0.0, 1.0 );
		}
		return occlusion;
	}
	float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
		float shadow = 1.0;
		shadowCoord.xyz /= shadowCoord.w;
		shadowCoord.z += shadowBias;
		bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
		bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
		if ( frustumTest ) {
		#if defined( SHADOWMAP_TYPE_PCF )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx0 = - texelSize.x * shadowRadius;
			float dy0 = - texelSize.y * shadowRadius;
			float dx1 = + texelSize.x * shadowRadius;
			float dy1 = + texelSize.y * shadowRadius;
			float dx2 = dx0 / 2.0;
			float dy2 = dy0 / 2.0;
			float dx3 = dx1 / 2.0;
			float dy3 = dy1 / 2.0;
			shadow = (
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy2 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx2, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx3, dy3 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( 0.0, dy1 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, shadowCoord.xy + vec2( dx1, dy1 ), shadowCoord.z )
			) * ( 1.0 / 17.0 );
		#elif defined( SHADOWMAP_TYPE_PCF_SOFT )
			vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
			float dx = texelSize.x;
			float dy = texelSize.y;
			vec2 uv = shadowCoord.xy;
			vec2 f = fract( uv * shadowMapSize + 0.5 );
			uv -= f * texelSize;
			shadow = (
				texture2DCompare( shadowMap, uv, shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( dx, 0.0 ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + vec2( 0.0, dy ), shadowCoord.z ) +
				texture2DCompare( shadowMap, uv + texelSize, shadowCoord.z ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, 0.0 ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 0.0 ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( -dx, dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, dy ), shadowCoord.z ),
					 f.x ) +
				mix( texture2DCompare( shadowMap, uv + vec2( 0.0, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( 0.0, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( texture2DCompare( shadowMap, uv + vec2( dx, -dy ), shadowCoord.z ),
					 texture2DCompare( shadowMap, uv + vec2( dx, 2.0 * dy ), shadowCoord.z ),
					 f.y ) +
				mix( mix( texture2DCompare( shadowMap, uv + vec2( -dx, -dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, -dy ), shadowCoord.z ),
						  f.x ),
					 mix( texture2DCompare( shadowMap, uv + vec2( -dx, 2.0 * dy ), shadowCoord.z ),
						  texture2DCompare( shadowMap, uv + vec2( 2.0 * dx, 2.0 * dy ), shadowCoord.z ),
						  f.x ),
					 f.y )
			) * ( 1.0 / 9.0 );
		#elif defined( SHADOWMAP_TYPE_VSM )
			shadow = VSMShadow( shadowMap, shadowCoord.xy, shadowCoord.z );
		#else
			shadow = texture2DCompare( shadowMap, shadowCoord.xy, shadowCoord.z );
		#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	vec2 cubeToUV( vec3 v, float texelSizeY ) {
		vec3 absV = abs( v );
		float scaleToCube = 1.0 / max( absV.x, max( absV.y, absV.z ) );
		absV *= scaleToCube;
		v *= scaleToCube * ( 1.0 - 2.0 * texelSizeY );
		vec2 planar = v.xy;
		float almostATexel = 1.5 * texelSizeY;
		float almostOne = 1.0 - almostATexel;
		if ( absV.z >= almostOne ) {
			if ( v.z > 0.0 )
				planar.x = 4.0 - v.x;
		} else if ( absV.x >= almostOne ) {
			float signX = sign( v.x );
			planar.x = v.z * signX + 2.0 * signX;
		} else if ( absV.y >= almostOne ) {
			float signY = sign( v.y );
			planar.x = v.x + 2.0 * signY + 2.0;
			planar.y = v.z * signY - 2.0;
		}
		return vec2( 0.125, 0.25 ) * planar + vec2( 0.375, 0.75 );
	}
	float getPointShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		
		float lightToPositionLength = length( lightToPosition );
		if ( lightToPositionLength - shadowCameraFar <= 0.0 && lightToPositionLength - shadowCameraNear >= 0.0 ) {
			float dp = ( lightToPositionLength - shadowCameraNear ) / ( shadowCameraFar - shadowCameraNear );			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			vec2 texelSize = vec2( 1.0 ) / ( shadowMapSize * vec2( 4.0, 2.0 ) );
			#if defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_PCF_SOFT ) || defined( SHADOWMAP_TYPE_VSM )
				vec2 offset = vec2( - 1, 1 ) * shadowRadius * texelSize.y;
				shadow = (
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yyx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxy, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.xxx, texelSize.y ), dp ) +
					texture2DCompare( shadowMap, cubeToUV( bd3D + offset.yxx, texelSize.y ), dp )
				) * ( 1.0 / 9.0 );
			#else
				shadow = texture2DCompare( shadowMap, cubeToUV( bd3D, texelSize.y ), dp );
			#endif
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
#endif`,Sx=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
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
#endif`,yx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	vec3 shadowWorldNormal = inverseTransformDirection( transformedNormal, viewMatrix );
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
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
#endif`,Ex=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
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
	#if NUM_POINT_LIGHT_SHADOWS > 0
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
}`,wx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Tx=`#ifdef USE_SKINNING
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
#endif`,bx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Ax=`#ifdef USE_SKINNING
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
#endif`,Rx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Cx=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Px=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Dx=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,Lx=`#ifdef USE_TRANSMISSION
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
	vec3 n = inverseTransformDirection( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseColor, material.specularColor, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Ux=`#ifdef USE_TRANSMISSION
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
#endif`,Nx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ix=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Fx=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ox=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const kx=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Bx=`uniform sampler2D t2D;
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
}`,zx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Hx=`#ifdef ENVMAP_TYPE_CUBE
	uniform samplerCube envMap;
#elif defined( ENVMAP_TYPE_CUBE_UV )
	uniform sampler2D envMap;
#endif
uniform float flipEnvMap;
uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <cube_uv_reflection_fragment>
void main() {
	#ifdef ENVMAP_TYPE_CUBE
		vec4 texColor = textureCube( envMap, backgroundRotation * vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) );
	#elif defined( ENVMAP_TYPE_CUBE_UV )
		vec4 texColor = textureCubeUV( envMap, backgroundRotation * vWorldDirection, backgroundBlurriness );
	#else
		vec4 texColor = vec4( 0.0, 0.0, 0.0, 1.0 );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vx=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Gx=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Wx=`#include <common>
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
}`,Xx=`#if DEPTH_PACKING == 3200
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
}`,Yx=`#define DISTANCE
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
}`,qx=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main () {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = packDepthToRGBA( dist );
}`,$x=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Kx=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Zx=`uniform float scale;
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
}`,jx=`uniform vec3 diffuse;
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
}`,Jx=`#include <common>
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
}`,Qx=`uniform vec3 diffuse;
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
}`,tM=`#define LAMBERT
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
}`,eM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,nM=`#define MATCAP
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
}`,iM=`#define MATCAP
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
}`,sM=`#define NORMAL
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
}`,rM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <packing>
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
	gl_FragColor = vec4( packNormalToRGB( normal ), diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,oM=`#define PHONG
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
}`,aM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <packing>
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
}`,lM=`#define STANDARD
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
}`,cM=`#define STANDARD
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
#ifdef USE_DISPERSION
	uniform float dispersion;
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
#include <packing>
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
#include <cube_uv_reflection_fragment>
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
		float sheenEnergyComp = 1.0 - 0.157 * max3( material.sheenColor );
		outgoingLight = outgoingLight * sheenEnergyComp + sheenSpecularDirect + sheenSpecularIndirect;
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
}`,hM=`#define TOON
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
}`,uM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <packing>
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
}`,fM=`uniform float size;
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
}`,dM=`uniform vec3 diffuse;
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
}`,pM=`#include <common>
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
}`,mM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <packing>
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
}`,gM=`uniform float rotation;
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
}`,_M=`uniform vec3 diffuse;
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
}`,re={alphahash_fragment:B0,alphahash_pars_fragment:z0,alphamap_fragment:H0,alphamap_pars_fragment:V0,alphatest_fragment:G0,alphatest_pars_fragment:W0,aomap_fragment:X0,aomap_pars_fragment:Y0,batching_pars_vertex:q0,batching_vertex:$0,begin_vertex:K0,beginnormal_vertex:Z0,bsdfs:j0,iridescence_fragment:J0,bumpmap_pars_fragment:Q0,clipping_planes_fragment:tv,clipping_planes_pars_fragment:ev,clipping_planes_pars_vertex:nv,clipping_planes_vertex:iv,color_fragment:sv,color_pars_fragment:rv,color_pars_vertex:ov,color_vertex:av,common:lv,cube_uv_reflection_fragment:cv,defaultnormal_vertex:hv,displacementmap_pars_vertex:uv,displacementmap_vertex:fv,emissivemap_fragment:dv,emissivemap_pars_fragment:pv,colorspace_fragment:mv,colorspace_pars_fragment:gv,envmap_fragment:_v,envmap_common_pars_fragment:vv,envmap_pars_fragment:xv,envmap_pars_vertex:Mv,envmap_physical_pars_fragment:Dv,envmap_vertex:Sv,fog_vertex:yv,fog_pars_vertex:Ev,fog_fragment:wv,fog_pars_fragment:Tv,gradientmap_pars_fragment:bv,lightmap_pars_fragment:Av,lights_lambert_fragment:Rv,lights_lambert_pars_fragment:Cv,lights_pars_begin:Pv,lights_toon_fragment:Lv,lights_toon_pars_fragment:Uv,lights_phong_fragment:Nv,lights_phong_pars_fragment:Iv,lights_physical_fragment:Fv,lights_physical_pars_fragment:Ov,lights_fragment_begin:kv,lights_fragment_maps:Bv,lights_fragment_end:zv,logdepthbuf_fragment:Hv,logdepthbuf_pars_fragment:Vv,logdepthbuf_pars_vertex:Gv,logdepthbuf_vertex:Wv,map_fragment:Xv,map_pars_fragment:Yv,map_particle_fragment:qv,map_particle_pars_fragment:$v,metalnessmap_fragment:Kv,metalnessmap_pars_fragment:Zv,morphinstance_vertex:jv,morphcolor_vertex:Jv,morphnormal_vertex:Qv,morphtarget_pars_vertex:tx,morphtarget_vertex:ex,normal_fragment_begin:nx,normal_fragment_maps:ix,normal_pars_fragment:sx,normal_pars_vertex:rx,normal_vertex:ox,normalmap_pars_fragment:ax,clearcoat_normal_fragment_begin:lx,clearcoat_normal_fragment_maps:cx,clearcoat_pars_fragment:hx,iridescence_pars_fragment:ux,opaque_fragment:fx,packing:dx,premultiplied_alpha_fragment:px,project_vertex:mx,dithering_fragment:gx,dithering_pars_fragment:_x,roughnessmap_fragment:vx,roughnessmap_pars_fragment:xx,shadowmap_pars_fragment:Mx,shadowmap_pars_vertex:Sx,shadowmap_vertex:yx,shadowmask_pars_fragment:Ex,skinbase_vertex:wx,skinning_pars_vertex:Tx,skinning_vertex:bx,skinnormal_vertex:Ax,specularmap_fragment:Rx,specularmap_pars_fragment:Cx,tonemapping_fragment:Px,tonemapping_pars_fragment:Dx,transmission_fragment:Lx,transmission_pars_fragment:Ux,uv_pars_fragment:Nx,uv_pars_vertex:Ix,uv_vertex:Fx,worldpos_vertex:Ox,background_vert:kx,background_frag:Bx,backgroundCube_vert:zx,backgroundCube_frag:Hx,cube_vert:Vx,cube_frag:Gx,depth_vert:Wx,depth_frag:Xx,distanceRGBA_vert:Yx,distanceRGBA_frag:qx,equirect_vert:$x,equirect_frag:Kx,linedashed_vert:Zx,linedashed_frag:jx,meshbasic_vert:Jx,meshbasic_frag:Qx,meshlambert_vert:tM,meshlambert_frag:eM,meshmatcap_vert:nM,meshmatcap_frag:iM,meshnormal_vert:sM,meshnormal_frag:rM,meshphong_vert:oM,meshphong_frag:aM,meshphysical_vert:lM,meshphysical_frag:cM,meshtoon_vert:hM,meshtoon_frag:uM,points_vert:fM,points_frag:dM,shadow_vert:pM,shadow_frag:mM,sprite_vert:gM,sprite_frag:_M},yt={common:{diffuse:{value:new Me(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new Rt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Me(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new Me(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new Me(16777215)},opacity:{value:1},center:{value:new Rt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},yi={basic:{uniforms:bn([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.fog]),vertexShader:re.meshbasic_vert,fragmentShader:re.meshbasic_frag},lambert:{uniforms:bn([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new Me(0)}}]),vertexShader:re.meshlambert_vert,fragmentShader:re.meshlambert_frag},phong:{uniforms:bn([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new Me(0)},specular:{value:new Me(1118481)},shininess:{value:30}}]),vertexShader:re.meshphong_vert,fragmentShader:re.meshphong_frag},standard:{uniforms:bn([yt.common,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.roughnessmap,yt.metalnessmap,yt.fog,yt.lights,{emissive:{value:new Me(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag},toon:{uniforms:bn([yt.common,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.gradientmap,yt.fog,yt.lights,{emissive:{value:new Me(0)}}]),vertexShader:re.meshtoon_vert,fragmentShader:re.meshtoon_frag},matcap:{uniforms:bn([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,{matcap:{value:null}}]),vertexShader:re.meshmatcap_vert,fragmentShader:re.meshmatcap_frag},points:{uniforms:bn([yt.points,yt.fog]),vertexShader:re.points_vert,fragmentShader:re.points_frag},dashed:{uniforms:bn([yt.common,yt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:re.linedashed_vert,fragmentShader:re.linedashed_frag},depth:{uniforms:bn([yt.common,yt.displacementmap]),vertexShader:re.depth_vert,fragmentShader:re.depth_frag},normal:{uniforms:bn([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,{opacity:{value:1}}]),vertexShader:re.meshnormal_vert,fragmentShader:re.meshnormal_frag},sprite:{uniforms:bn([yt.sprite,yt.fog]),vertexShader:re.sprite_vert,fragmentShader:re.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:re.background_vert,fragmentShader:re.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:re.backgroundCube_vert,fragmentShader:re.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:re.cube_vert,fragmentShader:re.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:re.equirect_vert,fragmentShader:re.equirect_frag},distanceRGBA:{uniforms:bn([yt.common,yt.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:re.distanceRGBA_vert,fragmentShader:re.distanceRGBA_frag},shadow:{uniforms:bn([yt.lights,yt.fog,{color:{value:new Me(0)},opacity:{value:1}}]),vertexShader:re.shadow_vert,fragmentShader:re.shadow_frag}};yi.physical={uniforms:bn([yi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new Rt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new Me(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new Rt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new Me(0)},specularColor:{value:new Me(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new Rt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag};const sa={r:0,b:0,g:0},ys=new Xi,vM=new Xe;function xM(i,t,e,n,s,r,o){const a=new Me(0);let l=r===!0?0:1,c,u,h=null,f=0,p=null;function _(T){let S=T.isScene===!0?T.background:null;return S&&S.isTexture&&(S=(T.backgroundBlurriness>0?e:t).get(S)),S}function x(T){let S=!1;const U=_(T);U===null?d(a,l):U&&U.isColor&&(d(U,1),S=!0);const D=i.xr.getEnvironmentBlendMode();D==="additive"?n.buffers.color.setClear(0,0,0,1,o):D==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||S)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(T,S){const U=_(S);U&&(U.isCubeTexture||U.mapping===Na)?(u===void 0&&(u=new qn(new wo(1,1,1),new Yi({name:"BackgroundCubeMaterial",uniforms:Er(yi.backgroundCube.uniforms),vertexShader:yi.backgroundCube.vertexShader,fragmentShader:yi.backgroundCube.fragmentShader,side:Fn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(D,N,k){this.matrixWorld.copyPosition(k.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),ys.copy(S.backgroundRotation),ys.x*=-1,ys.y*=-1,ys.z*=-1,U.isCubeTexture&&U.isRenderTargetTexture===!1&&(ys.y*=-1,ys.z*=-1),u.material.uniforms.envMap.value=U,u.material.uniforms.flipEnvMap.value=U.isCubeTexture&&U.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(vM.makeRotationFromEuler(ys)),u.material.toneMapped=pe.getTransfer(U.colorSpace)!==Ae,(h!==U||f!==U.version||p!==i.toneMapping)&&(u.material.needsUpdate=!0,h=U,f=U.version,p=i.toneMapping),u.layers.enableAll(),T.unshift(u,u.geometry,u.material,0,0,null)):U&&U.isTexture&&(c===void 0&&(c=new qn(new Fa(2,2),new Yi({name:"BackgroundMaterial",uniforms:Er(yi.background.uniforms),vertexShader:yi.background.vertexShader,fragmentShader:yi.background.fragmentShader,side:hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=U,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=pe.getTransfer(U.colorSpace)!==Ae,U.matrixAutoUpdate===!0&&U.updateMatrix(),c.material.uniforms.uvTransform.value.copy(U.matrix),(h!==U||f!==U.version||p!==i.toneMapping)&&(c.material.needsUpdate=!0,h=U,f=U.version,p=i.toneMapping),c.layers.enableAll(),T.unshift(c,c.geometry,c.material,0,0,null))}function d(T,S){T.getRGB(sa,Xd(i)),n.buffers.color.setClear(sa.r,sa.g,sa.b,S,o)}function w(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(T,S=1){a.set(T),l=S,d(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(T){l=T,d(a,l)},render:x,addToRenderList:m,dispose:w}}function MM(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(E,C,G,H,$){let W=!1;const j=h(H,G,C);r!==j&&(r=j,c(r.object)),W=p(E,H,G,$),W&&_(E,H,G,$),$!==null&&t.update($,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,S(E,C,G,H),$!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get($).buffer))}function l(){return i.createVertexArray()}function c(E){return i.bindVertexArray(E)}function u(E){return i.deleteVertexArray(E)}function h(E,C,G){const H=G.wireframe===!0;let $=n[E.id];$===void 0&&($={},n[E.id]=$);let W=$[C.id];W===void 0&&(W={},$[C.id]=W);let j=W[H];return j===void 0&&(j=f(l()),W[H]=j),j}function f(E){const C=[],G=[],H=[];for(let $=0;$<e;$++)C[$]=0,G[$]=0,H[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:G,attributeDivisors:H,object:E,attributes:{},index:null}}function p(E,C,G,H){const $=r.attributes,W=C.attributes;let j=0;const Y=G.getAttributes();for(const J in Y)if(Y[J].location>=0){const at=$[J];let _t=W[J];if(_t===void 0&&(J==="instanceMatrix"&&E.instanceMatrix&&(_t=E.instanceMatrix),J==="instanceColor"&&E.instanceColor&&(_t=E.instanceColor)),at===void 0||at.attribute!==_t||_t&&at.data!==_t.data)return!0;j++}return r.attributesNum!==j||r.index!==H}function _(E,C,G,H){const $={},W=C.attributes;let j=0;const Y=G.getAttributes();for(const J in Y)if(Y[J].location>=0){let at=W[J];at===void 0&&(J==="instanceMatrix"&&E.instanceMatrix&&(at=E.instanceMatrix),J==="instanceColor"&&E.instanceColor&&(at=E.instanceColor));const _t={};_t.attribute=at,at&&at.data&&(_t.data=at.data),$[J]=_t,j++}r.attributes=$,r.attributesNum=j,r.index=H}function x(){const E=r.newAttributes;for(let C=0,G=E.length;C<G;C++)E[C]=0}function m(E){d(E,0)}function d(E,C){const G=r.newAttributes,H=r.enabledAttributes,$=r.attributeDivisors;G[E]=1,H[E]===0&&(i.enableVertexAttribArray(E),H[E]=1),$[E]!==C&&(i.vertexAttribDivisor(E,C),$[E]=C)}function w(){const E=r.newAttributes,C=r.enabledAttributes;for(let G=0,H=C.length;G<H;G++)C[G]!==E[G]&&(i.disableVertexAttribArray(G),C[G]=0)}function T(E,C,G,H,$,W,j){j===!0?i.vertexAttribIPointer(E,C,G,$,W):i.vertexAttribPointer(E,C,G,H,$,W)}function S(E,C,G,H){x();const $=H.attributes,W=G.getAttributes(),j=C.defaultAttributeValues;for(const Y in W){const J=W[Y];if(J.location>=0){let ot=$[Y];if(ot===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(ot=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(ot=E.instanceColor)),ot!==void 0){const at=ot.normalized,_t=ot.itemSize,Mt=t.get(ot);if(Mt===void 0)continue;const gt=Mt.buffer,ee=Mt.type,jt=Mt.bytesPerElement,Q=ee===i.INT||ee===i.UNSIGNED_INT||ot.gpuType===ch;if(ot.isInterleavedBufferAttribute){const et=ot.data,Et=et.stride,Bt=ot.offset;if(et.isInstancedInterleavedBuffer){for(let vt=0;vt<J.locationSize;vt++)d(J.location+vt,et.meshPerAttribute);E.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=et.meshPerAttribute*et.count)}else for(let vt=0;vt<J.locationSize;vt++)m(J.location+vt);i.bindBuffer(i.ARRAY_BUFFER,gt);for(let vt=0;vt<J.locationSize;vt++)T(J.location+vt,_t/J.locationSize,ee,at,Et*jt,(Bt+_t/J.locationSize*vt)*jt,Q)}else{if(ot.isInstancedBufferAttribute){for(let et=0;et<J.locationSize;et++)d(J.location+et,ot.meshPerAttribute);E.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let et=0;et<J.locationSize;et++)m(J.location+et);i.bindBuffer(i.ARRAY_BUFFER,gt);for(let et=0;et<J.locationSize;et++)T(J.location+et,_t/J.locationSize,ee,at,_t*jt,_t/J.locationSize*et*jt,Q)}}else if(j!==void 0){const at=j[Y];if(at!==void 0)switch(at.length){case 2:i.vertexAttrib2fv(J.location,at);break;case 3:i.vertexAttrib3fv(J.location,at);break;case 4:i.vertexAttrib4fv(J.location,at);break;default:i.vertexAttrib1fv(J.location,at)}}}}w()}function U(){k();for(const E in n){const C=n[E];for(const G in C){const H=C[G];for(const $ in H)u(H[$].object),delete H[$];delete C[G]}delete n[E]}}function D(E){if(n[E.id]===void 0)return;const C=n[E.id];for(const G in C){const H=C[G];for(const $ in H)u(H[$].object),delete H[$];delete C[G]}delete n[E.id]}function N(E){for(const C in n){const G=n[C];if(G[E.id]===void 0)continue;const H=G[E.id];for(const $ in H)u(H[$].object),delete H[$];delete G[E.id]}}function k(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:b,dispose:U,releaseStatesOfGeometry:D,releaseStatesOfProgram:N,initAttributes:x,enableAttribute:m,disableUnusedAttributes:w}}function SM(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let p=0;for(let _=0;_<h;_++)p+=u[_];e.update(p,n,1)}function l(c,u,h,f){if(h===0)return;const p=t.get("WEBGL_multi_draw");if(p===null)for(let _=0;_<c.length;_++)o(c[_],u[_],f[_]);else{p.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let _=0;for(let x=0;x<h;x++)_+=u[x]*f[x];e.update(_,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function yM(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const N=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(N.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(N){return!(N!==si&&n.convert(N)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(N){const k=N===yo&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(N!==bi&&n.convert(N)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&N!==Bi&&!k)}function l(N){if(N==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";N="mediump"}return N==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),p=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),_=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),d=i.getParameter(i.MAX_VERTEX_ATTRIBS),w=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),S=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),U=_>0,D=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:p,maxVertexTextures:_,maxTextureSize:x,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:w,maxVaryings:T,maxFragmentUniforms:S,vertexTextures:U,maxSamples:D}}function EM(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new rs,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const p=h.length!==0||f||n!==0||s;return s=f,n=h.length,p},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,p){const _=h.clippingPlanes,x=h.clipIntersection,m=h.clipShadows,d=i.get(h);if(!s||_===null||_.length===0||r&&!m)r?u(null):c();else{const w=r?0:n,T=w*4;let S=d.clippingState||null;l.value=S,S=u(_,f,T,p);for(let U=0;U!==T;++U)S[U]=e[U];d.clippingState=S,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=w}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,p,_){const x=h!==null?h.length:0;let m=null;if(x!==0){if(m=l.value,_!==!0||m===null){const d=p+x*4,w=f.matrixWorldInverse;a.getNormalMatrix(w),(m===null||m.length<d)&&(m=new Float32Array(d));for(let T=0,S=p;T!==x;++T,S+=4)o.copy(h[T]).applyMatrix4(w,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}function wM(i){let t=new WeakMap;function e(o,a){return a===fc?o.mapping=xr:a===dc&&(o.mapping=Mr),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===fc||a===dc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new X_(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}const dr=4,ju=[.125,.215,.35,.446,.526,.582],Rs=20,Il=new cp,Ju=new Me;let Fl=null,Ol=0,kl=0,Bl=!1;const ws=(1+Math.sqrt(5))/2,cr=1/ws,Qu=[new z(-ws,cr,0),new z(ws,cr,0),new z(-cr,0,ws),new z(cr,0,ws),new z(0,ws,-cr),new z(0,ws,cr),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)],TM=new z;class tf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){const{size:o=256,position:a=TM}=r;Fl=this._renderer.getRenderTarget(),Ol=this._renderer.getActiveCubeFace(),kl=this._renderer.getActiveMipmapLevel(),Bl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);const l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,n,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=sf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=nf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Fl,Ol,kl),this._renderer.xr.enabled=Bl,t.scissorTest=!1,ra(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===xr||t.mapping===Mr?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Fl=this._renderer.getRenderTarget(),Ol=this._renderer.getActiveCubeFace(),kl=this._renderer.getActiveMipmapLevel(),Bl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:wi,minFilter:wi,generateMipmaps:!1,type:yo,format:si,colorSpace:Sr,depthBuffer:!1},s=ef(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=ef(t,e,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=bM(r)),this._blurMaterial=AM(r,t,e)}return s}_compileMaterial(t){const e=new qn(this._lodPlanes[0],t);this._renderer.compile(e,Il)}_sceneToCubeUV(t,e,n,s,r){const l=new Yn(90,1,e,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,p=h.toneMapping;h.getClearColor(Ju),h.toneMapping=cs,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));const x=new yr({name:"PMREM.Background",side:Fn,depthWrite:!1,depthTest:!1}),m=new qn(new wo,x);let d=!1;const w=t.background;w?w.isColor&&(x.color.copy(w),t.background=null,d=!0):(x.color.copy(Ju),d=!0);for(let T=0;T<6;T++){const S=T%3;S===0?(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[T],r.y,r.z)):S===1?(l.up.set(0,0,c[T]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[T],r.z)):(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[T]));const U=this._cubeSize;ra(s,S*U,T>2?U:0,U,U),h.setRenderTarget(s),d&&h.render(m,l),h.render(t,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=p,h.autoClear=f,t.background=w}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===xr||t.mapping===Mr;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=sf()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=nf());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new qn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;ra(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,Il)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=Qu[(s-r-1)%Qu.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new qn(this._lodPlanes[s],c),f=c.uniforms,p=this._sizeLods[n]-1,_=isFinite(r)?Math.PI/(2*p):2*Math.PI/(2*Rs-1),x=r/_,m=isFinite(r)?1+Math.floor(u*x):Rs;m>Rs&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Rs}`);const d=[];let w=0;for(let N=0;N<Rs;++N){const k=N/x,b=Math.exp(-k*k/2);d.push(b),N===0?w+=b:N<m&&(w+=2*b)}for(let N=0;N<d.length;N++)d[N]=d[N]/w;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=d,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=_,f.mipInt.value=T-n;const S=this._sizeLods[s],U=3*S*(s>T-dr?s-T+dr:0),D=4*(this._cubeSize-S);ra(e,U,D,3*S,2*S),l.setRenderTarget(e),l.render(h,Il)}}function bM(i){const t=[],e=[],n=[];let s=i;const r=i-dr+1+ju.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>i-dr?l=ju[o-i+dr-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],p=6,_=6,x=3,m=2,d=1,w=new Float32Array(x*_*p),T=new Float32Array(m*_*p),S=new Float32Array(d*_*p);for(let D=0;D<p;D++){const N=D%3*2/3-1,k=D>2?0:-1,b=[N,k,0,N+2/3,k,0,N+2/3,k+1,0,N,k,0,N+2/3,k+1,0,N,k+1,0];w.set(b,x*_*D),T.set(f,m*_*D);const E=[D,D,D,D,D,D];S.set(E,d*_*D)}const U=new Pn;U.setAttribute("position",new vn(w,x)),U.setAttribute("uv",new vn(T,m)),U.setAttribute("faceIndex",new vn(S,d)),t.push(U),s>dr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function ef(i,t,e){const n=new Fs(i,t,e);return n.texture.mapping=Na,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ra(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function AM(i,t,e){const n=new Float32Array(Rs),s=new z(0,1,0);return new Yi({name:"SphericalGaussianBlur",defines:{n:Rs,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:xh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;
			uniform int samples;
			uniform float weights[ n ];
			uniform bool latitudinal;
			uniform float dTheta;
			uniform float mipInt;
			uniform vec3 poleAxis;

			#define ENVMAP_TYPE_CUBE_UV
			#include <cube_uv_reflection_fragment>

			vec3 getSample( float theta, vec3 axis ) {

				float cosTheta = cos( theta );
				// Rodrigues' axis-angle rotation
				vec3 sampleDirection = vOutputDirection * cosTheta
					+ cross( axis, vOutputDirection ) * sin( theta )
					+ axis * dot( axis, vOutputDirection ) * ( 1.0 - cosTheta );

				return bilinearCubeUV( envMap, sampleDirection, mipInt );

			}

			void main() {

				vec3 axis = latitudinal ? poleAxis : cross( poleAxis, vOutputDirection );

				if ( all( equal( axis, vec3( 0.0 ) ) ) ) {

					axis = vec3( vOutputDirection.z, 0.0, - vOutputDirection.x );

				}

				axis = normalize( axis );

				gl_FragColor = vec4( 0.0, 0.0, 0.0, 1.0 );
				gl_FragColor.rgb += weights[ 0 ] * getSample( 0.0, axis );

				for ( int i = 1; i < n; i++ ) {

					if ( i >= samples ) {

						break;

					}

					float theta = dTheta * float( i );
					gl_FragColor.rgb += weights[ i ] * getSample( -1.0 * theta, axis );
					gl_FragColor.rgb += weights[ i ] * getSample( theta, axis );

				}

			}
		`,blending:Hi,depthTest:!1,depthWrite:!1})}function nf(){return new Yi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:xh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			varying vec3 vOutputDirection;

			uniform sampler2D envMap;

			#include <common>

			void main() {

				vec3 outputDirection = normalize( vOutputDirection );
				vec2 uv = equirectUv( outputDirection );

				gl_FragColor = vec4( texture2D ( envMap, uv ).rgb, 1.0 );

			}
		`,blending:Hi,depthTest:!1,depthWrite:!1})}function sf(){return new Yi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:xh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Hi,depthTest:!1,depthWrite:!1})}function xh(){return`

		precision mediump float;
		precision mediump int;

		attribute float faceIndex;

		varying vec3 vOutputDirection;

		// RH coordinate system; PMREM face-indexing convention
		vec3 getDirection( vec2 uv, float face ) {

			uv = 2.0 * uv - 1.0;

			vec3 direction = vec3( uv, 1.0 );

			if ( face == 0.0 ) {

				direction = direction.zyx; // ( 1, v, u ) pos x

			} else if ( face == 1.0 ) {

				direction = direction.xzy;
				direction.xz *= -1.0; // ( -u, 1, -v ) pos y

			} else if ( face == 2.0 ) {

				direction.x *= -1.0; // ( -u, v, 1 ) pos z

			} else if ( face == 3.0 ) {

				direction = direction.zyx;
				direction.xz *= -1.0; // ( -1, v, -u ) neg x

			} else if ( face == 4.0 ) {

				direction = direction.xzy;
				direction.xy *= -1.0; // ( -u, -1, v ) neg y

			} else if ( face == 5.0 ) {

				direction.z *= -1.0; // ( u, v, -1 ) neg z

			}

			return direction;

		}

		void main() {

			vOutputDirection = getDirection( uv, faceIndex );
			gl_Position = vec4( position, 1.0 );

		}
	`}function RM(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===fc||l===dc,u=l===xr||l===Mr;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new tf(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const p=a.image;return c&&p&&p.height>0||u&&p&&s(p)?(e===null&&(e=new tf(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function CM(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&_o("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function PM(i,t,e,n){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const _ in f.attributes)t.remove(f.attributes[_]);f.removeEventListener("dispose",o),delete s[f.id];const p=r.get(f);p&&(t.remove(p),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const p in f)t.update(f[p],i.ARRAY_BUFFER)}function c(h){const f=[],p=h.index,_=h.attributes.position;let x=0;if(p!==null){const w=p.array;x=p.version;for(let T=0,S=w.length;T<S;T+=3){const U=w[T+0],D=w[T+1],N=w[T+2];f.push(U,D,D,N,N,U)}}else if(_!==void 0){const w=_.array;x=_.version;for(let T=0,S=w.length/3-1;T<S;T+=3){const U=T+0,D=T+1,N=T+2;f.push(U,D,D,N,N,U)}}else return;const m=new(Bd(f)?Wd:Gd)(f,1);m.version=x;const d=r.get(h);d&&t.remove(d),r.set(h,m)}function u(h){const f=r.get(h);if(f){const p=h.index;p!==null&&f.version<p.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function DM(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,p){i.drawElements(n,p,r,f*o),e.update(p,n,1)}function c(f,p,_){_!==0&&(i.drawElementsInstanced(n,p,r,f*o,_),e.update(p,n,_))}function u(f,p,_){if(_===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,p,0,r,f,0,_);let m=0;for(let d=0;d<_;d++)m+=p[d];e.update(m,n,1)}function h(f,p,_,x){if(_===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let d=0;d<f.length;d++)c(f[d]/o,p[d],x[d]);else{m.multiDrawElementsInstancedWEBGL(n,p,0,r,f,0,x,0,_);let d=0;for(let w=0;w<_;w++)d+=p[w]*x[w];e.update(d,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function LM(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function UM(i,t,e){const n=new WeakMap,s=new Ye;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=n.get(a);if(f===void 0||f.count!==h){let E=function(){k.dispose(),n.delete(a),a.removeEventListener("dispose",E)};var p=E;f!==void 0&&f.texture.dispose();const _=a.morphAttributes.position!==void 0,x=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,d=a.morphAttributes.position||[],w=a.morphAttributes.normal||[],T=a.morphAttributes.color||[];let S=0;_===!0&&(S=1),x===!0&&(S=2),m===!0&&(S=3);let U=a.attributes.position.count*S,D=1;U>t.maxTextureSize&&(D=Math.ceil(U/t.maxTextureSize),U=t.maxTextureSize);const N=new Float32Array(U*D*4*h),k=new zd(N,U,D,h);k.type=Bi,k.needsUpdate=!0;const b=S*4;for(let C=0;C<h;C++){const G=d[C],H=w[C],$=T[C],W=U*D*4*C;for(let j=0;j<G.count;j++){const Y=j*b;_===!0&&(s.fromBufferAttribute(G,j),N[W+Y+0]=s.x,N[W+Y+1]=s.y,N[W+Y+2]=s.z,N[W+Y+3]=0),x===!0&&(s.fromBufferAttribute(H,j),N[W+Y+4]=s.x,N[W+Y+5]=s.y,N[W+Y+6]=s.z,N[W+Y+7]=0),m===!0&&(s.fromBufferAttribute($,j),N[W+Y+8]=s.x,N[W+Y+9]=s.y,N[W+Y+10]=s.z,N[W+Y+11]=$.itemSize===4?s.w:1)}}f={count:h,texture:k,size:new Rt(U,D)},n.set(a,f),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let _=0;for(let m=0;m<c.length;m++)_+=c[m];const x=a.morphTargetsRelative?1:1-_;l.getUniforms().setValue(i,"morphTargetBaseInfluence",x),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function NM(i,t,e,n){let s=new WeakMap;function r(l){const c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}const up=new xn,rf=new Jd(1,1),fp=new zd,dp=new R_,pp=new qd,of=[],af=[],lf=new Float32Array(16),cf=new Float32Array(9),hf=new Float32Array(4);function Ur(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=of[s];if(r===void 0&&(r=new Float32Array(s),of[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function en(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function nn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Oa(i,t){let e=af[t];e===void 0&&(e=new Int32Array(t),af[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function IM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function FM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2fv(this.addr,t),nn(e,t)}}function OM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(en(e,t))return;i.uniform3fv(this.addr,t),nn(e,t)}}function kM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4fv(this.addr,t),nn(e,t)}}function BM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;hf.set(n),i.uniformMatrix2fv(this.addr,!1,hf),nn(e,n)}}function zM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;cf.set(n),i.uniformMatrix3fv(this.addr,!1,cf),nn(e,n)}}function HM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;lf.set(n),i.uniformMatrix4fv(this.addr,!1,lf),nn(e,n)}}function VM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function GM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2iv(this.addr,t),nn(e,t)}}function WM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3iv(this.addr,t),nn(e,t)}}function XM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4iv(this.addr,t),nn(e,t)}}function YM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function qM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2uiv(this.addr,t),nn(e,t)}}function $M(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3uiv(this.addr,t),nn(e,t)}}function KM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4uiv(this.addr,t),nn(e,t)}}function ZM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(rf.compareFunction=kd,r=rf):r=up,e.setTexture2D(t||r,s)}function jM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||dp,s)}function JM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||pp,s)}function QM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||fp,s)}function tS(i){switch(i){case 5126:return IM;case 35664:return FM;case 35665:return OM;case 35666:return kM;case 35674:return BM;case 35675:return zM;case 35676:return HM;case 5124:case 35670:return VM;case 35667:case 35671:return GM;case 35668:case 35672:return WM;case 35669:case 35673:return XM;case 5125:return YM;case 36294:return qM;case 36295:return $M;case 36296:return KM;case 35678:case 36198:case 36298:case 36306:case 35682:return ZM;case 35679:case 36299:case 36307:return jM;case 35680:case 36300:case 36308:case 36293:return JM;case 36289:case 36303:case 36311:case 36292:return QM}}function eS(i,t){i.uniform1fv(this.addr,t)}function nS(i,t){const e=Ur(t,this.size,2);i.uniform2fv(this.addr,e)}function iS(i,t){const e=Ur(t,this.size,3);i.uniform3fv(this.addr,e)}function sS(i,t){const e=Ur(t,this.size,4);i.uniform4fv(this.addr,e)}function rS(i,t){const e=Ur(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function oS(i,t){const e=Ur(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function aS(i,t){const e=Ur(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function lS(i,t){i.uniform1iv(this.addr,t)}function cS(i,t){i.uniform2iv(this.addr,t)}function hS(i,t){i.uniform3iv(this.addr,t)}function uS(i,t){i.uniform4iv(this.addr,t)}function fS(i,t){i.uniform1uiv(this.addr,t)}function dS(i,t){i.uniform2uiv(this.addr,t)}function pS(i,t){i.uniform3uiv(this.addr,t)}function mS(i,t){i.uniform4uiv(this.addr,t)}function gS(i,t,e){const n=this.cache,s=t.length,r=Oa(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||up,r[o])}function _S(i,t,e){const n=this.cache,s=t.length,r=Oa(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||dp,r[o])}function vS(i,t,e){const n=this.cache,s=t.length,r=Oa(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||pp,r[o])}function xS(i,t,e){const n=this.cache,s=t.length,r=Oa(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||fp,r[o])}function MS(i){switch(i){case 5126:return eS;case 35664:return nS;case 35665:return iS;case 35666:return sS;case 35674:return rS;case 35675:return oS;case 35676:return aS;case 5124:case 35670:return lS;case 35667:case 35671:return cS;case 35668:case 35672:return hS;case 35669:case 35673:return uS;case 5125:return fS;case 36294:return dS;case 36295:return pS;case 36296:return mS;case 35678:case 36198:case 36298:case 36306:case 35682:return gS;case 35679:case 36299:case 36307:return _S;case 35680:case 36300:case 36308:case 36293:return vS;case 36289:case 36303:case 36311:case 36292:return xS}}class SS{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=tS(e.type)}}class yS{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=MS(e.type)}}class ES{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const zl=/(\w+)(\])?(\[|\.)?/g;function uf(i,t){i.seq.push(t),i.map[t.id]=t}function wS(i,t,e){const n=i.name,s=n.length;for(zl.lastIndex=0;;){const r=zl.exec(n),o=zl.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){uf(e,c===void 0?new SS(a,i,t):new yS(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new ES(a),uf(e,h)),e=h}}}class _a{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);wS(r,o,this)}}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function ff(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const TS=37297;let bS=0;function AS(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const df=new ie;function RS(i){pe._getMatrix(df,pe.workingColorSpace,i);const t=`mat3( ${df.elements.map(e=>e.toFixed(4))} )`;switch(pe.getTransfer(i)){case Sa:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function pf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+AS(i.getShaderSource(t),a)}else return r}function CS(i,t){const e=RS(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function PS(i,t){let e;switch(t){case t_:e="Linear";break;case e_:e="Reinhard";break;case n_:e="Cineon";break;case i_:e="ACESFilmic";break;case r_:e="AgX";break;case o_:e="Neutral";break;case s_:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const oa=new z;function DS(){pe.getLuminanceCoefficients(oa);const i=oa.x.toFixed(4),t=oa.y.toFixed(4),e=oa.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function LS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Qr).join(`
`)}function US(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function NS(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Qr(i){return i!==""}function mf(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function gf(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const IS=/^[ \t]*#include +<([\w\d./]+)>/gm;function qc(i){return i.replace(IS,OS)}const FS=new Map;function OS(i,t){let e=re[t];if(e===void 0){const n=FS.get(t);if(n!==void 0)e=re[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return qc(e)}const kS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function _f(i){return i.replace(kS,BS)}function BS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vf(i){let t=`precision ${i.precision} float;
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
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}function zS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Ad?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===Ug?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===Oi&&(t="SHADOWMAP_TYPE_VSM"),t}function HS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case xr:case Mr:t="ENVMAP_TYPE_CUBE";break;case Na:t="ENVMAP_TYPE_CUBE_UV";break}return t}function VS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Mr:t="ENVMAP_MODE_REFRACTION";break}return t}function GS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Rd:t="ENVMAP_BLENDING_MULTIPLY";break;case Jg:t="ENVMAP_BLENDING_MIX";break;case Qg:t="ENVMAP_BLENDING_ADD";break}return t}function WS(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function XS(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=zS(e),c=HS(e),u=VS(e),h=GS(e),f=WS(e),p=LS(e),_=US(r),x=s.createProgram();let m,d,w=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Qr).join(`
`),m.length>0&&(m+=`
`),d=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_].filter(Qr).join(`
`),d.length>0&&(d+=`
`)):(m=[vf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Qr).join(`
`),d=[vf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,_,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==cs?"#define TONE_MAPPING":"",e.toneMapping!==cs?re.tonemapping_pars_fragment:"",e.toneMapping!==cs?PS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",re.colorspace_pars_fragment,CS("linearToOutputTexel",e.outputColorSpace),DS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Qr).join(`
`)),o=qc(o),o=mf(o,e),o=gf(o,e),a=qc(a),a=mf(a,e),a=gf(a,e),o=_f(o),a=_f(a),e.isRawShaderMaterial!==!0&&(w=`#version 300 es
`,m=[p,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,d=["#define varying in",e.glslVersion===xu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===xu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+d);const T=w+m+o,S=w+d+a,U=ff(s,s.VERTEX_SHADER,T),D=ff(s,s.FRAGMENT_SHADER,S);s.attachShader(x,U),s.attachShader(x,D),e.index0AttributeName!==void 0?s.bindAttribLocation(x,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(x,0,"position"),s.linkProgram(x);function N(C){if(i.debug.checkShaderErrors){const G=s.getProgramInfoLog(x)||"",H=s.getShaderInfoLog(U)||"",$=s.getShaderInfoLog(D)||"",W=G.trim(),j=H.trim(),Y=$.trim();let J=!0,ot=!0;if(s.getProgramParameter(x,s.LINK_STATUS)===!1)if(J=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,x,U,D);else{const at=pf(s,U,"vertex"),_t=pf(s,D,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(x,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+W+`
`+at+`
`+_t)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(j===""||Y==="")&&(ot=!1);ot&&(C.diagnostics={runnable:J,programLog:W,vertexShader:{log:j,prefix:m},fragmentShader:{log:Y,prefix:d}})}s.deleteShader(U),s.deleteShader(D),k=new _a(s,x),b=NS(s,x)}let k;this.getUniforms=function(){return k===void 0&&N(this),k};let b;this.getAttributes=function(){return b===void 0&&N(this),b};let E=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return E===!1&&(E=s.getProgramParameter(x,TS)),E},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(x),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=bS++,this.cacheKey=t,this.usedTimes=1,this.program=x,this.vertexShader=U,this.fragmentShader=D,this}let YS=0;class qS{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new $S(t),e.set(t,n)),n}}class $S{constructor(t){this.id=YS++,this.code=t,this.usedTimes=0}}function KS(i,t,e,n,s,r,o){const a=new Hd,l=new qS,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let p=s.precision;const _={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function x(b){return c.add(b),b===0?"uv":`uv${b}`}function m(b,E,C,G,H){const $=G.fog,W=H.geometry,j=b.isMeshStandardMaterial?G.environment:null,Y=(b.isMeshStandardMaterial?e:t).get(b.envMap||j),J=Y&&Y.mapping===Na?Y.image.height:null,ot=_[b.type];b.precision!==null&&(p=s.getMaxPrecision(b.precision),p!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",p,"instead."));const at=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,_t=at!==void 0?at.length:0;let Mt=0;W.morphAttributes.position!==void 0&&(Mt=1),W.morphAttributes.normal!==void 0&&(Mt=2),W.morphAttributes.color!==void 0&&(Mt=3);let gt,ee,jt,Q;if(ot){const ue=yi[ot];gt=ue.vertexShader,ee=ue.fragmentShader}else gt=b.vertexShader,ee=b.fragmentShader,l.update(b),jt=l.getVertexShaderID(b),Q=l.getFragmentShaderID(b);const et=i.getRenderTarget(),Et=i.state.buffers.depth.getReversed(),Bt=H.isInstancedMesh===!0,vt=H.isBatchedMesh===!0,Jt=!!b.map,Le=!!b.matcap,L=!!Y,he=!!b.aoMap,$t=!!b.lightMap,Gt=!!b.bumpMap,Nt=!!b.normalMap,Ee=!!b.displacementMap,Ct=!!b.emissiveMap,Vt=!!b.metalnessMap,Fe=!!b.roughnessMap,_e=b.anisotropy>0,R=b.clearcoat>0,v=b.dispersion>0,I=b.iridescence>0,K=b.sheen>0,nt=b.transmission>0,tt=_e&&!!b.anisotropyMap,It=R&&!!b.clearcoatMap,ht=R&&!!b.clearcoatNormalMap,Dt=R&&!!b.clearcoatRoughnessMap,bt=I&&!!b.iridescenceMap,rt=I&&!!b.iridescenceThicknessMap,mt=K&&!!b.sheenColorMap,kt=K&&!!b.sheenRoughnessMap,Ot=!!b.specularMap,xt=!!b.specularColorMap,Zt=!!b.specularIntensityMap,F=nt&&!!b.transmissionMap,ut=nt&&!!b.thicknessMap,dt=!!b.gradientMap,Pt=!!b.alphaMap,ct=b.alphaTest>0,st=!!b.alphaHash,Ft=!!b.extensions;let Qt=cs;b.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(Qt=i.toneMapping);const Te={shaderID:ot,shaderType:b.type,shaderName:b.name,vertexShader:gt,fragmentShader:ee,defines:b.defines,customVertexShaderID:jt,customFragmentShaderID:Q,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:p,batching:vt,batchingColor:vt&&H._colorsTexture!==null,instancing:Bt,instancingColor:Bt&&H.instanceColor!==null,instancingMorph:Bt&&H.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:et===null?i.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:Sr,alphaToCoverage:!!b.alphaToCoverage,map:Jt,matcap:Le,envMap:L,envMapMode:L&&Y.mapping,envMapCubeUVHeight:J,aoMap:he,lightMap:$t,bumpMap:Gt,normalMap:Nt,displacementMap:f&&Ee,emissiveMap:Ct,normalMapObjectSpace:Nt&&b.normalMapType===u_,normalMapTangentSpace:Nt&&b.normalMapType===h_,metalnessMap:Vt,roughnessMap:Fe,anisotropy:_e,anisotropyMap:tt,clearcoat:R,clearcoatMap:It,clearcoatNormalMap:ht,clearcoatRoughnessMap:Dt,dispersion:v,iridescence:I,iridescenceMap:bt,iridescenceThicknessMap:rt,sheen:K,sheenColorMap:mt,sheenRoughnessMap:kt,specularMap:Ot,specularColorMap:xt,specularIntensityMap:Zt,transmission:nt,transmissionMap:F,thicknessMap:ut,gradientMap:dt,opaque:b.transparent===!1&&b.blending===mr&&b.alphaToCoverage===!1,alphaMap:Pt,alphaTest:ct,alphaHash:st,combine:b.combine,mapUv:Jt&&x(b.map.channel),aoMapUv:he&&x(b.aoMap.channel),lightMapUv:$t&&x(b.lightMap.channel),bumpMapUv:Gt&&x(b.bumpMap.channel),normalMapUv:Nt&&x(b.normalMap.channel),displacementMapUv:Ee&&x(b.displacementMap.channel),emissiveMapUv:Ct&&x(b.emissiveMap.channel),metalnessMapUv:Vt&&x(b.metalnessMap.channel),roughnessMapUv:Fe&&x(b.roughnessMap.channel),anisotropyMapUv:tt&&x(b.anisotropyMap.channel),clearcoatMapUv:It&&x(b.clearcoatMap.channel),clearcoatNormalMapUv:ht&&x(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Dt&&x(b.clearcoatRoughnessMap.channel),iridescenceMapUv:bt&&x(b.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&x(b.iridescenceThicknessMap.channel),sheenColorMapUv:mt&&x(b.sheenColorMap.channel),sheenRoughnessMapUv:kt&&x(b.sheenRoughnessMap.channel),specularMapUv:Ot&&x(b.specularMap.channel),specularColorMapUv:xt&&x(b.specularColorMap.channel),specularIntensityMapUv:Zt&&x(b.specularIntensityMap.channel),transmissionMapUv:F&&x(b.transmissionMap.channel),thicknessMapUv:ut&&x(b.thicknessMap.channel),alphaMapUv:Pt&&x(b.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(Nt||_e),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!W.attributes.uv&&(Jt||Pt),fog:!!$,useFog:b.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:b.flatShading===!0&&b.wireframe===!1,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Et,skinning:H.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:_t,morphTextureStride:Mt,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Qt,decodeVideoTexture:Jt&&b.map.isVideoTexture===!0&&pe.getTransfer(b.map.colorSpace)===Ae,decodeVideoTextureEmissive:Ct&&b.emissiveMap.isVideoTexture===!0&&pe.getTransfer(b.emissiveMap.colorSpace)===Ae,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===Ei,flipSided:b.side===Fn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Ft&&b.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ft&&b.extensions.multiDraw===!0||vt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return Te.vertexUv1s=c.has(1),Te.vertexUv2s=c.has(2),Te.vertexUv3s=c.has(3),c.clear(),Te}function d(b){const E=[];if(b.shaderID?E.push(b.shaderID):(E.push(b.customVertexShaderID),E.push(b.customFragmentShaderID)),b.defines!==void 0)for(const C in b.defines)E.push(C),E.push(b.defines[C]);return b.isRawShaderMaterial===!1&&(w(E,b),T(E,b),E.push(i.outputColorSpace)),E.push(b.customProgramCacheKey),E.join()}function w(b,E){b.push(E.precision),b.push(E.outputColorSpace),b.push(E.envMapMode),b.push(E.envMapCubeUVHeight),b.push(E.mapUv),b.push(E.alphaMapUv),b.push(E.lightMapUv),b.push(E.aoMapUv),b.push(E.bumpMapUv),b.push(E.normalMapUv),b.push(E.displacementMapUv),b.push(E.emissiveMapUv),b.push(E.metalnessMapUv),b.push(E.roughnessMapUv),b.push(E.anisotropyMapUv),b.push(E.clearcoatMapUv),b.push(E.clearcoatNormalMapUv),b.push(E.clearcoatRoughnessMapUv),b.push(E.iridescenceMapUv),b.push(E.iridescenceThicknessMapUv),b.push(E.sheenColorMapUv),b.push(E.sheenRoughnessMapUv),b.push(E.specularMapUv),b.push(E.specularColorMapUv),b.push(E.specularIntensityMapUv),b.push(E.transmissionMapUv),b.push(E.thicknessMapUv),b.push(E.combine),b.push(E.fogExp2),b.push(E.sizeAttenuation),b.push(E.morphTargetsCount),b.push(E.morphAttributeCount),b.push(E.numDirLights),b.push(E.numPointLights),b.push(E.numSpotLights),b.push(E.numSpotLightMaps),b.push(E.numHemiLights),b.push(E.numRectAreaLights),b.push(E.numDirLightShadows),b.push(E.numPointLightShadows),b.push(E.numSpotLightShadows),b.push(E.numSpotLightShadowsWithMaps),b.push(E.numLightProbes),b.push(E.shadowMapType),b.push(E.toneMapping),b.push(E.numClippingPlanes),b.push(E.numClipIntersection),b.push(E.depthPacking)}function T(b,E){a.disableAll(),E.supportsVertexTextures&&a.enable(0),E.instancing&&a.enable(1),E.instancingColor&&a.enable(2),E.instancingMorph&&a.enable(3),E.matcap&&a.enable(4),E.envMap&&a.enable(5),E.normalMapObjectSpace&&a.enable(6),E.normalMapTangentSpace&&a.enable(7),E.clearcoat&&a.enable(8),E.iridescence&&a.enable(9),E.alphaTest&&a.enable(10),E.vertexColors&&a.enable(11),E.vertexAlphas&&a.enable(12),E.vertexUv1s&&a.enable(13),E.vertexUv2s&&a.enable(14),E.vertexUv3s&&a.enable(15),E.vertexTangents&&a.enable(16),E.anisotropy&&a.enable(17),E.alphaHash&&a.enable(18),E.batching&&a.enable(19),E.dispersion&&a.enable(20),E.batchingColor&&a.enable(21),E.gradientMap&&a.enable(22),b.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),b.push(a.mask)}function S(b){const E=_[b.type];let C;if(E){const G=yi[E];C=H_.clone(G.uniforms)}else C=b.uniforms;return C}function U(b,E){let C;for(let G=0,H=u.length;G<H;G++){const $=u[G];if($.cacheKey===E){C=$,++C.usedTimes;break}}return C===void 0&&(C=new XS(i,E,b,r),u.push(C)),C}function D(b){if(--b.usedTimes===0){const E=u.indexOf(b);u[E]=u[u.length-1],u.pop(),b.destroy()}}function N(b){l.remove(b)}function k(){l.dispose()}return{getParameters:m,getProgramCacheKey:d,getUniforms:S,acquireProgram:U,releaseProgram:D,releaseShaderCache:N,programs:u,dispose:k}}function ZS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function jS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function xf(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Mf(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,p,_,x,m){let d=i[t];return d===void 0?(d={id:h.id,object:h,geometry:f,material:p,groupOrder:_,renderOrder:h.renderOrder,z:x,group:m},i[t]=d):(d.id=h.id,d.object=h,d.geometry=f,d.material=p,d.groupOrder=_,d.renderOrder=h.renderOrder,d.z=x,d.group=m),t++,d}function a(h,f,p,_,x,m){const d=o(h,f,p,_,x,m);p.transmission>0?n.push(d):p.transparent===!0?s.push(d):e.push(d)}function l(h,f,p,_,x,m){const d=o(h,f,p,_,x,m);p.transmission>0?n.unshift(d):p.transparent===!0?s.unshift(d):e.unshift(d)}function c(h,f){e.length>1&&e.sort(h||jS),n.length>1&&n.sort(f||xf),s.length>1&&s.sort(f||xf)}function u(){for(let h=t,f=i.length;h<f;h++){const p=i[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function JS(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new Mf,i.set(n,[o])):s>=r.length?(o=new Mf,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function QS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new Me};break;case"SpotLight":e={position:new z,direction:new z,color:new Me,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new Me,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new Me,groundColor:new Me};break;case"RectAreaLight":e={color:new Me,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function ty(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let ey=0;function ny(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function iy(i){const t=new QS,e=ty(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);const s=new z,r=new Xe,o=new Xe;function a(c){let u=0,h=0,f=0;for(let b=0;b<9;b++)n.probe[b].set(0,0,0);let p=0,_=0,x=0,m=0,d=0,w=0,T=0,S=0,U=0,D=0,N=0;c.sort(ny);for(let b=0,E=c.length;b<E;b++){const C=c[b],G=C.color,H=C.intensity,$=C.distance,W=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=G.r*H,h+=G.g*H,f+=G.b*H;else if(C.isLightProbe){for(let j=0;j<9;j++)n.probe[j].addScaledVector(C.sh.coefficients[j],H);N++}else if(C.isDirectionalLight){const j=t.get(C);if(j.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Y=C.shadow,J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,n.directionalShadow[p]=J,n.directionalShadowMap[p]=W,n.directionalShadowMatrix[p]=C.shadow.matrix,w++}n.directional[p]=j,p++}else if(C.isSpotLight){const j=t.get(C);j.position.setFromMatrixPosition(C.matrixWorld),j.color.copy(G).multiplyScalar(H),j.distance=$,j.coneCos=Math.cos(C.angle),j.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),j.decay=C.decay,n.spot[x]=j;const Y=C.shadow;if(C.map&&(n.spotLightMap[U]=C.map,U++,Y.updateMatrices(C),C.castShadow&&D++),n.spotLightMatrix[x]=Y.matrix,C.castShadow){const J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,n.spotShadow[x]=J,n.spotShadowMap[x]=W,S++}x++}else if(C.isRectAreaLight){const j=t.get(C);j.color.copy(G).multiplyScalar(H),j.halfWidth.set(C.width*.5,0,0),j.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=j,m++}else if(C.isPointLight){const j=t.get(C);if(j.color.copy(C.color).multiplyScalar(C.intensity),j.distance=C.distance,j.decay=C.decay,C.castShadow){const Y=C.shadow,J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,J.shadowCameraNear=Y.camera.near,J.shadowCameraFar=Y.camera.far,n.pointShadow[_]=J,n.pointShadowMap[_]=W,n.pointShadowMatrix[_]=C.shadow.matrix,T++}n.point[_]=j,_++}else if(C.isHemisphereLight){const j=t.get(C);j.skyColor.copy(C.color).multiplyScalar(H),j.groundColor.copy(C.groundColor).multiplyScalar(H),n.hemi[d]=j,d++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=yt.LTC_FLOAT_1,n.rectAreaLTC2=yt.LTC_FLOAT_2):(n.rectAreaLTC1=yt.LTC_HALF_1,n.rectAreaLTC2=yt.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;const k=n.hash;(k.directionalLength!==p||k.pointLength!==_||k.spotLength!==x||k.rectAreaLength!==m||k.hemiLength!==d||k.numDirectionalShadows!==w||k.numPointShadows!==T||k.numSpotShadows!==S||k.numSpotMaps!==U||k.numLightProbes!==N)&&(n.directional.length=p,n.spot.length=x,n.rectArea.length=m,n.point.length=_,n.hemi.length=d,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.pointShadow.length=T,n.pointShadowMap.length=T,n.spotShadow.length=S,n.spotShadowMap.length=S,n.directionalShadowMatrix.length=w,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=S+U-D,n.spotLightMap.length=U,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=N,k.directionalLength=p,k.pointLength=_,k.spotLength=x,k.rectAreaLength=m,k.hemiLength=d,k.numDirectionalShadows=w,k.numPointShadows=T,k.numSpotShadows=S,k.numSpotMaps=U,k.numLightProbes=N,n.version=ey++)}function l(c,u){let h=0,f=0,p=0,_=0,x=0;const m=u.matrixWorldInverse;for(let d=0,w=c.length;d<w;d++){const T=c[d];if(T.isDirectionalLight){const S=n.directional[h];S.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),h++}else if(T.isSpotLight){const S=n.spot[p];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(m),S.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),p++}else if(T.isRectAreaLight){const S=n.rectArea[_];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),S.halfWidth.set(T.width*.5,0,0),S.halfHeight.set(0,T.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),_++}else if(T.isPointLight){const S=n.point[f];S.position.setFromMatrixPosition(T.matrixWorld),S.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const S=n.hemi[x];S.direction.setFromMatrixPosition(T.matrixWorld),S.direction.transformDirection(m),x++}}}return{setup:a,setupView:l,state:n}}function Sf(i){const t=new iy(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function sy(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Sf(i),t.set(s,[a])):r>=o.length?(a=new Sf(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}const ry=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,oy=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
#include <packing>
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = unpackRGBATo2Half( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ) );
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = unpackRGBAToDepth( texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ) );
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( squared_mean - mean * mean );
	gl_FragColor = pack2HalfToRGBA( vec2( mean, std_dev ) );
}`;function ay(i,t,e){let n=new Kd;const s=new Rt,r=new Rt,o=new Ye,a=new U0({depthPacking:c_}),l=new N0,c={},u=e.maxTextureSize,h={[hs]:Fn,[Fn]:hs,[Ei]:Ei},f=new Yi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Rt},radius:{value:4}},vertexShader:ry,fragmentShader:oy}),p=f.clone();p.defines.HORIZONTAL_PASS=1;const _=new Pn;_.setAttribute("position",new vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const x=new qn(_,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ad;let d=this.type;this.render=function(D,N,k){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||D.length===0)return;const b=i.getRenderTarget(),E=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Hi),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);const H=d!==Oi&&this.type===Oi,$=d===Oi&&this.type!==Oi;for(let W=0,j=D.length;W<j;W++){const Y=D[W],J=Y.shadow;if(J===void 0){console.warn("THREE.WebGLShadowMap:",Y,"has no shadow.");continue}if(J.autoUpdate===!1&&J.needsUpdate===!1)continue;s.copy(J.mapSize);const ot=J.getFrameExtents();if(s.multiply(ot),r.copy(J.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ot.x),s.x=r.x*ot.x,J.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ot.y),s.y=r.y*ot.y,J.mapSize.y=r.y)),J.map===null||H===!0||$===!0){const _t=this.type!==Oi?{minFilter:On,magFilter:On}:{};J.map!==null&&J.map.dispose(),J.map=new Fs(s.x,s.y,_t),J.map.texture.name=Y.name+".shadowMap",J.camera.updateProjectionMatrix()}i.setRenderTarget(J.map),i.clear();const at=J.getViewportCount();for(let _t=0;_t<at;_t++){const Mt=J.getViewport(_t);o.set(r.x*Mt.x,r.y*Mt.y,r.x*Mt.z,r.y*Mt.w),G.viewport(o),J.updateMatrices(Y,_t),n=J.getFrustum(),S(N,k,J.camera,Y,this.type)}J.isPointLightShadow!==!0&&this.type===Oi&&w(J,k),J.needsUpdate=!1}d=this.type,m.needsUpdate=!1,i.setRenderTarget(b,E,C)};function w(D,N){const k=t.update(x);f.defines.VSM_SAMPLES!==D.blurSamples&&(f.defines.VSM_SAMPLES=D.blurSamples,p.defines.VSM_SAMPLES=D.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),D.mapPass===null&&(D.mapPass=new Fs(s.x,s.y)),f.uniforms.shadow_pass.value=D.map.texture,f.uniforms.resolution.value=D.mapSize,f.uniforms.radius.value=D.radius,i.setRenderTarget(D.mapPass),i.clear(),i.renderBufferDirect(N,null,k,f,x,null),p.uniforms.shadow_pass.value=D.mapPass.texture,p.uniforms.resolution.value=D.mapSize,p.uniforms.radius.value=D.radius,i.setRenderTarget(D.map),i.clear(),i.renderBufferDirect(N,null,k,p,x,null)}function T(D,N,k,b){let E=null;const C=k.isPointLight===!0?D.customDistanceMaterial:D.customDepthMaterial;if(C!==void 0)E=C;else if(E=k.isPointLight===!0?l:a,i.localClippingEnabled&&N.clipShadows===!0&&Array.isArray(N.clippingPlanes)&&N.clippingPlanes.length!==0||N.displacementMap&&N.displacementScale!==0||N.alphaMap&&N.alphaTest>0||N.map&&N.alphaTest>0||N.alphaToCoverage===!0){const G=E.uuid,H=N.uuid;let $=c[G];$===void 0&&($={},c[G]=$);let W=$[H];W===void 0&&(W=E.clone(),$[H]=W,N.addEventListener("dispose",U)),E=W}if(E.visible=N.visible,E.wireframe=N.wireframe,b===Oi?E.side=N.shadowSide!==null?N.shadowSide:N.side:E.side=N.shadowSide!==null?N.shadowSide:h[N.side],E.alphaMap=N.alphaMap,E.alphaTest=N.alphaToCoverage===!0?.5:N.alphaTest,E.map=N.map,E.clipShadows=N.clipShadows,E.clippingPlanes=N.clippingPlanes,E.clipIntersection=N.clipIntersection,E.displacementMap=N.displacementMap,E.displacementScale=N.displacementScale,E.displacementBias=N.displacementBias,E.wireframeLinewidth=N.wireframeLinewidth,E.linewidth=N.linewidth,k.isPointLight===!0&&E.isMeshDistanceMaterial===!0){const G=i.properties.get(E);G.light=k}return E}function S(D,N,k,b,E){if(D.visible===!1)return;if(D.layers.test(N.layers)&&(D.isMesh||D.isLine||D.isPoints)&&(D.castShadow||D.receiveShadow&&E===Oi)&&(!D.frustumCulled||n.intersectsObject(D))){D.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,D.matrixWorld);const H=t.update(D),$=D.material;if(Array.isArray($)){const W=H.groups;for(let j=0,Y=W.length;j<Y;j++){const J=W[j],ot=$[J.materialIndex];if(ot&&ot.visible){const at=T(D,ot,b,E);D.onBeforeShadow(i,D,N,k,H,at,J),i.renderBufferDirect(k,null,H,at,D,J),D.onAfterShadow(i,D,N,k,H,at,J)}}}else if($.visible){const W=T(D,$,b,E);D.onBeforeShadow(i,D,N,k,H,W,null),i.renderBufferDirect(k,null,H,W,D,null),D.onAfterShadow(i,D,N,k,H,W,null)}}const G=D.children;for(let H=0,$=G.length;H<$;H++)S(G[H],N,k,b,E)}function U(D){D.target.removeEventListener("dispose",U);for(const k in c){const b=c[k],E=D.target.uuid;E in b&&(b[E].dispose(),delete b[E])}}}const ly={[rc]:oc,[ac]:hc,[lc]:uc,[vr]:cc,[oc]:rc,[hc]:ac,[uc]:lc,[cc]:vr};function cy(i,t){function e(){let F=!1;const ut=new Ye;let dt=null;const Pt=new Ye(0,0,0,0);return{setMask:function(ct){dt!==ct&&!F&&(i.colorMask(ct,ct,ct,ct),dt=ct)},setLocked:function(ct){F=ct},setClear:function(ct,st,Ft,Qt,Te){Te===!0&&(ct*=Qt,st*=Qt,Ft*=Qt),ut.set(ct,st,Ft,Qt),Pt.equals(ut)===!1&&(i.clearColor(ct,st,Ft,Qt),Pt.copy(ut))},reset:function(){F=!1,dt=null,Pt.set(-1,0,0,0)}}}function n(){let F=!1,ut=!1,dt=null,Pt=null,ct=null;return{setReversed:function(st){if(ut!==st){const Ft=t.get("EXT_clip_control");st?Ft.clipControlEXT(Ft.LOWER_LEFT_EXT,Ft.ZERO_TO_ONE_EXT):Ft.clipControlEXT(Ft.LOWER_LEFT_EXT,Ft.NEGATIVE_ONE_TO_ONE_EXT),ut=st;const Qt=ct;ct=null,this.setClear(Qt)}},getReversed:function(){return ut},setTest:function(st){st?et(i.DEPTH_TEST):Et(i.DEPTH_TEST)},setMask:function(st){dt!==st&&!F&&(i.depthMask(st),dt=st)},setFunc:function(st){if(ut&&(st=ly[st]),Pt!==st){switch(st){case rc:i.depthFunc(i.NEVER);break;case oc:i.depthFunc(i.ALWAYS);break;case ac:i.depthFunc(i.LESS);break;case vr:i.depthFunc(i.LEQUAL);break;case lc:i.depthFunc(i.EQUAL);break;case cc:i.depthFunc(i.GEQUAL);break;case hc:i.depthFunc(i.GREATER);break;case uc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pt=st}},setLocked:function(st){F=st},setClear:function(st){ct!==st&&(ut&&(st=1-st),i.clearDepth(st),ct=st)},reset:function(){F=!1,dt=null,Pt=null,ct=null,ut=!1}}}function s(){let F=!1,ut=null,dt=null,Pt=null,ct=null,st=null,Ft=null,Qt=null,Te=null;return{setTest:function(ue){F||(ue?et(i.STENCIL_TEST):Et(i.STENCIL_TEST))},setMask:function(ue){ut!==ue&&!F&&(i.stencilMask(ue),ut=ue)},setFunc:function(ue,fn,Ce){(dt!==ue||Pt!==fn||ct!==Ce)&&(i.stencilFunc(ue,fn,Ce),dt=ue,Pt=fn,ct=Ce)},setOp:function(ue,fn,Ce){(st!==ue||Ft!==fn||Qt!==Ce)&&(i.stencilOp(ue,fn,Ce),st=ue,Ft=fn,Qt=Ce)},setLocked:function(ue){F=ue},setClear:function(ue){Te!==ue&&(i.clearStencil(ue),Te=ue)},reset:function(){F=!1,ut=null,dt=null,Pt=null,ct=null,st=null,Ft=null,Qt=null,Te=null}}}const r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,p=[],_=null,x=!1,m=null,d=null,w=null,T=null,S=null,U=null,D=null,N=new Me(0,0,0),k=0,b=!1,E=null,C=null,G=null,H=null,$=null;const W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let j=!1,Y=0;const J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(Y=parseFloat(/^WebGL (\d)/.exec(J)[1]),j=Y>=1):J.indexOf("OpenGL ES")!==-1&&(Y=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),j=Y>=2);let ot=null,at={};const _t=i.getParameter(i.SCISSOR_BOX),Mt=i.getParameter(i.VIEWPORT),gt=new Ye().fromArray(_t),ee=new Ye().fromArray(Mt);function jt(F,ut,dt,Pt){const ct=new Uint8Array(4),st=i.createTexture();i.bindTexture(F,st),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ft=0;Ft<dt;Ft++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(ut,0,i.RGBA,1,1,Pt,0,i.RGBA,i.UNSIGNED_BYTE,ct):i.texImage2D(ut+Ft,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ct);return st}const Q={};Q[i.TEXTURE_2D]=jt(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=jt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[i.TEXTURE_2D_ARRAY]=jt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=jt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),et(i.DEPTH_TEST),o.setFunc(vr),Gt(!1),Nt(du),et(i.CULL_FACE),he(Hi);function et(F){u[F]!==!0&&(i.enable(F),u[F]=!0)}function Et(F){u[F]!==!1&&(i.disable(F),u[F]=!1)}function Bt(F,ut){return h[F]!==ut?(i.bindFramebuffer(F,ut),h[F]=ut,F===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ut),F===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ut),!0):!1}function vt(F,ut){let dt=p,Pt=!1;if(F){dt=f.get(ut),dt===void 0&&(dt=[],f.set(ut,dt));const ct=F.textures;if(dt.length!==ct.length||dt[0]!==i.COLOR_ATTACHMENT0){for(let st=0,Ft=ct.length;st<Ft;st++)dt[st]=i.COLOR_ATTACHMENT0+st;dt.length=ct.length,Pt=!0}}else dt[0]!==i.BACK&&(dt[0]=i.BACK,Pt=!0);Pt&&i.drawBuffers(dt)}function Jt(F){return _!==F?(i.useProgram(F),_=F,!0):!1}const Le={[As]:i.FUNC_ADD,[Ig]:i.FUNC_SUBTRACT,[Fg]:i.FUNC_REVERSE_SUBTRACT};Le[Og]=i.MIN,Le[kg]=i.MAX;const L={[Bg]:i.ZERO,[zg]:i.ONE,[Hg]:i.SRC_COLOR,[ic]:i.SRC_ALPHA,[qg]:i.SRC_ALPHA_SATURATE,[Xg]:i.DST_COLOR,[Gg]:i.DST_ALPHA,[Vg]:i.ONE_MINUS_SRC_COLOR,[sc]:i.ONE_MINUS_SRC_ALPHA,[Yg]:i.ONE_MINUS_DST_COLOR,[Wg]:i.ONE_MINUS_DST_ALPHA,[$g]:i.CONSTANT_COLOR,[Kg]:i.ONE_MINUS_CONSTANT_COLOR,[Zg]:i.CONSTANT_ALPHA,[jg]:i.ONE_MINUS_CONSTANT_ALPHA};function he(F,ut,dt,Pt,ct,st,Ft,Qt,Te,ue){if(F===Hi){x===!0&&(Et(i.BLEND),x=!1);return}if(x===!1&&(et(i.BLEND),x=!0),F!==Ng){if(F!==m||ue!==b){if((d!==As||S!==As)&&(i.blendEquation(i.FUNC_ADD),d=As,S=As),ue)switch(F){case mr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pu:i.blendFunc(i.ONE,i.ONE);break;case mu:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case gu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}else switch(F){case mr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case pu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case mu:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case gu:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}w=null,T=null,U=null,D=null,N.set(0,0,0),k=0,m=F,b=ue}return}ct=ct||ut,st=st||dt,Ft=Ft||Pt,(ut!==d||ct!==S)&&(i.blendEquationSeparate(Le[ut],Le[ct]),d=ut,S=ct),(dt!==w||Pt!==T||st!==U||Ft!==D)&&(i.blendFuncSeparate(L[dt],L[Pt],L[st],L[Ft]),w=dt,T=Pt,U=st,D=Ft),(Qt.equals(N)===!1||Te!==k)&&(i.blendColor(Qt.r,Qt.g,Qt.b,Te),N.copy(Qt),k=Te),m=F,b=!1}function $t(F,ut){F.side===Ei?Et(i.CULL_FACE):et(i.CULL_FACE);let dt=F.side===Fn;ut&&(dt=!dt),Gt(dt),F.blending===mr&&F.transparent===!1?he(Hi):he(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);const Pt=F.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Ct(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?et(i.SAMPLE_ALPHA_TO_COVERAGE):Et(i.SAMPLE_ALPHA_TO_COVERAGE)}function Gt(F){E!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),E=F)}function Nt(F){F!==Dg?(et(i.CULL_FACE),F!==C&&(F===du?i.cullFace(i.BACK):F===Lg?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Et(i.CULL_FACE),C=F}function Ee(F){F!==G&&(j&&i.lineWidth(F),G=F)}function Ct(F,ut,dt){F?(et(i.POLYGON_OFFSET_FILL),(H!==ut||$!==dt)&&(i.polygonOffset(ut,dt),H=ut,$=dt)):Et(i.POLYGON_OFFSET_FILL)}function Vt(F){F?et(i.SCISSOR_TEST):Et(i.SCISSOR_TEST)}function Fe(F){F===void 0&&(F=i.TEXTURE0+W-1),ot!==F&&(i.activeTexture(F),ot=F)}function _e(F,ut,dt){dt===void 0&&(ot===null?dt=i.TEXTURE0+W-1:dt=ot);let Pt=at[dt];Pt===void 0&&(Pt={type:void 0,texture:void 0},at[dt]=Pt),(Pt.type!==F||Pt.texture!==ut)&&(ot!==dt&&(i.activeTexture(dt),ot=dt),i.bindTexture(F,ut||Q[F]),Pt.type=F,Pt.texture=ut)}function R(){const F=at[ot];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function v(){try{i.compressedTexImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function I(){try{i.compressedTexImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function K(){try{i.texSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function nt(){try{i.texSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function tt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function It(){try{i.compressedTexSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function ht(){try{i.texStorage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Dt(){try{i.texStorage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function bt(){try{i.texImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function rt(){try{i.texImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function mt(F){gt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),gt.copy(F))}function kt(F){ee.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),ee.copy(F))}function Ot(F,ut){let dt=c.get(ut);dt===void 0&&(dt=new WeakMap,c.set(ut,dt));let Pt=dt.get(F);Pt===void 0&&(Pt=i.getUniformBlockIndex(ut,F.name),dt.set(F,Pt))}function xt(F,ut){const Pt=c.get(ut).get(F);l.get(ut)!==Pt&&(i.uniformBlockBinding(ut,Pt,F.__bindingPointIndex),l.set(ut,Pt))}function Zt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},ot=null,at={},h={},f=new WeakMap,p=[],_=null,x=!1,m=null,d=null,w=null,T=null,S=null,U=null,D=null,N=new Me(0,0,0),k=0,b=!1,E=null,C=null,G=null,H=null,$=null,gt.set(0,0,i.canvas.width,i.canvas.height),ee.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:et,disable:Et,bindFramebuffer:Bt,drawBuffers:vt,useProgram:Jt,setBlending:he,setMaterial:$t,setFlipSided:Gt,setCullFace:Nt,setLineWidth:Ee,setPolygonOffset:Ct,setScissorTest:Vt,activeTexture:Fe,bindTexture:_e,unbindTexture:R,compressedTexImage2D:v,compressedTexImage3D:I,texImage2D:bt,texImage3D:rt,updateUBOMapping:Ot,uniformBlockBinding:xt,texStorage2D:ht,texStorage3D:Dt,texSubImage2D:K,texSubImage3D:nt,compressedTexSubImage2D:tt,compressedTexSubImage3D:It,scissor:mt,viewport:kt,reset:Zt}}function hy(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Rt,u=new WeakMap;let h;const f=new WeakMap;let p=!1;try{p=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(R,v){return p?new OffscreenCanvas(R,v):Ea("canvas")}function x(R,v,I){let K=1;const nt=_e(R);if((nt.width>I||nt.height>I)&&(K=I/Math.max(nt.width,nt.height)),K<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const tt=Math.floor(K*nt.width),It=Math.floor(K*nt.height);h===void 0&&(h=_(tt,It));const ht=v?_(tt,It):h;return ht.width=tt,ht.height=It,ht.getContext("2d").drawImage(R,0,0,tt,It),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+tt+"x"+It+")."),ht}else return"data"in R&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),R;return R}function m(R){return R.generateMipmaps}function d(R){i.generateMipmap(R)}function w(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(R,v,I,K,nt=!1){if(R!==null){if(i[R]!==void 0)return i[R];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let tt=v;if(v===i.RED&&(I===i.FLOAT&&(tt=i.R32F),I===i.HALF_FLOAT&&(tt=i.R16F),I===i.UNSIGNED_BYTE&&(tt=i.R8)),v===i.RED_INTEGER&&(I===i.UNSIGNED_BYTE&&(tt=i.R8UI),I===i.UNSIGNED_SHORT&&(tt=i.R16UI),I===i.UNSIGNED_INT&&(tt=i.R32UI),I===i.BYTE&&(tt=i.R8I),I===i.SHORT&&(tt=i.R16I),I===i.INT&&(tt=i.R32I)),v===i.RG&&(I===i.FLOAT&&(tt=i.RG32F),I===i.HALF_FLOAT&&(tt=i.RG16F),I===i.UNSIGNED_BYTE&&(tt=i.RG8)),v===i.RG_INTEGER&&(I===i.UNSIGNED_BYTE&&(tt=i.RG8UI),I===i.UNSIGNED_SHORT&&(tt=i.RG16UI),I===i.UNSIGNED_INT&&(tt=i.RG32UI),I===i.BYTE&&(tt=i.RG8I),I===i.SHORT&&(tt=i.RG16I),I===i.INT&&(tt=i.RG32I)),v===i.RGB_INTEGER&&(I===i.UNSIGNED_BYTE&&(tt=i.RGB8UI),I===i.UNSIGNED_SHORT&&(tt=i.RGB16UI),I===i.UNSIGNED_INT&&(tt=i.RGB32UI),I===i.BYTE&&(tt=i.RGB8I),I===i.SHORT&&(tt=i.RGB16I),I===i.INT&&(tt=i.RGB32I)),v===i.RGBA_INTEGER&&(I===i.UNSIGNED_BYTE&&(tt=i.RGBA8UI),I===i.UNSIGNED_SHORT&&(tt=i.RGBA16UI),I===i.UNSIGNED_INT&&(tt=i.RGBA32UI),I===i.BYTE&&(tt=i.RGBA8I),I===i.SHORT&&(tt=i.RGBA16I),I===i.INT&&(tt=i.RGBA32I)),v===i.RGB&&(I===i.UNSIGNED_INT_5_9_9_9_REV&&(tt=i.RGB9_E5),I===i.UNSIGNED_INT_10F_11F_11F_REV&&(tt=i.R11F_G11F_B10F)),v===i.RGBA){const It=nt?Sa:pe.getTransfer(K);I===i.FLOAT&&(tt=i.RGBA32F),I===i.HALF_FLOAT&&(tt=i.RGBA16F),I===i.UNSIGNED_BYTE&&(tt=It===Ae?i.SRGB8_ALPHA8:i.RGBA8),I===i.UNSIGNED_SHORT_4_4_4_4&&(tt=i.RGBA4),I===i.UNSIGNED_SHORT_5_5_5_1&&(tt=i.RGB5_A1)}return(tt===i.R16F||tt===i.R32F||tt===i.RG16F||tt===i.RG32F||tt===i.RGBA16F||tt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function S(R,v){let I;return R?v===null||v===Ns||v===po?I=i.DEPTH24_STENCIL8:v===Bi?I=i.DEPTH32F_STENCIL8:v===fo&&(I=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===Ns||v===po?I=i.DEPTH_COMPONENT24:v===Bi?I=i.DEPTH_COMPONENT32F:v===fo&&(I=i.DEPTH_COMPONENT16),I}function U(R,v){return m(R)===!0||R.isFramebufferTexture&&R.minFilter!==On&&R.minFilter!==wi?Math.log2(Math.max(v.width,v.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?v.mipmaps.length:1}function D(R){const v=R.target;v.removeEventListener("dispose",D),k(v),v.isVideoTexture&&u.delete(v)}function N(R){const v=R.target;v.removeEventListener("dispose",N),E(v)}function k(R){const v=n.get(R);if(v.__webglInit===void 0)return;const I=R.source,K=f.get(I);if(K){const nt=K[v.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&b(R),Object.keys(K).length===0&&f.delete(I)}n.remove(R)}function b(R){const v=n.get(R);i.deleteTexture(v.__webglTexture);const I=R.source,K=f.get(I);delete K[v.__cacheKey],o.memory.textures--}function E(R){const v=n.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),n.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(v.__webglFramebuffer[K]))for(let nt=0;nt<v.__webglFramebuffer[K].length;nt++)i.deleteFramebuffer(v.__webglFramebuffer[K][nt]);else i.deleteFramebuffer(v.__webglFramebuffer[K]);v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer[K])}else{if(Array.isArray(v.__webglFramebuffer))for(let K=0;K<v.__webglFramebuffer.length;K++)i.deleteFramebuffer(v.__webglFramebuffer[K]);else i.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&i.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&i.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let K=0;K<v.__webglColorRenderbuffer.length;K++)v.__webglColorRenderbuffer[K]&&i.deleteRenderbuffer(v.__webglColorRenderbuffer[K]);v.__webglDepthRenderbuffer&&i.deleteRenderbuffer(v.__webglDepthRenderbuffer)}const I=R.textures;for(let K=0,nt=I.length;K<nt;K++){const tt=n.get(I[K]);tt.__webglTexture&&(i.deleteTexture(tt.__webglTexture),o.memory.textures--),n.remove(I[K])}n.remove(R)}let C=0;function G(){C=0}function H(){const R=C;return R>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),C+=1,R}function $(R){const v=[];return v.push(R.wrapS),v.push(R.wrapT),v.push(R.wrapR||0),v.push(R.magFilter),v.push(R.minFilter),v.push(R.anisotropy),v.push(R.internalFormat),v.push(R.format),v.push(R.type),v.push(R.generateMipmaps),v.push(R.premultiplyAlpha),v.push(R.flipY),v.push(R.unpackAlignment),v.push(R.colorSpace),v.join()}function W(R,v){const I=n.get(R);if(R.isVideoTexture&&Vt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&I.__version!==R.version){const K=R.image;if(K===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(K.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(I,R,v);return}}else R.isExternalTexture&&(I.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,I.__webglTexture,i.TEXTURE0+v)}function j(R,v){const I=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&I.__version!==R.version){Q(I,R,v);return}e.bindTexture(i.TEXTURE_2D_ARRAY,I.__webglTexture,i.TEXTURE0+v)}function Y(R,v){const I=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&I.__version!==R.version){Q(I,R,v);return}e.bindTexture(i.TEXTURE_3D,I.__webglTexture,i.TEXTURE0+v)}function J(R,v){const I=n.get(R);if(R.version>0&&I.__version!==R.version){et(I,R,v);return}e.bindTexture(i.TEXTURE_CUBE_MAP,I.__webglTexture,i.TEXTURE0+v)}const ot={[Ma]:i.REPEAT,[Ds]:i.CLAMP_TO_EDGE,[pc]:i.MIRRORED_REPEAT},at={[On]:i.NEAREST,[a_]:i.NEAREST_MIPMAP_NEAREST,[Uo]:i.NEAREST_MIPMAP_LINEAR,[wi]:i.LINEAR,[al]:i.LINEAR_MIPMAP_NEAREST,[Ls]:i.LINEAR_MIPMAP_LINEAR},_t={[f_]:i.NEVER,[v_]:i.ALWAYS,[d_]:i.LESS,[kd]:i.LEQUAL,[p_]:i.EQUAL,[__]:i.GEQUAL,[m_]:i.GREATER,[g_]:i.NOTEQUAL};function Mt(R,v){if(v.type===Bi&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===wi||v.magFilter===al||v.magFilter===Uo||v.magFilter===Ls||v.minFilter===wi||v.minFilter===al||v.minFilter===Uo||v.minFilter===Ls)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,ot[v.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,ot[v.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,ot[v.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,at[v.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,at[v.minFilter]),v.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,_t[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===On||v.minFilter!==Uo&&v.minFilter!==Ls||v.type===Bi&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||n.get(v).__currentAnisotropy){const I=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,I.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),n.get(v).__currentAnisotropy=v.anisotropy}}}function gt(R,v){let I=!1;R.__webglInit===void 0&&(R.__webglInit=!0,v.addEventListener("dispose",D));const K=v.source;let nt=f.get(K);nt===void 0&&(nt={},f.set(K,nt));const tt=$(v);if(tt!==R.__cacheKey){nt[tt]===void 0&&(nt[tt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,I=!0),nt[tt].usedTimes++;const It=nt[R.__cacheKey];It!==void 0&&(nt[R.__cacheKey].usedTimes--,It.usedTimes===0&&b(v)),R.__cacheKey=tt,R.__webglTexture=nt[tt].texture}return I}function ee(R,v,I){return Math.floor(Math.floor(R/I)/v)}function jt(R,v,I,K){const tt=R.updateRanges;if(tt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,v.width,v.height,I,K,v.data);else{tt.sort((rt,mt)=>rt.start-mt.start);let It=0;for(let rt=1;rt<tt.length;rt++){const mt=tt[It],kt=tt[rt],Ot=mt.start+mt.count,xt=ee(kt.start,v.width,4),Zt=ee(mt.start,v.width,4);kt.start<=Ot+1&&xt===Zt&&ee(kt.start+kt.count-1,v.width,4)===xt?mt.count=Math.max(mt.count,kt.start+kt.count-mt.start):(++It,tt[It]=kt)}tt.length=It+1;const ht=i.getParameter(i.UNPACK_ROW_LENGTH),Dt=i.getParameter(i.UNPACK_SKIP_PIXELS),bt=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,v.width);for(let rt=0,mt=tt.length;rt<mt;rt++){const kt=tt[rt],Ot=Math.floor(kt.start/4),xt=Math.ceil(kt.count/4),Zt=Ot%v.width,F=Math.floor(Ot/v.width),ut=xt,dt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Zt),i.pixelStorei(i.UNPACK_SKIP_ROWS,F),e.texSubImage2D(i.TEXTURE_2D,0,Zt,F,ut,dt,I,K,v.data)}R.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ht),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Dt),i.pixelStorei(i.UNPACK_SKIP_ROWS,bt)}}function Q(R,v,I){let K=i.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(K=i.TEXTURE_2D_ARRAY),v.isData3DTexture&&(K=i.TEXTURE_3D);const nt=gt(R,v),tt=v.source;e.bindTexture(K,R.__webglTexture,i.TEXTURE0+I);const It=n.get(tt);if(tt.version!==It.__version||nt===!0){e.activeTexture(i.TEXTURE0+I);const ht=pe.getPrimaries(pe.workingColorSpace),Dt=v.colorSpace===as?null:pe.getPrimaries(v.colorSpace),bt=v.colorSpace===as||ht===Dt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,bt);let rt=x(v.image,!1,s.maxTextureSize);rt=Fe(v,rt);const mt=r.convert(v.format,v.colorSpace),kt=r.convert(v.type);let Ot=T(v.internalFormat,mt,kt,v.colorSpace,v.isVideoTexture);Mt(K,v);let xt;const Zt=v.mipmaps,F=v.isVideoTexture!==!0,ut=It.__version===void 0||nt===!0,dt=tt.dataReady,Pt=U(v,rt);if(v.isDepthTexture)Ot=S(v.format===go,v.type),ut&&(F?e.texStorage2D(i.TEXTURE_2D,1,Ot,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,Ot,rt.width,rt.height,0,mt,kt,null));else if(v.isDataTexture)if(Zt.length>0){F&&ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,Zt[0].width,Zt[0].height);for(let ct=0,st=Zt.length;ct<st;ct++)xt=Zt[ct],F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,kt,xt.data):e.texImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,mt,kt,xt.data);v.generateMipmaps=!1}else F?(ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,rt.width,rt.height),dt&&jt(v,rt,mt,kt)):e.texImage2D(i.TEXTURE_2D,0,Ot,rt.width,rt.height,0,mt,kt,rt.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){F&&ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Pt,Ot,Zt[0].width,Zt[0].height,rt.depth);for(let ct=0,st=Zt.length;ct<st;ct++)if(xt=Zt[ct],v.format!==si)if(mt!==null)if(F){if(dt)if(v.layerUpdates.size>0){const Ft=Zu(xt.width,xt.height,v.format,v.type);for(const Qt of v.layerUpdates){const Te=xt.data.subarray(Qt*Ft/xt.data.BYTES_PER_ELEMENT,(Qt+1)*Ft/xt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,Qt,xt.width,xt.height,1,mt,Te)}v.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,xt.width,xt.height,rt.depth,mt,xt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,Ot,xt.width,xt.height,rt.depth,0,xt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else F?dt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,xt.width,xt.height,rt.depth,mt,kt,xt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,Ot,xt.width,xt.height,rt.depth,0,mt,kt,xt.data)}else{F&&ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,Zt[0].width,Zt[0].height);for(let ct=0,st=Zt.length;ct<st;ct++)xt=Zt[ct],v.format!==si?mt!==null?F?dt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,xt.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,xt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,kt,xt.data):e.texImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,mt,kt,xt.data)}else if(v.isDataArrayTexture)if(F){if(ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Pt,Ot,rt.width,rt.height,rt.depth),dt)if(v.layerUpdates.size>0){const ct=Zu(rt.width,rt.height,v.format,v.type);for(const st of v.layerUpdates){const Ft=rt.data.subarray(st*ct/rt.data.BYTES_PER_ELEMENT,(st+1)*ct/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,st,rt.width,rt.height,1,mt,kt,Ft)}v.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,mt,kt,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ot,rt.width,rt.height,rt.depth,0,mt,kt,rt.data);else if(v.isData3DTexture)F?(ut&&e.texStorage3D(i.TEXTURE_3D,Pt,Ot,rt.width,rt.height,rt.depth),dt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,mt,kt,rt.data)):e.texImage3D(i.TEXTURE_3D,0,Ot,rt.width,rt.height,rt.depth,0,mt,kt,rt.data);else if(v.isFramebufferTexture){if(ut)if(F)e.texStorage2D(i.TEXTURE_2D,Pt,Ot,rt.width,rt.height);else{let ct=rt.width,st=rt.height;for(let Ft=0;Ft<Pt;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,Ot,ct,st,0,mt,kt,null),ct>>=1,st>>=1}}else if(Zt.length>0){if(F&&ut){const ct=_e(Zt[0]);e.texStorage2D(i.TEXTURE_2D,Pt,Ot,ct.width,ct.height)}for(let ct=0,st=Zt.length;ct<st;ct++)xt=Zt[ct],F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,mt,kt,xt):e.texImage2D(i.TEXTURE_2D,ct,Ot,mt,kt,xt);v.generateMipmaps=!1}else if(F){if(ut){const ct=_e(rt);e.texStorage2D(i.TEXTURE_2D,Pt,Ot,ct.width,ct.height)}dt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,kt,rt)}else e.texImage2D(i.TEXTURE_2D,0,Ot,mt,kt,rt);m(v)&&d(K),It.__version=tt.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function et(R,v,I){if(v.image.length!==6)return;const K=gt(R,v),nt=v.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+I);const tt=n.get(nt);if(nt.version!==tt.__version||K===!0){e.activeTexture(i.TEXTURE0+I);const It=pe.getPrimaries(pe.workingColorSpace),ht=v.colorSpace===as?null:pe.getPrimaries(v.colorSpace),Dt=v.colorSpace===as||It===ht?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,v.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,v.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Dt);const bt=v.isCompressedTexture||v.image[0].isCompressedTexture,rt=v.image[0]&&v.image[0].isDataTexture,mt=[];for(let st=0;st<6;st++)!bt&&!rt?mt[st]=x(v.image[st],!0,s.maxCubemapSize):mt[st]=rt?v.image[st].image:v.image[st],mt[st]=Fe(v,mt[st]);const kt=mt[0],Ot=r.convert(v.format,v.colorSpace),xt=r.convert(v.type),Zt=T(v.internalFormat,Ot,xt,v.colorSpace),F=v.isVideoTexture!==!0,ut=tt.__version===void 0||K===!0,dt=nt.dataReady;let Pt=U(v,kt);Mt(i.TEXTURE_CUBE_MAP,v);let ct;if(bt){F&&ut&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,Zt,kt.width,kt.height);for(let st=0;st<6;st++){ct=mt[st].mipmaps;for(let Ft=0;Ft<ct.length;Ft++){const Qt=ct[Ft];v.format!==si?Ot!==null?F?dt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,0,0,Qt.width,Qt.height,Ot,Qt.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,Zt,Qt.width,Qt.height,0,Qt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,0,0,Qt.width,Qt.height,Ot,xt,Qt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,Zt,Qt.width,Qt.height,0,Ot,xt,Qt.data)}}}else{if(ct=v.mipmaps,F&&ut){ct.length>0&&Pt++;const st=_e(mt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,Zt,st.width,st.height)}for(let st=0;st<6;st++)if(rt){F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,mt[st].width,mt[st].height,Ot,xt,mt[st].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Zt,mt[st].width,mt[st].height,0,Ot,xt,mt[st].data);for(let Ft=0;Ft<ct.length;Ft++){const Te=ct[Ft].image[st].image;F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,0,0,Te.width,Te.height,Ot,xt,Te.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,Zt,Te.width,Te.height,0,Ot,xt,Te.data)}}else{F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,Ot,xt,mt[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Zt,Ot,xt,mt[st]);for(let Ft=0;Ft<ct.length;Ft++){const Qt=ct[Ft];F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,0,0,Ot,xt,Qt.image[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,Zt,Ot,xt,Qt.image[st])}}}m(v)&&d(i.TEXTURE_CUBE_MAP),tt.__version=nt.version,v.onUpdate&&v.onUpdate(v)}R.__version=v.version}function Et(R,v,I,K,nt,tt){const It=r.convert(I.format,I.colorSpace),ht=r.convert(I.type),Dt=T(I.internalFormat,It,ht,I.colorSpace),bt=n.get(v),rt=n.get(I);if(rt.__renderTarget=v,!bt.__hasExternalTextures){const mt=Math.max(1,v.width>>tt),kt=Math.max(1,v.height>>tt);nt===i.TEXTURE_3D||nt===i.TEXTURE_2D_ARRAY?e.texImage3D(nt,tt,Dt,mt,kt,v.depth,0,It,ht,null):e.texImage2D(nt,tt,Dt,mt,kt,0,It,ht,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Ct(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,K,nt,rt.__webglTexture,0,Ee(v)):(nt===i.TEXTURE_2D||nt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,K,nt,rt.__webglTexture,tt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Bt(R,v,I){if(i.bindRenderbuffer(i.RENDERBUFFER,R),v.depthBuffer){const K=v.depthTexture,nt=K&&K.isDepthTexture?K.type:null,tt=S(v.stencilBuffer,nt),It=v.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=Ee(v);Ct(v)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht,tt,v.width,v.height):I?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht,tt,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,tt,v.width,v.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,It,i.RENDERBUFFER,R)}else{const K=v.textures;for(let nt=0;nt<K.length;nt++){const tt=K[nt],It=r.convert(tt.format,tt.colorSpace),ht=r.convert(tt.type),Dt=T(tt.internalFormat,It,ht,tt.colorSpace),bt=Ee(v);I&&Ct(v)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,bt,Dt,v.width,v.height):Ct(v)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,bt,Dt,v.width,v.height):i.renderbufferStorage(i.RENDERBUFFER,Dt,v.width,v.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function vt(R,v){if(v&&v.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const K=n.get(v.depthTexture);K.__renderTarget=v,(!K.__webglTexture||v.depthTexture.image.width!==v.width||v.depthTexture.image.height!==v.height)&&(v.depthTexture.image.width=v.width,v.depthTexture.image.height=v.height,v.depthTexture.needsUpdate=!0),W(v.depthTexture,0);const nt=K.__webglTexture,tt=Ee(v);if(v.depthTexture.format===mo)Ct(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0);else if(v.depthTexture.format===go)Ct(v)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0);else throw new Error("Unknown depthTexture format")}function Jt(R){const v=n.get(R),I=R.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==R.depthTexture){const K=R.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),K){const nt=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,K.removeEventListener("dispose",nt)};K.addEventListener("dispose",nt),v.__depthDisposeCallback=nt}v.__boundDepthTexture=K}if(R.depthTexture&&!v.__autoAllocateDepthBuffer){if(I)throw new Error("target.depthTexture not supported in Cube render targets");const K=R.texture.mipmaps;K&&K.length>0?vt(v.__webglFramebuffer[0],R):vt(v.__webglFramebuffer,R)}else if(I){v.__webglDepthbuffer=[];for(let K=0;K<6;K++)if(e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[K]),v.__webglDepthbuffer[K]===void 0)v.__webglDepthbuffer[K]=i.createRenderbuffer(),Bt(v.__webglDepthbuffer[K],R,!1);else{const nt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=v.__webglDepthbuffer[K];i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,tt)}}else{const K=R.texture.mipmaps;if(K&&K.length>0?e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=i.createRenderbuffer(),Bt(v.__webglDepthbuffer,R,!1);else{const nt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=v.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,tt)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Le(R,v,I){const K=n.get(R);v!==void 0&&Et(K.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),I!==void 0&&Jt(R)}function L(R){const v=R.texture,I=n.get(R),K=n.get(v);R.addEventListener("dispose",N);const nt=R.textures,tt=R.isWebGLCubeRenderTarget===!0,It=nt.length>1;if(It||(K.__webglTexture===void 0&&(K.__webglTexture=i.createTexture()),K.__version=v.version,o.memory.textures++),tt){I.__webglFramebuffer=[];for(let ht=0;ht<6;ht++)if(v.mipmaps&&v.mipmaps.length>0){I.__webglFramebuffer[ht]=[];for(let Dt=0;Dt<v.mipmaps.length;Dt++)I.__webglFramebuffer[ht][Dt]=i.createFramebuffer()}else I.__webglFramebuffer[ht]=i.createFramebuffer()}else{if(v.mipmaps&&v.mipmaps.length>0){I.__webglFramebuffer=[];for(let ht=0;ht<v.mipmaps.length;ht++)I.__webglFramebuffer[ht]=i.createFramebuffer()}else I.__webglFramebuffer=i.createFramebuffer();if(It)for(let ht=0,Dt=nt.length;ht<Dt;ht++){const bt=n.get(nt[ht]);bt.__webglTexture===void 0&&(bt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Ct(R)===!1){I.__webglMultisampledFramebuffer=i.createFramebuffer(),I.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,I.__webglMultisampledFramebuffer);for(let ht=0;ht<nt.length;ht++){const Dt=nt[ht];I.__webglColorRenderbuffer[ht]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,I.__webglColorRenderbuffer[ht]);const bt=r.convert(Dt.format,Dt.colorSpace),rt=r.convert(Dt.type),mt=T(Dt.internalFormat,bt,rt,Dt.colorSpace,R.isXRRenderTarget===!0),kt=Ee(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,kt,mt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ht,i.RENDERBUFFER,I.__webglColorRenderbuffer[ht])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(I.__webglDepthRenderbuffer=i.createRenderbuffer(),Bt(I.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(tt){e.bindTexture(i.TEXTURE_CUBE_MAP,K.__webglTexture),Mt(i.TEXTURE_CUBE_MAP,v);for(let ht=0;ht<6;ht++)if(v.mipmaps&&v.mipmaps.length>0)for(let Dt=0;Dt<v.mipmaps.length;Dt++)Et(I.__webglFramebuffer[ht][Dt],R,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,Dt);else Et(I.__webglFramebuffer[ht],R,v,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,0);m(v)&&d(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(It){for(let ht=0,Dt=nt.length;ht<Dt;ht++){const bt=nt[ht],rt=n.get(bt);let mt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(mt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(mt,rt.__webglTexture),Mt(mt,bt),Et(I.__webglFramebuffer,R,bt,i.COLOR_ATTACHMENT0+ht,mt,0),m(bt)&&d(mt)}e.unbindTexture()}else{let ht=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ht=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ht,K.__webglTexture),Mt(ht,v),v.mipmaps&&v.mipmaps.length>0)for(let Dt=0;Dt<v.mipmaps.length;Dt++)Et(I.__webglFramebuffer[Dt],R,v,i.COLOR_ATTACHMENT0,ht,Dt);else Et(I.__webglFramebuffer,R,v,i.COLOR_ATTACHMENT0,ht,0);m(v)&&d(ht),e.unbindTexture()}R.depthBuffer&&Jt(R)}function he(R){const v=R.textures;for(let I=0,K=v.length;I<K;I++){const nt=v[I];if(m(nt)){const tt=w(R),It=n.get(nt).__webglTexture;e.bindTexture(tt,It),d(tt),e.unbindTexture()}}}const $t=[],Gt=[];function Nt(R){if(R.samples>0){if(Ct(R)===!1){const v=R.textures,I=R.width,K=R.height;let nt=i.COLOR_BUFFER_BIT;const tt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,It=n.get(R),ht=v.length>1;if(ht)for(let bt=0;bt<v.length;bt++)e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,It.__webglMultisampledFramebuffer);const Dt=R.texture.mipmaps;Dt&&Dt.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglFramebuffer);for(let bt=0;bt<v.length;bt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(nt|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(nt|=i.STENCIL_BUFFER_BIT)),ht){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,It.__webglColorRenderbuffer[bt]);const rt=n.get(v[bt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,rt,0)}i.blitFramebuffer(0,0,I,K,0,0,I,K,nt,i.NEAREST),l===!0&&($t.length=0,Gt.length=0,$t.push(i.COLOR_ATTACHMENT0+bt),R.depthBuffer&&R.resolveDepthBuffer===!1&&($t.push(tt),Gt.push(tt),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Gt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,$t))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ht)for(let bt=0;bt<v.length;bt++){e.bindFramebuffer(i.FRAMEBUFFER,It.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,It.__webglColorRenderbuffer[bt]);const rt=n.get(v[bt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,It.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,rt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,It.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){const v=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[v])}}}function Ee(R){return Math.min(s.maxSamples,R.samples)}function Ct(R){const v=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Vt(R){const v=o.render.frame;u.get(R)!==v&&(u.set(R,v),R.update())}function Fe(R,v){const I=R.colorSpace,K=R.format,nt=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||I!==Sr&&I!==as&&(pe.getTransfer(I)===Ae?(K!==si||nt!==bi)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",I)),v}function _e(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=G,this.setTexture2D=W,this.setTexture2DArray=j,this.setTexture3D=Y,this.setTextureCube=J,this.rebindTextures=Le,this.setupRenderTarget=L,this.updateRenderTargetMipmap=he,this.updateMultisampleRenderTarget=Nt,this.setupDepthRenderbuffer=Jt,this.setupFrameBufferTexture=Et,this.useMultisampledRTT=Ct}function uy(i,t){function e(n,s=as){let r;const o=pe.getTransfer(s);if(n===bi)return i.UNSIGNED_BYTE;if(n===hh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===uh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Ld)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Ud)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===Pd)return i.BYTE;if(n===Dd)return i.SHORT;if(n===fo)return i.UNSIGNED_SHORT;if(n===ch)return i.INT;if(n===Ns)return i.UNSIGNED_INT;if(n===Bi)return i.FLOAT;if(n===yo)return i.HALF_FLOAT;if(n===Nd)return i.ALPHA;if(n===Id)return i.RGB;if(n===si)return i.RGBA;if(n===mo)return i.DEPTH_COMPONENT;if(n===go)return i.DEPTH_STENCIL;if(n===Fd)return i.RED;if(n===fh)return i.RED_INTEGER;if(n===Od)return i.RG;if(n===dh)return i.RG_INTEGER;if(n===ph)return i.RGBA_INTEGER;if(n===fa||n===da||n===pa||n===ma)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===fa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===da)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===pa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===ma)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===fa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===da)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===pa)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===ma)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===mc||n===gc||n===_c||n===vc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===mc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===gc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===_c)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===vc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===xc||n===Mc||n===Sc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===xc||n===Mc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Sc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===yc||n===Ec||n===wc||n===Tc||n===bc||n===Ac||n===Rc||n===Cc||n===Pc||n===Dc||n===Lc||n===Uc||n===Nc||n===Ic)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===yc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Ec)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===wc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Tc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Dc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Uc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Fc||n===Oc||n===kc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Fc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===Oc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===kc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Bc||n===zc||n===Hc||n===Vc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Bc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===zc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Hc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Vc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===po?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}const fy=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,dy=`
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

}`;class py{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){const n=new Qd(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new Yi({vertexShader:fy,fragmentShader:dy,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new qn(new Fa(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class my extends Bs{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,p=null,_=null;const x=typeof XRWebGLBinding<"u",m=new py,d={},w=e.getContextAttributes();let T=null,S=null;const U=[],D=[],N=new Rt;let k=null;const b=new Yn;b.viewport=new Ye;const E=new Yn;E.viewport=new Ye;const C=[b,E],G=new I0;let H=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let et=U[Q];return et===void 0&&(et=new Cl,U[Q]=et),et.getTargetRaySpace()},this.getControllerGrip=function(Q){let et=U[Q];return et===void 0&&(et=new Cl,U[Q]=et),et.getGripSpace()},this.getHand=function(Q){let et=U[Q];return et===void 0&&(et=new Cl,U[Q]=et),et.getHandSpace()};function W(Q){const et=D.indexOf(Q.inputSource);if(et===-1)return;const Et=U[et];Et!==void 0&&(Et.update(Q.inputSource,Q.frame,c||o),Et.dispatchEvent({type:Q.type,data:Q.inputSource}))}function j(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",j),s.removeEventListener("inputsourceschange",Y);for(let Q=0;Q<U.length;Q++){const et=D[Q];et!==null&&(D[Q]=null,U[Q].disconnect(et))}H=null,$=null,m.reset();for(const Q in d)delete d[Q];t.setRenderTarget(T),p=null,f=null,h=null,s=null,S=null,jt.stop(),n.isPresenting=!1,t.setPixelRatio(k),t.setSize(N.width,N.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return h===null&&x&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return _},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",j),s.addEventListener("inputsourceschange",Y),w.xrCompatible!==!0&&await e.makeXRCompatible(),k=t.getPixelRatio(),t.getSize(N),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let Et=null,Bt=null,vt=null;w.depth&&(vt=w.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Et=w.stencil?go:mo,Bt=w.stencil?po:Ns);const Jt={colorFormat:e.RGBA8,depthFormat:vt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Jt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),S=new Fs(f.textureWidth,f.textureHeight,{format:si,type:bi,depthTexture:new Jd(f.textureWidth,f.textureHeight,Bt,void 0,void 0,void 0,void 0,void 0,void 0,Et),stencilBuffer:w.stencil,colorSpace:t.outputColorSpace,samples:w.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{const Et={antialias:w.antialias,alpha:!0,depth:w.depth,stencil:w.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,Et),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),S=new Fs(p.framebufferWidth,p.framebufferHeight,{format:si,type:bi,colorSpace:t.outputColorSpace,stencilBuffer:w.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),jt.setContext(s),jt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Y(Q){for(let et=0;et<Q.removed.length;et++){const Et=Q.removed[et],Bt=D.indexOf(Et);Bt>=0&&(D[Bt]=null,U[Bt].disconnect(Et))}for(let et=0;et<Q.added.length;et++){const Et=Q.added[et];let Bt=D.indexOf(Et);if(Bt===-1){for(let Jt=0;Jt<U.length;Jt++)if(Jt>=D.length){D.push(Et),Bt=Jt;break}else if(D[Jt]===null){D[Jt]=Et,Bt=Jt;break}if(Bt===-1)break}const vt=U[Bt];vt&&vt.connect(Et)}}const J=new z,ot=new z;function at(Q,et,Et){J.setFromMatrixPosition(et.matrixWorld),ot.setFromMatrixPosition(Et.matrixWorld);const Bt=J.distanceTo(ot),vt=et.projectionMatrix.elements,Jt=Et.projectionMatrix.elements,Le=vt[14]/(vt[10]-1),L=vt[14]/(vt[10]+1),he=(vt[9]+1)/vt[5],$t=(vt[9]-1)/vt[5],Gt=(vt[8]-1)/vt[0],Nt=(Jt[8]+1)/Jt[0],Ee=Le*Gt,Ct=Le*Nt,Vt=Bt/(-Gt+Nt),Fe=Vt*-Gt;if(et.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Fe),Q.translateZ(Vt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),vt[10]===-1)Q.projectionMatrix.copy(et.projectionMatrix),Q.projectionMatrixInverse.copy(et.projectionMatrixInverse);else{const _e=Le+Vt,R=L+Vt,v=Ee-Fe,I=Ct+(Bt-Fe),K=he*L/R*_e,nt=$t*L/R*_e;Q.projectionMatrix.makePerspective(v,I,K,nt,_e,R),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function _t(Q,et){et===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(et.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let et=Q.near,Et=Q.far;m.texture!==null&&(m.depthNear>0&&(et=m.depthNear),m.depthFar>0&&(Et=m.depthFar)),G.near=E.near=b.near=et,G.far=E.far=b.far=Et,(H!==G.near||$!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),H=G.near,$=G.far),G.layers.mask=Q.layers.mask|6,b.layers.mask=G.layers.mask&3,E.layers.mask=G.layers.mask&5;const Bt=Q.parent,vt=G.cameras;_t(G,Bt);for(let Jt=0;Jt<vt.length;Jt++)_t(vt[Jt],Bt);vt.length===2?at(G,b,E):G.projectionMatrix.copy(b.projectionMatrix),Mt(Q,G,Bt)};function Mt(Q,et,Et){Et===null?Q.matrix.copy(et.matrixWorld):(Q.matrix.copy(Et.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(et.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(et.projectionMatrix),Q.projectionMatrixInverse.copy(et.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Gc*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(Q){return d[Q]};let gt=null;function ee(Q,et){if(u=et.getViewerPose(c||o),_=et,u!==null){const Et=u.views;p!==null&&(t.setRenderTargetFramebuffer(S,p.framebuffer),t.setRenderTarget(S));let Bt=!1;Et.length!==G.cameras.length&&(G.cameras.length=0,Bt=!0);for(let L=0;L<Et.length;L++){const he=Et[L];let $t=null;if(p!==null)$t=p.getViewport(he);else{const Nt=h.getViewSubImage(f,he);$t=Nt.viewport,L===0&&(t.setRenderTargetTextures(S,Nt.colorTexture,Nt.depthStencilTexture),t.setRenderTarget(S))}let Gt=C[L];Gt===void 0&&(Gt=new Yn,Gt.layers.enable(L),Gt.viewport=new Ye,C[L]=Gt),Gt.matrix.fromArray(he.transform.matrix),Gt.matrix.decompose(Gt.position,Gt.quaternion,Gt.scale),Gt.projectionMatrix.fromArray(he.projectionMatrix),Gt.projectionMatrixInverse.copy(Gt.projectionMatrix).invert(),Gt.viewport.set($t.x,$t.y,$t.width,$t.height),L===0&&(G.matrix.copy(Gt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Bt===!0&&G.cameras.push(Gt)}const vt=s.enabledFeatures;if(vt&&vt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){h=n.getBinding();const L=h.getDepthInformation(Et[0]);L&&L.isValid&&L.texture&&m.init(L,s.renderState)}if(vt&&vt.includes("camera-access")&&x){t.state.unbindTexture(),h=n.getBinding();for(let L=0;L<Et.length;L++){const he=Et[L].camera;if(he){let $t=d[he];$t||($t=new Qd,d[he]=$t);const Gt=h.getCameraImage(he);$t.sourceTexture=Gt}}}}for(let Et=0;Et<U.length;Et++){const Bt=D[Et],vt=U[Et];Bt!==null&&vt!==void 0&&vt.update(Bt,et,c||o)}gt&&gt(Q,et),et.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:et}),_=null}const jt=new hp;jt.setAnimationLoop(ee),this.setAnimationLoop=function(Q){gt=Q},this.dispose=function(){}}}const Es=new Xi,gy=new Xe;function _y(i,t){function e(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function n(m,d){d.color.getRGB(m.fogColor.value,Xd(i)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,w,T,S){d.isMeshBasicMaterial||d.isMeshLambertMaterial?r(m,d):d.isMeshToonMaterial?(r(m,d),h(m,d)):d.isMeshPhongMaterial?(r(m,d),u(m,d)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,S)):d.isMeshMatcapMaterial?(r(m,d),_(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),x(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,w,T):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,e(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===Fn&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,e(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===Fn&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,e(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,e(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);const w=t.get(d),T=w.envMap,S=w.envMapRotation;T&&(m.envMap.value=T,Es.copy(S),Es.x*=-1,Es.y*=-1,Es.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Es.y*=-1,Es.z*=-1),m.envMapRotation.value.setFromMatrix4(gy.makeRotationFromEuler(Es)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,w,T){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*w,m.scale.value=T*.5,d.map&&(m.map.value=d.map,e(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function u(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function h(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,w){m.ior.value=d.ior,d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===Fn&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=d.iridescenceThicknessRange[1],d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=w.texture,m.transmissionSamplerSize.value.set(w.width,w.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,m.specularIntensityMapTransform))}function _(m,d){d.matcap&&(m.matcap.value=d.matcap)}function x(m,d){const w=t.get(d).light;m.referencePosition.value.setFromMatrixPosition(w.matrixWorld),m.nearDistance.value=w.shadow.camera.near,m.farDistance.value=w.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function vy(i,t,e,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(w,T){const S=T.program;n.uniformBlockBinding(w,S)}function c(w,T){let S=s[w.id];S===void 0&&(_(w),S=u(w),s[w.id]=S,w.addEventListener("dispose",m));const U=T.program;n.updateUBOMapping(w,U);const D=t.render.frame;r[w.id]!==D&&(f(w),r[w.id]=D)}function u(w){const T=h();w.__bindingPointIndex=T;const S=i.createBuffer(),U=w.__size,D=w.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,U,D),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,S),S}function h(){for(let w=0;w<a;w++)if(o.indexOf(w)===-1)return o.push(w),w;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(w){const T=s[w.id],S=w.uniforms,U=w.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let D=0,N=S.length;D<N;D++){const k=Array.isArray(S[D])?S[D]:[S[D]];for(let b=0,E=k.length;b<E;b++){const C=k[b];if(p(C,D,b,U)===!0){const G=C.__offset,H=Array.isArray(C.value)?C.value:[C.value];let $=0;for(let W=0;W<H.length;W++){const j=H[W],Y=x(j);typeof j=="number"||typeof j=="boolean"?(C.__data[0]=j,i.bufferSubData(i.UNIFORM_BUFFER,G+$,C.__data)):j.isMatrix3?(C.__data[0]=j.elements[0],C.__data[1]=j.elements[1],C.__data[2]=j.elements[2],C.__data[3]=0,C.__data[4]=j.elements[3],C.__data[5]=j.elements[4],C.__data[6]=j.elements[5],C.__data[7]=0,C.__data[8]=j.elements[6],C.__data[9]=j.elements[7],C.__data[10]=j.elements[8],C.__data[11]=0):(j.toArray(C.__data,$),$+=Y.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,G,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function p(w,T,S,U){const D=w.value,N=T+"_"+S;if(U[N]===void 0)return typeof D=="number"||typeof D=="boolean"?U[N]=D:U[N]=D.clone(),!0;{const k=U[N];if(typeof D=="number"||typeof D=="boolean"){if(k!==D)return U[N]=D,!0}else if(k.equals(D)===!1)return k.copy(D),!0}return!1}function _(w){const T=w.uniforms;let S=0;const U=16;for(let N=0,k=T.length;N<k;N++){const b=Array.isArray(T[N])?T[N]:[T[N]];for(let E=0,C=b.length;E<C;E++){const G=b[E],H=Array.isArray(G.value)?G.value:[G.value];for(let $=0,W=H.length;$<W;$++){const j=H[$],Y=x(j),J=S%U,ot=J%Y.boundary,at=J+ot;S+=ot,at!==0&&U-at<Y.storage&&(S+=U-at),G.__data=new Float32Array(Y.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=S,S+=Y.storage}}}const D=S%U;return D>0&&(S+=U-D),w.__size=S,w.__cache={},this}function x(w){const T={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(T.boundary=4,T.storage=4):w.isVector2?(T.boundary=8,T.storage=8):w.isVector3||w.isColor?(T.boundary=16,T.storage=12):w.isVector4?(T.boundary=16,T.storage=16):w.isMatrix3?(T.boundary=48,T.storage=48):w.isMatrix4?(T.boundary=64,T.storage=64):w.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",w),T}function m(w){const T=w.target;T.removeEventListener("dispose",m);const S=o.indexOf(T.__bindingPointIndex);o.splice(S,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function d(){for(const w in s)i.deleteBuffer(s[w]);o=[],s={},r={}}return{bind:l,update:c,dispose:d}}class mp{constructor(t={}){const{canvas:e=S_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;const _=new Uint32Array(4),x=new Int32Array(4);let m=null,d=null;const w=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=cs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const S=this;let U=!1;this._outputColorSpace=Xn;let D=0,N=0,k=null,b=-1,E=null;const C=new Ye,G=new Ye;let H=null;const $=new Me(0);let W=0,j=e.width,Y=e.height,J=1,ot=null,at=null;const _t=new Ye(0,0,j,Y),Mt=new Ye(0,0,j,Y);let gt=!1;const ee=new Kd;let jt=!1,Q=!1;const et=new Xe,Et=new z,Bt=new Ye,vt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function Le(){return k===null?J:1}let L=n;function he(y,B){return e.getContext(y,B)}try{const y={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${lh}`),e.addEventListener("webglcontextlost",dt,!1),e.addEventListener("webglcontextrestored",Pt,!1),e.addEventListener("webglcontextcreationerror",ct,!1),L===null){const B="webgl2";if(L=he(B,y),L===null)throw he(B)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(y){throw console.error("THREE.WebGLRenderer: "+y.message),y}let $t,Gt,Nt,Ee,Ct,Vt,Fe,_e,R,v,I,K,nt,tt,It,ht,Dt,bt,rt,mt,kt,Ot,xt,Zt;function F(){$t=new CM(L),$t.init(),Ot=new uy(L,$t),Gt=new yM(L,$t,t,Ot),Nt=new cy(L,$t),Gt.reversedDepthBuffer&&f&&Nt.buffers.depth.setReversed(!0),Ee=new LM(L),Ct=new ZS,Vt=new hy(L,$t,Nt,Ct,Gt,Ot,Ee),Fe=new wM(S),_e=new RM(S),R=new k0(L),xt=new MM(L,R),v=new PM(L,R,Ee,xt),I=new NM(L,v,R,Ee),rt=new UM(L,Gt,Vt),ht=new EM(Ct),K=new KS(S,Fe,_e,$t,Gt,xt,ht),nt=new _y(S,Ct),tt=new JS,It=new sy($t),bt=new xM(S,Fe,_e,Nt,I,p,l),Dt=new ay(S,I,Gt),Zt=new vy(L,Ee,Gt,Nt),mt=new SM(L,$t,Ee),kt=new DM(L,$t,Ee),Ee.programs=K.programs,S.capabilities=Gt,S.extensions=$t,S.properties=Ct,S.renderLists=tt,S.shadowMap=Dt,S.state=Nt,S.info=Ee}F();const ut=new my(S,L);this.xr=ut,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){const y=$t.get("WEBGL_lose_context");y&&y.loseContext()},this.forceContextRestore=function(){const y=$t.get("WEBGL_lose_context");y&&y.restoreContext()},this.getPixelRatio=function(){return J},this.setPixelRatio=function(y){y!==void 0&&(J=y,this.setSize(j,Y,!1))},this.getSize=function(y){return y.set(j,Y)},this.setSize=function(y,B,Z=!0){if(ut.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}j=y,Y=B,e.width=Math.floor(y*J),e.height=Math.floor(B*J),Z===!0&&(e.style.width=y+"px",e.style.height=B+"px"),this.setViewport(0,0,y,B)},this.getDrawingBufferSize=function(y){return y.set(j*J,Y*J).floor()},this.setDrawingBufferSize=function(y,B,Z){j=y,Y=B,J=Z,e.width=Math.floor(y*Z),e.height=Math.floor(B*Z),this.setViewport(0,0,y,B)},this.getCurrentViewport=function(y){return y.copy(C)},this.getViewport=function(y){return y.copy(_t)},this.setViewport=function(y,B,Z,q){y.isVector4?_t.set(y.x,y.y,y.z,y.w):_t.set(y,B,Z,q),Nt.viewport(C.copy(_t).multiplyScalar(J).round())},this.getScissor=function(y){return y.copy(Mt)},this.setScissor=function(y,B,Z,q){y.isVector4?Mt.set(y.x,y.y,y.z,y.w):Mt.set(y,B,Z,q),Nt.scissor(G.copy(Mt).multiplyScalar(J).round())},this.getScissorTest=function(){return gt},this.setScissorTest=function(y){Nt.setScissorTest(gt=y)},this.setOpaqueSort=function(y){ot=y},this.setTransparentSort=function(y){at=y},this.getClearColor=function(y){return y.copy(bt.getClearColor())},this.setClearColor=function(){bt.setClearColor(...arguments)},this.getClearAlpha=function(){return bt.getClearAlpha()},this.setClearAlpha=function(){bt.setClearAlpha(...arguments)},this.clear=function(y=!0,B=!0,Z=!0){let q=0;if(y){let V=!1;if(k!==null){const ft=k.texture.format;V=ft===ph||ft===dh||ft===fh}if(V){const ft=k.texture.type,St=ft===bi||ft===Ns||ft===fo||ft===po||ft===hh||ft===uh,Lt=bt.getClearColor(),wt=bt.getClearAlpha(),Xt=Lt.r,qt=Lt.g,zt=Lt.b;St?(_[0]=Xt,_[1]=qt,_[2]=zt,_[3]=wt,L.clearBufferuiv(L.COLOR,0,_)):(x[0]=Xt,x[1]=qt,x[2]=zt,x[3]=wt,L.clearBufferiv(L.COLOR,0,x))}else q|=L.COLOR_BUFFER_BIT}B&&(q|=L.DEPTH_BUFFER_BIT),Z&&(q|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",dt,!1),e.removeEventListener("webglcontextrestored",Pt,!1),e.removeEventListener("webglcontextcreationerror",ct,!1),bt.dispose(),tt.dispose(),It.dispose(),Ct.dispose(),Fe.dispose(),_e.dispose(),I.dispose(),xt.dispose(),Zt.dispose(),K.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Ce),ut.removeEventListener("sessionend",kn),Dn.stop()};function dt(y){y.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function Pt(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;const y=Ee.autoReset,B=Dt.enabled,Z=Dt.autoUpdate,q=Dt.needsUpdate,V=Dt.type;F(),Ee.autoReset=y,Dt.enabled=B,Dt.autoUpdate=Z,Dt.needsUpdate=q,Dt.type=V}function ct(y){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",y.statusMessage)}function st(y){const B=y.target;B.removeEventListener("dispose",st),Ft(B)}function Ft(y){Qt(y),Ct.remove(y)}function Qt(y){const B=Ct.get(y).programs;B!==void 0&&(B.forEach(function(Z){K.releaseProgram(Z)}),y.isShaderMaterial&&K.releaseShaderCache(y))}this.renderBufferDirect=function(y,B,Z,q,V,ft){B===null&&(B=vt);const St=V.isMesh&&V.matrixWorld.determinant()<0,Lt=Ci(y,B,Z,q,V);Nt.setMaterial(q,St);let wt=Z.index,Xt=1;if(q.wireframe===!0){if(wt=v.getWireframeAttribute(Z),wt===void 0)return;Xt=2}const qt=Z.drawRange,zt=Z.attributes.position;let se=qt.start*Xt,fe=(qt.start+qt.count)*Xt;ft!==null&&(se=Math.max(se,ft.start*Xt),fe=Math.min(fe,(ft.start+ft.count)*Xt)),wt!==null?(se=Math.max(se,0),fe=Math.min(fe,wt.count)):zt!=null&&(se=Math.max(se,0),fe=Math.min(fe,zt.count));const Ue=fe-se;if(Ue<0||Ue===1/0)return;xt.setup(V,q,Lt,Z,wt);let we,ne=mt;if(wt!==null&&(we=R.get(wt),ne=kt,ne.setIndex(we)),V.isMesh)q.wireframe===!0?(Nt.setLineWidth(q.wireframeLinewidth*Le()),ne.setMode(L.LINES)):ne.setMode(L.TRIANGLES);else if(V.isLine){let Wt=q.linewidth;Wt===void 0&&(Wt=1),Nt.setLineWidth(Wt*Le()),V.isLineSegments?ne.setMode(L.LINES):V.isLineLoop?ne.setMode(L.LINE_LOOP):ne.setMode(L.LINE_STRIP)}else V.isPoints?ne.setMode(L.POINTS):V.isSprite&&ne.setMode(L.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)_o("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ne.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if($t.get("WEBGL_multi_draw"))ne.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{const Wt=V._multiDrawStarts,Ne=V._multiDrawCounts,le=V._multiDrawCount,mn=wt?R.get(wt).bytesPerElement:1,qi=Ct.get(q).currentProgram.getUniforms();for(let Sn=0;Sn<le;Sn++)qi.setValue(L,"_gl_DrawID",Sn),ne.render(Wt[Sn]/mn,Ne[Sn])}else if(V.isInstancedMesh)ne.renderInstances(se,Ue,V.count);else if(Z.isInstancedBufferGeometry){const Wt=Z._maxInstanceCount!==void 0?Z._maxInstanceCount:1/0,Ne=Math.min(Z.instanceCount,Wt);ne.renderInstances(se,Ue,Ne)}else ne.render(se,Ue)};function Te(y,B,Z){y.transparent===!0&&y.side===Ei&&y.forceSinglePass===!1?(y.side=Fn,y.needsUpdate=!0,fs(y,B,Z),y.side=hs,y.needsUpdate=!0,fs(y,B,Z),y.side=Ei):fs(y,B,Z)}this.compile=function(y,B,Z=null){Z===null&&(Z=y),d=It.get(Z),d.init(B),T.push(d),Z.traverseVisible(function(V){V.isLight&&V.layers.test(B.layers)&&(d.pushLight(V),V.castShadow&&d.pushShadow(V))}),y!==Z&&y.traverseVisible(function(V){V.isLight&&V.layers.test(B.layers)&&(d.pushLight(V),V.castShadow&&d.pushShadow(V))}),d.setupLights();const q=new Set;return y.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;const ft=V.material;if(ft)if(Array.isArray(ft))for(let St=0;St<ft.length;St++){const Lt=ft[St];Te(Lt,Z,V),q.add(Lt)}else Te(ft,Z,V),q.add(ft)}),d=T.pop(),q},this.compileAsync=function(y,B,Z=null){const q=this.compile(y,B,Z);return new Promise(V=>{function ft(){if(q.forEach(function(St){Ct.get(St).currentProgram.isReady()&&q.delete(St)}),q.size===0){V(y);return}setTimeout(ft,10)}$t.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let ue=null;function fn(y){ue&&ue(y)}function Ce(){Dn.stop()}function kn(){Dn.start()}const Dn=new hp;Dn.setAnimationLoop(fn),typeof self<"u"&&Dn.setContext(self),this.setAnimationLoop=function(y){ue=y,ut.setAnimationLoop(y),y===null?Dn.stop():Dn.start()},ut.addEventListener("sessionstart",Ce),ut.addEventListener("sessionend",kn),this.render=function(y,B){if(B!==void 0&&B.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(y.matrixWorldAutoUpdate===!0&&y.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(B),B=ut.getCamera()),y.isScene===!0&&y.onBeforeRender(S,y,B,k),d=It.get(y,T.length),d.init(B),T.push(d),et.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),ee.setFromProjectionMatrix(et,Ti,B.reversedDepth),Q=this.localClippingEnabled,jt=ht.init(this.clippingPlanes,Q),m=tt.get(y,w.length),m.init(),w.push(m),ut.enabled===!0&&ut.isPresenting===!0){const ft=S.xr.getDepthSensingMesh();ft!==null&&mi(ft,B,-1/0,S.sortObjects)}mi(y,B,0,S.sortObjects),m.finish(),S.sortObjects===!0&&m.sort(ot,at),Jt=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Jt&&bt.addToRenderList(m,y),this.info.render.frame++,jt===!0&&ht.beginShadows();const Z=d.state.shadowsArray;Dt.render(Z,y,B),jt===!0&&ht.endShadows(),this.info.autoReset===!0&&this.info.reset();const q=m.opaque,V=m.transmissive;if(d.setupLights(),B.isArrayCamera){const ft=B.cameras;if(V.length>0)for(let St=0,Lt=ft.length;St<Lt;St++){const wt=ft[St];Ri(q,V,y,wt)}Jt&&bt.render(y);for(let St=0,Lt=ft.length;St<Lt;St++){const wt=ft[St];Mn(m,y,wt,wt.viewport)}}else V.length>0&&Ri(q,V,y,B),Jt&&bt.render(y),Mn(m,y,B);k!==null&&N===0&&(Vt.updateMultisampleRenderTarget(k),Vt.updateRenderTargetMipmap(k)),y.isScene===!0&&y.onAfterRender(S,y,B),xt.resetDefaultState(),b=-1,E=null,T.pop(),T.length>0?(d=T[T.length-1],jt===!0&&ht.setGlobalState(S.clippingPlanes,d.state.camera)):d=null,w.pop(),w.length>0?m=w[w.length-1]:m=null};function mi(y,B,Z,q){if(y.visible===!1)return;if(y.layers.test(B.layers)){if(y.isGroup)Z=y.renderOrder;else if(y.isLOD)y.autoUpdate===!0&&y.update(B);else if(y.isLight)d.pushLight(y),y.castShadow&&d.pushShadow(y);else if(y.isSprite){if(!y.frustumCulled||ee.intersectsSprite(y)){q&&Bt.setFromMatrixPosition(y.matrixWorld).applyMatrix4(et);const St=I.update(y),Lt=y.material;Lt.visible&&m.push(y,St,Lt,Z,Bt.z,null)}}else if((y.isMesh||y.isLine||y.isPoints)&&(!y.frustumCulled||ee.intersectsObject(y))){const St=I.update(y),Lt=y.material;if(q&&(y.boundingSphere!==void 0?(y.boundingSphere===null&&y.computeBoundingSphere(),Bt.copy(y.boundingSphere.center)):(St.boundingSphere===null&&St.computeBoundingSphere(),Bt.copy(St.boundingSphere.center)),Bt.applyMatrix4(y.matrixWorld).applyMatrix4(et)),Array.isArray(Lt)){const wt=St.groups;for(let Xt=0,qt=wt.length;Xt<qt;Xt++){const zt=wt[Xt],se=Lt[zt.materialIndex];se&&se.visible&&m.push(y,St,se,Z,Bt.z,zt)}}else Lt.visible&&m.push(y,St,Lt,Z,Bt.z,null)}}const ft=y.children;for(let St=0,Lt=ft.length;St<Lt;St++)mi(ft[St],B,Z,q)}function Mn(y,B,Z,q){const V=y.opaque,ft=y.transmissive,St=y.transparent;d.setupLightsView(Z),jt===!0&&ht.setGlobalState(S.clippingPlanes,Z),q&&Nt.viewport(C.copy(q)),V.length>0&&ri(V,B,Z),ft.length>0&&ri(ft,B,Z),St.length>0&&ri(St,B,Z),Nt.buffers.depth.setTest(!0),Nt.buffers.depth.setMask(!0),Nt.buffers.color.setMask(!0),Nt.setPolygonOffset(!1)}function Ri(y,B,Z,q){if((Z.isScene===!0?Z.overrideMaterial:null)!==null)return;d.state.transmissionRenderTarget[q.id]===void 0&&(d.state.transmissionRenderTarget[q.id]=new Fs(1,1,{generateMipmaps:!0,type:$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float")?yo:bi,minFilter:Ls,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:pe.workingColorSpace}));const ft=d.state.transmissionRenderTarget[q.id],St=q.viewport||C;ft.setSize(St.z*S.transmissionResolutionScale,St.w*S.transmissionResolutionScale);const Lt=S.getRenderTarget(),wt=S.getActiveCubeFace(),Xt=S.getActiveMipmapLevel();S.setRenderTarget(ft),S.getClearColor($),W=S.getClearAlpha(),W<1&&S.setClearColor(16777215,.5),S.clear(),Jt&&bt.render(Z);const qt=S.toneMapping;S.toneMapping=cs;const zt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),d.setupLightsView(q),jt===!0&&ht.setGlobalState(S.clippingPlanes,q),ri(y,Z,q),Vt.updateMultisampleRenderTarget(ft),Vt.updateRenderTargetMipmap(ft),$t.has("WEBGL_multisampled_render_to_texture")===!1){let se=!1;for(let fe=0,Ue=B.length;fe<Ue;fe++){const we=B[fe],ne=we.object,Wt=we.geometry,Ne=we.material,le=we.group;if(Ne.side===Ei&&ne.layers.test(q.layers)){const mn=Ne.side;Ne.side=Fn,Ne.needsUpdate=!0,Or(ne,Z,q,Wt,Ne,le),Ne.side=mn,Ne.needsUpdate=!0,se=!0}}se===!0&&(Vt.updateMultisampleRenderTarget(ft),Vt.updateRenderTargetMipmap(ft))}S.setRenderTarget(Lt,wt,Xt),S.setClearColor($,W),zt!==void 0&&(q.viewport=zt),S.toneMapping=qt}function ri(y,B,Z){const q=B.isScene===!0?B.overrideMaterial:null;for(let V=0,ft=y.length;V<ft;V++){const St=y[V],Lt=St.object,wt=St.geometry,Xt=St.group;let qt=St.material;qt.allowOverride===!0&&q!==null&&(qt=q),Lt.layers.test(Z.layers)&&Or(Lt,B,Z,wt,qt,Xt)}}function Or(y,B,Z,q,V,ft){y.onBeforeRender(S,B,Z,q,V,ft),y.modelViewMatrix.multiplyMatrices(Z.matrixWorldInverse,y.matrixWorld),y.normalMatrix.getNormalMatrix(y.modelViewMatrix),V.onBeforeRender(S,B,Z,q,y,ft),V.transparent===!0&&V.side===Ei&&V.forceSinglePass===!1?(V.side=Fn,V.needsUpdate=!0,S.renderBufferDirect(Z,B,q,V,y,ft),V.side=hs,V.needsUpdate=!0,S.renderBufferDirect(Z,B,q,V,y,ft),V.side=Ei):S.renderBufferDirect(Z,B,q,V,y,ft),y.onAfterRender(S,B,Z,q,V,ft)}function fs(y,B,Z){B.isScene!==!0&&(B=vt);const q=Ct.get(y),V=d.state.lights,ft=d.state.shadowsArray,St=V.state.version,Lt=K.getParameters(y,V.state,ft,B,Z),wt=K.getProgramCacheKey(Lt);let Xt=q.programs;q.environment=y.isMeshStandardMaterial?B.environment:null,q.fog=B.fog,q.envMap=(y.isMeshStandardMaterial?_e:Fe).get(y.envMap||q.environment),q.envMapRotation=q.environment!==null&&y.envMap===null?B.environmentRotation:y.envMapRotation,Xt===void 0&&(y.addEventListener("dispose",st),Xt=new Map,q.programs=Xt);let qt=Xt.get(wt);if(qt!==void 0){if(q.currentProgram===qt&&q.lightsStateVersion===St)return bo(y,Lt),qt}else Lt.uniforms=K.getUniforms(y),y.onBeforeCompile(Lt,S),qt=K.acquireProgram(Lt,wt),Xt.set(wt,qt),q.uniforms=Lt.uniforms;const zt=q.uniforms;return(!y.isShaderMaterial&&!y.isRawShaderMaterial||y.clipping===!0)&&(zt.clippingPlanes=ht.uniform),bo(y,Lt),q.needsLights=ds(y),q.lightsStateVersion=St,q.needsLights&&(zt.ambientLightColor.value=V.state.ambient,zt.lightProbe.value=V.state.probe,zt.directionalLights.value=V.state.directional,zt.directionalLightShadows.value=V.state.directionalShadow,zt.spotLights.value=V.state.spot,zt.spotLightShadows.value=V.state.spotShadow,zt.rectAreaLights.value=V.state.rectArea,zt.ltc_1.value=V.state.rectAreaLTC1,zt.ltc_2.value=V.state.rectAreaLTC2,zt.pointLights.value=V.state.point,zt.pointLightShadows.value=V.state.pointShadow,zt.hemisphereLights.value=V.state.hemi,zt.directionalShadowMap.value=V.state.directionalShadowMap,zt.directionalShadowMatrix.value=V.state.directionalShadowMatrix,zt.spotShadowMap.value=V.state.spotShadowMap,zt.spotLightMatrix.value=V.state.spotLightMatrix,zt.spotLightMap.value=V.state.spotLightMap,zt.pointShadowMap.value=V.state.pointShadowMap,zt.pointShadowMatrix.value=V.state.pointShadowMatrix),q.currentProgram=qt,q.uniformsList=null,qt}function To(y){if(y.uniformsList===null){const B=y.currentProgram.getUniforms();y.uniformsList=_a.seqWithValue(B.seq,y.uniforms)}return y.uniformsList}function bo(y,B){const Z=Ct.get(y);Z.outputColorSpace=B.outputColorSpace,Z.batching=B.batching,Z.batchingColor=B.batchingColor,Z.instancing=B.instancing,Z.instancingColor=B.instancingColor,Z.instancingMorph=B.instancingMorph,Z.skinning=B.skinning,Z.morphTargets=B.morphTargets,Z.morphNormals=B.morphNormals,Z.morphColors=B.morphColors,Z.morphTargetsCount=B.morphTargetsCount,Z.numClippingPlanes=B.numClippingPlanes,Z.numIntersection=B.numClipIntersection,Z.vertexAlphas=B.vertexAlphas,Z.vertexTangents=B.vertexTangents,Z.toneMapping=B.toneMapping}function Ci(y,B,Z,q,V){B.isScene!==!0&&(B=vt),Vt.resetTextureUnits();const ft=B.fog,St=q.isMeshStandardMaterial?B.environment:null,Lt=k===null?S.outputColorSpace:k.isXRRenderTarget===!0?k.texture.colorSpace:Sr,wt=(q.isMeshStandardMaterial?_e:Fe).get(q.envMap||St),Xt=q.vertexColors===!0&&!!Z.attributes.color&&Z.attributes.color.itemSize===4,qt=!!Z.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),zt=!!Z.morphAttributes.position,se=!!Z.morphAttributes.normal,fe=!!Z.morphAttributes.color;let Ue=cs;q.toneMapped&&(k===null||k.isXRRenderTarget===!0)&&(Ue=S.toneMapping);const we=Z.morphAttributes.position||Z.morphAttributes.normal||Z.morphAttributes.color,ne=we!==void 0?we.length:0,Wt=Ct.get(q),Ne=d.state.lights;if(jt===!0&&(Q===!0||y!==E)){const rn=y===E&&q.id===b;ht.setState(q,y,rn)}let le=!1;q.version===Wt.__version?(Wt.needsLights&&Wt.lightsStateVersion!==Ne.state.version||Wt.outputColorSpace!==Lt||V.isBatchedMesh&&Wt.batching===!1||!V.isBatchedMesh&&Wt.batching===!0||V.isBatchedMesh&&Wt.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Wt.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Wt.instancing===!1||!V.isInstancedMesh&&Wt.instancing===!0||V.isSkinnedMesh&&Wt.skinning===!1||!V.isSkinnedMesh&&Wt.skinning===!0||V.isInstancedMesh&&Wt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Wt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Wt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Wt.instancingMorph===!1&&V.morphTexture!==null||Wt.envMap!==wt||q.fog===!0&&Wt.fog!==ft||Wt.numClippingPlanes!==void 0&&(Wt.numClippingPlanes!==ht.numPlanes||Wt.numIntersection!==ht.numIntersection)||Wt.vertexAlphas!==Xt||Wt.vertexTangents!==qt||Wt.morphTargets!==zt||Wt.morphNormals!==se||Wt.morphColors!==fe||Wt.toneMapping!==Ue||Wt.morphTargetsCount!==ne)&&(le=!0):(le=!0,Wt.__version=q.version);let mn=Wt.currentProgram;le===!0&&(mn=fs(q,B,V));let qi=!1,Sn=!1,ps=!1;const Ie=mn.getUniforms(),yn=Wt.uniforms;if(Nt.useProgram(mn.program)&&(qi=!0,Sn=!0,ps=!0),q.id!==b&&(b=q.id,Sn=!0),qi||E!==y){Nt.buffers.depth.getReversed()&&y.reversedDepth!==!0&&(y._reversedDepth=!0,y.updateProjectionMatrix()),Ie.setValue(L,"projectionMatrix",y.projectionMatrix),Ie.setValue(L,"viewMatrix",y.matrixWorldInverse);const on=Ie.map.cameraPosition;on!==void 0&&on.setValue(L,Et.setFromMatrixPosition(y.matrixWorld)),Gt.logarithmicDepthBuffer&&Ie.setValue(L,"logDepthBufFC",2/(Math.log(y.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&Ie.setValue(L,"isOrthographic",y.isOrthographicCamera===!0),E!==y&&(E=y,Sn=!0,ps=!0)}if(V.isSkinnedMesh){Ie.setOptional(L,V,"bindMatrix"),Ie.setOptional(L,V,"bindMatrixInverse");const rn=V.skeleton;rn&&(rn.boneTexture===null&&rn.computeBoneTexture(),Ie.setValue(L,"boneTexture",rn.boneTexture,Vt))}V.isBatchedMesh&&(Ie.setOptional(L,V,"batchingTexture"),Ie.setValue(L,"batchingTexture",V._matricesTexture,Vt),Ie.setOptional(L,V,"batchingIdTexture"),Ie.setValue(L,"batchingIdTexture",V._indirectTexture,Vt),Ie.setOptional(L,V,"batchingColorTexture"),V._colorsTexture!==null&&Ie.setValue(L,"batchingColorTexture",V._colorsTexture,Vt));const Ln=Z.morphAttributes;if((Ln.position!==void 0||Ln.normal!==void 0||Ln.color!==void 0)&&rt.update(V,Z,mn),(Sn||Wt.receiveShadow!==V.receiveShadow)&&(Wt.receiveShadow=V.receiveShadow,Ie.setValue(L,"receiveShadow",V.receiveShadow)),q.isMeshGouraudMaterial&&q.envMap!==null&&(yn.envMap.value=wt,yn.flipEnvMap.value=wt.isCubeTexture&&wt.isRenderTargetTexture===!1?-1:1),q.isMeshStandardMaterial&&q.envMap===null&&B.environment!==null&&(yn.envMapIntensity.value=B.environmentIntensity),Sn&&(Ie.setValue(L,"toneMappingExposure",S.toneMappingExposure),Wt.needsLights&&qa(yn,ps),ft&&q.fog===!0&&nt.refreshFogUniforms(yn,ft),nt.refreshMaterialUniforms(yn,q,J,Y,d.state.transmissionRenderTarget[y.id]),_a.upload(L,To(Wt),yn,Vt)),q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(_a.upload(L,To(Wt),yn,Vt),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&Ie.setValue(L,"center",V.center),Ie.setValue(L,"modelViewMatrix",V.modelViewMatrix),Ie.setValue(L,"normalMatrix",V.normalMatrix),Ie.setValue(L,"modelMatrix",V.matrixWorld),q.isShaderMaterial||q.isRawShaderMaterial){const rn=q.uniformsGroups;for(let on=0,$i=rn.length;on<$i;on++){const Zn=rn[on];Zt.update(Zn,mn),Zt.bind(Zn,mn)}}return mn}function qa(y,B){y.ambientLightColor.needsUpdate=B,y.lightProbe.needsUpdate=B,y.directionalLights.needsUpdate=B,y.directionalLightShadows.needsUpdate=B,y.pointLights.needsUpdate=B,y.pointLightShadows.needsUpdate=B,y.spotLights.needsUpdate=B,y.spotLightShadows.needsUpdate=B,y.rectAreaLights.needsUpdate=B,y.hemisphereLights.needsUpdate=B}function ds(y){return y.isMeshLambertMaterial||y.isMeshToonMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isShadowMaterial||y.isShaderMaterial&&y.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return N},this.getRenderTarget=function(){return k},this.setRenderTargetTextures=function(y,B,Z){const q=Ct.get(y);q.__autoAllocateDepthBuffer=y.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Ct.get(y.texture).__webglTexture=B,Ct.get(y.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:Z,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(y,B){const Z=Ct.get(y);Z.__webglFramebuffer=B,Z.__useDefaultFramebuffer=B===void 0};const Ao=L.createFramebuffer();this.setRenderTarget=function(y,B=0,Z=0){k=y,D=B,N=Z;let q=!0,V=null,ft=!1,St=!1;if(y){const wt=Ct.get(y);if(wt.__useDefaultFramebuffer!==void 0)Nt.bindFramebuffer(L.FRAMEBUFFER,null),q=!1;else if(wt.__webglFramebuffer===void 0)Vt.setupRenderTarget(y);else if(wt.__hasExternalTextures)Vt.rebindTextures(y,Ct.get(y.texture).__webglTexture,Ct.get(y.depthTexture).__webglTexture);else if(y.depthBuffer){const zt=y.depthTexture;if(wt.__boundDepthTexture!==zt){if(zt!==null&&Ct.has(zt)&&(y.width!==zt.image.width||y.height!==zt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Vt.setupDepthRenderbuffer(y)}}const Xt=y.texture;(Xt.isData3DTexture||Xt.isDataArrayTexture||Xt.isCompressedArrayTexture)&&(St=!0);const qt=Ct.get(y).__webglFramebuffer;y.isWebGLCubeRenderTarget?(Array.isArray(qt[B])?V=qt[B][Z]:V=qt[B],ft=!0):y.samples>0&&Vt.useMultisampledRTT(y)===!1?V=Ct.get(y).__webglMultisampledFramebuffer:Array.isArray(qt)?V=qt[Z]:V=qt,C.copy(y.viewport),G.copy(y.scissor),H=y.scissorTest}else C.copy(_t).multiplyScalar(J).floor(),G.copy(Mt).multiplyScalar(J).floor(),H=gt;if(Z!==0&&(V=Ao),Nt.bindFramebuffer(L.FRAMEBUFFER,V)&&q&&Nt.drawBuffers(y,V),Nt.viewport(C),Nt.scissor(G),Nt.setScissorTest(H),ft){const wt=Ct.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+B,wt.__webglTexture,Z)}else if(St){const wt=B;for(let Xt=0;Xt<y.textures.length;Xt++){const qt=Ct.get(y.textures[Xt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+Xt,qt.__webglTexture,Z,wt)}}else if(y!==null&&Z!==0){const wt=Ct.get(y.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,wt.__webglTexture,Z)}b=-1},this.readRenderTargetPixels=function(y,B,Z,q,V,ft,St,Lt=0){if(!(y&&y.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let wt=Ct.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&St!==void 0&&(wt=wt[St]),wt){Nt.bindFramebuffer(L.FRAMEBUFFER,wt);try{const Xt=y.textures[Lt],qt=Xt.format,zt=Xt.type;if(!Gt.textureFormatReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Gt.textureTypeReadable(zt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=y.width-q&&Z>=0&&Z<=y.height-V&&(y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Lt),L.readPixels(B,Z,q,V,Ot.convert(qt),Ot.convert(zt),ft))}finally{const Xt=k!==null?Ct.get(k).__webglFramebuffer:null;Nt.bindFramebuffer(L.FRAMEBUFFER,Xt)}}},this.readRenderTargetPixelsAsync=async function(y,B,Z,q,V,ft,St,Lt=0){if(!(y&&y.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let wt=Ct.get(y).__webglFramebuffer;if(y.isWebGLCubeRenderTarget&&St!==void 0&&(wt=wt[St]),wt)if(B>=0&&B<=y.width-q&&Z>=0&&Z<=y.height-V){Nt.bindFramebuffer(L.FRAMEBUFFER,wt);const Xt=y.textures[Lt],qt=Xt.format,zt=Xt.type;if(!Gt.textureFormatReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Gt.textureTypeReadable(zt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const se=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,se),L.bufferData(L.PIXEL_PACK_BUFFER,ft.byteLength,L.STREAM_READ),y.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Lt),L.readPixels(B,Z,q,V,Ot.convert(qt),Ot.convert(zt),0);const fe=k!==null?Ct.get(k).__webglFramebuffer:null;Nt.bindFramebuffer(L.FRAMEBUFFER,fe);const Ue=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await y_(L,Ue,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,se),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ft),L.deleteBuffer(se),L.deleteSync(Ue),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(y,B=null,Z=0){const q=Math.pow(2,-Z),V=Math.floor(y.image.width*q),ft=Math.floor(y.image.height*q),St=B!==null?B.x:0,Lt=B!==null?B.y:0;Vt.setTexture2D(y,0),L.copyTexSubImage2D(L.TEXTURE_2D,Z,0,0,St,Lt,V,ft),Nt.unbindTexture()};const gi=L.createFramebuffer(),Ze=L.createFramebuffer();this.copyTextureToTexture=function(y,B,Z=null,q=null,V=0,ft=null){ft===null&&(V!==0?(_o("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),ft=V,V=0):ft=0);let St,Lt,wt,Xt,qt,zt,se,fe,Ue;const we=y.isCompressedTexture?y.mipmaps[ft]:y.image;if(Z!==null)St=Z.max.x-Z.min.x,Lt=Z.max.y-Z.min.y,wt=Z.isBox3?Z.max.z-Z.min.z:1,Xt=Z.min.x,qt=Z.min.y,zt=Z.isBox3?Z.min.z:0;else{const Ln=Math.pow(2,-V);St=Math.floor(we.width*Ln),Lt=Math.floor(we.height*Ln),y.isDataArrayTexture?wt=we.depth:y.isData3DTexture?wt=Math.floor(we.depth*Ln):wt=1,Xt=0,qt=0,zt=0}q!==null?(se=q.x,fe=q.y,Ue=q.z):(se=0,fe=0,Ue=0);const ne=Ot.convert(B.format),Wt=Ot.convert(B.type);let Ne;B.isData3DTexture?(Vt.setTexture3D(B,0),Ne=L.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Vt.setTexture2DArray(B,0),Ne=L.TEXTURE_2D_ARRAY):(Vt.setTexture2D(B,0),Ne=L.TEXTURE_2D),L.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,B.flipY),L.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),L.pixelStorei(L.UNPACK_ALIGNMENT,B.unpackAlignment);const le=L.getParameter(L.UNPACK_ROW_LENGTH),mn=L.getParameter(L.UNPACK_IMAGE_HEIGHT),qi=L.getParameter(L.UNPACK_SKIP_PIXELS),Sn=L.getParameter(L.UNPACK_SKIP_ROWS),ps=L.getParameter(L.UNPACK_SKIP_IMAGES);L.pixelStorei(L.UNPACK_ROW_LENGTH,we.width),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,we.height),L.pixelStorei(L.UNPACK_SKIP_PIXELS,Xt),L.pixelStorei(L.UNPACK_SKIP_ROWS,qt),L.pixelStorei(L.UNPACK_SKIP_IMAGES,zt);const Ie=y.isDataArrayTexture||y.isData3DTexture,yn=B.isDataArrayTexture||B.isData3DTexture;if(y.isDepthTexture){const Ln=Ct.get(y),rn=Ct.get(B),on=Ct.get(Ln.__renderTarget),$i=Ct.get(rn.__renderTarget);Nt.bindFramebuffer(L.READ_FRAMEBUFFER,on.__webglFramebuffer),Nt.bindFramebuffer(L.DRAW_FRAMEBUFFER,$i.__webglFramebuffer);for(let Zn=0;Zn<wt;Zn++)Ie&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ct.get(y).__webglTexture,V,zt+Zn),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ct.get(B).__webglTexture,ft,Ue+Zn)),L.blitFramebuffer(Xt,qt,St,Lt,se,fe,St,Lt,L.DEPTH_BUFFER_BIT,L.NEAREST);Nt.bindFramebuffer(L.READ_FRAMEBUFFER,null),Nt.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(V!==0||y.isRenderTargetTexture||Ct.has(y)){const Ln=Ct.get(y),rn=Ct.get(B);Nt.bindFramebuffer(L.READ_FRAMEBUFFER,gi),Nt.bindFramebuffer(L.DRAW_FRAMEBUFFER,Ze);for(let on=0;on<wt;on++)Ie?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ln.__webglTexture,V,zt+on):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Ln.__webglTexture,V),yn?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,rn.__webglTexture,ft,Ue+on):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,rn.__webglTexture,ft),V!==0?L.blitFramebuffer(Xt,qt,St,Lt,se,fe,St,Lt,L.COLOR_BUFFER_BIT,L.NEAREST):yn?L.copyTexSubImage3D(Ne,ft,se,fe,Ue+on,Xt,qt,St,Lt):L.copyTexSubImage2D(Ne,ft,se,fe,Xt,qt,St,Lt);Nt.bindFramebuffer(L.READ_FRAMEBUFFER,null),Nt.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else yn?y.isDataTexture||y.isData3DTexture?L.texSubImage3D(Ne,ft,se,fe,Ue,St,Lt,wt,ne,Wt,we.data):B.isCompressedArrayTexture?L.compressedTexSubImage3D(Ne,ft,se,fe,Ue,St,Lt,wt,ne,we.data):L.texSubImage3D(Ne,ft,se,fe,Ue,St,Lt,wt,ne,Wt,we):y.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ft,se,fe,St,Lt,ne,Wt,we.data):y.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ft,se,fe,we.width,we.height,ne,we.data):L.texSubImage2D(L.TEXTURE_2D,ft,se,fe,St,Lt,ne,Wt,we);L.pixelStorei(L.UNPACK_ROW_LENGTH,le),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,mn),L.pixelStorei(L.UNPACK_SKIP_PIXELS,qi),L.pixelStorei(L.UNPACK_SKIP_ROWS,Sn),L.pixelStorei(L.UNPACK_SKIP_IMAGES,ps),ft===0&&B.generateMipmaps&&L.generateMipmap(Ne),Nt.unbindTexture()},this.initRenderTarget=function(y){Ct.get(y).__webglFramebuffer===void 0&&Vt.setupRenderTarget(y)},this.initTexture=function(y){y.isCubeTexture?Vt.setTextureCube(y,0):y.isData3DTexture?Vt.setTexture3D(y,0):y.isDataArrayTexture||y.isCompressedArrayTexture?Vt.setTexture2DArray(y,0):Vt.setTexture2D(y,0),Nt.unbindTexture()},this.resetState=function(){D=0,N=0,k=null,Nt.reset(),xt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ti}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorSpace=pe._getDrawingBufferColorSpace(t),e.unpackColorSpace=pe._getUnpackColorSpace()}}let yf=null;function Mh(){return yf??=xy(),yf}function xy(){const i=document.createElement("canvas").getContext("webgl2");if(i===null)return"none";const t=i.getExtension("WEBGL_debug_renderer_info"),e=String(t?i.getParameter(t.UNMASKED_RENDERER_WEBGL):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)?"software":"hardware"}const My=wd(),Sy=.6;class yy{constructor(t){this.changed=t,this.possible=Mh()!=="none",this.moved=!1,this.renderer=null,this.scene=new $d,this.camera=new Yn(36,1,.1,20),this.material=new yr({transparent:!0,side:Ei,depthWrite:!1}),this.wire=new yr({wireframe:!0,transparent:!0,opacity:.07,depthWrite:!1}),this.mesh=new qn(new ba(1,.48,40,80),this.material),this.canvas=null,this.drag=e=>this.turn(e),this.mesh.add(new qn(new ba(1,.482,18,36),this.wire)),this.scene.add(this.mesh),this.camera.position.set(0,-3.5,3.5),this.camera.lookAt(0,0,0)}attach(t){this.detach(),this.canvas=t,t.style.touchAction="none",t.style.cursor="grab",t.addEventListener("pointermove",this.drag)}detach(){this.canvas?.removeEventListener("pointermove",this.drag),this.canvas=null}isOn(t){return this.canvas===t}draw(t,e,n){this.wire.color.set(n.ink),this.moved=!1,this.renderer??=new mp({antialias:!0,alpha:!0});const s=Math.min(t.canvas.width,t.canvas.height);this.renderer.setSize(s,s,!1),this.material.map?.dispose(),this.material.map=Ey(e),this.material.needsUpdate=!0,this.renderer.render(this.scene,this.camera);const r=t.clear(),o=Math.min(t.width,t.height);r.drawImage(this.renderer.domElement,(t.width-o)/2,(t.height-o)/2,o,o)}turn(t){if(t.buttons!==1)return;const e=Sy*Math.PI/180;this.mesh.rotation.z+=t.movementX*e,this.mesh.rotation.x=Math.max(-1,Math.min(1,this.mesh.rotation.x+t.movementY*e)),this.moved=!0,this.changed()}}function Ey({shape:i,activity:t}){const[e,n]=i,s=t.reduce((a,l)=>Math.max(a,l),1e-9),r=new Uint8Array(t.length*4);for(let a=0;a<t.length;++a){const l=4*Math.round(255*Math.max(0,t[a]/s));for(let c=0;c<3;++c)r[4*a+c]=My[l+c];r[4*a+3]=70+185*l/1020}const o=new q_(r,n,e,si,bi);return o.colorSpace=Xn,o.magFilter=On,o.wrapS=o.wrapT=Ma,o.needsUpdate=!0,o}class wy{constructor(t){this.changed=t,this.root=Yt("cells"),this.empty=Yt("cells-empty"),this.legend=Yt("bumps"),this.button=Yt("torus"),this.tiles=[],this.layout="",this.message=null,this.colours=null,this.asTorus=!1,this.torus=new yy(t),this.button.onclick=()=>this.toggleTorus()}toggleTorus(){this.torus.possible&&(this.asTorus=!this.asTorus,tn(this.button,"aria-pressed",String(this.asTorus)),this.message=null,this.layout="",this.changed())}update(t){const e=t.message?.cells.length?t.message:null;let n=this.torus.moved;for(const o of this.tiles)n=o.surface.fit()||n;if(e===this.message&&t.colours===this.colours&&!n)return!1;t.colours!==this.colours&&this.drawLegend(t.colours),this.message=e,this.colours=t.colours;const r=ug(e?.cells??[]);return this.arrange(r),[...r.rings,...r.sheets].forEach((o,a)=>{this.draw(this.tiles[a],o,t.colours)}),!1}arrange({rings:t,sheets:e}){const n=[...t,...e],s=n.map(o=>`${o.module}:${o.shape.join("x")}`).join()+this.asTorus;if(s===this.layout)return;this.layout=s,this.empty.hidden=n.length>0,this.button.hidden=e.length===0||!this.torus.possible,this.legend.hidden=n.every(o=>o.bumps.length===0),this.root.replaceChildren(),this.tiles=n.map(o=>this.makeTile(o));const r=this.tiles[t.length];this.asTorus&&r?this.torus.attach(r.surface.canvas):this.torus.detach()}makeTile({module:t,shape:e}){const n=e.length===1?"ring":"sheet",s=`Activity of ${t}, ${n} of ${e.join(" × ")} cells`,r=ye("canvas",{role:"img","aria-label":s}),o=ye("figcaption",{"data-testid":`cells-${t}`}),a=ye("figure");a.append(r,o),this.root.append(a);const l=new Da(r);return l.fit(),{surface:l,caption:o,finder:new gg,sheet:new bg}}draw(t,e,n){t.finder.note(e),e.shape.length===1?vg(t.surface,e,n):this.torus.isOn(t.surface.canvas)?this.torus.draw(t.surface,e,n):t.sheet.draw(t.surface,e,t.finder.period,n),me(t.caption,by(e)),tn(t.caption,"data-peak",String(Ty(e.activity)))}drawLegend(t){const e=ah(t);this.legend.replaceChildren(...bd.map(n=>{const s=ye("li");return s.append(ye("i",{class:"swatch",style:`--swatch: ${e[n]}`}),n),s}))}}function Ty(i){let t=0;for(let e=1;e<i.length;++e)i[e]>i[t]&&(t=e);return t}function by({module:i,shape:t,bumps:e,inUnits:n,activity:s}){const r=e.find(o=>o.kind==="estimate")?.mean;if(r===void 0)return i;if(t.length===1){const o=n?2*Math.PI/s.length:1;return`${i} ${Td((r[0]??NaN)*o)}`}return`${i} (${uo(r[0]??NaN)}, ${uo(r[1]??NaN)}) cells`}const Fi=(i,t)=>i.rows.value(i.row,t),Ef=[{name:"tracking",label:"odometry",text:i=>ec(ig,Fi(i,"tracking")),tone:i=>["","good","warn"][Fi(i,"tracking")]??""},{name:"speed",label:"speed",unit:"m/s",text:i=>xa(Fi(i,"v"),2)},{name:"tracked",label:"tracked",text:i=>ni(Fi(i,"tracked"))},{name:"heading",label:"heading",text:i=>Td(Fi(i,"heading"))},{name:"templates",label:"templates",text:i=>ni(i.rows.templates(i.row))},{name:"experiences",label:"experiences",text:i=>ni(Fi(i,"experiences"))},{name:"links",label:"links",text:i=>ni(Fi(i,"links"))},{name:"loops",label:"loops",text:i=>ni(Fi(i,"loops"))},{name:"action",label:"decision",text:i=>ec(rg,Fi(i,"action"))},{name:"rate",label:"frames/s",text:i=>i.live?xa(i.rate,1):"–"},{name:"dropped",label:"dropped",text:i=>ni(i.dropped)}];class Ay{constructor(){this.values=new Map;const t=Yt("counters");for(const e of Ef){const n=ye("div",{class:`counter-${e.name}`}),s=ye("span",{"data-testid":e.name}),r=ye("dd");r.append(s),e.unit&&r.append(ye("small",{},e.unit)),n.append(ye("dt",{},e.label),r),t.append(n),this.values.set(e.name,s)}}update(t){for(const e of Ef){const n=this.values.get(e.name);me(n,e.text(t)),e.tone&&tn(n.parentElement,"data-tone",e.tone(t))}return!1}}class ka{constructor(t){this.interval=t,this.last=-1/0}due(t){return t-this.last<this.interval?!1:(this.last=t,!0)}}const Ry=60;class Cy{constructor(t){this.list=Yt("events"),this.count=so("event-count"),this.pace=new ka(150),this.items=[],this.key="",this.list.addEventListener("click",e=>{const n=e.target.closest("li");n&&t(Number(n.dataset.frame))})}update(t,e){const n=`${t.events.edition} ${t.frame}`;if(n===this.key)return!1;if(!this.pace.due(e))return!0;this.key=n;const s=t.events.newest(t.frame,Ry);for(;this.items.length<s.length;)this.items.push(this.makeItem());return this.items.forEach((r,o)=>this.fill(r,s[o])),me(this.count,String(t.events.count)),!1}makeItem(){const t=ye("li"),e=ye("span");return e.append(ye("b")," ",ye("small")),t.append(ye("span"),e),this.list.append(t),t}fill(t,e){t.hidden=e===void 0,e!==void 0&&(tn(t,"data-frame",String(e.frame)),tn(t,"data-level",e.level),me(t.firstElementChild,String(e.frame)),me(t.querySelector("b"),e.message),me(t.querySelector("small"),e.source))}}const Hl=2**17;class wf{constructor(t){this.cell=t,this.values=new Float32Array(6*256),this.kept=[],this.seen=0,this.places=new Map,this.points=[],this.pairs=new Set}get count(){return this.seen}take(t,e){const n=this.kept.length;for(;this.seen<e;++this.seen)this.takeOne(t,6*this.seen);return this.kept.length>n}takeOne(t,e){if(this.cell<=0){this.keep(t,e,t,e+3);return}const n=this.place(t,e),s=this.place(t,e+3);if(n===s)return;const r=Math.min(n,s)*2**26+Math.max(n,s);this.pairs.has(r)||(this.pairs.add(r),this.keep(this.points,3*n,this.points,3*s))}place(t,e){let n=0;for(let o=0;o<3;++o){const a=Math.floor(t[e+o]/this.cell)%Hl;n=n*Hl+(a<0?a+Hl:a)}const s=this.places.get(n);if(s!==void 0)return s;const r=this.points.length/3;for(let o=0;o<3;++o)this.points.push(t[e+o]);return this.places.set(n,r),r}keep(t,e,n,s){const r=6*this.kept.length;if(r+6>this.values.length){const o=new Float32Array(2*this.values.length);o.set(this.values),this.values=o}for(let o=0;o<3;++o)this.values[r+o]=t[e+o],this.values[r+3+o]=n[s+o];this.kept.push(this.seen)}}function $c(i,t){let e=0,n=i.length;for(;e<n;){const s=e+n>>1;i[s]<t?e=s+1:n=s}return e}function Py(i){return 2**Math.floor(Math.log2(2.5/i))}const to={cos:1,sin:0,x:0,y:0,z:0};function Dy(i,t,e){return[i.cos*t-i.sin*e+i.x,i.sin*t+i.cos*e+i.z]}function Ly(i,t,e){for(let n=0;n<e;++n)if(pr(i,n)&&pr(t,n))return n;return-1}function Uy(i,t,e){const n=Ly(i,t,e);return n<0?NaN:Math.hypot(ki(i.x,n)-ki(t.x,n),ki(i.z,n)-ki(t.z,n))}function Ny(i,t,e){let n=0;const s=[0,0,0,0,0,0];for(let m=0;m<e;++m)!pr(i,m)||!pr(t,m)||(++n,[i.x,i.y,i.z,t.x,t.y,t.z].forEach((d,w)=>{s[w]=s[w]+ki(d,m)}));if(n<2)return to;const[r,o,a,l,c,u]=s.map(m=>m/n);let h=0,f=0;for(let m=0;m<e;++m){if(!pr(i,m)||!pr(t,m))continue;const[d,w]=[ki(i.x,m)-r,ki(i.z,m)-a],[T,S]=[ki(t.x,m)-l,ki(t.z,m)-u];h+=d*T+w*S,f+=d*S-w*T}const p=Math.atan2(f,h),[_,x]=[Math.cos(p),Math.sin(p)];return{cos:_,sin:x,x:l-(_*r-x*a),y:c-o,z:u-(x*r+_*a)}}function ki(i,t){return i[t]}function pr(i,t){return Number.isFinite(i.x[t])&&Number.isFinite(i.z[t])}const Iy=`
attribute vec3 start;
attribute vec3 end;
uniform vec2 resolution;
uniform float width;
const float kNear = 0.01;

void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
  // What lies behind the viewer has no place on the screen: cut it off.
  if (a.w < kNear && b.w > kNear) a = mix(a, b, (kNear - a.w) / (b.w - a.w));
  else if (b.w < kNear && a.w > kNear) b = mix(b, a, (kNear - b.w) / (a.w - b.w));
  vec2 way = (b.xy / b.w - a.xy / a.w) * resolution;
  float far = length(way);
  vec2 along = far > 1e-6 ? way / far : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 here = position.x > 0.0 ? b : a;
  // Half a width beyond the ends closes the corners.
  here.xy += (along * position.x + across * position.y) * width / resolution * here.w;
  gl_Position = here;
}`,Fy=`
uniform vec3 colour;
void main() {
  gl_FragColor = vec4(colour, 1.0);
  #include <colorspace_fragment>
}`;class Oy extends Yi{constructor(t,e){super({vertexShader:Iy,fragmentShader:Fy,uniforms:{width:{value:t},colour:{value:new Me},resolution:e},transparent:!0,blending:Hi,depthTest:!1,depthWrite:!1,side:2})}setColour(t){(this.uniforms.colour?.value).set(t)}}const ky=800;function Vl(i,t,e){return[i,-t,-e]}class aa{constructor(t,e,n){this.raw=new Float32Array(384),this.count=0,this.thinner=new wf(0),this.stale=!0,this.room=64,this.object=new qn(Tf(this.room),new Oy(t,n)),this.object.frustumCulled=!1,this.object.renderOrder=e}setColour(t){this.object.material.setColour(t)}set(t,e,n){const s=6*t+6;if(s>this.raw.length){const r=new Float32Array(Math.max(s,2*this.raw.length));r.set(this.raw),this.raw=r}this.raw.set(e,s-6),this.raw.set(n,s-3),t<this.thinner.count&&(this.stale=!0),this.count=Math.max(this.count,t+1)}cut(t){t>=this.count||(this.count=t,this.stale=!0)}show(t,e){const n=this.count>ky?e:0;(this.stale||this.thinner.cell!==n)&&(this.thinner=new wf(n)),this.stale=!1;const s=this.thinner.kept.length;this.thinner.take(this.raw,this.count)&&this.upload(s);const r=$c(this.thinner.kept,t);this.object.geometry.setDrawRange(0,6*r),this.object.visible=r>0}upload(t){const{values:e,kept:n}=this.thinner;n.length>this.room&&this.grow(n.length);const[s,r]=this.ends();for(let o=t;o<n.length;++o){const[a,l]=[e.subarray(6*o,6*o+3),e.subarray(6*o+3,6*o+6)];for(let c=0;c<4;++c)s.array.set(a,12*o+3*c),r.array.set(l,12*o+3*c)}s.needsUpdate=r.needsUpdate=!0}ends(){const{start:t,end:e}=this.object.geometry.attributes;return[t,e]}grow(t){for(;this.room<t;)this.room*=2;const e=this.object.geometry,[n,s]=this.ends();this.object.geometry=Tf(this.room);const[r,o]=this.ends();r.array.set(n.array),o.array.set(s.array),e.dispose()}}function Tf(i){const t=new Float32Array(12*i),e=new Uint32Array(6*i);for(let s=0;s<i;++s)t.set([-1,-1,0,1,-1,0,1,1,0,-1,1,0],12*s),e.set([0,1,2,0,2,3].map(r=>4*s+r),6*s);const n=new Pn;return n.setAttribute("position",new vn(t,3)),n.setAttribute("start",new vn(new Float32Array(12*i),3)),n.setAttribute("end",new vn(new Float32Array(12*i),3)),n.setIndex(new vn(e,1)),n}class By{constructor(t){this.values=new Float32Array(192);const e=new jd({size:6,sizeAttenuation:!1,map:zy(),transparent:!0,depthTest:!1,depthWrite:!1});this.object=new Q_(new Pn,e),this.object.frustumCulled=!1,this.object.renderOrder=t,this.bind(),this.show(0)}setColour(t){this.object.material.color.set(t)}setSize(t){this.object.material.size=t}set(t,e){if(3*t+3>this.values.length){const n=new Float32Array(2*this.values.length);n.set(this.values),this.values=n,this.bind()}this.values.set(e,3*t)}upload(){this.object.geometry.getAttribute("position").needsUpdate=!0}show(t){this.object.geometry.setDrawRange(0,t),this.object.visible=t>0}bind(){const{drawRange:t}=this.object.geometry,e=new Pn;e.setAttribute("position",new vn(this.values,3)),e.setDrawRange(t.start,t.count),this.object.geometry.dispose(),this.object.geometry=e}}function zy(){const i=document.createElement("canvas");i.width=i.height=64;const t=i.getContext("2d");return t!==null&&(t.strokeStyle="#fff",t.fillStyle="#ffffff59",t.lineWidth=13,t.beginPath(),t.arc(32,32,23,0,2*Math.PI),t.fill(),t.stroke()),new t0(i)}const Hy=["links","loops","experiences","odometry","truth"],Vy=1;function Kr(i,t){return{x:i.column(`${t}_x`),y:i.column(`${t}_y`),z:i.column(`${t}_z`)}}class Gy{constructor(t){this.group=new fr,this.bounds=new Dr,this.robot=new fr,this.truthMode=null,this.hidden=new Set,this.dots=new By(4),this.fill=new yr({depthTest:!1,transparent:!0}),this.rim=new yr({depthTest:!1,transparent:!0}),this.drawnRows={rows:null,count:0},this.drawnGraph=-1,this.motion=to,this.fittedRows=0,this.loopLinks=[],this.otherLinks=[],this.truth=new aa(4.5,1,t),this.odometry=new aa(1.4,2,t),this.links=new aa(1.6,3,t),this.loops=new aa(3,5,t);for(const e of[this.truth,this.odometry,this.links,this.loops,this.dots])this.group.add(e.object);this.makeRobot(),this.group.add(this.robot)}isHidden(t){return this.hidden.has(t)}setHidden(t,e){e?this.hidden.add(t):this.hidden.delete(t)}setTruthMode(t){this.truthMode=t,this.drawnRows.count=0}setColours(t){this.truth.setColour(t.truth),this.odometry.setColour(t.orange),this.links.setColour(t.blue),this.loops.setColour(t.vermilion),this.dots.setColour(t.green),this.fill.color.set(t.ink),this.rim.color.set(t.panel)}setDotSize(t){this.dots.setSize(t)}take(t){this.updateRows(t.rows),t.graph.edition!==this.drawnGraph&&this.updateGraph(t.graph)}show(t,e){const{rows:n,row:s}=t,r=s===n.count-1,o=(c,u)=>{const h=n.value(s,c);return r||!Number.isFinite(h)?u:Math.min(u,h)},a=o("links",t.graph.links);this.draw("odometry",this.odometry,s,e),this.draw("truth",this.truth,s,e);const l=o("experiences",t.graph.experiences);this.dots.show(this.hidden.has("experiences")?0:l),this.draw("links",this.links,$c(this.otherLinks,a),e),this.draw("loops",this.loops,$c(this.loopLinks,a),e),this.placeRobot(n,s)}draw(t,e,n,s){e.show(this.hidden.has(t)?0:n,s)}updateRows(t){this.drawnRows.rows!==t&&(this.drawnRows={rows:t,count:0},this.truthMode=null,this.bounds.makeEmpty(),this.odometry.cut(0),this.truth.cut(0));const e=this.drawnRows.count;if(t.count===e)return;const n=this.alignTruth(t);this.addPath(this.odometry,Kr(t,"odo"),to,e,t.count),this.addPath(this.truth,Kr(t,"truth"),this.motion,n?0:e,t.count),this.drawnRows.count=t.count}alignTruth(t){const e=Kr(t,"truth"),n=Kr(t,"map");if(this.truthMode===null){const s=Uy(e,Kr(t,"odo"),t.count);Number.isFinite(s)&&(this.truthMode=s<Vy?"given":"fitted")}if(this.truthMode!=="fitted"){const s=this.motion;return this.motion=to,s!==to}return this.drawnRows.count>0&&t.count<1.05*this.fittedRows?!1:(this.fittedRows=t.count,this.motion=Ny(e,n,t.count),!0)}addPath(t,e,n,s,r){let o=null;const a=l=>{const[c,u]=Dy(n,e.x[l],e.z[l]);return Vl(c,e.y[l]+n.y,u)};for(let l=Math.max(0,s-1);l<r;++l){const c=a(l),u=Number.isFinite(c[0]);u&&this.bounds.expandByPoint(new z(...c));const h=o??c;l>0&&t.set(l-1,u?h:o??[0,0,0],u?c:o??[0,0,0]),u&&(o=c)}}updateGraph(t){this.drawnGraph=t.edition;const e=n=>Vl(...t.position(n));for(let n=0;n<t.experiences;++n){const s=e(n);this.dots.set(n,s),this.bounds.expandByPoint(new z(...s))}this.loopLinks=[],this.otherLinks=[];for(let n=0;n<t.links;++n){const[s,r]=t.ends(n),o=t.isLoop(n),a=o?this.loopLinks:this.otherLinks;(o?this.loops:this.links).set(a.length,e(s),e(r)),a.push(n)}this.loops.cut(this.loopLinks.length),this.links.cut(this.otherLinks.length),this.dots.upload()}placeRobot(t,e){const[n,s,r]=["map_x","map_y","map_z"].map(a=>t.value(e,a));if(this.robot.visible=Number.isFinite(n),!this.robot.visible)return;this.robot.position.set(...Vl(n,s,r));const o=t.value(e,"heading");this.robot.rotation.y=Number.isFinite(o)?o:0}makeRobot(){const t=[[this.rim,1.42,6],[this.fill,1,7]];for(const[e,n,s]of t){const r=new sp;r.moveTo(0,.62*n),r.lineTo(.42*n,-.45*n),r.lineTo(0,-.22*n),r.lineTo(-.42*n,-.45*n);const o=new qn(new vh(r),e);o.rotation.x=-Math.PI/2,o.renderOrder=s,e.side=2,this.robot.add(o)}}}const bf={type:"change"},Sh={type:"start"},gp={type:"end"},la=new Ia,Af=new rs,Wy=Math.cos(70*M_.DEG2RAD),je=new z,Nn=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Gl=1e-6;class Rf extends F0{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:zi.ROTATE,MIDDLE:zi.DOLLY,RIGHT:zi.PAN},this.touches={ONE:ls.ROTATE,TWO:ls.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Is,this._lastTargetPosition=new z,this._quat=new Is().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ku,this._sphericalDelta=new Ku,this._scale=1,this._panOffset=new z,this._rotateStart=new Rt,this._rotateEnd=new Rt,this._rotateDelta=new Rt,this._panStart=new Rt,this._panEnd=new Rt,this._panDelta=new Rt,this._dollyStart=new Rt,this._dollyEnd=new Rt,this._dollyDelta=new Rt,this._dollyDirection=new z,this._mouse=new Rt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=Yy.bind(this),this._onPointerDown=Xy.bind(this),this._onPointerUp=qy.bind(this),this._onContextMenu=tE.bind(this),this._onMouseWheel=Zy.bind(this),this._onKeyDown=jy.bind(this),this._onTouchStart=Jy.bind(this),this._onTouchMove=Qy.bind(this),this._onMouseDown=$y.bind(this),this._onMouseMove=Ky.bind(this),this._interceptControlDown=eE.bind(this),this._interceptControlUp=nE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(bf),this.update(),this.state=Re.NONE}update(t=null){const e=this.object.position;je.copy(e).sub(this.target),je.applyQuaternion(this._quat),this._spherical.setFromVector3(je),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=Nn:n>Math.PI&&(n-=Nn),s<-Math.PI?s+=Nn:s>Math.PI&&(s-=Nn),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(je.setFromSpherical(this._spherical),je.applyQuaternion(this._quatInverse),e.copy(this.target).add(je),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=je.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=je.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(la.origin.copy(this.object.position),la.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(la.direction))<Wy?this.object.lookAt(this.target):(Af.setFromNormalAndCoplanarPoint(this.object.up,this.target),la.intersectPlane(Af,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Gl||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Gl||this._lastTargetPosition.distanceToSquared(this.target)>Gl?(this.dispatchEvent(bf),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Nn/60*this.autoRotateSpeed*t:Nn/60/60*this.autoRotateSpeed}_getZoomScale(t){const e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){je.setFromMatrixColumn(e,0),je.multiplyScalar(-t),this._panOffset.add(je)}_panUp(t,e){this.screenSpacePanning===!0?je.setFromMatrixColumn(e,1):(je.setFromMatrixColumn(e,0),je.crossVectors(this.object.up,je)),je.multiplyScalar(t),this._panOffset.add(je)}_pan(t,e){const n=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;je.copy(s).sub(this.target);let r=je.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(Nn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Nn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Nn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{const n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(Nn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Nn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Rt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){const e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){const e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}}function Xy(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function Yy(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function qy(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(gp),this.state=Re.NONE;break;case 1:const t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function $y(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case zi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case zi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case zi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Sh)}function Ky(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function Zy(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(Sh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(gp))}function jy(i){this.enabled!==!1&&this._handleKeyDown(i)}function Jy(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case ls.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case ls.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case ls.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case ls.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(Sh)}function Qy(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function tE(i){this.enabled!==!1&&i.preventDefault()}function eE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function nE(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}const Wl=5e3;class iE{constructor(t,e){this.canvas=t,this.scene=new $d,this.dimension="2d",this.software=Mh()==="software",this.fine=!1,this.untouched=!0,this.gridStep=0,this.flat=new cp(-1,1,1,-1,1,4*Wl),this.space=new Yn(45,1,.05,1e5),this.gridMaterial=new Zd({transparent:!0,depthWrite:!1}),this.grid=new J_(new Pn,this.gridMaterial),this.gridKey="",this.resolution={value:new Rt(1,1)},this.width=1,this.height=1,this.renderer=new mp({canvas:t,antialias:!this.software,alpha:!1}),this.flat.up.set(0,0,-1),this.flat.position.set(0,Wl,0),this.space.position.set(40,60,80),this.flatControls=new Rf(this.flat,t),this.spaceControls=new Rf(this.space,t),this.setUpControls(e),this.grid.renderOrder=0,this.grid.frustumCulled=!1,this.scene.add(this.grid),this.choose("2d")}setUpControls(t){this.flatControls.enableRotate=!1,this.flatControls.zoomToCursor=!0,this.flatControls.mouseButtons={LEFT:zi.PAN,MIDDLE:zi.DOLLY,RIGHT:zi.PAN},this.flatControls.touches={ONE:ls.PAN,TWO:ls.DOLLY_PAN},[this.flatControls.minZoom,this.flatControls.maxZoom]=[.001,1e4],this.spaceControls.enableDamping=!0,this.spaceControls.dampingFactor=.12,this.spaceControls.maxPolarAngle=.49*Math.PI;for(const e of[this.flatControls,this.spaceControls])e.enabled=!1,e.addEventListener("change",t),e.addEventListener("start",()=>this.untouched=!1)}add(t){this.scene.add(t)}choose(t){this.dimension=t,this.flatControls.enabled=t==="2d",this.spaceControls.enabled=t==="3d"}setColours(t,e){this.renderer.setClearColor(t),this.gridMaterial.color.set(e)}resize(){const{clientWidth:t,clientHeight:e}=this.canvas,n=this.software?this.fine?2:1:Math.min(window.devicePixelRatio,2);return t===this.width&&e===this.height&&n===this.renderer.getPixelRatio()?!1:([this.width,this.height]=[Math.max(1,t),Math.max(1,e)],this.resolution.value.set(this.width,this.height),this.renderer.setPixelRatio(n),this.renderer.setSize(this.width,this.height,!1),[this.flat.left,this.flat.right]=[-this.width/2,this.width/2],[this.flat.top,this.flat.bottom]=[this.height/2,-this.height/2],this.flat.updateProjectionMatrix(),this.space.aspect=this.width/this.height,this.space.updateProjectionMatrix(),!0)}get zoom(){if(this.dimension==="2d")return this.flat.zoom;const t=this.space.position.distanceTo(this.spaceControls.target);return this.height/(2*t*Math.tan(this.space.fov*Math.PI/360))}get centre(){return(this.dimension==="2d"?this.flatControls:this.spaceControls).target}zoomBy(t){if(this.untouched=!1,this.dimension==="2d"){this.flat.zoom*=t,this.flat.updateProjectionMatrix(),this.flatControls.update();return}const e=this.space.position.clone().sub(this.spaceControls.target).divideScalar(t);this.space.position.copy(this.spaceControls.target).add(e),this.spaceControls.update()}centreOn(t){for(const e of[this.flatControls,this.spaceControls]){const n=t.clone().sub(e.target);n.lengthSq()<1e-8||(e.object.position.add(n),e.target.add(n),e.update())}}fit(t){if(t.isEmpty())return;const e=t.getCenter(new z),n=t.getSize(new z),s=.84*Math.min(this.width/Math.max(n.x,4),this.height/Math.max(n.z,4));this.flat.zoom=s,this.flat.updateProjectionMatrix(),this.flatControls.target.copy(e).setY(0),this.flat.position.set(e.x,Wl,e.z),this.flatControls.update();const r=.46*this.height/s/Math.tan(this.space.fov*Math.PI/360),o=new z(-.35,.75,.8).normalize();this.spaceControls.target.copy(e),this.space.position.copy(e).addScaledVector(o,r),this.spaceControls.update()}render(t){const e=this.dimension==="3d"&&this.spaceControls.update();return this.layGrid(t),this.renderer.render(this.scene,this.dimension==="2d"?this.flat:this.space),e}layGrid(t){const e=Math.min(this.width,this.height)/this.zoom,n=Ua(Math.max(e/3.5,.001)),s=this.dimension==="2d"||t.isEmpty()?this.centre:t.getCenter(new z),r=f=>Math.round(f/n)*n,[o,a]=[r(s.x),r(s.z)],l=`${this.dimension} ${n} ${o} ${a}`;if(l===this.gridKey)return;this.gridKey=l,this.gridStep=n;const[c,u]=this.dimension==="2d"?[8,1]:[16,32],h=[];for(let f=-c;f<=c;++f)for(let p=0;p<u;++p){const _=(-c+2*c*p/u)*n,x=_+2*c/u*n;h.push(o+f*n,0,a+_,o+f*n,0,a+x),h.push(o+_,0,a+f*n,o+x,0,a+f*n)}this.grid.geometry.setAttribute("position",new vn(new Float32Array(h),3))}}const sE=17,rE=300,oE={links:"blue",loops:"vermilion",experiences:"green",odometry:"orange",truth:"truth"};class aE{constructor(t){this.changed=t,this.renders=0,this.texts={foot:Yt("map-foot"),scale:Yt("scale-text"),axes:Yt("axes")},this.bar=Yt("scale-bar"),this.numbers=new Map,this.centreButton=Yt("map-centre"),this.align=Yt("align"),this.centred=!1,this.dirty=!0,this.lastMove=0,this.key="",this.cell=0,this.relayer=!1,this.colours=null,this.hasTruth=null;const e=Yt("map");if(this.stage=Mh()!=="none"?new iE(e,()=>this.touch()):null,this.content=new Gy(this.stage?.resolution??{value:new Rt(1,1)}),this.stage?.add(this.content.group),this.stage===null){const n=Yt("map-empty");n.hidden=!1,me(n,"This browser offers no WebGL, which the map needs.")}Yt("map-2d").onclick=()=>this.choose("2d"),Yt("map-3d").onclick=()=>this.choose("3d"),Yt("map-fit").onclick=()=>this.fit(),this.centreButton.onclick=()=>this.toggleCentre(),this.makeLayers()}get zoom(){return this.stage?.zoom??NaN}get centre(){const t=this.stage?.centre;return t?[t.x,-t.z]:[NaN,NaN]}get dimension(){return this.stage?.dimension??"2d"}choose(t){this.stage?.choose(t),tn(Yt("map-2d"),"aria-pressed",String(t==="2d")),tn(Yt("map-3d"),"aria-pressed",String(t==="3d")),this.touch()}fit(){this.centred&&this.toggleCentre(),this.stage?.fit(this.content.bounds),this.stage&&(this.stage.untouched=!0),this.touch()}toggleCentre(){this.centred=!this.centred,tn(this.centreButton,"aria-pressed",String(this.centred)),this.touch()}zoomBy(t){this.stage?.zoomBy(t),this.touch()}toggle(t){this.content.setHidden(t,!this.content.isHidden(t)),this.relayer=!0,this.touch()}update(t,e){if(this.stage===null)return!1;const n=this.stage.resize();t.colours!==this.colours&&this.paint(t.colours);const s=`${t.rows.count} ${t.row} ${t.graph.edition}`;if(!n&&!this.dirty&&s===this.key)return this.refine(this.stage,e);this.stage.fine=!1,this.stage.resize(),this.lastMove=e;const r=s!==this.key||this.relayer;r&&this.content.take(t),this.stage.untouched&&this.stage.fit(this.content.bounds);const o=Py(this.stage.zoom);(r||o!==this.cell)&&this.content.show(t,o),r&&this.describe(t),[this.key,this.cell,this.relayer,this.dirty]=[s,o,!1,!1],this.centred&&this.content.robot.visible&&this.stage.centreOn(this.content.robot.position);const a=this.stage.zoom;return this.content.robot.scale.setScalar(sE/a),this.content.setDotSize(Math.max(3.4,Math.min(9,2.2*a))),this.dirty=this.stage.render(this.content.bounds),++this.renders,this.showScale(a),this.dirty&&this.changed(),this.stage.software}refine(t,e){return!t.software||t.fine?!1:e-this.lastMove<rE?!0:(t.fine=!0,t.resize(),t.render(this.content.bounds),++this.renders,!1)}touch(){this.dirty=!0,this.changed()}paint(t){this.colours=t,this.content.setColours(t),this.stage?.setColours(t.well,t.line),this.dirty=!0}describe(t){const{rows:e,row:n,graph:s}=t;me(this.numbers.get("experiences"),String(s.experiences)),me(this.numbers.get("links"),String(s.links-s.loops)),me(this.numbers.get("loops"),String(s.loops));const r=Number.isFinite(e.value(0,"truth_x"))||(t.info?.hasTruth??!1);r!==this.hasTruth&&(this.hasTruth=r,Yt("layer-truth").hidden=!r,this.align.hidden=!r),me(this.align,this.content.truthMode==="fitted"?"as given":"align");const o=n<e.count-1,a=`correction ${s.version}`,l=r?` · truth ${lE(this.content.truthMode)}`:"";me(this.texts.foot,(o?`as far as frame ${t.frame} · `:"")+a+l),tn(this.texts.foot,"data-version",String(s.version))}showScale(t){const e=Ua(110/t);tn(this.bar,"style",`width: ${(e*t).toFixed(1)}px`),me(this.texts.scale,tc(e));const n=`grid ${tc(this.stage?.gridStep??NaN)}`;me(this.texts.axes,this.dimension==="2d"?`z ↑ x → · ${n}`:n)}makeLayers(){for(const t of Hy){const e=ye("label",{id:`layer-${t}`,class:"chip"}),n=ye("input",{type:"checkbox","aria-label":`Show ${t==="truth"?"ground truth":t}`});n.checked=!0,n.onchange=()=>this.toggle(t);const s=`--swatch: var(--${oE[t]})`,r=ye("i",{style:s,class:t==="experiences"?"round":""}),o=ye("b",{"data-testid":`graph-${t}`});this.numbers.set(t,o),e.append(n,r,t,o),Yt("layers").append(e)}this.align.onclick=()=>{this.content.setTruthMode(this.content.truthMode==="fitted"?"given":"fitted"),this.relayer=!0,this.touch()}}}function lE(i){return i==="fitted"?"fitted (turn and shift)":i==="given"?"as given":"not known yet"}const cE=40;function hE(i,t){for(let e=t;e>=0&&e>t-cE;--e)if(i.value(e,"recognition")>0)return e;return-1}class uE{constructor(){this.surface=new Da(Yt("view")),this.image=Yt("template"),this.empty=Yt("template-empty"),this.made=Yt("template-made"),this.tag=Yt("recognition"),this.texts={frame:so("view-frame"),template:so("template"),score:so("score")},this.picture=null,this.coming=new Image,this.fetching=-1,this.wanted=-1,this.coming.onload=()=>this.arrived(),this.coming.onerror=()=>this.arrived()}update(t){this.drawView(t);const e=hE(t.rows,t.row),n=t.rows.value(e,"template_id"),s=e<0?0:t.rows.value(e,"recognition");me(this.texts.frame,ni(t.picture?.frame??NaN)),me(this.texts.template,ni(n>=0?n:NaN)),me(this.texts.score,uo(t.rows.value(e,"score"))),me(this.tag,ec(sg,s)),tn(this.tag,"data-kind",String(s)),tn(this.tag,"data-frame",ni(t.rows.frame(e)));const r=n>=0?t.rows.frameOfTemplate(n):NaN;return me(this.made,Number.isFinite(r)?` · frame ${r}`:""),this.showTemplate(t.picture!==null&&n>=0?n:-1),!1}drawView({picture:t}){if(!this.surface.fit()&&this.picture===t)return;this.picture=t;const e=this.surface.clear();if(t===null)return;const{width:n,height:s}=t.bitmap;for(const l of[this.surface.canvas,this.image])l.parentElement?.style.setProperty("--shape",String(n/s));const r=Math.min(this.surface.width/n,this.surface.height/s),[o,a]=[n*r,s*r];e.imageSmoothingQuality="high",e.drawImage(t.bitmap,(this.surface.width-o)/2,(this.surface.height-a)/2,o,a)}showTemplate(t){this.image.hidden=t<0,this.empty.hidden=t>=0,this.wanted=t,this.fetching<0&&this.fetchWanted()}fetchWanted(){this.wanted<0||this.image.dataset.template===String(this.wanted)||(this.fetching=this.wanted,this.coming.src=Bm(this.fetching))}arrived(){const t=this.coming.naturalWidth>0;this.image.dataset.template=String(this.fetching),t?this.image.src=this.coming.src:this.image.removeAttribute("src"),this.fetching=-1,this.fetchWanted()}}class fE{constructor(t){this.session=t,this.name=Yt("run-name"),this.description=Yt("run-description"),this.pill=Yt("link"),this.pillText=Yt("link-text"),this.banner=Yt("banner")}update(t,e){me(this.name,t.info?.name??"no run yet"),me(this.description,t.info?.description||t.info?.directory||"");const n=t.info?`${t.info.name} · Tolman`:"Tolman";document.title!==n&&(document.title=n);const[s,r]=this.state(t);tn(this.pill,"data-state",s),me(this.pillText,r);const o=this.trouble(e);return this.banner.hidden=o===null,o!==null&&(me(this.banner,o.text),tn(this.banner,"data-kind",o.kind)),this.session.trouble?.kind==="gone"}state(t){return t.link==="waiting"||t.link==="connecting"?[t.link,t.link==="waiting"?"no server":"connecting"]:t.loading?["connecting","reading the history"]:this.session.end==="interrupted"?["ended","run was interrupted"]:this.session.end!==""||t.link==="ended"?["ended","run has ended"]:t.live?t.mode==="live"?["open","live"]:["open",t.mode==="playing"?"live, playing":"live, paused here"]:["recorded","recorded run"]}trouble(t){const e=this.session.trouble;if(e===null)return null;if(e.kind==="no_frames")return{kind:"info",text:'The run has ended, and its server with it: no more images and activity. Numbers, plots and map stay. "tolman view" opens the recorded run.'};const n=Math.max(0,Math.ceil((e.until-t)/1e3));return{kind:"warning",text:`The viewer's server does not answer. What was seen stays here; next attempt ${n>0?`in ${n} s`:"now"}.`}}}const dE=!0,sn="u-",pE="uplot",mE=sn+"hz",gE=sn+"vt",_E=sn+"title",vE=sn+"wrap",xE=sn+"under",ME=sn+"over",SE=sn+"axis",Cs=sn+"off",yE=sn+"select",EE=sn+"cursor-x",wE=sn+"cursor-y",TE=sn+"cursor-pt",bE=sn+"legend",AE=sn+"live",RE=sn+"inline",CE=sn+"series",PE=sn+"marker",Cf=sn+"label",DE=sn+"value",eo="width",no="height",Zr="top",Pf="bottom",hr="left",Xl="right",yh="#000",Df=yh+"0",Yl="mousemove",Lf="mousedown",ql="mouseup",Uf="mouseenter",Nf="mouseleave",If="dblclick",LE="resize",UE="scroll",Ff="change",Aa="dppxchange",Eh="--",Nr=typeof window<"u",Kc=Nr?document:null,_r=Nr?window:null,NE=Nr?navigator:null;let xe,ca;function Zc(){let i=devicePixelRatio;xe!=i&&(xe=i,ca&&Jc(Ff,ca,Zc),ca=matchMedia(`(min-resolution: ${xe-.001}dppx) and (max-resolution: ${xe+.001}dppx)`),Us(Ff,ca,Zc),_r.dispatchEvent(new CustomEvent(Aa)))}function Wn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function jc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function ze(i,t,e){i.style[t]=e+"px"}function ui(i,t,e,n){let s=Kc.createElement(i);return t!=null&&Wn(s,t),e?.insertBefore(s,n),s}function ti(i,t){return ui("div",i,t)}const Of=new WeakMap;function Si(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=Of.get(i);r!=o&&(i.style.transform=r,Of.set(i,r),t<0||e<0||t>n||e>s?Wn(i,Cs):jc(i,Cs))}const kf=new WeakMap;function Bf(i,t,e){let n=t+e,s=kf.get(i);n!=s&&(kf.set(i,n),i.style.background=t,i.style.borderColor=e)}const zf=new WeakMap;function Hf(i,t,e,n){let s=t+""+e,r=zf.get(i);s!=r&&(zf.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const wh={passive:!0},IE={...wh,capture:!0};function Us(i,t,e,n){t.addEventListener(i,e,n?IE:wh)}function Jc(i,t,e,n){t.removeEventListener(i,e,wh)}Nr&&Zc();function fi(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:$n((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function _p(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}const vp=i=>i!=null,xp=i=>i!=null&&i>0,Ba=_p(vp),FE=_p(xp);function OE(i,t,e,n=0,s=!1){let r=s?FE:Ba,o=s?xp:vp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Pe,l??-Pe]}function za(i,t,e,n){let s=Wf(i),r=Wf(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Gi:Mp,a=s==1?$n:ei,l=r==1?ei:$n,c=a(o(Qe(i))),u=l(o(Qe(t))),h=Tr(e,c),f=Tr(e,u);return e==10&&(c<0&&(h=De(h,-c)),u<0&&(f=De(f,-u))),n||e==2?(i=h*s,t=f*r):(i=wp(i,h),t=Ha(t,f)),[i,t]}function Th(i,t,e,n){let s=za(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const bh=.1,Vf={mode:3,pad:bh},lo={pad:0,soft:null,mode:0},kE={min:lo,max:lo};function Ra(i,t,e,n){return Va(e)?Gf(i,t,e):(lo.pad=e,lo.soft=n?0:null,lo.mode=n?3:0,Gf(i,t,kE))}function ge(i,t){return i??t}function BE(i,t,e){for(t=ge(t,0),e=ge(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Gf(i,t,e){let n=e.min,s=e.max,r=ge(n.pad,0),o=ge(s.pad,0),a=ge(n.hard,-Pe),l=ge(s.hard,Pe),c=ge(n.soft,Pe),u=ge(s.soft,-Pe),h=ge(n.mode,0),f=ge(s.mode,0),p=t-i,_=Gi(p),x=An(Qe(i),Qe(t)),m=Gi(x),d=Qe(m-_);(p<1e-24||d>10)&&(p=0,(i==0||t==0)&&(p=1e-24,h==2&&c!=Pe&&(r=0),f==2&&u!=-Pe&&(o=0)));let w=p||x||1e3,T=Gi(w),S=Tr(10,$n(T)),U=w*(p==0?i==0?.1:1:r),D=De(wp(i-U,S/10),24),N=i>=c&&(h==1||h==3&&D<=c||h==2&&D>=c)?c:Pe,k=An(a,D<N&&i>=N?N:pi(N,D)),b=w*(p==0?t==0?.1:1:o),E=De(Ha(t+b,S/10),24),C=t<=u&&(f==1||f==3&&E>=u||f==2&&E<=u)?u:-Pe,G=pi(l,E>C&&t<=C?C:An(C,E));return k==G&&k==0&&(G=100),[k,G]}const zE=new Intl.NumberFormat(Nr?NE.language:"en-US"),Ah=i=>zE.format(i),Kn=Math,va=Kn.PI,Qe=Kn.abs,$n=Kn.floor,Je=Kn.round,ei=Kn.ceil,pi=Kn.min,An=Kn.max,Tr=Kn.pow,Wf=Kn.sign,Gi=Kn.log10,Mp=Kn.log2,HE=(i,t=1)=>Kn.sinh(i)*t,$l=(i,t=1)=>Kn.asinh(i/t),Pe=1/0;function Xf(i){return(Gi((i^i>>31)-(i>>31))|0)+1}function Qc(i,t,e){return pi(An(i,t),e)}function Sp(i){return typeof i=="function"}function ce(i){return Sp(i)?i:()=>i}const VE=()=>{},yp=i=>i,Ep=(i,t)=>t,GE=i=>null,Yf=i=>!0,qf=(i,t)=>i==t,WE=/\.\d*?(?=9{6,}|0{6,})/gm,ks=i=>{if(bp(i)||us.has(i))return i;const t=`${i}`,e=t.match(WE);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${ks(s)}e${r}`}return De(i,n)};function Ts(i,t){return ks(De(ks(i/t))*t)}function Ha(i,t){return ks(ei(ks(i/t))*t)}function wp(i,t){return ks($n(ks(i/t))*t)}function De(i,t=0){if(bp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Je(n)/e}const us=new Map;function Tp(i){return((""+i).split(".")[1]||"").length}function So(i,t,e,n){let s=[],r=n.map(Tp);for(let o=t;o<e;o++){let a=Qe(o),l=De(Tr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:De(u,h);s.push(f),us.set(f,h)}}return s}const co={},Rh=[],br=[null,null],os=Array.isArray,bp=Number.isInteger,XE=i=>i===void 0;function $f(i){return typeof i=="string"}function Va(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function YE(i){return i!=null&&typeof i=="object"}const qE=Object.getPrototypeOf(Uint8Array),Ap="__proto__";function Ar(i,t=Va){let e;if(os(i)){let n=i.find(s=>s!=null);if(os(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Ar(i[s],t)}else e=i.slice()}else if(i instanceof qE)e=i.slice();else if(t(i)){e={};for(let n in i)n!=Ap&&(e[n]=Ar(i[n],t))}else e=i;return e}function Ke(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=Ap&&(Va(i[s])?Ke(i[s],Ar(n[s])):i[s]=Ar(n[s]))}return i}const $E=0,KE=1,ZE=2;function jE(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function JE(i,t){if(ew(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return nw(o[0])||(o=tw(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:KE,p=[];for(let _=0;_<u.length;_++){let x=u[_],m=r.get(l[_]);x===null?f!=$E&&(h[m]=x,f==ZE&&p.push(m)):h[m]=x}jE(h,p,s),n.push(h)}}return n}const QE=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function tw(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function ew(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function nw(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=An(1,$n((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const Rp=["January","February","March","April","May","June","July","August","September","October","November","December"],Cp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Pp(i){return i.slice(0,3)}const iw=Cp.map(Pp),sw=Rp.map(Pp),rw={MMMM:Rp,MMM:sw,WWWW:Cp,WWW:iw};function jr(i){return(i<10?"0":"")+i}function ow(i){return(i<10?"00":i<100?"0":"")+i}const aw={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>jr(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>jr(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>jr(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>jr(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>jr(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>ow(i.getMilliseconds())};function Ch(i,t){t=t||rw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?aw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const lw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function cw(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==lw?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const Dp=i=>i%1==0,Ca=[1,2,2.5,5],hw=So(10,-32,0,Ca),Lp=So(10,0,32,Ca),uw=Lp.filter(Dp),bs=hw.concat(Lp),Ph=`
`,Up="{YYYY}",Kf=Ph+Up,Np="{M}/{D}",io=Ph+Np,ha=io+"/{YY}",Ip="{aa}",fw="{h}:{mm}",ur=fw+Ip,Zf=Ph+ur,jf=":{ss}",Se=null;function Fp(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?So(10,0,3,Ca).filter(Dp):So(10,-3,0,Ca)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,Up,Se,Se,Se,Se,Se,Se,1],[s*28,"{MMM}",Kf,Se,Se,Se,Se,Se,1],[s,Np,Kf,Se,Se,Se,Se,Se,1],[n,"{h}"+Ip,ha,Se,io,Se,Se,Se,1],[e,ur,ha,Se,io,Se,Se,Se,1],[t,jf,ha+" "+ur,Se,io+" "+ur,Se,Zf,Se,1],[i,jf+".{fff}",ha+" "+ur,Se,io+" "+ur,Se,Zf,Se,1]];function u(h){return(f,p,_,x,m,d)=>{let w=[],T=m>=o,S=m>=r&&m<o,U=h(_),D=De(U*i,3),N=Kl(U.getFullYear(),T?0:U.getMonth(),S||T?1:U.getDate()),k=De(N*i,3);if(S||T){let b=S?m/r:0,E=T?m/o:0,C=D==k?D:De(Kl(N.getFullYear()+E,N.getMonth()+b,1)*i,3),G=new Date(Je(C/i)),H=G.getFullYear(),$=G.getMonth();for(let W=0;C<=x;W++){let j=Kl(H+E*W,$+b*W,1),Y=j-h(De(j*i,3));C=De((+j+Y)*i,3),C<=x&&w.push(C)}}else{let b=m>=s?s:m,E=$n(_)-$n(D),C=k+E+Ha(D-k,b);w.push(C);let G=h(C),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,$=m/n,W=f.axes[p]._space,j=d/W;for(;C=De(C+m,i==1?0:3),!(C>x);)if($>1){let Y=$n(De(H+$,6))%24,at=h(C).getHours()-Y;at>1&&(at=-1),C-=at*n,H=(H+$)%24;let _t=w[w.length-1];De((C-_t)/m,3)*j>=.7&&w.push(C)}else w.push(C)}return w}}return[l,c,u]}const[dw,pw,mw]=Fp(1),[gw,_w,vw]=Fp(.001);So(2,-53,53,[1]);function Jf(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function Qf(i,t){return(e,n,s,r,o)=>{let a=t.find(_=>o>=_[0])||t[t.length-1],l,c,u,h,f,p;return n.map(_=>{let x=i(_),m=x.getFullYear(),d=x.getMonth(),w=x.getDate(),T=x.getHours(),S=x.getMinutes(),U=x.getSeconds(),D=m!=l&&a[2]||d!=c&&a[3]||w!=u&&a[4]||T!=h&&a[5]||S!=f&&a[6]||U!=p&&a[7]||a[1];return l=m,c=d,u=w,h=T,f=S,p=U,D(x)})}}function xw(i,t){let e=Ch(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function Kl(i,t,e){return new Date(i,t,e)}function td(i,t){return t(i)}const Mw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ed(i,t){return(e,n,s,r)=>r==null?Eh:t(i(n))}function Sw(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function yw(i,t){return i.series[t].fill(i,t)}const Ew={show:!0,live:!0,isolate:!1,mount:VE,markers:{show:!0,width:2,stroke:Sw,fill:yw,dash:"solid"},idx:null,idxs:null,values:[]};function ww(i,t){let e=i.cursor.points,n=ti(),s=e.size(i,t);ze(n,eo,s),ze(n,no,s);let r=s/-2;ze(n,"marginLeft",r),ze(n,"marginTop",r);let o=e.width(i,t,s);return o&&ze(n,"borderWidth",o),n}function Tw(i,t){let e=i.series[t].points;return e._fill||e._stroke}function bw(i,t){let e=i.series[t].points;return e._stroke||e._fill}function Aw(i,t){return i.series[t].points.size}const Zl=[0,0];function Rw(i,t,e){return Zl[0]=t,Zl[1]=e,Zl}function ua(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function jl(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const Cw={show:!0,x:!0,y:!0,lock:!1,move:Rw,points:{one:!1,show:ww,size:Aw,width:0,stroke:bw,fill:Tw},bind:{mousedown:ua,mouseup:ua,click:ua,dblclick:ua,mousemove:jl,mouseleave:jl,mouseenter:jl},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Op={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Dh=Ke({},Op,{filter:Ep}),kp=Ke({},Dh,{size:10}),Bp=Ke({},Op,{show:!1}),Lh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',zp="bold "+Lh,Hp=1.5,nd={show:!0,scale:"x",stroke:yh,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zp,side:2,grid:Dh,ticks:kp,border:Bp,font:Lh,lineGap:Hp,rotate:0},Pw="Value",Dw="Time",id={show:!0,scale:"x",auto:!1,sorted:1,min:Pe,max:-Pe,idxs:[]};function Lw(i,t,e,n,s){return t.map(r=>r==null?"":Ah(r))}function Uw(i,t,e,n,s,r,o){let a=[],l=us.get(s)||0;e=o?e:De(Ha(e,s),l);for(let c=e;c<=n;c=De(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function th(i,t,e,n,s,r,o){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Gi:Mp,u=$n(c(e));s=Tr(l,u),l==10&&(s=bs[fi(s,bs)]);let h=e,f=s*l;l==10&&(f=bs[fi(f,bs)]);do a.push(h),h=h+s,l==10&&!us.has(h)&&(h=De(h,us.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=bs[fi(f,bs)]));while(h<=n);return a}function Nw(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?th(i,t,An(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?th(i,t,An(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const Vp=/./,Iw=/[12357]/,Fw=/[125]/,sd=/1/,eh=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function Ow(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?Vp:l(7,o)-u>=c?Iw:l(5,o)-u>=c?Fw:sd;if(h==sd){let f=Qe(l(1,o)-u);if(f<c)return eh(t.slice().reverse(),a.distr,h,ei(c/f)).reverse()}return eh(t,a.distr,h,1)}function kw(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Qe(l(1,o)-l(2,o));return c<a?eh(t.slice().reverse(),3,Vp,ei(a/c)).reverse():t}function Bw(i,t,e,n){return n==null?Eh:t==null?"":Ah(t)}const rd={show:!0,scale:"y",stroke:yh,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:zp,side:3,grid:Dh,ticks:kp,border:Bp,font:Lh,lineGap:Hp,rotate:0};function zw(i,t){let e=3+(i||1)*2;return De(e*t,3)}function Hw(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Qe(o-r),l=i.series[t],c=a/(l.points.space*xe);return n[1]-n[0]<=c}const od={scale:null,auto:!0,sorted:0,min:Pe,max:-Pe},Gp=(i,t,e,n,s)=>s,ad={show:!0,auto:!0,sorted:0,gaps:Gp,alpha:1,facets:[Ke({},od,{scale:"x"}),Ke({},od,{scale:"y"})]},ld={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Gp,alpha:1,points:{show:Hw,filter:null},values:null,min:Pe,max:-Pe,idxs:[],path:null,clip:null};function Vw(i,t,e,n,s){return e/10}const Wp={time:dE,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Gw=Ke({},Wp,{time:!1,ori:1}),cd={};function Xp(i,t){let e=cd[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(cd[i]=e)),e}const Rr=1,nh=2;function zs(i,t,e){const n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,p=a.top,_=a.width,x=a.height,m=i.valToPosH,d=i.valToPosV;return u.ori==0?e(s,l,c,u,h,m,d,f,p,_,x,Wa,Ir,Ya,qp,Kp):e(s,l,c,u,h,d,m,p,f,x,_,Xa,Fr,Ih,$p,Zp)}function Uh(i,t){let e=0,n=0,s=ge(i.bands,Rh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function Ww(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Wi(i,t,e,n,s,r){return zs(i,t,(o,a,l,c,u,h,f,p,_,x,m)=>{let d=o.pxRound;const w=c.dir*(c.ori==0?1:-1),T=c.ori==0?Ir:Fr;let S,U;w==1?(S=e,U=n):(S=n,U=e);let D=d(h(a[S],c,x,p)),N=d(f(l[S],u,m,_)),k=d(h(a[U],c,x,p)),b=d(f(r==1?u.max:u.min,u,m,_)),E=new Path2D(s);return T(E,k,b),T(E,D,b),T(E,D,N),E})}function Ga(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=t==0?Ya:Ih;let l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let p=f[0]-l;p>0&&a(o,l,n,p,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function Xw(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Nh(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let p=r(i[h]),_=f==h?p:r(i[f]),x=h-s;p=o<=0&&x>=0&&x<l?r(i[x]):p;let d=f+s;_=o>=0&&d>=0&&d<l?r(i[d]):_,_>=p&&a.push([p,_])}return a}function hd(i){return i==0?yp:i==1?Je:t=>Ts(t,i)}function Yp(i){let t=i==0?Wa:Xa,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=pi(c,a/2,l/2),u=pi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const Wa=(i,t,e)=>{i.moveTo(t,e)},Xa=(i,t,e)=>{i.moveTo(e,t)},Ir=(i,t,e)=>{i.lineTo(t,e)},Fr=(i,t,e)=>{i.lineTo(e,t)},Ya=Yp(0),Ih=Yp(1),qp=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},$p=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},Kp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},Zp=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function jp(i){return(t,e,n,s,r)=>zs(t,e,(o,a,l,c,u,h,f,p,_,x,m)=>{let{pxRound:d,points:w}=o,T,S;c.ori==0?(T=Wa,S=qp):(T=Xa,S=$p);const U=De(w.width*xe,3);let D=(w.size-w.width)/2*xe,N=De(D*2,3),k=new Path2D,b=new Path2D,{left:E,top:C,width:G,height:H}=t.bbox;Ya(b,E-N,C-N,G+N*2,H+N*2);const $=W=>{if(l[W]!=null){let j=d(h(a[W],c,x,p)),Y=d(f(l[W],u,m,_));T(k,j+D,Y),S(k,j,Y,D,0,va*2)}};if(r)r.forEach($);else for(let W=n;W<=s;W++)$(W);return{stroke:U>0?k:null,fill:k,clip:b,flags:Rr|nh}})}function Jp(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}const Yw=Jp(Ir),qw=Jp(Fr);function Qp(i){const t=ge(i?.alignGaps,0);return(e,n,s,r)=>zs(e,n,(o,a,l,c,u,h,f,p,_,x,m)=>{[s,r]=Ba(l,s,r);let d=o.pxRound,w=H=>d(h(H,c,x,p)),T=H=>d(f(H,u,m,_)),S,U;c.ori==0?(S=Ir,U=Yw):(S=Fr,U=qw);const D=c.dir*(c.ori==0?1:-1),N={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Rr},k=N.stroke;let b=!1;if(r-s>=x*4){let H=gt=>e.posToVal(gt,c.key,!0),$=null,W=null,j,Y,J,ot=w(a[D==1?s:r]),at=w(a[s]),_t=w(a[r]),Mt=H(D==1?at+1:_t-1);for(let gt=D==1?s:r;gt>=s&&gt<=r;gt+=D){let ee=a[gt],Q=(D==1?ee<Mt:ee>Mt)?ot:w(ee),et=l[gt];Q==ot?et!=null?(Y=et,$==null?(S(k,Q,T(Y)),j=$=W=Y):Y<$?$=Y:Y>W&&(W=Y)):et===null&&(b=!0):($!=null&&U(k,ot,T($),T(W),T(j),T(Y)),et!=null?(Y=et,S(k,Q,T(Y)),$=W=j=Y):($=W=null,et===null&&(b=!0)),ot=Q,Mt=H(ot+D))}$!=null&&$!=W&&J!=ot&&U(k,ot,T($),T(W),T(j),T(Y))}else for(let H=D==1?s:r;H>=s&&H<=r;H+=D){let $=l[H];$===null?b=!0:$!=null&&S(k,w(a[H]),T($))}let[C,G]=Uh(e,n);if(o.fill!=null||C!=0){let H=N.fill=new Path2D(k),$=o.fillTo(e,n,o.min,o.max,C),W=T($),j=w(a[s]),Y=w(a[r]);D==-1&&([Y,j]=[j,Y]),S(H,Y,W),S(H,j,W)}if(!o.spanGaps){let H=[];b&&H.push(...Nh(a,l,s,r,D,w,t)),N.gaps=H=o.gaps(e,n,s,r,H),N.clip=Ga(H,c.ori,p,_,x,m)}return G!=0&&(N.band=G==2?[Wi(e,n,s,r,k,-1),Wi(e,n,s,r,k,1)]:Wi(e,n,s,r,k,G)),N})}function $w(i){const t=ge(i.align,1),e=ge(i.ascDesc,!1),n=ge(i.alignGaps,0),s=ge(i.extend,!1);return(r,o,a,l)=>zs(r,o,(c,u,h,f,p,_,x,m,d,w,T)=>{[a,l]=Ba(h,a,l);let S=c.pxRound,{left:U,width:D}=r.bbox,N=at=>S(_(at,f,w,m)),k=at=>S(x(at,p,T,d)),b=f.ori==0?Ir:Fr;const E={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Rr},C=E.stroke,G=f.dir*(f.ori==0?1:-1);let H=k(h[G==1?a:l]),$=N(u[G==1?a:l]),W=$,j=$;s&&t==-1&&(j=U,b(C,j,H)),b(C,$,H);for(let at=G==1?a:l;at>=a&&at<=l;at+=G){let _t=h[at];if(_t==null)continue;let Mt=N(u[at]),gt=k(_t);t==1?b(C,Mt,H):b(C,W,gt),b(C,Mt,gt),H=gt,W=Mt}let Y=W;s&&t==1&&(Y=U+D,b(C,Y,H));let[J,ot]=Uh(r,o);if(c.fill!=null||J!=0){let at=E.fill=new Path2D(C),_t=c.fillTo(r,o,c.min,c.max,J),Mt=k(_t);b(at,Y,Mt),b(at,j,Mt)}if(!c.spanGaps){let at=[];at.push(...Nh(u,h,a,l,G,N,n));let _t=c.width*xe/2,Mt=e||t==1?_t:-_t,gt=e||t==-1?-_t:_t;at.forEach(ee=>{ee[0]+=Mt,ee[1]+=gt}),E.gaps=at=c.gaps(r,o,a,l,at),E.clip=Ga(at,f.ori,m,d,w,T)}return ot!=0&&(E.band=ot==2?[Wi(r,o,a,l,C,-1),Wi(r,o,a,l,C,1)]:Wi(r,o,a,l,C,ot)),E})}function ud(i,t,e,n,s,r,o=Pe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=Qe(i[l]-i[a]);u<c&&(c=u,o=Qe(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function Kw(i){i=i||co;const t=ge(i.size,[.6,Pe,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ce(s),o=1-t[0],a=ge(t[1],Pe),l=ge(t[2],1),c=ge(i.disp,co),u=ge(i.each,p=>{}),{fill:h,stroke:f}=c;return(p,_,x,m)=>zs(p,_,(d,w,T,S,U,D,N,k,b,E,C)=>{let G=d.pxRound,H=e,$=n*xe,W=a*xe,j=l*xe,Y,J;S.ori==0?[Y,J]=r(p,_):[J,Y]=r(p,_);const ot=S.dir*(S.ori==0?1:-1);let at=S.ori==0?Ya:Ih,_t=S.ori==0?u:(I,K,nt,tt,It,ht,Dt)=>{u(I,K,nt,It,tt,Dt,ht)},Mt=ge(p.bands,Rh).find(I=>I.series[0]==_),gt=Mt!=null?Mt.dir:0,ee=d.fillTo(p,_,d.min,d.max,gt),jt=G(N(ee,U,C,b)),Q,et,Et,Bt=E,vt=G(d.width*xe),Jt=!1,Le=null,L=null,he=null,$t=null;h!=null&&(vt==0||f!=null)&&(Jt=!0,Le=h.values(p,_,x,m),L=new Map,new Set(Le).forEach(I=>{I!=null&&L.set(I,new Path2D)}),vt>0&&(he=f.values(p,_,x,m),$t=new Map,new Set(he).forEach(I=>{I!=null&&$t.set(I,new Path2D)})));let{x0:Gt,size:Nt}=c;if(Gt!=null&&Nt!=null){H=1,w=Gt.values(p,_,x,m),Gt.unit==2&&(w=w.map(nt=>p.posToVal(k+nt*E,S.key,!0)));let I=Nt.values(p,_,x,m);Nt.unit==2?et=I[0]*E:et=D(I[0],S,E,k)-D(0,S,E,k),Bt=ud(w,T,D,S,E,k,Bt),Et=Bt-et+$}else Bt=ud(w,T,D,S,E,k,Bt),Et=Bt*o+$,et=Bt-Et;Et<1&&(Et=0),vt>=et/2&&(vt=0),Et<5&&(G=yp);let Ee=Et>0,Ct=Bt-Et-(Ee?vt:0);et=G(Qc(Ct,j,W)),Q=(H==0?et/2:H==ot?0:et)-H*ot*((H==0?$/2:0)+(Ee?vt/2:0));const Vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Fe=Jt?null:new Path2D;let _e=null;if(Mt!=null)_e=p.data[Mt.series[1]];else{let{y0:I,y1:K}=c;I!=null&&K!=null&&(T=K.values(p,_,x,m),_e=I.values(p,_,x,m))}let R=Y*et,v=J*et;for(let I=ot==1?x:m;I>=x&&I<=m;I+=ot){let K=T[I];if(K==null)continue;if(_e!=null){let mt=_e[I]??0;if(K-mt==0)continue;jt=N(mt,U,C,b)}let nt=S.distr!=2||c!=null?w[I]:I,tt=D(nt,S,E,k),It=N(ge(K,ee),U,C,b),ht=G(tt-Q),Dt=G(An(It,jt)),bt=G(pi(It,jt)),rt=Dt-bt;if(K!=null){let mt=K<0?v:R,kt=K<0?R:v;Jt?(vt>0&&he[I]!=null&&at($t.get(he[I]),ht,bt+$n(vt/2),et,An(0,rt-vt),mt,kt),Le[I]!=null&&at(L.get(Le[I]),ht,bt+$n(vt/2),et,An(0,rt-vt),mt,kt)):at(Fe,ht,bt+$n(vt/2),et,An(0,rt-vt),mt,kt),_t(p,_,I,ht-vt/2,bt,et+vt,rt)}}return vt>0?Vt.stroke=Jt?$t:Fe:Jt||(Vt._fill=d.width==0?d._fill:d._stroke??d._fill,Vt.width=0),Vt.fill=Jt?L:Fe,Vt})}function Zw(i,t){const e=ge(t?.alignGaps,0);return(n,s,r,o)=>zs(n,s,(a,l,c,u,h,f,p,_,x,m,d)=>{[r,o]=Ba(c,r,o);let w=a.pxRound,T=Y=>w(f(Y,u,m,_)),S=Y=>w(p(Y,h,d,x)),U,D,N;u.ori==0?(U=Wa,N=Ir,D=Kp):(U=Xa,N=Fr,D=Zp);const k=u.dir*(u.ori==0?1:-1);let b=T(l[k==1?r:o]),E=b,C=[],G=[];for(let Y=k==1?r:o;Y>=r&&Y<=o;Y+=k)if(c[Y]!=null){let ot=l[Y],at=T(ot);C.push(E=at),G.push(S(c[Y]))}const H={stroke:i(C,G,U,N,D,w),fill:null,clip:null,band:null,gaps:null,flags:Rr},$=H.stroke;let[W,j]=Uh(n,s);if(a.fill!=null||W!=0){let Y=H.fill=new Path2D($),J=a.fillTo(n,s,a.min,a.max,W),ot=S(J);N(Y,E,ot),N(Y,b,ot)}if(!a.spanGaps){let Y=[];Y.push(...Nh(l,c,r,o,k,T,e)),H.gaps=Y=a.gaps(n,s,r,o,Y),H.clip=Ga(Y,u.ori,_,x,m,d)}return j!=0&&(H.band=j==2?[Wi(n,s,r,o,$,-1),Wi(n,s,r,o,$,1)]:Wi(n,s,r,o,$,j)),H})}function jw(i){return Zw(Jw,i)}function Jw(i,t,e,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}const ih=new Set;function fd(){for(let i of ih)i.syncRect(!0)}Nr&&(Us(LE,_r,fd),Us(UE,_r,fd,!0),Us(Aa,_r,()=>{pn.pxRatio=xe}));const Qw=Qp(),tT=jp();function dd(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>sh(r,o,t,e))}function eT(i,t){return i.map((e,n)=>n==0?{}:Ke({},t,e))}function sh(i,t,e,n){return Ke({},t==0?e:n,i)}function tm(i,t,e){return t==null?br:[t,e]}const nT=tm;function iT(i,t,e){return t==null?br:Ra(t,e,bh,!0)}function em(i,t,e,n){return t==null?br:za(t,e,i.scales[n].log,!1)}const sT=em;function nm(i,t,e,n){return t==null?br:Th(t,e,i.scales[n].log,!1)}const rT=nm;function oT(i,t,e,n,s){let r=An(Xf(i),Xf(t)),o=t-i,a=fi(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?us.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function pd(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Je((e=+s)*xe))+"px"),[i,t,e]}function aT(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=De(t[2]*xe,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function pn(i,t,e){const n={mode:ge(i.mode,1)},s=n.mode;function r(g,M,A,P){let O=M.valToPct(g);return P+A*(M.dir==-1?1-O:O)}function o(g,M,A,P){let O=M.valToPct(g);return P+A*(M.dir==-1?O:1-O)}function a(g,M,A,P){return M.ori==0?r(g,M,A,P):o(g,M,A,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=ti(pE);if(i.id!=null&&(c.id=i.id),Wn(c,i.class),i.title){let g=ti(_E,c);g.textContent=i.title}const u=ui("canvas"),h=n.ctx=u.getContext("2d"),f=ti(vE,c);Us("click",f,g=>{g.target===_&&(Oe!=Xs||He!=Ys)&&dn.click(n,g)},!0);const p=n.under=ti(xE,f);f.appendChild(u);const _=n.over=ti(ME,f);i=Ar(i);const x=+ge(i.pxAlign,1),m=hd(x);(i.plugins||[]).forEach(g=>{g.opts&&(i=g.opts(n,i)||i)});const d=i.ms||.001,w=n.series=s==1?dd(i.series||[],id,ld,!1):eT(i.series||[null],ad),T=n.axes=dd(i.axes||[],nd,rd,!0),S=n.scales={},U=n.bands=i.bands||[];U.forEach(g=>{g.fill=ce(g.fill||null),g.dir=ge(g.dir,-1)});const D=s==2?w[1].facets[0].scale:w[0].scale,N={axes:lm,series:ps},k=(i.drawOrder||["axes","series"]).map(g=>N[g]);function b(g){const M=g.distr==3?A=>Gi(A>0?A:g.clamp(n,A,g.min,g.max,g.key)):g.distr==4?A=>$l(A,g.asinh):g.distr==100?A=>g.fwd(A):A=>A;return A=>{let P=M(A),{_min:O,_max:X}=g,it=X-O;return(P-O)/it}}function E(g){let M=S[g];if(M==null){let A=(i.scales||co)[g]||co;if(A.from!=null){E(A.from);let P=Ke({},S[A.from],A,{key:g});P.valToPct=b(P),S[g]=P}else{M=S[g]=Ke({},g==D?Wp:Gw,A),M.key=g;let P=M.time,O=M.range,X=os(O);if((g!=D||s==2&&!P)&&(X&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?Vf:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?Vf:{mode:1,hard:O[1],soft:O[1]}},X=!1),!X&&Va(O))){let it=O;O=(lt,pt,Tt)=>pt==null?br:Ra(pt,Tt,it)}M.range=ce(O||(P?nT:g==D?M.distr==3?sT:M.distr==4?rT:tm:M.distr==3?em:M.distr==4?nm:iT)),M.auto=ce(X?!1:M.auto),M.clamp=ce(M.clamp||Vw),M._min=M._max=null,M.valToPct=b(M)}}}E("x"),E("y"),s==1&&w.forEach(g=>{E(g.scale)}),T.forEach(g=>{E(g.scale)});for(let g in i.scales)E(g);const C=S[D],G=C.distr;let H,$;C.ori==0?(Wn(c,mE),H=r,$=o):(Wn(c,gE),H=o,$=r);const W={};for(let g in S){let M=S[g];(M.min!=null||M.max!=null)&&(W[g]={min:M.min,max:M.max},M.min=M.max=null)}const j=i.tzDate||(g=>new Date(Je(g/d))),Y=i.fmtDate||Ch,J=d==1?mw(j):vw(j),ot=Qf(j,Jf(d==1?pw:_w,Y)),at=ed(j,td(Mw,Y)),_t=[],Mt=n.legend=Ke({},Ew,i.legend),gt=n.cursor=Ke({},Cw,{drag:{y:s==2}},i.cursor),ee=Mt.show,jt=gt.show,Q=Mt.markers;Mt.idxs=_t,Q.width=ce(Q.width),Q.dash=ce(Q.dash),Q.stroke=ce(Q.stroke),Q.fill=ce(Q.fill);let et,Et,Bt,vt=[],Jt=[],Le,L=!1,he={};if(Mt.live){const g=w[1]?w[1].values:null;L=g!=null,Le=L?g(n,1,0):{_:0};for(let M in Le)he[M]=Eh}if(ee)if(et=ui("table",bE,c),Bt=ui("tbody",null,et),Mt.mount(n,et),L){Et=ui("thead",null,et,Bt);let g=ui("tr",null,Et);ui("th",null,g);for(var $t in Le)ui("th",Cf,g).textContent=$t}else Wn(et,RE),Mt.live&&Wn(et,AE);const Gt={show:!0},Nt={show:!1};function Ee(g,M){if(M==0&&(L||!Mt.live||s==2))return br;let A=[],P=ui("tr",CE,Bt,Bt.childNodes[M]);Wn(P,g.class),g.show||Wn(P,Cs);let O=ui("th",null,P);if(Q.show){let lt=ti(PE,O);if(M>0){let pt=Q.width(n,M);pt&&(lt.style.border=pt+"px "+Q.dash(n,M)+" "+Q.stroke(n,M)),lt.style.background=Q.fill(n,M)}}let X=ti(Cf,O);g.label instanceof HTMLElement?X.appendChild(g.label):X.textContent=g.label,M>0&&(Q.show||(X.style.color=g.width>0?Q.stroke(n,M):Q.fill(n,M)),Vt("click",O,lt=>{if(gt._lock)return;fn(lt);let pt=w.indexOf(g);if((lt.ctrlKey||lt.metaKey)!=Mt.isolate){let Tt=w.some((At,Ut)=>Ut>0&&Ut!=pt&&At.show);w.forEach((At,Ut)=>{Ut>0&&_i(Ut,Tt?Ut==pt?Gt:Nt:Gt,!0,qe.setSeries)})}else _i(pt,{show:!g.show},!0,qe.setSeries)},!1),Dn&&Vt(Uf,O,lt=>{gt._lock||(fn(lt),_i(w.indexOf(g),$s,!0,qe.setSeries))},!1));for(var it in Le){let lt=ui("td",DE,P);lt.textContent="--",A.push(lt)}return[P,A]}const Ct=new Map;function Vt(g,M,A,P=!0){const O=Ct.get(M)||{},X=gt.bind[g](n,M,A,P);X&&(Us(g,M,O[g]=X),Ct.set(M,O))}function Fe(g,M,A){const P=Ct.get(M)||{};for(let O in P)(g==null||O==g)&&(Jc(O,M,P[O]),delete P[O]);g==null&&Ct.delete(M)}let _e=0,R=0,v=0,I=0,K=0,nt=0,tt=K,It=nt,ht=v,Dt=I,bt=0,rt=0,mt=0,kt=0;n.bbox={};let Ot=!1,xt=!1,Zt=!1,F=!1,ut=!1,dt=!1;function Pt(g,M,A){(A||g!=n.width||M!=n.height)&&ct(g,M),Hs(!1),Zt=!0,xt=!0,Vs()}function ct(g,M){n.width=_e=v=g,n.height=R=I=M,K=nt=0,Te(),ue();let A=n.bbox;bt=A.left=Ts(K*xe,.5),rt=A.top=Ts(nt*xe,.5),mt=A.width=Ts(v*xe,.5),kt=A.height=Ts(I*xe,.5)}const st=3;function Ft(){let g=!1,M=0;for(;!g;){M++;let A=om(M),P=am(M);g=M==st||A&&P,g||(ct(n.width,n.height),xt=!0)}}function Qt({width:g,height:M}){Pt(g,M)}n.setSize=Qt;function Te(){let g=!1,M=!1,A=!1,P=!1;T.forEach((O,X)=>{if(O.show&&O._show){let{side:it,_size:lt}=O,pt=it%2,Tt=O.label!=null?O.labelSize:0,At=lt+Tt;At>0&&(pt?(v-=At,it==3?(K+=At,P=!0):A=!0):(I-=At,it==0?(nt+=At,g=!0):M=!0))}}),Ci[0]=g,Ci[1]=A,Ci[2]=M,Ci[3]=P,v-=gi[1]+gi[3],K+=gi[3],I-=gi[2]+gi[0],nt+=gi[0]}function ue(){let g=K+v,M=nt+I,A=K,P=nt;function O(X,it){switch(X){case 1:return g+=it,g-it;case 2:return M+=it,M-it;case 3:return A-=it,A+it;case 0:return P-=it,P+it}}T.forEach((X,it)=>{if(X.show&&X._show){let lt=X.side;X._pos=O(lt,X._size),X.label!=null&&(X._lpos=O(lt,X.labelSize))}})}if(gt.dataIdx==null){let g=gt.hover,M=g.skip=new Set(g.skip??[]);M.add(void 0);let A=g.prox=ce(g.prox),P=g.bias??=0;gt.dataIdx=(O,X,it,lt)=>{if(X==0)return it;let pt=it,Tt=A(O,X,it,lt)??Pe,At=Tt>=0&&Tt<Pe,Ut=C.ori==0?v:I,te=gt.left,ve=t[0],de=t[X];if(M.has(de[it])){pt=null;let ae=null,Kt=null,Ht;if(P==0||P==-1)for(Ht=it;ae==null&&Ht-- >0;)M.has(de[Ht])||(ae=Ht);if(P==0||P==1)for(Ht=it;Kt==null&&Ht++<de.length;)M.has(de[Ht])||(Kt=Ht);if(ae!=null||Kt!=null)if(At){let Be=ae==null?-1/0:H(ve[ae],C,Ut,0),Ge=Kt==null?1/0:H(ve[Kt],C,Ut,0),hn=te-Be,be=Ge-te;hn<=be?hn<=Tt&&(pt=ae):be<=Tt&&(pt=Kt)}else pt=Kt==null?ae:ae==null?Kt:it-ae<=Kt-it?ae:Kt}else At&&Qe(te-H(ve[it],C,Ut,0))>Tt&&(pt=null);return pt}}const fn=g=>{gt.event=g};gt.idxs=_t,gt._lock=!1;let Ce=gt.points;Ce.show=ce(Ce.show),Ce.size=ce(Ce.size),Ce.stroke=ce(Ce.stroke),Ce.width=ce(Ce.width),Ce.fill=ce(Ce.fill);const kn=n.focus=Ke({},i.focus||{alpha:.3},gt.focus),Dn=kn.prox>=0,mi=Dn&&Ce.one;let Mn=[],Ri=[],ri=[];function Or(g,M){let A=Ce.show(n,M);if(A instanceof HTMLElement)return Wn(A,TE),Wn(A,g.class),Si(A,-10,-10,v,I),_.insertBefore(A,Mn[M]),A}function fs(g,M){if(s==1||M>0){let A=s==1&&S[g.scale].time,P=g.value;g.value=A?$f(P)?ed(j,td(P,Y)):P||at:P||Bw,g.label=g.label||(A?Dw:Pw)}if(mi||M>0){g.width=g.width==null?1:g.width,g.paths=g.paths||Qw||GE,g.fillTo=ce(g.fillTo||Ww),g.pxAlign=+ge(g.pxAlign,x),g.pxRound=hd(g.pxAlign),g.stroke=ce(g.stroke||null),g.fill=ce(g.fill||null),g._stroke=g._fill=g._paths=g._focus=null;let A=zw(An(1,g.width),1),P=g.points=Ke({},{size:A,width:An(1,A*.2),stroke:g.stroke,space:A*2,paths:tT,_stroke:null,_fill:null},g.points);P.show=ce(P.show),P.filter=ce(P.filter),P.fill=ce(P.fill),P.stroke=ce(P.stroke),P.paths=ce(P.paths),P.pxAlign=g.pxAlign}if(ee){let A=Ee(g,M);vt.splice(M,0,A[0]),Jt.splice(M,0,A[1]),Mt.values.push(null)}if(jt){_t.splice(M,0,null);let A=null;mi?M==0&&(A=Or(g,M)):M>0&&(A=Or(g,M)),Mn.splice(M,0,A),Ri.splice(M,0,0),ri.splice(M,0,0)}cn("addSeries",M)}function To(g,M){M=M??w.length,g=s==1?sh(g,M,id,ld):sh(g,M,{},ad),w.splice(M,0,g),fs(w[M],M)}n.addSeries=To;function bo(g){if(w.splice(g,1),ee){Mt.values.splice(g,1),Jt.splice(g,1);let M=vt.splice(g,1)[0];Fe(null,M.firstChild),M.remove()}jt&&(_t.splice(g,1),Mn.splice(g,1)[0].remove(),Ri.splice(g,1),ri.splice(g,1)),cn("delSeries",g)}n.delSeries=bo;const Ci=[!1,!1,!1,!1];function qa(g,M){if(g._show=g.show,g.show){let A=g.side%2,P=S[g.scale];P==null&&(g.scale=A?w[1].scale:D,P=S[g.scale]);let O=P.time;g.size=ce(g.size),g.space=ce(g.space),g.rotate=ce(g.rotate),os(g.incrs)&&g.incrs.forEach(it=>{!us.has(it)&&us.set(it,Tp(it))}),g.incrs=ce(g.incrs||(P.distr==2?uw:O?d==1?dw:gw:bs)),g.splits=ce(g.splits||(O&&P.distr==1?J:P.distr==3?th:P.distr==4?Nw:Uw)),g.stroke=ce(g.stroke),g.grid.stroke=ce(g.grid.stroke),g.ticks.stroke=ce(g.ticks.stroke),g.border.stroke=ce(g.border.stroke);let X=g.values;g.values=os(X)&&!os(X[0])?ce(X):O?os(X)?Qf(j,Jf(X,Y)):$f(X)?xw(j,X):X||ot:X||Lw,g.filter=ce(g.filter||(P.distr>=3&&P.log==10?Ow:P.distr==3&&P.log==2?kw:Ep)),g.font=pd(g.font),g.labelFont=pd(g.labelFont),g._size=g.size(n,null,M,0),g._space=g._rotate=g._incrs=g._found=g._splits=g._values=null,g._size>0&&(Ci[M]=!0,g._el=ti(SE,f))}}function ds(g,M,A,P){let[O,X,it,lt]=A,pt=M%2,Tt=0;return pt==0&&(lt||X)&&(Tt=M==0&&!O||M==2&&!it?Je(nd.size/3):0),pt==1&&(O||it)&&(Tt=M==1&&!X||M==3&&!lt?Je(rd.size/2):0),Tt}const Ao=n.padding=(i.padding||[ds,ds,ds,ds]).map(g=>ce(ge(g,ds))),gi=n._padding=Ao.map((g,M)=>g(n,M,Ci,0));let Ze,y=null,B=null;const Z=s==1?w[0].idxs:null;let q=null,V=!1;function ft(g,M){if(t=g??[],n.data=n._data=t,s==2){Ze=0;for(let A=1;A<w.length;A++)Ze+=t[A][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),q=t[0],Ze=q.length;let A=t;if(G==2){A=t.slice();let P=A[0]=Array(Ze);for(let O=0;O<Ze;O++)P[O]=O}n._data=t=A}if(Hs(!0),cn("setData"),G==2&&(Zt=!0),M!==!1){let A=C;A.auto(n,V)?St():Zi(D,A.min,A.max),F=F||gt.left>=0,dt=!0,Vs()}}n.setData=ft;function St(){V=!0;let g,M;s==1&&(Ze>0?(y=Z[0]=0,B=Z[1]=Ze-1,g=t[0][y],M=t[0][B],G==2?(g=y,M=B):g==M&&(G==3?[g,M]=za(g,g,C.log,!1):G==4?[g,M]=Th(g,g,C.log,!1):C.time?M=g+Je(86400/d):[g,M]=Ra(g,M,bh,!0))):(y=Z[0]=g=null,B=Z[1]=M=null)),Zi(D,g,M)}let Lt,wt,Xt,qt,zt,se,fe,Ue,we,ne;function Wt(g,M,A,P,O,X){g??=Df,A??=Rh,P??="butt",O??=Df,X??="round",g!=Lt&&(h.strokeStyle=Lt=g),O!=wt&&(h.fillStyle=wt=O),M!=Xt&&(h.lineWidth=Xt=M),X!=zt&&(h.lineJoin=zt=X),P!=se&&(h.lineCap=se=P),A!=qt&&h.setLineDash(qt=A)}function Ne(g,M,A,P){M!=wt&&(h.fillStyle=wt=M),g!=fe&&(h.font=fe=g),A!=Ue&&(h.textAlign=Ue=A),P!=we&&(h.textBaseline=we=P)}function le(g,M,A,P,O=0){if(P.length>0&&g.auto(n,V)&&(M==null||M.min==null)){let X=ge(y,0),it=ge(B,P.length-1),lt=A.min==null?OE(P,X,it,O,g.distr==3):[A.min,A.max];g.min=pi(g.min,A.min=lt[0]),g.max=An(g.max,A.max=lt[1])}}const mn={min:null,max:null};function qi(){for(let P in S){let O=S[P];W[P]==null&&(O.min==null||W[D]!=null&&O.auto(n,V))&&(W[P]=mn)}for(let P in S){let O=S[P];W[P]==null&&O.from!=null&&W[O.from]!=null&&(W[P]=mn)}W[D]!=null&&Hs(!0);let g={};for(let P in W){let O=W[P];if(O!=null){let X=g[P]=Ar(S[P],YE);if(O.min!=null)Ke(X,O);else if(P!=D||s==2)if(Ze==0&&X.from==null){let it=X.range(n,null,null,P);X.min=it[0],X.max=it[1]}else X.min=Pe,X.max=-Pe}}if(Ze>0){w.forEach((P,O)=>{if(s==1){let X=P.scale,it=W[X];if(it==null)return;let lt=g[X];if(O==0){let pt=lt.range(n,lt.min,lt.max,X);lt.min=pt[0],lt.max=pt[1],y=fi(lt.min,t[0]),B=fi(lt.max,t[0]),B-y>1&&(t[0][y]<lt.min&&y++,t[0][B]>lt.max&&B--),P.min=q[y],P.max=q[B]}else P.show&&P.auto&&le(lt,it,P,t[O],P.sorted);P.idxs[0]=y,P.idxs[1]=B}else if(O>0&&P.show&&P.auto){let[X,it]=P.facets,lt=X.scale,pt=it.scale,[Tt,At]=t[O],Ut=g[lt],te=g[pt];Ut!=null&&le(Ut,W[lt],X,Tt,X.sorted),te!=null&&le(te,W[pt],it,At,it.sorted),P.min=it.min,P.max=it.max}});for(let P in g){let O=g[P],X=W[P];if(O.from==null&&(X==null||X.min==null)){let it=O.range(n,O.min==Pe?null:O.min,O.max==-Pe?null:O.max,P);O.min=it[0],O.max=it[1]}}}for(let P in g){let O=g[P];if(O.from!=null){let X=g[O.from];if(X.min==null)O.min=O.max=null;else{let it=O.range(n,X.min,X.max,P);O.min=it[0],O.max=it[1]}}}let M={},A=!1;for(let P in g){let O=g[P],X=S[P];if(X.min!=O.min||X.max!=O.max){X.min=O.min,X.max=O.max;let it=X.distr;X._min=it==3?Gi(X.min):it==4?$l(X.min,X.asinh):it==100?X.fwd(X.min):X.min,X._max=it==3?Gi(X.max):it==4?$l(X.max,X.asinh):it==100?X.fwd(X.max):X.max,M[P]=A=!0}}if(A){w.forEach((P,O)=>{s==2?O>0&&M.y&&(P._paths=null):M[P.scale]&&(P._paths=null)});for(let P in M)Zt=!0,cn("setScale",P);jt&&gt.left>=0&&(F=dt=!0)}for(let P in W)W[P]=null}function Sn(g){let M=Qc(y-1,0,Ze-1),A=Qc(B+1,0,Ze-1);for(;g[M]==null&&M>0;)M--;for(;g[A]==null&&A<Ze-1;)A++;return[M,A]}function ps(){if(Ze>0){let g=w.some(M=>M._focus)&&ne!=kn.alpha;g&&(h.globalAlpha=ne=kn.alpha),w.forEach((M,A)=>{if(A>0&&M.show&&(Ie(A,!1),Ie(A,!0),M._paths==null)){let P=ne;ne!=M.alpha&&(h.globalAlpha=ne=M.alpha);let O=s==2?[0,t[A][0].length-1]:Sn(t[A]);M._paths=M.paths(n,A,O[0],O[1]),ne!=P&&(h.globalAlpha=ne=P)}}),w.forEach((M,A)=>{if(A>0&&M.show){let P=ne;ne!=M.alpha&&(h.globalAlpha=ne=M.alpha),M._paths!=null&&yn(A,!1);{let O=M._paths!=null?M._paths.gaps:null,X=M.points.show(n,A,y,B,O),it=M.points.filter(n,A,X,O);(X||it)&&(M.points._paths=M.points.paths(n,A,y,B,it),yn(A,!0))}ne!=P&&(h.globalAlpha=ne=P),cn("drawSeries",A)}}),g&&(h.globalAlpha=ne=1)}}function Ie(g,M){let A=M?w[g].points:w[g];A._stroke=A.stroke(n,g),A._fill=A.fill(n,g)}function yn(g,M){let A=M?w[g].points:w[g],{stroke:P,fill:O,clip:X,flags:it,_stroke:lt=A._stroke,_fill:pt=A._fill,_width:Tt=A.width}=A._paths;Tt=De(Tt*xe,3);let At=null,Ut=Tt%2/2;M&&pt==null&&(pt=Tt>0?"#fff":lt);let te=A.pxAlign==1&&Ut>0;if(te&&h.translate(Ut,Ut),!M){let ve=bt-Tt/2,de=rt-Tt/2,ae=mt+Tt,Kt=kt+Tt;At=new Path2D,At.rect(ve,de,ae,Kt)}M?on(lt,Tt,A.dash,A.cap,pt,P,O,it,X):Ln(g,lt,Tt,A.dash,A.cap,pt,P,O,it,At,X),te&&h.translate(-Ut,-Ut)}function Ln(g,M,A,P,O,X,it,lt,pt,Tt,At){let Ut=!1;pt!=0&&U.forEach((te,ve)=>{if(te.series[0]==g){let de=w[te.series[1]],ae=t[te.series[1]],Kt=(de._paths||co).band;os(Kt)&&(Kt=te.dir==1?Kt[0]:Kt[1]);let Ht,Be=null;de.show&&Kt&&BE(ae,y,B)?(Be=te.fill(n,ve)||X,Ht=de._paths.clip):Kt=null,on(M,A,P,O,Be,it,lt,pt,Tt,At,Ht,Kt),Ut=!0}}),Ut||on(M,A,P,O,X,it,lt,pt,Tt,At)}const rn=Rr|nh;function on(g,M,A,P,O,X,it,lt,pt,Tt,At,Ut){Wt(g,M,A,P,O),(pt||Tt||Ut)&&(h.save(),pt&&h.clip(pt),Tt&&h.clip(Tt)),Ut?(lt&rn)==rn?(h.clip(Ut),At&&h.clip(At),Zn(O,it),$i(g,X,M)):lt&nh?(Zn(O,it),h.clip(Ut),$i(g,X,M)):lt&Rr&&(h.save(),h.clip(Ut),At&&h.clip(At),Zn(O,it),h.restore(),$i(g,X,M)):(Zn(O,it),$i(g,X,M)),(pt||Tt||Ut)&&h.restore()}function $i(g,M,A){A>0&&(M instanceof Map?M.forEach((P,O)=>{h.strokeStyle=Lt=O,h.stroke(P)}):M!=null&&g&&h.stroke(M))}function Zn(g,M){M instanceof Map?M.forEach((A,P)=>{h.fillStyle=wt=P,h.fill(A)}):M!=null&&g&&h.fill(M)}function rm(g,M,A,P){let O=T[g],X;if(P<=0)X=[0,0];else{let it=O._space=O.space(n,g,M,A,P),lt=O._incrs=O.incrs(n,g,M,A,P,it);X=oT(M,A,lt,P,it)}return O._found=X}function $a(g,M,A,P,O,X,it,lt,pt,Tt){let At=it%2/2;x==1&&h.translate(At,At),Wt(lt,it,pt,Tt,lt),h.beginPath();let Ut,te,ve,de,ae=O+(P==0||P==3?-X:X);A==0?(te=O,de=ae):(Ut=O,ve=ae);for(let Kt=0;Kt<g.length;Kt++)M[Kt]!=null&&(A==0?Ut=ve=g[Kt]:te=de=g[Kt],h.moveTo(Ut,te),h.lineTo(ve,de));h.stroke(),x==1&&h.translate(-At,-At)}function om(g){let M=!0;return T.forEach((A,P)=>{if(!A.show)return;let O=S[A.scale];if(O.min==null){A._show&&(M=!1,A._show=!1,Hs(!1));return}else A._show||(M=!1,A._show=!0,Hs(!1));let X=A.side,it=X%2,{min:lt,max:pt}=O,[Tt,At]=rm(P,lt,pt,it==0?v:I);if(At==0)return;let Ut=O.distr==2,te=A._splits=A.splits(n,P,lt,pt,Tt,At,Ut),ve=O.distr==2?te.map(Ht=>q[Ht]):te,de=O.distr==2?q[te[1]]-q[te[0]]:Tt,ae=A._values=A.values(n,A.filter(n,ve,P,At,de),P,At,de);A._rotate=X==2?A.rotate(n,ae,P,At):0;let Kt=A._size;A._size=ei(A.size(n,ae,P,g)),Kt!=null&&A._size!=Kt&&(M=!1)}),M}function am(g){let M=!0;return Ao.forEach((A,P)=>{let O=A(n,P,Ci,g);O!=gi[P]&&(M=!1),gi[P]=O}),M}function lm(){for(let g=0;g<T.length;g++){let M=T[g];if(!M.show||!M._show)continue;let A=M.side,P=A%2,O,X,it=M.stroke(n,g),lt=A==0||A==3?-1:1,[pt,Tt]=M._found;if(M.label!=null){let wn=M.labelGap*lt,Hn=Je((M._lpos+wn)*xe);Ne(M.labelFont[0],it,"center",A==2?Zr:Pf),h.save(),P==1?(O=X=0,h.translate(Hn,Je(rt+kt/2)),h.rotate((A==3?-va:va)/2)):(O=Je(bt+mt/2),X=Hn);let _s=Sp(M.label)?M.label(n,g,pt,Tt):M.label;h.fillText(_s,O,X),h.restore()}if(Tt==0)continue;let At=S[M.scale],Ut=P==0?mt:kt,te=P==0?bt:rt,ve=M._splits,de=At.distr==2?ve.map(wn=>q[wn]):ve,ae=At.distr==2?q[ve[1]]-q[ve[0]]:pt,Kt=M.ticks,Ht=M.border,Be=Kt.show?Kt.size:0,Ge=Je(Be*xe),hn=Je((M.alignTo==2?M._size-Be-M.gap:M.gap)*xe),be=M._rotate*-va/180,We=m(M._pos*xe),Bn=(Ge+hn)*lt,En=We+Bn;X=P==0?En:0,O=P==1?En:0;let jn=M.font[0],oi=M.align==1?hr:M.align==2?Xl:be>0?hr:be<0?Xl:P==0?"center":A==3?Xl:hr,xi=be||P==1?"middle":A==2?Zr:Pf;Ne(jn,it,oi,xi);let zn=M.font[1]*M.lineGap,Jn=ve.map(wn=>m(a(wn,At,Ut,te))),ai=M._values;for(let wn=0;wn<ai.length;wn++){let Hn=ai[wn];if(Hn!=null){P==0?O=Jn[wn]:X=Jn[wn],Hn=""+Hn;let _s=Hn.indexOf(`
`)==-1?[Hn]:Hn.split(/\n/gm);for(let Tn=0;Tn<_s.length;Tn++){let tu=_s[Tn];be?(h.save(),h.translate(O,X+Tn*zn),h.rotate(be),h.fillText(tu,0,0),h.restore()):h.fillText(tu,O,X+Tn*zn)}}}Kt.show&&$a(Jn,Kt.filter(n,de,g,Tt,ae),P,A,We,Ge,De(Kt.width*xe,3),Kt.stroke(n,g),Kt.dash,Kt.cap);let Mi=M.grid;Mi.show&&$a(Jn,Mi.filter(n,de,g,Tt,ae),P,P==0?2:1,P==0?rt:bt,P==0?kt:mt,De(Mi.width*xe,3),Mi.stroke(n,g),Mi.dash,Mi.cap),Ht.show&&$a([We],[1],P==0?1:0,P==0?1:2,P==1?rt:bt,P==1?kt:mt,De(Ht.width*xe,3),Ht.stroke(n,g),Ht.dash,Ht.cap)}cn("drawAxes")}function Hs(g){w.forEach((M,A)=>{A>0&&(M._paths=null,g&&(s==1?(M.min=null,M.max=null):M.facets.forEach(P=>{P.min=null,P.max=null})))})}let Ro=!1,Ka=!1,kr=[];function cm(){Ka=!1;for(let g=0;g<kr.length;g++)cn(...kr[g]);kr.length=0}function Vs(){Ro||(QE(Fh),Ro=!0)}function hm(g,M=!1){Ro=!0,Ka=M,g(n),Fh(),M&&kr.length>0&&queueMicrotask(cm)}n.batch=hm;function Fh(){if(Ot&&(qi(),Ot=!1),Zt&&(Ft(),Zt=!1),xt){if(ze(p,hr,K),ze(p,Zr,nt),ze(p,eo,v),ze(p,no,I),ze(_,hr,K),ze(_,Zr,nt),ze(_,eo,v),ze(_,no,I),ze(f,eo,_e),ze(f,no,R),u.width=Je(_e*xe),u.height=Je(R*xe),T.forEach(({_el:g,_show:M,_size:A,_pos:P,side:O})=>{if(g!=null)if(M){let X=O===3||O===0?A:0,it=O%2==1;ze(g,it?"left":"top",P-X),ze(g,it?"width":"height",A),ze(g,it?"top":"left",it?nt:K),ze(g,it?"height":"width",it?I:v),jc(g,Cs)}else Wn(g,Cs)}),Lt=wt=Xt=zt=se=fe=Ue=we=qt=null,ne=1,Hr(!0),K!=tt||nt!=It||v!=ht||I!=Dt){Hs(!1);let g=v/ht,M=I/Dt;if(jt&&!F&&gt.left>=0){gt.left*=g,gt.top*=M,Gs&&Si(Gs,Je(gt.left),0,v,I),Ws&&Si(Ws,0,Je(gt.top),v,I);for(let A=0;A<Mn.length;A++){let P=Mn[A];P!=null&&(Ri[A]*=g,ri[A]*=M,Si(P,ei(Ri[A]),ei(ri[A]),v,I))}}if(ke.show&&!ut&&ke.left>=0&&ke.width>0){ke.left*=g,ke.width*=g,ke.top*=M,ke.height*=M;for(let A in el)ze(qs,A,ke[A])}tt=K,It=nt,ht=v,Dt=I}cn("setSize"),xt=!1}_e>0&&R>0&&(h.clearRect(0,0,u.width,u.height),cn("drawClear"),k.forEach(g=>g()),cn("draw")),ke.show&&ut&&(Co(ke),ut=!1),jt&&F&&(gs(null,!0,!1),F=!1),Mt.show&&Mt.live&&dt&&(Qa(),dt=!1),l||(l=!0,n.status=1,cn("ready")),V=!1,Ro=!1}n.redraw=(g,M)=>{Zt=M||!1,g!==!1?Zi(D,C.min,C.max):Vs()};function Za(g,M){let A=S[g];if(A.from==null){if(Ze==0){let P=A.range(n,M.min,M.max,g);M.min=P[0],M.max=P[1]}if(M.min>M.max){let P=M.min;M.min=M.max,M.max=P}if(Ze>1&&M.min!=null&&M.max!=null&&M.max-M.min<1e-16)return;g==D&&A.distr==2&&Ze>0&&(M.min=fi(M.min,t[0]),M.max=fi(M.max,t[0]),M.min==M.max&&M.max++),W[g]=M,Ot=!0,Vs()}}n.setScale=Za;let ja,Ja,Gs,Ws,Oh,kh,Xs,Ys,Bh,zh,Oe,He,Ki=!1;const dn=gt.drag;let an=dn.x,ln=dn.y;jt&&(gt.x&&(ja=ti(EE,_)),gt.y&&(Ja=ti(wE,_)),C.ori==0?(Gs=ja,Ws=Ja):(Gs=Ja,Ws=ja),Oe=gt.left,He=gt.top);const ke=n.select=Ke({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),qs=ke.show?ti(yE,ke.over?_:p):null;function Co(g,M){if(ke.show){for(let A in g)ke[A]=g[A],A in el&&ze(qs,A,g[A]);M!==!1&&cn("setSelect")}}n.setSelect=Co;function um(g){if(w[g].show)ee&&jc(vt[g],Cs);else if(ee&&Wn(vt[g],Cs),jt){let A=mi?Mn[0]:Mn[g];A!=null&&Si(A,-10,-10,v,I)}}function Zi(g,M,A){Za(g,{min:M,max:A})}function _i(g,M,A,P){M.focus!=null&&gm(g),M.show!=null&&w.forEach((O,X)=>{X>0&&(g==X||g==null)&&(O.show=M.show,um(X),s==2?(Zi(O.facets[0].scale,null,null),Zi(O.facets[1].scale,null,null)):Zi(O.scale,null,null),Vs())}),A!==!1&&cn("setSeries",g,M),P&&Vr("setSeries",n,g,M)}n.setSeries=_i;function fm(g,M){Ke(U[g],M)}function dm(g,M){g.fill=ce(g.fill||null),g.dir=ge(g.dir,-1),M=M??U.length,U.splice(M,0,g)}function pm(g){g==null?U.length=0:U.splice(g,1)}n.addBand=dm,n.setBand=fm,n.delBand=pm;function mm(g,M){w[g].alpha=M,jt&&Mn[g]!=null&&(Mn[g].style.opacity=M),ee&&vt[g]&&(vt[g].style.opacity=M)}let Pi,ji,ms;const $s={focus:!0};function gm(g){if(g!=ms){let M=g==null,A=kn.alpha!=1;w.forEach((P,O)=>{if(s==1||O>0){let X=M||O==0||O==g;P._focus=M?null:X,A&&mm(O,X?1:kn.alpha)}}),ms=g,A&&Vs()}}ee&&Dn&&Vt(Nf,et,g=>{gt._lock||(fn(g),ms!=null&&_i(null,$s,!0,qe.setSeries))});function vi(g,M,A){let P=S[M];A&&(g=g/xe-(P.ori==1?nt:K));let O=v;P.ori==1&&(O=I,g=O-g),P.dir==-1&&(g=O-g);let X=P._min,it=P._max,lt=g/O,pt=X+(it-X)*lt,Tt=P.distr;return Tt==3?Tr(10,pt):Tt==4?HE(pt,P.asinh):Tt==100?P.bwd(pt):pt}function _m(g,M){let A=vi(g,D,M);return fi(A,t[0],y,B)}n.valToIdx=g=>fi(g,t[0]),n.posToIdx=_m,n.posToVal=vi,n.valToPos=(g,M,A)=>S[M].ori==0?r(g,S[M],A?mt:v,A?bt:0):o(g,S[M],A?kt:I,A?rt:0),n.setCursor=(g,M,A)=>{Oe=g.left,He=g.top,gs(null,M,A)};function Hh(g,M){ze(qs,hr,ke.left=g),ze(qs,eo,ke.width=M)}function Vh(g,M){ze(qs,Zr,ke.top=g),ze(qs,no,ke.height=M)}let Br=C.ori==0?Hh:Vh,zr=C.ori==1?Hh:Vh;function vm(){if(ee&&Mt.live)for(let g=s==2?1:0;g<w.length;g++){if(g==0&&L)continue;let M=Mt.values[g],A=0;for(let P in M)Jt[g][A++].firstChild.nodeValue=M[P]}}function Qa(g,M){if(g!=null&&(g.idxs?g.idxs.forEach((A,P)=>{_t[P]=A}):XE(g.idx)||_t.fill(g.idx),Mt.idx=_t[0]),ee&&Mt.live){for(let A=0;A<w.length;A++)(A>0||s==1&&!L)&&xm(A,_t[A]);vm()}dt=!1,M!==!1&&cn("setLegend")}n.setLegend=Qa;function xm(g,M){let A=w[g],P=g==0&&G==2?q:t[g],O;L?O=A.values(n,g,M)??he:(O=A.value(n,M==null?null:P[M],g,M),O=O==null?he:{_:O}),Mt.values[g]=O}function gs(g,M,A){Bh=Oe,zh=He,[Oe,He]=gt.move(n,Oe,He),gt.left=Oe,gt.top=He,jt&&(Gs&&Si(Gs,Je(Oe),0,v,I),Ws&&Si(Ws,0,Je(He),v,I));let P,O=y>B;Pi=Pe,ji=null;let X=C.ori==0?v:I,it=C.ori==1?v:I;if(Oe<0||Ze==0||O){P=gt.idx=null;for(let lt=0;lt<w.length;lt++){let pt=Mn[lt];pt!=null&&Si(pt,-10,-10,v,I)}Dn&&_i(null,$s,!0,g==null&&qe.setSeries),Mt.live&&(_t.fill(P),dt=!0)}else{let lt,pt,Tt;s==1&&(lt=C.ori==0?Oe:He,pt=vi(lt,D),P=gt.idx=fi(pt,t[0],y,B),Tt=H(t[0][P],C,X,0));let At=-10,Ut=-10,te=0,ve=0,de=!0,ae="",Kt="";for(let Ht=s==2?1:0;Ht<w.length;Ht++){let Be=w[Ht],Ge=_t[Ht],hn=Ge==null?null:s==1?t[Ht][Ge]:t[Ht][1][Ge],be=gt.dataIdx(n,Ht,P,pt),We=be==null?null:s==1?t[Ht][be]:t[Ht][1][be];if(dt=dt||We!=hn||be!=Ge,_t[Ht]=be,Ht>0&&Be.show){let Bn=be==null?-10:be==P?Tt:H(s==1?t[0][be]:t[Ht][0][be],C,X,0),En=We==null?-10:$(We,s==1?S[Be.scale]:S[Be.facets[1].scale],it,0);if(Dn&&We!=null){let jn=C.ori==1?Oe:He,oi=Qe(kn.dist(n,Ht,be,En,jn));if(oi<Pi){let xi=kn.bias;if(xi!=0){let zn=vi(jn,Be.scale),Jn=We>=0?1:-1,ai=zn>=0?1:-1;ai==Jn&&(ai==1?xi==1?We>=zn:We<=zn:xi==1?We<=zn:We>=zn)&&(Pi=oi,ji=Ht)}else Pi=oi,ji=Ht}}if(dt||mi){let jn,oi;C.ori==0?(jn=Bn,oi=En):(jn=En,oi=Bn);let xi,zn,Jn,ai,Mi,wn,Hn=!0,_s=Ce.bbox;if(_s!=null){Hn=!1;let Tn=_s(n,Ht);Jn=Tn.left,ai=Tn.top,xi=Tn.width,zn=Tn.height}else Jn=jn,ai=oi,xi=zn=Ce.size(n,Ht);if(wn=Ce.fill(n,Ht),Mi=Ce.stroke(n,Ht),mi)Ht==ji&&Pi<=kn.prox&&(At=Jn,Ut=ai,te=xi,ve=zn,de=Hn,ae=wn,Kt=Mi);else{let Tn=Mn[Ht];Tn!=null&&(Ri[Ht]=Jn,ri[Ht]=ai,Hf(Tn,xi,zn,Hn),Bf(Tn,wn,Mi),Si(Tn,ei(Jn),ei(ai),v,I))}}}}if(mi){let Ht=kn.prox,Be=ms==null?Pi<=Ht:Pi>Ht||ji!=ms;if(dt||Be){let Ge=Mn[0];Ge!=null&&(Ri[0]=At,ri[0]=Ut,Hf(Ge,te,ve,de),Bf(Ge,ae,Kt),Si(Ge,ei(At),ei(Ut),v,I))}}}if(ke.show&&Ki)if(g!=null){let[lt,pt]=qe.scales,[Tt,At]=qe.match,[Ut,te]=g.cursor.sync.scales,ve=g.cursor.drag;if(an=ve._x,ln=ve._y,an||ln){let{left:de,top:ae,width:Kt,height:Ht}=g.select,Be=g.scales[Ut].ori,Ge=g.posToVal,hn,be,We,Bn,En,jn=lt!=null&&Tt(lt,Ut),oi=pt!=null&&At(pt,te);jn&&an?(Be==0?(hn=de,be=Kt):(hn=ae,be=Ht),We=S[lt],Bn=H(Ge(hn,Ut),We,X,0),En=H(Ge(hn+be,Ut),We,X,0),Br(pi(Bn,En),Qe(En-Bn))):Br(0,X),oi&&ln?(Be==1?(hn=de,be=Kt):(hn=ae,be=Ht),We=S[pt],Bn=$(Ge(hn,te),We,it,0),En=$(Ge(hn+be,te),We,it,0),zr(pi(Bn,En),Qe(En-Bn))):zr(0,it)}else nl()}else{let lt=Qe(Bh-Oh),pt=Qe(zh-kh);if(C.ori==1){let te=lt;lt=pt,pt=te}an=dn.x&&lt>=dn.dist,ln=dn.y&&pt>=dn.dist;let Tt=dn.uni;Tt!=null?an&&ln&&(an=lt>=Tt,ln=pt>=Tt,!an&&!ln&&(pt>lt?ln=!0:an=!0)):dn.x&&dn.y&&(an||ln)&&(an=ln=!0);let At,Ut;an&&(C.ori==0?(At=Xs,Ut=Oe):(At=Ys,Ut=He),Br(pi(At,Ut),Qe(Ut-At)),ln||zr(0,it)),ln&&(C.ori==1?(At=Xs,Ut=Oe):(At=Ys,Ut=He),zr(pi(At,Ut),Qe(Ut-At)),an||Br(0,X)),!an&&!ln&&(Br(0,0),zr(0,0))}if(dn._x=an,dn._y=ln,g==null){if(A){if(Qh!=null){let[lt,pt]=qe.scales;qe.values[0]=lt!=null?vi(C.ori==0?Oe:He,lt):null,qe.values[1]=pt!=null?vi(C.ori==1?Oe:He,pt):null}Vr(Yl,n,Oe,He,v,I,P)}if(Dn){let lt=A&&qe.setSeries,pt=kn.prox;ms==null?Pi<=pt&&_i(ji,$s,!0,lt):Pi>pt?_i(null,$s,!0,lt):ji!=ms&&_i(ji,$s,!0,lt)}}dt&&(Mt.idx=P,Qa()),M!==!1&&cn("setCursor")}let Ji=null;Object.defineProperty(n,"rect",{get(){return Ji==null&&Hr(!1),Ji}});function Hr(g=!1){g?Ji=null:(Ji=_.getBoundingClientRect(),cn("syncRect",Ji))}function Gh(g,M,A,P,O,X,it){gt._lock||Ki&&g!=null&&g.movementX==0&&g.movementY==0||(tl(g,M,A,P,O,X,it,!1,g!=null),g!=null?gs(null,!0,!0):gs(M,!0,!1))}function tl(g,M,A,P,O,X,it,lt,pt){if(Ji==null&&Hr(!1),fn(g),g!=null)A=g.clientX-Ji.left,P=g.clientY-Ji.top;else{if(A<0||P<0){Oe=-10,He=-10;return}let[Tt,At]=qe.scales,Ut=M.cursor.sync,[te,ve]=Ut.values,[de,ae]=Ut.scales,[Kt,Ht]=qe.match,Be=M.axes[0].side%2==1,Ge=C.ori==0?v:I,hn=C.ori==1?v:I,be=Be?X:O,We=Be?O:X,Bn=Be?P:A,En=Be?A:P;if(de!=null?A=Kt(Tt,de)?a(te,S[Tt],Ge,0):-10:A=Ge*(Bn/be),ae!=null?P=Ht(At,ae)?a(ve,S[At],hn,0):-10:P=hn*(En/We),C.ori==1){let jn=A;A=P,P=jn}}pt&&(M==null||M.cursor.event.type==Yl)&&((A<=1||A>=v-1)&&(A=Ts(A,v)),(P<=1||P>=I-1)&&(P=Ts(P,I))),lt?(Oh=A,kh=P,[Xs,Ys]=gt.move(n,A,P)):(Oe=A,He=P)}const el={width:0,height:0,left:0,top:0};function nl(){Co(el,!1)}let Wh,Xh,Yh,qh;function $h(g,M,A,P,O,X,it){Ki=!0,an=ln=dn._x=dn._y=!1,tl(g,M,A,P,O,X,it,!0,!1),g!=null&&(Vt(ql,Kc,Kh,!1),Vr(Lf,n,Xs,Ys,v,I,null));let{left:lt,top:pt,width:Tt,height:At}=ke;Wh=lt,Xh=pt,Yh=Tt,qh=At}function Kh(g,M,A,P,O,X,it){Ki=dn._x=dn._y=!1,tl(g,M,A,P,O,X,it,!1,!0);let{left:lt,top:pt,width:Tt,height:At}=ke,Ut=Tt>0||At>0,te=Wh!=lt||Xh!=pt||Yh!=Tt||qh!=At;if(Ut&&te&&Co(ke),dn.setScale&&Ut&&te){let ve=lt,de=Tt,ae=pt,Kt=At;if(C.ori==1&&(ve=pt,de=At,ae=lt,Kt=Tt),an&&Zi(D,vi(ve,D),vi(ve+de,D)),ln)for(let Ht in S){let Be=S[Ht];Ht!=D&&Be.from==null&&Be.min!=Pe&&Zi(Ht,vi(ae+Kt,Ht),vi(ae,Ht))}nl()}else gt.lock&&(gt._lock=!gt._lock,gs(M,!0,g!=null));g!=null&&(Fe(ql,Kc),Vr(ql,n,Oe,He,v,I,null))}function Mm(g,M,A,P,O,X,it){if(gt._lock)return;fn(g);let lt=Ki;if(Ki){let pt=!0,Tt=!0,At=10,Ut,te;C.ori==0?(Ut=an,te=ln):(Ut=ln,te=an),Ut&&te&&(pt=Oe<=At||Oe>=v-At,Tt=He<=At||He>=I-At),Ut&&pt&&(Oe=Oe<Xs?0:v),te&&Tt&&(He=He<Ys?0:I),gs(null,!0,!0),Ki=!1}Oe=-10,He=-10,_t.fill(null),gs(null,!0,!0),lt&&(Ki=lt)}function Zh(g,M,A,P,O,X,it){gt._lock||(fn(g),St(),nl(),g!=null&&Vr(If,n,Oe,He,v,I,null))}function jh(){T.forEach(aT),Pt(n.width,n.height,!0)}Us(Aa,_r,jh);const Ks={};Ks.mousedown=$h,Ks.mousemove=Gh,Ks.mouseup=Kh,Ks.dblclick=Zh,Ks.setSeries=(g,M,A,P)=>{let O=qe.match[2];A=O(n,M,A),A!=-1&&_i(A,P,!0,!1)},jt&&(Vt(Lf,_,$h),Vt(Yl,_,Gh),Vt(Uf,_,g=>{fn(g),Hr(!1)}),Vt(Nf,_,Mm),Vt(If,_,Zh),ih.add(n),n.syncRect=Hr);const Po=n.hooks=i.hooks||{};function cn(g,M,A){Ka?kr.push([g,M,A]):g in Po&&Po[g].forEach(P=>{P.call(null,n,M,A)})}(i.plugins||[]).forEach(g=>{for(let M in g.hooks)Po[M]=(Po[M]||[]).concat(g.hooks[M])});const Jh=(g,M,A)=>A,qe=Ke({key:null,setSeries:!1,filters:{pub:Yf,sub:Yf},scales:[D,w[1]?w[1].scale:null],match:[qf,qf,Jh],values:[null,null]},gt.sync);qe.match.length==2&&qe.match.push(Jh),gt.sync=qe;const Qh=qe.key,il=Xp(Qh);function Vr(g,M,A,P,O,X,it){qe.filters.pub(g,M,A,P,O,X,it)&&il.pub(g,M,A,P,O,X,it)}il.sub(n);function Sm(g,M,A,P,O,X,it){qe.filters.sub(g,M,A,P,O,X,it)&&Ks[g](null,M,A,P,O,X,it)}n.pub=Sm;function ym(){il.unsub(n),ih.delete(n),Ct.clear(),Jc(Aa,_r,jh),c.remove(),et?.remove(),cn("destroy")}n.destroy=ym;function sl(){cn("init",i,t),ft(t||i.data,!1),W[D]?Za(D,W[D]):St(),ut=ke.show&&(ke.width>0||ke.height>0),F=dt=!0,Pt(i.width,i.height)}return w.forEach(fs),T.forEach(qa),e?e instanceof HTMLElement?(e.appendChild(c),sl()):e(n,sl):sl(),n}pn.assign=Ke;pn.fmtNum=Ah;pn.rangeNum=Ra;pn.rangeLog=za;pn.rangeAsinh=Th;pn.orient=zs;pn.pxRatio=xe;pn.join=JE;pn.fmtDate=Ch,pn.tzDate=cw;pn.sync=Xp;{pn.addGap=Xw,pn.clipGaps=Ga;let i=pn.paths={points:jp};i.linear=Qp,i.stepped=$w,i.bars=Kw,i.spline=jw}const md="10.5px system-ui, sans-serif";function Pa(i,t,e){return{label:i,labelSize:15,labelGap:0,labelFont:md,font:md,size:t,gap:3,stroke:()=>e().soft,grid:{stroke:()=>e().line,width:1},ticks:{stroke:()=>e().line,width:1,size:4}}}function im(i){i.ctx.canvas.setAttribute("aria-hidden","true")}class lT{constructor(t){this.plot=t,this.line=ye("div",{class:"now"}),im(t),t.over.append(this.line)}at(t){const e=this.plot.valToPos(t,"x"),n=Number.isFinite(e)&&e>=0&&e<=this.plot.over.clientWidth;this.line.hidden=!n,n&&(this.line.style.transform=`translateX(${e.toFixed(1)}px)`)}}function sm(i,t){const[e,n]=[t.clientWidth,t.clientHeight];return e===0||n===0||i.width===e&&i.height===n?!1:(i.setSize({width:e,height:n}),!0)}function cT(i,t){i.over.addEventListener("click",e=>{t(i.posToVal(e.clientX-i.over.getBoundingClientRect().left,"x"))})}const hT=6e3;class uT{constructor(t,e){this.painted=t,this.root=Yt("templates"),this.pace=new ka(200),this.rows=null,this.drawn=-1;const n=o=>()=>this.painted[o],s=(o,a)=>({label:o,stroke:n(a),paths:()=>null,points:{show:!0,size:3.5,width:0,fill:n(a),stroke:n(a)}}),r=()=>this.painted;this.plot=new pn({width:300,height:150,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,a+1)]},y:{range:(o,a,l)=>[0,Math.max(4,(l??0)*1.04,a)]}},axes:[Pa("data time, s",22,r),{...Pa("template",38,r),incrs:[1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4]}],series:[{},s("familiar","vermilion"),s("novel","blue")]},[[],[],[]],this.root),this.now=new lT(this.plot),cT(this.plot,e)}update(t,e){const n=t.colours!==this.painted;this.painted=t.colours;const s=sm(this.plot,this.root);n&&!s&&this.plot.redraw(!1);const{rows:r}=t;let o=!1;return(r!==this.rows||r.count!==this.drawn)&&(o=!this.pace.due(e),o||this.setData(r)),this.now.at(r.value(t.row,"stamp_s")),o}setData(t){this.rows=t,this.drawn=t.count;const[e,n,s]=["stamp_s","recognition","template_id"].map(a=>t.column(a)),r=og(t.count,hT),o=a=>r.map(l=>n[l]===a?s[l]:null);this.plot.setData([r.map(a=>e[a]),o(2),o(1)])}}const fT=300,Jl=.001,gd={source:"grey",odometry:"orange",place:"purple",cells:"green",map:"blue"};class dT{constructor(){this.root=Yt("timing"),this.table=Yt("stages"),this.pace=new ka(150),this.colours=null,this.stages=[],this.cells=[],this.plot=null,this.key=""}update(t,e){const n=mT(t),s=t.colours!==this.colours;if(this.colours=t.colours,n.join()!==this.stages.join()&&this.rebuild(n),this.plot===null)return!1;const r=sm(this.plot,this.root);s&&!r&&this.plot.redraw(!1);const o=`${t.row} ${t.rows.count}`;return o===this.key?!1:this.pace.due(e)?(this.key=o,this.show(t,this.plot),!1):!0}show({rows:t,row:e},n){const s=Math.max(0,e+1-fT),r=this.stages.map(l=>t.column(`${l}_ms`)),o=Array.from(t.column("frame").subarray(s,e+1)),a=r.map(l=>Array.from(l.subarray(s,e+1),c=>c>=0?Math.max(c,Jl):null));n.setData([o,...a]),r.forEach((l,c)=>{const u=this.cells[c];me(u.now,uo(l[e]??NaN)),me(u.median,uo(ag(l,s,e+1)))})}rebuild(t){this.stages=t,this.plot?.destroy(),this.cells=[],this.table.replaceChildren(...t.map(s=>this.makeRow(s)));const e=()=>this.colours,n=(s,r,o)=>[10**Math.floor(Math.log10(Math.max(r??1,Jl))),10**Math.ceil(Math.log10(Math.max(o??1,10*Jl)))];this.plot=new pn({width:200,height:150,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1},y:{distr:3,log:10,range:n}},axes:[{...Pa("frame",22,e),space:44},{...Pa("ms",34,e),values:(s,r)=>r.map(o=>pT(o)?String(+o.toPrecision(3)):"")}],series:[{},...t.map(s=>this.series(s))]},[[],...t.map(()=>[])],this.root),im(this.plot)}series(t){return{label:t,stroke:()=>this.colours?.[gd[t]??"sky"]??"#888",width:1.3,points:{show:!1}}}makeRow(t){const e=ye("tr"),n=ye("th",{scope:"row"}),s=`--swatch: var(--${gd[t]??"sky"})`;n.append(ye("i",{class:"swatch",style:s}),t);const r=ye("td",{"data-testid":`${t}-now`}),o=ye("td",{"data-testid":`${t}-median`});return e.append(n,r,o),this.cells.push({now:r,median:o}),e}}function pT(i){const t=Math.log10(i);return Math.abs(t-Math.round(t))<1e-9}function mT({info:i,rows:t}){return(i?.stages??[]).filter(e=>t.names.includes(`${e}_ms`))}const gT="M6 4.5h3v11H6zM11 4.5h3v11h-3z",_T="M6.5 4.2v11.6L16 10z";class vT{constructor(t,e){this.scrub=Yt("scrub"),this.play=Yt("play"),this.live=Yt("live"),this.speed=Yt("speed"),this.surface=new Da(Yt("strip")),this.texts={shape:Yt("play-shape"),frame:Yt("shown-frame"),of:Yt("of-frames"),time:Yt("shown-time")},this.pace=new ka(300),this.key="",this.scrub.oninput=()=>t.seek(Number(this.scrub.value)),this.play.onclick=()=>t.toggle(),this.live.onclick=()=>t.follow(),this.speed.onclick=()=>{t.player.cycleSpeed(),e()}}update(t,e){const{rows:n,row:s,mode:r}=t;tn(this.scrub,"max",String(Math.max(0,n.count-1))),this.scrub.value!==String(Math.max(0,s))&&(this.scrub.value=String(Math.max(0,s))),tn(this.scrub,"aria-valuetext",`frame ${ni(t.frame)}`);const o=r==="paused"||r==="live"&&!t.live;tn(this.texts.shape,"d",o?_T:gT),tn(this.play,"aria-label",o?"Play (space)":"Pause (space)"),me(this.live,t.live?"Live":"Newest"),tn(this.live,"aria-pressed",String(r==="live")),me(this.speed,`${t.speed}×`),me(this.texts.frame,ni(t.frame));const a=t.live&&t.info&&t.info.frames>0?t.info.frames-1:n.frame(n.count-1);return me(this.texts.of,` / ${ni(a)}`),me(this.texts.time,`${ng(n.value(s,"stamp_s")-n.value(0,"stamp_s"))} min`),this.updateStrip(t,e)}updateStrip(t,e){const n=`${t.rows.count} ${t.info?.name} ${Object.values(t.colours).join()}`,s=this.surface.fit();return n===this.key&&!s?!1:!s&&!this.pace.due(e)?!0:(this.key=n,this.drawStrip(t),!1)}drawStrip({rows:t,colours:e}){const n=this.surface.clear(),{width:s,height:r}=this.surface,o=t.count;if(o<2)return;const[a,l,c,u]=["v","recognition","action","tracking"].map(p=>t.column(p));let h=1e-6;for(let p=0;p<o;++p)h=Math.max(h,Math.abs(a[p])||0);const f=Math.max(1,Math.floor(s));for(let p=0;p<f;++p){const _=Math.floor(p*o/f),x=Math.max(_+1,Math.floor((p+1)*o/f));let[m,d,w,T]=[0,!1,!1,!1];for(let U=_;U<x;++U)m=Math.max(m,Math.abs(a[U])||0),d||=l[U]===2,w||=c[U]===2,T||=u[U]===2;const S=.55*r*m/h;n.fillStyle=T?e.purple:e.line,n.fillRect(p,r-5-S,1,S),n.fillStyle=d?e.faint:"transparent",n.fillRect(p,r-4,1,3),w&&(n.fillStyle=e.vermilion,n.fillRect(p,3,1.4,9))}}}const xT=100;class MT{constructor(){this.theme=new Rm(()=>this.invalidate()),this.session=new tg(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live`,()=>this.invalidate()),this.map=new aE(()=>this.invalidate()),this.cells=new wy(()=>this.invalidate()),this.drawn=new vd(1),this.draws=0,this.waiting=!1,this.later=0,this.last=performance.now();const t=e=>this.session.seekFrame(e);this.panels=[new fE(this.session),new Ay,new cg,new uE,this.map,this.cells,new uT(this.theme.colours,e=>this.seekTime(e)),new dT,new Cy(t),new vT(this.session,()=>this.invalidate())],this.bindKeys(),Yt("theme").onclick=()=>this.theme.toggle(),Yt("help-open").onclick=()=>this.openHelp(),new ResizeObserver(()=>this.invalidate()).observe(document.documentElement),Em(()=>this.session.view(this.theme.colours),this.map,()=>this.drawn.rate(performance.now()/1e3)),this.session.open()}invalidate(){this.waiting||(this.waiting=!0,requestAnimationFrame(t=>this.draw(t)))}draw(t){this.waiting=!1,this.session.tick((t-this.last)/1e3),this.last=t;const e=this.session.view(this.theme.colours);let n=!1;for(const s of this.panels)n=s.update(e,t)||n;this.drawn.note(++this.draws,t/1e3),e.mode==="playing"&&this.invalidate(),this.scheduleLater(n?xT:e.live?1e3:0)}scheduleLater(t){window.clearTimeout(this.later),t>0&&(this.later=window.setTimeout(()=>this.invalidate(),t))}seekTime(t){const{rows:e}=this.session.view(this.theme.colours);let s=e.column("stamp_s").subarray(0,e.count).findIndex(r=>r>=t);s<0&&(s=e.count-1),this.session.seek(s)}step(t,e){this.session.seek(this.session.player.row+e*(t.shiftKey?10:1))}openHelp(){Yt("help").showModal()}bindKeys(){const{session:t,map:e}=this;wm([{keys:[" "],shown:"space",meaning:"pause, or play what is recorded",act:()=>t.toggle()},{keys:["ArrowLeft"],shown:"←",meaning:"a frame back (with shift: ten)",act:n=>this.step(n,-1)},{keys:["ArrowRight"],shown:"→",meaning:"a frame on (with shift: ten)",act:n=>this.step(n,1)},{keys:["PageUp"],shown:"PgUp",meaning:"a hundred frames back",act:()=>t.seek(t.player.row-100)},{keys:["PageDown"],shown:"PgDn",meaning:"a hundred frames on",act:()=>t.seek(t.player.row+100)},{keys:["Home"],shown:"home",meaning:"first frame",act:()=>t.seek(0)},{keys:["End","l"],shown:"end l",meaning:"newest frame, and follow the run",act:()=>t.follow()},{keys:["s"],shown:"s",meaning:"speed of playing",act:()=>Yt("speed").click()},{keys:["+","="],shown:"+",meaning:"map nearer",act:()=>e.zoomBy(1.25)},{keys:["-"],shown:"-",meaning:"map farther",act:()=>e.zoomBy(.8)},{keys:["f"],shown:"f",meaning:"fit the whole map",act:()=>e.fit()},{keys:["c"],shown:"c",meaning:"keep the robot in the middle",act:()=>e.toggleCentre()},{keys:["2"],shown:"2",meaning:"map from above",act:()=>e.choose("2d")},{keys:["3"],shown:"3",meaning:"map in space",act:()=>e.choose("3d")},{keys:["g"],shown:"g",meaning:"grid cells as sheet or torus",act:()=>this.cells.toggleTorus()},{keys:["t"],shown:"t",meaning:"light or dark",act:()=>this.theme.toggle()},{keys:["?"],shown:"?",meaning:"this help",act:()=>this.openHelp()}])}}new MT;
