function Wm(i,t,e){Object.defineProperty(window,"tolman",{value:Object.freeze({get rows(){return i().rows.count},get newestFrame(){return i().rows.frame(i().rows.count-1)},get shownFrame(){return i().frame},get imageFrame(){return i().picture?.frame??NaN},get mode(){return i().mode},get live(){return i().live},get graph(){const{experiences:s,links:r,loops:o,rejected:a,version:l}=i().graph;return{experiences:s,links:r,loops:o,rejected:a,version:l}},get map(){return{zoom:t.zoom,centre:t.centre,dimension:t.dimension,renders:t.renders}},get fps(){return e()},get dropped(){return i().dropped},get nodes(){return document.getElementsByTagName("*").length},row(s){const{rows:r}=i();return Object.fromEntries(r.names.map(o=>[o,r.value(s,o)]))}})})}function Gt(i){const t=document.getElementById(i);if(t===null)throw new Error(`no element #${i}`);return t}function gr(i){const t=document.querySelector(`[data-testid="${i}"]`);if(t===null)throw new Error(`no element for ${i}`);return t}function he(i,t){i.textContent!==t&&(i.textContent=t)}function tn(i,t,e){i.getAttribute(t)!==e&&i.setAttribute(t,e)}function ue(i,t={},e=""){const n=document.createElement(i);for(const[s,r]of Object.entries(t))n.setAttribute(s,r);return e!==""&&(n.textContent=e),n}class Fa{constructor(t){this.canvas=t,this.width=0,this.height=0;const e=t.getContext("2d");if(e===null)throw new Error("no 2-D canvas");this.context=e}fit(){const t=this.canvas.clientWidth,e=this.canvas.clientHeight,n=window.devicePixelRatio,[s,r]=[Math.round(t*n),Math.round(e*n)];return this.canvas.width===s&&this.canvas.height===r?!1:([this.canvas.width,this.canvas.height]=[s,r],[this.width,this.height]=[t,e],!0)}clear(){const t=window.devicePixelRatio;return this.context.setTransform(t,0,0,t,0,0),this.context.clearRect(0,0,this.width,this.height),this.context}}function Xm(i){const t=new Map(i.flatMap(e=>e.keys.map(n=>[n,e])));document.addEventListener("keydown",e=>{if(e.ctrlKey||e.metaKey||e.altKey||document.querySelector("dialog[open]")!==null)return;const n=t.get(e.key);n===void 0||Ym(e)||(e.preventDefault(),n.act(e))}),qm(i)}function Ym(i){const t=i.target;return i.key===" "?t.matches("button, input[type=checkbox]"):t.matches("#events")&&["ArrowUp","ArrowDown","Home","End"].includes(i.key)}function qm(i){const t=i.map(({shown:e,meaning:n})=>{const s=ue("tr"),r=ue("td");return r.append(...e.split(" ").map(o=>ue("kbd",{},o))),s.append(r,ue("td",{},n)),s});Gt("keys").replaceChildren(...t)}const $m=["ink","soft","faint","line","panel","well","blue","orange","green","vermilion","purple","sky","grey","accent","truth","rejected"],Rd="tolman.theme";class jm{constructor(t){this.changed=t,this.system=matchMedia("(prefers-color-scheme: dark)"),this.chosen=null,this.chosen=Km(),this.system.addEventListener("change",()=>this.apply()),this.colours_=this.show()}get name(){return this.chosen??(this.system.matches?"dark":"light")}get colours(){return this.colours_}toggle(){this.chosen=this.name==="dark"?"light":"dark";try{localStorage.setItem(Rd,this.chosen)}catch{}this.apply()}apply(){this.colours_=this.show(),this.changed()}show(){document.documentElement.dataset.theme=this.name;const t=getComputedStyle(document.documentElement),e=$m.map(n=>[n,t.getPropertyValue(`--${n}`).trim()]);return Object.fromEntries(e)}}function Km(){try{const i=localStorage.getItem(Rd);return i==="light"||i==="dark"?i:null}catch{return null}}class Cd{constructor(t){this.window=t,this.times=[],this.counts=[]}note(t,e){this.times.push(e),this.counts.push(t),this.forget(e)}rate(t){if(this.forget(t),this.times.length<2)return 0;const e=Math.max(t,this.times[this.times.length-1])-this.times[0],n=this.counts[this.counts.length-1]-this.counts[0];return e>0?n/e:0}forget(t){let e=0;for(;e<this.times.length&&this.times[e]<t-this.window;)++e;e>0&&(this.times.splice(0,e),this.counts.splice(0,e))}}const Zm={u8:{size:1,make:(i,t,e)=>new Uint8Array(i,t,e)},i32:{size:4,make:(i,t,e)=>new Int32Array(i,t,e)},f32:{size:4,make:(i,t,e)=>new Float32Array(i,t,e)},f64:{size:8,make:(i,t,e)=>new Float64Array(i,t,e)}};class ii extends Error{}function Pd(i){return typeof i=="object"&&i!==null&&!Array.isArray(i)}function Dd(i){if(i.byteLength<4)throw new ii("message shorter than its length field");const t=new DataView(i).getUint32(0,!0);if(4+t>i.byteLength)throw new ii("header longer than the message");const e=Jm(new Uint8Array(i,4,t)),n=e.type;if(typeof n!="string")throw new ii("header without a type");const s=Math.ceil((4+t)/8)*8;return{type:n,header:e,arrays:Qm(i,s,e.arrays)}}function Jm(i){let t;try{t=JSON.parse(new TextDecoder("utf-8",{fatal:!0}).decode(i))}catch{throw new ii("header is not JSON")}if(!Pd(t))throw new ii("header is not an object");return t}function Qm(i,t,e){const n=new Map;if(e===void 0)return n;if(!Array.isArray(e))throw new ii('"arrays" is not a list');for(const s of e){if(!Pd(s))throw new ii("an array is not described by an object");const r=s.name;if(typeof r!="string")throw new ii("an array without a name");n.set(r,tg(i,t,r,s))}return n}function tg(i,t,e,n){const s=Zm[String(n.dtype)],r=n.shape,o=n.offset;if(s===void 0)throw new ii(`array ${e}: unknown dtype`);if(!Array.isArray(r)||!r.every(ou))throw new ii(`array ${e}: shape`);if(!ou(o)||o%8!==0)throw new ii(`array ${e}: offset`);const a=r.reduce((l,c)=>l*c,1);if(t+o+a*s.size>i.byteLength)throw new ii(`array ${e} reaches beyond the message`);return{shape:r,values:s.make(i,t+o,a)}}function ou(i){return typeof i=="number"&&Number.isInteger(i)&&i>=0}const Ea=["frame.frame","frame.time","frame.source_index","frame.has_truth","motion.state","motion.dt","motion.v","motion.omega","motion.scale_known","motion.tracked","motion.is_keyframe","motion.points_frame","place.recognition","place.template_id","place.score","place.relative_yaw","place.has_relative_pose","candidate.template_id","candidate.score","candidate.limit","candidate.agreeing","candidate.compared","candidate.needed","decision.action","decision.experience","decision.template_id","decision.relative_yaw","decision.has_relative_pose","decision.heading","decision.confidence","hypothesis.id","hypothesis.fate","hypothesis.experience","hypothesis.energy","hypothesis.change","hypothesis.share","hypothesis.limit","hypothesis.views","hypothesis.unsupported","map_update.experience","map_update.version","map_update.experiences","map_update.links","map_update.loops","odometry.x","odometry.y","odometry.z","map.x","map.y","map.z","truth.x","truth.y","truth.z","anchor.x","anchor.y","anchor.z","anchor.yaw","measured.error","measured.sigmas","duration.source","duration.odometry","duration.place","duration.cells","duration.map"],$n={"motion.state":["initialising","tracking","lost"],"place.recognition":["none","novel","familiar"],"decision.action":["stay","create_experience","close_loop"],"hypothesis.fate":["born","grew","accepted","faded","displaced"]};function po({header:i}){return i}function eg(i){return i.columns.map(t=>t.name).join()===Ea.join()}function Ld(i,t){const e=i.arrays.get("rows");return!(e?.values instanceof Float64Array)||e.shape.length!==2?null:{from:t,columns:e.shape[1]??0,values:e.values}}const au="cells.";function ng(i){const t=[];for(const[e,{shape:n,values:s}]of i.arrays)e.startsWith(au)&&s instanceof Float32Array&&t.push({name:e.slice(au.length),shape:n,values:s});return t}function Ud(i){const t=po(i),e=i.arrays.get("image")?.values,n=i.arrays.get("points")?.values;return{header:t,image:e instanceof Uint8Array&&e.length>0?e:null,points:n instanceof Float32Array?n:null,arrays:ng(i),rows:Ld(i,t.rows_from)}}function Id(i){const t=l=>i.arrays.get(l)?.values,e=t("experience"),n=t("link"),s=t("link_kind"),r=t("link_rejected"),o=t("loop"),a=t("loop_residual");return{header:po(i),experience:e instanceof Float32Array?e:new Float32Array,link:n instanceof Int32Array?n:new Int32Array,linkKind:s instanceof Uint8Array?s:new Uint8Array,linkRejected:r instanceof Uint8Array?r:new Uint8Array,loop:o instanceof Int32Array?o:new Int32Array,loopResidual:a instanceof Float32Array?a:new Float32Array}}const Nd=1e4;async function ah(i){const t=await fetch(i,{cache:"no-store"});if(t.status===404)return null;if(!t.ok)throw new Error(`${i}: ${t.status}`);return Dd(await t.arrayBuffer())}async function lu(i,t){const e=Math.min(t,Nd),n=await ah(`/api/history?from=${i}&count=${e}`);return n&&Ld(n,po(n).from)}async function ig(i){const t=await ah(`/api/frame/${i}`);return t&&Ud(t)}async function sg(){const i=await ah("/api/graph");return i&&Id(i)}function rg(i){return`/api/template/${i}`}const cu=.5,og=10;function ag(i){return Math.min(og,i*2)}class lg{constructor(t,e){this.address=t,this.listener=e,this.socket=null,this.wait=cu,this.live=!0,this.ended=!1}open(){this.ended=!1,this.listener.state("connecting",0);const t=new WebSocket(this.address);t.binaryType="arraybuffer",this.socket=t,t.onopen=()=>{this.live||this.say(),this.listener.state("open",0)},t.onmessage=e=>this.receive(e.data),t.onclose=()=>this.closed()}setFlow(t){this.live!==t&&(this.live=t,this.say())}say(){this.socket?.readyState===WebSocket.OPEN&&this.socket.send(JSON.stringify({type:"flow",live:this.live}))}receive(t){if(!(t instanceof ArrayBuffer))return;const e=Dd(t);e.type==="hello"&&(this.wait=cu),e.type==="end"&&(this.ended=!0),this.listener.message(e)}closed(){if(this.socket=null,this.ended){this.listener.state("ended",0);return}const t=this.wait;this.wait=ag(t),this.listener.state("waiting",t),setTimeout(()=>this.open(),t*1e3)}}const hu=1e3,cg=2e4,hg=$n["motion.state"].indexOf("tracking"),cl=$n["motion.state"].indexOf("lost"),ug=$n["decision.action"].indexOf("close_loop");class fg{constructor(){this.logged=[],this.moments=[],this.seen=new Set,this.scanned=0,this.edition_=0}get edition(){return this.edition_}get count(){return this.logged.length+this.moments.length}clear(){this.logged=[],this.moments=[],this.seen.clear(),this.scanned=0,++this.edition_}add(t){for(const e of t){const n=`${e.frame} ${e.source} ${e.message}`;this.seen.has(n)||(this.seen.add(n),this.logged.push(e),++this.edition_)}this.logged.length>hu&&(this.logged.splice(0,this.logged.length-hu),this.seen=new Set(this.logged.map(e=>`${e.frame} ${e.source} ${e.message}`)))}scan(t){for(;this.scanned<t.count;++this.scanned)for(const e of dg(t,this.scanned))this.moments.length<cg&&this.moments.push(e),++this.edition_}newest(t,e){return[...uu(this.logged,t,e),...uu(this.moments,t,e)].sort((s,r)=>r.frame-s.frame).slice(0,e)}}function uu(i,t,e){const n=[];for(let s=i.length-1;s>=0&&n.length<e;--s){const r=i[s];r.frame<=t&&n.push(r)}return n}function dg(i,t){const e=[],n=i.frame(t),s=(u,h,f)=>e.push({frame:n,level:u,source:h,message:f}),r=i.value(t,"motion.state"),o=i.value(t-1,"motion.state");if(r===cl&&o!==cl&&s("warning","odometry","tracking lost"),r===hg&&o===cl&&s("info","odometry","tracking again"),i.value(t,"decision.action")!==ug)return e;const a=i.value(t,"decision.experience"),l=i.value(t,"place.template_id"),c=l>=0?` by template ${l}`:"";return s("loop","cells",`loop to experience ${a}${c}`),e}const pg=24;class mg{constructor(t,e,n){this.fetchFrame=t,this.arrived=e,this.failed=n,this.kept=new Map,this.busy=!1,this.next=null}get loading(){return this.busy}clear(){this.kept.clear(),this.next=null}keep(t){(t.image!==null||t.arrays.length>0)&&this.remember(t.header.frame,t)}want(t){const e=this.kept.get(t);if(e!==void 0){this.next=null,this.remember(t,e),this.arrived(t,e);return}this.next=t,this.busy||this.fetchNext()}remember(t,e){this.kept.delete(t),this.kept.set(t,e);for(const n of this.kept.keys()){if(this.kept.size<=pg)break;this.kept.delete(n)}}async fetchNext(){for(this.busy=!0;this.next!==null;){const t=this.next;this.next=null;try{const e=await this.fetchFrame(t);e!==null&&this.remember(t,e),this.arrived(t,e)}catch(e){this.failed(e)}}this.busy=!1}}class gg{constructor(){this.message=null,this.loops_=0,this.rejected_=0,this.edition_=0}get experiences(){return this.message?this.message.experience.length/4:0}get links(){return this.message?this.message.linkKind.length:0}get loops(){return this.loops_}get rejected(){return this.rejected_}get version(){return this.message?.header.version??-1}get frame(){return this.message?.header.frame??-1}get edition(){return this.edition_}replace(t){t&&this.message&&du(t)<du(this.message)||this.set(t)}clear(){this.set(null)}position(t){const e=this.message?.experience??fu,n=4*t;return[e[n]??NaN,e[n+1]??NaN,e[n+2]??NaN]}heading(t){return this.message?.experience[4*t+3]??NaN}*loopLinks(){const{loop:t=new Int32Array,loopResidual:e=fu}=this.message??{},n=s=>t[s];for(let s=0;s<t.length;s+=4)yield[n(s),n(s+1),n(s+2),n(s+3),e[s/4]??-1]}ends(t){const e=this.message?.link;return[e?.[2*t]??-1,e?.[2*t+1]??-1]}isLoop(t){return this.message?.linkKind[t]===1}isRejected(t){return this.message?.linkRejected[t]===1}set(t){this.message=t,this.rejected_=t?t.linkRejected.reduce((n,s)=>n+s,0):0;const e=t?.linkKind??new Uint8Array;this.loops_=e.reduce((n,s)=>n+(s===1?1:0),0)-this.rejected_,++this.edition_}}const fu=new Float32Array;function du({header:i}){return i.frame<0?1/0:i.frame}class pu{constructor(t,e,n){this.store=t,this.fetchRows=e,this.loaded=n,this.busy=!1,this.wanted=0}get loading(){return this.busy}async catchUp(t){if(this.wanted=Math.max(this.wanted,t),!this.busy){this.busy=!0;try{for(;this.store.count<this.wanted;){const e=this.store.count,n=await this.fetchRows(e,Math.min(this.wanted-e,Nd));if(n!==null&&this.store.add(n),this.loaded(),this.store.count===e)break}}finally{this.busy=!1}}}}class _g{constructor(t){this.changed=t,this.shown=null,this.next=null,this.busy=!1}get picture(){return this.shown}clear(){this.next=null,this.shown?.bitmap.close(),this.shown=null}dropAfter(t){(this.shown?.frame??t)>t&&this.clear()}decode(t){t.image===null||t.header.frame===this.shown?.frame||(this.next=t,this.busy||this.work())}async work(){for(this.busy=!0;this.next?.image;){const{image:t,header:e}=this.next;this.next=null;const n=new Blob([t.slice()],{type:"image/jpeg"}),s=await createImageBitmap(n).catch(()=>null);s!==null&&(this.shown?.bitmap.close(),this.shown={frame:e.frame,bitmap:s},this.changed())}this.busy=!1}}const hl=[1,2,5,10,50],vg=.25;class xg{constructor(){this.mode_="live",this.row_=-1,this.clock=0,this.speed_=1}get mode(){return this.mode_}get row(){return this.row_}get speed(){return this.speed_}reset(){this.mode_="live",this.row_=-1}grow(t){return this.mode_!=="live"||this.row_===t-1?!1:(this.row_=t-1,!0)}follow(t){this.mode_="live",this.row_=t-1}pause(){this.mode_="paused"}seek(t,e){this.mode_="paused",this.row_=Math.max(0,Math.min(e-1,Math.round(t)))}play(t,e){this.row_>=e-1&&(this.row_=0),this.clock=t[this.row_]??0,this.mode_="playing"}cycleSpeed(){const t=hl.findIndex(e=>e===this.speed_);this.speed_=hl[(t+1)%hl.length]??1}tick(t,e,n){if(this.mode_!=="playing")return!1;this.clock+=Math.min(t,vg)*this.speed_;const s=this.row_;for(;this.row_+1<n&&(e[this.row_+1]??1/0)<=this.clock;)++this.row_;return this.row_>=n-1&&(this.mode_="paused"),this.row_!==s||this.mode_==="paused"}}const ul=1024;class mu{constructor(t){this.names=t,this.columns=new Map,this.early=[],this.capacity=ul,this.length=0,this.templates_=new Int32Array(ul),this.firstRows=[];for(const e of t)this.columns.set(e,new Float64Array(ul))}get count(){return this.length}get gap(){return this.early.length>0?this.length:-1}column(t){return this.columns.get(t)??yg}value(t,e){return t<0||t>=this.length?NaN:this.columns.get(e)?.[t]??NaN}templates(t){return t>=0&&t<this.length?this.templates_[t]??0:0}frameOfTemplate(t){return this.frame(this.firstRows[t]??-1)}frame(t){return this.value(t,"frame.frame")}rowOfFrame(t){const e=this.column("frame.frame");let n=0,s=this.length;for(;n<s;){const r=n+s>>1;(e[r]??1/0)<=t?n=r+1:s=r}return n-1}add(t){if(t.columns!==this.names.length)throw new Error("rows with other columns");const e=this.length;for(this.early.push(t),this.early.sort((n,s)=>n.from-s.from);this.early.length>0&&this.early[0].from<=this.length;)this.append(this.early.shift());return this.length>e}append(t){const e=Math.floor(t.values.length/t.columns),n=this.length-t.from;if(n>=e)return;this.reserve(t.from+e),this.names.forEach((r,o)=>{const a=this.column(r);for(let l=n;l<e;++l)a[t.from+l]=t.values[l*t.columns+o]});const s=this.length;this.length=t.from+e,this.countTemplates(s)}countTemplates(t){const e=this.column("place.template_id");let n=t>0?this.templates_[t-1]:0;for(let s=t;s<this.length;++s){const r=e[s];r!==void 0&&r+1>n&&(n=r+1,this.firstRows[r]=s),this.templates_[s]=n}}reserve(t){if(t<=this.capacity)return;for(;this.capacity<t;)this.capacity*=2;for(const[n,s]of this.columns){const r=new Float64Array(this.capacity);r.set(s),this.columns.set(n,r)}const e=new Int32Array(this.capacity);e.set(this.templates_),this.templates_=e}}const yg=new Float64Array;class Mg{constructor(t,e){this.changed=e,this.player=new xg,this.trouble=null,this.info=null,this.rows=new mu(Ea),this.loader=new pu(this.rows,lu,()=>{}),this.graph=new gg,this.events=new fg,this.rate=new Cd(5),this.message=null,this.link="connecting",this.live=!1,this.recorded=!1,this.reading=!1,this.endState="",this.dropped=0,this.streamed=0,this.graphAsked=!1,this.frames=new mg(ig,(n,s)=>this.stored(n,s),()=>this.lostServer()),this.pictures=new _g(e),this.connection=new lg(t,{message:n=>this.receive(n),state:(n,s)=>this.linkChanged(n,s)})}open(){this.connection.open()}state(t){const e=Math.min(this.player.row,this.rows.count-1);return{info:this.info,rows:this.rows,row:e,frame:this.rows.frame(e),message:this.message,picture:this.pictures.picture,graph:this.graph,events:this.events,mode:this.player.mode,speed:this.player.speed,live:this.live,loading:this.loader.loading||this.reading,recorded:this.recorded,link:this.link,rate:this.live?this.rate.rate(performance.now()/1e3):NaN,dropped:this.dropped,colours:t}}get count(){return this.rows.count}get end(){return this.endState}seek(t){this.rows.count!==0&&(this.player.seek(t,this.rows.count),this.shownChanged())}seekFrame(t){this.seek(this.rows.rowOfFrame(t))}follow(){this.player.follow(this.rows.count),this.shownChanged()}toggle(){this.player.mode!=="paused"?this.player.pause():this.player.play(this.rows.column("frame.time"),this.rows.count),this.shownChanged()}tick(t){const e=this.rows.column("frame.time");if(!this.player.tick(t,e,this.rows.count))return;this.live&&this.player.mode==="paused"?this.follow():this.shownChanged()}receive(t){t.type==="hello"?this.hello(po(t)):t.type==="frame"?this.frame(Ud(t)):t.type==="graph"?this.graph.replace(Id(t)):t.type==="end"&&this.finish(po(t).state),this.changed()}hello(t){if(!eg(t)){this.trouble={kind:"other_version",until:0};return}const{run:e}=t;this.info?.name===e.name&&this.info.directory===e.directory&&t.rows>=this.rows.count||this.restart(),this.info=e,this.live=t.live&&!t.recorded,this.recorded=t.recorded,this.reading=t.recorded&&t.live,this.endState="",this.trouble=null,this.dropped=0,this.connection.setFlow(this.player.mode==="live"),this.catchUp(t.rows)}restart(){this.rows=new mu(Ea),this.loader=new pu(this.rows,lu,()=>this.grown()),this.graph.clear(),this.events.clear(),this.frames.clear(),this.player.reset(),this.message=null,this.pictures.clear(),this.graphAsked=!1}async catchUp(t){try{await this.loader.catchUp(t)}catch{this.lostServer();return}this.grown();const e=this.rows.count-1;this.rows.value(e,"map_update.experiences")>0&&this.graph.experiences===0&&!this.graphAsked&&(this.graphAsked=!0,this.graph.replace(await sg().catch(()=>null)),this.changed()),this.message===null&&e>=0&&this.shownChanged()}frame(t){if(this.dropped=t.header.dropped,this.events.add(t.header.events),this.frames.keep(t),t.rows!==null){const e=t.rows.values.length/t.rows.columns,n=t.rows.from+e;this.streamed+=e,this.rows.add(t.rows),this.rows.gap>=0&&this.catchUp(n)}this.rate.note(this.streamed,performance.now()/1e3),this.player.mode==="live"&&this.show(t),this.grown()}grown(){this.events.scan(this.rows),this.player.grow(this.rows.count),this.changed()}finish(t){this.live=!1,this.reading=!1,this.endState=t}shownChanged(){const{mode:t,row:e}=this.player;this.connection.setFlow(t==="live");const n=t==="live"&&this.live&&this.message!==null;e>=0&&!n&&this.frames.want(this.rows.frame(e)),this.changed()}stored(t,e){this.trouble?.kind==="no_frames"&&(this.trouble=null);const n=this.player.mode==="live"&&(this.message?.header.frame??-1)>t;!n&&!e?.image&&this.pictures.dropAfter(t),e!==null&&!n&&(this.events.add(e.header.events),this.show(e)),this.changed()}show(t){this.message=t,this.pictures.decode(t)}lostServer(){(this.link==="ended"||this.endState!=="")&&(this.trouble={kind:"no_frames",until:0}),this.changed()}linkChanged(t,e){this.link=t,t==="waiting"&&(this.trouble={kind:"gone",until:performance.now()+1e3*e}),this.changed()}}const No=[[68,1,84],[71,44,122],[59,81,139],[44,113,142],[33,144,141],[39,173,129],[92,200,99],[170,220,50],[253,231,37]];function Oa(i){const e=(i>0?Math.min(i,1):0)*(No.length-1),n=Math.min(Math.floor(e),No.length-2),s=e-n,r=No[n],o=No[n+1],a=l=>Math.round((1-s)*r[l]+s*o[l]);return[a(0),a(1),a(2)]}function lh([i,t,e]){return`rgb(${i} ${t} ${e})`}function Sg(i,t=0){return Array.from({length:i},(e,n)=>lh(Oa(t+(1-t)*n/Math.max(1,i-1))))}function ch(){const i=new Uint8ClampedArray(1024);for(let t=0;t<256;++t)i.set([...Oa(t/255),255],4*t);return i}function gu(i,{near:t,far:e}){if(!(i>0))return 0;const n=Math.log(e/i)/Math.log(e/t);return Math.max(0,Math.min(1,n))}const Lr="–";function ni(i){return Number.isFinite(i)?Math.round(i).toString():Lr}function mo(i,t){if(!Number.isFinite(i))return Lr;const e=i.toFixed(t);return Number(e)===0?e.replace("-",""):e}function ri(i){if(!Number.isFinite(i))return Lr;const t=Math.abs(i);return mo(i,t>=100?0:t>=10?1:t>=.1||t===0?2:3)}function Fd(i){return Number.isFinite(i)?`${mo(i*180/Math.PI,1)}°`:Lr}function Od(i){return i>=1e3?`${Number(i.toPrecision(6))/1e3} km`:`${Number(i.toPrecision(3))} m`}function kd(i){return`${ri(i)} units`}function Eg(i){if(!Number.isFinite(i))return Lr;if(Math.round(10*i)<600)return`${mo(i,1)} s`;const t=Math.round(i)>=3600,e=Math.round(t?i/60:i);return`${Math.floor(e/60)}:${String(e%60).padStart(2,"0")} ${t?"h":"min"}`}function Bd(i,t){return $n[i][t]?.replace("_"," ")??Lr}function wg(i,t){const e=Math.max(1,Math.ceil(i/t)),n=[];for(let s=0;s<i;s+=e)n.push(s);return i>0&&n[n.length-1]!==i-1&&n.push(i-1),n}function Tg(i,t,e){const n=i.slice(Math.max(0,t),e).filter(Number.isFinite).sort();if(n.length===0)return NaN;const s=n.length>>1,r=n[s];return n.length%2===1?r:(n[s-1]+r)/2}function _u(i,t){const e=Float64Array.from(i).filter(n=>Number.isFinite(n)&&n>0).sort();return e.length===0?NaN:e[Math.min(e.length-1,Math.floor(t*e.length))]}function ka(i){const t=10**Math.floor(Math.log10(i)+1e-12),e=i/t;return t*(e>=5-1e-9?5:e>=2-1e-9?2:1)}function vu(i){const t=ka(i);if(t>=i*(1-1e-9))return t;const e=Math.round(t/10**Math.floor(Math.log10(t)+1e-12));return t*(e===2?2.5:2)}class bg{constructor(){this.range_=null}get range(){return this.range_}clear(){this.range_=null}include(t){const e=new Float32Array(t.length/4);for(let o=0;o<e.length;++o)e[o]=t[4*o+2];const n=ka(1/_u(e,.98)),s=vu(1/_u(e,.04));if(!Number.isFinite(n)||!Number.isFinite(s)||n>=s)return;const r=this.range_;this.range_=r?{near:Math.min(r.near,n),far:Math.max(r.far,s)}:{near:n,far:s}}ticks(){if(this.range_===null)return[];const{near:t,far:e}=this.range_,n=[];for(let s=t;s<=e*1.001;s=vu(s*1.01))n.push(s);return n}}const xu=Sg(64,.12),Fo=2.4;class Ag{constructor(){this.surface=new Fa(Gt("camera")),this.empty=Gt("camera-empty"),this.legend=Gt("depth"),this.count=gr("points"),this.note=Gt("points-note"),this.depths=new bg,this.picture=null,this.points=null}update(t){const e=t.message?.points?t.message:null;return!this.surface.fit()&&this.picture===t.picture&&this.points===e||(this.picture=t.picture,this.points=e,this.empty.hidden=t.picture!==null||e!==null,e?.points&&(this.depths.include(e.points),this.drawLegend(t.rows.value(t.row,"motion.scale_known")!==0)),this.describe(e),this.draw(t)),!1}describe(t){he(this.count,t?.points?String(t.points.length/4):"–");const e=t!==null&&t.header.points_frame!==t.header.frame;he(this.note,e?` of frame ${t.header.points_frame}`:"")}draw(t){const[e,n]=[t.info?.source.rig.width||t.picture?.bitmap.width||0,t.info?.source.rig.height||t.picture?.bitmap.height||0],s=this.surface.clear();if(e===0||n===0)return;this.surface.canvas.parentElement?.style.setProperty("--shape",String(e/n));const r=Math.min(this.surface.width/e,this.surface.height/n);s.translate((this.surface.width-e*r)/2,(this.surface.height-n*r)/2),t.picture&&(s.imageSmoothingQuality="high",s.drawImage(t.picture.bitmap,0,0,e*r,n*r)),this.drawPoints(s,r)}drawPoints(t,e){const n=this.points?.points,s=this.depths.range;if(!(!n||s===null))for(let r=0;r+3<n.length;r+=4){const o=gu(1/n[r+2],s);t.fillStyle=xu[Math.round(o*(xu.length-1))];const a=n[r]*e-Fo/2,l=n[r+1]*e-Fo/2;t.fillRect(a,l,Fo,Fo)}}drawLegend(t){const e=this.depths.range;if(e===null)return;const n=`${e.near} ${e.far} ${t}`;if(this.legend.dataset.range===n)return;this.legend.dataset.range=n;const s=[1,.75,.5,.25,0].map(r=>lh(Oa(.12+.88*r)));this.legend.style.background=`linear-gradient(to right, ${s.join(", ")})`,this.legend.replaceChildren(...Rg(this.depths.ticks()).map((r,o)=>{const a=`left: ${(100*(1-gu(r,e))).toFixed(2)}%`;return ue("span",{style:a},(t?Od:o===0?kd:ri)(r))}))}}function Rg(i){if(i.length<=7)return i;const t=Math.ceil((i.length-1)/6);return i.filter((e,n)=>n%t===0)}const Cg=12,Pg=4;function Dg(i,t){const e=i.filter(a=>a.values.length>0).map(a=>({...a,info:Lg(a,t)})),n=e.filter(({info:a,shape:l})=>a.kind==="activity"&&(l.length===1||l.length===2)&&a.axes.length===l.length),s=e.filter(({info:a,shape:l})=>a.kind==="bump"&&hh(a,l).length>0),r=n.map(a=>Ug(a,s,n)),o=new Set([...n,...s.filter(a=>n.some(l=>zd(a,l,n)))]);return{rings:r.filter(a=>a.shape.length===1),sheets:r.filter(a=>a.shape.length===2),others:e.filter(a=>!o.has(a))}}function Lg({name:i,shape:t},e){const n=e.find(l=>l.name===i);if(n!==void 0)return n;const s=e.length===0,r=s&&t.length===1&&t[0]>=Cg,o=s&&t.length===2&&t.every(l=>l>=Pg),a=t.map((l,c)=>({name:`axis ${c}`,unit:"",period:l,first:0,step:1,labels:[]}));return{name:i,kind:r||o?"activity":"values",unit:"",doc:"",population:"",axes:a}}function hh(i,t){const e=i.axes[i.axes.length-1]?.labels??[];return(t.length===1||t.length===2)&&e.length===t[t.length-1]?e:[]}function zd({info:i,shape:t},e,n){if(n.some(r=>r.info.name===i.population))return e.info.name===i.population;const s=hh(i,t);return e.info.axes.every(r=>s.includes(r.name))}function Ug(i,t,e){const{info:n,shape:s,values:r}=i,o=t.filter(a=>zd(a,i,e)).flatMap(a=>Ig(a,i));return{info:n,title:n.name.replace(/\.activity$/,""),shape:s,activity:r,bumps:Ng(o)}}function Ig({info:i,shape:t,values:e},n){const s=hh(i,t),r=i.name.slice(i.name.lastIndexOf(".")+1),o=n.info.axes.map((u,h)=>({axis:u,units:n.shape[h]})),a=o.map(({axis:u})=>s.indexOf(u.name)),l=a.includes(-1)?o.map((u,h)=>h):a,c=[];for(let u=0;u+s.length<=e.length;u+=s.length){const h=(...d)=>{const g=s.findIndex(v=>d.includes(v));return g<0?NaN:e[u+g]},f=d=>h(`precision.${d.name}`,...d.unit==="rad"?["concentration","precision"]:["precision","concentration"]);c.push({label:r,mean:o.map(({axis:d,units:g},v)=>Fg(e[u+l[v]],d,g)),sigma:o.map(({axis:d,units:g})=>1/Math.sqrt(f(d))/uh(d,g)),energy:h("energy"),precision:f(n.info.axes[0]),isHypothesis:t.length===2})}return c}function Ng(i){const t=n=>Number.isNaN(n.energy)?n.precision:n.energy,e=Math.max(...i.map(t).filter(Number.isFinite));return i.filter(n=>!(t(n)<=0)&&n.mean.every(Number.isFinite)).map(n=>({...n,weight:e>0&&Number.isFinite(t(n))?t(n)/e:1}))}function uh({period:i,step:t},e){return i>0?i:Math.abs(t)*e}function Hd({info:i}){return i.axes.every(t=>t.period>0)}function Fg(i,t,e){const n=(i-t.first)/uh(t,e);return t.period>0?n-Math.floor(n):n}function Og({info:i,shape:t},{mean:e}){return e.map((n,s)=>{const r=i.axes[s],o=r.first+n*uh(r,t[s]);return r.period>0?o-r.period*Math.floor(o/r.period):o})}const kg=ch(),cs=6;class Bg{constructor(){this.small=document.createElement("canvas")}draw(t,e,n){e.shape.length<=1?zg(t,e.values,n):this.drawHeatMap(t,e)}drawHeatMap(t,{shape:e,values:n}){const s=t.clear(),r=e[e.length-1],o=n.length/r,a=new ImageData(r,o),[l,c]=Vd(n);n.forEach((u,h)=>{const f=4*Math.round(255*(u-l)/(c-l));for(let d=0;d<4;++d)a.data[4*h+d]=kg[f+d]}),[this.small.width,this.small.height]=[r,o],this.small.getContext("2d")?.putImageData(a,0,0),s.imageSmoothingEnabled=!1,s.drawImage(this.small,cs,cs,t.width-2*cs,t.height-2*cs)}}function zg(i,t,e){const n=i.clear(),[s,r]=Vd(t),[o,a]=[i.width-2*cs,i.height-2*cs];n.beginPath(),t.forEach((l,c)=>{const u=cs+o*(c+.5)/t.length,h=cs+a*(1-(l-s)/(r-s));c===0?n.moveTo(u,h):n.lineTo(u,h)}),n.strokeStyle=e.blue,n.lineWidth=1.5,n.stroke()}function Vd(i){const t=i.reduce((n,s)=>Math.min(n,s),1/0),e=i.reduce((n,s)=>Math.max(n,s),-1/0);return t<e?[t,e]:[t-.5,t+.5]}const Hg={integrator:"orange",calibration:"sky",injected:"vermilion",estimate:"ink"};function fh(i,t){return t[Hg[i]??"purple"]}const yr=2*Math.PI,Vg=5;function Gg(i,t,e){const n=i.clear(),s=Math.min(i.width,i.height)/2;n.translate(i.width/2,i.height/2),n.rotate(-Math.PI/2),n.scale(1,-1);const r=s-23,o=r*.62;Wg(n,t,o,r);const a=[...new Set(t.bumps.map(l=>l.label))].filter(l=>l!=="estimate");for(const l of t.bumps)l.label==="estimate"?Yg(n,Gd(t,l),o-16,e):Xg(n,t,l,o-Vg*(1+a.indexOf(l.label)),e);t.info.axes[0]?.unit==="rad"&&qg(i,s,e)}function Gd(i,t){return Wd(i)+yr*(t.mean[0]??0)}function Wd({info:i}){const t=i.axes[0];return t&&t.period>0?yr*t.first/t.period:0}function Wg(i,t,e,n){const{activity:s}=t,r=s.reduce((a,l)=>Math.max(a,l),1e-9),o=.46*yr/s.length;for(let a=0;a<s.length;++a){const l=Wd(t)+a*yr/s.length;i.beginPath(),i.arc(0,0,n,l-o,l+o),i.arc(0,0,e,l+o,l-o,!0),i.closePath(),i.fillStyle=lh(Oa(s[a]/r)),i.fill()}}function Xg(i,t,e,n,s){const r=Gd(t,e),o=Math.min(Math.PI,yr*(e.sigma[0]||0));i.strokeStyle=i.fillStyle=fh(e.label,s),i.globalAlpha=.35+.65*e.weight,i.lineWidth=e.isHypothesis?2:3.5,i.lineCap="round",i.beginPath(),i.arc(0,0,n,r-o,r+o),i.stroke(),e.isHypothesis&&(i.beginPath(),i.arc(n*Math.cos(r),n*Math.sin(r),2+4*e.weight,0,yr),i.fill()),i.globalAlpha=1}function Yg(i,t,e,n){const[s,r]=[Math.cos(t),Math.sin(t)];i.fillStyle=n.ink,i.beginPath(),i.moveTo(e*s,e*r),i.lineTo(-.16*e*s-.2*e*r,-.16*e*r+.2*e*s),i.lineTo(-.16*e*s+.2*e*r,-.16*e*r-.2*e*s),i.closePath(),i.fill()}function qg(i,t,e){const{context:n}=i,s=window.devicePixelRatio;n.setTransform(s,0,0,s,0,0),n.translate(i.width/2,i.height/2),n.fillStyle=e.soft,n.font="10px system-ui, sans-serif",n.textAlign="center",n.textBaseline="middle";const r=t-11;n.fillText("0°",0,-r),n.fillText("90°",-r,0),n.fillText("180°",0,r),n.fillText("270°",r,0)}const $g=ch(),jg=14;function Kg({shape:i,activity:t}){const[e,n]=i,s=new ImageData(e,n),r=t.reduce((o,a)=>Math.max(o,a),1e-9);for(let o=0;o<e;++o)for(let a=0;a<n;++a){const l=Math.max(0,Math.min(1,t[o*n+a]/r)),c=4*Math.round(255*l),u=4*((n-1-a)*e+(e-1-o));for(let h=0;h<4;++h)s.data[u+h]=$g[c+h]}return s}class Zg{constructor(){this.small=document.createElement("canvas")}draw(t,e,n){const s=t.clear(),r=Math.min(t.width,t.height)-2*jg,o={left:(t.width-r)/2,top:(t.height-r)/2,side:r},a=Kg(e);[this.small.width,this.small.height]=[a.width,a.height],this.small.getContext("2d")?.putImageData(a,0,0),s.imageSmoothingEnabled=!1,s.drawImage(this.small,o.left,o.top,r,r),s.save(),s.beginPath(),s.rect(o.left,o.top,r,r),s.clip();for(const l of e.bumps)Jg(s,l,o,e,n);s.restore(),e_(s,e,o,n)}}function Jg(i,t,{left:e,top:n,side:s},r,o){const[a,l]=r.shape,c=e+s*(1-(t.mean[0]??NaN)-.5/a),u=n+s*(1-(t.mean[1]??NaN)-.5/l),h=s*Math.min(.5,Math.max(t.sigma[0]||0,t.sigma[1]||0)),f=Hd(r)?[-s,0,s]:[0];for(const d of f)for(const g of f)t.label==="estimate"?t_(i,c+d,u+g):Qg(i,c+d,u+g,h,t,o)}function Qg(i,t,e,n,s,r){i.strokeStyle=i.fillStyle=fh(s.label,r),i.globalAlpha=.35+.65*s.weight,i.lineWidth=2,i.beginPath(),i.arc(t,e,Math.max(3,n),0,2*Math.PI),i.stroke(),s.isHypothesis&&(i.beginPath(),i.arc(t,e,2+4*s.weight,0,2*Math.PI),i.fill()),i.globalAlpha=1}function t_(i,t,e){for(const[n,s]of[["#000c",3.5],["#fff",1.6]])i.beginPath(),i.moveTo(t-6,e),i.lineTo(t+6,e),i.moveTo(t,e-6),i.lineTo(t,e+6),i.strokeStyle=n,i.lineWidth=s,i.stroke()}function e_(i,{info:t},{left:e,top:n,side:s},r){i.fillStyle=r.soft,i.font="10px system-ui, sans-serif",i.textAlign="center",i.textBaseline="middle",i.fillText(`← ${t.axes[0]?.name??""}`,e+s/2,n+s+8),i.save(),i.translate(e-8,n+s/2),i.rotate(-Math.PI/2),i.fillText(`${t.axes[1]?.name??""} →`,0,0),i.restore()}/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */const dh="180",Hi={ROTATE:0,DOLLY:1,PAN:2},hs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},n_=0,yu=1,i_=2,Xd=1,s_=2,ki=3,fs=0,Nn=1,Ti=2,Vi=0,_r=1,Mu=2,Su=3,Eu=4,r_=5,Cs=100,o_=101,a_=102,l_=103,c_=104,h_=200,u_=201,f_=202,d_=203,oc=204,ac=205,p_=206,m_=207,g_=208,__=209,v_=210,x_=211,y_=212,M_=213,S_=214,lc=0,cc=1,hc=2,Mr=3,uc=4,fc=5,dc=6,pc=7,Yd=0,E_=1,w_=2,us=0,T_=1,b_=2,A_=3,R_=4,C_=5,P_=6,D_=7,qd=300,Sr=301,Er=302,mc=303,gc=304,Ba=306,wa=1e3,Ls=1001,_c=1002,Fn=1003,L_=1004,Oo=1005,bi=1006,fl=1007,Us=1008,Ri=1009,$d=1010,jd=1011,go=1012,ph=1013,Ns=1014,zi=1015,To=1016,mh=1017,gh=1018,_o=1020,Kd=35902,Zd=35899,Jd=1021,Qd=1022,si=1023,vo=1026,xo=1027,tp=1028,_h=1029,ep=1030,vh=1031,xh=1033,ga=33776,_a=33777,va=33778,xa=33779,vc=35840,xc=35841,yc=35842,Mc=35843,Sc=36196,Ec=37492,wc=37496,Tc=37808,bc=37809,Ac=37810,Rc=37811,Cc=37812,Pc=37813,Dc=37814,Lc=37815,Uc=37816,Ic=37817,Nc=37818,Fc=37819,Oc=37820,kc=37821,Bc=36492,zc=36494,Hc=36495,Vc=36283,Gc=36284,Wc=36285,Xc=36286,U_=3200,I_=3201,N_=0,F_=1,ls="",Wn="srgb",wr="srgb-linear",Ta="linear",Ae="srgb",Zs=7680,wu=519,O_=512,k_=513,B_=514,np=515,z_=516,H_=517,V_=518,G_=519,Tu=35044,bu="300 es",Ai=2e3,ba=2001;class zs{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});const n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){const n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){const n=this._listeners;if(n===void 0)return;const s=n[t];if(s!==void 0){const r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){const e=this._listeners;if(e===void 0)return;const n=e[t.type];if(n!==void 0){t.target=this;const s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}}const gn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],ya=Math.PI/180,Yc=180/Math.PI;function Ur(){const i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(gn[i&255]+gn[i>>8&255]+gn[i>>16&255]+gn[i>>24&255]+"-"+gn[t&255]+gn[t>>8&255]+"-"+gn[t>>16&15|64]+gn[t>>24&255]+"-"+gn[e&63|128]+gn[e>>8&255]+"-"+gn[e>>16&255]+gn[e>>24&255]+gn[n&255]+gn[n>>8&255]+gn[n>>16&255]+gn[n>>24&255]).toLowerCase()}function oe(i,t,e){return Math.max(t,Math.min(e,i))}function W_(i,t){return(i%t+t)%t}function dl(i,t,e){return(1-e)*i+e*t}function Yr(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return i/4294967295;case Uint16Array:return i/65535;case Uint8Array:return i/255;case Int32Array:return Math.max(i/2147483647,-1);case Int16Array:return Math.max(i/32767,-1);case Int8Array:return Math.max(i/127,-1);default:throw new Error("Invalid component type.")}}function Un(i,t){switch(t.constructor){case Float32Array:return i;case Uint32Array:return Math.round(i*4294967295);case Uint16Array:return Math.round(i*65535);case Uint8Array:return Math.round(i*255);case Int32Array:return Math.round(i*2147483647);case Int16Array:return Math.round(i*32767);case Int8Array:return Math.round(i*127);default:throw new Error("Invalid component type.")}}const X_={DEG2RAD:ya};class Rt{constructor(t=0,e=0){Rt.prototype.isVector2=!0,this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){const e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(oe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){const n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}}class Fs{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let l=n[s+0],c=n[s+1],u=n[s+2],h=n[s+3];const f=r[o+0],d=r[o+1],g=r[o+2],v=r[o+3];if(a===0){t[e+0]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h;return}if(a===1){t[e+0]=f,t[e+1]=d,t[e+2]=g,t[e+3]=v;return}if(h!==v||l!==f||c!==d||u!==g){let m=1-a;const p=l*f+c*d+u*g+h*v,w=p>=0?1:-1,T=1-p*p;if(T>Number.EPSILON){const U=Math.sqrt(T),D=Math.atan2(U,p*w);m=Math.sin(m*D)/U,a=Math.sin(a*D)/U}const M=a*w;if(l=l*m+f*M,c=c*m+d*M,u=u*m+g*M,h=h*m+v*M,m===1-a){const U=1/Math.sqrt(l*l+c*c+u*u+h*h);l*=U,c*=U,u*=U,h*=U}}t[e]=l,t[e+1]=c,t[e+2]=u,t[e+3]=h}static multiplyQuaternionsFlat(t,e,n,s,r,o){const a=n[s],l=n[s+1],c=n[s+2],u=n[s+3],h=r[o],f=r[o+1],d=r[o+2],g=r[o+3];return t[e]=a*g+u*h+l*d-c*f,t[e+1]=l*g+u*f+c*h-a*d,t[e+2]=c*g+u*d+a*f-l*h,t[e+3]=u*g-a*h-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){const n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(n/2),u=a(s/2),h=a(r/2),f=l(n/2),d=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"YXZ":this._x=f*u*h+c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"ZXY":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h-f*d*g;break;case"ZYX":this._x=f*u*h-c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h+f*d*g;break;case"YZX":this._x=f*u*h+c*d*g,this._y=c*d*h+f*u*g,this._z=c*u*g-f*d*h,this._w=c*u*h-f*d*g;break;case"XZY":this._x=f*u*h-c*d*g,this._y=c*d*h-f*u*g,this._z=c*u*g+f*d*h,this._w=c*u*h+f*d*g;break;default:console.warn("THREE.Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){const n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){const e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],u=e[6],h=e[10],f=n+a+h;if(f>0){const d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(n>a&&n>h){const d=2*Math.sqrt(1+n-a-h);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>h){const d=2*Math.sqrt(1+a-n-h);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{const d=2*Math.sqrt(1+h-n-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(oe(this.dot(t),-1,1)))}rotateTowards(t,e){const n=this.angleTo(t);if(n===0)return this;const s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){const n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,u=e._w;return this._x=n*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-n*c,this._z=r*u+o*c+n*l-s*a,this._w=o*u-n*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){if(e===0)return this;if(e===1)return this.copy(t);const n=this._x,s=this._y,r=this._z,o=this._w;let a=o*t._w+n*t._x+s*t._y+r*t._z;if(a<0?(this._w=-t._w,this._x=-t._x,this._y=-t._y,this._z=-t._z,a=-a):this.copy(t),a>=1)return this._w=o,this._x=n,this._y=s,this._z=r,this;const l=1-a*a;if(l<=Number.EPSILON){const d=1-e;return this._w=d*o+e*this._w,this._x=d*n+e*this._x,this._y=d*s+e*this._y,this._z=d*r+e*this._z,this.normalize(),this}const c=Math.sqrt(l),u=Math.atan2(c,a),h=Math.sin((1-e)*u)/c,f=Math.sin(e*u)/c;return this._w=o*h+this._w*f,this._x=n*h+this._x*f,this._y=s*h+this._y*f,this._z=r*h+this._z*f,this._onChangeCallback(),this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){const t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}}class z{constructor(t=0,e=0,n=0){z.prototype.isVector3=!0,this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Au.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Au.setFromAxisAngle(t,e))}applyMatrix3(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){const e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*n),u=2*(a*e-r*s),h=2*(r*n-o*e);return this.x=e+l*c+o*h-a*u,this.y=n+l*u+a*c-r*h,this.z=s+l*h+r*u-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){const e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){const n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-n*l,this.z=n*a-s*o,this}projectOnVector(t){const e=t.lengthSq();if(e===0)return this.set(0,0,0);const n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return pl.copy(this).projectOnVector(t),this.sub(pl)}reflect(t){return this.sub(pl.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){const e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;const n=this.dot(t)/e;return Math.acos(oe(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){const e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){const s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){const e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){const t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}}const pl=new z,Au=new Fs;class ie{constructor(t,e,n,s,r,o,a,l,c){ie.prototype.isMatrix3=!0,this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c)}set(t,e,n,s,r,o,a,l,c){const u=this.elements;return u[0]=t,u[1]=s,u[2]=a,u[3]=e,u[4]=r,u[5]=l,u[6]=n,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){const e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],l=n[6],c=n[1],u=n[4],h=n[7],f=n[2],d=n[5],g=n[8],v=s[0],m=s[3],p=s[6],w=s[1],T=s[4],M=s[7],U=s[2],D=s[5],I=s[8];return r[0]=o*v+a*w+l*U,r[3]=o*m+a*T+l*D,r[6]=o*p+a*M+l*I,r[1]=c*v+u*w+h*U,r[4]=c*m+u*T+h*D,r[7]=c*p+u*M+h*I,r[2]=f*v+d*w+g*U,r[5]=f*m+d*T+g*D,r[8]=f*p+d*M+g*I,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8];return e*o*u-e*a*c-n*r*u+n*a*l+s*r*c-s*o*l}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=u*o-a*c,f=a*l-u*r,d=c*r-o*l,g=e*h+n*f+s*d;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);const v=1/g;return t[0]=h*v,t[1]=(s*c-u*n)*v,t[2]=(a*n-s*o)*v,t[3]=f*v,t[4]=(u*e-s*l)*v,t[5]=(s*r-a*e)*v,t[6]=d*v,t[7]=(n*l-c*e)*v,t[8]=(o*e-n*r)*v,this}transpose(){let t;const e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){const e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){const l=Math.cos(r),c=Math.sin(r);return this.set(n*l,n*c,-n*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return this.premultiply(ml.makeScale(t,e)),this}rotate(t){return this.premultiply(ml.makeRotation(-t)),this}translate(t,e){return this.premultiply(ml.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}}const ml=new ie;function ip(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Aa(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function Y_(){const i=Aa("canvas");return i.style.display="block",i}const Ru={};function yo(i){i in Ru||(Ru[i]=!0,console.warn(i))}function q_(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}const Cu=new ie().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Pu=new ie().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function $_(){const i={enabled:!0,workingColorSpace:wr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=Gi(s.r),s.g=Gi(s.g),s.b=Gi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=vr(s.r),s.g=vr(s.g),s.b=vr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===ls?Ta:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[r].toXYZ).multiply(this.spaces[o].fromXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace},fromWorkingColorSpace:function(s,r){return yo("THREE.ColorManagement: .fromWorkingColorSpace() has been renamed to .workingToColorSpace()."),i.workingToColorSpace(s,r)},toWorkingColorSpace:function(s,r){return yo("THREE.ColorManagement: .toWorkingColorSpace() has been renamed to .colorSpaceToWorking()."),i.colorSpaceToWorking(s,r)}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[wr]:{primaries:t,whitePoint:n,transfer:Ta,toXYZ:Cu,fromXYZ:Pu,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Wn},outputColorSpaceConfig:{drawingBufferColorSpace:Wn}},[Wn]:{primaries:t,whitePoint:n,transfer:Ae,toXYZ:Cu,fromXYZ:Pu,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Wn}}}),i}const ge=$_();function Gi(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function vr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}let Js;class j_{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Js===void 0&&(Js=Aa("canvas")),Js.width=t.width,Js.height=t.height;const s=Js.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Js}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){const e=Aa("canvas");e.width=t.width,e.height=t.height;const n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);const s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Gi(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){const e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Gi(e[n]/255)*255):e[n]=Gi(e[n]);return{data:e,width:t.width,height:t.height}}else return console.warn("THREE.ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}}let K_=0;class yh{constructor(t=null){this.isSource=!0,Object.defineProperty(this,"id",{value:K_++}),this.uuid=Ur(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){const e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):e instanceof VideoFrame?t.set(e.displayHeight,e.displayWidth,0):e!==null?t.set(e.width,e.height,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];const n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(gl(s[o].image)):r.push(gl(s[o]))}else r=gl(s);n.url=r}return e||(t.images[this.uuid]=n),n}}function gl(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?j_.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(console.warn("THREE.Texture: Unable to serialize Texture."),{})}let Z_=0;const _l=new z;class xn extends zs{constructor(t=xn.DEFAULT_IMAGE,e=xn.DEFAULT_MAPPING,n=Ls,s=Ls,r=bi,o=Us,a=si,l=Ri,c=xn.DEFAULT_ANISOTROPY,u=ls){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Z_++}),this.uuid=Ur(),this.name="",this.source=new yh(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Rt(0,0),this.repeat=new Rt(1,1),this.center=new Rt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ie,this.generateMipmaps=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0}get width(){return this.source.getSize(_l).x}get height(){return this.source.getSize(_l).y}get depth(){return this.source.getSize(_l).z}get image(){return this.source.data}set image(t=null){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Texture.setValues(): parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];const n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==qd)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case wa:t.x=t.x-Math.floor(t.x);break;case Ls:t.x=t.x<0?0:1;break;case _c:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case wa:t.y=t.y-Math.floor(t.y);break;case Ls:t.y=t.y<0?0:1;break;case _c:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}}xn.DEFAULT_IMAGE=null;xn.DEFAULT_MAPPING=qd;xn.DEFAULT_ANISOTROPY=1;class Ye{constructor(t=0,e=0,n=0,s=1){Ye.prototype.isVector4=!0,this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){const e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);const e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r;const l=t.elements,c=l[0],u=l[4],h=l[8],f=l[1],d=l[5],g=l[9],v=l[2],m=l[6],p=l[10];if(Math.abs(u-f)<.01&&Math.abs(h-v)<.01&&Math.abs(g-m)<.01){if(Math.abs(u+f)<.1&&Math.abs(h+v)<.1&&Math.abs(g+m)<.1&&Math.abs(c+d+p-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;const T=(c+1)/2,M=(d+1)/2,U=(p+1)/2,D=(u+f)/4,I=(h+v)/4,k=(g+m)/4;return T>M&&T>U?T<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(T),s=D/n,r=I/n):M>U?M<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),n=D/s,r=k/s):U<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(U),n=I/r,s=k/r),this.set(n,s,r,e),this}let w=Math.sqrt((m-g)*(m-g)+(h-v)*(h-v)+(f-u)*(f-u));return Math.abs(w)<.001&&(w=1),this.x=(m-g)/w,this.y=(h-v)/w,this.z=(f-u)/w,this.w=Math.acos((c+d+p-1)/2),this}setFromMatrixPosition(t){const e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=oe(this.x,t.x,e.x),this.y=oe(this.y,t.y,e.y),this.z=oe(this.z,t.z,e.z),this.w=oe(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=oe(this.x,t,e),this.y=oe(this.y,t,e),this.z=oe(this.z,t,e),this.w=oe(this.w,t,e),this}clampLength(t,e){const n=this.length();return this.divideScalar(n||1).multiplyScalar(oe(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}}class J_ extends zs{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:bi,depthBuffer:!0,stencilBuffer:!1,resolveDepthBuffer:!0,resolveStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ye(0,0,t,e),this.scissorTest=!1,this.viewport=new Ye(0,0,t,e);const s={width:t,height:e,depth:n.depth},r=new xn(s);this.textures=[];const o=n.count;for(let a=0;a<o;a++)this.textures[a]=r.clone(),this.textures[a].isRenderTargetTexture=!0,this.textures[a].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview}_setTextureOptions(t={}){const e={minFilter:bi,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&(this._depthTexture.renderTarget=null),t!==null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isArrayTexture=this.textures[s].image.depth>1;this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;const s=Object.assign({},t.textures[e].image);this.textures[e].source=new yh(s)}return this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,t.depthTexture!==null&&(this.depthTexture=t.depthTexture.clone()),this.samples=t.samples,this}dispose(){this.dispatchEvent({type:"dispose"})}}class Os extends J_{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}}class sp extends xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}}class Q_ extends xn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=Fn,this.minFilter=Fn,this.wrapR=Ls,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}class Ir{constructor(t=new z(1/0,1/0,1/0),e=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(ci.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(ci.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){const n=ci.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);const n=t.geometry;if(n!==void 0){const r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ci):ci.fromBufferAttribute(r,o),ci.applyMatrix4(t.matrixWorld),this.expandByPoint(ci);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),ko.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),ko.copy(n.boundingBox)),ko.applyMatrix4(t.matrixWorld),this.union(ko)}const s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ci),ci.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(qr),Bo.subVectors(this.max,qr),Qs.subVectors(t.a,qr),tr.subVectors(t.b,qr),er.subVectors(t.c,qr),ts.subVectors(tr,Qs),es.subVectors(er,tr),ys.subVectors(Qs,er);let e=[0,-ts.z,ts.y,0,-es.z,es.y,0,-ys.z,ys.y,ts.z,0,-ts.x,es.z,0,-es.x,ys.z,0,-ys.x,-ts.y,ts.x,0,-es.y,es.x,0,-ys.y,ys.x,0];return!vl(e,Qs,tr,er,Bo)||(e=[1,0,0,0,1,0,0,0,1],!vl(e,Qs,tr,er,Bo))?!1:(zo.crossVectors(ts,es),e=[zo.x,zo.y,zo.z],vl(e,Qs,tr,er,Bo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ci).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ci).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ui[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ui[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ui[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ui[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ui[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ui[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ui[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ui[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ui),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}}const Ui=[new z,new z,new z,new z,new z,new z,new z,new z],ci=new z,ko=new Ir,Qs=new z,tr=new z,er=new z,ts=new z,es=new z,ys=new z,qr=new z,Bo=new z,zo=new z,Ms=new z;function vl(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Ms.fromArray(i,r);const a=s.x*Math.abs(Ms.x)+s.y*Math.abs(Ms.y)+s.z*Math.abs(Ms.z),l=t.dot(Ms),c=e.dot(Ms),u=n.dot(Ms);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}const t0=new Ir,$r=new z,xl=new z;class bo{constructor(t=new z,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){const n=this.center;e!==void 0?n.copy(e):t0.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){const e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){const n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;$r.subVectors(t,this.center);const e=$r.lengthSq();if(e>this.radius*this.radius){const n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector($r,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(xl.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint($r.copy(t.center).add(xl)),this.expandByPoint($r.copy(t.center).sub(xl))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}}const Ii=new z,yl=new z,Ho=new z,ns=new z,Ml=new z,Vo=new z,Sl=new z;class za{constructor(t=new z,e=new z(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ii)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);const n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){const e=Ii.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ii.copy(this.origin).addScaledVector(this.direction,e),Ii.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){yl.copy(t).add(e).multiplyScalar(.5),Ho.copy(e).sub(t).normalize(),ns.copy(this.origin).sub(yl);const r=t.distanceTo(e)*.5,o=-this.direction.dot(Ho),a=ns.dot(this.direction),l=-ns.dot(Ho),c=ns.lengthSq(),u=Math.abs(1-o*o);let h,f,d,g;if(u>0)if(h=o*l-a,f=o*a-l,g=r*u,h>=0)if(f>=-g)if(f<=g){const v=1/u;h*=v,f*=v,d=h*(h+o*f+2*a)+f*(o*h+f+2*l)+c}else f=r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f=-r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;else f<=-g?(h=Math.max(0,-(-o*r+a)),f=h>0?-r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c):f<=g?(h=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(h=Math.max(0,-(o*r+a)),f=h>0?r:Math.min(Math.max(-r,-l),r),d=-h*h+f*(f+2*l)+c);else f=o>0?-r:r,h=Math.max(0,-(o*f+a)),d=-h*h+f*(f+2*l)+c;return n&&n.copy(this.origin).addScaledVector(this.direction,h),s&&s.copy(yl).addScaledVector(Ho,f),d}intersectSphere(t,e){Ii.subVectors(t.center,this.origin);const n=Ii.dot(this.direction),s=Ii.dot(Ii)-n*n,r=t.radius*t.radius;if(s>r)return null;const o=Math.sqrt(r-s),a=n-o,l=n+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){const e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;const n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){const n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){const e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,l;const c=1/this.direction.x,u=1/this.direction.y,h=1/this.direction.z,f=this.origin;return c>=0?(n=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(n=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),u>=0?(r=(t.min.y-f.y)*u,o=(t.max.y-f.y)*u):(r=(t.max.y-f.y)*u,o=(t.min.y-f.y)*u),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),h>=0?(a=(t.min.z-f.z)*h,l=(t.max.z-f.z)*h):(a=(t.max.z-f.z)*h,l=(t.min.z-f.z)*h),n>l||a>s)||((a>n||n!==n)&&(n=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ii)!==null}intersectTriangle(t,e,n,s,r){Ml.subVectors(e,t),Vo.subVectors(n,t),Sl.crossVectors(Ml,Vo);let o=this.direction.dot(Sl),a;if(o>0){if(s)return null;a=1}else if(o<0)a=-1,o=-o;else return null;ns.subVectors(this.origin,t);const l=a*this.direction.dot(Vo.crossVectors(ns,Vo));if(l<0)return null;const c=a*this.direction.dot(Ml.cross(ns));if(c<0||l+c>o)return null;const u=-a*ns.dot(Sl);return u<0?null:this.at(u/o,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}}class Xe{constructor(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){Xe.prototype.isMatrix4=!0,this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m)}set(t,e,n,s,r,o,a,l,c,u,h,f,d,g,v,m){const p=this.elements;return p[0]=t,p[4]=e,p[8]=n,p[12]=s,p[1]=r,p[5]=o,p[9]=a,p[13]=l,p[2]=c,p[6]=u,p[10]=h,p[14]=f,p[3]=d,p[7]=g,p[11]=v,p[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new Xe().fromArray(this.elements)}copy(t){const e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){const e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){const e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){const e=this.elements,n=t.elements,s=1/nr.setFromMatrixColumn(t,0).length(),r=1/nr.setFromMatrixColumn(t,1).length(),o=1/nr.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){const e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),h=Math.sin(r);if(t.order==="XYZ"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=-l*h,e[8]=c,e[1]=d+g*c,e[5]=f-v*c,e[9]=-a*l,e[2]=v-f*c,e[6]=g+d*c,e[10]=o*l}else if(t.order==="YXZ"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f+v*a,e[4]=g*a-d,e[8]=o*c,e[1]=o*h,e[5]=o*u,e[9]=-a,e[2]=d*a-g,e[6]=v+f*a,e[10]=o*l}else if(t.order==="ZXY"){const f=l*u,d=l*h,g=c*u,v=c*h;e[0]=f-v*a,e[4]=-o*h,e[8]=g+d*a,e[1]=d+g*a,e[5]=o*u,e[9]=v-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){const f=o*u,d=o*h,g=a*u,v=a*h;e[0]=l*u,e[4]=g*c-d,e[8]=f*c+v,e[1]=l*h,e[5]=v*c+f,e[9]=d*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=v-f*h,e[8]=g*h+d,e[1]=h,e[5]=o*u,e[9]=-a*u,e[2]=-c*u,e[6]=d*h+g,e[10]=f-v*h}else if(t.order==="XZY"){const f=o*l,d=o*c,g=a*l,v=a*c;e[0]=l*u,e[4]=-h,e[8]=c*u,e[1]=f*h+v,e[5]=o*u,e[9]=d*h-g,e[2]=g*h-d,e[6]=a*u,e[10]=v*h+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(e0,t,n0)}lookAt(t,e,n){const s=this.elements;return Hn.subVectors(t,e),Hn.lengthSq()===0&&(Hn.z=1),Hn.normalize(),is.crossVectors(n,Hn),is.lengthSq()===0&&(Math.abs(n.z)===1?Hn.x+=1e-4:Hn.z+=1e-4,Hn.normalize(),is.crossVectors(n,Hn)),is.normalize(),Go.crossVectors(Hn,is),s[0]=is.x,s[4]=Go.x,s[8]=Hn.x,s[1]=is.y,s[5]=Go.y,s[9]=Hn.y,s[2]=is.z,s[6]=Go.z,s[10]=Hn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){const n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],l=n[8],c=n[12],u=n[1],h=n[5],f=n[9],d=n[13],g=n[2],v=n[6],m=n[10],p=n[14],w=n[3],T=n[7],M=n[11],U=n[15],D=s[0],I=s[4],k=s[8],b=s[12],E=s[1],C=s[5],G=s[9],H=s[13],$=s[2],W=s[6],Z=s[10],Y=s[14],J=s[3],ot=s[7],at=s[11],_t=s[15];return r[0]=o*D+a*E+l*$+c*J,r[4]=o*I+a*C+l*W+c*ot,r[8]=o*k+a*G+l*Z+c*at,r[12]=o*b+a*H+l*Y+c*_t,r[1]=u*D+h*E+f*$+d*J,r[5]=u*I+h*C+f*W+d*ot,r[9]=u*k+h*G+f*Z+d*at,r[13]=u*b+h*H+f*Y+d*_t,r[2]=g*D+v*E+m*$+p*J,r[6]=g*I+v*C+m*W+p*ot,r[10]=g*k+v*G+m*Z+p*at,r[14]=g*b+v*H+m*Y+p*_t,r[3]=w*D+T*E+M*$+U*J,r[7]=w*I+T*C+M*W+U*ot,r[11]=w*k+T*G+M*Z+U*at,r[15]=w*b+T*H+M*Y+U*_t,this}multiplyScalar(t){const e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){const t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],u=t[2],h=t[6],f=t[10],d=t[14],g=t[3],v=t[7],m=t[11],p=t[15];return g*(+r*l*h-s*c*h-r*a*f+n*c*f+s*a*d-n*l*d)+v*(+e*l*d-e*c*f+r*o*f-s*o*d+s*c*u-r*l*u)+m*(+e*c*h-e*a*d-r*o*h+n*o*d+r*a*u-n*c*u)+p*(-s*a*u-e*l*h+e*a*f+s*o*h-n*o*f+n*l*u)}transpose(){const t=this.elements;let e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){const s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){const t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],u=t[8],h=t[9],f=t[10],d=t[11],g=t[12],v=t[13],m=t[14],p=t[15],w=h*m*c-v*f*c+v*l*d-a*m*d-h*l*p+a*f*p,T=g*f*c-u*m*c-g*l*d+o*m*d+u*l*p-o*f*p,M=u*v*c-g*h*c+g*a*d-o*v*d-u*a*p+o*h*p,U=g*h*l-u*v*l-g*a*f+o*v*f+u*a*m-o*h*m,D=e*w+n*T+s*M+r*U;if(D===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);const I=1/D;return t[0]=w*I,t[1]=(v*f*r-h*m*r-v*s*d+n*m*d+h*s*p-n*f*p)*I,t[2]=(a*m*r-v*l*r+v*s*c-n*m*c-a*s*p+n*l*p)*I,t[3]=(h*l*r-a*f*r-h*s*c+n*f*c+a*s*d-n*l*d)*I,t[4]=T*I,t[5]=(u*m*r-g*f*r+g*s*d-e*m*d-u*s*p+e*f*p)*I,t[6]=(g*l*r-o*m*r-g*s*c+e*m*c+o*s*p-e*l*p)*I,t[7]=(o*f*r-u*l*r+u*s*c-e*f*c-o*s*d+e*l*d)*I,t[8]=M*I,t[9]=(g*h*r-u*v*r-g*n*d+e*v*d+u*n*p-e*h*p)*I,t[10]=(o*v*r-g*a*r+g*n*c-e*v*c-o*n*p+e*a*p)*I,t[11]=(u*a*r-o*h*r-u*n*c+e*h*c+o*n*d-e*a*d)*I,t[12]=U*I,t[13]=(u*v*s-g*h*s+g*n*f-e*v*f-u*n*m+e*h*m)*I,t[14]=(g*a*s-o*v*s-g*n*l+e*v*l+o*n*m-e*a*m)*I,t[15]=(o*h*s-u*a*s+u*n*l-e*h*l-o*n*f+e*a*f)*I,this}scale(t){const e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){const t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){const e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){const e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){const n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,l=t.z,c=r*o,u=r*a;return this.set(c*o+n,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+n,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){const s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,u=o+o,h=a+a,f=r*c,d=r*u,g=r*h,v=o*u,m=o*h,p=a*h,w=l*c,T=l*u,M=l*h,U=n.x,D=n.y,I=n.z;return s[0]=(1-(v+p))*U,s[1]=(d+M)*U,s[2]=(g-T)*U,s[3]=0,s[4]=(d-M)*D,s[5]=(1-(f+p))*D,s[6]=(m+w)*D,s[7]=0,s[8]=(g+T)*I,s[9]=(m-w)*I,s[10]=(1-(f+v))*I,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){const s=this.elements;let r=nr.set(s[0],s[1],s[2]).length();const o=nr.set(s[4],s[5],s[6]).length(),a=nr.set(s[8],s[9],s[10]).length();this.determinant()<0&&(r=-r),t.x=s[12],t.y=s[13],t.z=s[14],hi.copy(this);const c=1/r,u=1/o,h=1/a;return hi.elements[0]*=c,hi.elements[1]*=c,hi.elements[2]*=c,hi.elements[4]*=u,hi.elements[5]*=u,hi.elements[6]*=u,hi.elements[8]*=h,hi.elements[9]*=h,hi.elements[10]*=h,e.setFromRotationMatrix(hi),n.x=r,n.y=o,n.z=a,this}makePerspective(t,e,n,s,r,o,a=Ai,l=!1){const c=this.elements,u=2*r/(e-t),h=2*r/(n-s),f=(e+t)/(e-t),d=(n+s)/(n-s);let g,v;if(l)g=r/(o-r),v=o*r/(o-r);else if(a===Ai)g=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===ba)g=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=h,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Ai,l=!1){const c=this.elements,u=2/(e-t),h=2/(n-s),f=-(e+t)/(e-t),d=-(n+s)/(n-s);let g,v;if(l)g=1/(o-r),v=o/(o-r);else if(a===Ai)g=-2/(o-r),v=-(o+r)/(o-r);else if(a===ba)g=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=h,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=g,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){const e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){const n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}}const nr=new z,hi=new Xe,e0=new z(0,0,0),n0=new z(1,1,1),is=new z,Go=new z,Hn=new z,Du=new Xe,Lu=new Fs;class Yi{constructor(t=0,e=0,n=0,s=Yi.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){const s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],h=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(oe(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-oe(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-h,r),this._z=0);break;case"ZXY":this._x=Math.asin(oe(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-h,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-oe(h,-1,1)),Math.abs(h)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(oe(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-h,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-oe(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:console.warn("THREE.Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Du.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Du,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Lu.setFromEuler(this),this.setFromQuaternion(Lu,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}}Yi.DEFAULT_ORDER="XYZ";class rp{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}}let i0=0;const Uu=new z,ir=new Fs,Ni=new Xe,Wo=new z,jr=new z,s0=new z,r0=new Fs,Iu=new z(1,0,0),Nu=new z(0,1,0),Fu=new z(0,0,1),Ou={type:"added"},o0={type:"removed"},sr={type:"childadded",child:null},El={type:"childremoved",child:null};class Rn extends zs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:i0++}),this.uuid=Ur(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=Rn.DEFAULT_UP.clone();const t=new z,e=new Yi,n=new Fs,s=new z(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new Xe},normalMatrix:{value:new ie}}),this.matrix=new Xe,this.matrixWorld=new Xe,this.matrixAutoUpdate=Rn.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=Rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new rp,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.userData={}}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return ir.setFromAxisAngle(t,e),this.quaternion.multiply(ir),this}rotateOnWorldAxis(t,e){return ir.setFromAxisAngle(t,e),this.quaternion.premultiply(ir),this}rotateX(t){return this.rotateOnAxis(Iu,t)}rotateY(t){return this.rotateOnAxis(Nu,t)}rotateZ(t){return this.rotateOnAxis(Fu,t)}translateOnAxis(t,e){return Uu.copy(t).applyQuaternion(this.quaternion),this.position.add(Uu.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Iu,t)}translateY(t){return this.translateOnAxis(Nu,t)}translateZ(t){return this.translateOnAxis(Fu,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Ni.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?Wo.copy(t):Wo.set(t,e,n);const s=this.parent;this.updateWorldMatrix(!0,!1),jr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ni.lookAt(jr,Wo,this.up):Ni.lookAt(Wo,jr,this.up),this.quaternion.setFromRotationMatrix(Ni),s&&(Ni.extractRotation(s.matrixWorld),ir.setFromRotationMatrix(Ni),this.quaternion.premultiply(ir.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(console.error("THREE.Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Ou),sr.child=t,this.dispatchEvent(sr),sr.child=null):console.error("THREE.Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}const e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(o0),El.child=t,this.dispatchEvent(El),El.child=null),this}removeFromParent(){const t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Ni.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Ni.multiply(t.parent.matrixWorld)),t.applyMatrix4(Ni),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Ou),sr.child=t,this.dispatchEvent(sr),sr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){const o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jr,t,s0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(jr,r0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);const e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}traverse(t){t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){const e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale),this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);const e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e){const n=this.parent;if(t===!0&&n!==null&&n.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),e===!0){const s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0)}}toJSON(t){const e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});const s={};s.uuid=this.uuid,s.type=this.type,this.name!==""&&(s.name=this.name),this.castShadow===!0&&(s.castShadow=!0),this.receiveShadow===!0&&(s.receiveShadow=!0),this.visible===!1&&(s.visible=!1),this.frustumCulled===!1&&(s.frustumCulled=!1),this.renderOrder!==0&&(s.renderOrder=this.renderOrder),Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.matrixAutoUpdate===!1&&(s.matrixAutoUpdate=!1),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);const a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){const l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){const h=l[c];r(t.shapes,h)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){const a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){const l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){const a=o(t.geometries),l=o(t.materials),c=o(t.textures),u=o(t.images),h=o(t.shapes),f=o(t.skeletons),d=o(t.animations),g=o(t.nodes);a.length>0&&(n.geometries=a),l.length>0&&(n.materials=l),c.length>0&&(n.textures=c),u.length>0&&(n.images=u),h.length>0&&(n.shapes=h),f.length>0&&(n.skeletons=f),d.length>0&&(n.animations=d),g.length>0&&(n.nodes=g)}return n.object=s,n;function o(a){const l=[];for(const c in a){const u=a[c];delete u.metadata,l.push(u)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){const s=t.children[n];this.add(s.clone())}return this}}Rn.DEFAULT_UP=new z(0,1,0);Rn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Rn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;const ui=new z,Fi=new z,wl=new z,Oi=new z,rr=new z,or=new z,ku=new z,Tl=new z,bl=new z,Al=new z,Rl=new Ye,Cl=new Ye,Pl=new Ye;class pi{constructor(t=new z,e=new z,n=new z){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),ui.subVectors(t,e),s.cross(ui);const r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){ui.subVectors(s,e),Fi.subVectors(n,e),wl.subVectors(t,e);const o=ui.dot(ui),a=ui.dot(Fi),l=ui.dot(wl),c=Fi.dot(Fi),u=Fi.dot(wl),h=o*c-a*a;if(h===0)return r.set(0,0,0),null;const f=1/h,d=(c*l-a*u)*f,g=(o*u-a*l)*f;return r.set(1-d-g,g,d)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,Oi)===null?!1:Oi.x>=0&&Oi.y>=0&&Oi.x+Oi.y<=1}static getInterpolation(t,e,n,s,r,o,a,l){return this.getBarycoord(t,e,n,s,Oi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Oi.x),l.addScaledVector(o,Oi.y),l.addScaledVector(a,Oi.z),l)}static getInterpolatedAttribute(t,e,n,s,r,o){return Rl.setScalar(0),Cl.setScalar(0),Pl.setScalar(0),Rl.fromBufferAttribute(t,e),Cl.fromBufferAttribute(t,n),Pl.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Rl,r.x),o.addScaledVector(Cl,r.y),o.addScaledVector(Pl,r.z),o}static isFrontFacing(t,e,n,s){return ui.subVectors(n,e),Fi.subVectors(t,e),ui.cross(Fi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return ui.subVectors(this.c,this.b),Fi.subVectors(this.a,this.b),ui.cross(Fi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return pi.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return pi.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return pi.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return pi.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return pi.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){const n=this.a,s=this.b,r=this.c;let o,a;rr.subVectors(s,n),or.subVectors(r,n),Tl.subVectors(t,n);const l=rr.dot(Tl),c=or.dot(Tl);if(l<=0&&c<=0)return e.copy(n);bl.subVectors(t,s);const u=rr.dot(bl),h=or.dot(bl);if(u>=0&&h<=u)return e.copy(s);const f=l*h-u*c;if(f<=0&&l>=0&&u<=0)return o=l/(l-u),e.copy(n).addScaledVector(rr,o);Al.subVectors(t,r);const d=rr.dot(Al),g=or.dot(Al);if(g>=0&&d<=g)return e.copy(r);const v=d*c-l*g;if(v<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(n).addScaledVector(or,a);const m=u*g-d*h;if(m<=0&&h-u>=0&&d-g>=0)return ku.subVectors(r,s),a=(h-u)/(h-u+(d-g)),e.copy(s).addScaledVector(ku,a);const p=1/(m+v+f);return o=v*p,a=f*p,e.copy(n).addScaledVector(rr,o).addScaledVector(or,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}}const op={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},ss={h:0,s:0,l:0},Xo={h:0,s:0,l:0};function Dl(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}class ve{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){const s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Wn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,ge.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=ge.workingColorSpace){return this.r=t,this.g=e,this.b=n,ge.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=ge.workingColorSpace){if(t=W_(t,1),e=oe(e,0,1),n=oe(n,0,1),e===0)this.r=this.g=this.b=n;else{const r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=Dl(o,r,t+1/3),this.g=Dl(o,r,t),this.b=Dl(o,r,t-1/3)}return ge.colorSpaceToWorking(this,s),this}setStyle(t,e=Wn){function n(r){r!==void 0&&parseFloat(r)<1&&console.warn("THREE.Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r;const o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+)\%\s*,\s*(\d+)\%\s*,\s*(\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseInt(r[1],10))/100,Math.min(100,parseInt(r[2],10))/100,Math.min(100,parseInt(r[3],10))/100,e);break;case"hsl":case"hsla":if(r=/^\s*(\d*\.?\d+)\s*,\s*(\d*\.?\d+)\%\s*,\s*(\d*\.?\d+)\%\s*(?:,\s*(\d*\.?\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:console.warn("THREE.Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){const r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);console.warn("THREE.Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Wn){const n=op[t.toLowerCase()];return n!==void 0?this.setHex(n,e):console.warn("THREE.Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Gi(t.r),this.g=Gi(t.g),this.b=Gi(t.b),this}copyLinearToSRGB(t){return this.r=vr(t.r),this.g=vr(t.g),this.b=vr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Wn){return ge.workingToColorSpace(_n.copy(this),t),Math.round(oe(_n.r*255,0,255))*65536+Math.round(oe(_n.g*255,0,255))*256+Math.round(oe(_n.b*255,0,255))}getHexString(t=Wn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=ge.workingColorSpace){ge.workingToColorSpace(_n.copy(this),e);const n=_n.r,s=_n.g,r=_n.b,o=Math.max(n,s,r),a=Math.min(n,s,r);let l,c;const u=(a+o)/2;if(a===o)l=0,c=0;else{const h=o-a;switch(c=u<=.5?h/(o+a):h/(2-o-a),o){case n:l=(s-r)/h+(s<r?6:0);break;case s:l=(r-n)/h+2;break;case r:l=(n-s)/h+4;break}l/=6}return t.h=l,t.s=c,t.l=u,t}getRGB(t,e=ge.workingColorSpace){return ge.workingToColorSpace(_n.copy(this),e),t.r=_n.r,t.g=_n.g,t.b=_n.b,t}getStyle(t=Wn){ge.workingToColorSpace(_n.copy(this),t);const e=_n.r,n=_n.g,s=_n.b;return t!==Wn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL(ss),this.setHSL(ss.h+t,ss.s+e,ss.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(ss),t.getHSL(Xo);const n=dl(ss.h,Xo.h,e),s=dl(ss.s,Xo.s,e),r=dl(ss.l,Xo.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){const e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}}const _n=new ve;ve.NAMES=op;let a0=0;class Nr extends zs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:a0++}),this.uuid=Ur(),this.name="",this.type="Material",this.blending=_r,this.side=fs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=oc,this.blendDst=ac,this.blendEquation=Cs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ve(0,0,0),this.blendAlpha=0,this.depthFunc=Mr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=wu,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Zs,this.stencilZFail=Zs,this.stencilZPass=Zs,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(const e in t){const n=t[e];if(n===void 0){console.warn(`THREE.Material: parameter '${e}' has value of undefined.`);continue}const s=this[e];if(s===void 0){console.warn(`THREE.Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){const e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});const n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,this.name!==""&&(n.name=this.name),this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&this.emissiveIntensity!==1&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessRange!==void 0&&(n.iridescenceThicknessRange=this.iridescenceThicknessRange),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&this.attenuationDistance!==1/0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.shadowSide!==null&&(n.shadowSide=this.shadowSide),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),this.blending!==_r&&(n.blending=this.blending),this.side!==fs&&(n.side=this.side),this.vertexColors===!0&&(n.vertexColors=!0),this.opacity<1&&(n.opacity=this.opacity),this.transparent===!0&&(n.transparent=!0),this.blendSrc!==oc&&(n.blendSrc=this.blendSrc),this.blendDst!==ac&&(n.blendDst=this.blendDst),this.blendEquation!==Cs&&(n.blendEquation=this.blendEquation),this.blendSrcAlpha!==null&&(n.blendSrcAlpha=this.blendSrcAlpha),this.blendDstAlpha!==null&&(n.blendDstAlpha=this.blendDstAlpha),this.blendEquationAlpha!==null&&(n.blendEquationAlpha=this.blendEquationAlpha),this.blendColor&&this.blendColor.isColor&&(n.blendColor=this.blendColor.getHex()),this.blendAlpha!==0&&(n.blendAlpha=this.blendAlpha),this.depthFunc!==Mr&&(n.depthFunc=this.depthFunc),this.depthTest===!1&&(n.depthTest=this.depthTest),this.depthWrite===!1&&(n.depthWrite=this.depthWrite),this.colorWrite===!1&&(n.colorWrite=this.colorWrite),this.stencilWriteMask!==255&&(n.stencilWriteMask=this.stencilWriteMask),this.stencilFunc!==wu&&(n.stencilFunc=this.stencilFunc),this.stencilRef!==0&&(n.stencilRef=this.stencilRef),this.stencilFuncMask!==255&&(n.stencilFuncMask=this.stencilFuncMask),this.stencilFail!==Zs&&(n.stencilFail=this.stencilFail),this.stencilZFail!==Zs&&(n.stencilZFail=this.stencilZFail),this.stencilZPass!==Zs&&(n.stencilZPass=this.stencilZPass),this.stencilWrite===!0&&(n.stencilWrite=this.stencilWrite),this.rotation!==void 0&&this.rotation!==0&&(n.rotation=this.rotation),this.polygonOffset===!0&&(n.polygonOffset=!0),this.polygonOffsetFactor!==0&&(n.polygonOffsetFactor=this.polygonOffsetFactor),this.polygonOffsetUnits!==0&&(n.polygonOffsetUnits=this.polygonOffsetUnits),this.linewidth!==void 0&&this.linewidth!==1&&(n.linewidth=this.linewidth),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.dithering===!0&&(n.dithering=!0),this.alphaTest>0&&(n.alphaTest=this.alphaTest),this.alphaHash===!0&&(n.alphaHash=!0),this.alphaToCoverage===!0&&(n.alphaToCoverage=!0),this.premultipliedAlpha===!0&&(n.premultipliedAlpha=!0),this.forceSinglePass===!0&&(n.forceSinglePass=!0),this.wireframe===!0&&(n.wireframe=!0),this.wireframeLinewidth>1&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!=="round"&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!=="round"&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading===!0&&(n.flatShading=!0),this.visible===!1&&(n.visible=!1),this.toneMapped===!1&&(n.toneMapped=!1),this.fog===!1&&(n.fog=!1),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){const o=[];for(const a in r){const l=r[a];delete l.metadata,o.push(l)}return o}if(e){const r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;const e=t.clippingPlanes;let n=null;if(e!==null){const s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}}class Tr extends Nr{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ve(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Yi,this.combine=Yd,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}}const $e=new z,Yo=new Rt;let l0=0;class vn{constructor(t,e,n=!1){if(Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:l0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=Tu,this.updateRanges=[],this.gpuType=zi,this.version=0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Yo.fromBufferAttribute(this,e),Yo.applyMatrix3(t),this.setXY(e,Yo.x,Yo.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix3(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyMatrix4(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.applyNormalMatrix(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)$e.fromBufferAttribute(this,e),$e.transformDirection(t),this.setXYZ(e,$e.x,$e.y,$e.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=Yr(n,this.array)),n}setComponent(t,e,n){return this.normalized&&(n=Un(n,this.array)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=Yr(e,this.array)),e}setX(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=Yr(e,this.array)),e}setY(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=Yr(e,this.array)),e}setZ(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=Yr(e,this.array)),e}setW(t,e){return this.normalized&&(e=Un(e,this.array)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=Un(e,this.array),n=Un(n,this.array),s=Un(s,this.array),r=Un(r,this.array)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){const t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return this.name!==""&&(t.name=this.name),this.usage!==Tu&&(t.usage=this.usage),t}}class ap extends vn{constructor(t,e,n){super(new Uint16Array(t),e,n)}}class lp extends vn{constructor(t,e,n){super(new Uint32Array(t),e,n)}}class Cn extends vn{constructor(t,e,n){super(new Float32Array(t),e,n)}}let c0=0;const Qn=new Xe,Ll=new Rn,ar=new z,Vn=new Ir,Kr=new Ir,un=new z;class Pn extends zs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:c0++}),this.uuid=Ur(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={}}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ip(t)?lp:ap)(t,1):this.index=t,this}setIndirect(t){return this.indirect=t,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){const e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);const n=this.attributes.normal;if(n!==void 0){const r=new ie().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}const s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}applyQuaternion(t){return Qn.makeRotationFromQuaternion(t),this.applyMatrix4(Qn),this}rotateX(t){return Qn.makeRotationX(t),this.applyMatrix4(Qn),this}rotateY(t){return Qn.makeRotationY(t),this.applyMatrix4(Qn),this}rotateZ(t){return Qn.makeRotationZ(t),this.applyMatrix4(Qn),this}translate(t,e,n){return Qn.makeTranslation(t,e,n),this.applyMatrix4(Qn),this}scale(t,e,n){return Qn.makeScale(t,e,n),this.applyMatrix4(Qn),this}lookAt(t){return Ll.lookAt(t),Ll.updateMatrix(),this.applyMatrix4(Ll.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ar).negate(),this.translate(ar.x,ar.y,ar.z),this}setFromPoints(t){const e=this.getAttribute("position");if(e===void 0){const n=[];for(let s=0,r=t.length;s<r;s++){const o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Cn(n,3))}else{const n=Math.min(t.length,e.count);for(let s=0;s<n;s++){const r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&console.warn("THREE.BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ir);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){const r=e[n];Vn.setFromBufferAttribute(r),this.morphTargetsRelative?(un.addVectors(this.boundingBox.min,Vn.min),this.boundingBox.expandByPoint(un),un.addVectors(this.boundingBox.max,Vn.max),this.boundingBox.expandByPoint(un)):(this.boundingBox.expandByPoint(Vn.min),this.boundingBox.expandByPoint(Vn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&console.error('THREE.BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new bo);const t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){console.error("THREE.BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(t){const n=this.boundingSphere.center;if(Vn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){const a=e[r];Kr.setFromBufferAttribute(a),this.morphTargetsRelative?(un.addVectors(Vn.min,Kr.min),Vn.expandByPoint(un),un.addVectors(Vn.max,Kr.max),Vn.expandByPoint(un)):(Vn.expandByPoint(Kr.min),Vn.expandByPoint(Kr.max))}Vn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)un.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(un));if(e)for(let r=0,o=e.length;r<o;r++){const a=e[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)un.fromBufferAttribute(a,c),l&&(ar.fromBufferAttribute(t,c),un.add(ar)),s=Math.max(s,n.distanceToSquared(un))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error('THREE.BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){const t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){console.error("THREE.BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}const n=e.position,s=e.normal,r=e.uv;this.hasAttribute("tangent")===!1&&this.setAttribute("tangent",new vn(new Float32Array(4*n.count),4));const o=this.getAttribute("tangent"),a=[],l=[];for(let k=0;k<n.count;k++)a[k]=new z,l[k]=new z;const c=new z,u=new z,h=new z,f=new Rt,d=new Rt,g=new Rt,v=new z,m=new z;function p(k,b,E){c.fromBufferAttribute(n,k),u.fromBufferAttribute(n,b),h.fromBufferAttribute(n,E),f.fromBufferAttribute(r,k),d.fromBufferAttribute(r,b),g.fromBufferAttribute(r,E),u.sub(c),h.sub(c),d.sub(f),g.sub(f);const C=1/(d.x*g.y-g.x*d.y);isFinite(C)&&(v.copy(u).multiplyScalar(g.y).addScaledVector(h,-d.y).multiplyScalar(C),m.copy(h).multiplyScalar(d.x).addScaledVector(u,-g.x).multiplyScalar(C),a[k].add(v),a[b].add(v),a[E].add(v),l[k].add(m),l[b].add(m),l[E].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let k=0,b=w.length;k<b;++k){const E=w[k],C=E.start,G=E.count;for(let H=C,$=C+G;H<$;H+=3)p(t.getX(H+0),t.getX(H+1),t.getX(H+2))}const T=new z,M=new z,U=new z,D=new z;function I(k){U.fromBufferAttribute(s,k),D.copy(U);const b=a[k];T.copy(b),T.sub(U.multiplyScalar(U.dot(b))).normalize(),M.crossVectors(D,b);const C=M.dot(l[k])<0?-1:1;o.setXYZW(k,T.x,T.y,T.z,C)}for(let k=0,b=w.length;k<b;++k){const E=w[k],C=E.start,G=E.count;for(let H=C,$=C+G;H<$;H+=3)I(t.getX(H+0)),I(t.getX(H+1)),I(t.getX(H+2))}}computeVertexNormals(){const t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0)n=new vn(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let f=0,d=n.count;f<d;f++)n.setXYZ(f,0,0,0);const s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,h=new z;if(t)for(let f=0,d=t.count;f<d;f+=3){const g=t.getX(f+0),v=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,v),o.fromBufferAttribute(e,m),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),a.fromBufferAttribute(n,g),l.fromBufferAttribute(n,v),c.fromBufferAttribute(n,m),a.add(u),l.add(u),c.add(u),n.setXYZ(g,a.x,a.y,a.z),n.setXYZ(v,l.x,l.y,l.z),n.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),u.subVectors(o,r),h.subVectors(s,r),u.cross(h),n.setXYZ(f+0,u.x,u.y,u.z),n.setXYZ(f+1,u.x,u.y,u.z),n.setXYZ(f+2,u.x,u.y,u.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){const t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)un.fromBufferAttribute(t,e),un.normalize(),t.setXYZ(e,un.x,un.y,un.z)}toNonIndexed(){function t(a,l){const c=a.array,u=a.itemSize,h=a.normalized,f=new c.constructor(l.length*u);let d=0,g=0;for(let v=0,m=l.length;v<m;v++){a.isInterleavedBufferAttribute?d=l[v]*a.data.stride+a.offset:d=l[v]*u;for(let p=0;p<u;p++)f[g++]=c[d++]}return new vn(f,u,h)}if(this.index===null)return console.warn("THREE.BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;const e=new Pn,n=this.index.array,s=this.attributes;for(const a in s){const l=s[a],c=t(l,n);e.setAttribute(a,c)}const r=this.morphAttributes;for(const a in r){const l=[],c=r[a];for(let u=0,h=c.length;u<h;u++){const f=c[u],d=t(f,n);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;const o=this.groups;for(let a=0,l=o.length;a<l;a++){const c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){const t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.type,this.name!==""&&(t.name=this.name),Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0){const l=this.parameters;for(const c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};const e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});const n=this.attributes;for(const l in n){const c=n[l];t.data.attributes[l]=c.toJSON(t.data)}const s={};let r=!1;for(const l in this.morphAttributes){const c=this.morphAttributes[l],u=[];for(let h=0,f=c.length;h<f;h++){const d=c[h];u.push(d.toJSON(t.data))}u.length>0&&(s[l]=u,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);const o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));const a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;const e={};this.name=t.name;const n=t.index;n!==null&&this.setIndex(n.clone());const s=t.attributes;for(const c in s){const u=s[c];this.setAttribute(c,u.clone(e))}const r=t.morphAttributes;for(const c in r){const u=[],h=r[c];for(let f=0,d=h.length;f<d;f++)u.push(h[f].clone(e));this.morphAttributes[c]=u}this.morphTargetsRelative=t.morphTargetsRelative;const o=t.groups;for(let c=0,u=o.length;c<u;c++){const h=o[c];this.addGroup(h.start,h.count,h.materialIndex)}const a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());const l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this}dispose(){this.dispatchEvent({type:"dispose"})}}const Bu=new Xe,Ss=new za,qo=new bo,zu=new z,$o=new z,jo=new z,Ko=new z,Ul=new z,Zo=new z,Hu=new z,Jo=new z;class Yn extends Rn{constructor(t=new Pn,e=new Tr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0&&(this.morphTargetInfluences=t.morphTargetInfluences.slice()),t.morphTargetDictionary!==void 0&&(this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary)),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){const n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);const a=this.morphTargetInfluences;if(r&&a){Zo.set(0,0,0);for(let l=0,c=r.length;l<c;l++){const u=a[l],h=r[l];u!==0&&(Ul.fromBufferAttribute(h,t),o?Zo.addScaledVector(Ul,u):Zo.addScaledVector(Ul.sub(e),u))}e.add(Zo)}return e}raycast(t,e){const n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),qo.copy(n.boundingSphere),qo.applyMatrix4(r),Ss.copy(t.ray).recast(t.near),!(qo.containsPoint(Ss.origin)===!1&&(Ss.intersectSphere(qo,zu)===null||Ss.origin.distanceToSquared(zu)>(t.far-t.near)**2))&&(Bu.copy(r).invert(),Ss.copy(t.ray).applyMatrix4(Bu),!(n.boundingBox!==null&&Ss.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Ss)))}_computeIntersections(t,e,n){let s;const r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,h=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],w=Math.max(m.start,d.start),T=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=w,U=T;M<U;M+=3){const D=a.getX(M),I=a.getX(M+1),k=a.getX(M+2);s=Qo(this,p,t,n,c,u,h,D,I,k),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(a.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const w=a.getX(m),T=a.getX(m+1),M=a.getX(m+2);s=Qo(this,o,t,n,c,u,h,w,T,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,v=f.length;g<v;g++){const m=f[g],p=o[m.materialIndex],w=Math.max(m.start,d.start),T=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=w,U=T;M<U;M+=3){const D=M,I=M+1,k=M+2;s=Qo(this,p,t,n,c,u,h,D,I,k),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{const g=Math.max(0,d.start),v=Math.min(l.count,d.start+d.count);for(let m=g,p=v;m<p;m+=3){const w=m,T=m+1,M=m+2;s=Qo(this,o,t,n,c,u,h,w,T,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}}function h0(i,t,e,n,s,r,o,a){let l;if(t.side===Nn?l=n.intersectTriangle(o,r,s,!0,a):l=n.intersectTriangle(s,r,o,t.side===fs,a),l===null)return null;Jo.copy(a),Jo.applyMatrix4(i.matrixWorld);const c=e.ray.origin.distanceTo(Jo);return c<e.near||c>e.far?null:{distance:c,point:Jo.clone(),object:i}}function Qo(i,t,e,n,s,r,o,a,l,c){i.getVertexPosition(a,$o),i.getVertexPosition(l,jo),i.getVertexPosition(c,Ko);const u=h0(i,t,e,n,$o,jo,Ko,Hu);if(u){const h=new z;pi.getBarycoord(Hu,$o,jo,Ko,h),s&&(u.uv=pi.getInterpolatedAttribute(s,a,l,c,h,new Rt)),r&&(u.uv1=pi.getInterpolatedAttribute(r,a,l,c,h,new Rt)),o&&(u.normal=pi.getInterpolatedAttribute(o,a,l,c,h,new z),u.normal.dot(n.direction)>0&&u.normal.multiplyScalar(-1));const f={a,b:l,c,normal:new z,materialIndex:0};pi.getNormal($o,jo,Ko,f.normal),u.face=f,u.barycoord=h}return u}class Ao extends Pn{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};const a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);const l=[],c=[],u=[],h=[];let f=0,d=0;g("z","y","x",-1,-1,n,e,t,o,r,0),g("z","y","x",1,-1,n,e,-t,o,r,1),g("x","z","y",1,1,t,n,e,s,o,2),g("x","z","y",1,-1,t,n,-e,s,o,3),g("x","y","z",1,-1,t,e,n,s,r,4),g("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(l),this.setAttribute("position",new Cn(c,3)),this.setAttribute("normal",new Cn(u,3)),this.setAttribute("uv",new Cn(h,2));function g(v,m,p,w,T,M,U,D,I,k,b){const E=M/I,C=U/k,G=M/2,H=U/2,$=D/2,W=I+1,Z=k+1;let Y=0,J=0;const ot=new z;for(let at=0;at<Z;at++){const _t=at*C-H;for(let yt=0;yt<W;yt++){const gt=yt*E-G;ot[v]=gt*w,ot[m]=_t*T,ot[p]=$,c.push(ot.x,ot.y,ot.z),ot[v]=0,ot[m]=0,ot[p]=D>0?1:-1,u.push(ot.x,ot.y,ot.z),h.push(yt/I),h.push(1-at/k),Y+=1}}for(let at=0;at<k;at++)for(let _t=0;_t<I;_t++){const yt=f+_t+W*at,gt=f+_t+W*(at+1),ee=f+(_t+1)+W*(at+1),Zt=f+(_t+1)+W*at;l.push(yt,gt,Zt),l.push(gt,ee,Zt),J+=6}a.addGroup(d,J,b),d+=J,f+=Y}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ao(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}}function br(i){const t={};for(const e in i){t[e]={};for(const n in i[e]){const s=i[e][n];s&&(s.isColor||s.isMatrix3||s.isMatrix4||s.isVector2||s.isVector3||s.isVector4||s.isTexture||s.isQuaternion)?s.isRenderTargetTexture?(console.warn("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone():Array.isArray(s)?t[e][n]=s.slice():t[e][n]=s}}return t}function bn(i){const t={};for(let e=0;e<i.length;e++){const n=br(i[e]);for(const s in n)t[s]=n[s]}return t}function u0(i){const t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function cp(i){const t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:ge.workingColorSpace}const f0={clone:br,merge:bn};var d0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,p0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`;class qi extends Nr{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=d0,this.fragmentShader=p0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=br(t.uniforms),this.uniformsGroups=u0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this}toJSON(t){const e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(const s in this.uniforms){const o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;const n={};for(const s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}}class hp extends Rn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new Xe,this.projectionMatrix=new Xe,this.projectionMatrixInverse=new Xe,this.coordinateSystem=Ai,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorldInverse.copy(this.matrixWorld).invert()}updateWorldMatrix(t,e){super.updateWorldMatrix(t,e),this.matrixWorldInverse.copy(this.matrixWorld).invert()}clone(){return new this.constructor().copy(this)}}const rs=new z,Vu=new Rt,Gu=new Rt;class Xn extends hp{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){const e=.5*this.getFilmHeight()/t;this.fov=Yc*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){const t=Math.tan(ya*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Yc*2*Math.atan(Math.tan(ya*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){rs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(rs.x,rs.y).multiplyScalar(-t/rs.z),rs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(rs.x,rs.y).multiplyScalar(-t/rs.z)}getViewSize(t,e){return this.getViewBounds(t,Vu,Gu),e.subVectors(Gu,Vu)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=this.near;let e=t*Math.tan(ya*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s;const o=this.view;if(this.view!==null&&this.view.enabled){const l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*n/c,s*=o.width/l,n*=o.height/c}const a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}}const lr=-90,cr=1;class m0 extends Rn{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;const s=new Xn(lr,cr,t,e);s.layers=this.layers,this.add(s);const r=new Xn(lr,cr,t,e);r.layers=this.layers,this.add(r);const o=new Xn(lr,cr,t,e);o.layers=this.layers,this.add(o);const a=new Xn(lr,cr,t,e);a.layers=this.layers,this.add(a);const l=new Xn(lr,cr,t,e);l.layers=this.layers,this.add(l);const c=new Xn(lr,cr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){const t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,l]=e;for(const c of e)this.remove(c);if(t===Ai)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ba)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(const c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();const{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());const[r,o,a,l,c,u]=this.children,h=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;const v=n.texture.generateMipmaps;n.texture.generateMipmaps=!1,t.setRenderTarget(n,0,s),t.render(e,r),t.setRenderTarget(n,1,s),t.render(e,o),t.setRenderTarget(n,2,s),t.render(e,a),t.setRenderTarget(n,3,s),t.render(e,l),t.setRenderTarget(n,4,s),t.render(e,c),n.texture.generateMipmaps=v,t.setRenderTarget(n,5,s),t.render(e,u),t.setRenderTarget(h,f,d),t.xr.enabled=g,n.texture.needsPMREMUpdate=!0}}class up extends xn{constructor(t=[],e=Sr,n,s,r,o,a,l,c,u){super(t,e,n,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}}class g0 extends Os{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;const n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new up(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;const n={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ao(5,5,5),r=new qi({name:"CubemapFromEquirect",uniforms:br(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:Nn,blending:Vi});r.uniforms.tEquirect.value=e;const o=new Yn(s,r),a=e.minFilter;return e.minFilter===Us&&(e.minFilter=bi),new m0(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){const r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}}class dr extends Rn{constructor(){super(),this.isGroup=!0,this.type="Group"}}const _0={type:"move"};class Il{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new dr,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new dr,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new dr,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){const e=this._hand;if(e)for(const n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null;const a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(const v of t.hand.values()){const m=e.getJointPose(v,n),p=this._getHandJoint(c,v);m!==null&&(p.matrix.fromArray(m.transform.matrix),p.matrix.decompose(p.position,p.rotation,p.scale),p.matrixWorldNeedsUpdate=!0,p.jointRadius=m.radius),p.visible=m!==null}const u=c.joints["index-finger-tip"],h=c.joints["thumb-tip"],f=u.position.distanceTo(h.position),d=.02,g=.005;c.inputState.pinching&&f>d+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.rotation,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.rotation,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(_0)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){const n=new dr;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}}class fp extends Rn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Yi,this.environmentIntensity=1,this.environmentRotation=new Yi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),t.background!==null&&(this.background=t.background.clone()),t.environment!==null&&(this.environment=t.environment.clone()),t.fog!==null&&(this.fog=t.fog.clone()),this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),t.overrideMaterial!==null&&(this.overrideMaterial=t.overrideMaterial.clone()),this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){const e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),this.backgroundBlurriness>0&&(e.object.backgroundBlurriness=this.backgroundBlurriness),this.backgroundIntensity!==1&&(e.object.backgroundIntensity=this.backgroundIntensity),e.object.backgroundRotation=this.backgroundRotation.toArray(),this.environmentIntensity!==1&&(e.object.environmentIntensity=this.environmentIntensity),e.object.environmentRotation=this.environmentRotation.toArray(),e}}class v0 extends xn{constructor(t=null,e=1,n=1,s,r,o,a,l,c=Fn,u=Fn,h,f){super(null,o,a,l,c,u,s,r,h,f),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}}const Nl=new z,x0=new z,y0=new ie;class os{constructor(t=new z(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){const s=Nl.subVectors(n,e).cross(x0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){const t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e){const n=t.delta(Nl),s=this.normal.dot(n);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;const r=-(t.start.dot(this.normal)+this.constant)/s;return r<0||r>1?null:e.copy(t.start).addScaledVector(n,r)}intersectsLine(t){const e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){const n=e||y0.getNormalMatrix(t),s=this.coplanarPoint(Nl).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}}const Es=new bo,M0=new Rt(.5,.5),ta=new z;class dp{constructor(t=new os,e=new os,n=new os,s=new os,r=new os,o=new os){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){const a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){const e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Ai,n=!1){const s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],h=r[5],f=r[6],d=r[7],g=r[8],v=r[9],m=r[10],p=r[11],w=r[12],T=r[13],M=r[14],U=r[15];if(s[0].setComponents(c-o,d-u,p-g,U-w).normalize(),s[1].setComponents(c+o,d+u,p+g,U+w).normalize(),s[2].setComponents(c+a,d+h,p+v,U+T).normalize(),s[3].setComponents(c-a,d-h,p-v,U-T).normalize(),n)s[4].setComponents(l,f,m,M).normalize(),s[5].setComponents(c-l,d-f,p-m,U-M).normalize();else if(s[4].setComponents(c-l,d-f,p-m,U-M).normalize(),e===Ai)s[5].setComponents(c+l,d+f,p+m,U+M).normalize();else if(e===ba)s[5].setComponents(l,f,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Es.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{const e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Es.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Es)}intersectsSprite(t){Es.center.set(0,0,0);const e=M0.distanceTo(t.center);return Es.radius=.7071067811865476+e,Es.applyMatrix4(t.matrixWorld),this.intersectsSphere(Es)}intersectsSphere(t){const e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){const e=this.planes;for(let n=0;n<6;n++){const s=e[n];if(ta.x=s.normal.x>0?t.max.x:t.min.x,ta.y=s.normal.y>0?t.max.y:t.min.y,ta.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(ta)<0)return!1}return!0}containsPoint(t){const e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}}class pp extends Nr{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ve(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}}const Ra=new z,Ca=new z,Wu=new Xe,Zr=new za,ea=new bo,Fl=new z,Xu=new z;class S0 extends Rn{constructor(t=new Pn,e=new pp){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)Ra.fromBufferAttribute(e,s-1),Ca.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=Ra.distanceTo(Ca);t.setAttribute("lineDistance",new Cn(n,1))}else console.warn("THREE.Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ea.copy(n.boundingSphere),ea.applyMatrix4(s),ea.radius+=r,t.ray.intersectsSphere(ea)===!1)return;Wu.copy(s).invert(),Zr.copy(t.ray).applyMatrix4(Wu);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=n.index,f=n.attributes.position;if(u!==null){const d=Math.max(0,o.start),g=Math.min(u.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=u.getX(v),w=u.getX(v+1),T=na(this,t,Zr,l,p,w,v);T&&e.push(T)}if(this.isLineLoop){const v=u.getX(g-1),m=u.getX(d),p=na(this,t,Zr,l,v,m,g-1);p&&e.push(p)}}else{const d=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let v=d,m=g-1;v<m;v+=c){const p=na(this,t,Zr,l,v,v+1,v);p&&e.push(p)}if(this.isLineLoop){const v=na(this,t,Zr,l,g-1,d,g-1);v&&e.push(v)}}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function na(i,t,e,n,s,r,o){const a=i.geometry.attributes.position;if(Ra.fromBufferAttribute(a,s),Ca.fromBufferAttribute(a,r),e.distanceSqToSegment(Ra,Ca,Fl,Xu)>n)return;Fl.applyMatrix4(i.matrixWorld);const c=t.ray.origin.distanceTo(Fl);if(!(c<t.near||c>t.far))return{distance:c,point:Xu.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}const Yu=new z,qu=new z;class E0 extends S0{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){const t=this.geometry;if(t.index===null){const e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Yu.fromBufferAttribute(e,s),qu.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Yu.distanceTo(qu);t.setAttribute("lineDistance",new Cn(n,1))}else console.warn("THREE.LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}}class mp extends Nr{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ve(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}}const $u=new Xe,qc=new za,ia=new bo,sa=new z;class w0 extends Rn{constructor(t=new Pn,e=new mp){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}raycast(t,e){const n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),ia.copy(n.boundingSphere),ia.applyMatrix4(s),ia.radius+=r,t.ray.intersectsSphere(ia)===!1)return;$u.copy(s).invert(),qc.copy(t.ray).applyMatrix4($u);const a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=n.index,h=n.attributes.position;if(c!==null){const f=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let g=f,v=d;g<v;g++){const m=c.getX(g);sa.fromBufferAttribute(h,m),ju(sa,m,l,s,t,e,this)}}else{const f=Math.max(0,o.start),d=Math.min(h.count,o.start+o.count);for(let g=f,v=d;g<v;g++)sa.fromBufferAttribute(h,g),ju(sa,g,l,s,t,e,this)}}updateMorphTargets(){const e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){const s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){const a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}}function ju(i,t,e,n,s,r,o){const a=qc.distanceSqToPoint(i);if(a<e){const l=new z;qc.closestPointToPoint(i,l),l.applyMatrix4(n);const c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}class T0 extends xn{constructor(t,e,n,s,r,o,a,l,c){super(t,e,n,s,r,o,a,l,c),this.isCanvasTexture=!0,this.needsUpdate=!0}}class gp extends xn{constructor(t,e,n=Ns,s,r,o,a=Fn,l=Fn,c,u=vo,h=1){if(u!==vo&&u!==xo)throw new Error("DepthTexture format must be either THREE.DepthFormat or THREE.DepthStencilFormat");const f={width:t,height:e,depth:h};super(f,s,r,o,a,l,u,n,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new yh(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){const e=super.toJSON(t);return this.compareFunction!==null&&(e.compareFunction=this.compareFunction),e}}class _p extends xn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}}class Ci{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){console.warn("THREE.Curve: .getPoint() not implemented.")}getPointAt(t,e){const n=this.getUtoTmapping(t);return this.getPoint(n,e)}getPoints(t=5){const e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return e}getSpacedPoints(t=5){const e=[];for(let n=0;n<=t;n++)e.push(this.getPointAt(n/t));return e}getLength(){const t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;const e=[];let n,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)n=this.getPoint(o/t),r+=n.distanceTo(s),e.push(r),s=n;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){const n=this.getLengths();let s=0;const r=n.length;let o;e?o=e:o=t*n[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=n[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,n[s]===o)return s/(r-1);const u=n[s],f=n[s+1]-u,d=(o-u)/f;return(s+d)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);const o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new Rt:new z);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){const n=this.getUtoTmapping(t);return this.getTangent(n,e)}computeFrenetFrames(t,e=!1){const n=new z,s=[],r=[],o=[],a=new z,l=new Xe;for(let d=0;d<=t;d++){const g=d/t;s[d]=this.getTangentAt(g,new z)}r[0]=new z,o[0]=new z;let c=Number.MAX_VALUE;const u=Math.abs(s[0].x),h=Math.abs(s[0].y),f=Math.abs(s[0].z);u<=c&&(c=u,n.set(1,0,0)),h<=c&&(c=h,n.set(0,1,0)),f<=c&&n.set(0,0,1),a.crossVectors(s[0],n).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let d=1;d<=t;d++){if(r[d]=r[d-1].clone(),o[d]=o[d-1].clone(),a.crossVectors(s[d-1],s[d]),a.length()>Number.EPSILON){a.normalize();const g=Math.acos(oe(s[d-1].dot(s[d]),-1,1));r[d].applyMatrix4(l.makeRotationAxis(a,g))}o[d].crossVectors(s[d],r[d])}if(e===!0){let d=Math.acos(oe(r[0].dot(r[t]),-1,1));d/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(d=-d);for(let g=1;g<=t;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],d*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}toJSON(){const t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this}}class Mh extends Ci{constructor(t=0,e=0,n=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=n,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new Rt){const n=e,s=Math.PI*2;let r=this.aEndAngle-this.aStartAngle;const o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);const a=this.aStartAngle+t*r;let l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){const u=Math.cos(this.aRotation),h=Math.sin(this.aRotation),f=l-this.aX,d=c-this.aY;l=f*u-d*h+this.aX,c=f*h+d*u+this.aY}return n.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){const t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}}class b0 extends Mh{constructor(t,e,n,s,r,o){super(t,e,n,n,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}}function Sh(){let i=0,t=0,e=0,n=0;function s(r,o,a,l){i=r,t=a,e=-3*r+3*o-2*a-l,n=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,u,h){let f=(o-r)/c-(a-r)/(c+u)+(a-o)/u,d=(a-o)/u-(l-o)/(u+h)+(l-a)/h;f*=u,d*=u,s(o,a,f,d)},calc:function(r){const o=r*r,a=o*r;return i+t*r+e*o+n*a}}}const ra=new z,Ol=new Sh,kl=new Sh,Bl=new Sh;class A0 extends Ci{constructor(t=[],e=!1,n="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=n,this.tension=s}getPoint(t,e=new z){const n=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t;let a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,u;this.closed||a>0?c=s[(a-1)%r]:(ra.subVectors(s[0],s[1]).add(s[0]),c=ra);const h=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?u=s[(a+2)%r]:(ra.subVectors(s[r-1],s[r-2]).add(s[r-1]),u=ra),this.curveType==="centripetal"||this.curveType==="chordal"){const d=this.curveType==="chordal"?.5:.25;let g=Math.pow(c.distanceToSquared(h),d),v=Math.pow(h.distanceToSquared(f),d),m=Math.pow(f.distanceToSquared(u),d);v<1e-4&&(v=1),g<1e-4&&(g=v),m<1e-4&&(m=v),Ol.initNonuniformCatmullRom(c.x,h.x,f.x,u.x,g,v,m),kl.initNonuniformCatmullRom(c.y,h.y,f.y,u.y,g,v,m),Bl.initNonuniformCatmullRom(c.z,h.z,f.z,u.z,g,v,m)}else this.curveType==="catmullrom"&&(Ol.initCatmullRom(c.x,h.x,f.x,u.x,this.tension),kl.initCatmullRom(c.y,h.y,f.y,u.y,this.tension),Bl.initCatmullRom(c.z,h.z,f.z,u.z,this.tension));return n.set(Ol.calc(l),kl.calc(l),Bl.calc(l)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){const t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){const s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(new z().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}}function Ku(i,t,e,n,s){const r=(n-t)*.5,o=(s-e)*.5,a=i*i,l=i*a;return(2*e-2*n+r+o)*l+(-3*e+3*n-2*r-o)*a+r*i+e}function R0(i,t){const e=1-i;return e*e*t}function C0(i,t){return 2*(1-i)*i*t}function P0(i,t){return i*i*t}function lo(i,t,e,n){return R0(i,t)+C0(i,e)+P0(i,n)}function D0(i,t){const e=1-i;return e*e*e*t}function L0(i,t){const e=1-i;return 3*e*e*i*t}function U0(i,t){return 3*(1-i)*i*i*t}function I0(i,t){return i*i*i*t}function co(i,t,e,n,s){return D0(i,t)+L0(i,e)+U0(i,n)+I0(i,s)}class vp extends Ci{constructor(t=new Rt,e=new Rt,n=new Rt,s=new Rt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new Rt){const n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(co(t,s.x,r.x,o.x,a.x),co(t,s.y,r.y,o.y,a.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}}class N0 extends Ci{constructor(t=new z,e=new z,n=new z,s=new z){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=n,this.v3=s}getPoint(t,e=new z){const n=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return n.set(co(t,s.x,r.x,o.x,a.x),co(t,s.y,r.y,o.y,a.y),co(t,s.z,r.z,o.z,a.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}}class xp extends Ci{constructor(t=new Rt,e=new Rt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new Rt){const n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new Rt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class F0 extends Ci{constructor(t=new z,e=new z){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new z){const n=e;return t===1?n.copy(this.v2):(n.copy(this.v2).sub(this.v1),n.multiplyScalar(t).add(this.v1)),n}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new z){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class yp extends Ci{constructor(t=new Rt,e=new Rt,n=new Rt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new Rt){const n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(lo(t,s.x,r.x,o.x),lo(t,s.y,r.y,o.y)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class O0 extends Ci{constructor(t=new z,e=new z,n=new z){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=n}getPoint(t,e=new z){const n=e,s=this.v0,r=this.v1,o=this.v2;return n.set(lo(t,s.x,r.x,o.x),lo(t,s.y,r.y,o.y),lo(t,s.z,r.z,o.z)),n}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){const t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}}class Mp extends Ci{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new Rt){const n=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],u=s[o>s.length-2?s.length-1:o+1],h=s[o>s.length-3?s.length-1:o+2];return n.set(Ku(a,l.x,c.x,u.x,h.x),Ku(a,l.y,c.y,u.y,h.y)),n}copy(t){super.copy(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(s.clone())}return this}toJSON(){const t=super.toJSON();t.points=[];for(let e=0,n=this.points.length;e<n;e++){const s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,n=t.points.length;e<n;e++){const s=t.points[e];this.points.push(new Rt().fromArray(s))}return this}}var Zu=Object.freeze({__proto__:null,ArcCurve:b0,CatmullRomCurve3:A0,CubicBezierCurve:vp,CubicBezierCurve3:N0,EllipseCurve:Mh,LineCurve:xp,LineCurve3:F0,QuadraticBezierCurve:yp,QuadraticBezierCurve3:O0,SplineCurve:Mp});class k0 extends Ci{constructor(){super(),this.type="CurvePath",this.curves=[],this.autoClose=!1}add(t){this.curves.push(t)}closePath(){const t=this.curves[0].getPoint(0),e=this.curves[this.curves.length-1].getPoint(1);if(!t.equals(e)){const n=t.isVector2===!0?"LineCurve":"LineCurve3";this.curves.push(new Zu[n](e,t))}return this}getPoint(t,e){const n=t*this.getLength(),s=this.getCurveLengths();let r=0;for(;r<s.length;){if(s[r]>=n){const o=s[r]-n,a=this.curves[r],l=a.getLength(),c=l===0?0:1-o/l;return a.getPointAt(c,e)}r++}return null}getLength(){const t=this.getCurveLengths();return t[t.length-1]}updateArcLengths(){this.needsUpdate=!0,this.cacheLengths=null,this.getCurveLengths()}getCurveLengths(){if(this.cacheLengths&&this.cacheLengths.length===this.curves.length)return this.cacheLengths;const t=[];let e=0;for(let n=0,s=this.curves.length;n<s;n++)e+=this.curves[n].getLength(),t.push(e);return this.cacheLengths=t,t}getSpacedPoints(t=40){const e=[];for(let n=0;n<=t;n++)e.push(this.getPoint(n/t));return this.autoClose&&e.push(e[0]),e}getPoints(t=12){const e=[];let n;for(let s=0,r=this.curves;s<r.length;s++){const o=r[s],a=o.isEllipseCurve?t*2:o.isLineCurve||o.isLineCurve3?1:o.isSplineCurve?t*o.points.length:t,l=o.getPoints(a);for(let c=0;c<l.length;c++){const u=l[c];n&&n.equals(u)||(e.push(u),n=u)}}return this.autoClose&&e.length>1&&!e[e.length-1].equals(e[0])&&e.push(e[0]),e}copy(t){super.copy(t),this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){const s=t.curves[e];this.curves.push(s.clone())}return this.autoClose=t.autoClose,this}toJSON(){const t=super.toJSON();t.autoClose=this.autoClose,t.curves=[];for(let e=0,n=this.curves.length;e<n;e++){const s=this.curves[e];t.curves.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.autoClose=t.autoClose,this.curves=[];for(let e=0,n=t.curves.length;e<n;e++){const s=t.curves[e];this.curves.push(new Zu[s.type]().fromJSON(s))}return this}}class Ju extends k0{constructor(t){super(),this.type="Path",this.currentPoint=new Rt,t&&this.setFromPoints(t)}setFromPoints(t){this.moveTo(t[0].x,t[0].y);for(let e=1,n=t.length;e<n;e++)this.lineTo(t[e].x,t[e].y);return this}moveTo(t,e){return this.currentPoint.set(t,e),this}lineTo(t,e){const n=new xp(this.currentPoint.clone(),new Rt(t,e));return this.curves.push(n),this.currentPoint.set(t,e),this}quadraticCurveTo(t,e,n,s){const r=new yp(this.currentPoint.clone(),new Rt(t,e),new Rt(n,s));return this.curves.push(r),this.currentPoint.set(n,s),this}bezierCurveTo(t,e,n,s,r,o){const a=new vp(this.currentPoint.clone(),new Rt(t,e),new Rt(n,s),new Rt(r,o));return this.curves.push(a),this.currentPoint.set(r,o),this}splineThru(t){const e=[this.currentPoint.clone()].concat(t),n=new Mp(e);return this.curves.push(n),this.currentPoint.copy(t[t.length-1]),this}arc(t,e,n,s,r,o){const a=this.currentPoint.x,l=this.currentPoint.y;return this.absarc(t+a,e+l,n,s,r,o),this}absarc(t,e,n,s,r,o){return this.absellipse(t,e,n,n,s,r,o),this}ellipse(t,e,n,s,r,o,a,l){const c=this.currentPoint.x,u=this.currentPoint.y;return this.absellipse(t+c,e+u,n,s,r,o,a,l),this}absellipse(t,e,n,s,r,o,a,l){const c=new Mh(t,e,n,s,r,o,a,l);if(this.curves.length>0){const h=c.getPoint(0);h.equals(this.currentPoint)||this.lineTo(h.x,h.y)}this.curves.push(c);const u=c.getPoint(1);return this.currentPoint.copy(u),this}copy(t){return super.copy(t),this.currentPoint.copy(t.currentPoint),this}toJSON(){const t=super.toJSON();return t.currentPoint=this.currentPoint.toArray(),t}fromJSON(t){return super.fromJSON(t),this.currentPoint.fromArray(t.currentPoint),this}}class Sp extends Ju{constructor(t){super(t),this.uuid=Ur(),this.type="Shape",this.holes=[]}getPointsHoles(t){const e=[];for(let n=0,s=this.holes.length;n<s;n++)e[n]=this.holes[n].getPoints(t);return e}extractPoints(t){return{shape:this.getPoints(t),holes:this.getPointsHoles(t)}}copy(t){super.copy(t),this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){const s=t.holes[e];this.holes.push(s.clone())}return this}toJSON(){const t=super.toJSON();t.uuid=this.uuid,t.holes=[];for(let e=0,n=this.holes.length;e<n;e++){const s=this.holes[e];t.holes.push(s.toJSON())}return t}fromJSON(t){super.fromJSON(t),this.uuid=t.uuid,this.holes=[];for(let e=0,n=t.holes.length;e<n;e++){const s=t.holes[e];this.holes.push(new Ju().fromJSON(s))}return this}}function B0(i,t,e=2){const n=t&&t.length,s=n?t[0]*e:i.length;let r=Ep(i,0,s,e,!0);const o=[];if(!r||r.next===r.prev)return o;let a,l,c;if(n&&(r=W0(i,t,r,e)),i.length>80*e){a=1/0,l=1/0;let u=-1/0,h=-1/0;for(let f=e;f<s;f+=e){const d=i[f],g=i[f+1];d<a&&(a=d),g<l&&(l=g),d>u&&(u=d),g>h&&(h=g)}c=Math.max(u-a,h-l),c=c!==0?32767/c:0}return Mo(r,o,e,a,l,c,0),o}function Ep(i,t,e,n,s){let r;if(s===ev(i,t,e,n)>0)for(let o=t;o<e;o+=n)r=Qu(o/n|0,i[o],i[o+1],r);else for(let o=e-n;o>=t;o-=n)r=Qu(o/n|0,i[o],i[o+1],r);return r&&Ar(r,r.next)&&(Eo(r),r=r.next),r}function ks(i,t){if(!i)return i;t||(t=i);let e=i,n;do if(n=!1,!e.steiner&&(Ar(e,e.next)||Ve(e.prev,e,e.next)===0)){if(Eo(e),e=t=e.prev,e===e.next)break;n=!0}else e=e.next;while(n||e!==t);return t}function Mo(i,t,e,n,s,r,o){if(!i)return;!o&&r&&j0(i,n,s,r);let a=i;for(;i.prev!==i.next;){const l=i.prev,c=i.next;if(r?H0(i,n,s,r):z0(i)){t.push(l.i,i.i,c.i),Eo(i),i=c.next,a=c.next;continue}if(i=c,i===a){o?o===1?(i=V0(ks(i),t),Mo(i,t,e,n,s,r,2)):o===2&&G0(i,t,e,n,s,r):Mo(ks(i),t,e,n,s,r,1);break}}}function z0(i){const t=i.prev,e=i,n=i.next;if(Ve(t,e,n)>=0)return!1;const s=t.x,r=e.x,o=n.x,a=t.y,l=e.y,c=n.y,u=Math.min(s,r,o),h=Math.min(a,l,c),f=Math.max(s,r,o),d=Math.max(a,l,c);let g=n.next;for(;g!==t;){if(g.x>=u&&g.x<=f&&g.y>=h&&g.y<=d&&no(s,a,r,l,o,c,g.x,g.y)&&Ve(g.prev,g,g.next)>=0)return!1;g=g.next}return!0}function H0(i,t,e,n){const s=i.prev,r=i,o=i.next;if(Ve(s,r,o)>=0)return!1;const a=s.x,l=r.x,c=o.x,u=s.y,h=r.y,f=o.y,d=Math.min(a,l,c),g=Math.min(u,h,f),v=Math.max(a,l,c),m=Math.max(u,h,f),p=$c(d,g,t,e,n),w=$c(v,m,t,e,n);let T=i.prevZ,M=i.nextZ;for(;T&&T.z>=p&&M&&M.z<=w;){if(T.x>=d&&T.x<=v&&T.y>=g&&T.y<=m&&T!==s&&T!==o&&no(a,u,l,h,c,f,T.x,T.y)&&Ve(T.prev,T,T.next)>=0||(T=T.prevZ,M.x>=d&&M.x<=v&&M.y>=g&&M.y<=m&&M!==s&&M!==o&&no(a,u,l,h,c,f,M.x,M.y)&&Ve(M.prev,M,M.next)>=0))return!1;M=M.nextZ}for(;T&&T.z>=p;){if(T.x>=d&&T.x<=v&&T.y>=g&&T.y<=m&&T!==s&&T!==o&&no(a,u,l,h,c,f,T.x,T.y)&&Ve(T.prev,T,T.next)>=0)return!1;T=T.prevZ}for(;M&&M.z<=w;){if(M.x>=d&&M.x<=v&&M.y>=g&&M.y<=m&&M!==s&&M!==o&&no(a,u,l,h,c,f,M.x,M.y)&&Ve(M.prev,M,M.next)>=0)return!1;M=M.nextZ}return!0}function V0(i,t){let e=i;do{const n=e.prev,s=e.next.next;!Ar(n,s)&&Tp(n,e,e.next,s)&&So(n,s)&&So(s,n)&&(t.push(n.i,e.i,s.i),Eo(e),Eo(e.next),e=i=s),e=e.next}while(e!==i);return ks(e)}function G0(i,t,e,n,s,r){let o=i;do{let a=o.next.next;for(;a!==o.prev;){if(o.i!==a.i&&J0(o,a)){let l=bp(o,a);o=ks(o,o.next),l=ks(l,l.next),Mo(o,t,e,n,s,r,0),Mo(l,t,e,n,s,r,0);return}a=a.next}o=o.next}while(o!==i)}function W0(i,t,e,n){const s=[];for(let r=0,o=t.length;r<o;r++){const a=t[r]*n,l=r<o-1?t[r+1]*n:i.length,c=Ep(i,a,l,n,!1);c===c.next&&(c.steiner=!0),s.push(Z0(c))}s.sort(X0);for(let r=0;r<s.length;r++)e=Y0(s[r],e);return e}function X0(i,t){let e=i.x-t.x;if(e===0&&(e=i.y-t.y,e===0)){const n=(i.next.y-i.y)/(i.next.x-i.x),s=(t.next.y-t.y)/(t.next.x-t.x);e=n-s}return e}function Y0(i,t){const e=q0(i,t);if(!e)return t;const n=bp(e,i);return ks(n,n.next),ks(e,e.next)}function q0(i,t){let e=t;const n=i.x,s=i.y;let r=-1/0,o;if(Ar(i,e))return e;do{if(Ar(i,e.next))return e.next;if(s<=e.y&&s>=e.next.y&&e.next.y!==e.y){const h=e.x+(s-e.y)*(e.next.x-e.x)/(e.next.y-e.y);if(h<=n&&h>r&&(r=h,o=e.x<e.next.x?e:e.next,h===n))return o}e=e.next}while(e!==t);if(!o)return null;const a=o,l=o.x,c=o.y;let u=1/0;e=o;do{if(n>=e.x&&e.x>=l&&n!==e.x&&wp(s<c?n:r,s,l,c,s<c?r:n,s,e.x,e.y)){const h=Math.abs(s-e.y)/(n-e.x);So(e,i)&&(h<u||h===u&&(e.x>o.x||e.x===o.x&&$0(o,e)))&&(o=e,u=h)}e=e.next}while(e!==a);return o}function $0(i,t){return Ve(i.prev,i,t.prev)<0&&Ve(t.next,i,i.next)<0}function j0(i,t,e,n){let s=i;do s.z===0&&(s.z=$c(s.x,s.y,t,e,n)),s.prevZ=s.prev,s.nextZ=s.next,s=s.next;while(s!==i);s.prevZ.nextZ=null,s.prevZ=null,K0(s)}function K0(i){let t,e=1;do{let n=i,s;i=null;let r=null;for(t=0;n;){t++;let o=n,a=0;for(let c=0;c<e&&(a++,o=o.nextZ,!!o);c++);let l=e;for(;a>0||l>0&&o;)a!==0&&(l===0||!o||n.z<=o.z)?(s=n,n=n.nextZ,a--):(s=o,o=o.nextZ,l--),r?r.nextZ=s:i=s,s.prevZ=r,r=s;n=o}r.nextZ=null,e*=2}while(t>1);return i}function $c(i,t,e,n,s){return i=(i-e)*s|0,t=(t-n)*s|0,i=(i|i<<8)&16711935,i=(i|i<<4)&252645135,i=(i|i<<2)&858993459,i=(i|i<<1)&1431655765,t=(t|t<<8)&16711935,t=(t|t<<4)&252645135,t=(t|t<<2)&858993459,t=(t|t<<1)&1431655765,i|t<<1}function Z0(i){let t=i,e=i;do(t.x<e.x||t.x===e.x&&t.y<e.y)&&(e=t),t=t.next;while(t!==i);return e}function wp(i,t,e,n,s,r,o,a){return(s-o)*(t-a)>=(i-o)*(r-a)&&(i-o)*(n-a)>=(e-o)*(t-a)&&(e-o)*(r-a)>=(s-o)*(n-a)}function no(i,t,e,n,s,r,o,a){return!(i===o&&t===a)&&wp(i,t,e,n,s,r,o,a)}function J0(i,t){return i.next.i!==t.i&&i.prev.i!==t.i&&!Q0(i,t)&&(So(i,t)&&So(t,i)&&tv(i,t)&&(Ve(i.prev,i,t.prev)||Ve(i,t.prev,t))||Ar(i,t)&&Ve(i.prev,i,i.next)>0&&Ve(t.prev,t,t.next)>0)}function Ve(i,t,e){return(t.y-i.y)*(e.x-t.x)-(t.x-i.x)*(e.y-t.y)}function Ar(i,t){return i.x===t.x&&i.y===t.y}function Tp(i,t,e,n){const s=aa(Ve(i,t,e)),r=aa(Ve(i,t,n)),o=aa(Ve(e,n,i)),a=aa(Ve(e,n,t));return!!(s!==r&&o!==a||s===0&&oa(i,e,t)||r===0&&oa(i,n,t)||o===0&&oa(e,i,n)||a===0&&oa(e,t,n))}function oa(i,t,e){return t.x<=Math.max(i.x,e.x)&&t.x>=Math.min(i.x,e.x)&&t.y<=Math.max(i.y,e.y)&&t.y>=Math.min(i.y,e.y)}function aa(i){return i>0?1:i<0?-1:0}function Q0(i,t){let e=i;do{if(e.i!==i.i&&e.next.i!==i.i&&e.i!==t.i&&e.next.i!==t.i&&Tp(e,e.next,i,t))return!0;e=e.next}while(e!==i);return!1}function So(i,t){return Ve(i.prev,i,i.next)<0?Ve(i,t,i.next)>=0&&Ve(i,i.prev,t)>=0:Ve(i,t,i.prev)<0||Ve(i,i.next,t)<0}function tv(i,t){let e=i,n=!1;const s=(i.x+t.x)/2,r=(i.y+t.y)/2;do e.y>r!=e.next.y>r&&e.next.y!==e.y&&s<(e.next.x-e.x)*(r-e.y)/(e.next.y-e.y)+e.x&&(n=!n),e=e.next;while(e!==i);return n}function bp(i,t){const e=jc(i.i,i.x,i.y),n=jc(t.i,t.x,t.y),s=i.next,r=t.prev;return i.next=t,t.prev=i,e.next=s,s.prev=e,n.next=e,e.prev=n,r.next=n,n.prev=r,n}function Qu(i,t,e,n){const s=jc(i,t,e);return n?(s.next=n.next,s.prev=n,n.next.prev=s,n.next=s):(s.prev=s,s.next=s),s}function Eo(i){i.next.prev=i.prev,i.prev.next=i.next,i.prevZ&&(i.prevZ.nextZ=i.nextZ),i.nextZ&&(i.nextZ.prevZ=i.prevZ)}function jc(i,t,e){return{i,x:t,y:e,prev:null,next:null,z:0,prevZ:null,nextZ:null,steiner:!1}}function ev(i,t,e,n){let s=0;for(let r=t,o=e-n;r<e;r+=n)s+=(i[o]-i[r])*(i[r+1]+i[o+1]),o=r;return s}class nv{static triangulate(t,e,n=2){return B0(t,e,n)}}class ho{static area(t){const e=t.length;let n=0;for(let s=e-1,r=0;r<e;s=r++)n+=t[s].x*t[r].y-t[r].x*t[s].y;return n*.5}static isClockWise(t){return ho.area(t)<0}static triangulateShape(t,e){const n=[],s=[],r=[];tf(t),ef(n,t);let o=t.length;e.forEach(tf);for(let l=0;l<e.length;l++)s.push(o),o+=e[l].length,ef(n,e[l]);const a=nv.triangulate(n,s);for(let l=0;l<a.length;l+=3)r.push(a.slice(l,l+3));return r}}function tf(i){const t=i.length;t>2&&i[t-1].equals(i[0])&&i.pop()}function ef(i,t){for(let e=0;e<t.length;e++)i.push(t[e].x),i.push(t[e].y)}class Ha extends Pn{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};const r=t/2,o=e/2,a=Math.floor(n),l=Math.floor(s),c=a+1,u=l+1,h=t/a,f=e/l,d=[],g=[],v=[],m=[];for(let p=0;p<u;p++){const w=p*f-o;for(let T=0;T<c;T++){const M=T*h-r;g.push(M,-w,0),v.push(0,0,1),m.push(T/a),m.push(1-p/l)}}for(let p=0;p<l;p++)for(let w=0;w<a;w++){const T=w+c*p,M=w+c*(p+1),U=w+1+c*(p+1),D=w+1+c*p;d.push(T,M,D),d.push(M,U,D)}this.setIndex(d),this.setAttribute("position",new Cn(g,3)),this.setAttribute("normal",new Cn(v,3)),this.setAttribute("uv",new Cn(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Ha(t.width,t.height,t.widthSegments,t.heightSegments)}}class Eh extends Pn{constructor(t=new Sp([new Rt(0,.5),new Rt(-.5,-.5),new Rt(.5,-.5)]),e=12){super(),this.type="ShapeGeometry",this.parameters={shapes:t,curveSegments:e};const n=[],s=[],r=[],o=[];let a=0,l=0;if(Array.isArray(t)===!1)c(t);else for(let u=0;u<t.length;u++)c(t[u]),this.addGroup(a,l,u),a+=l,l=0;this.setIndex(n),this.setAttribute("position",new Cn(s,3)),this.setAttribute("normal",new Cn(r,3)),this.setAttribute("uv",new Cn(o,2));function c(u){const h=s.length/3,f=u.extractPoints(e);let d=f.shape;const g=f.holes;ho.isClockWise(d)===!1&&(d=d.reverse());for(let m=0,p=g.length;m<p;m++){const w=g[m];ho.isClockWise(w)===!0&&(g[m]=w.reverse())}const v=ho.triangulateShape(d,g);for(let m=0,p=g.length;m<p;m++){const w=g[m];d=d.concat(w)}for(let m=0,p=d.length;m<p;m++){const w=d[m];s.push(w.x,w.y,0),r.push(0,0,1),o.push(w.x,w.y)}for(let m=0,p=v.length;m<p;m++){const w=v[m],T=w[0]+h,M=w[1]+h,U=w[2]+h;n.push(T,M,U),l+=3}}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){const t=super.toJSON(),e=this.parameters.shapes;return iv(e,t)}static fromJSON(t,e){const n=[];for(let s=0,r=t.shapes.length;s<r;s++){const o=e[t.shapes[s]];n.push(o)}return new Eh(n,t.curveSegments)}}function iv(i,t){if(t.shapes=[],Array.isArray(i))for(let e=0,n=i.length;e<n;e++){const s=i[e];t.shapes.push(s.uuid)}else t.shapes.push(i.uuid);return t}class Pa extends Pn{constructor(t=1,e=.4,n=12,s=48,r=Math.PI*2){super(),this.type="TorusGeometry",this.parameters={radius:t,tube:e,radialSegments:n,tubularSegments:s,arc:r},n=Math.floor(n),s=Math.floor(s);const o=[],a=[],l=[],c=[],u=new z,h=new z,f=new z;for(let d=0;d<=n;d++)for(let g=0;g<=s;g++){const v=g/s*r,m=d/n*Math.PI*2;h.x=(t+e*Math.cos(m))*Math.cos(v),h.y=(t+e*Math.cos(m))*Math.sin(v),h.z=e*Math.sin(m),a.push(h.x,h.y,h.z),u.x=t*Math.cos(v),u.y=t*Math.sin(v),f.subVectors(h,u).normalize(),l.push(f.x,f.y,f.z),c.push(g/s),c.push(d/n)}for(let d=1;d<=n;d++)for(let g=1;g<=s;g++){const v=(s+1)*d+g-1,m=(s+1)*(d-1)+g-1,p=(s+1)*(d-1)+g,w=(s+1)*d+g;o.push(v,m,w),o.push(m,p,w)}this.setIndex(o),this.setAttribute("position",new Cn(a,3)),this.setAttribute("normal",new Cn(l,3)),this.setAttribute("uv",new Cn(c,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new Pa(t.radius,t.tube,t.radialSegments,t.tubularSegments,t.arc)}}class sv extends Nr{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=U_,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}}class rv extends Nr{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}}class Ap extends hp{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){const t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2;let r=n-t,o=n+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){const c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){const e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}}class ov extends Xn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t}}class nf{constructor(t=1,e=0,n=0){this.radius=t,this.phi=e,this.theta=n}set(t,e,n){return this.radius=t,this.phi=e,this.theta=n,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=oe(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,n){return this.radius=Math.sqrt(t*t+e*e+n*n),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,n),this.phi=Math.acos(oe(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}}class av extends zs{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){if(t===void 0){console.warn("THREE.Controls: connect() now requires an element.");return}this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}}function sf(i,t,e,n){const s=lv(n);switch(e){case Jd:return i*t;case tp:return i*t/s.components*s.byteLength;case _h:return i*t/s.components*s.byteLength;case ep:return i*t*2/s.components*s.byteLength;case vh:return i*t*2/s.components*s.byteLength;case Qd:return i*t*3/s.components*s.byteLength;case si:return i*t*4/s.components*s.byteLength;case xh:return i*t*4/s.components*s.byteLength;case ga:case _a:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case va:case xa:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case xc:case Mc:return Math.max(i,16)*Math.max(t,8)/4;case vc:case yc:return Math.max(i,8)*Math.max(t,8)/2;case Sc:case Ec:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case wc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Tc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case bc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Ac:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Rc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case Cc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Pc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case Dc:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Lc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Uc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Ic:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Nc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case Fc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Oc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case kc:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case Bc:case zc:case Hc:return Math.ceil(i/4)*Math.ceil(t/4)*16;case Vc:case Gc:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Wc:case Xc:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function lv(i){switch(i){case Ri:case $d:return{byteLength:1,components:1};case go:case jd:case To:return{byteLength:2,components:1};case mh:case gh:return{byteLength:2,components:4};case Ns:case ph:case zi:return{byteLength:4,components:1};case Kd:case Zd:return{byteLength:4,components:3}}throw new Error(`Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:dh}}));typeof window<"u"&&(window.__THREE__?console.warn("WARNING: Multiple instances of Three.js being imported."):window.__THREE__=dh);/**
 * @license
 * Copyright 2010-2025 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Rp(){let i=null,t=!1,e=null,n=null;function s(r,o){e(r,o),n=i.requestAnimationFrame(s)}return{start:function(){t!==!0&&e!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function cv(i){const t=new WeakMap;function e(a,l){const c=a.array,u=a.usage,h=c.byteLength,f=i.createBuffer();i.bindBuffer(l,f),i.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=i.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=i.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=i.HALF_FLOAT:d=i.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=i.SHORT;else if(c instanceof Uint32Array)d=i.UNSIGNED_INT;else if(c instanceof Int32Array)d=i.INT;else if(c instanceof Int8Array)d=i.BYTE;else if(c instanceof Uint8Array)d=i.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:h}}function n(a,l,c){const u=l.array,h=l.updateRanges;if(i.bindBuffer(c,a),h.length===0)i.bufferSubData(c,0,u);else{h.sort((d,g)=>d.start-g.start);let f=0;for(let d=1;d<h.length;d++){const g=h[f],v=h[d];v.start<=g.start+g.count+1?g.count=Math.max(g.count,v.start+v.count-g.start):(++f,h[f]=v)}h.length=f+1;for(let d=0,g=h.length;d<g;d++){const v=h[d];i.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);const l=t.get(a);l&&(i.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){const u=t.get(a);(!u||u.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}const c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hv=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,uv=`#ifdef USE_ALPHAHASH
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
#endif`,fv=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,dv=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,pv=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,mv=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,gv=`#ifdef USE_AOMAP
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
#endif`,_v=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,vv=`#ifdef USE_BATCHING
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
#endif`,xv=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,yv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Mv=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Sv=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Ev=`#ifdef USE_IRIDESCENCE
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
#endif`,wv=`#ifdef USE_BUMPMAP
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
#endif`,Tv=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,bv=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Av=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Rv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Cv=`#if defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#elif defined( USE_COLOR )
	diffuseColor.rgb *= vColor;
#endif`,Pv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR )
	varying vec3 vColor;
#endif`,Dv=`#if defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#elif defined( USE_COLOR ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec3 vColor;
#endif`,Lv=`#if defined( USE_COLOR_ALPHA )
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
#endif`,Uv=`#define PI 3.141592653589793
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
} // validated`,Iv=`#ifdef ENVMAP_TYPE_CUBE_UV
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
#endif`,Nv=`vec3 transformedNormal = objectNormal;
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
#endif`,Fv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ov=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Bv=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zv="gl_FragColor = linearToOutputTexel( gl_FragColor );",Hv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Vv=`#ifdef USE_ENVMAP
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
#endif`,Gv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform float flipEnvMap;
	uniform mat3 envMapRotation;
	#ifdef ENVMAP_TYPE_CUBE
		uniform samplerCube envMap;
	#else
		uniform sampler2D envMap;
	#endif
	
#endif`,Wv=`#ifdef USE_ENVMAP
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
#endif`,Xv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Yv=`#ifdef USE_ENVMAP
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
#endif`,qv=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,$v=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,jv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Kv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Zv=`#ifdef USE_GRADIENTMAP
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
}`,Jv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Qv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,tx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,ex=`uniform bool receiveShadow;
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
#endif`,nx=`#ifdef USE_ENVMAP
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
#endif`,ix=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,sx=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,rx=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,ox=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,ax=`PhysicalMaterial material;
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
#endif`,lx=`struct PhysicalMaterial {
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
}`,cx=`
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
#endif`,hx=`#if defined( RE_IndirectDiffuse )
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
#endif`,ux=`#if defined( RE_IndirectDiffuse )
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,fx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,dx=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,px=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mx=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,gx=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,_x=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,vx=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,xx=`#if defined( USE_POINTS_UV )
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
#endif`,yx=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Mx=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Sx=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,Ex=`#if defined( USE_MORPHCOLORS )
	vColor *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,wx=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Tx=`#ifdef USE_MORPHTARGETS
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
#endif`,bx=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Ax=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,Rx=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Cx=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Px=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,Dx=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
	#endif
#endif`,Lx=`#ifdef USE_NORMALMAP
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
#endif`,Ux=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,Ix=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Nx=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Fx=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Ox=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,kx=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,Bx=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,zx=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Hx=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Vx=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Gx=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Wx=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Xx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,Yx=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,qx=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,$x=`float getShadowMask() {
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
}`,jx=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Kx=`#ifdef USE_SKINNING
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
#endif`,Zx=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Jx=`#ifdef USE_SKINNING
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
#endif`,Qx=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,ty=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,ey=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,ny=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,iy=`#ifdef USE_TRANSMISSION
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
#endif`,sy=`#ifdef USE_TRANSMISSION
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
#endif`,ry=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oy=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ay=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,ly=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`;const cy=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hy=`uniform sampler2D t2D;
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
}`,uy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fy=`#ifdef ENVMAP_TYPE_CUBE
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
}`,dy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,py=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,my=`#include <common>
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
}`,gy=`#if DEPTH_PACKING == 3200
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
}`,_y=`#define DISTANCE
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
}`,vy=`#define DISTANCE
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
}`,xy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,yy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,My=`uniform float scale;
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
}`,Sy=`uniform vec3 diffuse;
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
}`,Ey=`#include <common>
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
}`,wy=`uniform vec3 diffuse;
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
}`,Ty=`#define LAMBERT
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
}`,by=`#define LAMBERT
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
}`,Ay=`#define MATCAP
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
}`,Ry=`#define MATCAP
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
}`,Cy=`#define NORMAL
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
}`,Py=`#define NORMAL
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
}`,Dy=`#define PHONG
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
}`,Ly=`#define PHONG
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
}`,Uy=`#define STANDARD
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
}`,Iy=`#define STANDARD
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
}`,Ny=`#define TOON
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
}`,Fy=`#define TOON
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
}`,Oy=`uniform float size;
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
}`,ky=`uniform vec3 diffuse;
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
}`,By=`#include <common>
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
}`,zy=`uniform vec3 color;
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
}`,Hy=`uniform float rotation;
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
}`,Vy=`uniform vec3 diffuse;
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
}`,re={alphahash_fragment:hv,alphahash_pars_fragment:uv,alphamap_fragment:fv,alphamap_pars_fragment:dv,alphatest_fragment:pv,alphatest_pars_fragment:mv,aomap_fragment:gv,aomap_pars_fragment:_v,batching_pars_vertex:vv,batching_vertex:xv,begin_vertex:yv,beginnormal_vertex:Mv,bsdfs:Sv,iridescence_fragment:Ev,bumpmap_pars_fragment:wv,clipping_planes_fragment:Tv,clipping_planes_pars_fragment:bv,clipping_planes_pars_vertex:Av,clipping_planes_vertex:Rv,color_fragment:Cv,color_pars_fragment:Pv,color_pars_vertex:Dv,color_vertex:Lv,common:Uv,cube_uv_reflection_fragment:Iv,defaultnormal_vertex:Nv,displacementmap_pars_vertex:Fv,displacementmap_vertex:Ov,emissivemap_fragment:kv,emissivemap_pars_fragment:Bv,colorspace_fragment:zv,colorspace_pars_fragment:Hv,envmap_fragment:Vv,envmap_common_pars_fragment:Gv,envmap_pars_fragment:Wv,envmap_pars_vertex:Xv,envmap_physical_pars_fragment:nx,envmap_vertex:Yv,fog_vertex:qv,fog_pars_vertex:$v,fog_fragment:jv,fog_pars_fragment:Kv,gradientmap_pars_fragment:Zv,lightmap_pars_fragment:Jv,lights_lambert_fragment:Qv,lights_lambert_pars_fragment:tx,lights_pars_begin:ex,lights_toon_fragment:ix,lights_toon_pars_fragment:sx,lights_phong_fragment:rx,lights_phong_pars_fragment:ox,lights_physical_fragment:ax,lights_physical_pars_fragment:lx,lights_fragment_begin:cx,lights_fragment_maps:hx,lights_fragment_end:ux,logdepthbuf_fragment:fx,logdepthbuf_pars_fragment:dx,logdepthbuf_pars_vertex:px,logdepthbuf_vertex:mx,map_fragment:gx,map_pars_fragment:_x,map_particle_fragment:vx,map_particle_pars_fragment:xx,metalnessmap_fragment:yx,metalnessmap_pars_fragment:Mx,morphinstance_vertex:Sx,morphcolor_vertex:Ex,morphnormal_vertex:wx,morphtarget_pars_vertex:Tx,morphtarget_vertex:bx,normal_fragment_begin:Ax,normal_fragment_maps:Rx,normal_pars_fragment:Cx,normal_pars_vertex:Px,normal_vertex:Dx,normalmap_pars_fragment:Lx,clearcoat_normal_fragment_begin:Ux,clearcoat_normal_fragment_maps:Ix,clearcoat_pars_fragment:Nx,iridescence_pars_fragment:Fx,opaque_fragment:Ox,packing:kx,premultiplied_alpha_fragment:Bx,project_vertex:zx,dithering_fragment:Hx,dithering_pars_fragment:Vx,roughnessmap_fragment:Gx,roughnessmap_pars_fragment:Wx,shadowmap_pars_fragment:Xx,shadowmap_pars_vertex:Yx,shadowmap_vertex:qx,shadowmask_pars_fragment:$x,skinbase_vertex:jx,skinning_pars_vertex:Kx,skinning_vertex:Zx,skinnormal_vertex:Jx,specularmap_fragment:Qx,specularmap_pars_fragment:ty,tonemapping_fragment:ey,tonemapping_pars_fragment:ny,transmission_fragment:iy,transmission_pars_fragment:sy,uv_pars_fragment:ry,uv_pars_vertex:oy,uv_vertex:ay,worldpos_vertex:ly,background_vert:cy,background_frag:hy,backgroundCube_vert:uy,backgroundCube_frag:fy,cube_vert:dy,cube_frag:py,depth_vert:my,depth_frag:gy,distanceRGBA_vert:_y,distanceRGBA_frag:vy,equirect_vert:xy,equirect_frag:yy,linedashed_vert:My,linedashed_frag:Sy,meshbasic_vert:Ey,meshbasic_frag:wy,meshlambert_vert:Ty,meshlambert_frag:by,meshmatcap_vert:Ay,meshmatcap_frag:Ry,meshnormal_vert:Cy,meshnormal_frag:Py,meshphong_vert:Dy,meshphong_frag:Ly,meshphysical_vert:Uy,meshphysical_frag:Iy,meshtoon_vert:Ny,meshtoon_frag:Fy,points_vert:Oy,points_frag:ky,shadow_vert:By,shadow_frag:zy,sprite_vert:Hy,sprite_frag:Vy},St={common:{diffuse:{value:new ve(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ie}},envmap:{envMap:{value:null},envMapRotation:{value:new ie},flipEnvMap:{value:-1},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ie}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ie}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ie},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ie},normalScale:{value:new Rt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ie},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ie}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ie}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ie}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ve(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMap:{value:[]},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotShadowMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMap:{value:[]},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null}},points:{diffuse:{value:new ve(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0},uvTransform:{value:new ie}},sprite:{diffuse:{value:new ve(16777215)},opacity:{value:1},center:{value:new Rt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ie},alphaMap:{value:null},alphaMapTransform:{value:new ie},alphaTest:{value:0}}},wi={basic:{uniforms:bn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.fog]),vertexShader:re.meshbasic_vert,fragmentShader:re.meshbasic_frag},lambert:{uniforms:bn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.fog,St.lights,{emissive:{value:new ve(0)}}]),vertexShader:re.meshlambert_vert,fragmentShader:re.meshlambert_frag},phong:{uniforms:bn([St.common,St.specularmap,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.fog,St.lights,{emissive:{value:new ve(0)},specular:{value:new ve(1118481)},shininess:{value:30}}]),vertexShader:re.meshphong_vert,fragmentShader:re.meshphong_frag},standard:{uniforms:bn([St.common,St.envmap,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.roughnessmap,St.metalnessmap,St.fog,St.lights,{emissive:{value:new ve(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag},toon:{uniforms:bn([St.common,St.aomap,St.lightmap,St.emissivemap,St.bumpmap,St.normalmap,St.displacementmap,St.gradientmap,St.fog,St.lights,{emissive:{value:new ve(0)}}]),vertexShader:re.meshtoon_vert,fragmentShader:re.meshtoon_frag},matcap:{uniforms:bn([St.common,St.bumpmap,St.normalmap,St.displacementmap,St.fog,{matcap:{value:null}}]),vertexShader:re.meshmatcap_vert,fragmentShader:re.meshmatcap_frag},points:{uniforms:bn([St.points,St.fog]),vertexShader:re.points_vert,fragmentShader:re.points_frag},dashed:{uniforms:bn([St.common,St.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:re.linedashed_vert,fragmentShader:re.linedashed_frag},depth:{uniforms:bn([St.common,St.displacementmap]),vertexShader:re.depth_vert,fragmentShader:re.depth_frag},normal:{uniforms:bn([St.common,St.bumpmap,St.normalmap,St.displacementmap,{opacity:{value:1}}]),vertexShader:re.meshnormal_vert,fragmentShader:re.meshnormal_frag},sprite:{uniforms:bn([St.sprite,St.fog]),vertexShader:re.sprite_vert,fragmentShader:re.sprite_frag},background:{uniforms:{uvTransform:{value:new ie},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:re.background_vert,fragmentShader:re.background_frag},backgroundCube:{uniforms:{envMap:{value:null},flipEnvMap:{value:-1},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ie}},vertexShader:re.backgroundCube_vert,fragmentShader:re.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:re.cube_vert,fragmentShader:re.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:re.equirect_vert,fragmentShader:re.equirect_frag},distanceRGBA:{uniforms:bn([St.common,St.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:re.distanceRGBA_vert,fragmentShader:re.distanceRGBA_frag},shadow:{uniforms:bn([St.lights,St.fog,{color:{value:new ve(0)},opacity:{value:1}}]),vertexShader:re.shadow_vert,fragmentShader:re.shadow_frag}};wi.physical={uniforms:bn([wi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ie},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ie},clearcoatNormalScale:{value:new Rt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ie},dispersion:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ie},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ie},sheen:{value:0},sheenColor:{value:new ve(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ie},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ie},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ie},transmissionSamplerSize:{value:new Rt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ie},attenuationDistance:{value:0},attenuationColor:{value:new ve(0)},specularColor:{value:new ve(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ie},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ie},anisotropyVector:{value:new Rt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ie}}]),vertexShader:re.meshphysical_vert,fragmentShader:re.meshphysical_frag};const la={r:0,b:0,g:0},ws=new Yi,Gy=new Xe;function Wy(i,t,e,n,s,r,o){const a=new ve(0);let l=r===!0?0:1,c,u,h=null,f=0,d=null;function g(T){let M=T.isScene===!0?T.background:null;return M&&M.isTexture&&(M=(T.backgroundBlurriness>0?e:t).get(M)),M}function v(T){let M=!1;const U=g(T);U===null?p(a,l):U&&U.isColor&&(p(U,1),M=!0);const D=i.xr.getEnvironmentBlendMode();D==="additive"?n.buffers.color.setClear(0,0,0,1,o):D==="alpha-blend"&&n.buffers.color.setClear(0,0,0,0,o),(i.autoClear||M)&&(n.buffers.depth.setTest(!0),n.buffers.depth.setMask(!0),n.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function m(T,M){const U=g(M);U&&(U.isCubeTexture||U.mapping===Ba)?(u===void 0&&(u=new Yn(new Ao(1,1,1),new qi({name:"BackgroundCubeMaterial",uniforms:br(wi.backgroundCube.uniforms),vertexShader:wi.backgroundCube.vertexShader,fragmentShader:wi.backgroundCube.fragmentShader,side:Nn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),u.geometry.deleteAttribute("normal"),u.geometry.deleteAttribute("uv"),u.onBeforeRender=function(D,I,k){this.matrixWorld.copyPosition(k.matrixWorld)},Object.defineProperty(u.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),s.update(u)),ws.copy(M.backgroundRotation),ws.x*=-1,ws.y*=-1,ws.z*=-1,U.isCubeTexture&&U.isRenderTargetTexture===!1&&(ws.y*=-1,ws.z*=-1),u.material.uniforms.envMap.value=U,u.material.uniforms.flipEnvMap.value=U.isCubeTexture&&U.isRenderTargetTexture===!1?-1:1,u.material.uniforms.backgroundBlurriness.value=M.backgroundBlurriness,u.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,u.material.uniforms.backgroundRotation.value.setFromMatrix4(Gy.makeRotationFromEuler(ws)),u.material.toneMapped=ge.getTransfer(U.colorSpace)!==Ae,(h!==U||f!==U.version||d!==i.toneMapping)&&(u.material.needsUpdate=!0,h=U,f=U.version,d=i.toneMapping),u.layers.enableAll(),T.unshift(u,u.geometry,u.material,0,0,null)):U&&U.isTexture&&(c===void 0&&(c=new Yn(new Ha(2,2),new qi({name:"BackgroundMaterial",uniforms:br(wi.background.uniforms),vertexShader:wi.background.vertexShader,fragmentShader:wi.background.fragmentShader,side:fs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),s.update(c)),c.material.uniforms.t2D.value=U,c.material.uniforms.backgroundIntensity.value=M.backgroundIntensity,c.material.toneMapped=ge.getTransfer(U.colorSpace)!==Ae,U.matrixAutoUpdate===!0&&U.updateMatrix(),c.material.uniforms.uvTransform.value.copy(U.matrix),(h!==U||f!==U.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=U,f=U.version,d=i.toneMapping),c.layers.enableAll(),T.unshift(c,c.geometry,c.material,0,0,null))}function p(T,M){T.getRGB(la,cp(i)),n.buffers.color.setClear(la.r,la.g,la.b,M,o)}function w(){u!==void 0&&(u.geometry.dispose(),u.material.dispose(),u=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return a},setClearColor:function(T,M=1){a.set(T),l=M,p(a,l)},getClearAlpha:function(){return l},setClearAlpha:function(T){l=T,p(a,l)},render:v,addToRenderList:m,dispose:w}}function Xy(i,t){const e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=f(null);let r=s,o=!1;function a(E,C,G,H,$){let W=!1;const Z=h(H,G,C);r!==Z&&(r=Z,c(r.object)),W=d(E,H,G,$),W&&g(E,H,G,$),$!==null&&t.update($,i.ELEMENT_ARRAY_BUFFER),(W||o)&&(o=!1,M(E,C,G,H),$!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get($).buffer))}function l(){return i.createVertexArray()}function c(E){return i.bindVertexArray(E)}function u(E){return i.deleteVertexArray(E)}function h(E,C,G){const H=G.wireframe===!0;let $=n[E.id];$===void 0&&($={},n[E.id]=$);let W=$[C.id];W===void 0&&(W={},$[C.id]=W);let Z=W[H];return Z===void 0&&(Z=f(l()),W[H]=Z),Z}function f(E){const C=[],G=[],H=[];for(let $=0;$<e;$++)C[$]=0,G[$]=0,H[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:C,enabledAttributes:G,attributeDivisors:H,object:E,attributes:{},index:null}}function d(E,C,G,H){const $=r.attributes,W=C.attributes;let Z=0;const Y=G.getAttributes();for(const J in Y)if(Y[J].location>=0){const at=$[J];let _t=W[J];if(_t===void 0&&(J==="instanceMatrix"&&E.instanceMatrix&&(_t=E.instanceMatrix),J==="instanceColor"&&E.instanceColor&&(_t=E.instanceColor)),at===void 0||at.attribute!==_t||_t&&at.data!==_t.data)return!0;Z++}return r.attributesNum!==Z||r.index!==H}function g(E,C,G,H){const $={},W=C.attributes;let Z=0;const Y=G.getAttributes();for(const J in Y)if(Y[J].location>=0){let at=W[J];at===void 0&&(J==="instanceMatrix"&&E.instanceMatrix&&(at=E.instanceMatrix),J==="instanceColor"&&E.instanceColor&&(at=E.instanceColor));const _t={};_t.attribute=at,at&&at.data&&(_t.data=at.data),$[J]=_t,Z++}r.attributes=$,r.attributesNum=Z,r.index=H}function v(){const E=r.newAttributes;for(let C=0,G=E.length;C<G;C++)E[C]=0}function m(E){p(E,0)}function p(E,C){const G=r.newAttributes,H=r.enabledAttributes,$=r.attributeDivisors;G[E]=1,H[E]===0&&(i.enableVertexAttribArray(E),H[E]=1),$[E]!==C&&(i.vertexAttribDivisor(E,C),$[E]=C)}function w(){const E=r.newAttributes,C=r.enabledAttributes;for(let G=0,H=C.length;G<H;G++)C[G]!==E[G]&&(i.disableVertexAttribArray(G),C[G]=0)}function T(E,C,G,H,$,W,Z){Z===!0?i.vertexAttribIPointer(E,C,G,$,W):i.vertexAttribPointer(E,C,G,H,$,W)}function M(E,C,G,H){v();const $=H.attributes,W=G.getAttributes(),Z=C.defaultAttributeValues;for(const Y in W){const J=W[Y];if(J.location>=0){let ot=$[Y];if(ot===void 0&&(Y==="instanceMatrix"&&E.instanceMatrix&&(ot=E.instanceMatrix),Y==="instanceColor"&&E.instanceColor&&(ot=E.instanceColor)),ot!==void 0){const at=ot.normalized,_t=ot.itemSize,yt=t.get(ot);if(yt===void 0)continue;const gt=yt.buffer,ee=yt.type,Zt=yt.bytesPerElement,Q=ee===i.INT||ee===i.UNSIGNED_INT||ot.gpuType===ph;if(ot.isInterleavedBufferAttribute){const et=ot.data,Et=et.stride,Bt=ot.offset;if(et.isInstancedInterleavedBuffer){for(let vt=0;vt<J.locationSize;vt++)p(J.location+vt,et.meshPerAttribute);E.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=et.meshPerAttribute*et.count)}else for(let vt=0;vt<J.locationSize;vt++)m(J.location+vt);i.bindBuffer(i.ARRAY_BUFFER,gt);for(let vt=0;vt<J.locationSize;vt++)T(J.location+vt,_t/J.locationSize,ee,at,Et*Zt,(Bt+_t/J.locationSize*vt)*Zt,Q)}else{if(ot.isInstancedBufferAttribute){for(let et=0;et<J.locationSize;et++)p(J.location+et,ot.meshPerAttribute);E.isInstancedMesh!==!0&&H._maxInstanceCount===void 0&&(H._maxInstanceCount=ot.meshPerAttribute*ot.count)}else for(let et=0;et<J.locationSize;et++)m(J.location+et);i.bindBuffer(i.ARRAY_BUFFER,gt);for(let et=0;et<J.locationSize;et++)T(J.location+et,_t/J.locationSize,ee,at,_t*Zt,_t/J.locationSize*et*Zt,Q)}}else if(Z!==void 0){const at=Z[Y];if(at!==void 0)switch(at.length){case 2:i.vertexAttrib2fv(J.location,at);break;case 3:i.vertexAttrib3fv(J.location,at);break;case 4:i.vertexAttrib4fv(J.location,at);break;default:i.vertexAttrib1fv(J.location,at)}}}}w()}function U(){k();for(const E in n){const C=n[E];for(const G in C){const H=C[G];for(const $ in H)u(H[$].object),delete H[$];delete C[G]}delete n[E]}}function D(E){if(n[E.id]===void 0)return;const C=n[E.id];for(const G in C){const H=C[G];for(const $ in H)u(H[$].object),delete H[$];delete C[G]}delete n[E.id]}function I(E){for(const C in n){const G=n[C];if(G[E.id]===void 0)continue;const H=G[E.id];for(const $ in H)u(H[$].object),delete H[$];delete G[E.id]}}function k(){b(),o=!0,r!==s&&(r=s,c(r.object))}function b(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:b,dispose:U,releaseStatesOfGeometry:D,releaseStatesOfProgram:I,initAttributes:v,enableAttribute:m,disableUnusedAttributes:w}}function Yy(i,t,e){let n;function s(c){n=c}function r(c,u){i.drawArrays(n,c,u),e.update(u,n,1)}function o(c,u,h){h!==0&&(i.drawArraysInstanced(n,c,u,h),e.update(u,n,h))}function a(c,u,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,u,0,h);let d=0;for(let g=0;g<h;g++)d+=u[g];e.update(d,n,1)}function l(c,u,h,f){if(h===0)return;const d=t.get("WEBGL_multi_draw");if(d===null)for(let g=0;g<c.length;g++)o(c[g],u[g],f[g]);else{d.multiDrawArraysInstancedWEBGL(n,c,0,u,0,f,0,h);let g=0;for(let v=0;v<h;v++)g+=u[v]*f[v];e.update(g,n,1)}}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a,this.renderMultiDrawInstances=l}function qy(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){const I=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(I.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(I){return!(I!==si&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(I){const k=I===To&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(I!==Ri&&n.convert(I)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE)&&I!==zi&&!k)}function l(I){if(I==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";I="mediump"}return I==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp";const u=l(c);u!==c&&(console.warn("THREE.WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);const h=e.logarithmicDepthBuffer===!0,f=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),g=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),p=i.getParameter(i.MAX_VERTEX_ATTRIBS),w=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),T=i.getParameter(i.MAX_VARYING_VECTORS),M=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),U=g>0,D=i.getParameter(i.MAX_SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:g,maxTextureSize:v,maxCubemapSize:m,maxAttributes:p,maxVertexUniforms:w,maxVaryings:T,maxFragmentUniforms:M,vertexTextures:U,maxSamples:D}}function $y(i){const t=this;let e=null,n=0,s=!1,r=!1;const o=new os,a=new ie,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(h,f){const d=h.length!==0||f||n!==0||s;return s=f,n=h.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(h,f){e=u(h,f,0)},this.setState=function(h,f,d){const g=h.clippingPlanes,v=h.clipIntersection,m=h.clipShadows,p=i.get(h);if(!s||g===null||g.length===0||r&&!m)r?u(null):c();else{const w=r?0:n,T=w*4;let M=p.clippingState||null;l.value=M,M=u(g,f,T,d);for(let U=0;U!==T;++U)M[U]=e[U];p.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=w}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function u(h,f,d,g){const v=h!==null?h.length:0;let m=null;if(v!==0){if(m=l.value,g!==!0||m===null){const p=d+v*4,w=f.matrixWorldInverse;a.getNormalMatrix(w),(m===null||m.length<p)&&(m=new Float32Array(p));for(let T=0,M=d;T!==v;++T,M+=4)o.copy(h[T]).applyMatrix4(w,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=v,t.numIntersection=0,m}}function jy(i){let t=new WeakMap;function e(o,a){return a===mc?o.mapping=Sr:a===gc&&(o.mapping=Er),o}function n(o){if(o&&o.isTexture){const a=o.mapping;if(a===mc||a===gc)if(t.has(o)){const l=t.get(o).texture;return e(l,o.mapping)}else{const l=o.image;if(l&&l.height>0){const c=new g0(l.height);return c.fromEquirectangularTexture(i,o),t.set(o,c),o.addEventListener("dispose",s),e(c.texture,o.mapping)}else return null}}return o}function s(o){const a=o.target;a.removeEventListener("dispose",s);const l=t.get(a);l!==void 0&&(t.delete(a),l.dispose())}function r(){t=new WeakMap}return{get:n,dispose:r}}const pr=4,rf=[.125,.215,.35,.446,.526,.582],Ps=20,zl=new Ap,of=new ve;let Hl=null,Vl=0,Gl=0,Wl=!1;const bs=(1+Math.sqrt(5))/2,hr=1/bs,af=[new z(-bs,hr,0),new z(bs,hr,0),new z(-hr,0,bs),new z(hr,0,bs),new z(0,bs,-hr),new z(0,bs,hr),new z(-1,1,-1),new z(1,1,-1),new z(-1,1,1),new z(1,1,1)],Ky=new z;class lf{constructor(t){this._renderer=t,this._pingPongRenderTarget=null,this._lodMax=0,this._cubeSize=0,this._lodPlanes=[],this._sizeLods=[],this._sigmas=[],this._blurMaterial=null,this._cubemapMaterial=null,this._equirectMaterial=null,this._compileMaterial(this._blurMaterial)}fromScene(t,e=0,n=.1,s=100,r={}){const{size:o=256,position:a=Ky}=r;Hl=this._renderer.getRenderTarget(),Vl=this._renderer.getActiveCubeFace(),Gl=this._renderer.getActiveMipmapLevel(),Wl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1,this._setSize(o);const l=this._allocateTargets();return l.depthBuffer=!0,this._sceneToCubeUV(t,n,s,l,a),e>0&&this._blur(l,0,0,e),this._applyPMREM(l),this._cleanup(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=uf(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=hf(),this._compileMaterial(this._equirectMaterial))}dispose(){this._dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose()}_setSize(t){this._lodMax=Math.floor(Math.log2(t)),this._cubeSize=Math.pow(2,this._lodMax)}_dispose(){this._blurMaterial!==null&&this._blurMaterial.dispose(),this._pingPongRenderTarget!==null&&this._pingPongRenderTarget.dispose();for(let t=0;t<this._lodPlanes.length;t++)this._lodPlanes[t].dispose()}_cleanup(t){this._renderer.setRenderTarget(Hl,Vl,Gl),this._renderer.xr.enabled=Wl,t.scissorTest=!1,ca(t,0,0,t.width,t.height)}_fromTexture(t,e){t.mapping===Sr||t.mapping===Er?this._setSize(t.image.length===0?16:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4),Hl=this._renderer.getRenderTarget(),Vl=this._renderer.getActiveCubeFace(),Gl=this._renderer.getActiveMipmapLevel(),Wl=this._renderer.xr.enabled,this._renderer.xr.enabled=!1;const n=e||this._allocateTargets();return this._textureToCubeUV(t,n),this._applyPMREM(n),this._cleanup(n),n}_allocateTargets(){const t=3*Math.max(this._cubeSize,112),e=4*this._cubeSize,n={magFilter:bi,minFilter:bi,generateMipmaps:!1,type:To,format:si,colorSpace:wr,depthBuffer:!1},s=cf(t,e,n);if(this._pingPongRenderTarget===null||this._pingPongRenderTarget.width!==t||this._pingPongRenderTarget.height!==e){this._pingPongRenderTarget!==null&&this._dispose(),this._pingPongRenderTarget=cf(t,e,n);const{_lodMax:r}=this;({sizeLods:this._sizeLods,lodPlanes:this._lodPlanes,sigmas:this._sigmas}=Zy(r)),this._blurMaterial=Jy(r,t,e)}return s}_compileMaterial(t){const e=new Yn(this._lodPlanes[0],t);this._renderer.compile(e,zl)}_sceneToCubeUV(t,e,n,s,r){const l=new Xn(90,1,e,n),c=[1,-1,1,1,1,1],u=[1,1,1,-1,-1,-1],h=this._renderer,f=h.autoClear,d=h.toneMapping;h.getClearColor(of),h.toneMapping=us,h.autoClear=!1,h.state.buffers.depth.getReversed()&&(h.setRenderTarget(s),h.clearDepth(),h.setRenderTarget(null));const v=new Tr({name:"PMREM.Background",side:Nn,depthWrite:!1,depthTest:!1}),m=new Yn(new Ao,v);let p=!1;const w=t.background;w?w.isColor&&(v.color.copy(w),t.background=null,p=!0):(v.color.copy(of),p=!0);for(let T=0;T<6;T++){const M=T%3;M===0?(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x+u[T],r.y,r.z)):M===1?(l.up.set(0,0,c[T]),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y+u[T],r.z)):(l.up.set(0,c[T],0),l.position.set(r.x,r.y,r.z),l.lookAt(r.x,r.y,r.z+u[T]));const U=this._cubeSize;ca(s,M*U,T>2?U:0,U,U),h.setRenderTarget(s),p&&h.render(m,l),h.render(t,l)}m.geometry.dispose(),m.material.dispose(),h.toneMapping=d,h.autoClear=f,t.background=w}_textureToCubeUV(t,e){const n=this._renderer,s=t.mapping===Sr||t.mapping===Er;s?(this._cubemapMaterial===null&&(this._cubemapMaterial=uf()),this._cubemapMaterial.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):this._equirectMaterial===null&&(this._equirectMaterial=hf());const r=s?this._cubemapMaterial:this._equirectMaterial,o=new Yn(this._lodPlanes[0],r),a=r.uniforms;a.envMap.value=t;const l=this._cubeSize;ca(e,0,0,3*l,2*l),n.setRenderTarget(e),n.render(o,zl)}_applyPMREM(t){const e=this._renderer,n=e.autoClear;e.autoClear=!1;const s=this._lodPlanes.length;for(let r=1;r<s;r++){const o=Math.sqrt(this._sigmas[r]*this._sigmas[r]-this._sigmas[r-1]*this._sigmas[r-1]),a=af[(s-r-1)%af.length];this._blur(t,r-1,r,o,a)}e.autoClear=n}_blur(t,e,n,s,r){const o=this._pingPongRenderTarget;this._halfBlur(t,o,e,n,s,"latitudinal",r),this._halfBlur(o,t,n,n,s,"longitudinal",r)}_halfBlur(t,e,n,s,r,o,a){const l=this._renderer,c=this._blurMaterial;o!=="latitudinal"&&o!=="longitudinal"&&console.error("blur direction must be either latitudinal or longitudinal!");const u=3,h=new Yn(this._lodPlanes[s],c),f=c.uniforms,d=this._sizeLods[n]-1,g=isFinite(r)?Math.PI/(2*d):2*Math.PI/(2*Ps-1),v=r/g,m=isFinite(r)?1+Math.floor(u*v):Ps;m>Ps&&console.warn(`sigmaRadians, ${r}, is too large and will clip, as it requested ${m} samples when the maximum is set to ${Ps}`);const p=[];let w=0;for(let I=0;I<Ps;++I){const k=I/v,b=Math.exp(-k*k/2);p.push(b),I===0?w+=b:I<m&&(w+=2*b)}for(let I=0;I<p.length;I++)p[I]=p[I]/w;f.envMap.value=t.texture,f.samples.value=m,f.weights.value=p,f.latitudinal.value=o==="latitudinal",a&&(f.poleAxis.value=a);const{_lodMax:T}=this;f.dTheta.value=g,f.mipInt.value=T-n;const M=this._sizeLods[s],U=3*M*(s>T-pr?s-T+pr:0),D=4*(this._cubeSize-M);ca(e,U,D,3*M,2*M),l.setRenderTarget(e),l.render(h,zl)}}function Zy(i){const t=[],e=[],n=[];let s=i;const r=i-pr+1+rf.length;for(let o=0;o<r;o++){const a=Math.pow(2,s);e.push(a);let l=1/a;o>i-pr?l=rf[o-i+pr-1]:o===0&&(l=0),n.push(l);const c=1/(a-2),u=-c,h=1+c,f=[u,u,h,u,h,h,u,u,h,h,u,h],d=6,g=6,v=3,m=2,p=1,w=new Float32Array(v*g*d),T=new Float32Array(m*g*d),M=new Float32Array(p*g*d);for(let D=0;D<d;D++){const I=D%3*2/3-1,k=D>2?0:-1,b=[I,k,0,I+2/3,k,0,I+2/3,k+1,0,I,k,0,I+2/3,k+1,0,I,k+1,0];w.set(b,v*g*D),T.set(f,m*g*D);const E=[D,D,D,D,D,D];M.set(E,p*g*D)}const U=new Pn;U.setAttribute("position",new vn(w,v)),U.setAttribute("uv",new vn(T,m)),U.setAttribute("faceIndex",new vn(M,p)),t.push(U),s>pr&&s--}return{lodPlanes:t,sizeLods:e,sigmas:n}}function cf(i,t,e){const n=new Os(i,t,e);return n.texture.mapping=Ba,n.texture.name="PMREM.cubeUv",n.scissorTest=!0,n}function ca(i,t,e,n,s){i.viewport.set(t,e,n,s),i.scissor.set(t,e,n,s)}function Jy(i,t,e){const n=new Float32Array(Ps),s=new z(0,1,0);return new qi({name:"SphericalGaussianBlur",defines:{n:Ps,CUBEUV_TEXEL_WIDTH:1/t,CUBEUV_TEXEL_HEIGHT:1/e,CUBEUV_MAX_MIP:`${i}.0`},uniforms:{envMap:{value:null},samples:{value:1},weights:{value:n},latitudinal:{value:!1},dTheta:{value:0},mipInt:{value:0},poleAxis:{value:s}},vertexShader:wh(),fragmentShader:`

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
		`,blending:Vi,depthTest:!1,depthWrite:!1})}function hf(){return new qi({name:"EquirectangularToCubeUV",uniforms:{envMap:{value:null}},vertexShader:wh(),fragmentShader:`

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
		`,blending:Vi,depthTest:!1,depthWrite:!1})}function uf(){return new qi({name:"CubemapToCubeUV",uniforms:{envMap:{value:null},flipEnvMap:{value:-1}},vertexShader:wh(),fragmentShader:`

			precision mediump float;
			precision mediump int;

			uniform float flipEnvMap;

			varying vec3 vOutputDirection;

			uniform samplerCube envMap;

			void main() {

				gl_FragColor = textureCube( envMap, vec3( flipEnvMap * vOutputDirection.x, vOutputDirection.yz ) );

			}
		`,blending:Vi,depthTest:!1,depthWrite:!1})}function wh(){return`

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
	`}function Qy(i){let t=new WeakMap,e=null;function n(a){if(a&&a.isTexture){const l=a.mapping,c=l===mc||l===gc,u=l===Sr||l===Er;if(c||u){let h=t.get(a);const f=h!==void 0?h.texture.pmremVersion:0;if(a.isRenderTargetTexture&&a.pmremVersion!==f)return e===null&&(e=new lf(i)),h=c?e.fromEquirectangular(a,h):e.fromCubemap(a,h),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),h.texture;if(h!==void 0)return h.texture;{const d=a.image;return c&&d&&d.height>0||u&&d&&s(d)?(e===null&&(e=new lf(i)),h=c?e.fromEquirectangular(a):e.fromCubemap(a),h.texture.pmremVersion=a.pmremVersion,t.set(a,h),a.addEventListener("dispose",r),h.texture):null}}}return a}function s(a){let l=0;const c=6;for(let u=0;u<c;u++)a[u]!==void 0&&l++;return l===c}function r(a){const l=a.target;l.removeEventListener("dispose",r);const c=t.get(l);c!==void 0&&(t.delete(l),c.dispose())}function o(){t=new WeakMap,e!==null&&(e.dispose(),e=null)}return{get:n,dispose:o}}function tM(i){const t={};function e(n){if(t[n]!==void 0)return t[n];let s;switch(n){case"WEBGL_depth_texture":s=i.getExtension("WEBGL_depth_texture")||i.getExtension("MOZ_WEBGL_depth_texture")||i.getExtension("WEBKIT_WEBGL_depth_texture");break;case"EXT_texture_filter_anisotropic":s=i.getExtension("EXT_texture_filter_anisotropic")||i.getExtension("MOZ_EXT_texture_filter_anisotropic")||i.getExtension("WEBKIT_EXT_texture_filter_anisotropic");break;case"WEBGL_compressed_texture_s3tc":s=i.getExtension("WEBGL_compressed_texture_s3tc")||i.getExtension("MOZ_WEBGL_compressed_texture_s3tc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_s3tc");break;case"WEBGL_compressed_texture_pvrtc":s=i.getExtension("WEBGL_compressed_texture_pvrtc")||i.getExtension("WEBKIT_WEBGL_compressed_texture_pvrtc");break;default:s=i.getExtension(n)}return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){const s=e(n);return s===null&&yo("THREE.WebGLRenderer: "+n+" extension not supported."),s}}}function eM(i,t,e,n){const s={},r=new WeakMap;function o(h){const f=h.target;f.index!==null&&t.remove(f.index);for(const g in f.attributes)t.remove(f.attributes[g]);f.removeEventListener("dispose",o),delete s[f.id];const d=r.get(f);d&&(t.remove(d),r.delete(f)),n.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function a(h,f){return s[f.id]===!0||(f.addEventListener("dispose",o),s[f.id]=!0,e.memory.geometries++),f}function l(h){const f=h.attributes;for(const d in f)t.update(f[d],i.ARRAY_BUFFER)}function c(h){const f=[],d=h.index,g=h.attributes.position;let v=0;if(d!==null){const w=d.array;v=d.version;for(let T=0,M=w.length;T<M;T+=3){const U=w[T+0],D=w[T+1],I=w[T+2];f.push(U,D,D,I,I,U)}}else if(g!==void 0){const w=g.array;v=g.version;for(let T=0,M=w.length/3-1;T<M;T+=3){const U=T+0,D=T+1,I=T+2;f.push(U,D,D,I,I,U)}}else return;const m=new(ip(f)?lp:ap)(f,1);m.version=v;const p=r.get(h);p&&t.remove(p),r.set(h,m)}function u(h){const f=r.get(h);if(f){const d=h.index;d!==null&&f.version<d.version&&c(h)}else c(h);return r.get(h)}return{get:a,update:l,getWireframeAttribute:u}}function nM(i,t,e){let n;function s(f){n=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,d){i.drawElements(n,d,r,f*o),e.update(d,n,1)}function c(f,d,g){g!==0&&(i.drawElementsInstanced(n,d,r,f*o,g),e.update(d,n,g))}function u(f,d,g){if(g===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,f,0,g);let m=0;for(let p=0;p<g;p++)m+=d[p];e.update(m,n,1)}function h(f,d,g,v){if(g===0)return;const m=t.get("WEBGL_multi_draw");if(m===null)for(let p=0;p<f.length;p++)c(f[p]/o,d[p],v[p]);else{m.multiDrawElementsInstancedWEBGL(n,d,0,r,f,0,v,0,g);let p=0;for(let w=0;w<g;w++)p+=d[w]*v[w];e.update(p,n,1)}}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u,this.renderMultiDrawInstances=h}function iM(i){const t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:console.error("THREE.WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function sM(i,t,e){const n=new WeakMap,s=new Ye;function r(o,a,l){const c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,h=u!==void 0?u.length:0;let f=n.get(a);if(f===void 0||f.count!==h){let E=function(){k.dispose(),n.delete(a),a.removeEventListener("dispose",E)};var d=E;f!==void 0&&f.texture.dispose();const g=a.morphAttributes.position!==void 0,v=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,p=a.morphAttributes.position||[],w=a.morphAttributes.normal||[],T=a.morphAttributes.color||[];let M=0;g===!0&&(M=1),v===!0&&(M=2),m===!0&&(M=3);let U=a.attributes.position.count*M,D=1;U>t.maxTextureSize&&(D=Math.ceil(U/t.maxTextureSize),U=t.maxTextureSize);const I=new Float32Array(U*D*4*h),k=new sp(I,U,D,h);k.type=zi,k.needsUpdate=!0;const b=M*4;for(let C=0;C<h;C++){const G=p[C],H=w[C],$=T[C],W=U*D*4*C;for(let Z=0;Z<G.count;Z++){const Y=Z*b;g===!0&&(s.fromBufferAttribute(G,Z),I[W+Y+0]=s.x,I[W+Y+1]=s.y,I[W+Y+2]=s.z,I[W+Y+3]=0),v===!0&&(s.fromBufferAttribute(H,Z),I[W+Y+4]=s.x,I[W+Y+5]=s.y,I[W+Y+6]=s.z,I[W+Y+7]=0),m===!0&&(s.fromBufferAttribute($,Z),I[W+Y+8]=s.x,I[W+Y+9]=s.y,I[W+Y+10]=s.z,I[W+Y+11]=$.itemSize===4?s.w:1)}}f={count:h,texture:k,size:new Rt(U,D)},n.set(a,f),a.addEventListener("dispose",E)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let g=0;for(let m=0;m<c.length;m++)g+=c[m];const v=a.morphTargetsRelative?1:1-g;l.getUniforms().setValue(i,"morphTargetBaseInfluence",v),l.getUniforms().setValue(i,"morphTargetInfluences",c)}l.getUniforms().setValue(i,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(i,"morphTargetsTextureSize",f.size)}return{update:r}}function rM(i,t,e,n){let s=new WeakMap;function r(l){const c=n.render.frame,u=l.geometry,h=t.get(l,u);if(s.get(h)!==c&&(t.update(h),s.set(h,c)),l.isInstancedMesh&&(l.hasEventListener("dispose",a)===!1&&l.addEventListener("dispose",a),s.get(l)!==c&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),s.set(l,c))),l.isSkinnedMesh){const f=l.skeleton;s.get(f)!==c&&(f.update(),s.set(f,c))}return h}function o(){s=new WeakMap}function a(l){const c=l.target;c.removeEventListener("dispose",a),e.remove(c.instanceMatrix),c.instanceColor!==null&&e.remove(c.instanceColor)}return{update:r,dispose:o}}const Cp=new xn,ff=new gp(1,1),Pp=new sp,Dp=new Q_,Lp=new up,df=[],pf=[],mf=new Float32Array(16),gf=new Float32Array(9),_f=new Float32Array(4);function Fr(i,t,e){const n=i[0];if(n<=0||n>0)return i;const s=t*e;let r=df[s];if(r===void 0&&(r=new Float32Array(s),df[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function en(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function nn(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function Va(i,t){let e=pf[t];e===void 0&&(e=new Int32Array(t),pf[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function oM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function aM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2fv(this.addr,t),nn(e,t)}}function lM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(en(e,t))return;i.uniform3fv(this.addr,t),nn(e,t)}}function cM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4fv(this.addr,t),nn(e,t)}}function hM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;_f.set(n),i.uniformMatrix2fv(this.addr,!1,_f),nn(e,n)}}function uM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;gf.set(n),i.uniformMatrix3fv(this.addr,!1,gf),nn(e,n)}}function fM(i,t){const e=this.cache,n=t.elements;if(n===void 0){if(en(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),nn(e,t)}else{if(en(e,n))return;mf.set(n),i.uniformMatrix4fv(this.addr,!1,mf),nn(e,n)}}function dM(i,t){const e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function pM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2iv(this.addr,t),nn(e,t)}}function mM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3iv(this.addr,t),nn(e,t)}}function gM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4iv(this.addr,t),nn(e,t)}}function _M(i,t){const e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function vM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(en(e,t))return;i.uniform2uiv(this.addr,t),nn(e,t)}}function xM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(en(e,t))return;i.uniform3uiv(this.addr,t),nn(e,t)}}function yM(i,t){const e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(en(e,t))return;i.uniform4uiv(this.addr,t),nn(e,t)}}function MM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?(ff.compareFunction=np,r=ff):r=Cp,e.setTexture2D(t||r,s)}function SM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Dp,s)}function EM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTextureCube(t||Lp,s)}function wM(i,t,e){const n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Pp,s)}function TM(i){switch(i){case 5126:return oM;case 35664:return aM;case 35665:return lM;case 35666:return cM;case 35674:return hM;case 35675:return uM;case 35676:return fM;case 5124:case 35670:return dM;case 35667:case 35671:return pM;case 35668:case 35672:return mM;case 35669:case 35673:return gM;case 5125:return _M;case 36294:return vM;case 36295:return xM;case 36296:return yM;case 35678:case 36198:case 36298:case 36306:case 35682:return MM;case 35679:case 36299:case 36307:return SM;case 35680:case 36300:case 36308:case 36293:return EM;case 36289:case 36303:case 36311:case 36292:return wM}}function bM(i,t){i.uniform1fv(this.addr,t)}function AM(i,t){const e=Fr(t,this.size,2);i.uniform2fv(this.addr,e)}function RM(i,t){const e=Fr(t,this.size,3);i.uniform3fv(this.addr,e)}function CM(i,t){const e=Fr(t,this.size,4);i.uniform4fv(this.addr,e)}function PM(i,t){const e=Fr(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function DM(i,t){const e=Fr(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function LM(i,t){const e=Fr(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function UM(i,t){i.uniform1iv(this.addr,t)}function IM(i,t){i.uniform2iv(this.addr,t)}function NM(i,t){i.uniform3iv(this.addr,t)}function FM(i,t){i.uniform4iv(this.addr,t)}function OM(i,t){i.uniform1uiv(this.addr,t)}function kM(i,t){i.uniform2uiv(this.addr,t)}function BM(i,t){i.uniform3uiv(this.addr,t)}function zM(i,t){i.uniform4uiv(this.addr,t)}function HM(i,t,e){const n=this.cache,s=t.length,r=Va(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture2D(t[o]||Cp,r[o])}function VM(i,t,e){const n=this.cache,s=t.length,r=Va(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Dp,r[o])}function GM(i,t,e){const n=this.cache,s=t.length,r=Va(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTextureCube(t[o]||Lp,r[o])}function WM(i,t,e){const n=this.cache,s=t.length,r=Va(e,s);en(n,r)||(i.uniform1iv(this.addr,r),nn(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Pp,r[o])}function XM(i){switch(i){case 5126:return bM;case 35664:return AM;case 35665:return RM;case 35666:return CM;case 35674:return PM;case 35675:return DM;case 35676:return LM;case 5124:case 35670:return UM;case 35667:case 35671:return IM;case 35668:case 35672:return NM;case 35669:case 35673:return FM;case 5125:return OM;case 36294:return kM;case 36295:return BM;case 36296:return zM;case 35678:case 36198:case 36298:case 36306:case 35682:return HM;case 35679:case 36299:case 36307:return VM;case 35680:case 36300:case 36308:case 36293:return GM;case 36289:case 36303:case 36311:case 36292:return WM}}class YM{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=TM(e.type)}}class qM{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=XM(e.type)}}class $M{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){const s=this.seq;for(let r=0,o=s.length;r!==o;++r){const a=s[r];a.setValue(t,e[a.id],n)}}}const Xl=/(\w+)(\])?(\[|\.)?/g;function vf(i,t){i.seq.push(t),i.map[t.id]=t}function jM(i,t,e){const n=i.name,s=n.length;for(Xl.lastIndex=0;;){const r=Xl.exec(n),o=Xl.lastIndex;let a=r[1];const l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){vf(e,c===void 0?new YM(a,i,t):new qM(a,i,t));break}else{let h=e.map[a];h===void 0&&(h=new $M(a),vf(e,h)),e=h}}}class Ma{constructor(t,e){this.seq=[],this.map={};const n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let s=0;s<n;++s){const r=t.getActiveUniform(e,s),o=t.getUniformLocation(e,r.name);jM(r,o,this)}}setValue(t,e,n,s){const r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){const s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){const a=e[r],l=n[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){const n=[];for(let s=0,r=t.length;s!==r;++s){const o=t[s];o.id in e&&n.push(o)}return n}}function xf(i,t,e){const n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}const KM=37297;let ZM=0;function JM(i,t){const e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){const a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}const yf=new ie;function QM(i){ge._getMatrix(yf,ge.workingColorSpace,i);const t=`mat3( ${yf.elements.map(e=>e.toFixed(4))} )`;switch(ge.getTransfer(i)){case Ta:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return console.warn("THREE.WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function Mf(i,t,e){const n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";const o=/ERROR: 0:(\d+)/.exec(r);if(o){const a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+JM(i.getShaderSource(t),a)}else return r}function tS(i,t){const e=QM(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( value.rgb * ${e[0]}, value.a ) );`,"}"].join(`
`)}function eS(i,t){let e;switch(t){case T_:e="Linear";break;case b_:e="Reinhard";break;case A_:e="Cineon";break;case R_:e="ACESFilmic";break;case P_:e="AgX";break;case D_:e="Neutral";break;case C_:e="Custom";break;default:console.warn("THREE.WebGLProgram: Unsupported toneMapping:",t),e="Linear"}return"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}const ha=new z;function nS(){ge.getLuminanceCoefficients(ha);const i=ha.x.toFixed(4),t=ha.y.toFixed(4),e=ha.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function iS(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(io).join(`
`)}function sS(i){const t=[];for(const e in i){const n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function rS(i,t){const e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){const r=i.getActiveAttrib(t,s),o=r.name;let a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function io(i){return i!==""}function Sf(i,t){const e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows)}function Ef(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}const oS=/^[ \t]*#include +<([\w\d./]+)>/gm;function Kc(i){return i.replace(oS,lS)}const aS=new Map;function lS(i,t){let e=re[t];if(e===void 0){const n=aS.get(t);if(n!==void 0)e=re[n],console.warn('THREE.WebGLRenderer: Shader chunk "%s" has been deprecated. Use "%s" instead.',t,n);else throw new Error("Can not resolve #include <"+t+">")}return Kc(e)}const cS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function wf(i){return i.replace(cS,hS)}function hS(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Tf(i){let t=`precision ${i.precision} float;
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
#define LOW_PRECISION`),t}function uS(i){let t="SHADOWMAP_TYPE_BASIC";return i.shadowMapType===Xd?t="SHADOWMAP_TYPE_PCF":i.shadowMapType===s_?t="SHADOWMAP_TYPE_PCF_SOFT":i.shadowMapType===ki&&(t="SHADOWMAP_TYPE_VSM"),t}function fS(i){let t="ENVMAP_TYPE_CUBE";if(i.envMap)switch(i.envMapMode){case Sr:case Er:t="ENVMAP_TYPE_CUBE";break;case Ba:t="ENVMAP_TYPE_CUBE_UV";break}return t}function dS(i){let t="ENVMAP_MODE_REFLECTION";if(i.envMap)switch(i.envMapMode){case Er:t="ENVMAP_MODE_REFRACTION";break}return t}function pS(i){let t="ENVMAP_BLENDING_NONE";if(i.envMap)switch(i.combine){case Yd:t="ENVMAP_BLENDING_MULTIPLY";break;case E_:t="ENVMAP_BLENDING_MIX";break;case w_:t="ENVMAP_BLENDING_ADD";break}return t}function mS(i){const t=i.envMapCubeUVHeight;if(t===null)return null;const e=Math.log2(t)-2,n=1/t;return{texelWidth:1/(3*Math.max(Math.pow(2,e),112)),texelHeight:n,maxMip:e}}function gS(i,t,e,n){const s=i.getContext(),r=e.defines;let o=e.vertexShader,a=e.fragmentShader;const l=uS(e),c=fS(e),u=dS(e),h=pS(e),f=mS(e),d=iS(e),g=sS(r),v=s.createProgram();let m,p,w=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(io).join(`
`),m.length>0&&(m+=`
`),p=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g].filter(io).join(`
`),p.length>0&&(p+=`
`)):(m=[Tf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+u:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(io).join(`
`),p=[Tf(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,g,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+u:"",e.envMap?"#define "+h:"",f?"#define CUBEUV_TEXEL_WIDTH "+f.texelWidth:"",f?"#define CUBEUV_TEXEL_HEIGHT "+f.texelHeight:"",f?"#define CUBEUV_MAX_MIP "+f.maxMip+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor||e.batchingColor?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==us?"#define TONE_MAPPING":"",e.toneMapping!==us?re.tonemapping_pars_fragment:"",e.toneMapping!==us?eS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",re.colorspace_pars_fragment,tS("linearToOutputTexel",e.outputColorSpace),nS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(io).join(`
`)),o=Kc(o),o=Sf(o,e),o=Ef(o,e),a=Kc(a),a=Sf(a,e),a=Ef(a,e),o=wf(o),a=wf(a),e.isRawShaderMaterial!==!0&&(w=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,p=["#define varying in",e.glslVersion===bu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===bu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+p);const T=w+m+o,M=w+p+a,U=xf(s,s.VERTEX_SHADER,T),D=xf(s,s.FRAGMENT_SHADER,M);s.attachShader(v,U),s.attachShader(v,D),e.index0AttributeName!==void 0?s.bindAttribLocation(v,0,e.index0AttributeName):e.morphTargets===!0&&s.bindAttribLocation(v,0,"position"),s.linkProgram(v);function I(C){if(i.debug.checkShaderErrors){const G=s.getProgramInfoLog(v)||"",H=s.getShaderInfoLog(U)||"",$=s.getShaderInfoLog(D)||"",W=G.trim(),Z=H.trim(),Y=$.trim();let J=!0,ot=!0;if(s.getProgramParameter(v,s.LINK_STATUS)===!1)if(J=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,v,U,D);else{const at=Mf(s,U,"vertex"),_t=Mf(s,D,"fragment");console.error("THREE.WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(v,s.VALIDATE_STATUS)+`

Material Name: `+C.name+`
Material Type: `+C.type+`

Program Info Log: `+W+`
`+at+`
`+_t)}else W!==""?console.warn("THREE.WebGLProgram: Program Info Log:",W):(Z===""||Y==="")&&(ot=!1);ot&&(C.diagnostics={runnable:J,programLog:W,vertexShader:{log:Z,prefix:m},fragmentShader:{log:Y,prefix:p}})}s.deleteShader(U),s.deleteShader(D),k=new Ma(s,v),b=rS(s,v)}let k;this.getUniforms=function(){return k===void 0&&I(this),k};let b;this.getAttributes=function(){return b===void 0&&I(this),b};let E=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return E===!1&&(E=s.getProgramParameter(v,KM)),E},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(v),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=ZM++,this.cacheKey=t,this.usedTimes=1,this.program=v,this.vertexShader=U,this.fragmentShader=D,this}let _S=0;class vS{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t){const e=t.vertexShader,n=t.fragmentShader,s=this._getShaderStage(e),r=this._getShaderStage(n),o=this._getShaderCacheForMaterial(t);return o.has(s)===!1&&(o.add(s),s.usedTimes++),o.has(r)===!1&&(o.add(r),r.usedTimes++),this}remove(t){const e=this.materialCache.get(t);for(const n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderID(t){return this._getShaderStage(t.vertexShader).id}getFragmentShaderID(t){return this._getShaderStage(t.fragmentShader).id}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){const e=this.materialCache;let n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){const e=this.shaderCache;let n=e.get(t);return n===void 0&&(n=new xS(t),e.set(t,n)),n}}class xS{constructor(t){this.id=_S++,this.code=t,this.usedTimes=0}}function yS(i,t,e,n,s,r,o){const a=new rp,l=new vS,c=new Set,u=[],h=s.logarithmicDepthBuffer,f=s.vertexTextures;let d=s.precision;const g={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distanceRGBA",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function v(b){return c.add(b),b===0?"uv":`uv${b}`}function m(b,E,C,G,H){const $=G.fog,W=H.geometry,Z=b.isMeshStandardMaterial?G.environment:null,Y=(b.isMeshStandardMaterial?e:t).get(b.envMap||Z),J=Y&&Y.mapping===Ba?Y.image.height:null,ot=g[b.type];b.precision!==null&&(d=s.getMaxPrecision(b.precision),d!==b.precision&&console.warn("THREE.WebGLProgram.getParameters:",b.precision,"not supported, using",d,"instead."));const at=W.morphAttributes.position||W.morphAttributes.normal||W.morphAttributes.color,_t=at!==void 0?at.length:0;let yt=0;W.morphAttributes.position!==void 0&&(yt=1),W.morphAttributes.normal!==void 0&&(yt=2),W.morphAttributes.color!==void 0&&(yt=3);let gt,ee,Zt,Q;if(ot){const de=wi[ot];gt=de.vertexShader,ee=de.fragmentShader}else gt=b.vertexShader,ee=b.fragmentShader,l.update(b),Zt=l.getVertexShaderID(b),Q=l.getFragmentShaderID(b);const et=i.getRenderTarget(),Et=i.state.buffers.depth.getReversed(),Bt=H.isInstancedMesh===!0,vt=H.isBatchedMesh===!0,Jt=!!b.map,Le=!!b.matcap,L=!!Y,fe=!!b.aoMap,$t=!!b.lightMap,Wt=!!b.bumpMap,It=!!b.normalMap,Ee=!!b.displacementMap,Ct=!!b.emissiveMap,Vt=!!b.metalnessMap,Fe=!!b.roughnessMap,xe=b.anisotropy>0,R=b.clearcoat>0,x=b.dispersion>0,N=b.iridescence>0,j=b.sheen>0,nt=b.transmission>0,tt=xe&&!!b.anisotropyMap,Nt=R&&!!b.clearcoatMap,ht=R&&!!b.clearcoatNormalMap,Dt=R&&!!b.clearcoatRoughnessMap,bt=N&&!!b.iridescenceMap,rt=N&&!!b.iridescenceThicknessMap,mt=j&&!!b.sheenColorMap,kt=j&&!!b.sheenRoughnessMap,Ot=!!b.specularMap,xt=!!b.specularColorMap,Kt=!!b.specularIntensityMap,F=nt&&!!b.transmissionMap,ut=nt&&!!b.thicknessMap,dt=!!b.gradientMap,Pt=!!b.alphaMap,ct=b.alphaTest>0,st=!!b.alphaHash,Ft=!!b.extensions;let Qt=us;b.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(Qt=i.toneMapping);const Te={shaderID:ot,shaderType:b.type,shaderName:b.name,vertexShader:gt,fragmentShader:ee,defines:b.defines,customVertexShaderID:Zt,customFragmentShaderID:Q,isRawShaderMaterial:b.isRawShaderMaterial===!0,glslVersion:b.glslVersion,precision:d,batching:vt,batchingColor:vt&&H._colorsTexture!==null,instancing:Bt,instancingColor:Bt&&H.instanceColor!==null,instancingMorph:Bt&&H.morphTexture!==null,supportsVertexTextures:f,outputColorSpace:et===null?i.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:wr,alphaToCoverage:!!b.alphaToCoverage,map:Jt,matcap:Le,envMap:L,envMapMode:L&&Y.mapping,envMapCubeUVHeight:J,aoMap:fe,lightMap:$t,bumpMap:Wt,normalMap:It,displacementMap:f&&Ee,emissiveMap:Ct,normalMapObjectSpace:It&&b.normalMapType===F_,normalMapTangentSpace:It&&b.normalMapType===N_,metalnessMap:Vt,roughnessMap:Fe,anisotropy:xe,anisotropyMap:tt,clearcoat:R,clearcoatMap:Nt,clearcoatNormalMap:ht,clearcoatRoughnessMap:Dt,dispersion:x,iridescence:N,iridescenceMap:bt,iridescenceThicknessMap:rt,sheen:j,sheenColorMap:mt,sheenRoughnessMap:kt,specularMap:Ot,specularColorMap:xt,specularIntensityMap:Kt,transmission:nt,transmissionMap:F,thicknessMap:ut,gradientMap:dt,opaque:b.transparent===!1&&b.blending===_r&&b.alphaToCoverage===!1,alphaMap:Pt,alphaTest:ct,alphaHash:st,combine:b.combine,mapUv:Jt&&v(b.map.channel),aoMapUv:fe&&v(b.aoMap.channel),lightMapUv:$t&&v(b.lightMap.channel),bumpMapUv:Wt&&v(b.bumpMap.channel),normalMapUv:It&&v(b.normalMap.channel),displacementMapUv:Ee&&v(b.displacementMap.channel),emissiveMapUv:Ct&&v(b.emissiveMap.channel),metalnessMapUv:Vt&&v(b.metalnessMap.channel),roughnessMapUv:Fe&&v(b.roughnessMap.channel),anisotropyMapUv:tt&&v(b.anisotropyMap.channel),clearcoatMapUv:Nt&&v(b.clearcoatMap.channel),clearcoatNormalMapUv:ht&&v(b.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:Dt&&v(b.clearcoatRoughnessMap.channel),iridescenceMapUv:bt&&v(b.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&v(b.iridescenceThicknessMap.channel),sheenColorMapUv:mt&&v(b.sheenColorMap.channel),sheenRoughnessMapUv:kt&&v(b.sheenRoughnessMap.channel),specularMapUv:Ot&&v(b.specularMap.channel),specularColorMapUv:xt&&v(b.specularColorMap.channel),specularIntensityMapUv:Kt&&v(b.specularIntensityMap.channel),transmissionMapUv:F&&v(b.transmissionMap.channel),thicknessMapUv:ut&&v(b.thicknessMap.channel),alphaMapUv:Pt&&v(b.alphaMap.channel),vertexTangents:!!W.attributes.tangent&&(It||xe),vertexColors:b.vertexColors,vertexAlphas:b.vertexColors===!0&&!!W.attributes.color&&W.attributes.color.itemSize===4,pointsUvs:H.isPoints===!0&&!!W.attributes.uv&&(Jt||Pt),fog:!!$,useFog:b.fog===!0,fogExp2:!!$&&$.isFogExp2,flatShading:b.flatShading===!0&&b.wireframe===!1,sizeAttenuation:b.sizeAttenuation===!0,logarithmicDepthBuffer:h,reversedDepthBuffer:Et,skinning:H.isSkinnedMesh===!0,morphTargets:W.morphAttributes.position!==void 0,morphNormals:W.morphAttributes.normal!==void 0,morphColors:W.morphAttributes.color!==void 0,morphTargetsCount:_t,morphTextureStride:yt,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numClippingPlanes:o.numPlanes,numClipIntersection:o.numIntersection,dithering:b.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:Qt,decodeVideoTexture:Jt&&b.map.isVideoTexture===!0&&ge.getTransfer(b.map.colorSpace)===Ae,decodeVideoTextureEmissive:Ct&&b.emissiveMap.isVideoTexture===!0&&ge.getTransfer(b.emissiveMap.colorSpace)===Ae,premultipliedAlpha:b.premultipliedAlpha,doubleSided:b.side===Ti,flipSided:b.side===Nn,useDepthPacking:b.depthPacking>=0,depthPacking:b.depthPacking||0,index0AttributeName:b.index0AttributeName,extensionClipCullDistance:Ft&&b.extensions.clipCullDistance===!0&&n.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ft&&b.extensions.multiDraw===!0||vt)&&n.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:n.has("KHR_parallel_shader_compile"),customProgramCacheKey:b.customProgramCacheKey()};return Te.vertexUv1s=c.has(1),Te.vertexUv2s=c.has(2),Te.vertexUv3s=c.has(3),c.clear(),Te}function p(b){const E=[];if(b.shaderID?E.push(b.shaderID):(E.push(b.customVertexShaderID),E.push(b.customFragmentShaderID)),b.defines!==void 0)for(const C in b.defines)E.push(C),E.push(b.defines[C]);return b.isRawShaderMaterial===!1&&(w(E,b),T(E,b),E.push(i.outputColorSpace)),E.push(b.customProgramCacheKey),E.join()}function w(b,E){b.push(E.precision),b.push(E.outputColorSpace),b.push(E.envMapMode),b.push(E.envMapCubeUVHeight),b.push(E.mapUv),b.push(E.alphaMapUv),b.push(E.lightMapUv),b.push(E.aoMapUv),b.push(E.bumpMapUv),b.push(E.normalMapUv),b.push(E.displacementMapUv),b.push(E.emissiveMapUv),b.push(E.metalnessMapUv),b.push(E.roughnessMapUv),b.push(E.anisotropyMapUv),b.push(E.clearcoatMapUv),b.push(E.clearcoatNormalMapUv),b.push(E.clearcoatRoughnessMapUv),b.push(E.iridescenceMapUv),b.push(E.iridescenceThicknessMapUv),b.push(E.sheenColorMapUv),b.push(E.sheenRoughnessMapUv),b.push(E.specularMapUv),b.push(E.specularColorMapUv),b.push(E.specularIntensityMapUv),b.push(E.transmissionMapUv),b.push(E.thicknessMapUv),b.push(E.combine),b.push(E.fogExp2),b.push(E.sizeAttenuation),b.push(E.morphTargetsCount),b.push(E.morphAttributeCount),b.push(E.numDirLights),b.push(E.numPointLights),b.push(E.numSpotLights),b.push(E.numSpotLightMaps),b.push(E.numHemiLights),b.push(E.numRectAreaLights),b.push(E.numDirLightShadows),b.push(E.numPointLightShadows),b.push(E.numSpotLightShadows),b.push(E.numSpotLightShadowsWithMaps),b.push(E.numLightProbes),b.push(E.shadowMapType),b.push(E.toneMapping),b.push(E.numClippingPlanes),b.push(E.numClipIntersection),b.push(E.depthPacking)}function T(b,E){a.disableAll(),E.supportsVertexTextures&&a.enable(0),E.instancing&&a.enable(1),E.instancingColor&&a.enable(2),E.instancingMorph&&a.enable(3),E.matcap&&a.enable(4),E.envMap&&a.enable(5),E.normalMapObjectSpace&&a.enable(6),E.normalMapTangentSpace&&a.enable(7),E.clearcoat&&a.enable(8),E.iridescence&&a.enable(9),E.alphaTest&&a.enable(10),E.vertexColors&&a.enable(11),E.vertexAlphas&&a.enable(12),E.vertexUv1s&&a.enable(13),E.vertexUv2s&&a.enable(14),E.vertexUv3s&&a.enable(15),E.vertexTangents&&a.enable(16),E.anisotropy&&a.enable(17),E.alphaHash&&a.enable(18),E.batching&&a.enable(19),E.dispersion&&a.enable(20),E.batchingColor&&a.enable(21),E.gradientMap&&a.enable(22),b.push(a.mask),a.disableAll(),E.fog&&a.enable(0),E.useFog&&a.enable(1),E.flatShading&&a.enable(2),E.logarithmicDepthBuffer&&a.enable(3),E.reversedDepthBuffer&&a.enable(4),E.skinning&&a.enable(5),E.morphTargets&&a.enable(6),E.morphNormals&&a.enable(7),E.morphColors&&a.enable(8),E.premultipliedAlpha&&a.enable(9),E.shadowMapEnabled&&a.enable(10),E.doubleSided&&a.enable(11),E.flipSided&&a.enable(12),E.useDepthPacking&&a.enable(13),E.dithering&&a.enable(14),E.transmission&&a.enable(15),E.sheen&&a.enable(16),E.opaque&&a.enable(17),E.pointsUvs&&a.enable(18),E.decodeVideoTexture&&a.enable(19),E.decodeVideoTextureEmissive&&a.enable(20),E.alphaToCoverage&&a.enable(21),b.push(a.mask)}function M(b){const E=g[b.type];let C;if(E){const G=wi[E];C=f0.clone(G.uniforms)}else C=b.uniforms;return C}function U(b,E){let C;for(let G=0,H=u.length;G<H;G++){const $=u[G];if($.cacheKey===E){C=$,++C.usedTimes;break}}return C===void 0&&(C=new gS(i,E,b,r),u.push(C)),C}function D(b){if(--b.usedTimes===0){const E=u.indexOf(b);u[E]=u[u.length-1],u.pop(),b.destroy()}}function I(b){l.remove(b)}function k(){l.dispose()}return{getParameters:m,getProgramCacheKey:p,getUniforms:M,acquireProgram:U,releaseProgram:D,releaseShaderCache:I,programs:u,dispose:k}}function MS(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,l){i.get(o)[a]=l}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function SS(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.z!==t.z?i.z-t.z:i.id-t.id}function bf(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function Af(){const i=[];let t=0;const e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(h,f,d,g,v,m){let p=i[t];return p===void 0?(p={id:h.id,object:h,geometry:f,material:d,groupOrder:g,renderOrder:h.renderOrder,z:v,group:m},i[t]=p):(p.id=h.id,p.object=h,p.geometry=f,p.material=d,p.groupOrder=g,p.renderOrder=h.renderOrder,p.z=v,p.group=m),t++,p}function a(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?n.push(p):d.transparent===!0?s.push(p):e.push(p)}function l(h,f,d,g,v,m){const p=o(h,f,d,g,v,m);d.transmission>0?n.unshift(p):d.transparent===!0?s.unshift(p):e.unshift(p)}function c(h,f){e.length>1&&e.sort(h||SS),n.length>1&&n.sort(f||bf),s.length>1&&s.sort(f||bf)}function u(){for(let h=t,f=i.length;h<f;h++){const d=i[h];if(d.id===null)break;d.id=null,d.object=null,d.geometry=null,d.material=null,d.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:a,unshift:l,finish:u,sort:c}}function ES(){let i=new WeakMap;function t(n,s){const r=i.get(n);let o;return r===void 0?(o=new Af,i.set(n,[o])):s>=r.length?(o=new Af,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function wS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={direction:new z,color:new ve};break;case"SpotLight":e={position:new z,direction:new z,color:new ve,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new z,color:new ve,distance:0,decay:0};break;case"HemisphereLight":e={direction:new z,skyColor:new ve,groundColor:new ve};break;case"RectAreaLight":e={color:new ve,position:new z,halfWidth:new z,halfHeight:new z};break}return i[t.id]=e,e}}}function TS(){const i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Rt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}let bS=0;function AS(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function RS(i){const t=new wS,e=TS(),n={version:0,hash:{directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)n.probe.push(new z);const s=new z,r=new Xe,o=new Xe;function a(c){let u=0,h=0,f=0;for(let b=0;b<9;b++)n.probe[b].set(0,0,0);let d=0,g=0,v=0,m=0,p=0,w=0,T=0,M=0,U=0,D=0,I=0;c.sort(AS);for(let b=0,E=c.length;b<E;b++){const C=c[b],G=C.color,H=C.intensity,$=C.distance,W=C.shadow&&C.shadow.map?C.shadow.map.texture:null;if(C.isAmbientLight)u+=G.r*H,h+=G.g*H,f+=G.b*H;else if(C.isLightProbe){for(let Z=0;Z<9;Z++)n.probe[Z].addScaledVector(C.sh.coefficients[Z],H);I++}else if(C.isDirectionalLight){const Z=t.get(C);if(Z.color.copy(C.color).multiplyScalar(C.intensity),C.castShadow){const Y=C.shadow,J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,n.directionalShadow[d]=J,n.directionalShadowMap[d]=W,n.directionalShadowMatrix[d]=C.shadow.matrix,w++}n.directional[d]=Z,d++}else if(C.isSpotLight){const Z=t.get(C);Z.position.setFromMatrixPosition(C.matrixWorld),Z.color.copy(G).multiplyScalar(H),Z.distance=$,Z.coneCos=Math.cos(C.angle),Z.penumbraCos=Math.cos(C.angle*(1-C.penumbra)),Z.decay=C.decay,n.spot[v]=Z;const Y=C.shadow;if(C.map&&(n.spotLightMap[U]=C.map,U++,Y.updateMatrices(C),C.castShadow&&D++),n.spotLightMatrix[v]=Y.matrix,C.castShadow){const J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,n.spotShadow[v]=J,n.spotShadowMap[v]=W,M++}v++}else if(C.isRectAreaLight){const Z=t.get(C);Z.color.copy(G).multiplyScalar(H),Z.halfWidth.set(C.width*.5,0,0),Z.halfHeight.set(0,C.height*.5,0),n.rectArea[m]=Z,m++}else if(C.isPointLight){const Z=t.get(C);if(Z.color.copy(C.color).multiplyScalar(C.intensity),Z.distance=C.distance,Z.decay=C.decay,C.castShadow){const Y=C.shadow,J=e.get(C);J.shadowIntensity=Y.intensity,J.shadowBias=Y.bias,J.shadowNormalBias=Y.normalBias,J.shadowRadius=Y.radius,J.shadowMapSize=Y.mapSize,J.shadowCameraNear=Y.camera.near,J.shadowCameraFar=Y.camera.far,n.pointShadow[g]=J,n.pointShadowMap[g]=W,n.pointShadowMatrix[g]=C.shadow.matrix,T++}n.point[g]=Z,g++}else if(C.isHemisphereLight){const Z=t.get(C);Z.skyColor.copy(C.color).multiplyScalar(H),Z.groundColor.copy(C.groundColor).multiplyScalar(H),n.hemi[p]=Z,p++}}m>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=St.LTC_FLOAT_1,n.rectAreaLTC2=St.LTC_FLOAT_2):(n.rectAreaLTC1=St.LTC_HALF_1,n.rectAreaLTC2=St.LTC_HALF_2)),n.ambient[0]=u,n.ambient[1]=h,n.ambient[2]=f;const k=n.hash;(k.directionalLength!==d||k.pointLength!==g||k.spotLength!==v||k.rectAreaLength!==m||k.hemiLength!==p||k.numDirectionalShadows!==w||k.numPointShadows!==T||k.numSpotShadows!==M||k.numSpotMaps!==U||k.numLightProbes!==I)&&(n.directional.length=d,n.spot.length=v,n.rectArea.length=m,n.point.length=g,n.hemi.length=p,n.directionalShadow.length=w,n.directionalShadowMap.length=w,n.pointShadow.length=T,n.pointShadowMap.length=T,n.spotShadow.length=M,n.spotShadowMap.length=M,n.directionalShadowMatrix.length=w,n.pointShadowMatrix.length=T,n.spotLightMatrix.length=M+U-D,n.spotLightMap.length=U,n.numSpotLightShadowsWithMaps=D,n.numLightProbes=I,k.directionalLength=d,k.pointLength=g,k.spotLength=v,k.rectAreaLength=m,k.hemiLength=p,k.numDirectionalShadows=w,k.numPointShadows=T,k.numSpotShadows=M,k.numSpotMaps=U,k.numLightProbes=I,n.version=bS++)}function l(c,u){let h=0,f=0,d=0,g=0,v=0;const m=u.matrixWorldInverse;for(let p=0,w=c.length;p<w;p++){const T=c[p];if(T.isDirectionalLight){const M=n.directional[h];M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),h++}else if(T.isSpotLight){const M=n.spot[d];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),M.direction.setFromMatrixPosition(T.matrixWorld),s.setFromMatrixPosition(T.target.matrixWorld),M.direction.sub(s),M.direction.transformDirection(m),d++}else if(T.isRectAreaLight){const M=n.rectArea[g];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),o.identity(),r.copy(T.matrixWorld),r.premultiply(m),o.extractRotation(r),M.halfWidth.set(T.width*.5,0,0),M.halfHeight.set(0,T.height*.5,0),M.halfWidth.applyMatrix4(o),M.halfHeight.applyMatrix4(o),g++}else if(T.isPointLight){const M=n.point[f];M.position.setFromMatrixPosition(T.matrixWorld),M.position.applyMatrix4(m),f++}else if(T.isHemisphereLight){const M=n.hemi[v];M.direction.setFromMatrixPosition(T.matrixWorld),M.direction.transformDirection(m),v++}}}return{setup:a,setupView:l,state:n}}function Rf(i){const t=new RS(i),e=[],n=[];function s(u){c.camera=u,e.length=0,n.length=0}function r(u){e.push(u)}function o(u){n.push(u)}function a(){t.setup(e)}function l(u){t.setupView(e,u)}const c={lightsArray:e,shadowsArray:n,camera:null,lights:t,transmissionRenderTarget:{}};return{init:s,state:c,setupLights:a,setupLightsView:l,pushLight:r,pushShadow:o}}function CS(i){let t=new WeakMap;function e(s,r=0){const o=t.get(s);let a;return o===void 0?(a=new Rf(i),t.set(s,[a])):r>=o.length?(a=new Rf(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}const PS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,DS=`uniform sampler2D shadow_pass;
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
}`;function LS(i,t,e){let n=new dp;const s=new Rt,r=new Rt,o=new Ye,a=new sv({depthPacking:I_}),l=new rv,c={},u=e.maxTextureSize,h={[fs]:Nn,[Nn]:fs,[Ti]:Ti},f=new qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Rt},radius:{value:4}},vertexShader:PS,fragmentShader:DS}),d=f.clone();d.defines.HORIZONTAL_PASS=1;const g=new Pn;g.setAttribute("position",new vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));const v=new Yn(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Xd;let p=this.type;this.render=function(D,I,k){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||D.length===0)return;const b=i.getRenderTarget(),E=i.getActiveCubeFace(),C=i.getActiveMipmapLevel(),G=i.state;G.setBlending(Vi),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);const H=p!==ki&&this.type===ki,$=p===ki&&this.type!==ki;for(let W=0,Z=D.length;W<Z;W++){const Y=D[W],J=Y.shadow;if(J===void 0){console.warn("THREE.WebGLShadowMap:",Y,"has no shadow.");continue}if(J.autoUpdate===!1&&J.needsUpdate===!1)continue;s.copy(J.mapSize);const ot=J.getFrameExtents();if(s.multiply(ot),r.copy(J.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ot.x),s.x=r.x*ot.x,J.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ot.y),s.y=r.y*ot.y,J.mapSize.y=r.y)),J.map===null||H===!0||$===!0){const _t=this.type!==ki?{minFilter:Fn,magFilter:Fn}:{};J.map!==null&&J.map.dispose(),J.map=new Os(s.x,s.y,_t),J.map.texture.name=Y.name+".shadowMap",J.camera.updateProjectionMatrix()}i.setRenderTarget(J.map),i.clear();const at=J.getViewportCount();for(let _t=0;_t<at;_t++){const yt=J.getViewport(_t);o.set(r.x*yt.x,r.y*yt.y,r.x*yt.z,r.y*yt.w),G.viewport(o),J.updateMatrices(Y,_t),n=J.getFrustum(),M(I,k,J.camera,Y,this.type)}J.isPointLightShadow!==!0&&this.type===ki&&w(J,k),J.needsUpdate=!1}p=this.type,m.needsUpdate=!1,i.setRenderTarget(b,E,C)};function w(D,I){const k=t.update(v);f.defines.VSM_SAMPLES!==D.blurSamples&&(f.defines.VSM_SAMPLES=D.blurSamples,d.defines.VSM_SAMPLES=D.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),D.mapPass===null&&(D.mapPass=new Os(s.x,s.y)),f.uniforms.shadow_pass.value=D.map.texture,f.uniforms.resolution.value=D.mapSize,f.uniforms.radius.value=D.radius,i.setRenderTarget(D.mapPass),i.clear(),i.renderBufferDirect(I,null,k,f,v,null),d.uniforms.shadow_pass.value=D.mapPass.texture,d.uniforms.resolution.value=D.mapSize,d.uniforms.radius.value=D.radius,i.setRenderTarget(D.map),i.clear(),i.renderBufferDirect(I,null,k,d,v,null)}function T(D,I,k,b){let E=null;const C=k.isPointLight===!0?D.customDistanceMaterial:D.customDepthMaterial;if(C!==void 0)E=C;else if(E=k.isPointLight===!0?l:a,i.localClippingEnabled&&I.clipShadows===!0&&Array.isArray(I.clippingPlanes)&&I.clippingPlanes.length!==0||I.displacementMap&&I.displacementScale!==0||I.alphaMap&&I.alphaTest>0||I.map&&I.alphaTest>0||I.alphaToCoverage===!0){const G=E.uuid,H=I.uuid;let $=c[G];$===void 0&&($={},c[G]=$);let W=$[H];W===void 0&&(W=E.clone(),$[H]=W,I.addEventListener("dispose",U)),E=W}if(E.visible=I.visible,E.wireframe=I.wireframe,b===ki?E.side=I.shadowSide!==null?I.shadowSide:I.side:E.side=I.shadowSide!==null?I.shadowSide:h[I.side],E.alphaMap=I.alphaMap,E.alphaTest=I.alphaToCoverage===!0?.5:I.alphaTest,E.map=I.map,E.clipShadows=I.clipShadows,E.clippingPlanes=I.clippingPlanes,E.clipIntersection=I.clipIntersection,E.displacementMap=I.displacementMap,E.displacementScale=I.displacementScale,E.displacementBias=I.displacementBias,E.wireframeLinewidth=I.wireframeLinewidth,E.linewidth=I.linewidth,k.isPointLight===!0&&E.isMeshDistanceMaterial===!0){const G=i.properties.get(E);G.light=k}return E}function M(D,I,k,b,E){if(D.visible===!1)return;if(D.layers.test(I.layers)&&(D.isMesh||D.isLine||D.isPoints)&&(D.castShadow||D.receiveShadow&&E===ki)&&(!D.frustumCulled||n.intersectsObject(D))){D.modelViewMatrix.multiplyMatrices(k.matrixWorldInverse,D.matrixWorld);const H=t.update(D),$=D.material;if(Array.isArray($)){const W=H.groups;for(let Z=0,Y=W.length;Z<Y;Z++){const J=W[Z],ot=$[J.materialIndex];if(ot&&ot.visible){const at=T(D,ot,b,E);D.onBeforeShadow(i,D,I,k,H,at,J),i.renderBufferDirect(k,null,H,at,D,J),D.onAfterShadow(i,D,I,k,H,at,J)}}}else if($.visible){const W=T(D,$,b,E);D.onBeforeShadow(i,D,I,k,H,W,null),i.renderBufferDirect(k,null,H,W,D,null),D.onAfterShadow(i,D,I,k,H,W,null)}}const G=D.children;for(let H=0,$=G.length;H<$;H++)M(G[H],I,k,b,E)}function U(D){D.target.removeEventListener("dispose",U);for(const k in c){const b=c[k],E=D.target.uuid;E in b&&(b[E].dispose(),delete b[E])}}}const US={[lc]:cc,[hc]:dc,[uc]:pc,[Mr]:fc,[cc]:lc,[dc]:hc,[pc]:uc,[fc]:Mr};function IS(i,t){function e(){let F=!1;const ut=new Ye;let dt=null;const Pt=new Ye(0,0,0,0);return{setMask:function(ct){dt!==ct&&!F&&(i.colorMask(ct,ct,ct,ct),dt=ct)},setLocked:function(ct){F=ct},setClear:function(ct,st,Ft,Qt,Te){Te===!0&&(ct*=Qt,st*=Qt,Ft*=Qt),ut.set(ct,st,Ft,Qt),Pt.equals(ut)===!1&&(i.clearColor(ct,st,Ft,Qt),Pt.copy(ut))},reset:function(){F=!1,dt=null,Pt.set(-1,0,0,0)}}}function n(){let F=!1,ut=!1,dt=null,Pt=null,ct=null;return{setReversed:function(st){if(ut!==st){const Ft=t.get("EXT_clip_control");st?Ft.clipControlEXT(Ft.LOWER_LEFT_EXT,Ft.ZERO_TO_ONE_EXT):Ft.clipControlEXT(Ft.LOWER_LEFT_EXT,Ft.NEGATIVE_ONE_TO_ONE_EXT),ut=st;const Qt=ct;ct=null,this.setClear(Qt)}},getReversed:function(){return ut},setTest:function(st){st?et(i.DEPTH_TEST):Et(i.DEPTH_TEST)},setMask:function(st){dt!==st&&!F&&(i.depthMask(st),dt=st)},setFunc:function(st){if(ut&&(st=US[st]),Pt!==st){switch(st){case lc:i.depthFunc(i.NEVER);break;case cc:i.depthFunc(i.ALWAYS);break;case hc:i.depthFunc(i.LESS);break;case Mr:i.depthFunc(i.LEQUAL);break;case uc:i.depthFunc(i.EQUAL);break;case fc:i.depthFunc(i.GEQUAL);break;case dc:i.depthFunc(i.GREATER);break;case pc:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}Pt=st}},setLocked:function(st){F=st},setClear:function(st){ct!==st&&(ut&&(st=1-st),i.clearDepth(st),ct=st)},reset:function(){F=!1,dt=null,Pt=null,ct=null,ut=!1}}}function s(){let F=!1,ut=null,dt=null,Pt=null,ct=null,st=null,Ft=null,Qt=null,Te=null;return{setTest:function(de){F||(de?et(i.STENCIL_TEST):Et(i.STENCIL_TEST))},setMask:function(de){ut!==de&&!F&&(i.stencilMask(de),ut=de)},setFunc:function(de,fn,Ce){(dt!==de||Pt!==fn||ct!==Ce)&&(i.stencilFunc(de,fn,Ce),dt=de,Pt=fn,ct=Ce)},setOp:function(de,fn,Ce){(st!==de||Ft!==fn||Qt!==Ce)&&(i.stencilOp(de,fn,Ce),st=de,Ft=fn,Qt=Ce)},setLocked:function(de){F=de},setClear:function(de){Te!==de&&(i.clearStencil(de),Te=de)},reset:function(){F=!1,ut=null,dt=null,Pt=null,ct=null,st=null,Ft=null,Qt=null,Te=null}}}const r=new e,o=new n,a=new s,l=new WeakMap,c=new WeakMap;let u={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,w=null,T=null,M=null,U=null,D=null,I=new ve(0,0,0),k=0,b=!1,E=null,C=null,G=null,H=null,$=null;const W=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS);let Z=!1,Y=0;const J=i.getParameter(i.VERSION);J.indexOf("WebGL")!==-1?(Y=parseFloat(/^WebGL (\d)/.exec(J)[1]),Z=Y>=1):J.indexOf("OpenGL ES")!==-1&&(Y=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),Z=Y>=2);let ot=null,at={};const _t=i.getParameter(i.SCISSOR_BOX),yt=i.getParameter(i.VIEWPORT),gt=new Ye().fromArray(_t),ee=new Ye().fromArray(yt);function Zt(F,ut,dt,Pt){const ct=new Uint8Array(4),st=i.createTexture();i.bindTexture(F,st),i.texParameteri(F,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(F,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ft=0;Ft<dt;Ft++)F===i.TEXTURE_3D||F===i.TEXTURE_2D_ARRAY?i.texImage3D(ut,0,i.RGBA,1,1,Pt,0,i.RGBA,i.UNSIGNED_BYTE,ct):i.texImage2D(ut+Ft,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,ct);return st}const Q={};Q[i.TEXTURE_2D]=Zt(i.TEXTURE_2D,i.TEXTURE_2D,1),Q[i.TEXTURE_CUBE_MAP]=Zt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),Q[i.TEXTURE_2D_ARRAY]=Zt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),Q[i.TEXTURE_3D]=Zt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),et(i.DEPTH_TEST),o.setFunc(Mr),Wt(!1),It(yu),et(i.CULL_FACE),fe(Vi);function et(F){u[F]!==!0&&(i.enable(F),u[F]=!0)}function Et(F){u[F]!==!1&&(i.disable(F),u[F]=!1)}function Bt(F,ut){return h[F]!==ut?(i.bindFramebuffer(F,ut),h[F]=ut,F===i.DRAW_FRAMEBUFFER&&(h[i.FRAMEBUFFER]=ut),F===i.FRAMEBUFFER&&(h[i.DRAW_FRAMEBUFFER]=ut),!0):!1}function vt(F,ut){let dt=d,Pt=!1;if(F){dt=f.get(ut),dt===void 0&&(dt=[],f.set(ut,dt));const ct=F.textures;if(dt.length!==ct.length||dt[0]!==i.COLOR_ATTACHMENT0){for(let st=0,Ft=ct.length;st<Ft;st++)dt[st]=i.COLOR_ATTACHMENT0+st;dt.length=ct.length,Pt=!0}}else dt[0]!==i.BACK&&(dt[0]=i.BACK,Pt=!0);Pt&&i.drawBuffers(dt)}function Jt(F){return g!==F?(i.useProgram(F),g=F,!0):!1}const Le={[Cs]:i.FUNC_ADD,[o_]:i.FUNC_SUBTRACT,[a_]:i.FUNC_REVERSE_SUBTRACT};Le[l_]=i.MIN,Le[c_]=i.MAX;const L={[h_]:i.ZERO,[u_]:i.ONE,[f_]:i.SRC_COLOR,[oc]:i.SRC_ALPHA,[v_]:i.SRC_ALPHA_SATURATE,[g_]:i.DST_COLOR,[p_]:i.DST_ALPHA,[d_]:i.ONE_MINUS_SRC_COLOR,[ac]:i.ONE_MINUS_SRC_ALPHA,[__]:i.ONE_MINUS_DST_COLOR,[m_]:i.ONE_MINUS_DST_ALPHA,[x_]:i.CONSTANT_COLOR,[y_]:i.ONE_MINUS_CONSTANT_COLOR,[M_]:i.CONSTANT_ALPHA,[S_]:i.ONE_MINUS_CONSTANT_ALPHA};function fe(F,ut,dt,Pt,ct,st,Ft,Qt,Te,de){if(F===Vi){v===!0&&(Et(i.BLEND),v=!1);return}if(v===!1&&(et(i.BLEND),v=!0),F!==r_){if(F!==m||de!==b){if((p!==Cs||M!==Cs)&&(i.blendEquation(i.FUNC_ADD),p=Cs,M=Cs),de)switch(F){case _r:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Mu:i.blendFunc(i.ONE,i.ONE);break;case Su:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Eu:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}else switch(F){case _r:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Mu:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Su:console.error("THREE.WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Eu:console.error("THREE.WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:console.error("THREE.WebGLState: Invalid blending: ",F);break}w=null,T=null,U=null,D=null,I.set(0,0,0),k=0,m=F,b=de}return}ct=ct||ut,st=st||dt,Ft=Ft||Pt,(ut!==p||ct!==M)&&(i.blendEquationSeparate(Le[ut],Le[ct]),p=ut,M=ct),(dt!==w||Pt!==T||st!==U||Ft!==D)&&(i.blendFuncSeparate(L[dt],L[Pt],L[st],L[Ft]),w=dt,T=Pt,U=st,D=Ft),(Qt.equals(I)===!1||Te!==k)&&(i.blendColor(Qt.r,Qt.g,Qt.b,Te),I.copy(Qt),k=Te),m=F,b=!1}function $t(F,ut){F.side===Ti?Et(i.CULL_FACE):et(i.CULL_FACE);let dt=F.side===Nn;ut&&(dt=!dt),Wt(dt),F.blending===_r&&F.transparent===!1?fe(Vi):fe(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);const Pt=F.stencilWrite;a.setTest(Pt),Pt&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),Ct(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?et(i.SAMPLE_ALPHA_TO_COVERAGE):Et(i.SAMPLE_ALPHA_TO_COVERAGE)}function Wt(F){E!==F&&(F?i.frontFace(i.CW):i.frontFace(i.CCW),E=F)}function It(F){F!==n_?(et(i.CULL_FACE),F!==C&&(F===yu?i.cullFace(i.BACK):F===i_?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Et(i.CULL_FACE),C=F}function Ee(F){F!==G&&(Z&&i.lineWidth(F),G=F)}function Ct(F,ut,dt){F?(et(i.POLYGON_OFFSET_FILL),(H!==ut||$!==dt)&&(i.polygonOffset(ut,dt),H=ut,$=dt)):Et(i.POLYGON_OFFSET_FILL)}function Vt(F){F?et(i.SCISSOR_TEST):Et(i.SCISSOR_TEST)}function Fe(F){F===void 0&&(F=i.TEXTURE0+W-1),ot!==F&&(i.activeTexture(F),ot=F)}function xe(F,ut,dt){dt===void 0&&(ot===null?dt=i.TEXTURE0+W-1:dt=ot);let Pt=at[dt];Pt===void 0&&(Pt={type:void 0,texture:void 0},at[dt]=Pt),(Pt.type!==F||Pt.texture!==ut)&&(ot!==dt&&(i.activeTexture(dt),ot=dt),i.bindTexture(F,ut||Q[F]),Pt.type=F,Pt.texture=ut)}function R(){const F=at[ot];F!==void 0&&F.type!==void 0&&(i.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function x(){try{i.compressedTexImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function N(){try{i.compressedTexImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function j(){try{i.texSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function nt(){try{i.texSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function tt(){try{i.compressedTexSubImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Nt(){try{i.compressedTexSubImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function ht(){try{i.texStorage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function Dt(){try{i.texStorage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function bt(){try{i.texImage2D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function rt(){try{i.texImage3D(...arguments)}catch(F){console.error("THREE.WebGLState:",F)}}function mt(F){gt.equals(F)===!1&&(i.scissor(F.x,F.y,F.z,F.w),gt.copy(F))}function kt(F){ee.equals(F)===!1&&(i.viewport(F.x,F.y,F.z,F.w),ee.copy(F))}function Ot(F,ut){let dt=c.get(ut);dt===void 0&&(dt=new WeakMap,c.set(ut,dt));let Pt=dt.get(F);Pt===void 0&&(Pt=i.getUniformBlockIndex(ut,F.name),dt.set(F,Pt))}function xt(F,ut){const Pt=c.get(ut).get(F);l.get(ut)!==Pt&&(i.uniformBlockBinding(ut,Pt,F.__bindingPointIndex),l.set(ut,Pt))}function Kt(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),u={},ot=null,at={},h={},f=new WeakMap,d=[],g=null,v=!1,m=null,p=null,w=null,T=null,M=null,U=null,D=null,I=new ve(0,0,0),k=0,b=!1,E=null,C=null,G=null,H=null,$=null,gt.set(0,0,i.canvas.width,i.canvas.height),ee.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:et,disable:Et,bindFramebuffer:Bt,drawBuffers:vt,useProgram:Jt,setBlending:fe,setMaterial:$t,setFlipSided:Wt,setCullFace:It,setLineWidth:Ee,setPolygonOffset:Ct,setScissorTest:Vt,activeTexture:Fe,bindTexture:xe,unbindTexture:R,compressedTexImage2D:x,compressedTexImage3D:N,texImage2D:bt,texImage3D:rt,updateUBOMapping:Ot,uniformBlockBinding:xt,texStorage2D:ht,texStorage3D:Dt,texSubImage2D:j,texSubImage3D:nt,compressedTexSubImage2D:tt,compressedTexSubImage3D:Nt,scissor:mt,viewport:kt,reset:Kt}}function NS(i,t,e,n,s,r,o){const a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Rt,u=new WeakMap;let h;const f=new WeakMap;let d=!1;try{d=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,x){return d?new OffscreenCanvas(R,x):Aa("canvas")}function v(R,x,N){let j=1;const nt=xe(R);if((nt.width>N||nt.height>N)&&(j=N/Math.max(nt.width,nt.height)),j<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){const tt=Math.floor(j*nt.width),Nt=Math.floor(j*nt.height);h===void 0&&(h=g(tt,Nt));const ht=x?g(tt,Nt):h;return ht.width=tt,ht.height=Nt,ht.getContext("2d").drawImage(R,0,0,tt,Nt),console.warn("THREE.WebGLRenderer: Texture has been resized from ("+nt.width+"x"+nt.height+") to ("+tt+"x"+Nt+")."),ht}else return"data"in R&&console.warn("THREE.WebGLRenderer: Image in DataTexture is too big ("+nt.width+"x"+nt.height+")."),R;return R}function m(R){return R.generateMipmaps}function p(R){i.generateMipmap(R)}function w(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function T(R,x,N,j,nt=!1){if(R!==null){if(i[R]!==void 0)return i[R];console.warn("THREE.WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let tt=x;if(x===i.RED&&(N===i.FLOAT&&(tt=i.R32F),N===i.HALF_FLOAT&&(tt=i.R16F),N===i.UNSIGNED_BYTE&&(tt=i.R8)),x===i.RED_INTEGER&&(N===i.UNSIGNED_BYTE&&(tt=i.R8UI),N===i.UNSIGNED_SHORT&&(tt=i.R16UI),N===i.UNSIGNED_INT&&(tt=i.R32UI),N===i.BYTE&&(tt=i.R8I),N===i.SHORT&&(tt=i.R16I),N===i.INT&&(tt=i.R32I)),x===i.RG&&(N===i.FLOAT&&(tt=i.RG32F),N===i.HALF_FLOAT&&(tt=i.RG16F),N===i.UNSIGNED_BYTE&&(tt=i.RG8)),x===i.RG_INTEGER&&(N===i.UNSIGNED_BYTE&&(tt=i.RG8UI),N===i.UNSIGNED_SHORT&&(tt=i.RG16UI),N===i.UNSIGNED_INT&&(tt=i.RG32UI),N===i.BYTE&&(tt=i.RG8I),N===i.SHORT&&(tt=i.RG16I),N===i.INT&&(tt=i.RG32I)),x===i.RGB_INTEGER&&(N===i.UNSIGNED_BYTE&&(tt=i.RGB8UI),N===i.UNSIGNED_SHORT&&(tt=i.RGB16UI),N===i.UNSIGNED_INT&&(tt=i.RGB32UI),N===i.BYTE&&(tt=i.RGB8I),N===i.SHORT&&(tt=i.RGB16I),N===i.INT&&(tt=i.RGB32I)),x===i.RGBA_INTEGER&&(N===i.UNSIGNED_BYTE&&(tt=i.RGBA8UI),N===i.UNSIGNED_SHORT&&(tt=i.RGBA16UI),N===i.UNSIGNED_INT&&(tt=i.RGBA32UI),N===i.BYTE&&(tt=i.RGBA8I),N===i.SHORT&&(tt=i.RGBA16I),N===i.INT&&(tt=i.RGBA32I)),x===i.RGB&&(N===i.UNSIGNED_INT_5_9_9_9_REV&&(tt=i.RGB9_E5),N===i.UNSIGNED_INT_10F_11F_11F_REV&&(tt=i.R11F_G11F_B10F)),x===i.RGBA){const Nt=nt?Ta:ge.getTransfer(j);N===i.FLOAT&&(tt=i.RGBA32F),N===i.HALF_FLOAT&&(tt=i.RGBA16F),N===i.UNSIGNED_BYTE&&(tt=Nt===Ae?i.SRGB8_ALPHA8:i.RGBA8),N===i.UNSIGNED_SHORT_4_4_4_4&&(tt=i.RGBA4),N===i.UNSIGNED_SHORT_5_5_5_1&&(tt=i.RGB5_A1)}return(tt===i.R16F||tt===i.R32F||tt===i.RG16F||tt===i.RG32F||tt===i.RGBA16F||tt===i.RGBA32F)&&t.get("EXT_color_buffer_float"),tt}function M(R,x){let N;return R?x===null||x===Ns||x===_o?N=i.DEPTH24_STENCIL8:x===zi?N=i.DEPTH32F_STENCIL8:x===go&&(N=i.DEPTH24_STENCIL8,console.warn("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):x===null||x===Ns||x===_o?N=i.DEPTH_COMPONENT24:x===zi?N=i.DEPTH_COMPONENT32F:x===go&&(N=i.DEPTH_COMPONENT16),N}function U(R,x){return m(R)===!0||R.isFramebufferTexture&&R.minFilter!==Fn&&R.minFilter!==bi?Math.log2(Math.max(x.width,x.height))+1:R.mipmaps!==void 0&&R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?x.mipmaps.length:1}function D(R){const x=R.target;x.removeEventListener("dispose",D),k(x),x.isVideoTexture&&u.delete(x)}function I(R){const x=R.target;x.removeEventListener("dispose",I),E(x)}function k(R){const x=n.get(R);if(x.__webglInit===void 0)return;const N=R.source,j=f.get(N);if(j){const nt=j[x.__cacheKey];nt.usedTimes--,nt.usedTimes===0&&b(R),Object.keys(j).length===0&&f.delete(N)}n.remove(R)}function b(R){const x=n.get(R);i.deleteTexture(x.__webglTexture);const N=R.source,j=f.get(N);delete j[x.__cacheKey],o.memory.textures--}function E(R){const x=n.get(R);if(R.depthTexture&&(R.depthTexture.dispose(),n.remove(R.depthTexture)),R.isWebGLCubeRenderTarget)for(let j=0;j<6;j++){if(Array.isArray(x.__webglFramebuffer[j]))for(let nt=0;nt<x.__webglFramebuffer[j].length;nt++)i.deleteFramebuffer(x.__webglFramebuffer[j][nt]);else i.deleteFramebuffer(x.__webglFramebuffer[j]);x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer[j])}else{if(Array.isArray(x.__webglFramebuffer))for(let j=0;j<x.__webglFramebuffer.length;j++)i.deleteFramebuffer(x.__webglFramebuffer[j]);else i.deleteFramebuffer(x.__webglFramebuffer);if(x.__webglDepthbuffer&&i.deleteRenderbuffer(x.__webglDepthbuffer),x.__webglMultisampledFramebuffer&&i.deleteFramebuffer(x.__webglMultisampledFramebuffer),x.__webglColorRenderbuffer)for(let j=0;j<x.__webglColorRenderbuffer.length;j++)x.__webglColorRenderbuffer[j]&&i.deleteRenderbuffer(x.__webglColorRenderbuffer[j]);x.__webglDepthRenderbuffer&&i.deleteRenderbuffer(x.__webglDepthRenderbuffer)}const N=R.textures;for(let j=0,nt=N.length;j<nt;j++){const tt=n.get(N[j]);tt.__webglTexture&&(i.deleteTexture(tt.__webglTexture),o.memory.textures--),n.remove(N[j])}n.remove(R)}let C=0;function G(){C=0}function H(){const R=C;return R>=s.maxTextures&&console.warn("THREE.WebGLTextures: Trying to use "+R+" texture units while this GPU supports only "+s.maxTextures),C+=1,R}function $(R){const x=[];return x.push(R.wrapS),x.push(R.wrapT),x.push(R.wrapR||0),x.push(R.magFilter),x.push(R.minFilter),x.push(R.anisotropy),x.push(R.internalFormat),x.push(R.format),x.push(R.type),x.push(R.generateMipmaps),x.push(R.premultiplyAlpha),x.push(R.flipY),x.push(R.unpackAlignment),x.push(R.colorSpace),x.join()}function W(R,x){const N=n.get(R);if(R.isVideoTexture&&Vt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&N.__version!==R.version){const j=R.image;if(j===null)console.warn("THREE.WebGLRenderer: Texture marked for update but no image data found.");else if(j.complete===!1)console.warn("THREE.WebGLRenderer: Texture marked for update but image is incomplete");else{Q(N,R,x);return}}else R.isExternalTexture&&(N.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,N.__webglTexture,i.TEXTURE0+x)}function Z(R,x){const N=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&N.__version!==R.version){Q(N,R,x);return}e.bindTexture(i.TEXTURE_2D_ARRAY,N.__webglTexture,i.TEXTURE0+x)}function Y(R,x){const N=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&N.__version!==R.version){Q(N,R,x);return}e.bindTexture(i.TEXTURE_3D,N.__webglTexture,i.TEXTURE0+x)}function J(R,x){const N=n.get(R);if(R.version>0&&N.__version!==R.version){et(N,R,x);return}e.bindTexture(i.TEXTURE_CUBE_MAP,N.__webglTexture,i.TEXTURE0+x)}const ot={[wa]:i.REPEAT,[Ls]:i.CLAMP_TO_EDGE,[_c]:i.MIRRORED_REPEAT},at={[Fn]:i.NEAREST,[L_]:i.NEAREST_MIPMAP_NEAREST,[Oo]:i.NEAREST_MIPMAP_LINEAR,[bi]:i.LINEAR,[fl]:i.LINEAR_MIPMAP_NEAREST,[Us]:i.LINEAR_MIPMAP_LINEAR},_t={[O_]:i.NEVER,[G_]:i.ALWAYS,[k_]:i.LESS,[np]:i.LEQUAL,[B_]:i.EQUAL,[V_]:i.GEQUAL,[z_]:i.GREATER,[H_]:i.NOTEQUAL};function yt(R,x){if(x.type===zi&&t.has("OES_texture_float_linear")===!1&&(x.magFilter===bi||x.magFilter===fl||x.magFilter===Oo||x.magFilter===Us||x.minFilter===bi||x.minFilter===fl||x.minFilter===Oo||x.minFilter===Us)&&console.warn("THREE.WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,ot[x.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,ot[x.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,ot[x.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,at[x.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,at[x.minFilter]),x.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,_t[x.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(x.magFilter===Fn||x.minFilter!==Oo&&x.minFilter!==Us||x.type===zi&&t.has("OES_texture_float_linear")===!1)return;if(x.anisotropy>1||n.get(x).__currentAnisotropy){const N=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,N.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(x.anisotropy,s.getMaxAnisotropy())),n.get(x).__currentAnisotropy=x.anisotropy}}}function gt(R,x){let N=!1;R.__webglInit===void 0&&(R.__webglInit=!0,x.addEventListener("dispose",D));const j=x.source;let nt=f.get(j);nt===void 0&&(nt={},f.set(j,nt));const tt=$(x);if(tt!==R.__cacheKey){nt[tt]===void 0&&(nt[tt]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,N=!0),nt[tt].usedTimes++;const Nt=nt[R.__cacheKey];Nt!==void 0&&(nt[R.__cacheKey].usedTimes--,Nt.usedTimes===0&&b(x)),R.__cacheKey=tt,R.__webglTexture=nt[tt].texture}return N}function ee(R,x,N){return Math.floor(Math.floor(R/N)/x)}function Zt(R,x,N,j){const tt=R.updateRanges;if(tt.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,x.width,x.height,N,j,x.data);else{tt.sort((rt,mt)=>rt.start-mt.start);let Nt=0;for(let rt=1;rt<tt.length;rt++){const mt=tt[Nt],kt=tt[rt],Ot=mt.start+mt.count,xt=ee(kt.start,x.width,4),Kt=ee(mt.start,x.width,4);kt.start<=Ot+1&&xt===Kt&&ee(kt.start+kt.count-1,x.width,4)===xt?mt.count=Math.max(mt.count,kt.start+kt.count-mt.start):(++Nt,tt[Nt]=kt)}tt.length=Nt+1;const ht=i.getParameter(i.UNPACK_ROW_LENGTH),Dt=i.getParameter(i.UNPACK_SKIP_PIXELS),bt=i.getParameter(i.UNPACK_SKIP_ROWS);i.pixelStorei(i.UNPACK_ROW_LENGTH,x.width);for(let rt=0,mt=tt.length;rt<mt;rt++){const kt=tt[rt],Ot=Math.floor(kt.start/4),xt=Math.ceil(kt.count/4),Kt=Ot%x.width,F=Math.floor(Ot/x.width),ut=xt,dt=1;i.pixelStorei(i.UNPACK_SKIP_PIXELS,Kt),i.pixelStorei(i.UNPACK_SKIP_ROWS,F),e.texSubImage2D(i.TEXTURE_2D,0,Kt,F,ut,dt,N,j,x.data)}R.clearUpdateRanges(),i.pixelStorei(i.UNPACK_ROW_LENGTH,ht),i.pixelStorei(i.UNPACK_SKIP_PIXELS,Dt),i.pixelStorei(i.UNPACK_SKIP_ROWS,bt)}}function Q(R,x,N){let j=i.TEXTURE_2D;(x.isDataArrayTexture||x.isCompressedArrayTexture)&&(j=i.TEXTURE_2D_ARRAY),x.isData3DTexture&&(j=i.TEXTURE_3D);const nt=gt(R,x),tt=x.source;e.bindTexture(j,R.__webglTexture,i.TEXTURE0+N);const Nt=n.get(tt);if(tt.version!==Nt.__version||nt===!0){e.activeTexture(i.TEXTURE0+N);const ht=ge.getPrimaries(ge.workingColorSpace),Dt=x.colorSpace===ls?null:ge.getPrimaries(x.colorSpace),bt=x.colorSpace===ls||ht===Dt?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,bt);let rt=v(x.image,!1,s.maxTextureSize);rt=Fe(x,rt);const mt=r.convert(x.format,x.colorSpace),kt=r.convert(x.type);let Ot=T(x.internalFormat,mt,kt,x.colorSpace,x.isVideoTexture);yt(j,x);let xt;const Kt=x.mipmaps,F=x.isVideoTexture!==!0,ut=Nt.__version===void 0||nt===!0,dt=tt.dataReady,Pt=U(x,rt);if(x.isDepthTexture)Ot=M(x.format===xo,x.type),ut&&(F?e.texStorage2D(i.TEXTURE_2D,1,Ot,rt.width,rt.height):e.texImage2D(i.TEXTURE_2D,0,Ot,rt.width,rt.height,0,mt,kt,null));else if(x.isDataTexture)if(Kt.length>0){F&&ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,Kt[0].width,Kt[0].height);for(let ct=0,st=Kt.length;ct<st;ct++)xt=Kt[ct],F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,kt,xt.data):e.texImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,mt,kt,xt.data);x.generateMipmaps=!1}else F?(ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,rt.width,rt.height),dt&&Zt(x,rt,mt,kt)):e.texImage2D(i.TEXTURE_2D,0,Ot,rt.width,rt.height,0,mt,kt,rt.data);else if(x.isCompressedTexture)if(x.isCompressedArrayTexture){F&&ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Pt,Ot,Kt[0].width,Kt[0].height,rt.depth);for(let ct=0,st=Kt.length;ct<st;ct++)if(xt=Kt[ct],x.format!==si)if(mt!==null)if(F){if(dt)if(x.layerUpdates.size>0){const Ft=sf(xt.width,xt.height,x.format,x.type);for(const Qt of x.layerUpdates){const Te=xt.data.subarray(Qt*Ft/xt.data.BYTES_PER_ELEMENT,(Qt+1)*Ft/xt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,Qt,xt.width,xt.height,1,mt,Te)}x.clearLayerUpdates()}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,xt.width,xt.height,rt.depth,mt,xt.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,ct,Ot,xt.width,xt.height,rt.depth,0,xt.data,0,0);else console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else F?dt&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,ct,0,0,0,xt.width,xt.height,rt.depth,mt,kt,xt.data):e.texImage3D(i.TEXTURE_2D_ARRAY,ct,Ot,xt.width,xt.height,rt.depth,0,mt,kt,xt.data)}else{F&&ut&&e.texStorage2D(i.TEXTURE_2D,Pt,Ot,Kt[0].width,Kt[0].height);for(let ct=0,st=Kt.length;ct<st;ct++)xt=Kt[ct],x.format!==si?mt!==null?F?dt&&e.compressedTexSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,xt.data):e.compressedTexImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,xt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,xt.width,xt.height,mt,kt,xt.data):e.texImage2D(i.TEXTURE_2D,ct,Ot,xt.width,xt.height,0,mt,kt,xt.data)}else if(x.isDataArrayTexture)if(F){if(ut&&e.texStorage3D(i.TEXTURE_2D_ARRAY,Pt,Ot,rt.width,rt.height,rt.depth),dt)if(x.layerUpdates.size>0){const ct=sf(rt.width,rt.height,x.format,x.type);for(const st of x.layerUpdates){const Ft=rt.data.subarray(st*ct/rt.data.BYTES_PER_ELEMENT,(st+1)*ct/rt.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,st,rt.width,rt.height,1,mt,kt,Ft)}x.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,rt.width,rt.height,rt.depth,mt,kt,rt.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,Ot,rt.width,rt.height,rt.depth,0,mt,kt,rt.data);else if(x.isData3DTexture)F?(ut&&e.texStorage3D(i.TEXTURE_3D,Pt,Ot,rt.width,rt.height,rt.depth),dt&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,rt.width,rt.height,rt.depth,mt,kt,rt.data)):e.texImage3D(i.TEXTURE_3D,0,Ot,rt.width,rt.height,rt.depth,0,mt,kt,rt.data);else if(x.isFramebufferTexture){if(ut)if(F)e.texStorage2D(i.TEXTURE_2D,Pt,Ot,rt.width,rt.height);else{let ct=rt.width,st=rt.height;for(let Ft=0;Ft<Pt;Ft++)e.texImage2D(i.TEXTURE_2D,Ft,Ot,ct,st,0,mt,kt,null),ct>>=1,st>>=1}}else if(Kt.length>0){if(F&&ut){const ct=xe(Kt[0]);e.texStorage2D(i.TEXTURE_2D,Pt,Ot,ct.width,ct.height)}for(let ct=0,st=Kt.length;ct<st;ct++)xt=Kt[ct],F?dt&&e.texSubImage2D(i.TEXTURE_2D,ct,0,0,mt,kt,xt):e.texImage2D(i.TEXTURE_2D,ct,Ot,mt,kt,xt);x.generateMipmaps=!1}else if(F){if(ut){const ct=xe(rt);e.texStorage2D(i.TEXTURE_2D,Pt,Ot,ct.width,ct.height)}dt&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,mt,kt,rt)}else e.texImage2D(i.TEXTURE_2D,0,Ot,mt,kt,rt);m(x)&&p(j),Nt.__version=tt.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function et(R,x,N){if(x.image.length!==6)return;const j=gt(R,x),nt=x.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+N);const tt=n.get(nt);if(nt.version!==tt.__version||j===!0){e.activeTexture(i.TEXTURE0+N);const Nt=ge.getPrimaries(ge.workingColorSpace),ht=x.colorSpace===ls?null:ge.getPrimaries(x.colorSpace),Dt=x.colorSpace===ls||Nt===ht?i.NONE:i.BROWSER_DEFAULT_WEBGL;i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,x.flipY),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,x.premultiplyAlpha),i.pixelStorei(i.UNPACK_ALIGNMENT,x.unpackAlignment),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Dt);const bt=x.isCompressedTexture||x.image[0].isCompressedTexture,rt=x.image[0]&&x.image[0].isDataTexture,mt=[];for(let st=0;st<6;st++)!bt&&!rt?mt[st]=v(x.image[st],!0,s.maxCubemapSize):mt[st]=rt?x.image[st].image:x.image[st],mt[st]=Fe(x,mt[st]);const kt=mt[0],Ot=r.convert(x.format,x.colorSpace),xt=r.convert(x.type),Kt=T(x.internalFormat,Ot,xt,x.colorSpace),F=x.isVideoTexture!==!0,ut=tt.__version===void 0||j===!0,dt=nt.dataReady;let Pt=U(x,kt);yt(i.TEXTURE_CUBE_MAP,x);let ct;if(bt){F&&ut&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,Kt,kt.width,kt.height);for(let st=0;st<6;st++){ct=mt[st].mipmaps;for(let Ft=0;Ft<ct.length;Ft++){const Qt=ct[Ft];x.format!==si?Ot!==null?F?dt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,0,0,Qt.width,Qt.height,Ot,Qt.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,Kt,Qt.width,Qt.height,0,Qt.data):console.warn("THREE.WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,0,0,Qt.width,Qt.height,Ot,xt,Qt.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft,Kt,Qt.width,Qt.height,0,Ot,xt,Qt.data)}}}else{if(ct=x.mipmaps,F&&ut){ct.length>0&&Pt++;const st=xe(mt[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,Kt,st.width,st.height)}for(let st=0;st<6;st++)if(rt){F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,mt[st].width,mt[st].height,Ot,xt,mt[st].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Kt,mt[st].width,mt[st].height,0,Ot,xt,mt[st].data);for(let Ft=0;Ft<ct.length;Ft++){const Te=ct[Ft].image[st].image;F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,0,0,Te.width,Te.height,Ot,xt,Te.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,Kt,Te.width,Te.height,0,Ot,xt,Te.data)}}else{F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,0,0,Ot,xt,mt[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,0,Kt,Ot,xt,mt[st]);for(let Ft=0;Ft<ct.length;Ft++){const Qt=ct[Ft];F?dt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,0,0,Ot,xt,Qt.image[st]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+st,Ft+1,Kt,Ot,xt,Qt.image[st])}}}m(x)&&p(i.TEXTURE_CUBE_MAP),tt.__version=nt.version,x.onUpdate&&x.onUpdate(x)}R.__version=x.version}function Et(R,x,N,j,nt,tt){const Nt=r.convert(N.format,N.colorSpace),ht=r.convert(N.type),Dt=T(N.internalFormat,Nt,ht,N.colorSpace),bt=n.get(x),rt=n.get(N);if(rt.__renderTarget=x,!bt.__hasExternalTextures){const mt=Math.max(1,x.width>>tt),kt=Math.max(1,x.height>>tt);nt===i.TEXTURE_3D||nt===i.TEXTURE_2D_ARRAY?e.texImage3D(nt,tt,Dt,mt,kt,x.depth,0,Nt,ht,null):e.texImage2D(nt,tt,Dt,mt,kt,0,Nt,ht,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),Ct(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,j,nt,rt.__webglTexture,0,Ee(x)):(nt===i.TEXTURE_2D||nt>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&nt<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,j,nt,rt.__webglTexture,tt),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Bt(R,x,N){if(i.bindRenderbuffer(i.RENDERBUFFER,R),x.depthBuffer){const j=x.depthTexture,nt=j&&j.isDepthTexture?j.type:null,tt=M(x.stencilBuffer,nt),Nt=x.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ht=Ee(x);Ct(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,ht,tt,x.width,x.height):N?i.renderbufferStorageMultisample(i.RENDERBUFFER,ht,tt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,tt,x.width,x.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,Nt,i.RENDERBUFFER,R)}else{const j=x.textures;for(let nt=0;nt<j.length;nt++){const tt=j[nt],Nt=r.convert(tt.format,tt.colorSpace),ht=r.convert(tt.type),Dt=T(tt.internalFormat,Nt,ht,tt.colorSpace),bt=Ee(x);N&&Ct(x)===!1?i.renderbufferStorageMultisample(i.RENDERBUFFER,bt,Dt,x.width,x.height):Ct(x)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,bt,Dt,x.width,x.height):i.renderbufferStorage(i.RENDERBUFFER,Dt,x.width,x.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function vt(R,x){if(x&&x.isWebGLCubeRenderTarget)throw new Error("Depth Texture with cube render targets is not supported");if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(x.depthTexture&&x.depthTexture.isDepthTexture))throw new Error("renderTarget.depthTexture must be an instance of THREE.DepthTexture");const j=n.get(x.depthTexture);j.__renderTarget=x,(!j.__webglTexture||x.depthTexture.image.width!==x.width||x.depthTexture.image.height!==x.height)&&(x.depthTexture.image.width=x.width,x.depthTexture.image.height=x.height,x.depthTexture.needsUpdate=!0),W(x.depthTexture,0);const nt=j.__webglTexture,tt=Ee(x);if(x.depthTexture.format===vo)Ct(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_ATTACHMENT,i.TEXTURE_2D,nt,0);else if(x.depthTexture.format===xo)Ct(x)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0,tt):i.framebufferTexture2D(i.FRAMEBUFFER,i.DEPTH_STENCIL_ATTACHMENT,i.TEXTURE_2D,nt,0);else throw new Error("Unknown depthTexture format")}function Jt(R){const x=n.get(R),N=R.isWebGLCubeRenderTarget===!0;if(x.__boundDepthTexture!==R.depthTexture){const j=R.depthTexture;if(x.__depthDisposeCallback&&x.__depthDisposeCallback(),j){const nt=()=>{delete x.__boundDepthTexture,delete x.__depthDisposeCallback,j.removeEventListener("dispose",nt)};j.addEventListener("dispose",nt),x.__depthDisposeCallback=nt}x.__boundDepthTexture=j}if(R.depthTexture&&!x.__autoAllocateDepthBuffer){if(N)throw new Error("target.depthTexture not supported in Cube render targets");const j=R.texture.mipmaps;j&&j.length>0?vt(x.__webglFramebuffer[0],R):vt(x.__webglFramebuffer,R)}else if(N){x.__webglDepthbuffer=[];for(let j=0;j<6;j++)if(e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[j]),x.__webglDepthbuffer[j]===void 0)x.__webglDepthbuffer[j]=i.createRenderbuffer(),Bt(x.__webglDepthbuffer[j],R,!1);else{const nt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=x.__webglDepthbuffer[j];i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,tt)}}else{const j=R.texture.mipmaps;if(j&&j.length>0?e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,x.__webglFramebuffer),x.__webglDepthbuffer===void 0)x.__webglDepthbuffer=i.createRenderbuffer(),Bt(x.__webglDepthbuffer,R,!1);else{const nt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,tt=x.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,tt),i.framebufferRenderbuffer(i.FRAMEBUFFER,nt,i.RENDERBUFFER,tt)}}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Le(R,x,N){const j=n.get(R);x!==void 0&&Et(j.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),N!==void 0&&Jt(R)}function L(R){const x=R.texture,N=n.get(R),j=n.get(x);R.addEventListener("dispose",I);const nt=R.textures,tt=R.isWebGLCubeRenderTarget===!0,Nt=nt.length>1;if(Nt||(j.__webglTexture===void 0&&(j.__webglTexture=i.createTexture()),j.__version=x.version,o.memory.textures++),tt){N.__webglFramebuffer=[];for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer[ht]=[];for(let Dt=0;Dt<x.mipmaps.length;Dt++)N.__webglFramebuffer[ht][Dt]=i.createFramebuffer()}else N.__webglFramebuffer[ht]=i.createFramebuffer()}else{if(x.mipmaps&&x.mipmaps.length>0){N.__webglFramebuffer=[];for(let ht=0;ht<x.mipmaps.length;ht++)N.__webglFramebuffer[ht]=i.createFramebuffer()}else N.__webglFramebuffer=i.createFramebuffer();if(Nt)for(let ht=0,Dt=nt.length;ht<Dt;ht++){const bt=n.get(nt[ht]);bt.__webglTexture===void 0&&(bt.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&Ct(R)===!1){N.__webglMultisampledFramebuffer=i.createFramebuffer(),N.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,N.__webglMultisampledFramebuffer);for(let ht=0;ht<nt.length;ht++){const Dt=nt[ht];N.__webglColorRenderbuffer[ht]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,N.__webglColorRenderbuffer[ht]);const bt=r.convert(Dt.format,Dt.colorSpace),rt=r.convert(Dt.type),mt=T(Dt.internalFormat,bt,rt,Dt.colorSpace,R.isXRRenderTarget===!0),kt=Ee(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,kt,mt,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ht,i.RENDERBUFFER,N.__webglColorRenderbuffer[ht])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(N.__webglDepthRenderbuffer=i.createRenderbuffer(),Bt(N.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(tt){e.bindTexture(i.TEXTURE_CUBE_MAP,j.__webglTexture),yt(i.TEXTURE_CUBE_MAP,x);for(let ht=0;ht<6;ht++)if(x.mipmaps&&x.mipmaps.length>0)for(let Dt=0;Dt<x.mipmaps.length;Dt++)Et(N.__webglFramebuffer[ht][Dt],R,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,Dt);else Et(N.__webglFramebuffer[ht],R,x,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+ht,0);m(x)&&p(i.TEXTURE_CUBE_MAP),e.unbindTexture()}else if(Nt){for(let ht=0,Dt=nt.length;ht<Dt;ht++){const bt=nt[ht],rt=n.get(bt);let mt=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(mt=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(mt,rt.__webglTexture),yt(mt,bt),Et(N.__webglFramebuffer,R,bt,i.COLOR_ATTACHMENT0+ht,mt,0),m(bt)&&p(mt)}e.unbindTexture()}else{let ht=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ht=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(ht,j.__webglTexture),yt(ht,x),x.mipmaps&&x.mipmaps.length>0)for(let Dt=0;Dt<x.mipmaps.length;Dt++)Et(N.__webglFramebuffer[Dt],R,x,i.COLOR_ATTACHMENT0,ht,Dt);else Et(N.__webglFramebuffer,R,x,i.COLOR_ATTACHMENT0,ht,0);m(x)&&p(ht),e.unbindTexture()}R.depthBuffer&&Jt(R)}function fe(R){const x=R.textures;for(let N=0,j=x.length;N<j;N++){const nt=x[N];if(m(nt)){const tt=w(R),Nt=n.get(nt).__webglTexture;e.bindTexture(tt,Nt),p(tt),e.unbindTexture()}}}const $t=[],Wt=[];function It(R){if(R.samples>0){if(Ct(R)===!1){const x=R.textures,N=R.width,j=R.height;let nt=i.COLOR_BUFFER_BIT;const tt=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,Nt=n.get(R),ht=x.length>1;if(ht)for(let bt=0;bt<x.length;bt++)e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,Nt.__webglMultisampledFramebuffer);const Dt=R.texture.mipmaps;Dt&&Dt.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Nt.__webglFramebuffer);for(let bt=0;bt<x.length;bt++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(nt|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(nt|=i.STENCIL_BUFFER_BIT)),ht){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,Nt.__webglColorRenderbuffer[bt]);const rt=n.get(x[bt]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,rt,0)}i.blitFramebuffer(0,0,N,j,0,0,N,j,nt,i.NEAREST),l===!0&&($t.length=0,Wt.length=0,$t.push(i.COLOR_ATTACHMENT0+bt),R.depthBuffer&&R.resolveDepthBuffer===!1&&($t.push(tt),Wt.push(tt),i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,Wt)),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,$t))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),ht)for(let bt=0;bt<x.length;bt++){e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.RENDERBUFFER,Nt.__webglColorRenderbuffer[bt]);const rt=n.get(x[bt]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,Nt.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+bt,i.TEXTURE_2D,rt,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,Nt.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.resolveDepthBuffer===!1&&l){const x=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[x])}}}function Ee(R){return Math.min(s.maxSamples,R.samples)}function Ct(R){const x=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&x.__useRenderToTexture!==!1}function Vt(R){const x=o.render.frame;u.get(R)!==x&&(u.set(R,x),R.update())}function Fe(R,x){const N=R.colorSpace,j=R.format,nt=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||N!==wr&&N!==ls&&(ge.getTransfer(N)===Ae?(j!==si||nt!==Ri)&&console.warn("THREE.WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):console.error("THREE.WebGLTextures: Unsupported texture color space:",N)),x}function xe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=H,this.resetTextureUnits=G,this.setTexture2D=W,this.setTexture2DArray=Z,this.setTexture3D=Y,this.setTextureCube=J,this.rebindTextures=Le,this.setupRenderTarget=L,this.updateRenderTargetMipmap=fe,this.updateMultisampleRenderTarget=It,this.setupDepthRenderbuffer=Jt,this.setupFrameBufferTexture=Et,this.useMultisampledRTT=Ct}function FS(i,t){function e(n,s=ls){let r;const o=ge.getTransfer(s);if(n===Ri)return i.UNSIGNED_BYTE;if(n===mh)return i.UNSIGNED_SHORT_4_4_4_4;if(n===gh)return i.UNSIGNED_SHORT_5_5_5_1;if(n===Kd)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===Zd)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===$d)return i.BYTE;if(n===jd)return i.SHORT;if(n===go)return i.UNSIGNED_SHORT;if(n===ph)return i.INT;if(n===Ns)return i.UNSIGNED_INT;if(n===zi)return i.FLOAT;if(n===To)return i.HALF_FLOAT;if(n===Jd)return i.ALPHA;if(n===Qd)return i.RGB;if(n===si)return i.RGBA;if(n===vo)return i.DEPTH_COMPONENT;if(n===xo)return i.DEPTH_STENCIL;if(n===tp)return i.RED;if(n===_h)return i.RED_INTEGER;if(n===ep)return i.RG;if(n===vh)return i.RG_INTEGER;if(n===xh)return i.RGBA_INTEGER;if(n===ga||n===_a||n===va||n===xa)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===ga)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===_a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===xa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===ga)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===_a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===va)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===xa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===vc||n===xc||n===yc||n===Mc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===vc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===xc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===yc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Mc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Sc||n===Ec||n===wc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Sc||n===Ec)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===wc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC}else return null;if(n===Tc||n===bc||n===Ac||n===Rc||n===Cc||n===Pc||n===Dc||n===Lc||n===Uc||n===Ic||n===Nc||n===Fc||n===Oc||n===kc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Tc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===Dc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Uc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===Fc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Oc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===kc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===Bc||n===zc||n===Hc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===Bc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===zc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===Hc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===Vc||n===Gc||n===Wc||n===Xc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===Vc)return r.COMPRESSED_RED_RGTC1_EXT;if(n===Gc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Wc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Xc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===_o?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}const OS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,kS=`
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

}`;class BS{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){const n=new _p(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){const e=t.cameras[0].viewport,n=new qi({vertexShader:OS,fragmentShader:kS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Yn(new Ha(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}}class zS extends zs{constructor(t,e){super();const n=this;let s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,h=null,f=null,d=null,g=null;const v=typeof XRWebGLBinding<"u",m=new BS,p={},w=e.getContextAttributes();let T=null,M=null;const U=[],D=[],I=new Rt;let k=null;const b=new Xn;b.viewport=new Ye;const E=new Xn;E.viewport=new Ye;const C=[b,E],G=new ov;let H=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let et=U[Q];return et===void 0&&(et=new Il,U[Q]=et),et.getTargetRaySpace()},this.getControllerGrip=function(Q){let et=U[Q];return et===void 0&&(et=new Il,U[Q]=et),et.getGripSpace()},this.getHand=function(Q){let et=U[Q];return et===void 0&&(et=new Il,U[Q]=et),et.getHandSpace()};function W(Q){const et=D.indexOf(Q.inputSource);if(et===-1)return;const Et=U[et];Et!==void 0&&(Et.update(Q.inputSource,Q.frame,c||o),Et.dispatchEvent({type:Q.type,data:Q.inputSource}))}function Z(){s.removeEventListener("select",W),s.removeEventListener("selectstart",W),s.removeEventListener("selectend",W),s.removeEventListener("squeeze",W),s.removeEventListener("squeezestart",W),s.removeEventListener("squeezeend",W),s.removeEventListener("end",Z),s.removeEventListener("inputsourceschange",Y);for(let Q=0;Q<U.length;Q++){const et=D[Q];et!==null&&(D[Q]=null,U[Q].disconnect(et))}H=null,$=null,m.reset();for(const Q in p)delete p[Q];t.setRenderTarget(T),d=null,f=null,h=null,s=null,M=null,Zt.stop(),n.isPresenting=!1,t.setPixelRatio(k),t.setSize(I.width,I.height,!1),n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,n.isPresenting===!0&&console.warn("THREE.WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return h===null&&v&&(h=new XRWebGLBinding(s,e)),h},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(T=t.getRenderTarget(),s.addEventListener("select",W),s.addEventListener("selectstart",W),s.addEventListener("selectend",W),s.addEventListener("squeeze",W),s.addEventListener("squeezestart",W),s.addEventListener("squeezeend",W),s.addEventListener("end",Z),s.addEventListener("inputsourceschange",Y),w.xrCompatible!==!0&&await e.makeXRCompatible(),k=t.getPixelRatio(),t.getSize(I),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let Et=null,Bt=null,vt=null;w.depth&&(vt=w.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Et=w.stencil?xo:vo,Bt=w.stencil?_o:Ns);const Jt={colorFormat:e.RGBA8,depthFormat:vt,scaleFactor:r};h=this.getBinding(),f=h.createProjectionLayer(Jt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new Os(f.textureWidth,f.textureHeight,{format:si,type:Ri,depthTexture:new gp(f.textureWidth,f.textureHeight,Bt,void 0,void 0,void 0,void 0,void 0,void 0,Et),stencilBuffer:w.stencil,colorSpace:t.outputColorSpace,samples:w.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1})}else{const Et={antialias:w.antialias,alpha:!0,depth:w.depth,stencil:w.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,Et),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new Os(d.framebufferWidth,d.framebufferHeight,{format:si,type:Ri,colorSpace:t.outputColorSpace,stencilBuffer:w.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Zt.setContext(s),Zt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function Y(Q){for(let et=0;et<Q.removed.length;et++){const Et=Q.removed[et],Bt=D.indexOf(Et);Bt>=0&&(D[Bt]=null,U[Bt].disconnect(Et))}for(let et=0;et<Q.added.length;et++){const Et=Q.added[et];let Bt=D.indexOf(Et);if(Bt===-1){for(let Jt=0;Jt<U.length;Jt++)if(Jt>=D.length){D.push(Et),Bt=Jt;break}else if(D[Jt]===null){D[Jt]=Et,Bt=Jt;break}if(Bt===-1)break}const vt=U[Bt];vt&&vt.connect(Et)}}const J=new z,ot=new z;function at(Q,et,Et){J.setFromMatrixPosition(et.matrixWorld),ot.setFromMatrixPosition(Et.matrixWorld);const Bt=J.distanceTo(ot),vt=et.projectionMatrix.elements,Jt=Et.projectionMatrix.elements,Le=vt[14]/(vt[10]-1),L=vt[14]/(vt[10]+1),fe=(vt[9]+1)/vt[5],$t=(vt[9]-1)/vt[5],Wt=(vt[8]-1)/vt[0],It=(Jt[8]+1)/Jt[0],Ee=Le*Wt,Ct=Le*It,Vt=Bt/(-Wt+It),Fe=Vt*-Wt;if(et.matrixWorld.decompose(Q.position,Q.quaternion,Q.scale),Q.translateX(Fe),Q.translateZ(Vt),Q.matrixWorld.compose(Q.position,Q.quaternion,Q.scale),Q.matrixWorldInverse.copy(Q.matrixWorld).invert(),vt[10]===-1)Q.projectionMatrix.copy(et.projectionMatrix),Q.projectionMatrixInverse.copy(et.projectionMatrixInverse);else{const xe=Le+Vt,R=L+Vt,x=Ee-Fe,N=Ct+(Bt-Fe),j=fe*L/R*xe,nt=$t*L/R*xe;Q.projectionMatrix.makePerspective(x,N,j,nt,xe,R),Q.projectionMatrixInverse.copy(Q.projectionMatrix).invert()}}function _t(Q,et){et===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(et.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let et=Q.near,Et=Q.far;m.texture!==null&&(m.depthNear>0&&(et=m.depthNear),m.depthFar>0&&(Et=m.depthFar)),G.near=E.near=b.near=et,G.far=E.far=b.far=Et,(H!==G.near||$!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),H=G.near,$=G.far),G.layers.mask=Q.layers.mask|6,b.layers.mask=G.layers.mask&3,E.layers.mask=G.layers.mask&5;const Bt=Q.parent,vt=G.cameras;_t(G,Bt);for(let Jt=0;Jt<vt.length;Jt++)_t(vt[Jt],Bt);vt.length===2?at(G,b,E):G.projectionMatrix.copy(b.projectionMatrix),yt(Q,G,Bt)};function yt(Q,et,Et){Et===null?Q.matrix.copy(et.matrixWorld):(Q.matrix.copy(Et.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(et.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(et.projectionMatrix),Q.projectionMatrixInverse.copy(et.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=Yc*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(Q){l=Q,f!==null&&(f.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(G)},this.getCameraTexture=function(Q){return p[Q]};let gt=null;function ee(Q,et){if(u=et.getViewerPose(c||o),g=et,u!==null){const Et=u.views;d!==null&&(t.setRenderTargetFramebuffer(M,d.framebuffer),t.setRenderTarget(M));let Bt=!1;Et.length!==G.cameras.length&&(G.cameras.length=0,Bt=!0);for(let L=0;L<Et.length;L++){const fe=Et[L];let $t=null;if(d!==null)$t=d.getViewport(fe);else{const It=h.getViewSubImage(f,fe);$t=It.viewport,L===0&&(t.setRenderTargetTextures(M,It.colorTexture,It.depthStencilTexture),t.setRenderTarget(M))}let Wt=C[L];Wt===void 0&&(Wt=new Xn,Wt.layers.enable(L),Wt.viewport=new Ye,C[L]=Wt),Wt.matrix.fromArray(fe.transform.matrix),Wt.matrix.decompose(Wt.position,Wt.quaternion,Wt.scale),Wt.projectionMatrix.fromArray(fe.projectionMatrix),Wt.projectionMatrixInverse.copy(Wt.projectionMatrix).invert(),Wt.viewport.set($t.x,$t.y,$t.width,$t.height),L===0&&(G.matrix.copy(Wt.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),Bt===!0&&G.cameras.push(Wt)}const vt=s.enabledFeatures;if(vt&&vt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){h=n.getBinding();const L=h.getDepthInformation(Et[0]);L&&L.isValid&&L.texture&&m.init(L,s.renderState)}if(vt&&vt.includes("camera-access")&&v){t.state.unbindTexture(),h=n.getBinding();for(let L=0;L<Et.length;L++){const fe=Et[L].camera;if(fe){let $t=p[fe];$t||($t=new _p,p[fe]=$t);const Wt=h.getCameraImage(fe);$t.sourceTexture=Wt}}}}for(let Et=0;Et<U.length;Et++){const Bt=D[Et],vt=U[Et];Bt!==null&&vt!==void 0&&vt.update(Bt,et,c||o)}gt&&gt(Q,et),et.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:et}),g=null}const Zt=new Rp;Zt.setAnimationLoop(ee),this.setAnimationLoop=function(Q){gt=Q},this.dispose=function(){}}}const Ts=new Yi,HS=new Xe;function VS(i,t){function e(m,p){m.matrixAutoUpdate===!0&&m.updateMatrix(),p.value.copy(m.matrix)}function n(m,p){p.color.getRGB(m.fogColor.value,cp(i)),p.isFog?(m.fogNear.value=p.near,m.fogFar.value=p.far):p.isFogExp2&&(m.fogDensity.value=p.density)}function s(m,p,w,T,M){p.isMeshBasicMaterial||p.isMeshLambertMaterial?r(m,p):p.isMeshToonMaterial?(r(m,p),h(m,p)):p.isMeshPhongMaterial?(r(m,p),u(m,p)):p.isMeshStandardMaterial?(r(m,p),f(m,p),p.isMeshPhysicalMaterial&&d(m,p,M)):p.isMeshMatcapMaterial?(r(m,p),g(m,p)):p.isMeshDepthMaterial?r(m,p):p.isMeshDistanceMaterial?(r(m,p),v(m,p)):p.isMeshNormalMaterial?r(m,p):p.isLineBasicMaterial?(o(m,p),p.isLineDashedMaterial&&a(m,p)):p.isPointsMaterial?l(m,p,w,T):p.isSpriteMaterial?c(m,p):p.isShadowMaterial?(m.color.value.copy(p.color),m.opacity.value=p.opacity):p.isShaderMaterial&&(p.uniformsNeedUpdate=!1)}function r(m,p){m.opacity.value=p.opacity,p.color&&m.diffuse.value.copy(p.color),p.emissive&&m.emissive.value.copy(p.emissive).multiplyScalar(p.emissiveIntensity),p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.bumpMap&&(m.bumpMap.value=p.bumpMap,e(p.bumpMap,m.bumpMapTransform),m.bumpScale.value=p.bumpScale,p.side===Nn&&(m.bumpScale.value*=-1)),p.normalMap&&(m.normalMap.value=p.normalMap,e(p.normalMap,m.normalMapTransform),m.normalScale.value.copy(p.normalScale),p.side===Nn&&m.normalScale.value.negate()),p.displacementMap&&(m.displacementMap.value=p.displacementMap,e(p.displacementMap,m.displacementMapTransform),m.displacementScale.value=p.displacementScale,m.displacementBias.value=p.displacementBias),p.emissiveMap&&(m.emissiveMap.value=p.emissiveMap,e(p.emissiveMap,m.emissiveMapTransform)),p.specularMap&&(m.specularMap.value=p.specularMap,e(p.specularMap,m.specularMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest);const w=t.get(p),T=w.envMap,M=w.envMapRotation;T&&(m.envMap.value=T,Ts.copy(M),Ts.x*=-1,Ts.y*=-1,Ts.z*=-1,T.isCubeTexture&&T.isRenderTargetTexture===!1&&(Ts.y*=-1,Ts.z*=-1),m.envMapRotation.value.setFromMatrix4(HS.makeRotationFromEuler(Ts)),m.flipEnvMap.value=T.isCubeTexture&&T.isRenderTargetTexture===!1?-1:1,m.reflectivity.value=p.reflectivity,m.ior.value=p.ior,m.refractionRatio.value=p.refractionRatio),p.lightMap&&(m.lightMap.value=p.lightMap,m.lightMapIntensity.value=p.lightMapIntensity,e(p.lightMap,m.lightMapTransform)),p.aoMap&&(m.aoMap.value=p.aoMap,m.aoMapIntensity.value=p.aoMapIntensity,e(p.aoMap,m.aoMapTransform))}function o(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform))}function a(m,p){m.dashSize.value=p.dashSize,m.totalSize.value=p.dashSize+p.gapSize,m.scale.value=p.scale}function l(m,p,w,T){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.size.value=p.size*w,m.scale.value=T*.5,p.map&&(m.map.value=p.map,e(p.map,m.uvTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function c(m,p){m.diffuse.value.copy(p.color),m.opacity.value=p.opacity,m.rotation.value=p.rotation,p.map&&(m.map.value=p.map,e(p.map,m.mapTransform)),p.alphaMap&&(m.alphaMap.value=p.alphaMap,e(p.alphaMap,m.alphaMapTransform)),p.alphaTest>0&&(m.alphaTest.value=p.alphaTest)}function u(m,p){m.specular.value.copy(p.specular),m.shininess.value=Math.max(p.shininess,1e-4)}function h(m,p){p.gradientMap&&(m.gradientMap.value=p.gradientMap)}function f(m,p){m.metalness.value=p.metalness,p.metalnessMap&&(m.metalnessMap.value=p.metalnessMap,e(p.metalnessMap,m.metalnessMapTransform)),m.roughness.value=p.roughness,p.roughnessMap&&(m.roughnessMap.value=p.roughnessMap,e(p.roughnessMap,m.roughnessMapTransform)),p.envMap&&(m.envMapIntensity.value=p.envMapIntensity)}function d(m,p,w){m.ior.value=p.ior,p.sheen>0&&(m.sheenColor.value.copy(p.sheenColor).multiplyScalar(p.sheen),m.sheenRoughness.value=p.sheenRoughness,p.sheenColorMap&&(m.sheenColorMap.value=p.sheenColorMap,e(p.sheenColorMap,m.sheenColorMapTransform)),p.sheenRoughnessMap&&(m.sheenRoughnessMap.value=p.sheenRoughnessMap,e(p.sheenRoughnessMap,m.sheenRoughnessMapTransform))),p.clearcoat>0&&(m.clearcoat.value=p.clearcoat,m.clearcoatRoughness.value=p.clearcoatRoughness,p.clearcoatMap&&(m.clearcoatMap.value=p.clearcoatMap,e(p.clearcoatMap,m.clearcoatMapTransform)),p.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=p.clearcoatRoughnessMap,e(p.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),p.clearcoatNormalMap&&(m.clearcoatNormalMap.value=p.clearcoatNormalMap,e(p.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(p.clearcoatNormalScale),p.side===Nn&&m.clearcoatNormalScale.value.negate())),p.dispersion>0&&(m.dispersion.value=p.dispersion),p.iridescence>0&&(m.iridescence.value=p.iridescence,m.iridescenceIOR.value=p.iridescenceIOR,m.iridescenceThicknessMinimum.value=p.iridescenceThicknessRange[0],m.iridescenceThicknessMaximum.value=p.iridescenceThicknessRange[1],p.iridescenceMap&&(m.iridescenceMap.value=p.iridescenceMap,e(p.iridescenceMap,m.iridescenceMapTransform)),p.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=p.iridescenceThicknessMap,e(p.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),p.transmission>0&&(m.transmission.value=p.transmission,m.transmissionSamplerMap.value=w.texture,m.transmissionSamplerSize.value.set(w.width,w.height),p.transmissionMap&&(m.transmissionMap.value=p.transmissionMap,e(p.transmissionMap,m.transmissionMapTransform)),m.thickness.value=p.thickness,p.thicknessMap&&(m.thicknessMap.value=p.thicknessMap,e(p.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=p.attenuationDistance,m.attenuationColor.value.copy(p.attenuationColor)),p.anisotropy>0&&(m.anisotropyVector.value.set(p.anisotropy*Math.cos(p.anisotropyRotation),p.anisotropy*Math.sin(p.anisotropyRotation)),p.anisotropyMap&&(m.anisotropyMap.value=p.anisotropyMap,e(p.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=p.specularIntensity,m.specularColor.value.copy(p.specularColor),p.specularColorMap&&(m.specularColorMap.value=p.specularColorMap,e(p.specularColorMap,m.specularColorMapTransform)),p.specularIntensityMap&&(m.specularIntensityMap.value=p.specularIntensityMap,e(p.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,p){p.matcap&&(m.matcap.value=p.matcap)}function v(m,p){const w=t.get(p).light;m.referencePosition.value.setFromMatrixPosition(w.matrixWorld),m.nearDistance.value=w.shadow.camera.near,m.farDistance.value=w.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function GS(i,t,e,n){let s={},r={},o=[];const a=i.getParameter(i.MAX_UNIFORM_BUFFER_BINDINGS);function l(w,T){const M=T.program;n.uniformBlockBinding(w,M)}function c(w,T){let M=s[w.id];M===void 0&&(g(w),M=u(w),s[w.id]=M,w.addEventListener("dispose",m));const U=T.program;n.updateUBOMapping(w,U);const D=t.render.frame;r[w.id]!==D&&(f(w),r[w.id]=D)}function u(w){const T=h();w.__bindingPointIndex=T;const M=i.createBuffer(),U=w.__size,D=w.usage;return i.bindBuffer(i.UNIFORM_BUFFER,M),i.bufferData(i.UNIFORM_BUFFER,U,D),i.bindBuffer(i.UNIFORM_BUFFER,null),i.bindBufferBase(i.UNIFORM_BUFFER,T,M),M}function h(){for(let w=0;w<a;w++)if(o.indexOf(w)===-1)return o.push(w),w;return console.error("THREE.WebGLRenderer: Maximum number of simultaneously usable uniforms groups reached."),0}function f(w){const T=s[w.id],M=w.uniforms,U=w.__cache;i.bindBuffer(i.UNIFORM_BUFFER,T);for(let D=0,I=M.length;D<I;D++){const k=Array.isArray(M[D])?M[D]:[M[D]];for(let b=0,E=k.length;b<E;b++){const C=k[b];if(d(C,D,b,U)===!0){const G=C.__offset,H=Array.isArray(C.value)?C.value:[C.value];let $=0;for(let W=0;W<H.length;W++){const Z=H[W],Y=v(Z);typeof Z=="number"||typeof Z=="boolean"?(C.__data[0]=Z,i.bufferSubData(i.UNIFORM_BUFFER,G+$,C.__data)):Z.isMatrix3?(C.__data[0]=Z.elements[0],C.__data[1]=Z.elements[1],C.__data[2]=Z.elements[2],C.__data[3]=0,C.__data[4]=Z.elements[3],C.__data[5]=Z.elements[4],C.__data[6]=Z.elements[5],C.__data[7]=0,C.__data[8]=Z.elements[6],C.__data[9]=Z.elements[7],C.__data[10]=Z.elements[8],C.__data[11]=0):(Z.toArray(C.__data,$),$+=Y.storage/Float32Array.BYTES_PER_ELEMENT)}i.bufferSubData(i.UNIFORM_BUFFER,G,C.__data)}}}i.bindBuffer(i.UNIFORM_BUFFER,null)}function d(w,T,M,U){const D=w.value,I=T+"_"+M;if(U[I]===void 0)return typeof D=="number"||typeof D=="boolean"?U[I]=D:U[I]=D.clone(),!0;{const k=U[I];if(typeof D=="number"||typeof D=="boolean"){if(k!==D)return U[I]=D,!0}else if(k.equals(D)===!1)return k.copy(D),!0}return!1}function g(w){const T=w.uniforms;let M=0;const U=16;for(let I=0,k=T.length;I<k;I++){const b=Array.isArray(T[I])?T[I]:[T[I]];for(let E=0,C=b.length;E<C;E++){const G=b[E],H=Array.isArray(G.value)?G.value:[G.value];for(let $=0,W=H.length;$<W;$++){const Z=H[$],Y=v(Z),J=M%U,ot=J%Y.boundary,at=J+ot;M+=ot,at!==0&&U-at<Y.storage&&(M+=U-at),G.__data=new Float32Array(Y.storage/Float32Array.BYTES_PER_ELEMENT),G.__offset=M,M+=Y.storage}}}const D=M%U;return D>0&&(M+=U-D),w.__size=M,w.__cache={},this}function v(w){const T={boundary:0,storage:0};return typeof w=="number"||typeof w=="boolean"?(T.boundary=4,T.storage=4):w.isVector2?(T.boundary=8,T.storage=8):w.isVector3||w.isColor?(T.boundary=16,T.storage=12):w.isVector4?(T.boundary=16,T.storage=16):w.isMatrix3?(T.boundary=48,T.storage=48):w.isMatrix4?(T.boundary=64,T.storage=64):w.isTexture?console.warn("THREE.WebGLRenderer: Texture samplers can not be part of an uniforms group."):console.warn("THREE.WebGLRenderer: Unsupported uniform value type.",w),T}function m(w){const T=w.target;T.removeEventListener("dispose",m);const M=o.indexOf(T.__bindingPointIndex);o.splice(M,1),i.deleteBuffer(s[T.id]),delete s[T.id],delete r[T.id]}function p(){for(const w in s)i.deleteBuffer(s[w]);o=[],s={},r={}}return{bind:l,update:c,dispose:p}}class Up{constructor(t={}){const{canvas:e=Y_(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:h=!1,reversedDepthBuffer:f=!1}=t;this.isWebGLRenderer=!0;let d;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");d=n.getContextAttributes().alpha}else d=o;const g=new Uint32Array(4),v=new Int32Array(4);let m=null,p=null;const w=[],T=[];this.domElement=e,this.debug={checkShaderErrors:!0,onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=us,this.toneMappingExposure=1,this.transmissionResolutionScale=1;const M=this;let U=!1;this._outputColorSpace=Wn;let D=0,I=0,k=null,b=-1,E=null;const C=new Ye,G=new Ye;let H=null;const $=new ve(0);let W=0,Z=e.width,Y=e.height,J=1,ot=null,at=null;const _t=new Ye(0,0,Z,Y),yt=new Ye(0,0,Z,Y);let gt=!1;const ee=new dp;let Zt=!1,Q=!1;const et=new Xe,Et=new z,Bt=new Ye,vt={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0};let Jt=!1;function Le(){return k===null?J:1}let L=n;function fe(S,B){return e.getContext(S,B)}try{const S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:h};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${dh}`),e.addEventListener("webglcontextlost",dt,!1),e.addEventListener("webglcontextrestored",Pt,!1),e.addEventListener("webglcontextcreationerror",ct,!1),L===null){const B="webgl2";if(L=fe(B,S),L===null)throw fe(B)?new Error("Error creating WebGL context with your selected attributes."):new Error("Error creating WebGL context.")}}catch(S){throw console.error("THREE.WebGLRenderer: "+S.message),S}let $t,Wt,It,Ee,Ct,Vt,Fe,xe,R,x,N,j,nt,tt,Nt,ht,Dt,bt,rt,mt,kt,Ot,xt,Kt;function F(){$t=new tM(L),$t.init(),Ot=new FS(L,$t),Wt=new qy(L,$t,t,Ot),It=new IS(L,$t),Wt.reversedDepthBuffer&&f&&It.buffers.depth.setReversed(!0),Ee=new iM(L),Ct=new MS,Vt=new NS(L,$t,It,Ct,Wt,Ot,Ee),Fe=new jy(M),xe=new Qy(M),R=new cv(L),xt=new Xy(L,R),x=new eM(L,R,Ee,xt),N=new rM(L,x,R,Ee),rt=new sM(L,Wt,Vt),ht=new $y(Ct),j=new yS(M,Fe,xe,$t,Wt,xt,ht),nt=new VS(M,Ct),tt=new ES,Nt=new CS($t),bt=new Wy(M,Fe,xe,It,N,d,l),Dt=new LS(M,N,Wt),Kt=new GS(L,Ee,Wt,It),mt=new Yy(L,$t,Ee),kt=new nM(L,$t,Ee),Ee.programs=j.programs,M.capabilities=Wt,M.extensions=$t,M.properties=Ct,M.renderLists=tt,M.shadowMap=Dt,M.state=It,M.info=Ee}F();const ut=new zS(M,L);this.xr=ut,this.getContext=function(){return L},this.getContextAttributes=function(){return L.getContextAttributes()},this.forceContextLoss=function(){const S=$t.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){const S=$t.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return J},this.setPixelRatio=function(S){S!==void 0&&(J=S,this.setSize(Z,Y,!1))},this.getSize=function(S){return S.set(Z,Y)},this.setSize=function(S,B,K=!0){if(ut.isPresenting){console.warn("THREE.WebGLRenderer: Can't change size while VR device is presenting.");return}Z=S,Y=B,e.width=Math.floor(S*J),e.height=Math.floor(B*J),K===!0&&(e.style.width=S+"px",e.style.height=B+"px"),this.setViewport(0,0,S,B)},this.getDrawingBufferSize=function(S){return S.set(Z*J,Y*J).floor()},this.setDrawingBufferSize=function(S,B,K){Z=S,Y=B,J=K,e.width=Math.floor(S*K),e.height=Math.floor(B*K),this.setViewport(0,0,S,B)},this.getCurrentViewport=function(S){return S.copy(C)},this.getViewport=function(S){return S.copy(_t)},this.setViewport=function(S,B,K,q){S.isVector4?_t.set(S.x,S.y,S.z,S.w):_t.set(S,B,K,q),It.viewport(C.copy(_t).multiplyScalar(J).round())},this.getScissor=function(S){return S.copy(yt)},this.setScissor=function(S,B,K,q){S.isVector4?yt.set(S.x,S.y,S.z,S.w):yt.set(S,B,K,q),It.scissor(G.copy(yt).multiplyScalar(J).round())},this.getScissorTest=function(){return gt},this.setScissorTest=function(S){It.setScissorTest(gt=S)},this.setOpaqueSort=function(S){ot=S},this.setTransparentSort=function(S){at=S},this.getClearColor=function(S){return S.copy(bt.getClearColor())},this.setClearColor=function(){bt.setClearColor(...arguments)},this.getClearAlpha=function(){return bt.getClearAlpha()},this.setClearAlpha=function(){bt.setClearAlpha(...arguments)},this.clear=function(S=!0,B=!0,K=!0){let q=0;if(S){let V=!1;if(k!==null){const ft=k.texture.format;V=ft===xh||ft===vh||ft===_h}if(V){const ft=k.texture.type,Mt=ft===Ri||ft===Ns||ft===go||ft===_o||ft===mh||ft===gh,Lt=bt.getClearColor(),wt=bt.getClearAlpha(),Yt=Lt.r,qt=Lt.g,zt=Lt.b;Mt?(g[0]=Yt,g[1]=qt,g[2]=zt,g[3]=wt,L.clearBufferuiv(L.COLOR,0,g)):(v[0]=Yt,v[1]=qt,v[2]=zt,v[3]=wt,L.clearBufferiv(L.COLOR,0,v))}else q|=L.COLOR_BUFFER_BIT}B&&(q|=L.DEPTH_BUFFER_BIT),K&&(q|=L.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),L.clear(q)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.dispose=function(){e.removeEventListener("webglcontextlost",dt,!1),e.removeEventListener("webglcontextrestored",Pt,!1),e.removeEventListener("webglcontextcreationerror",ct,!1),bt.dispose(),tt.dispose(),Nt.dispose(),Ct.dispose(),Fe.dispose(),xe.dispose(),N.dispose(),xt.dispose(),Kt.dispose(),j.dispose(),ut.dispose(),ut.removeEventListener("sessionstart",Ce),ut.removeEventListener("sessionend",On),Dn.stop()};function dt(S){S.preventDefault(),console.log("THREE.WebGLRenderer: Context Lost."),U=!0}function Pt(){console.log("THREE.WebGLRenderer: Context Restored."),U=!1;const S=Ee.autoReset,B=Dt.enabled,K=Dt.autoUpdate,q=Dt.needsUpdate,V=Dt.type;F(),Ee.autoReset=S,Dt.enabled=B,Dt.autoUpdate=K,Dt.needsUpdate=q,Dt.type=V}function ct(S){console.error("THREE.WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function st(S){const B=S.target;B.removeEventListener("dispose",st),Ft(B)}function Ft(S){Qt(S),Ct.remove(S)}function Qt(S){const B=Ct.get(S).programs;B!==void 0&&(B.forEach(function(K){j.releaseProgram(K)}),S.isShaderMaterial&&j.releaseShaderCache(S))}this.renderBufferDirect=function(S,B,K,q,V,ft){B===null&&(B=vt);const Mt=V.isMesh&&V.matrixWorld.determinant()<0,Lt=Di(S,B,K,q,V);It.setMaterial(q,Mt);let wt=K.index,Yt=1;if(q.wireframe===!0){if(wt=x.getWireframeAttribute(K),wt===void 0)return;Yt=2}const qt=K.drawRange,zt=K.attributes.position;let se=qt.start*Yt,pe=(qt.start+qt.count)*Yt;ft!==null&&(se=Math.max(se,ft.start*Yt),pe=Math.min(pe,(ft.start+ft.count)*Yt)),wt!==null?(se=Math.max(se,0),pe=Math.min(pe,wt.count)):zt!=null&&(se=Math.max(se,0),pe=Math.min(pe,zt.count));const Ue=pe-se;if(Ue<0||Ue===1/0)return;xt.setup(V,q,Lt,K,wt);let we,ne=mt;if(wt!==null&&(we=R.get(wt),ne=kt,ne.setIndex(we)),V.isMesh)q.wireframe===!0?(It.setLineWidth(q.wireframeLinewidth*Le()),ne.setMode(L.LINES)):ne.setMode(L.TRIANGLES);else if(V.isLine){let Xt=q.linewidth;Xt===void 0&&(Xt=1),It.setLineWidth(Xt*Le()),V.isLineSegments?ne.setMode(L.LINES):V.isLineLoop?ne.setMode(L.LINE_LOOP):ne.setMode(L.LINE_STRIP)}else V.isPoints?ne.setMode(L.POINTS):V.isSprite&&ne.setMode(L.TRIANGLES);if(V.isBatchedMesh)if(V._multiDrawInstances!==null)yo("THREE.WebGLRenderer: renderMultiDrawInstances has been deprecated and will be removed in r184. Append to renderMultiDraw arguments and use indirection."),ne.renderMultiDrawInstances(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount,V._multiDrawInstances);else if($t.get("WEBGL_multi_draw"))ne.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{const Xt=V._multiDrawStarts,Ie=V._multiDrawCounts,le=V._multiDrawCount,mn=wt?R.get(wt).bytesPerElement:1,$i=Ct.get(q).currentProgram.getUniforms();for(let Mn=0;Mn<le;Mn++)$i.setValue(L,"_gl_DrawID",Mn),ne.render(Xt[Mn]/mn,Ie[Mn])}else if(V.isInstancedMesh)ne.renderInstances(se,Ue,V.count);else if(K.isInstancedBufferGeometry){const Xt=K._maxInstanceCount!==void 0?K._maxInstanceCount:1/0,Ie=Math.min(K.instanceCount,Xt);ne.renderInstances(se,Ue,Ie)}else ne.render(se,Ue)};function Te(S,B,K){S.transparent===!0&&S.side===Ti&&S.forceSinglePass===!1?(S.side=Nn,S.needsUpdate=!0,ps(S,B,K),S.side=fs,S.needsUpdate=!0,ps(S,B,K),S.side=Ti):ps(S,B,K)}this.compile=function(S,B,K=null){K===null&&(K=S),p=Nt.get(K),p.init(B),T.push(p),K.traverseVisible(function(V){V.isLight&&V.layers.test(B.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),S!==K&&S.traverseVisible(function(V){V.isLight&&V.layers.test(B.layers)&&(p.pushLight(V),V.castShadow&&p.pushShadow(V))}),p.setupLights();const q=new Set;return S.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;const ft=V.material;if(ft)if(Array.isArray(ft))for(let Mt=0;Mt<ft.length;Mt++){const Lt=ft[Mt];Te(Lt,K,V),q.add(Lt)}else Te(ft,K,V),q.add(ft)}),p=T.pop(),q},this.compileAsync=function(S,B,K=null){const q=this.compile(S,B,K);return new Promise(V=>{function ft(){if(q.forEach(function(Mt){Ct.get(Mt).currentProgram.isReady()&&q.delete(Mt)}),q.size===0){V(S);return}setTimeout(ft,10)}$t.get("KHR_parallel_shader_compile")!==null?ft():setTimeout(ft,10)})};let de=null;function fn(S){de&&de(S)}function Ce(){Dn.stop()}function On(){Dn.start()}const Dn=new Rp;Dn.setAnimationLoop(fn),typeof self<"u"&&Dn.setContext(self),this.setAnimationLoop=function(S){de=S,ut.setAnimationLoop(S),S===null?Dn.stop():Dn.start()},ut.addEventListener("sessionstart",Ce),ut.addEventListener("sessionend",On),this.render=function(S,B){if(B!==void 0&&B.isCamera!==!0){console.error("THREE.WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ut.enabled===!0&&ut.isPresenting===!0&&(ut.cameraAutoUpdate===!0&&ut.updateCamera(B),B=ut.getCamera()),S.isScene===!0&&S.onBeforeRender(M,S,B,k),p=Nt.get(S,T.length),p.init(B),T.push(p),et.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),ee.setFromProjectionMatrix(et,Ai,B.reversedDepth),Q=this.localClippingEnabled,Zt=ht.init(this.clippingPlanes,Q),m=tt.get(S,w.length),m.init(),w.push(m),ut.enabled===!0&&ut.isPresenting===!0){const ft=M.xr.getDepthSensingMesh();ft!==null&&gi(ft,B,-1/0,M.sortObjects)}gi(S,B,0,M.sortObjects),m.finish(),M.sortObjects===!0&&m.sort(ot,at),Jt=ut.enabled===!1||ut.isPresenting===!1||ut.hasDepthSensing()===!1,Jt&&bt.addToRenderList(m,S),this.info.render.frame++,Zt===!0&&ht.beginShadows();const K=p.state.shadowsArray;Dt.render(K,S,B),Zt===!0&&ht.endShadows(),this.info.autoReset===!0&&this.info.reset();const q=m.opaque,V=m.transmissive;if(p.setupLights(),B.isArrayCamera){const ft=B.cameras;if(V.length>0)for(let Mt=0,Lt=ft.length;Mt<Lt;Mt++){const wt=ft[Mt];Pi(q,V,S,wt)}Jt&&bt.render(S);for(let Mt=0,Lt=ft.length;Mt<Lt;Mt++){const wt=ft[Mt];yn(m,S,wt,wt.viewport)}}else V.length>0&&Pi(q,V,S,B),Jt&&bt.render(S),yn(m,S,B);k!==null&&I===0&&(Vt.updateMultisampleRenderTarget(k),Vt.updateRenderTargetMipmap(k)),S.isScene===!0&&S.onAfterRender(M,S,B),xt.resetDefaultState(),b=-1,E=null,T.pop(),T.length>0?(p=T[T.length-1],Zt===!0&&ht.setGlobalState(M.clippingPlanes,p.state.camera)):p=null,w.pop(),w.length>0?m=w[w.length-1]:m=null};function gi(S,B,K,q){if(S.visible===!1)return;if(S.layers.test(B.layers)){if(S.isGroup)K=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(B);else if(S.isLight)p.pushLight(S),S.castShadow&&p.pushShadow(S);else if(S.isSprite){if(!S.frustumCulled||ee.intersectsSprite(S)){q&&Bt.setFromMatrixPosition(S.matrixWorld).applyMatrix4(et);const Mt=N.update(S),Lt=S.material;Lt.visible&&m.push(S,Mt,Lt,K,Bt.z,null)}}else if((S.isMesh||S.isLine||S.isPoints)&&(!S.frustumCulled||ee.intersectsObject(S))){const Mt=N.update(S),Lt=S.material;if(q&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Bt.copy(S.boundingSphere.center)):(Mt.boundingSphere===null&&Mt.computeBoundingSphere(),Bt.copy(Mt.boundingSphere.center)),Bt.applyMatrix4(S.matrixWorld).applyMatrix4(et)),Array.isArray(Lt)){const wt=Mt.groups;for(let Yt=0,qt=wt.length;Yt<qt;Yt++){const zt=wt[Yt],se=Lt[zt.materialIndex];se&&se.visible&&m.push(S,Mt,se,K,Bt.z,zt)}}else Lt.visible&&m.push(S,Mt,Lt,K,Bt.z,null)}}const ft=S.children;for(let Mt=0,Lt=ft.length;Mt<Lt;Mt++)gi(ft[Mt],B,K,q)}function yn(S,B,K,q){const V=S.opaque,ft=S.transmissive,Mt=S.transparent;p.setupLightsView(K),Zt===!0&&ht.setGlobalState(M.clippingPlanes,K),q&&It.viewport(C.copy(q)),V.length>0&&oi(V,B,K),ft.length>0&&oi(ft,B,K),Mt.length>0&&oi(Mt,B,K),It.buffers.depth.setTest(!0),It.buffers.depth.setMask(!0),It.buffers.color.setMask(!0),It.setPolygonOffset(!1)}function Pi(S,B,K,q){if((K.isScene===!0?K.overrideMaterial:null)!==null)return;p.state.transmissionRenderTarget[q.id]===void 0&&(p.state.transmissionRenderTarget[q.id]=new Os(1,1,{generateMipmaps:!0,type:$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float")?To:Ri,minFilter:Us,samples:4,stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,colorSpace:ge.workingColorSpace}));const ft=p.state.transmissionRenderTarget[q.id],Mt=q.viewport||C;ft.setSize(Mt.z*M.transmissionResolutionScale,Mt.w*M.transmissionResolutionScale);const Lt=M.getRenderTarget(),wt=M.getActiveCubeFace(),Yt=M.getActiveMipmapLevel();M.setRenderTarget(ft),M.getClearColor($),W=M.getClearAlpha(),W<1&&M.setClearColor(16777215,.5),M.clear(),Jt&&bt.render(K);const qt=M.toneMapping;M.toneMapping=us;const zt=q.viewport;if(q.viewport!==void 0&&(q.viewport=void 0),p.setupLightsView(q),Zt===!0&&ht.setGlobalState(M.clippingPlanes,q),oi(S,K,q),Vt.updateMultisampleRenderTarget(ft),Vt.updateRenderTargetMipmap(ft),$t.has("WEBGL_multisampled_render_to_texture")===!1){let se=!1;for(let pe=0,Ue=B.length;pe<Ue;pe++){const we=B[pe],ne=we.object,Xt=we.geometry,Ie=we.material,le=we.group;if(Ie.side===Ti&&ne.layers.test(q.layers)){const mn=Ie.side;Ie.side=Nn,Ie.needsUpdate=!0,zr(ne,K,q,Xt,Ie,le),Ie.side=mn,Ie.needsUpdate=!0,se=!0}}se===!0&&(Vt.updateMultisampleRenderTarget(ft),Vt.updateRenderTargetMipmap(ft))}M.setRenderTarget(Lt,wt,Yt),M.setClearColor($,W),zt!==void 0&&(q.viewport=zt),M.toneMapping=qt}function oi(S,B,K){const q=B.isScene===!0?B.overrideMaterial:null;for(let V=0,ft=S.length;V<ft;V++){const Mt=S[V],Lt=Mt.object,wt=Mt.geometry,Yt=Mt.group;let qt=Mt.material;qt.allowOverride===!0&&q!==null&&(qt=q),Lt.layers.test(K.layers)&&zr(Lt,B,K,wt,qt,Yt)}}function zr(S,B,K,q,V,ft){S.onBeforeRender(M,B,K,q,V,ft),S.modelViewMatrix.multiplyMatrices(K.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),V.onBeforeRender(M,B,K,q,S,ft),V.transparent===!0&&V.side===Ti&&V.forceSinglePass===!1?(V.side=Nn,V.needsUpdate=!0,M.renderBufferDirect(K,B,q,V,S,ft),V.side=fs,V.needsUpdate=!0,M.renderBufferDirect(K,B,q,V,S,ft),V.side=Ti):M.renderBufferDirect(K,B,q,V,S,ft),S.onAfterRender(M,B,K,q,V,ft)}function ps(S,B,K){B.isScene!==!0&&(B=vt);const q=Ct.get(S),V=p.state.lights,ft=p.state.shadowsArray,Mt=V.state.version,Lt=j.getParameters(S,V.state,ft,B,K),wt=j.getProgramCacheKey(Lt);let Yt=q.programs;q.environment=S.isMeshStandardMaterial?B.environment:null,q.fog=B.fog,q.envMap=(S.isMeshStandardMaterial?xe:Fe).get(S.envMap||q.environment),q.envMapRotation=q.environment!==null&&S.envMap===null?B.environmentRotation:S.envMapRotation,Yt===void 0&&(S.addEventListener("dispose",st),Yt=new Map,q.programs=Yt);let qt=Yt.get(wt);if(qt!==void 0){if(q.currentProgram===qt&&q.lightsStateVersion===Mt)return Po(S,Lt),qt}else Lt.uniforms=j.getUniforms(S),S.onBeforeCompile(Lt,M),qt=j.acquireProgram(Lt,wt),Yt.set(wt,qt),q.uniforms=Lt.uniforms;const zt=q.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(zt.clippingPlanes=ht.uniform),Po(S,Lt),q.needsLights=ms(S),q.lightsStateVersion=Mt,q.needsLights&&(zt.ambientLightColor.value=V.state.ambient,zt.lightProbe.value=V.state.probe,zt.directionalLights.value=V.state.directional,zt.directionalLightShadows.value=V.state.directionalShadow,zt.spotLights.value=V.state.spot,zt.spotLightShadows.value=V.state.spotShadow,zt.rectAreaLights.value=V.state.rectArea,zt.ltc_1.value=V.state.rectAreaLTC1,zt.ltc_2.value=V.state.rectAreaLTC2,zt.pointLights.value=V.state.point,zt.pointLightShadows.value=V.state.pointShadow,zt.hemisphereLights.value=V.state.hemi,zt.directionalShadowMap.value=V.state.directionalShadowMap,zt.directionalShadowMatrix.value=V.state.directionalShadowMatrix,zt.spotShadowMap.value=V.state.spotShadowMap,zt.spotLightMatrix.value=V.state.spotLightMatrix,zt.spotLightMap.value=V.state.spotLightMap,zt.pointShadowMap.value=V.state.pointShadowMap,zt.pointShadowMatrix.value=V.state.pointShadowMatrix),q.currentProgram=qt,q.uniformsList=null,qt}function Co(S){if(S.uniformsList===null){const B=S.currentProgram.getUniforms();S.uniformsList=Ma.seqWithValue(B.seq,S.uniforms)}return S.uniformsList}function Po(S,B){const K=Ct.get(S);K.outputColorSpace=B.outputColorSpace,K.batching=B.batching,K.batchingColor=B.batchingColor,K.instancing=B.instancing,K.instancingColor=B.instancingColor,K.instancingMorph=B.instancingMorph,K.skinning=B.skinning,K.morphTargets=B.morphTargets,K.morphNormals=B.morphNormals,K.morphColors=B.morphColors,K.morphTargetsCount=B.morphTargetsCount,K.numClippingPlanes=B.numClippingPlanes,K.numIntersection=B.numClipIntersection,K.vertexAlphas=B.vertexAlphas,K.vertexTangents=B.vertexTangents,K.toneMapping=B.toneMapping}function Di(S,B,K,q,V){B.isScene!==!0&&(B=vt),Vt.resetTextureUnits();const ft=B.fog,Mt=q.isMeshStandardMaterial?B.environment:null,Lt=k===null?M.outputColorSpace:k.isXRRenderTarget===!0?k.texture.colorSpace:wr,wt=(q.isMeshStandardMaterial?xe:Fe).get(q.envMap||Mt),Yt=q.vertexColors===!0&&!!K.attributes.color&&K.attributes.color.itemSize===4,qt=!!K.attributes.tangent&&(!!q.normalMap||q.anisotropy>0),zt=!!K.morphAttributes.position,se=!!K.morphAttributes.normal,pe=!!K.morphAttributes.color;let Ue=us;q.toneMapped&&(k===null||k.isXRRenderTarget===!0)&&(Ue=M.toneMapping);const we=K.morphAttributes.position||K.morphAttributes.normal||K.morphAttributes.color,ne=we!==void 0?we.length:0,Xt=Ct.get(q),Ie=p.state.lights;if(Zt===!0&&(Q===!0||S!==E)){const rn=S===E&&q.id===b;ht.setState(q,S,rn)}let le=!1;q.version===Xt.__version?(Xt.needsLights&&Xt.lightsStateVersion!==Ie.state.version||Xt.outputColorSpace!==Lt||V.isBatchedMesh&&Xt.batching===!1||!V.isBatchedMesh&&Xt.batching===!0||V.isBatchedMesh&&Xt.batchingColor===!0&&V.colorTexture===null||V.isBatchedMesh&&Xt.batchingColor===!1&&V.colorTexture!==null||V.isInstancedMesh&&Xt.instancing===!1||!V.isInstancedMesh&&Xt.instancing===!0||V.isSkinnedMesh&&Xt.skinning===!1||!V.isSkinnedMesh&&Xt.skinning===!0||V.isInstancedMesh&&Xt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&Xt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&Xt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&Xt.instancingMorph===!1&&V.morphTexture!==null||Xt.envMap!==wt||q.fog===!0&&Xt.fog!==ft||Xt.numClippingPlanes!==void 0&&(Xt.numClippingPlanes!==ht.numPlanes||Xt.numIntersection!==ht.numIntersection)||Xt.vertexAlphas!==Yt||Xt.vertexTangents!==qt||Xt.morphTargets!==zt||Xt.morphNormals!==se||Xt.morphColors!==pe||Xt.toneMapping!==Ue||Xt.morphTargetsCount!==ne)&&(le=!0):(le=!0,Xt.__version=q.version);let mn=Xt.currentProgram;le===!0&&(mn=ps(q,B,V));let $i=!1,Mn=!1,gs=!1;const Ne=mn.getUniforms(),Sn=Xt.uniforms;if(It.useProgram(mn.program)&&($i=!0,Mn=!0,gs=!0),q.id!==b&&(b=q.id,Mn=!0),$i||E!==S){It.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),Ne.setValue(L,"projectionMatrix",S.projectionMatrix),Ne.setValue(L,"viewMatrix",S.matrixWorldInverse);const on=Ne.map.cameraPosition;on!==void 0&&on.setValue(L,Et.setFromMatrixPosition(S.matrixWorld)),Wt.logarithmicDepthBuffer&&Ne.setValue(L,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(q.isMeshPhongMaterial||q.isMeshToonMaterial||q.isMeshLambertMaterial||q.isMeshBasicMaterial||q.isMeshStandardMaterial||q.isShaderMaterial)&&Ne.setValue(L,"isOrthographic",S.isOrthographicCamera===!0),E!==S&&(E=S,Mn=!0,gs=!0)}if(V.isSkinnedMesh){Ne.setOptional(L,V,"bindMatrix"),Ne.setOptional(L,V,"bindMatrixInverse");const rn=V.skeleton;rn&&(rn.boneTexture===null&&rn.computeBoneTexture(),Ne.setValue(L,"boneTexture",rn.boneTexture,Vt))}V.isBatchedMesh&&(Ne.setOptional(L,V,"batchingTexture"),Ne.setValue(L,"batchingTexture",V._matricesTexture,Vt),Ne.setOptional(L,V,"batchingIdTexture"),Ne.setValue(L,"batchingIdTexture",V._indirectTexture,Vt),Ne.setOptional(L,V,"batchingColorTexture"),V._colorsTexture!==null&&Ne.setValue(L,"batchingColorTexture",V._colorsTexture,Vt));const Ln=K.morphAttributes;if((Ln.position!==void 0||Ln.normal!==void 0||Ln.color!==void 0)&&rt.update(V,K,mn),(Mn||Xt.receiveShadow!==V.receiveShadow)&&(Xt.receiveShadow=V.receiveShadow,Ne.setValue(L,"receiveShadow",V.receiveShadow)),q.isMeshGouraudMaterial&&q.envMap!==null&&(Sn.envMap.value=wt,Sn.flipEnvMap.value=wt.isCubeTexture&&wt.isRenderTargetTexture===!1?-1:1),q.isMeshStandardMaterial&&q.envMap===null&&B.environment!==null&&(Sn.envMapIntensity.value=B.environmentIntensity),Mn&&(Ne.setValue(L,"toneMappingExposure",M.toneMappingExposure),Xt.needsLights&&Za(Sn,gs),ft&&q.fog===!0&&nt.refreshFogUniforms(Sn,ft),nt.refreshMaterialUniforms(Sn,q,J,Y,p.state.transmissionRenderTarget[S.id]),Ma.upload(L,Co(Xt),Sn,Vt)),q.isShaderMaterial&&q.uniformsNeedUpdate===!0&&(Ma.upload(L,Co(Xt),Sn,Vt),q.uniformsNeedUpdate=!1),q.isSpriteMaterial&&Ne.setValue(L,"center",V.center),Ne.setValue(L,"modelViewMatrix",V.modelViewMatrix),Ne.setValue(L,"normalMatrix",V.normalMatrix),Ne.setValue(L,"modelMatrix",V.matrixWorld),q.isShaderMaterial||q.isRawShaderMaterial){const rn=q.uniformsGroups;for(let on=0,ji=rn.length;on<ji;on++){const Kn=rn[on];Kt.update(Kn,mn),Kt.bind(Kn,mn)}}return mn}function Za(S,B){S.ambientLightColor.needsUpdate=B,S.lightProbe.needsUpdate=B,S.directionalLights.needsUpdate=B,S.directionalLightShadows.needsUpdate=B,S.pointLights.needsUpdate=B,S.pointLightShadows.needsUpdate=B,S.spotLights.needsUpdate=B,S.spotLightShadows.needsUpdate=B,S.rectAreaLights.needsUpdate=B,S.hemisphereLights.needsUpdate=B}function ms(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return D},this.getActiveMipmapLevel=function(){return I},this.getRenderTarget=function(){return k},this.setRenderTargetTextures=function(S,B,K){const q=Ct.get(S);q.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,q.__autoAllocateDepthBuffer===!1&&(q.__useRenderToTexture=!1),Ct.get(S.texture).__webglTexture=B,Ct.get(S.depthTexture).__webglTexture=q.__autoAllocateDepthBuffer?void 0:K,q.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,B){const K=Ct.get(S);K.__webglFramebuffer=B,K.__useDefaultFramebuffer=B===void 0};const Do=L.createFramebuffer();this.setRenderTarget=function(S,B=0,K=0){k=S,D=B,I=K;let q=!0,V=null,ft=!1,Mt=!1;if(S){const wt=Ct.get(S);if(wt.__useDefaultFramebuffer!==void 0)It.bindFramebuffer(L.FRAMEBUFFER,null),q=!1;else if(wt.__webglFramebuffer===void 0)Vt.setupRenderTarget(S);else if(wt.__hasExternalTextures)Vt.rebindTextures(S,Ct.get(S.texture).__webglTexture,Ct.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){const zt=S.depthTexture;if(wt.__boundDepthTexture!==zt){if(zt!==null&&Ct.has(zt)&&(S.width!==zt.image.width||S.height!==zt.image.height))throw new Error("WebGLRenderTarget: Attached DepthTexture is initialized to the incorrect size.");Vt.setupDepthRenderbuffer(S)}}const Yt=S.texture;(Yt.isData3DTexture||Yt.isDataArrayTexture||Yt.isCompressedArrayTexture)&&(Mt=!0);const qt=Ct.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(qt[B])?V=qt[B][K]:V=qt[B],ft=!0):S.samples>0&&Vt.useMultisampledRTT(S)===!1?V=Ct.get(S).__webglMultisampledFramebuffer:Array.isArray(qt)?V=qt[K]:V=qt,C.copy(S.viewport),G.copy(S.scissor),H=S.scissorTest}else C.copy(_t).multiplyScalar(J).floor(),G.copy(yt).multiplyScalar(J).floor(),H=gt;if(K!==0&&(V=Do),It.bindFramebuffer(L.FRAMEBUFFER,V)&&q&&It.drawBuffers(S,V),It.viewport(C),It.scissor(G),It.setScissorTest(H),ft){const wt=Ct.get(S.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_CUBE_MAP_POSITIVE_X+B,wt.__webglTexture,K)}else if(Mt){const wt=B;for(let Yt=0;Yt<S.textures.length;Yt++){const qt=Ct.get(S.textures[Yt]);L.framebufferTextureLayer(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0+Yt,qt.__webglTexture,K,wt)}}else if(S!==null&&K!==0){const wt=Ct.get(S.texture);L.framebufferTexture2D(L.FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,wt.__webglTexture,K)}b=-1},this.readRenderTargetPixels=function(S,B,K,q,V,ft,Mt,Lt=0){if(!(S&&S.isWebGLRenderTarget)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let wt=Ct.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Mt!==void 0&&(wt=wt[Mt]),wt){It.bindFramebuffer(L.FRAMEBUFFER,wt);try{const Yt=S.textures[Lt],qt=Yt.format,zt=Yt.type;if(!Wt.textureFormatReadable(qt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(!Wt.textureTypeReadable(zt)){console.error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=S.width-q&&K>=0&&K<=S.height-V&&(S.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Lt),L.readPixels(B,K,q,V,Ot.convert(qt),Ot.convert(zt),ft))}finally{const Yt=k!==null?Ct.get(k).__webglFramebuffer:null;It.bindFramebuffer(L.FRAMEBUFFER,Yt)}}},this.readRenderTargetPixelsAsync=async function(S,B,K,q,V,ft,Mt,Lt=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let wt=Ct.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&Mt!==void 0&&(wt=wt[Mt]),wt)if(B>=0&&B<=S.width-q&&K>=0&&K<=S.height-V){It.bindFramebuffer(L.FRAMEBUFFER,wt);const Yt=S.textures[Lt],qt=Yt.format,zt=Yt.type;if(!Wt.textureFormatReadable(qt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(!Wt.textureTypeReadable(zt))throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");const se=L.createBuffer();L.bindBuffer(L.PIXEL_PACK_BUFFER,se),L.bufferData(L.PIXEL_PACK_BUFFER,ft.byteLength,L.STREAM_READ),S.textures.length>1&&L.readBuffer(L.COLOR_ATTACHMENT0+Lt),L.readPixels(B,K,q,V,Ot.convert(qt),Ot.convert(zt),0);const pe=k!==null?Ct.get(k).__webglFramebuffer:null;It.bindFramebuffer(L.FRAMEBUFFER,pe);const Ue=L.fenceSync(L.SYNC_GPU_COMMANDS_COMPLETE,0);return L.flush(),await q_(L,Ue,4),L.bindBuffer(L.PIXEL_PACK_BUFFER,se),L.getBufferSubData(L.PIXEL_PACK_BUFFER,0,ft),L.deleteBuffer(se),L.deleteSync(Ue),ft}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,B=null,K=0){const q=Math.pow(2,-K),V=Math.floor(S.image.width*q),ft=Math.floor(S.image.height*q),Mt=B!==null?B.x:0,Lt=B!==null?B.y:0;Vt.setTexture2D(S,0),L.copyTexSubImage2D(L.TEXTURE_2D,K,0,0,Mt,Lt,V,ft),It.unbindTexture()};const _i=L.createFramebuffer(),Ke=L.createFramebuffer();this.copyTextureToTexture=function(S,B,K=null,q=null,V=0,ft=null){ft===null&&(V!==0?(yo("WebGLRenderer: copyTextureToTexture function signature has changed to support src and dst mipmap levels."),ft=V,V=0):ft=0);let Mt,Lt,wt,Yt,qt,zt,se,pe,Ue;const we=S.isCompressedTexture?S.mipmaps[ft]:S.image;if(K!==null)Mt=K.max.x-K.min.x,Lt=K.max.y-K.min.y,wt=K.isBox3?K.max.z-K.min.z:1,Yt=K.min.x,qt=K.min.y,zt=K.isBox3?K.min.z:0;else{const Ln=Math.pow(2,-V);Mt=Math.floor(we.width*Ln),Lt=Math.floor(we.height*Ln),S.isDataArrayTexture?wt=we.depth:S.isData3DTexture?wt=Math.floor(we.depth*Ln):wt=1,Yt=0,qt=0,zt=0}q!==null?(se=q.x,pe=q.y,Ue=q.z):(se=0,pe=0,Ue=0);const ne=Ot.convert(B.format),Xt=Ot.convert(B.type);let Ie;B.isData3DTexture?(Vt.setTexture3D(B,0),Ie=L.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Vt.setTexture2DArray(B,0),Ie=L.TEXTURE_2D_ARRAY):(Vt.setTexture2D(B,0),Ie=L.TEXTURE_2D),L.pixelStorei(L.UNPACK_FLIP_Y_WEBGL,B.flipY),L.pixelStorei(L.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),L.pixelStorei(L.UNPACK_ALIGNMENT,B.unpackAlignment);const le=L.getParameter(L.UNPACK_ROW_LENGTH),mn=L.getParameter(L.UNPACK_IMAGE_HEIGHT),$i=L.getParameter(L.UNPACK_SKIP_PIXELS),Mn=L.getParameter(L.UNPACK_SKIP_ROWS),gs=L.getParameter(L.UNPACK_SKIP_IMAGES);L.pixelStorei(L.UNPACK_ROW_LENGTH,we.width),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,we.height),L.pixelStorei(L.UNPACK_SKIP_PIXELS,Yt),L.pixelStorei(L.UNPACK_SKIP_ROWS,qt),L.pixelStorei(L.UNPACK_SKIP_IMAGES,zt);const Ne=S.isDataArrayTexture||S.isData3DTexture,Sn=B.isDataArrayTexture||B.isData3DTexture;if(S.isDepthTexture){const Ln=Ct.get(S),rn=Ct.get(B),on=Ct.get(Ln.__renderTarget),ji=Ct.get(rn.__renderTarget);It.bindFramebuffer(L.READ_FRAMEBUFFER,on.__webglFramebuffer),It.bindFramebuffer(L.DRAW_FRAMEBUFFER,ji.__webglFramebuffer);for(let Kn=0;Kn<wt;Kn++)Ne&&(L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ct.get(S).__webglTexture,V,zt+Kn),L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ct.get(B).__webglTexture,ft,Ue+Kn)),L.blitFramebuffer(Yt,qt,Mt,Lt,se,pe,Mt,Lt,L.DEPTH_BUFFER_BIT,L.NEAREST);It.bindFramebuffer(L.READ_FRAMEBUFFER,null),It.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else if(V!==0||S.isRenderTargetTexture||Ct.has(S)){const Ln=Ct.get(S),rn=Ct.get(B);It.bindFramebuffer(L.READ_FRAMEBUFFER,_i),It.bindFramebuffer(L.DRAW_FRAMEBUFFER,Ke);for(let on=0;on<wt;on++)Ne?L.framebufferTextureLayer(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,Ln.__webglTexture,V,zt+on):L.framebufferTexture2D(L.READ_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,Ln.__webglTexture,V),Sn?L.framebufferTextureLayer(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,rn.__webglTexture,ft,Ue+on):L.framebufferTexture2D(L.DRAW_FRAMEBUFFER,L.COLOR_ATTACHMENT0,L.TEXTURE_2D,rn.__webglTexture,ft),V!==0?L.blitFramebuffer(Yt,qt,Mt,Lt,se,pe,Mt,Lt,L.COLOR_BUFFER_BIT,L.NEAREST):Sn?L.copyTexSubImage3D(Ie,ft,se,pe,Ue+on,Yt,qt,Mt,Lt):L.copyTexSubImage2D(Ie,ft,se,pe,Yt,qt,Mt,Lt);It.bindFramebuffer(L.READ_FRAMEBUFFER,null),It.bindFramebuffer(L.DRAW_FRAMEBUFFER,null)}else Sn?S.isDataTexture||S.isData3DTexture?L.texSubImage3D(Ie,ft,se,pe,Ue,Mt,Lt,wt,ne,Xt,we.data):B.isCompressedArrayTexture?L.compressedTexSubImage3D(Ie,ft,se,pe,Ue,Mt,Lt,wt,ne,we.data):L.texSubImage3D(Ie,ft,se,pe,Ue,Mt,Lt,wt,ne,Xt,we):S.isDataTexture?L.texSubImage2D(L.TEXTURE_2D,ft,se,pe,Mt,Lt,ne,Xt,we.data):S.isCompressedTexture?L.compressedTexSubImage2D(L.TEXTURE_2D,ft,se,pe,we.width,we.height,ne,we.data):L.texSubImage2D(L.TEXTURE_2D,ft,se,pe,Mt,Lt,ne,Xt,we);L.pixelStorei(L.UNPACK_ROW_LENGTH,le),L.pixelStorei(L.UNPACK_IMAGE_HEIGHT,mn),L.pixelStorei(L.UNPACK_SKIP_PIXELS,$i),L.pixelStorei(L.UNPACK_SKIP_ROWS,Mn),L.pixelStorei(L.UNPACK_SKIP_IMAGES,gs),ft===0&&B.generateMipmaps&&L.generateMipmap(Ie),It.unbindTexture()},this.initRenderTarget=function(S){Ct.get(S).__webglFramebuffer===void 0&&Vt.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Vt.setTextureCube(S,0):S.isData3DTexture?Vt.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Vt.setTexture2DArray(S,0):Vt.setTexture2D(S,0),It.unbindTexture()},this.resetState=function(){D=0,I=0,k=null,It.reset(),xt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Ai}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;const e=this.getContext();e.drawingBufferColorSpace=ge._getDrawingBufferColorSpace(t),e.unpackColorSpace=ge._getUnpackColorSpace()}}let Cf=null;function Th(){return Cf??=WS(),Cf}function WS(){const i=document.createElement("canvas").getContext("webgl2");if(i===null)return"none";const t=i.getExtension("WEBGL_debug_renderer_info"),e=String(t?i.getParameter(t.UNMASKED_RENDERER_WEBGL):"");return i.getExtension("WEBGL_lose_context")?.loseContext(),/swiftshader|llvmpipe|software|basic render/i.test(e)?"software":"hardware"}const XS=ch(),YS=.6;class qS{constructor(t){this.changed=t,this.possible=Th()!=="none",this.moved=!1,this.renderer=null,this.scene=new fp,this.camera=new Xn(36,1,.1,20),this.material=new Tr({transparent:!0,side:Ti,depthWrite:!1}),this.wire=new Tr({wireframe:!0,transparent:!0,opacity:.07,depthWrite:!1}),this.mesh=new Yn(new Pa(1,.48,40,80),this.material),this.canvas=null,this.drag=e=>this.turn(e),this.mesh.add(new Yn(new Pa(1,.482,18,36),this.wire)),this.scene.add(this.mesh),this.camera.position.set(0,-3.5,3.5),this.camera.lookAt(0,0,0)}attach(t){this.detach(),this.canvas=t,t.style.touchAction="none",t.style.cursor="grab",t.addEventListener("pointermove",this.drag)}detach(){this.canvas?.removeEventListener("pointermove",this.drag),this.canvas=null}isOn(t){return this.canvas===t}draw(t,e,n){this.wire.color.set(n.ink),this.moved=!1,this.renderer??=new Up({antialias:!0,alpha:!0});const s=Math.min(t.canvas.width,t.canvas.height);this.renderer.setSize(s,s,!1),this.material.map?.dispose(),this.material.map=$S(e),this.material.needsUpdate=!0,this.renderer.render(this.scene,this.camera);const r=t.clear(),o=Math.min(t.width,t.height);r.drawImage(this.renderer.domElement,(t.width-o)/2,(t.height-o)/2,o,o)}turn(t){if(t.buttons!==1)return;const e=YS*Math.PI/180;this.mesh.rotation.z+=t.movementX*e,this.mesh.rotation.x=Math.max(-1,Math.min(1,this.mesh.rotation.x+t.movementY*e)),this.moved=!0,this.changed()}}function $S({shape:i,activity:t}){const[e,n]=i,s=t.reduce((a,l)=>Math.max(a,l),1e-9),r=new Uint8Array(t.length*4);for(let a=0;a<t.length;++a){const l=4*Math.round(255*Math.max(0,t[a]/s));for(let c=0;c<3;++c)r[4*a+c]=XS[l+c];r[4*a+3]=70+185*l/1020}const o=new v0(r,n,e,si,Ri);return o.colorSpace=Wn,o.magFilter=Fn,o.wrapS=o.wrapT=wa,o.needsUpdate=!0,o}const jS=8;class KS{constructor(t){this.changed=t,this.root=Gt("cells"),this.listed=Gt("cells-listed"),this.empty=Gt("cells-empty"),this.legend=Gt("bumps"),this.button=Gt("torus"),this.tiles=[],this.layout="",this.labels="",this.message=null,this.colours=null,this.asTorus=!1,this.torus=new qS(t),this.button.onclick=()=>this.toggleTorus()}toggleTorus(){this.torus.possible&&(this.asTorus=!this.asTorus,tn(this.button,"aria-pressed",String(this.asTorus)),this.message=null,this.layout="",this.changed())}update(t){const e=t.message?.arrays.length?t.message:null;let n=this.torus.moved;for(const l of this.tiles)n=l.surface?.fit()||n;if(e===this.message&&t.colours===this.colours&&!n)return!1;const{colours:r}=t;r!==this.colours&&(this.labels=""),this.message=e,this.colours=r;const o=Dg(e?.arrays??[],t.info?.arrays??[]),a=[...o.rings,...o.sheets];return this.arrange(o,a),this.drawLegend(a,r),a.forEach((l,c)=>this.drawPopulation(this.tiles[c],l,r)),o.others.forEach((l,c)=>{ZS(this.tiles[a.length+c],l,r)}),!1}arrange({rings:t,sheets:e,others:n},s){const r=[...s,...n],o=r.map(({info:c,shape:u})=>`${c.name}:${u.join("x")}`).join()+this.asTorus;if(o===this.layout)return;this.layout=o,this.empty.hidden=r.length>0;const a=e.findIndex(Hd);this.button.hidden=a<0||!this.torus.possible,this.root.replaceChildren(),this.listed.replaceChildren(),this.tiles=[...s.map(c=>this.makePopulationTile(c)),...n.map(c=>this.makeOtherTile(c))];const l=this.tiles[t.length+a]?.surface?.canvas;this.asTorus&&a>=0&&l?this.torus.attach(l):this.torus.detach()}makePopulationTile({info:t,title:e,shape:n}){const s=n.length===1?"ring":"sheet";return this.makeTile(t,`Activity of ${e}, ${s} of ${n.join(" × ")} cells`,!0,"")}makeOtherTile({info:t,shape:e,values:n}){const s=`Values of ${t.name}, ${e.join(" × ")}`;return this.makeTile(t,s,n.length>jS,"other")}makeTile(t,e,n,s){const r=ue("figcaption",{"data-testid":`cells-${t.name}`,title:t.doc||t.name}),o=ue("figure",{class:s});let a=null;if(n){const l=ue("canvas",{role:"img","aria-label":e});o.append(l),a=new Fa(l)}return o.append(r),(n?this.root:this.listed).append(o),a?.fit(),{surface:a,caption:r,sheet:new Zg,array:new Bg}}drawPopulation({surface:t,caption:e,sheet:n},s,r){t!==null&&(s.shape.length===1?Gg(t,s,r):this.torus.isOn(t.canvas)?this.torus.draw(t,s,r):n.draw(t,s,r),he(e,QS(s)),tn(e,"data-peak",String(JS(s.activity))))}drawLegend(t,e){const n=[...new Set(t.flatMap(s=>s.bumps.map(r=>r.label)))];n.join()!==this.labels&&(this.labels=n.join(),this.legend.hidden=n.length===0,this.legend.replaceChildren(...n.map(s=>{const r=ue("li");return r.append(ue("i",{class:"swatch",style:`--swatch: ${fh(s,e)}`}),s),r})))}}function ZS({surface:i,caption:t,array:e},n,s){const{info:r,shape:o,values:a}=n;i!==null&&e.draw(i,n,s);const l=i!==null?o.join(" × "):Array.from(a,ri).join(", ");he(t,`${r.name}: ${l}${r.unit?` ${r.unit}`:""}`)}function JS(i){let t=0;for(let e=1;e<i.length;++e)i[e]>i[t]&&(t=e);return t}function QS(i){const t=i.bumps.filter(s=>s.isHypothesis).sort((s,r)=>r.weight-s.weight),e=i.bumps.find(s=>s.label==="estimate")??t[0];if(e===void 0)return i.title;const n=t.map(s=>ri(s.energy)).join(", ");return`${i.title} ${tE(i,e)}${n&&` · energies ${n}`}`}function tE(i,t){const e=Og(i,t),n=i.info.axes[0]?.unit??"";return n==="rad"?e.map(Fd).join(", "):`(${(e.length===2?[e[1],e[0]]:e).map(r=>ri(r??NaN)).join(", ")}) ${n}`}const eE=$n["decision.action"],nE={stay:"stay",create_experience:"create",close_loop:"loop"};function iE(i){const t=eE[i];return t===void 0?"–":nE[t]}const Si=(i,t)=>i.rows.value(i.row,t),Pf=[{name:"tracking",label:"odometry",text:i=>Bd("motion.state",Si(i,"motion.state")),tone:i=>["","good","warn"][Si(i,"motion.state")]??""},{name:"speed",label:"speed",unit:i=>Si(i,"motion.scale_known")===0?"units/s":"m/s",text:i=>mo(Si(i,"motion.v"),2)},{name:"tracked",label:"tracked",text:i=>ni(Si(i,"motion.tracked"))},{name:"heading",label:"heading",text:i=>Fd(Si(i,"decision.heading"))},{name:"templates",label:"templates",text:i=>ni(i.rows.templates(i.row))},{name:"experiences",label:"experiences",text:i=>ni(Si(i,"map_update.experiences"))},{name:"links",label:"links",text:i=>ni(Si(i,"map_update.links"))},{name:"loops",label:"loops",text:i=>ni(Si(i,"map_update.loops"))},{name:"action",label:"decision",text:i=>iE(Si(i,"decision.action"))},{name:"rate",label:"frames/s",text:i=>i.live?mo(i.rate,1):"–"},{name:"dropped",label:"dropped",text:i=>ni(i.dropped)}];class sE{constructor(){this.values=new Map;const t=Gt("counters");for(const e of Pf){const n=ue("div",{class:`counter-${e.name}`}),s=ue("span",{"data-testid":e.name}),r=ue("dd");r.append(s),e.unit&&r.append(ue("small")),n.append(ue("dt",{},e.label),r),t.append(n),this.values.set(e.name,s)}}update(t){for(const e of Pf){const n=this.values.get(e.name);he(n,e.text(t)),e.unit&&he(n.nextElementSibling,e.unit(t)),e.tone&&tn(n.parentElement,"data-tone",e.tone(t))}return!1}}class Ro{constructor(t){this.interval=t,this.last=-1/0}due(t){return t-this.last<this.interval?!1:(this.last=t,!0)}}const rE=60;class oE{constructor(t){this.list=Gt("events"),this.count=gr("event-count"),this.pace=new Ro(150),this.items=[],this.key="",this.list.addEventListener("click",e=>{const n=e.target.closest("li");n&&t(Number(n.dataset.frame))})}update(t,e){const n=`${t.events.edition} ${t.frame}`;if(n===this.key)return!1;if(!this.pace.due(e))return!0;this.key=n;const s=t.events.newest(t.frame,rE);for(;this.items.length<s.length;)this.items.push(this.makeItem());return this.items.forEach((r,o)=>this.fill(r,s[o])),he(this.count,String(t.events.count)),!1}makeItem(){const t=ue("li"),e=ue("span");return e.append(ue("b")," ",ue("small")),t.append(ue("span"),e),this.list.append(t),t}fill(t,e){t.hidden=e===void 0,e!==void 0&&(tn(t,"data-frame",String(e.frame)),tn(t,"data-level",e.level),he(t.firstElementChild,String(e.frame)),he(t.querySelector("b"),e.message),he(t.querySelector("small"),e.source))}}const aE=["kept","rejected","not accepted by the cells","not recognised"],lE=.01,cE=1.5,hE=20,uE=20,fE=.04,Yl={metres:1,sigmas:5,apart:10},Df=$n["place.recognition"].indexOf("familiar"),Lf=$n["hypothesis.fate"].indexOf("accepted");class dE{constructor(t,e){this.rows=t,this.graph=e,this.lives=new Map,this.supported=new Map,this.driven=new Float64Array(t.count);const n=["odometry.x","odometry.y","odometry.z","hypothesis.id"].map(l=>t.column(l)),[s,r,o,a]=n;for(let l=0;l<t.count;++l){const c=f=>f[l]-(f[l-1]??NaN),u=Math.hypot(c(s),c(r),c(o));this.driven[l]=(this.driven[l-1]??0)+(Number.isFinite(u)?u:0);const h=a[l];h>=0&&this.follow(l,this.lives.get(h)??{best:l,view:-1,end:l},h)}}all(){const t=[...this.links(),...this.undecided(),...this.unfamiliar()],e=({ending:n})=>aE.indexOf(n);return t.sort((n,s)=>e(n)-e(s)||n.distance-s.distance)}at(t,e){return this.rows.value(t,e)}apart(t,e){return Math.hypot(...["truth.x","truth.y","truth.z"].map(n=>this.at(t,n)-this.at(e,n)))}follow(t,e,n){this.lives.set(n,e),e.end=t,this.at(t,"hypothesis.share")>=this.at(e.best,"hypothesis.share")&&(e.best=t),!(this.at(t,"hypothesis.fate")>Lf)&&(e.view=t,this.supported.set(t,e))}story(t,e,n,s,r=this.supported.get(t)){const[o,a]=[this.rows.frame(t),this.at(t,"place.recognition")===Df],l=this.rows.frameOfTemplate(this.at(t,a?"place.template_id":"candidate.template_id")),c=v=>Number(v.toPrecision(3)),u=(v,m,p)=>Number.isFinite(m+p)?`${v} ${c(m)} (limit ${c(p)})`:"",[h,f]=[this.at(t,"candidate.agreeing"),this.at(t,"candidate.compared")],d=r?this.at(r.best,"hypothesis.views"):0,g=[u("score",this.at(t,"candidate.score"),this.at(t,"candidate.limit")),f>=0?`${h} of ${f} landmarks agree (needs ${this.at(t,"candidate.needed")})`:"",r?u("share",this.at(r.best,"hypothesis.share"),this.at(r.best,"hypothesis.limit")):"",d>0?`${d} view${d===1?"":"s"}`:"",s];return{frame:o,earlier:l<o?l:-1,ending:e,isTrue:null,distance:n,text:g.filter(Boolean).join(" · ")}}*links(){for(const[t,e,n,s,r]of this.graph.loopLinks()){const o=this.rows.rowOfFrame(e),[a,l]=[this.rows.rowOfFrame(n),this.rows.rowOfFrame(s)],c=this.rows.frame(a)===n&&this.rows.frame(l)===s,[u,h]=[this.at(o,"measured.error"),c?this.apart(a,l):NaN],f=u>Yl.metres&&this.at(o,"measured.sigmas")>Yl.sigmas,d=Number.isFinite(u)?u:h,g=Number.isFinite(d)?!f&&d<=Yl.apart:null,v=this.graph.isRejected(t),m=[r<0?"":`${ri(r)} σ from the map${v?", too far for its robust loss":""}`,g===null?"":`${g?"true":"FALSE"}: ${d===u?"its pose is":"ends are"} ${ri(d)} m ${d===u?"off":"apart"}`];yield{...this.story(o,v?"rejected":"kept",r,m.filter(Boolean).join(" · ")),frame:e,earlier:Math.min(n,s),isTrue:g}}}*undecided(){for(const t of this.lives.values()){const[e,n]=[this.at(t.best,"hypothesis.share"),this.at(t.end,"hypothesis.fate")];if(n===Lf||e<lE||t.view<0)continue;const s=this.at(t.end,"motion.scale_known")===0?"units":"m",o={faded:`died ${ri(this.at(t.end,"hypothesis.unsupported"))} ${s} after its last view`,displaced:"gave way to a stronger one"}[$n["hypothesis.fate"][n]];yield this.story(t.view,"not accepted by the cells",-e,o??"its share stayed too small",t)}}unfamiliar(){const t=[],{rows:e,driven:n}=this,r=this.at(e.count-1,"motion.scale_known")!==0?uE:fE*(n.at(-1)??0),o=e.column("place.recognition");for(let a=0;a<e.count;++a){if(o[a]===Df)continue;const[l,c,u]=[this.at(a,"candidate.score"),this.at(a,"candidate.limit"),this.at(a,"candidate.compared")];if(!(u>=0||l<=cE*c)||this.supported.has(a))continue;const f=this.story(a,"not recognised",l,u>=0?"":l>c?"above its limit":"no answer, though within its limit"),d=n[a]-(n[e.rowOfFrame(f.earlier)]??1/0),g=t.at(-1),v=g!==void 0&&f.frame-g.frame<=hE;!(d>=r)||v&&l>=g.distance||(v&&t.pop(),t.push(f))}return t}}function pE(i,t){return new dE(i,t).all()}const mE=400;class gE{constructor(t){this.list=Gt("loops"),this.verdict=gr("loops-verdict"),this.pace=new Ro(1500),this.key="",this.list.addEventListener("click",e=>{const n=e.target.closest("li");n&&t(Number(n.dataset.frame))})}update({rows:t,graph:e},n){const s=`${e.edition} ${t.count}`;if(s===this.key||t.count===0)return!1;if(!this.pace.due(n))return!0;this.key=s;const r=pE(t,e);he(this.verdict,_E(r));const o=[...r.filter(Da),...r.filter(a=>!Da(a))];return this.list.replaceChildren(...o.slice(0,mE).map(vE)),!1}}const Da=i=>i.ending==="kept"&&i.isTrue===!1;function _E(i){const t=i.filter(({ending:r})=>r==="kept"),e=i.filter(({ending:r})=>r==="rejected").length,s=t.length>0&&t.every(({isTrue:r})=>r===null)?"truth unknown":`${t.filter(Da).length} false`;return`loop links: ${t.length}, ${s} · rejected: ${e} · near misses: ${i.length-t.length-e}`}function vE(i){const t=ue("li",{"data-frame":String(i.frame),"data-verdict":Da(i)?"false":i.ending}),e=ue("span");return e.append(ue("b",{},i.ending)," ",ue("small",{},i.text)),t.append(ue("span",{},`${i.frame} → ${i.earlier<0?"–":i.earlier}`),e),t}const ql=2**17;class Uf{constructor(t){this.cell=t,this.values=new Float32Array(6*256),this.kept=[],this.seen=0,this.places=new Map,this.points=[],this.pairs=new Set}get count(){return this.seen}take(t,e){const n=this.kept.length;for(;this.seen<e;++this.seen)this.takeOne(t,6*this.seen);return this.kept.length>n}takeOne(t,e){if(this.cell<=0){this.keep(t,e,t,e+3);return}const n=this.place(t,e),s=this.place(t,e+3);if(n===s)return;const r=Math.min(n,s)*2**26+Math.max(n,s);this.pairs.has(r)||(this.pairs.add(r),this.keep(this.points,3*n,this.points,3*s))}place(t,e){let n=0;for(let o=0;o<3;++o){const a=Math.floor(t[e+o]/this.cell)%ql;n=n*ql+(a<0?a+ql:a)}const s=this.places.get(n);if(s!==void 0)return s;const r=this.points.length/3;for(let o=0;o<3;++o)this.points.push(t[e+o]);return this.places.set(n,r),r}keep(t,e,n,s){const r=6*this.kept.length;if(r+6>this.values.length){const o=new Float32Array(2*this.values.length);o.set(this.values),this.values=o}for(let o=0;o<3;++o)this.values[r+o]=t[e+o],this.values[r+3+o]=n[s+o];this.kept.push(this.seen)}}function Ip(i,t){let e=0,n=i.length;for(;e<n;){const s=e+n>>1;i[s]<t?e=s+1:n=s}return e}function xE(i){return 2**Math.floor(Math.log2(2.5/i))}const so={cos:1,sin:0,x:0,y:0,z:0,scale:1};function yE(i,t,e){return[i.scale*(i.cos*t-i.sin*e)+i.x,i.scale*(i.sin*t+i.cos*e)+i.z]}function ME(i,t,e){for(let n=0;n<e;++n)if(mr(i,n)&&mr(t,n))return n;return-1}function SE(i,t,e){const n=ME(i,t,e);return n<0?NaN:Math.hypot(Bi(i.x,n)-Bi(t.x,n),Bi(i.z,n)-Bi(t.z,n))}function EE(i,t,e){const{n,along:s,across:r,spread:o}=Np(i,t,e),a=Math.hypot(s,r)/o;return n>=2&&Number.isFinite(a)&&a>0?a:1}function wE(i,t,e,n=1){const{n:s,along:r,across:o,means:a}=Np(i,t,e);if(s<2)return so;const[l,c,u,h,f,d]=a,g=Math.atan2(o,r),[v,m]=[Math.cos(g),Math.sin(g)];return{cos:v,sin:m,x:n*h-(v*l-m*u),y:n*f-c,z:n*d-(m*l+v*u),scale:1}}function Np(i,t,e){let n=0;const s=[0,0,0,0,0,0];for(let d=0;d<e;++d)!mr(i,d)||!mr(t,d)||(++n,[i.x,i.y,i.z,t.x,t.y,t.z].forEach((g,v)=>{s[v]=s[v]+Bi(g,d)}));const r=s.map(d=>d/n),[o,,a,l,,c]=r;let[u,h,f]=[0,0,0];for(let d=0;d<e;++d){if(!mr(i,d)||!mr(t,d))continue;const[g,v]=[Bi(i.x,d)-o,Bi(i.z,d)-a],[m,p]=[Bi(t.x,d)-l,Bi(t.z,d)-c];u+=g*m+v*p,h+=g*p-v*m,f+=m*m+p*p}return{n,along:u,across:h,spread:f,means:r}}function Bi(i,t){return i[t]}function mr(i,t){return Number.isFinite(i.x[t])&&Number.isFinite(i.z[t])}const If=3,Fp=2;function TE(i,t){const e=new Map,n=new Map;for(let s=0;s<i.experiences;++s){const[r,o,a]=i.position(s).map(c=>t*c),l=`${Math.floor(r/If)} ${Math.floor(a/If)}`;if(e.set(l,Math.min(e.get(l)??o,o)),n.set(l,Math.max(n.get(l)??o,o)),n.get(l)-e.get(l)>=Fp)return!0}return!1}const bE=`
attribute vec3 start;
attribute vec3 end;
uniform vec2 resolution;
uniform float width;
uniform float level;
uniform float reach;
varying float away;
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
  float height = (position.x > 0.0 ? end : start).y;
  away = reach > 0.0 ? smoothstep(reach, 1.5 * reach, abs(height - level)) : 0.0;
  // Half a width beyond the ends closes the corners.
  here.xy += (along * position.x + across * position.y) * width / resolution * here.w;
  // Layers lie in their order, those of other storeys behind all.
  here.z = (away > 0.5 ? 0.5 : 0.0) * here.w;
  gl_Position = here;
}`,AE=`
uniform vec3 colour;
uniform vec3 paper;
varying float away;
void main() {
  gl_FragColor = vec4(mix(colour, paper, 0.75 * away), 1.0);
  #include <colorspace_fragment>
}`;class RE extends qi{constructor(t,e,n){super({vertexShader:bE,fragmentShader:AE,uniforms:{width:{value:t},colour:{value:new ve},resolution:e,...n},transparent:!0,blending:Vi,depthTest:!0,depthWrite:!0,side:2})}setColour(t){(this.uniforms.colour?.value).set(t)}}const CE=800;function $l(i,t,e){return[i,-t,-e]}class Jr{constructor(t,e,n,s){this.raw=new Float32Array(384),this.count=0,this.thinner=new Uf(0),this.stale=!0,this.room=64,this.object=new Yn(Nf(this.room),new RE(t,n,s)),this.object.frustumCulled=!1,this.object.renderOrder=e}setColour(t){this.object.material.setColour(t)}set(t,e,n){const s=6*t+6;if(s>this.raw.length){const r=new Float32Array(Math.max(s,2*this.raw.length));r.set(this.raw),this.raw=r}this.raw.set(e,s-6),this.raw.set(n,s-3),t<this.thinner.count&&(this.stale=!0),this.count=Math.max(this.count,t+1)}cut(t){t>=this.count||(this.count=t,this.stale=!0)}show(t,e){const n=this.count>CE?e:0;(this.stale||this.thinner.cell!==n)&&(this.thinner=new Uf(n)),this.stale=!1;const s=this.thinner.kept.length;this.thinner.take(this.raw,this.count)&&this.upload(s);const r=Ip(this.thinner.kept,t);this.object.geometry.setDrawRange(0,6*r),this.object.visible=r>0}upload(t){const{values:e,kept:n}=this.thinner;n.length>this.room&&this.grow(n.length);const[s,r]=this.ends();for(let o=t;o<n.length;++o){const[a,l]=[e.subarray(6*o,6*o+3),e.subarray(6*o+3,6*o+6)];for(let c=0;c<4;++c)s.array.set(a,12*o+3*c),r.array.set(l,12*o+3*c)}s.needsUpdate=r.needsUpdate=!0}ends(){const{start:t,end:e}=this.object.geometry.attributes;return[t,e]}grow(t){for(;this.room<t;)this.room*=2;const e=this.object.geometry,[n,s]=this.ends();this.object.geometry=Nf(this.room);const[r,o]=this.ends();r.array.set(n.array),o.array.set(s.array),e.dispose()}}function Nf(i){const t=new Float32Array(12*i),e=new Uint32Array(6*i);for(let s=0;s<i;++s)t.set([-1,-1,0,1,-1,0,1,1,0,-1,1,0],12*s),e.set([0,1,2,0,2,3].map(r=>4*s+r),6*s);const n=new Pn;return n.setAttribute("position",new vn(t,3)),n.setAttribute("start",new vn(new Float32Array(12*i),3)),n.setAttribute("end",new vn(new Float32Array(12*i),3)),n.setIndex(new vn(e,1)),n}class PE{constructor(t,e){this.values=new Float32Array(192);const n=new mp({size:6,sizeAttenuation:!1,map:LE(),transparent:!0,depthTest:!1,depthWrite:!1});DE(n,e),this.object=new w0(new Pn,n),this.object.frustumCulled=!1,this.object.renderOrder=t,this.bind(),this.show(0)}setColour(t){this.object.material.color.set(t)}setSize(t){this.object.material.size=t}set(t,e){if(3*t+3>this.values.length){const n=new Float32Array(2*this.values.length);n.set(this.values),this.values=n,this.bind()}this.values.set(e,3*t)}upload(){this.object.geometry.getAttribute("position").needsUpdate=!0}show(t){this.object.geometry.setDrawRange(0,t),this.object.visible=t>0}bind(){const{drawRange:t}=this.object.geometry,e=new Pn;e.setAttribute("position",new vn(this.values,3)),e.setDrawRange(t.start,t.count),this.object.geometry.dispose(),this.object.geometry=e}}function DE(i,t){i.onBeforeCompile=e=>{Object.assign(e.uniforms,t),e.vertexShader=e.vertexShader.replace("void main() {",`uniform float level;
uniform float reach;
varying float away;
void main() {
  away = reach > 0.0 ? smoothstep(reach, 1.5 * reach, abs(position.y - level)) : 0.0;`),e.fragmentShader=e.fragmentShader.replace("void main() {",`varying float away;
void main() {`).replace("#include <color_fragment>",`#include <color_fragment>
  diffuseColor.a *= 1.0 - 0.8 * away;`)}}function LE(){const i=document.createElement("canvas");i.width=i.height=64;const t=i.getContext("2d");return t!==null&&(t.strokeStyle="#fff",t.fillStyle="#ffffff59",t.lineWidth=13,t.beginPath(),t.arc(32,32,23,0,2*Math.PI),t.fill(),t.stroke()),new T0(i)}const UE=["links","loops","rejected","experiences","odometry","truth"],jl=["links","loops","rejected"],IE=1;function Qr(i,t){return{x:i.column(`${t}.x`),y:i.column(`${t}.y`),z:i.column(`${t}.z`)}}class NE{constructor(t){this.group=new dr,this.bounds=new Ir,this.robot=new dr,this.truthMode=null,this.scale=1,this.scaleKnown=!0,this.chosen=!1,this.hidden=new Set,this.fade={level:{value:0},reach:{value:0},paper:{value:new ve}},this.fill=new Tr({depthTest:!1,transparent:!0}),this.rim=new Tr({depthTest:!1,transparent:!0}),this.drawnRows={rows:null,count:0},this.drawnGraph=-1,this.motion=so,this.fittedRows=0,this.linksOf={links:[],loops:[],rejected:[]},this.truth=new Jr(4.5,1,t,this.fade),this.odometry=new Jr(1.4,2,t,this.fade),this.links=new Jr(1.6,3,t,this.fade),this.rejected=new Jr(1.2,2,t,this.fade),this.loops=new Jr(3,5,t,this.fade),this.dots=new PE(4,this.fade);for(const e of[this.truth,this.odometry,this.links,this.rejected,this.loops,this.dots])this.group.add(e.object);this.makeRobot(),this.group.add(this.robot)}isHidden(t){return this.hidden.has(t)}setHidden(t,e){e?this.hidden.add(t):this.hidden.delete(t)}setTruthMode(t){this.truthMode=t,this.chosen=!0,this.drawnRows.count=0}setColours(t){this.truth.setColour(t.truth),this.odometry.setColour(t.orange),this.links.setColour(t.blue),this.loops.setColour(t.vermilion),this.rejected.setColour(t.rejected),this.dots.setColour(t.green),this.fill.color.set(t.ink),this.rim.color.set(t.panel),this.fade.paper.value.set(t.well)}setDotSize(t){this.dots.setSize(t)}take(t){this.updateRows(t.rows),t.graph.edition!==this.drawnGraph&&this.updateGraph(t.graph)}get hasMetres(){return this.scaleKnown||this.truthMode==="fitted"}show(t,e){const{rows:n,row:s}=t,r=s===n.count-1,o=(c,u)=>{const h=n.value(s,c);return r||!Number.isFinite(h)?u:Math.min(u,h)},a=o("map_update.links",t.graph.links);this.draw("odometry",this.odometry,s,e),this.draw("truth",this.truth,s,e);const l=o("map_update.experiences",t.graph.experiences);this.dots.show(this.hidden.has("experiences")?0:l);for(const c of jl)this.draw(c,this[c],Ip(this.linksOf[c],a),e);this.placeRobot(t)}draw(t,e,n,s){e.show(this.hidden.has(t)?0:n,s)}updateRows(t){this.drawnRows.rows!==t&&(this.drawnRows={rows:t,count:0},this.truthMode=null,this.chosen=!1,this.bounds.makeEmpty(),this.odometry.cut(0),this.truth.cut(0));const e=this.drawnRows.count;if(t.count===e)return;const n=this.scale,s=this.alignTruth(t),r=this.scale!==n;r&&(this.drawnGraph=-1,this.bounds.makeEmpty());const o={...so,scale:this.scale};this.addPath(this.odometry,Qr(t,"odometry"),o,r?0:e,t.count),this.addPath(this.truth,Qr(t,"truth"),this.motion,s?0:e,t.count),this.drawnRows.count=t.count}alignTruth(t){const e=Qr(t,"truth"),n=Qr(t,"map");if(this.scaleKnown=t.value(t.count-1,"motion.scale_known")!==0,!this.chosen){const s=SE(e,Qr(t,"odometry"),t.count);Number.isFinite(s)&&(this.truthMode=s<IE&&this.scaleKnown?"given":"fitted")}if(this.truthMode!=="fitted"){const s=this.motion;return this.motion=so,this.scale=1,s!==so}return this.drawnRows.count>0&&t.count<1.05*this.fittedRows?!1:(this.fittedRows=t.count,this.scale=this.scaleKnown?1:EE(e,n,t.count),this.motion=wE(e,n,t.count,this.scale),!0)}addPath(t,e,n,s,r){let o=null;const a=l=>{const[c,u]=yE(n,e.x[l],e.z[l]);return $l(c,n.scale*e.y[l]+n.y,u)};for(let l=Math.max(0,s-1);l<r;++l){const c=a(l),u=Number.isFinite(c[0]);u&&this.bounds.expandByPoint(new z(...c));const h=o??c;l>0&&t.set(l-1,u?h:o??[0,0,0],u?c:o??[0,0,0]),u&&(o=c)}}updateGraph(t){this.drawnGraph=t.edition;const e=n=>{const[s,r,o]=t.position(n);return $l(this.scale*s,this.scale*r,this.scale*o)};for(let n=0;n<t.experiences;++n){const s=e(n);this.dots.set(n,s),this.bounds.expandByPoint(new z(...s))}for(const n of jl)this.linksOf[n]=[];for(let n=0;n<t.links;++n){const[s,r]=t.ends(n),o=t.isRejected(n)?"rejected":t.isLoop(n)?"loops":"links",a=this.linksOf[o];this[o].set(a.length,e(s),e(r)),a.push(n)}for(const n of jl)this[n].cut(this.linksOf[n].length);this.dots.upload(),this.fade.reach.value=TE(t,this.scale)?Fp*.6:0}placeRobot({rows:t,row:e,graph:n}){const s=(...p)=>p.map(w=>t.value(e,w));let[r,o,a]=s("map.x","map.y","map.z");const l=t.value(e,"map_update.experience"),[c,u,h]=s("anchor.x","anchor.y","anchor.z"),[f,d,g]=n.position(l);let v=n.heading(l)-t.value(e,"anchor.yaw");if(Number.isFinite(v+f+c)){const[p,w,T,M]=[r-c,a-h,Math.cos(v),Math.sin(v)];[r,o,a]=[f+T*p-M*w,d+o-u,g+M*p+T*w]}else v=0;if(this.robot.visible=Number.isFinite(r),!this.robot.visible)return;this.robot.position.set(...$l(this.scale*r,this.scale*o,this.scale*a)),this.fade.level.value=this.robot.position.y;const m=t.value(e,"decision.heading");this.robot.rotation.y=v+(Number.isFinite(m)?m:0)}makeRobot(){const t=[[this.rim,1.42,6],[this.fill,1,7]];for(const[e,n,s]of t){const r=new Sp;r.moveTo(0,.62*n),r.lineTo(.42*n,-.45*n),r.lineTo(0,-.22*n),r.lineTo(-.42*n,-.45*n);const o=new Yn(new Eh(r),e);o.rotation.x=-Math.PI/2,o.renderOrder=s,e.side=2,this.robot.add(o)}}}const Ff={type:"change"},bh={type:"start"},Op={type:"end"},ua=new za,Of=new os,FE=Math.cos(70*X_.DEG2RAD),Ze=new z,In=2*Math.PI,Re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Kl=1e-6;class kf extends av{constructor(t,e=null){super(t,e),this.state=Re.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Hi.ROTATE,MIDDLE:Hi.DOLLY,RIGHT:Hi.PAN},this.touches={ONE:hs.ROTATE,TWO:hs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Fs,this._lastTargetPosition=new z,this._quat=new Fs().setFromUnitVectors(t.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new nf,this._sphericalDelta=new nf,this._scale=1,this._panOffset=new z,this._rotateStart=new Rt,this._rotateEnd=new Rt,this._rotateDelta=new Rt,this._panStart=new Rt,this._panEnd=new Rt,this._panDelta=new Rt,this._dollyStart=new Rt,this._dollyEnd=new Rt,this._dollyDelta=new Rt,this._dollyDirection=new z,this._mouse=new Rt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=kE.bind(this),this._onPointerDown=OE.bind(this),this._onPointerUp=BE.bind(this),this._onContextMenu=YE.bind(this),this._onMouseWheel=VE.bind(this),this._onKeyDown=GE.bind(this),this._onTouchStart=WE.bind(this),this._onTouchMove=XE.bind(this),this._onMouseDown=zE.bind(this),this._onMouseMove=HE.bind(this),this._interceptControlDown=qE.bind(this),this._interceptControlUp=$E.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.getRootNode().addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.getRootNode().removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.style.touchAction="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Ff),this.update(),this.state=Re.NONE}update(t=null){const e=this.object.position;Ze.copy(e).sub(this.target),Ze.applyQuaternion(this._quat),this._spherical.setFromVector3(Ze),this.autoRotate&&this.state===Re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let n=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(n)&&isFinite(s)&&(n<-Math.PI?n+=In:n>Math.PI&&(n-=In),s<-Math.PI?s+=In:s>Math.PI&&(s-=In),n<=s?this._spherical.theta=Math.max(n,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(n+s)/2?Math.max(n,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{const o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ze.setFromSpherical(this._spherical),Ze.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ze),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){const a=Ze.length();o=this._clampDistance(a*this._scale);const l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){const a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);const l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;const c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ze.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ua.origin.copy(this.object.position),ua.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ua.direction))<FE?this.object.lookAt(this.target):(Of.setFromNormalAndCoplanarPoint(this.object.up,this.target),ua.intersectPlane(Of,this.target))))}else if(this.object.isOrthographicCamera){const o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Kl||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Kl||this._lastTargetPosition.distanceToSquared(this.target)>Kl?(this.dispatchEvent(Ff),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?In/60*this.autoRotateSpeed*t:In/60/60*this.autoRotateSpeed}_getZoomScale(t){const e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ze.setFromMatrixColumn(e,0),Ze.multiplyScalar(-t),this._panOffset.add(Ze)}_panUp(t,e){this.screenSpacePanning===!0?Ze.setFromMatrixColumn(e,1):(Ze.setFromMatrixColumn(e,0),Ze.crossVectors(this.object.up,Ze)),Ze.multiplyScalar(t),this._panOffset.add(Ze)}_pan(t,e){const n=this.domElement;if(this.object.isPerspectiveCamera){const s=this.object.position;Ze.copy(s).sub(this.target);let r=Ze.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/n.clientHeight,this.object.matrix),this._panUp(2*e*r/n.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/n.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/n.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;const n=this.domElement.getBoundingClientRect(),s=t-n.left,r=e-n.top,o=n.width,a=n.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientX),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(In*this._rotateDelta.x/e.clientHeight),this._rotateUp(In*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(In*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-In*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(In*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-In*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(n,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(n,s)}}_handleTouchStartDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{const n=this._getSecondPointerPosition(t),s=.5*(t.pageX+n.x),r=.5*(t.pageY+n.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);const e=this.domElement;this._rotateLeft(In*this._rotateDelta.x/e.clientHeight),this._rotateUp(In*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{const e=this._getSecondPointerPosition(t),n=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(n,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){const e=this._getSecondPointerPosition(t),n=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(n*n+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);const o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Rt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){const e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){const e=t.deltaMode,n={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:n.deltaY*=16;break;case 2:n.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(n.deltaY*=10),n}}function OE(i){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(i.pointerId),this.domElement.addEventListener("pointermove",this._onPointerMove),this.domElement.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(i)&&(this._addPointer(i),i.pointerType==="touch"?this._onTouchStart(i):this._onMouseDown(i)))}function kE(i){this.enabled!==!1&&(i.pointerType==="touch"?this._onTouchMove(i):this._onMouseMove(i))}function BE(i){switch(this._removePointer(i),this._pointers.length){case 0:this.domElement.releasePointerCapture(i.pointerId),this.domElement.removeEventListener("pointermove",this._onPointerMove),this.domElement.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Op),this.state=Re.NONE;break;case 1:const t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function zE(i){let t;switch(i.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Hi.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(i),this.state=Re.DOLLY;break;case Hi.ROTATE:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}break;case Hi.PAN:if(i.ctrlKey||i.metaKey||i.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(i),this.state=Re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(i),this.state=Re.PAN}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(bh)}function HE(i){switch(this.state){case Re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(i);break;case Re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(i);break;case Re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(i);break}}function VE(i){this.enabled===!1||this.enableZoom===!1||this.state!==Re.NONE||(i.preventDefault(),this.dispatchEvent(bh),this._handleMouseWheel(this._customWheelEvent(i)),this.dispatchEvent(Op))}function GE(i){this.enabled!==!1&&this._handleKeyDown(i)}function WE(i){switch(this._trackPointer(i),this._pointers.length){case 1:switch(this.touches.ONE){case hs.ROTATE:if(this.enableRotate===!1)return;this._handleTouchStartRotate(i),this.state=Re.TOUCH_ROTATE;break;case hs.PAN:if(this.enablePan===!1)return;this._handleTouchStartPan(i),this.state=Re.TOUCH_PAN;break;default:this.state=Re.NONE}break;case 2:switch(this.touches.TWO){case hs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(i),this.state=Re.TOUCH_DOLLY_PAN;break;case hs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(i),this.state=Re.TOUCH_DOLLY_ROTATE;break;default:this.state=Re.NONE}break;default:this.state=Re.NONE}this.state!==Re.NONE&&this.dispatchEvent(bh)}function XE(i){switch(this._trackPointer(i),this.state){case Re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(i),this.update();break;case Re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(i),this.update();break;case Re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(i),this.update();break;case Re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(i),this.update();break;default:this.state=Re.NONE}}function YE(i){this.enabled!==!1&&i.preventDefault()}function qE(i){i.key==="Control"&&(this._controlActive=!0,this.domElement.getRootNode().addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function $E(i){i.key==="Control"&&(this._controlActive=!1,this.domElement.getRootNode().removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}const Zl=5e3;class jE{constructor(t,e){this.canvas=t,this.scene=new fp,this.dimension="2d",this.software=Th()==="software",this.fine=!1,this.untouched=!0,this.gridStep=0,this.flat=new Ap(-1,1,1,-1,1,4*Zl),this.space=new Xn(45,1,.05,1e5),this.gridMaterial=new pp({transparent:!0,depthWrite:!1}),this.grid=new E0(new Pn,this.gridMaterial),this.gridKey="",this.resolution={value:new Rt(1,1)},this.width=1,this.height=1,this.renderer=new Up({canvas:t,antialias:!this.software,alpha:!1}),this.flat.up.set(0,0,-1),this.flat.position.set(0,Zl,0),this.space.position.set(40,60,80),this.flatControls=new kf(this.flat,t),this.spaceControls=new kf(this.space,t),this.setUpControls(e),this.grid.renderOrder=0,this.grid.frustumCulled=!1,this.scene.add(this.grid),this.choose("2d")}setUpControls(t){this.flatControls.enableRotate=!1,this.flatControls.zoomToCursor=!0,this.flatControls.mouseButtons={LEFT:Hi.PAN,MIDDLE:Hi.DOLLY,RIGHT:Hi.PAN},this.flatControls.touches={ONE:hs.PAN,TWO:hs.DOLLY_PAN},[this.flatControls.minZoom,this.flatControls.maxZoom]=[.001,1e4],this.spaceControls.enableDamping=!0,this.spaceControls.dampingFactor=.12,this.spaceControls.maxPolarAngle=.49*Math.PI;for(const e of[this.flatControls,this.spaceControls])e.enabled=!1,e.addEventListener("change",t),e.addEventListener("start",()=>this.untouched=!1)}add(t){this.scene.add(t)}choose(t){this.dimension=t,this.flatControls.enabled=t==="2d",this.spaceControls.enabled=t==="3d"}setColours(t,e){this.renderer.setClearColor(t),this.gridMaterial.color.set(e)}resize(){const{clientWidth:t,clientHeight:e}=this.canvas,n=this.software?this.fine?2:1:Math.min(window.devicePixelRatio,2);return t===this.width&&e===this.height&&n===this.renderer.getPixelRatio()?!1:([this.width,this.height]=[Math.max(1,t),Math.max(1,e)],this.resolution.value.set(this.width,this.height),this.renderer.setPixelRatio(n),this.renderer.setSize(this.width,this.height,!1),[this.flat.left,this.flat.right]=[-this.width/2,this.width/2],[this.flat.top,this.flat.bottom]=[this.height/2,-this.height/2],this.flat.updateProjectionMatrix(),this.space.aspect=this.width/this.height,this.space.updateProjectionMatrix(),!0)}get zoom(){if(this.dimension==="2d")return this.flat.zoom;const t=this.space.position.distanceTo(this.spaceControls.target);return this.height/(2*t*Math.tan(this.space.fov*Math.PI/360))}get centre(){return(this.dimension==="2d"?this.flatControls:this.spaceControls).target}zoomBy(t){if(this.untouched=!1,this.dimension==="2d"){this.flat.zoom*=t,this.flat.updateProjectionMatrix(),this.flatControls.update();return}const e=this.space.position.clone().sub(this.spaceControls.target).divideScalar(t);this.space.position.copy(this.spaceControls.target).add(e),this.spaceControls.update()}centreOn(t){for(const e of[this.flatControls,this.spaceControls]){const n=t.clone().sub(e.target);n.lengthSq()<1e-8||(e.object.position.add(n),e.target.add(n),e.update())}}fit(t){if(t.isEmpty())return;const e=t.getCenter(new z),n=t.getSize(new z),s=.84*Math.min(this.width/Math.max(n.x,4),this.height/Math.max(n.z,4));this.flat.zoom=s,this.flat.updateProjectionMatrix(),this.flatControls.target.copy(e).setY(0),this.flat.position.set(e.x,Zl,e.z),this.flatControls.update();const r=.46*this.height/s/Math.tan(this.space.fov*Math.PI/360),o=new z(-.35,.75,.8).normalize();this.spaceControls.target.copy(e),this.space.position.copy(e).addScaledVector(o,r),this.spaceControls.update()}render(t){const e=this.dimension==="3d"&&this.spaceControls.update();return this.layGrid(t),this.renderer.render(this.scene,this.dimension==="2d"?this.flat:this.space),e}layGrid(t){const e=Math.min(this.width,this.height)/this.zoom,n=ka(Math.max(e/3.5,.001)),s=this.dimension==="2d"||t.isEmpty()?this.centre:t.getCenter(new z),r=f=>Math.round(f/n)*n,[o,a]=[r(s.x),r(s.z)],l=`${this.dimension} ${n} ${o} ${a}`;if(l===this.gridKey)return;this.gridKey=l,this.gridStep=n;const[c,u]=this.dimension==="2d"?[8,1]:[16,32],h=[];for(let f=-c;f<=c;++f)for(let d=0;d<u;++d){const g=(-c+2*c*d/u)*n,v=g+2*c/u*n;h.push(o+f*n,0,a+g,o+f*n,0,a+v),h.push(o+g,0,a+f*n,o+v,0,a+f*n)}this.grid.geometry.setAttribute("position",new vn(new Float32Array(h),3))}}const KE={links:"odometry links",loops:"loop links",rejected:"rejected loop links",experiences:"experiences",odometry:"odometry",truth:"ground truth"},ZE=17,JE=300,QE={links:"blue",loops:"vermilion",rejected:"rejected",experiences:"green",odometry:"orange",truth:"truth"};class tw{constructor(t){this.changed=t,this.renders=0,this.texts={foot:Gt("map-foot"),scale:Gt("scale-text"),axes:Gt("axes")},this.bar=Gt("scale-bar"),this.numbers=new Map,this.centreButton=Gt("map-centre"),this.align=Gt("align"),this.centred=!1,this.dirty=!0,this.lastMove=0,this.key="",this.cell=0,this.relayer=!1,this.colours=null,this.hasTruth=null;const e=Gt("map");if(this.stage=Th()!=="none"?new jE(e,()=>this.touch()):null,this.content=new NE(this.stage?.resolution??{value:new Rt(1,1)}),this.stage?.add(this.content.group),this.stage===null){const n=Gt("map-empty");n.hidden=!1,he(n,"This browser offers no WebGL, which the map needs.")}Gt("map-2d").onclick=()=>this.choose("2d"),Gt("map-3d").onclick=()=>this.choose("3d"),Gt("map-fit").onclick=()=>this.fit(),this.centreButton.onclick=()=>this.toggleCentre(),this.makeLayers()}get zoom(){return this.stage?.zoom??NaN}get centre(){const t=this.stage?.centre;return t?[t.x,-t.z]:[NaN,NaN]}get dimension(){return this.stage?.dimension??"2d"}choose(t){this.stage?.choose(t),tn(Gt("map-2d"),"aria-pressed",String(t==="2d")),tn(Gt("map-3d"),"aria-pressed",String(t==="3d")),this.touch()}fit(){this.centred&&this.toggleCentre(),this.stage?.fit(this.content.bounds),this.stage&&(this.stage.untouched=!0),this.touch()}toggleCentre(){this.centred=!this.centred,tn(this.centreButton,"aria-pressed",String(this.centred)),this.touch()}zoomBy(t){this.stage?.zoomBy(t),this.touch()}toggle(t){this.content.setHidden(t,!this.content.isHidden(t)),this.relayer=!0,this.touch()}update(t,e){if(this.stage===null)return!1;const n=this.stage.resize();t.colours!==this.colours&&this.paint(t.colours);const s=`${t.rows.count} ${t.row} ${t.graph.edition}`;if(!n&&!this.dirty&&s===this.key)return this.refine(this.stage,e);this.stage.fine=!1,this.stage.resize(),this.lastMove=e;const r=s!==this.key||this.relayer;r&&this.content.take(t),this.stage.untouched&&this.stage.fit(this.content.bounds);const o=xE(this.stage.zoom);(r||o!==this.cell)&&this.content.show(t,o),r&&this.describe(t),[this.key,this.cell,this.relayer,this.dirty]=[s,o,!1,!1],this.centred&&this.content.robot.visible&&this.stage.centreOn(this.content.robot.position);const a=this.stage.zoom;return this.content.robot.scale.setScalar(ZE/a),this.content.setDotSize(Math.max(3.4,Math.min(9,2.2*a))),this.dirty=this.stage.render(this.content.bounds),++this.renders,this.showScale(a),this.dirty&&this.changed(),this.stage.software}refine(t,e){return!t.software||t.fine?!1:e-this.lastMove<JE?!0:(t.fine=!0,t.resize(),t.render(this.content.bounds),++this.renders,!1)}touch(){this.dirty=!0,this.changed()}paint(t){this.colours=t,this.content.setColours(t),this.stage?.setColours(t.well,t.line),this.dirty=!0}describe(t){const{rows:e,row:n,graph:s}=t;he(this.numbers.get("experiences"),String(s.experiences)),he(this.numbers.get("links"),String(s.links-s.loops-s.rejected)),he(this.numbers.get("loops"),String(s.loops)),he(this.numbers.get("rejected"),String(s.rejected)),Gt("layer-rejected").hidden=s.rejected===0;const r=Number.isFinite(e.value(0,"truth.x"))||(t.info?.source.has_truth??!1);r!==this.hasTruth&&(this.hasTruth=r,Gt("layer-truth").hidden=!r,this.align.hidden=!r),he(this.align,this.content.truthMode==="fitted"?"as given":"align");const o=n<e.count-1,a=`correction ${s.version}`,l=r?` · truth ${ew(this.content)}`:"";he(this.texts.foot,(o?`as far as frame ${t.frame} · `:"")+a+l),tn(this.texts.foot,"data-version",String(s.version))}showScale(t){const e=ka(110/t);tn(this.bar,"style",`width: ${(e*t).toFixed(1)}px`);const n=this.content.hasMetres?Od:kd;he(this.texts.scale,n(e));const s=`grid ${n(this.stage?.gridStep??NaN)}`;he(this.texts.axes,this.dimension==="2d"?`z ↑ x → · ${s}`:s)}makeLayers(){for(const t of UE){const e=ue("label",{id:`layer-${t}`,class:"chip"}),n=ue("input",{type:"checkbox","aria-label":`Show ${KE[t]}`});n.checked=!0,n.onchange=()=>this.toggle(t);const s=`--swatch: var(--${QE[t]})`,r=ue("i",{style:s,class:t==="experiences"?"round":""}),o=ue("b",{"data-testid":`graph-${t}`});this.numbers.set(t,o),e.append(n,r,t,o),Gt("layers").append(e)}this.align.onclick=()=>{this.content.setTruthMode(this.content.truthMode==="fitted"?"given":"fitted"),this.relayer=!0,this.touch()}}}function ew({truthMode:i,scaleKnown:t,scale:e}){return i==="fitted"?t?"fitted (turn and shift)":`fitted, 1 unit is ${ri(e)} m`:i==="given"?"as given":"not known yet"}const nw=40;function iw(i,t){for(let e=t;e>=0&&e>t-nw;--e)if(i.value(e,"place.recognition")>0)return e;return-1}class sw{constructor(){this.surface=new Fa(Gt("view")),this.image=Gt("template"),this.empty=Gt("template-empty"),this.made=Gt("template-made"),this.tag=Gt("recognition"),this.texts={frame:gr("view-frame"),template:gr("template"),score:gr("score")},this.picture=null,this.candidateAt=-1,this.coming=new Image,this.fetching=-1,this.wanted=-1,this.coming.onload=()=>this.arrived(),this.coming.onerror=()=>this.arrived()}update(t){this.drawView(t);const e=iw(t.rows,t.row),n=e<0?0:t.rows.value(e,"place.recognition"),s=t.frame===this.candidateAt&&$n["place.recognition"][n]!=="familiar",r=t.rows.value(s?t.row:e,s?"candidate.template_id":"place.template_id");he(this.texts.frame,ni(t.picture?.frame??NaN)),he(this.texts.template,ni(r>=0?r:NaN)),he(this.texts.score,ri(t.rows.value(e,"place.score"))),he(this.tag,Bd("place.recognition",n)),tn(this.tag,"data-kind",String(n)),tn(this.tag,"data-frame",ni(t.rows.frame(e)));const o=r>=0?t.rows.frameOfTemplate(r):NaN;return he(this.made,Number.isFinite(o)?` · frame ${o}`:""),this.showTemplate(t.picture!==null&&r>=0?r:-1),!1}drawView({picture:t}){if(!this.surface.fit()&&this.picture===t)return;this.picture=t;const e=this.surface.clear();if(t===null)return;const{width:n,height:s}=t.bitmap;for(const l of[this.surface.canvas,this.image])l.parentElement?.style.setProperty("--shape",String(n/s));const r=Math.min(this.surface.width/n,this.surface.height/s),[o,a]=[n*r,s*r];e.imageSmoothingQuality="high",e.drawImage(t.bitmap,(this.surface.width-o)/2,(this.surface.height-a)/2,o,a)}showTemplate(t){this.image.hidden=t<0,this.empty.hidden=t>=0,this.wanted=t,this.fetching<0&&this.fetchWanted()}fetchWanted(){this.wanted<0||this.image.dataset.template===String(this.wanted)||(this.fetching=this.wanted,this.coming.src=rg(this.fetching))}arrived(){const t=this.coming.naturalWidth>0;this.image.dataset.template=String(this.fetching),t?this.image.src=this.coming.src:this.image.removeAttribute("src"),this.fetching=-1,this.fetchWanted()}}class rw{constructor(t){this.model=t,this.name=Gt("run-name"),this.description=Gt("run-description"),this.pill=Gt("link"),this.pillText=Gt("link-text"),this.banner=Gt("banner")}update(t,e){he(this.name,t.info?.name??"no run yet"),he(this.description,t.info?.source.description||t.info?.directory||"");const n=t.info?`${t.info.name} · Tolman`:"Tolman";document.title!==n&&(document.title=n);const[s,r]=this.connection(t);tn(this.pill,"data-state",s),he(this.pillText,r);const o=this.trouble(e);return this.banner.hidden=o===null,o!==null&&(he(this.banner,o.text),tn(this.banner,"data-kind",o.kind)),this.model.trouble?.kind==="gone"}connection(t){return t.link==="waiting"||t.link==="connecting"?[t.link,t.link==="waiting"?"no server":"connecting"]:t.loading?["connecting",t.recorded?"reading the record":"reading the history"]:t.recorded&&t.link==="open"?["recorded","recorded run"]:this.model.end==="interrupted"?["ended","run was interrupted"]:this.model.end!==""||t.link==="ended"?["ended","run has ended"]:t.live?t.mode==="live"?["open","live"]:["open",t.mode==="playing"?"live, playing":"live, paused here"]:["recorded","recorded run"]}trouble(t){const e=this.model.trouble;if(e===null)return null;if(e.kind==="no_frames")return{kind:"info",text:'The run and its server have ended: images and activity of past frames are no longer available. "tolman view" shows the recorded run.'};if(e.kind==="other_version")return{kind:"warning",text:"The server is of another version than this page. Reload the page."};const n=Math.max(0,Math.ceil((e.until-t)/1e3));return{kind:"warning",text:`The server does not answer. Next attempt ${n>0?`in ${n} s`:"now"}.`}}}const ow=!0,sn="u-",aw="uplot",lw=sn+"hz",cw=sn+"vt",hw=sn+"title",uw=sn+"wrap",fw=sn+"under",dw=sn+"over",pw=sn+"axis",Ds=sn+"off",mw=sn+"select",gw=sn+"cursor-x",_w=sn+"cursor-y",vw=sn+"cursor-pt",xw=sn+"legend",yw=sn+"live",Mw=sn+"inline",Sw=sn+"series",Ew=sn+"marker",Bf=sn+"label",ww=sn+"value",ro="width",oo="height",to="top",zf="bottom",ur="left",Jl="right",Ah="#000",Hf=Ah+"0",Ql="mousemove",Vf="mousedown",tc="mouseup",Gf="mouseenter",Wf="mouseleave",Xf="dblclick",Tw="resize",bw="scroll",Yf="change",La="dppxchange",Rh="--",Or=typeof window<"u",Zc=Or?document:null,xr=Or?window:null,Aw=Or?navigator:null;let Me,fa;function Jc(){let i=devicePixelRatio;Me!=i&&(Me=i,fa&&th(Yf,fa,Jc),fa=matchMedia(`(min-resolution: ${Me-.001}dppx) and (max-resolution: ${Me+.001}dppx)`),Is(Yf,fa,Jc),xr.dispatchEvent(new CustomEvent(La)))}function Gn(i,t){if(t!=null){let e=i.classList;!e.contains(t)&&e.add(t)}}function Qc(i,t){let e=i.classList;e.contains(t)&&e.remove(t)}function ze(i,t,e){i.style[t]=e+"px"}function fi(i,t,e,n){let s=Zc.createElement(i);return t!=null&&Gn(s,t),e?.insertBefore(s,n),s}function ti(i,t){return fi("div",i,t)}const qf=new WeakMap;function Ei(i,t,e,n,s){let r="translate("+t+"px,"+e+"px)",o=qf.get(i);r!=o&&(i.style.transform=r,qf.set(i,r),t<0||e<0||t>n||e>s?Gn(i,Ds):Qc(i,Ds))}const $f=new WeakMap;function jf(i,t,e){let n=t+e,s=$f.get(i);n!=s&&($f.set(i,n),i.style.background=t,i.style.borderColor=e)}const Kf=new WeakMap;function Zf(i,t,e,n){let s=t+""+e,r=Kf.get(i);s!=r&&(Kf.set(i,s),i.style.height=e+"px",i.style.width=t+"px",i.style.marginLeft=n?-t/2+"px":0,i.style.marginTop=n?-e/2+"px":0)}const Ch={passive:!0},Rw={...Ch,capture:!0};function Is(i,t,e,n){t.addEventListener(i,e,n?Rw:Ch)}function th(i,t,e,n){t.removeEventListener(i,e,Ch)}Or&&Jc();function di(i,t,e,n){let s;e=e||0,n=n||t.length-1;let r=n<=2147483647;for(;n-e>1;)s=r?e+n>>1:qn((e+n)/2),t[s]<i?e=s:n=s;return i-t[e]<=t[n]-i?e:n}function kp(i){return(e,n,s)=>{let r=-1,o=-1;for(let a=n;a<=s;a++)if(i(e[a])){r=a;break}for(let a=s;a>=n;a--)if(i(e[a])){o=a;break}return[r,o]}}const Bp=i=>i!=null,zp=i=>i!=null&&i>0,Ga=kp(Bp),Cw=kp(zp);function Pw(i,t,e,n=0,s=!1){let r=s?Cw:Ga,o=s?zp:Bp;[t,e]=r(i,t,e);let a=i[t],l=i[t];if(t>-1)if(n==1)a=i[t],l=i[e];else if(n==-1)a=i[e],l=i[t];else for(let c=t;c<=e;c++){let u=i[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Pe,l??-Pe]}function Wa(i,t,e,n){let s=td(i),r=td(t);i==t&&(s==-1?(i*=e,t/=e):(i/=e,t*=e));let o=e==10?Wi:Hp,a=s==1?qn:ei,l=r==1?ei:qn,c=a(o(Qe(i))),u=l(o(Qe(t))),h=Rr(e,c),f=Rr(e,u);return e==10&&(c<0&&(h=De(h,-c)),u<0&&(f=De(f,-u))),n||e==2?(i=h*s,t=f*r):(i=Xp(i,h),t=Xa(t,f)),[i,t]}function Ph(i,t,e,n){let s=Wa(i,t,e,n);return i==0&&(s[0]=0),t==0&&(s[1]=0),s}const Dh=.1,Jf={mode:3,pad:Dh},uo={pad:0,soft:null,mode:0},Dw={min:uo,max:uo};function Ua(i,t,e,n){return Ya(e)?Qf(i,t,e):(uo.pad=e,uo.soft=n?0:null,uo.mode=n?3:0,Qf(i,t,Dw))}function _e(i,t){return i??t}function Lw(i,t,e){for(t=_e(t,0),e=_e(e,i.length-1);t<=e;){if(i[t]!=null)return!0;t++}return!1}function Qf(i,t,e){let n=e.min,s=e.max,r=_e(n.pad,0),o=_e(s.pad,0),a=_e(n.hard,-Pe),l=_e(s.hard,Pe),c=_e(n.soft,Pe),u=_e(s.soft,-Pe),h=_e(n.mode,0),f=_e(s.mode,0),d=t-i,g=Wi(d),v=An(Qe(i),Qe(t)),m=Wi(v),p=Qe(m-g);(d<1e-24||p>10)&&(d=0,(i==0||t==0)&&(d=1e-24,h==2&&c!=Pe&&(r=0),f==2&&u!=-Pe&&(o=0)));let w=d||v||1e3,T=Wi(w),M=Rr(10,qn(T)),U=w*(d==0?i==0?.1:1:r),D=De(Xp(i-U,M/10),24),I=i>=c&&(h==1||h==3&&D<=c||h==2&&D>=c)?c:Pe,k=An(a,D<I&&i>=I?I:mi(I,D)),b=w*(d==0?t==0?.1:1:o),E=De(Xa(t+b,M/10),24),C=t<=u&&(f==1||f==3&&E>=u||f==2&&E<=u)?u:-Pe,G=mi(l,E>C&&t<=C?C:An(C,E));return k==G&&k==0&&(G=100),[k,G]}const Uw=new Intl.NumberFormat(Or?Aw.language:"en-US"),Lh=i=>Uw.format(i),jn=Math,Sa=jn.PI,Qe=jn.abs,qn=jn.floor,Je=jn.round,ei=jn.ceil,mi=jn.min,An=jn.max,Rr=jn.pow,td=jn.sign,Wi=jn.log10,Hp=jn.log2,Iw=(i,t=1)=>jn.sinh(i)*t,ec=(i,t=1)=>jn.asinh(i/t),Pe=1/0;function ed(i){return(Wi((i^i>>31)-(i>>31))|0)+1}function eh(i,t,e){return mi(An(i,t),e)}function Vp(i){return typeof i=="function"}function ce(i){return Vp(i)?i:()=>i}const Nw=()=>{},Gp=i=>i,Wp=(i,t)=>t,Fw=i=>null,nd=i=>!0,id=(i,t)=>i==t,Ow=/\.\d*?(?=9{6,}|0{6,})/gm,Bs=i=>{if(qp(i)||ds.has(i))return i;const t=`${i}`,e=t.match(Ow);if(e==null)return i;let n=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${Bs(s)}e${r}`}return De(i,n)};function As(i,t){return Bs(De(Bs(i/t))*t)}function Xa(i,t){return Bs(ei(Bs(i/t))*t)}function Xp(i,t){return Bs(qn(Bs(i/t))*t)}function De(i,t=0){if(qp(i))return i;let e=10**t,n=i*e*(1+Number.EPSILON);return Je(n)/e}const ds=new Map;function Yp(i){return((""+i).split(".")[1]||"").length}function wo(i,t,e,n){let s=[],r=n.map(Yp);for(let o=t;o<e;o++){let a=Qe(o),l=De(Rr(i,o),a);for(let c=0;c<n.length;c++){let u=i==10?+`${n[c]}e${o}`:n[c]*l,h=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=i==10?u:De(u,h);s.push(f),ds.set(f,h)}}return s}const fo={},Uh=[],Cr=[null,null],as=Array.isArray,qp=Number.isInteger,kw=i=>i===void 0;function sd(i){return typeof i=="string"}function Ya(i){let t=!1;if(i!=null){let e=i.constructor;t=e==null||e==Object}return t}function Bw(i){return i!=null&&typeof i=="object"}const zw=Object.getPrototypeOf(Uint8Array),$p="__proto__";function Pr(i,t=Ya){let e;if(as(i)){let n=i.find(s=>s!=null);if(as(n)||t(n)){e=Array(i.length);for(let s=0;s<i.length;s++)e[s]=Pr(i[s],t)}else e=i.slice()}else if(i instanceof zw)e=i.slice();else if(t(i)){e={};for(let n in i)n!=$p&&(e[n]=Pr(i[n],t))}else e=i;return e}function je(i){let t=arguments;for(let e=1;e<t.length;e++){let n=t[e];for(let s in n)s!=$p&&(Ya(i[s])?je(i[s],Pr(n[s])):i[s]=Pr(n[s]))}return i}const Hw=0,Vw=1,Gw=2;function Ww(i,t,e){for(let n=0,s,r=-1;n<t.length;n++){let o=t[n];if(o>r){for(s=o-1;s>=0&&i[s]==null;)i[s--]=null;for(s=o+1;s<e&&i[s]==null;)i[r=s++]=null}}}function Xw(i,t){if($w(i)){let o=i[0].slice();for(let a=1;a<i.length;a++)o.push(...i[a].slice(1));return jw(o[0])||(o=qw(o)),o}let e=new Set;for(let o=0;o<i.length;o++){let l=i[o][0],c=l.length;for(let u=0;u<c;u++)e.add(l[u])}let n=[Array.from(e).sort((o,a)=>o-a)],s=n[0].length,r=new Map;for(let o=0;o<s;o++)r.set(n[0][o],o);for(let o=0;o<i.length;o++){let a=i[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],h=Array(s).fill(void 0),f=t?t[o][c]:Vw,d=[];for(let g=0;g<u.length;g++){let v=u[g],m=r.get(l[g]);v===null?f!=Hw&&(h[m]=v,f==Gw&&d.push(m)):h[m]=v}Ww(h,d,s),n.push(h)}}return n}const Yw=typeof queueMicrotask>"u"?i=>Promise.resolve().then(i):queueMicrotask;function qw(i){let t=i[0],e=t.length,n=Array(e);for(let r=0;r<n.length;r++)n[r]=r;n.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<i.length;r++){let o=i[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[n[l]];s.push(a)}return s}function $w(i){let t=i[0][0],e=t.length;for(let n=1;n<i.length;n++){let s=i[n][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function jw(i,t=100){const e=i.length;if(e<=1)return!0;let n=0,s=e-1;for(;n<=s&&i[n]==null;)n++;for(;s>=n&&i[s]==null;)s--;if(s<=n)return!0;const r=An(1,qn((s-n+1)/t));for(let o=i[n],a=n+r;a<=s;a+=r){const l=i[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}const jp=["January","February","March","April","May","June","July","August","September","October","November","December"],Kp=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Zp(i){return i.slice(0,3)}const Kw=Kp.map(Zp),Zw=jp.map(Zp),Jw={MMMM:jp,MMM:Zw,WWWW:Kp,WWW:Kw};function eo(i){return(i<10?"0":"")+i}function Qw(i){return(i<10?"00":i<100?"0":"")+i}const tT={YYYY:i=>i.getFullYear(),YY:i=>(i.getFullYear()+"").slice(2),MMMM:(i,t)=>t.MMMM[i.getMonth()],MMM:(i,t)=>t.MMM[i.getMonth()],MM:i=>eo(i.getMonth()+1),M:i=>i.getMonth()+1,DD:i=>eo(i.getDate()),D:i=>i.getDate(),WWWW:(i,t)=>t.WWWW[i.getDay()],WWW:(i,t)=>t.WWW[i.getDay()],HH:i=>eo(i.getHours()),H:i=>i.getHours(),h:i=>{let t=i.getHours();return t==0?12:t>12?t-12:t},AA:i=>i.getHours()>=12?"PM":"AM",aa:i=>i.getHours()>=12?"pm":"am",a:i=>i.getHours()>=12?"p":"a",mm:i=>eo(i.getMinutes()),m:i=>i.getMinutes(),ss:i=>eo(i.getSeconds()),s:i=>i.getSeconds(),fff:i=>Qw(i.getMilliseconds())};function Ih(i,t){t=t||Jw;let e=[],n=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=n.exec(i);)e.push(s[0][0]=="{"?tT[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}const eT=new Intl.DateTimeFormat().resolvedOptions().timeZone;function nT(i,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+i+i.getTimezoneOffset()*6e4):t==eT?e=i:(e=new Date(i.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(i.getMilliseconds())),e}const Jp=i=>i%1==0,Ia=[1,2,2.5,5],iT=wo(10,-32,0,Ia),Qp=wo(10,0,32,Ia),sT=Qp.filter(Jp),Rs=iT.concat(Qp),Nh=`
`,tm="{YYYY}",rd=Nh+tm,em="{M}/{D}",ao=Nh+em,da=ao+"/{YY}",nm="{aa}",rT="{h}:{mm}",fr=rT+nm,od=Nh+fr,ad=":{ss}",Se=null;function im(i){let t=i*1e3,e=t*60,n=e*60,s=n*24,r=s*30,o=s*365,l=(i==1?wo(10,0,3,Ia).filter(Jp):wo(10,-3,0,Ia)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,n,n*2,n*3,n*4,n*6,n*8,n*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]);const c=[[o,tm,Se,Se,Se,Se,Se,Se,1],[s*28,"{MMM}",rd,Se,Se,Se,Se,Se,1],[s,em,rd,Se,Se,Se,Se,Se,1],[n,"{h}"+nm,da,Se,ao,Se,Se,Se,1],[e,fr,da,Se,ao,Se,Se,Se,1],[t,ad,da+" "+fr,Se,ao+" "+fr,Se,od,Se,1],[i,ad+".{fff}",da+" "+fr,Se,ao+" "+fr,Se,od,Se,1]];function u(h){return(f,d,g,v,m,p)=>{let w=[],T=m>=o,M=m>=r&&m<o,U=h(g),D=De(U*i,3),I=nc(U.getFullYear(),T?0:U.getMonth(),M||T?1:U.getDate()),k=De(I*i,3);if(M||T){let b=M?m/r:0,E=T?m/o:0,C=D==k?D:De(nc(I.getFullYear()+E,I.getMonth()+b,1)*i,3),G=new Date(Je(C/i)),H=G.getFullYear(),$=G.getMonth();for(let W=0;C<=v;W++){let Z=nc(H+E*W,$+b*W,1),Y=Z-h(De(Z*i,3));C=De((+Z+Y)*i,3),C<=v&&w.push(C)}}else{let b=m>=s?s:m,E=qn(g)-qn(D),C=k+E+Xa(D-k,b);w.push(C);let G=h(C),H=G.getHours()+G.getMinutes()/e+G.getSeconds()/n,$=m/n,W=f.axes[d]._space,Z=p/W;for(;C=De(C+m,i==1?0:3),!(C>v);)if($>1){let Y=qn(De(H+$,6))%24,at=h(C).getHours()-Y;at>1&&(at=-1),C-=at*n,H=(H+$)%24;let _t=w[w.length-1];De((C-_t)/m,3)*Z>=.7&&w.push(C)}else w.push(C)}return w}}return[l,c,u]}const[oT,aT,lT]=im(1),[cT,hT,uT]=im(.001);wo(2,-53,53,[1]);function ld(i,t){return i.map(e=>e.map((n,s)=>s==0||s==8||n==null?n:t(s==1||e[8]==0?n:e[1]+n)))}function cd(i,t){return(e,n,s,r,o)=>{let a=t.find(g=>o>=g[0])||t[t.length-1],l,c,u,h,f,d;return n.map(g=>{let v=i(g),m=v.getFullYear(),p=v.getMonth(),w=v.getDate(),T=v.getHours(),M=v.getMinutes(),U=v.getSeconds(),D=m!=l&&a[2]||p!=c&&a[3]||w!=u&&a[4]||T!=h&&a[5]||M!=f&&a[6]||U!=d&&a[7]||a[1];return l=m,c=p,u=w,h=T,f=M,d=U,D(v)})}}function fT(i,t){let e=Ih(t);return(n,s,r,o,a)=>s.map(l=>e(i(l)))}function nc(i,t,e){return new Date(i,t,e)}function hd(i,t){return t(i)}const dT="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function ud(i,t){return(e,n,s,r)=>r==null?Rh:t(i(n))}function pT(i,t){let e=i.series[t];return e.width?e.stroke(i,t):e.points.width?e.points.stroke(i,t):null}function mT(i,t){return i.series[t].fill(i,t)}const gT={show:!0,live:!0,isolate:!1,mount:Nw,markers:{show:!0,width:2,stroke:pT,fill:mT,dash:"solid"},idx:null,idxs:null,values:[]};function _T(i,t){let e=i.cursor.points,n=ti(),s=e.size(i,t);ze(n,ro,s),ze(n,oo,s);let r=s/-2;ze(n,"marginLeft",r),ze(n,"marginTop",r);let o=e.width(i,t,s);return o&&ze(n,"borderWidth",o),n}function vT(i,t){let e=i.series[t].points;return e._fill||e._stroke}function xT(i,t){let e=i.series[t].points;return e._stroke||e._fill}function yT(i,t){return i.series[t].points.size}const ic=[0,0];function MT(i,t,e){return ic[0]=t,ic[1]=e,ic}function pa(i,t,e,n=!0){return s=>{s.button==0&&(!n||s.target==t)&&e(s)}}function sc(i,t,e,n=!0){return s=>{(!n||s.target==t)&&e(s)}}const ST={show:!0,x:!0,y:!0,lock:!1,move:MT,points:{one:!1,show:_T,size:yT,width:0,stroke:xT,fill:vT},bind:{mousedown:pa,mouseup:pa,click:pa,dblclick:pa,mousemove:sc,mouseleave:sc,mouseenter:sc},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(i,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(i,t,e,n,s)=>n-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},sm={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Fh=je({},sm,{filter:Wp}),rm=je({},Fh,{size:10}),om=je({},sm,{show:!1}),Oh='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',am="bold "+Oh,lm=1.5,fd={show:!0,scale:"x",stroke:Ah,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:am,side:2,grid:Fh,ticks:rm,border:om,font:Oh,lineGap:lm,rotate:0},ET="Value",wT="Time",dd={show:!0,scale:"x",auto:!1,sorted:1,min:Pe,max:-Pe,idxs:[]};function TT(i,t,e,n,s){return t.map(r=>r==null?"":Lh(r))}function bT(i,t,e,n,s,r,o){let a=[],l=ds.get(s)||0;e=o?e:De(Xa(e,s),l);for(let c=e;c<=n;c=De(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function nh(i,t,e,n,s,r,o){const a=[],l=i.scales[i.axes[t].scale].log,c=l==10?Wi:Hp,u=qn(c(e));s=Rr(l,u),l==10&&(s=Rs[di(s,Rs)]);let h=e,f=s*l;l==10&&(f=Rs[di(f,Rs)]);do a.push(h),h=h+s,l==10&&!ds.has(h)&&(h=De(h,ds.get(s))),h>=f&&(s=h,f=s*l,l==10&&(f=Rs[di(f,Rs)]));while(h<=n);return a}function AT(i,t,e,n,s,r,o){let l=i.scales[i.axes[t].scale].asinh,c=n>l?nh(i,t,An(l,e),n,s):[l],u=n>=0&&e<=0?[0]:[];return(e<-l?nh(i,t,An(l,-n),-e,s):[l]).reverse().map(f=>-f).concat(u,c)}const cm=/./,RT=/[12357]/,CT=/[125]/,pd=/1/,ih=(i,t,e,n)=>i.map((s,r)=>t==4&&s==0||r%n==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function PT(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=i.scales[o],l=i.valToPos,c=r._space,u=l(10,o),h=l(9,o)-u>=c?cm:l(7,o)-u>=c?RT:l(5,o)-u>=c?CT:pd;if(h==pd){let f=Qe(l(1,o)-u);if(f<c)return ih(t.slice().reverse(),a.distr,h,ei(c/f)).reverse()}return ih(t,a.distr,h,1)}function DT(i,t,e,n,s){let r=i.axes[e],o=r.scale,a=r._space,l=i.valToPos,c=Qe(l(1,o)-l(2,o));return c<a?ih(t.slice().reverse(),3,cm,ei(a/c)).reverse():t}function LT(i,t,e,n){return n==null?Rh:t==null?"":Lh(t)}const md={show:!0,scale:"y",stroke:Ah,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:am,side:3,grid:Fh,ticks:rm,border:om,font:Oh,lineGap:lm,rotate:0};function UT(i,t){let e=3+(i||1)*2;return De(e*t,3)}function IT(i,t){let{scale:e,idxs:n}=i.series[0],s=i._data[0],r=i.valToPos(s[n[0]],e,!0),o=i.valToPos(s[n[1]],e,!0),a=Qe(o-r),l=i.series[t],c=a/(l.points.space*Me);return n[1]-n[0]<=c}const gd={scale:null,auto:!0,sorted:0,min:Pe,max:-Pe},hm=(i,t,e,n,s)=>s,_d={show:!0,auto:!0,sorted:0,gaps:hm,alpha:1,facets:[je({},gd,{scale:"x"}),je({},gd,{scale:"y"})]},vd={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:hm,alpha:1,points:{show:IT,filter:null},values:null,min:Pe,max:-Pe,idxs:[],path:null,clip:null};function NT(i,t,e,n,s){return e/10}const um={time:ow,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},FT=je({},um,{time:!1,ori:1}),xd={};function fm(i,t){let e=xd[i];return e||(e={key:i,plots:[],sub(n){e.plots.push(n)},unsub(n){e.plots=e.plots.filter(s=>s!=n)},pub(n,s,r,o,a,l,c){for(let u=0;u<e.plots.length;u++)e.plots[u]!=s&&e.plots[u].pub(n,s,r,o,a,l,c)}},i!=null&&(xd[i]=e)),e}const Dr=1,sh=2;function Hs(i,t,e){const n=i.mode,s=i.series[t],r=n==2?i._data[t]:i._data,o=i.scales,a=i.bbox;let l=r[0],c=n==2?r[1]:r[t],u=n==2?o[s.facets[0].scale]:o[i.series[0].scale],h=n==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,g=a.width,v=a.height,m=i.valToPosH,p=i.valToPosV;return u.ori==0?e(s,l,c,u,h,m,p,f,d,g,v,$a,kr,Ka,pm,gm):e(s,l,c,u,h,p,m,d,f,v,g,ja,Br,zh,mm,_m)}function kh(i,t){let e=0,n=0,s=_e(i.bands,Uh);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?n|=1:n|=2)}return[e,n==1?-1:n==2?1:n==3?2:0]}function OT(i,t,e,n,s){let r=i.mode,o=i.series[t],a=r==2?o.facets[1].scale:o.scale,l=i.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Xi(i,t,e,n,s,r){return Hs(i,t,(o,a,l,c,u,h,f,d,g,v,m)=>{let p=o.pxRound;const w=c.dir*(c.ori==0?1:-1),T=c.ori==0?kr:Br;let M,U;w==1?(M=e,U=n):(M=n,U=e);let D=p(h(a[M],c,v,d)),I=p(f(l[M],u,m,g)),k=p(h(a[U],c,v,d)),b=p(f(r==1?u.max:u.min,u,m,g)),E=new Path2D(s);return T(E,k,b),T(E,D,b),T(E,D,I),E})}function qa(i,t,e,n,s,r){let o=null;if(i.length>0){o=new Path2D;const a=t==0?Ka:zh;let l=e;for(let h=0;h<i.length;h++){let f=i[h];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,n,d,n+r),l=f[1]}}let c=e+s-l,u=10;c>0&&a(o,l,n-u/2,c,n+r+u)}return o}function kT(i,t,e){let n=i[i.length-1];n&&n[0]==t?n[1]=e:i.push([t,e])}function Bh(i,t,e,n,s,r,o){let a=[],l=i.length;for(let c=s==1?e:n;c>=e&&c<=n;c+=s)if(t[c]===null){let h=c,f=c;if(s==1)for(;++c<=n&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(i[h]),g=f==h?d:r(i[f]),v=h-s;d=o<=0&&v>=0&&v<l?r(i[v]):d;let p=f+s;g=o>=0&&p>=0&&p<l?r(i[p]):g,g>=d&&a.push([d,g])}return a}function yd(i){return i==0?Gp:i==1?Je:t=>As(t,i)}function dm(i){let t=i==0?$a:ja,e=i==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},n=i==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?n(s,r,o,a,l):(c=mi(c,a/2,l/2),u=mi(u,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,u),e(s,r,o+l,r,o,u),e(s,r,o,r+a,o,c),s.closePath())}}const $a=(i,t,e)=>{i.moveTo(t,e)},ja=(i,t,e)=>{i.moveTo(e,t)},kr=(i,t,e)=>{i.lineTo(t,e)},Br=(i,t,e)=>{i.lineTo(e,t)},Ka=dm(0),zh=dm(1),pm=(i,t,e,n,s,r)=>{i.arc(t,e,n,s,r)},mm=(i,t,e,n,s,r)=>{i.arc(e,t,n,s,r)},gm=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(t,e,n,s,r,o)},_m=(i,t,e,n,s,r,o)=>{i.bezierCurveTo(e,t,s,n,o,r)};function vm(i){return(t,e,n,s,r)=>Hs(t,e,(o,a,l,c,u,h,f,d,g,v,m)=>{let{pxRound:p,points:w}=o,T,M;c.ori==0?(T=$a,M=pm):(T=ja,M=mm);const U=De(w.width*Me,3);let D=(w.size-w.width)/2*Me,I=De(D*2,3),k=new Path2D,b=new Path2D,{left:E,top:C,width:G,height:H}=t.bbox;Ka(b,E-I,C-I,G+I*2,H+I*2);const $=W=>{if(l[W]!=null){let Z=p(h(a[W],c,v,d)),Y=p(f(l[W],u,m,g));T(k,Z+D,Y),M(k,Z,Y,D,0,Sa*2)}};if(r)r.forEach($);else for(let W=n;W<=s;W++)$(W);return{stroke:U>0?k:null,fill:k,clip:b,flags:Dr|sh}})}function xm(i){return(t,e,n,s,r,o)=>{n!=s&&(r!=n&&o!=n&&i(t,e,n),r!=s&&o!=s&&i(t,e,s),i(t,e,o))}}const BT=xm(kr),zT=xm(Br);function ym(i){const t=_e(i?.alignGaps,0);return(e,n,s,r)=>Hs(e,n,(o,a,l,c,u,h,f,d,g,v,m)=>{[s,r]=Ga(l,s,r);let p=o.pxRound,w=H=>p(h(H,c,v,d)),T=H=>p(f(H,u,m,g)),M,U;c.ori==0?(M=kr,U=BT):(M=Br,U=zT);const D=c.dir*(c.ori==0?1:-1),I={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Dr},k=I.stroke;let b=!1;if(r-s>=v*4){let H=gt=>e.posToVal(gt,c.key,!0),$=null,W=null,Z,Y,J,ot=w(a[D==1?s:r]),at=w(a[s]),_t=w(a[r]),yt=H(D==1?at+1:_t-1);for(let gt=D==1?s:r;gt>=s&&gt<=r;gt+=D){let ee=a[gt],Q=(D==1?ee<yt:ee>yt)?ot:w(ee),et=l[gt];Q==ot?et!=null?(Y=et,$==null?(M(k,Q,T(Y)),Z=$=W=Y):Y<$?$=Y:Y>W&&(W=Y)):et===null&&(b=!0):($!=null&&U(k,ot,T($),T(W),T(Z),T(Y)),et!=null?(Y=et,M(k,Q,T(Y)),$=W=Z=Y):($=W=null,et===null&&(b=!0)),ot=Q,yt=H(ot+D))}$!=null&&$!=W&&J!=ot&&U(k,ot,T($),T(W),T(Z),T(Y))}else for(let H=D==1?s:r;H>=s&&H<=r;H+=D){let $=l[H];$===null?b=!0:$!=null&&M(k,w(a[H]),T($))}let[C,G]=kh(e,n);if(o.fill!=null||C!=0){let H=I.fill=new Path2D(k),$=o.fillTo(e,n,o.min,o.max,C),W=T($),Z=w(a[s]),Y=w(a[r]);D==-1&&([Y,Z]=[Z,Y]),M(H,Y,W),M(H,Z,W)}if(!o.spanGaps){let H=[];b&&H.push(...Bh(a,l,s,r,D,w,t)),I.gaps=H=o.gaps(e,n,s,r,H),I.clip=qa(H,c.ori,d,g,v,m)}return G!=0&&(I.band=G==2?[Xi(e,n,s,r,k,-1),Xi(e,n,s,r,k,1)]:Xi(e,n,s,r,k,G)),I})}function HT(i){const t=_e(i.align,1),e=_e(i.ascDesc,!1),n=_e(i.alignGaps,0),s=_e(i.extend,!1);return(r,o,a,l)=>Hs(r,o,(c,u,h,f,d,g,v,m,p,w,T)=>{[a,l]=Ga(h,a,l);let M=c.pxRound,{left:U,width:D}=r.bbox,I=at=>M(g(at,f,w,m)),k=at=>M(v(at,d,T,p)),b=f.ori==0?kr:Br;const E={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Dr},C=E.stroke,G=f.dir*(f.ori==0?1:-1);let H=k(h[G==1?a:l]),$=I(u[G==1?a:l]),W=$,Z=$;s&&t==-1&&(Z=U,b(C,Z,H)),b(C,$,H);for(let at=G==1?a:l;at>=a&&at<=l;at+=G){let _t=h[at];if(_t==null)continue;let yt=I(u[at]),gt=k(_t);t==1?b(C,yt,H):b(C,W,gt),b(C,yt,gt),H=gt,W=yt}let Y=W;s&&t==1&&(Y=U+D,b(C,Y,H));let[J,ot]=kh(r,o);if(c.fill!=null||J!=0){let at=E.fill=new Path2D(C),_t=c.fillTo(r,o,c.min,c.max,J),yt=k(_t);b(at,Y,yt),b(at,Z,yt)}if(!c.spanGaps){let at=[];at.push(...Bh(u,h,a,l,G,I,n));let _t=c.width*Me/2,yt=e||t==1?_t:-_t,gt=e||t==-1?-_t:_t;at.forEach(ee=>{ee[0]+=yt,ee[1]+=gt}),E.gaps=at=c.gaps(r,o,a,l,at),E.clip=qa(at,f.ori,m,p,w,T)}return ot!=0&&(E.band=ot==2?[Xi(r,o,a,l,C,-1),Xi(r,o,a,l,C,1)]:Xi(r,o,a,l,C,ot)),E})}function Md(i,t,e,n,s,r,o=Pe){if(i.length>1){let a=null;for(let l=0,c=1/0;l<i.length;l++)if(t[l]!==void 0){if(a!=null){let u=Qe(i[l]-i[a]);u<c&&(c=u,o=Qe(e(i[l],n,s,r)-e(i[a],n,s,r)))}a=l}}return o}function VT(i){i=i||fo;const t=_e(i.size,[.6,Pe,1]),e=i.align||0,n=i.gap||0;let s=i.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;const r=ce(s),o=1-t[0],a=_e(t[1],Pe),l=_e(t[2],1),c=_e(i.disp,fo),u=_e(i.each,d=>{}),{fill:h,stroke:f}=c;return(d,g,v,m)=>Hs(d,g,(p,w,T,M,U,D,I,k,b,E,C)=>{let G=p.pxRound,H=e,$=n*Me,W=a*Me,Z=l*Me,Y,J;M.ori==0?[Y,J]=r(d,g):[J,Y]=r(d,g);const ot=M.dir*(M.ori==0?1:-1);let at=M.ori==0?Ka:zh,_t=M.ori==0?u:(N,j,nt,tt,Nt,ht,Dt)=>{u(N,j,nt,Nt,tt,Dt,ht)},yt=_e(d.bands,Uh).find(N=>N.series[0]==g),gt=yt!=null?yt.dir:0,ee=p.fillTo(d,g,p.min,p.max,gt),Zt=G(I(ee,U,C,b)),Q,et,Et,Bt=E,vt=G(p.width*Me),Jt=!1,Le=null,L=null,fe=null,$t=null;h!=null&&(vt==0||f!=null)&&(Jt=!0,Le=h.values(d,g,v,m),L=new Map,new Set(Le).forEach(N=>{N!=null&&L.set(N,new Path2D)}),vt>0&&(fe=f.values(d,g,v,m),$t=new Map,new Set(fe).forEach(N=>{N!=null&&$t.set(N,new Path2D)})));let{x0:Wt,size:It}=c;if(Wt!=null&&It!=null){H=1,w=Wt.values(d,g,v,m),Wt.unit==2&&(w=w.map(nt=>d.posToVal(k+nt*E,M.key,!0)));let N=It.values(d,g,v,m);It.unit==2?et=N[0]*E:et=D(N[0],M,E,k)-D(0,M,E,k),Bt=Md(w,T,D,M,E,k,Bt),Et=Bt-et+$}else Bt=Md(w,T,D,M,E,k,Bt),Et=Bt*o+$,et=Bt-Et;Et<1&&(Et=0),vt>=et/2&&(vt=0),Et<5&&(G=Gp);let Ee=Et>0,Ct=Bt-Et-(Ee?vt:0);et=G(eh(Ct,Z,W)),Q=(H==0?et/2:H==ot?0:et)-H*ot*((H==0?$/2:0)+(Ee?vt/2:0));const Vt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Fe=Jt?null:new Path2D;let xe=null;if(yt!=null)xe=d.data[yt.series[1]];else{let{y0:N,y1:j}=c;N!=null&&j!=null&&(T=j.values(d,g,v,m),xe=N.values(d,g,v,m))}let R=Y*et,x=J*et;for(let N=ot==1?v:m;N>=v&&N<=m;N+=ot){let j=T[N];if(j==null)continue;if(xe!=null){let mt=xe[N]??0;if(j-mt==0)continue;Zt=I(mt,U,C,b)}let nt=M.distr!=2||c!=null?w[N]:N,tt=D(nt,M,E,k),Nt=I(_e(j,ee),U,C,b),ht=G(tt-Q),Dt=G(An(Nt,Zt)),bt=G(mi(Nt,Zt)),rt=Dt-bt;if(j!=null){let mt=j<0?x:R,kt=j<0?R:x;Jt?(vt>0&&fe[N]!=null&&at($t.get(fe[N]),ht,bt+qn(vt/2),et,An(0,rt-vt),mt,kt),Le[N]!=null&&at(L.get(Le[N]),ht,bt+qn(vt/2),et,An(0,rt-vt),mt,kt)):at(Fe,ht,bt+qn(vt/2),et,An(0,rt-vt),mt,kt),_t(d,g,N,ht-vt/2,bt,et+vt,rt)}}return vt>0?Vt.stroke=Jt?$t:Fe:Jt||(Vt._fill=p.width==0?p._fill:p._stroke??p._fill,Vt.width=0),Vt.fill=Jt?L:Fe,Vt})}function GT(i,t){const e=_e(t?.alignGaps,0);return(n,s,r,o)=>Hs(n,s,(a,l,c,u,h,f,d,g,v,m,p)=>{[r,o]=Ga(c,r,o);let w=a.pxRound,T=Y=>w(f(Y,u,m,g)),M=Y=>w(d(Y,h,p,v)),U,D,I;u.ori==0?(U=$a,I=kr,D=gm):(U=ja,I=Br,D=_m);const k=u.dir*(u.ori==0?1:-1);let b=T(l[k==1?r:o]),E=b,C=[],G=[];for(let Y=k==1?r:o;Y>=r&&Y<=o;Y+=k)if(c[Y]!=null){let ot=l[Y],at=T(ot);C.push(E=at),G.push(M(c[Y]))}const H={stroke:i(C,G,U,I,D,w),fill:null,clip:null,band:null,gaps:null,flags:Dr},$=H.stroke;let[W,Z]=kh(n,s);if(a.fill!=null||W!=0){let Y=H.fill=new Path2D($),J=a.fillTo(n,s,a.min,a.max,W),ot=M(J);I(Y,E,ot),I(Y,b,ot)}if(!a.spanGaps){let Y=[];Y.push(...Bh(l,c,r,o,k,T,e)),H.gaps=Y=a.gaps(n,s,r,o,Y),H.clip=qa(Y,u.ori,g,v,m,p)}return Z!=0&&(H.band=Z==2?[Xi(n,s,r,o,$,-1),Xi(n,s,r,o,$,1)]:Xi(n,s,r,o,$,Z)),H})}function WT(i){return GT(XT,i)}function XT(i,t,e,n,s,r){const o=i.length;if(o<2)return null;const a=new Path2D;if(e(a,i[0],t[0]),o==2)n(a,i[1],t[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),h=Array(o-1);for(let f=0;f<o-1;f++)u[f]=t[f+1]-t[f],h[f]=i[f+1]-i[f],c[f]=u[f]/h[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(h[f-1]+h[f])/((2*h[f]+h[f-1])/c[f-1]+(h[f]+2*h[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,i[f]+h[f]/3,t[f]+l[f]*h[f]/3,i[f+1]-h[f]/3,t[f+1]-l[f+1]*h[f]/3,i[f+1],t[f+1])}return a}const rh=new Set;function Sd(){for(let i of rh)i.syncRect(!0)}Or&&(Is(Tw,xr,Sd),Is(bw,xr,Sd,!0),Is(La,xr,()=>{pn.pxRatio=Me}));const YT=ym(),qT=vm();function Ed(i,t,e,n){return(n?[i[0],i[1]].concat(i.slice(2)):[i[0]].concat(i.slice(1))).map((r,o)=>oh(r,o,t,e))}function $T(i,t){return i.map((e,n)=>n==0?{}:je({},t,e))}function oh(i,t,e,n){return je({},t==0?e:n,i)}function Mm(i,t,e){return t==null?Cr:[t,e]}const jT=Mm;function KT(i,t,e){return t==null?Cr:Ua(t,e,Dh,!0)}function Sm(i,t,e,n){return t==null?Cr:Wa(t,e,i.scales[n].log,!1)}const ZT=Sm;function Em(i,t,e,n){return t==null?Cr:Ph(t,e,i.scales[n].log,!1)}const JT=Em;function QT(i,t,e,n,s){let r=An(ed(i),ed(t)),o=t-i,a=di(s/n*o,e);do{let l=e[a],c=n*l/o;if(c>=s&&r+(l<5?ds.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function wd(i){let t,e;return i=i.replace(/(\d+)px/,(n,s)=>(t=Je((e=+s)*Me))+"px"),[i,t,e]}function tb(i){i.show&&[i.font,i.labelFont].forEach(t=>{let e=De(t[2]*Me,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function pn(i,t,e){const n={mode:_e(i.mode,1)},s=n.mode;function r(_,y,A,P){let O=y.valToPct(_);return P+A*(y.dir==-1?1-O:O)}function o(_,y,A,P){let O=y.valToPct(_);return P+A*(y.dir==-1?O:1-O)}function a(_,y,A,P){return y.ori==0?r(_,y,A,P):o(_,y,A,P)}n.valToPosH=r,n.valToPosV=o;let l=!1;n.status=0;const c=n.root=ti(aw);if(i.id!=null&&(c.id=i.id),Gn(c,i.class),i.title){let _=ti(hw,c);_.textContent=i.title}const u=fi("canvas"),h=n.ctx=u.getContext("2d"),f=ti(uw,c);Is("click",f,_=>{_.target===g&&(Oe!=Ys||He!=qs)&&dn.click(n,_)},!0);const d=n.under=ti(fw,f);f.appendChild(u);const g=n.over=ti(dw,f);i=Pr(i);const v=+_e(i.pxAlign,1),m=yd(v);(i.plugins||[]).forEach(_=>{_.opts&&(i=_.opts(n,i)||i)});const p=i.ms||.001,w=n.series=s==1?Ed(i.series||[],dd,vd,!1):$T(i.series||[null],_d),T=n.axes=Ed(i.axes||[],fd,md,!0),M=n.scales={},U=n.bands=i.bands||[];U.forEach(_=>{_.fill=ce(_.fill||null),_.dir=_e(_.dir,-1)});const D=s==2?w[1].facets[0].scale:w[0].scale,I={axes:Cm,series:gs},k=(i.drawOrder||["axes","series"]).map(_=>I[_]);function b(_){const y=_.distr==3?A=>Wi(A>0?A:_.clamp(n,A,_.min,_.max,_.key)):_.distr==4?A=>ec(A,_.asinh):_.distr==100?A=>_.fwd(A):A=>A;return A=>{let P=y(A),{_min:O,_max:X}=_,it=X-O;return(P-O)/it}}function E(_){let y=M[_];if(y==null){let A=(i.scales||fo)[_]||fo;if(A.from!=null){E(A.from);let P=je({},M[A.from],A,{key:_});P.valToPct=b(P),M[_]=P}else{y=M[_]=je({},_==D?um:FT,A),y.key=_;let P=y.time,O=y.range,X=as(O);if((_!=D||s==2&&!P)&&(X&&(O[0]==null||O[1]==null)&&(O={min:O[0]==null?Jf:{mode:1,hard:O[0],soft:O[0]},max:O[1]==null?Jf:{mode:1,hard:O[1],soft:O[1]}},X=!1),!X&&Ya(O))){let it=O;O=(lt,pt,Tt)=>pt==null?Cr:Ua(pt,Tt,it)}y.range=ce(O||(P?jT:_==D?y.distr==3?ZT:y.distr==4?JT:Mm:y.distr==3?Sm:y.distr==4?Em:KT)),y.auto=ce(X?!1:y.auto),y.clamp=ce(y.clamp||NT),y._min=y._max=null,y.valToPct=b(y)}}}E("x"),E("y"),s==1&&w.forEach(_=>{E(_.scale)}),T.forEach(_=>{E(_.scale)});for(let _ in i.scales)E(_);const C=M[D],G=C.distr;let H,$;C.ori==0?(Gn(c,lw),H=r,$=o):(Gn(c,cw),H=o,$=r);const W={};for(let _ in M){let y=M[_];(y.min!=null||y.max!=null)&&(W[_]={min:y.min,max:y.max},y.min=y.max=null)}const Z=i.tzDate||(_=>new Date(Je(_/p))),Y=i.fmtDate||Ih,J=p==1?lT(Z):uT(Z),ot=cd(Z,ld(p==1?aT:hT,Y)),at=ud(Z,hd(dT,Y)),_t=[],yt=n.legend=je({},gT,i.legend),gt=n.cursor=je({},ST,{drag:{y:s==2}},i.cursor),ee=yt.show,Zt=gt.show,Q=yt.markers;yt.idxs=_t,Q.width=ce(Q.width),Q.dash=ce(Q.dash),Q.stroke=ce(Q.stroke),Q.fill=ce(Q.fill);let et,Et,Bt,vt=[],Jt=[],Le,L=!1,fe={};if(yt.live){const _=w[1]?w[1].values:null;L=_!=null,Le=L?_(n,1,0):{_:0};for(let y in Le)fe[y]=Rh}if(ee)if(et=fi("table",xw,c),Bt=fi("tbody",null,et),yt.mount(n,et),L){Et=fi("thead",null,et,Bt);let _=fi("tr",null,Et);fi("th",null,_);for(var $t in Le)fi("th",Bf,_).textContent=$t}else Gn(et,Mw),yt.live&&Gn(et,yw);const Wt={show:!0},It={show:!1};function Ee(_,y){if(y==0&&(L||!yt.live||s==2))return Cr;let A=[],P=fi("tr",Sw,Bt,Bt.childNodes[y]);Gn(P,_.class),_.show||Gn(P,Ds);let O=fi("th",null,P);if(Q.show){let lt=ti(Ew,O);if(y>0){let pt=Q.width(n,y);pt&&(lt.style.border=pt+"px "+Q.dash(n,y)+" "+Q.stroke(n,y)),lt.style.background=Q.fill(n,y)}}let X=ti(Bf,O);_.label instanceof HTMLElement?X.appendChild(_.label):X.textContent=_.label,y>0&&(Q.show||(X.style.color=_.width>0?Q.stroke(n,y):Q.fill(n,y)),Vt("click",O,lt=>{if(gt._lock)return;fn(lt);let pt=w.indexOf(_);if((lt.ctrlKey||lt.metaKey)!=yt.isolate){let Tt=w.some((At,Ut)=>Ut>0&&Ut!=pt&&At.show);w.forEach((At,Ut)=>{Ut>0&&vi(Ut,Tt?Ut==pt?Wt:It:Wt,!0,qe.setSeries)})}else vi(pt,{show:!_.show},!0,qe.setSeries)},!1),Dn&&Vt(Gf,O,lt=>{gt._lock||(fn(lt),vi(w.indexOf(_),js,!0,qe.setSeries))},!1));for(var it in Le){let lt=fi("td",ww,P);lt.textContent="--",A.push(lt)}return[P,A]}const Ct=new Map;function Vt(_,y,A,P=!0){const O=Ct.get(y)||{},X=gt.bind[_](n,y,A,P);X&&(Is(_,y,O[_]=X),Ct.set(y,O))}function Fe(_,y,A){const P=Ct.get(y)||{};for(let O in P)(_==null||O==_)&&(th(O,y,P[O]),delete P[O]);_==null&&Ct.delete(y)}let xe=0,R=0,x=0,N=0,j=0,nt=0,tt=j,Nt=nt,ht=x,Dt=N,bt=0,rt=0,mt=0,kt=0;n.bbox={};let Ot=!1,xt=!1,Kt=!1,F=!1,ut=!1,dt=!1;function Pt(_,y,A){(A||_!=n.width||y!=n.height)&&ct(_,y),Vs(!1),Kt=!0,xt=!0,Gs()}function ct(_,y){n.width=xe=x=_,n.height=R=N=y,j=nt=0,Te(),de();let A=n.bbox;bt=A.left=As(j*Me,.5),rt=A.top=As(nt*Me,.5),mt=A.width=As(x*Me,.5),kt=A.height=As(N*Me,.5)}const st=3;function Ft(){let _=!1,y=0;for(;!_;){y++;let A=Am(y),P=Rm(y);_=y==st||A&&P,_||(ct(n.width,n.height),xt=!0)}}function Qt({width:_,height:y}){Pt(_,y)}n.setSize=Qt;function Te(){let _=!1,y=!1,A=!1,P=!1;T.forEach((O,X)=>{if(O.show&&O._show){let{side:it,_size:lt}=O,pt=it%2,Tt=O.label!=null?O.labelSize:0,At=lt+Tt;At>0&&(pt?(x-=At,it==3?(j+=At,P=!0):A=!0):(N-=At,it==0?(nt+=At,_=!0):y=!0))}}),Di[0]=_,Di[1]=A,Di[2]=y,Di[3]=P,x-=_i[1]+_i[3],j+=_i[3],N-=_i[2]+_i[0],nt+=_i[0]}function de(){let _=j+x,y=nt+N,A=j,P=nt;function O(X,it){switch(X){case 1:return _+=it,_-it;case 2:return y+=it,y-it;case 3:return A-=it,A+it;case 0:return P-=it,P+it}}T.forEach((X,it)=>{if(X.show&&X._show){let lt=X.side;X._pos=O(lt,X._size),X.label!=null&&(X._lpos=O(lt,X.labelSize))}})}if(gt.dataIdx==null){let _=gt.hover,y=_.skip=new Set(_.skip??[]);y.add(void 0);let A=_.prox=ce(_.prox),P=_.bias??=0;gt.dataIdx=(O,X,it,lt)=>{if(X==0)return it;let pt=it,Tt=A(O,X,it,lt)??Pe,At=Tt>=0&&Tt<Pe,Ut=C.ori==0?x:N,te=gt.left,ye=t[0],me=t[X];if(y.has(me[it])){pt=null;let ae=null,jt=null,Ht;if(P==0||P==-1)for(Ht=it;ae==null&&Ht-- >0;)y.has(me[Ht])||(ae=Ht);if(P==0||P==1)for(Ht=it;jt==null&&Ht++<me.length;)y.has(me[Ht])||(jt=Ht);if(ae!=null||jt!=null)if(At){let Be=ae==null?-1/0:H(ye[ae],C,Ut,0),Ge=jt==null?1/0:H(ye[jt],C,Ut,0),hn=te-Be,be=Ge-te;hn<=be?hn<=Tt&&(pt=ae):be<=Tt&&(pt=jt)}else pt=jt==null?ae:ae==null?jt:it-ae<=jt-it?ae:jt}else At&&Qe(te-H(ye[it],C,Ut,0))>Tt&&(pt=null);return pt}}const fn=_=>{gt.event=_};gt.idxs=_t,gt._lock=!1;let Ce=gt.points;Ce.show=ce(Ce.show),Ce.size=ce(Ce.size),Ce.stroke=ce(Ce.stroke),Ce.width=ce(Ce.width),Ce.fill=ce(Ce.fill);const On=n.focus=je({},i.focus||{alpha:.3},gt.focus),Dn=On.prox>=0,gi=Dn&&Ce.one;let yn=[],Pi=[],oi=[];function zr(_,y){let A=Ce.show(n,y);if(A instanceof HTMLElement)return Gn(A,vw),Gn(A,_.class),Ei(A,-10,-10,x,N),g.insertBefore(A,yn[y]),A}function ps(_,y){if(s==1||y>0){let A=s==1&&M[_.scale].time,P=_.value;_.value=A?sd(P)?ud(Z,hd(P,Y)):P||at:P||LT,_.label=_.label||(A?wT:ET)}if(gi||y>0){_.width=_.width==null?1:_.width,_.paths=_.paths||YT||Fw,_.fillTo=ce(_.fillTo||OT),_.pxAlign=+_e(_.pxAlign,v),_.pxRound=yd(_.pxAlign),_.stroke=ce(_.stroke||null),_.fill=ce(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let A=UT(An(1,_.width),1),P=_.points=je({},{size:A,width:An(1,A*.2),stroke:_.stroke,space:A*2,paths:qT,_stroke:null,_fill:null},_.points);P.show=ce(P.show),P.filter=ce(P.filter),P.fill=ce(P.fill),P.stroke=ce(P.stroke),P.paths=ce(P.paths),P.pxAlign=_.pxAlign}if(ee){let A=Ee(_,y);vt.splice(y,0,A[0]),Jt.splice(y,0,A[1]),yt.values.push(null)}if(Zt){_t.splice(y,0,null);let A=null;gi?y==0&&(A=zr(_,y)):y>0&&(A=zr(_,y)),yn.splice(y,0,A),Pi.splice(y,0,0),oi.splice(y,0,0)}cn("addSeries",y)}function Co(_,y){y=y??w.length,_=s==1?oh(_,y,dd,vd):oh(_,y,{},_d),w.splice(y,0,_),ps(w[y],y)}n.addSeries=Co;function Po(_){if(w.splice(_,1),ee){yt.values.splice(_,1),Jt.splice(_,1);let y=vt.splice(_,1)[0];Fe(null,y.firstChild),y.remove()}Zt&&(_t.splice(_,1),yn.splice(_,1)[0].remove(),Pi.splice(_,1),oi.splice(_,1)),cn("delSeries",_)}n.delSeries=Po;const Di=[!1,!1,!1,!1];function Za(_,y){if(_._show=_.show,_.show){let A=_.side%2,P=M[_.scale];P==null&&(_.scale=A?w[1].scale:D,P=M[_.scale]);let O=P.time;_.size=ce(_.size),_.space=ce(_.space),_.rotate=ce(_.rotate),as(_.incrs)&&_.incrs.forEach(it=>{!ds.has(it)&&ds.set(it,Yp(it))}),_.incrs=ce(_.incrs||(P.distr==2?sT:O?p==1?oT:cT:Rs)),_.splits=ce(_.splits||(O&&P.distr==1?J:P.distr==3?nh:P.distr==4?AT:bT)),_.stroke=ce(_.stroke),_.grid.stroke=ce(_.grid.stroke),_.ticks.stroke=ce(_.ticks.stroke),_.border.stroke=ce(_.border.stroke);let X=_.values;_.values=as(X)&&!as(X[0])?ce(X):O?as(X)?cd(Z,ld(X,Y)):sd(X)?fT(Z,X):X||ot:X||TT,_.filter=ce(_.filter||(P.distr>=3&&P.log==10?PT:P.distr==3&&P.log==2?DT:Wp)),_.font=wd(_.font),_.labelFont=wd(_.labelFont),_._size=_.size(n,null,y,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(Di[y]=!0,_._el=ti(pw,f))}}function ms(_,y,A,P){let[O,X,it,lt]=A,pt=y%2,Tt=0;return pt==0&&(lt||X)&&(Tt=y==0&&!O||y==2&&!it?Je(fd.size/3):0),pt==1&&(O||it)&&(Tt=y==1&&!X||y==3&&!lt?Je(md.size/2):0),Tt}const Do=n.padding=(i.padding||[ms,ms,ms,ms]).map(_=>ce(_e(_,ms))),_i=n._padding=Do.map((_,y)=>_(n,y,Di,0));let Ke,S=null,B=null;const K=s==1?w[0].idxs:null;let q=null,V=!1;function ft(_,y){if(t=_??[],n.data=n._data=t,s==2){Ke=0;for(let A=1;A<w.length;A++)Ke+=t[A][0].length}else{t.length==0&&(n.data=n._data=t=[[]]),q=t[0],Ke=q.length;let A=t;if(G==2){A=t.slice();let P=A[0]=Array(Ke);for(let O=0;O<Ke;O++)P[O]=O}n._data=t=A}if(Vs(!0),cn("setData"),G==2&&(Kt=!0),y!==!1){let A=C;A.auto(n,V)?Mt():Zi(D,A.min,A.max),F=F||gt.left>=0,dt=!0,Gs()}}n.setData=ft;function Mt(){V=!0;let _,y;s==1&&(Ke>0?(S=K[0]=0,B=K[1]=Ke-1,_=t[0][S],y=t[0][B],G==2?(_=S,y=B):_==y&&(G==3?[_,y]=Wa(_,_,C.log,!1):G==4?[_,y]=Ph(_,_,C.log,!1):C.time?y=_+Je(86400/p):[_,y]=Ua(_,y,Dh,!0))):(S=K[0]=_=null,B=K[1]=y=null)),Zi(D,_,y)}let Lt,wt,Yt,qt,zt,se,pe,Ue,we,ne;function Xt(_,y,A,P,O,X){_??=Hf,A??=Uh,P??="butt",O??=Hf,X??="round",_!=Lt&&(h.strokeStyle=Lt=_),O!=wt&&(h.fillStyle=wt=O),y!=Yt&&(h.lineWidth=Yt=y),X!=zt&&(h.lineJoin=zt=X),P!=se&&(h.lineCap=se=P),A!=qt&&h.setLineDash(qt=A)}function Ie(_,y,A,P){y!=wt&&(h.fillStyle=wt=y),_!=pe&&(h.font=pe=_),A!=Ue&&(h.textAlign=Ue=A),P!=we&&(h.textBaseline=we=P)}function le(_,y,A,P,O=0){if(P.length>0&&_.auto(n,V)&&(y==null||y.min==null)){let X=_e(S,0),it=_e(B,P.length-1),lt=A.min==null?Pw(P,X,it,O,_.distr==3):[A.min,A.max];_.min=mi(_.min,A.min=lt[0]),_.max=An(_.max,A.max=lt[1])}}const mn={min:null,max:null};function $i(){for(let P in M){let O=M[P];W[P]==null&&(O.min==null||W[D]!=null&&O.auto(n,V))&&(W[P]=mn)}for(let P in M){let O=M[P];W[P]==null&&O.from!=null&&W[O.from]!=null&&(W[P]=mn)}W[D]!=null&&Vs(!0);let _={};for(let P in W){let O=W[P];if(O!=null){let X=_[P]=Pr(M[P],Bw);if(O.min!=null)je(X,O);else if(P!=D||s==2)if(Ke==0&&X.from==null){let it=X.range(n,null,null,P);X.min=it[0],X.max=it[1]}else X.min=Pe,X.max=-Pe}}if(Ke>0){w.forEach((P,O)=>{if(s==1){let X=P.scale,it=W[X];if(it==null)return;let lt=_[X];if(O==0){let pt=lt.range(n,lt.min,lt.max,X);lt.min=pt[0],lt.max=pt[1],S=di(lt.min,t[0]),B=di(lt.max,t[0]),B-S>1&&(t[0][S]<lt.min&&S++,t[0][B]>lt.max&&B--),P.min=q[S],P.max=q[B]}else P.show&&P.auto&&le(lt,it,P,t[O],P.sorted);P.idxs[0]=S,P.idxs[1]=B}else if(O>0&&P.show&&P.auto){let[X,it]=P.facets,lt=X.scale,pt=it.scale,[Tt,At]=t[O],Ut=_[lt],te=_[pt];Ut!=null&&le(Ut,W[lt],X,Tt,X.sorted),te!=null&&le(te,W[pt],it,At,it.sorted),P.min=it.min,P.max=it.max}});for(let P in _){let O=_[P],X=W[P];if(O.from==null&&(X==null||X.min==null)){let it=O.range(n,O.min==Pe?null:O.min,O.max==-Pe?null:O.max,P);O.min=it[0],O.max=it[1]}}}for(let P in _){let O=_[P];if(O.from!=null){let X=_[O.from];if(X.min==null)O.min=O.max=null;else{let it=O.range(n,X.min,X.max,P);O.min=it[0],O.max=it[1]}}}let y={},A=!1;for(let P in _){let O=_[P],X=M[P];if(X.min!=O.min||X.max!=O.max){X.min=O.min,X.max=O.max;let it=X.distr;X._min=it==3?Wi(X.min):it==4?ec(X.min,X.asinh):it==100?X.fwd(X.min):X.min,X._max=it==3?Wi(X.max):it==4?ec(X.max,X.asinh):it==100?X.fwd(X.max):X.max,y[P]=A=!0}}if(A){w.forEach((P,O)=>{s==2?O>0&&y.y&&(P._paths=null):y[P.scale]&&(P._paths=null)});for(let P in y)Kt=!0,cn("setScale",P);Zt&&gt.left>=0&&(F=dt=!0)}for(let P in W)W[P]=null}function Mn(_){let y=eh(S-1,0,Ke-1),A=eh(B+1,0,Ke-1);for(;_[y]==null&&y>0;)y--;for(;_[A]==null&&A<Ke-1;)A++;return[y,A]}function gs(){if(Ke>0){let _=w.some(y=>y._focus)&&ne!=On.alpha;_&&(h.globalAlpha=ne=On.alpha),w.forEach((y,A)=>{if(A>0&&y.show&&(Ne(A,!1),Ne(A,!0),y._paths==null)){let P=ne;ne!=y.alpha&&(h.globalAlpha=ne=y.alpha);let O=s==2?[0,t[A][0].length-1]:Mn(t[A]);y._paths=y.paths(n,A,O[0],O[1]),ne!=P&&(h.globalAlpha=ne=P)}}),w.forEach((y,A)=>{if(A>0&&y.show){let P=ne;ne!=y.alpha&&(h.globalAlpha=ne=y.alpha),y._paths!=null&&Sn(A,!1);{let O=y._paths!=null?y._paths.gaps:null,X=y.points.show(n,A,S,B,O),it=y.points.filter(n,A,X,O);(X||it)&&(y.points._paths=y.points.paths(n,A,S,B,it),Sn(A,!0))}ne!=P&&(h.globalAlpha=ne=P),cn("drawSeries",A)}}),_&&(h.globalAlpha=ne=1)}}function Ne(_,y){let A=y?w[_].points:w[_];A._stroke=A.stroke(n,_),A._fill=A.fill(n,_)}function Sn(_,y){let A=y?w[_].points:w[_],{stroke:P,fill:O,clip:X,flags:it,_stroke:lt=A._stroke,_fill:pt=A._fill,_width:Tt=A.width}=A._paths;Tt=De(Tt*Me,3);let At=null,Ut=Tt%2/2;y&&pt==null&&(pt=Tt>0?"#fff":lt);let te=A.pxAlign==1&&Ut>0;if(te&&h.translate(Ut,Ut),!y){let ye=bt-Tt/2,me=rt-Tt/2,ae=mt+Tt,jt=kt+Tt;At=new Path2D,At.rect(ye,me,ae,jt)}y?on(lt,Tt,A.dash,A.cap,pt,P,O,it,X):Ln(_,lt,Tt,A.dash,A.cap,pt,P,O,it,At,X),te&&h.translate(-Ut,-Ut)}function Ln(_,y,A,P,O,X,it,lt,pt,Tt,At){let Ut=!1;pt!=0&&U.forEach((te,ye)=>{if(te.series[0]==_){let me=w[te.series[1]],ae=t[te.series[1]],jt=(me._paths||fo).band;as(jt)&&(jt=te.dir==1?jt[0]:jt[1]);let Ht,Be=null;me.show&&jt&&Lw(ae,S,B)?(Be=te.fill(n,ye)||X,Ht=me._paths.clip):jt=null,on(y,A,P,O,Be,it,lt,pt,Tt,At,Ht,jt),Ut=!0}}),Ut||on(y,A,P,O,X,it,lt,pt,Tt,At)}const rn=Dr|sh;function on(_,y,A,P,O,X,it,lt,pt,Tt,At,Ut){Xt(_,y,A,P,O),(pt||Tt||Ut)&&(h.save(),pt&&h.clip(pt),Tt&&h.clip(Tt)),Ut?(lt&rn)==rn?(h.clip(Ut),At&&h.clip(At),Kn(O,it),ji(_,X,y)):lt&sh?(Kn(O,it),h.clip(Ut),ji(_,X,y)):lt&Dr&&(h.save(),h.clip(Ut),At&&h.clip(At),Kn(O,it),h.restore(),ji(_,X,y)):(Kn(O,it),ji(_,X,y)),(pt||Tt||Ut)&&h.restore()}function ji(_,y,A){A>0&&(y instanceof Map?y.forEach((P,O)=>{h.strokeStyle=Lt=O,h.stroke(P)}):y!=null&&_&&h.stroke(y))}function Kn(_,y){y instanceof Map?y.forEach((A,P)=>{h.fillStyle=wt=P,h.fill(A)}):y!=null&&_&&h.fill(y)}function bm(_,y,A,P){let O=T[_],X;if(P<=0)X=[0,0];else{let it=O._space=O.space(n,_,y,A,P),lt=O._incrs=O.incrs(n,_,y,A,P,it);X=QT(y,A,lt,P,it)}return O._found=X}function Ja(_,y,A,P,O,X,it,lt,pt,Tt){let At=it%2/2;v==1&&h.translate(At,At),Xt(lt,it,pt,Tt,lt),h.beginPath();let Ut,te,ye,me,ae=O+(P==0||P==3?-X:X);A==0?(te=O,me=ae):(Ut=O,ye=ae);for(let jt=0;jt<_.length;jt++)y[jt]!=null&&(A==0?Ut=ye=_[jt]:te=me=_[jt],h.moveTo(Ut,te),h.lineTo(ye,me));h.stroke(),v==1&&h.translate(-At,-At)}function Am(_){let y=!0;return T.forEach((A,P)=>{if(!A.show)return;let O=M[A.scale];if(O.min==null){A._show&&(y=!1,A._show=!1,Vs(!1));return}else A._show||(y=!1,A._show=!0,Vs(!1));let X=A.side,it=X%2,{min:lt,max:pt}=O,[Tt,At]=bm(P,lt,pt,it==0?x:N);if(At==0)return;let Ut=O.distr==2,te=A._splits=A.splits(n,P,lt,pt,Tt,At,Ut),ye=O.distr==2?te.map(Ht=>q[Ht]):te,me=O.distr==2?q[te[1]]-q[te[0]]:Tt,ae=A._values=A.values(n,A.filter(n,ye,P,At,me),P,At,me);A._rotate=X==2?A.rotate(n,ae,P,At):0;let jt=A._size;A._size=ei(A.size(n,ae,P,_)),jt!=null&&A._size!=jt&&(y=!1)}),y}function Rm(_){let y=!0;return Do.forEach((A,P)=>{let O=A(n,P,Di,_);O!=_i[P]&&(y=!1),_i[P]=O}),y}function Cm(){for(let _=0;_<T.length;_++){let y=T[_];if(!y.show||!y._show)continue;let A=y.side,P=A%2,O,X,it=y.stroke(n,_),lt=A==0||A==3?-1:1,[pt,Tt]=y._found;if(y.label!=null){let wn=y.labelGap*lt,zn=Je((y._lpos+wn)*Me);Ie(y.labelFont[0],it,"center",A==2?to:zf),h.save(),P==1?(O=X=0,h.translate(zn,Je(rt+kt/2)),h.rotate((A==3?-Sa:Sa)/2)):(O=Je(bt+mt/2),X=zn);let xs=Vp(y.label)?y.label(n,_,pt,Tt):y.label;h.fillText(xs,O,X),h.restore()}if(Tt==0)continue;let At=M[y.scale],Ut=P==0?mt:kt,te=P==0?bt:rt,ye=y._splits,me=At.distr==2?ye.map(wn=>q[wn]):ye,ae=At.distr==2?q[ye[1]]-q[ye[0]]:pt,jt=y.ticks,Ht=y.border,Be=jt.show?jt.size:0,Ge=Je(Be*Me),hn=Je((y.alignTo==2?y._size-Be-y.gap:y.gap)*Me),be=y._rotate*-Sa/180,We=m(y._pos*Me),kn=(Ge+hn)*lt,En=We+kn;X=P==0?En:0,O=P==1?En:0;let Zn=y.font[0],ai=y.align==1?ur:y.align==2?Jl:be>0?ur:be<0?Jl:P==0?"center":A==3?Jl:ur,yi=be||P==1?"middle":A==2?to:zf;Ie(Zn,it,ai,yi);let Bn=y.font[1]*y.lineGap,Jn=ye.map(wn=>m(a(wn,At,Ut,te))),li=y._values;for(let wn=0;wn<li.length;wn++){let zn=li[wn];if(zn!=null){P==0?O=Jn[wn]:X=Jn[wn],zn=""+zn;let xs=zn.indexOf(`
`)==-1?[zn]:zn.split(/\n/gm);for(let Tn=0;Tn<xs.length;Tn++){let ru=xs[Tn];be?(h.save(),h.translate(O,X+Tn*Bn),h.rotate(be),h.fillText(ru,0,0),h.restore()):h.fillText(ru,O,X+Tn*Bn)}}}jt.show&&Ja(Jn,jt.filter(n,me,_,Tt,ae),P,A,We,Ge,De(jt.width*Me,3),jt.stroke(n,_),jt.dash,jt.cap);let Mi=y.grid;Mi.show&&Ja(Jn,Mi.filter(n,me,_,Tt,ae),P,P==0?2:1,P==0?rt:bt,P==0?kt:mt,De(Mi.width*Me,3),Mi.stroke(n,_),Mi.dash,Mi.cap),Ht.show&&Ja([We],[1],P==0?1:0,P==0?1:2,P==1?rt:bt,P==1?kt:mt,De(Ht.width*Me,3),Ht.stroke(n,_),Ht.dash,Ht.cap)}cn("drawAxes")}function Vs(_){w.forEach((y,A)=>{A>0&&(y._paths=null,_&&(s==1?(y.min=null,y.max=null):y.facets.forEach(P=>{P.min=null,P.max=null})))})}let Lo=!1,Qa=!1,Hr=[];function Pm(){Qa=!1;for(let _=0;_<Hr.length;_++)cn(...Hr[_]);Hr.length=0}function Gs(){Lo||(Yw(Hh),Lo=!0)}function Dm(_,y=!1){Lo=!0,Qa=y,_(n),Hh(),y&&Hr.length>0&&queueMicrotask(Pm)}n.batch=Dm;function Hh(){if(Ot&&($i(),Ot=!1),Kt&&(Ft(),Kt=!1),xt){if(ze(d,ur,j),ze(d,to,nt),ze(d,ro,x),ze(d,oo,N),ze(g,ur,j),ze(g,to,nt),ze(g,ro,x),ze(g,oo,N),ze(f,ro,xe),ze(f,oo,R),u.width=Je(xe*Me),u.height=Je(R*Me),T.forEach(({_el:_,_show:y,_size:A,_pos:P,side:O})=>{if(_!=null)if(y){let X=O===3||O===0?A:0,it=O%2==1;ze(_,it?"left":"top",P-X),ze(_,it?"width":"height",A),ze(_,it?"top":"left",it?nt:j),ze(_,it?"height":"width",it?N:x),Qc(_,Ds)}else Gn(_,Ds)}),Lt=wt=Yt=zt=se=pe=Ue=we=qt=null,ne=1,Wr(!0),j!=tt||nt!=Nt||x!=ht||N!=Dt){Vs(!1);let _=x/ht,y=N/Dt;if(Zt&&!F&&gt.left>=0){gt.left*=_,gt.top*=y,Ws&&Ei(Ws,Je(gt.left),0,x,N),Xs&&Ei(Xs,0,Je(gt.top),x,N);for(let A=0;A<yn.length;A++){let P=yn[A];P!=null&&(Pi[A]*=_,oi[A]*=y,Ei(P,ei(Pi[A]),ei(oi[A]),x,N))}}if(ke.show&&!ut&&ke.left>=0&&ke.width>0){ke.left*=_,ke.width*=_,ke.top*=y,ke.height*=y;for(let A in rl)ze($s,A,ke[A])}tt=j,Nt=nt,ht=x,Dt=N}cn("setSize"),xt=!1}xe>0&&R>0&&(h.clearRect(0,0,u.width,u.height),cn("drawClear"),k.forEach(_=>_()),cn("draw")),ke.show&&ut&&(Uo(ke),ut=!1),Zt&&F&&(vs(null,!0,!1),F=!1),yt.show&&yt.live&&dt&&(il(),dt=!1),l||(l=!0,n.status=1,cn("ready")),V=!1,Lo=!1}n.redraw=(_,y)=>{Kt=y||!1,_!==!1?Zi(D,C.min,C.max):Gs()};function tl(_,y){let A=M[_];if(A.from==null){if(Ke==0){let P=A.range(n,y.min,y.max,_);y.min=P[0],y.max=P[1]}if(y.min>y.max){let P=y.min;y.min=y.max,y.max=P}if(Ke>1&&y.min!=null&&y.max!=null&&y.max-y.min<1e-16)return;_==D&&A.distr==2&&Ke>0&&(y.min=di(y.min,t[0]),y.max=di(y.max,t[0]),y.min==y.max&&y.max++),W[_]=y,Ot=!0,Gs()}}n.setScale=tl;let el,nl,Ws,Xs,Vh,Gh,Ys,qs,Wh,Xh,Oe,He,Ki=!1;const dn=gt.drag;let an=dn.x,ln=dn.y;Zt&&(gt.x&&(el=ti(gw,g)),gt.y&&(nl=ti(_w,g)),C.ori==0?(Ws=el,Xs=nl):(Ws=nl,Xs=el),Oe=gt.left,He=gt.top);const ke=n.select=je({show:!0,over:!0,left:0,width:0,top:0,height:0},i.select),$s=ke.show?ti(mw,ke.over?g:d):null;function Uo(_,y){if(ke.show){for(let A in _)ke[A]=_[A],A in rl&&ze($s,A,_[A]);y!==!1&&cn("setSelect")}}n.setSelect=Uo;function Lm(_){if(w[_].show)ee&&Qc(vt[_],Ds);else if(ee&&Gn(vt[_],Ds),Zt){let A=gi?yn[0]:yn[_];A!=null&&Ei(A,-10,-10,x,N)}}function Zi(_,y,A){tl(_,{min:y,max:A})}function vi(_,y,A,P){y.focus!=null&&Om(_),y.show!=null&&w.forEach((O,X)=>{X>0&&(_==X||_==null)&&(O.show=y.show,Lm(X),s==2?(Zi(O.facets[0].scale,null,null),Zi(O.facets[1].scale,null,null)):Zi(O.scale,null,null),Gs())}),A!==!1&&cn("setSeries",_,y),P&&Xr("setSeries",n,_,y)}n.setSeries=vi;function Um(_,y){je(U[_],y)}function Im(_,y){_.fill=ce(_.fill||null),_.dir=_e(_.dir,-1),y=y??U.length,U.splice(y,0,_)}function Nm(_){_==null?U.length=0:U.splice(_,1)}n.addBand=Im,n.setBand=Um,n.delBand=Nm;function Fm(_,y){w[_].alpha=y,Zt&&yn[_]!=null&&(yn[_].style.opacity=y),ee&&vt[_]&&(vt[_].style.opacity=y)}let Li,Ji,_s;const js={focus:!0};function Om(_){if(_!=_s){let y=_==null,A=On.alpha!=1;w.forEach((P,O)=>{if(s==1||O>0){let X=y||O==0||O==_;P._focus=y?null:X,A&&Fm(O,X?1:On.alpha)}}),_s=_,A&&Gs()}}ee&&Dn&&Vt(Wf,et,_=>{gt._lock||(fn(_),_s!=null&&vi(null,js,!0,qe.setSeries))});function xi(_,y,A){let P=M[y];A&&(_=_/Me-(P.ori==1?nt:j));let O=x;P.ori==1&&(O=N,_=O-_),P.dir==-1&&(_=O-_);let X=P._min,it=P._max,lt=_/O,pt=X+(it-X)*lt,Tt=P.distr;return Tt==3?Rr(10,pt):Tt==4?Iw(pt,P.asinh):Tt==100?P.bwd(pt):pt}function km(_,y){let A=xi(_,D,y);return di(A,t[0],S,B)}n.valToIdx=_=>di(_,t[0]),n.posToIdx=km,n.posToVal=xi,n.valToPos=(_,y,A)=>M[y].ori==0?r(_,M[y],A?mt:x,A?bt:0):o(_,M[y],A?kt:N,A?rt:0),n.setCursor=(_,y,A)=>{Oe=_.left,He=_.top,vs(null,y,A)};function Yh(_,y){ze($s,ur,ke.left=_),ze($s,ro,ke.width=y)}function qh(_,y){ze($s,to,ke.top=_),ze($s,oo,ke.height=y)}let Vr=C.ori==0?Yh:qh,Gr=C.ori==1?Yh:qh;function Bm(){if(ee&&yt.live)for(let _=s==2?1:0;_<w.length;_++){if(_==0&&L)continue;let y=yt.values[_],A=0;for(let P in y)Jt[_][A++].firstChild.nodeValue=y[P]}}function il(_,y){if(_!=null&&(_.idxs?_.idxs.forEach((A,P)=>{_t[P]=A}):kw(_.idx)||_t.fill(_.idx),yt.idx=_t[0]),ee&&yt.live){for(let A=0;A<w.length;A++)(A>0||s==1&&!L)&&zm(A,_t[A]);Bm()}dt=!1,y!==!1&&cn("setLegend")}n.setLegend=il;function zm(_,y){let A=w[_],P=_==0&&G==2?q:t[_],O;L?O=A.values(n,_,y)??fe:(O=A.value(n,y==null?null:P[y],_,y),O=O==null?fe:{_:O}),yt.values[_]=O}function vs(_,y,A){Wh=Oe,Xh=He,[Oe,He]=gt.move(n,Oe,He),gt.left=Oe,gt.top=He,Zt&&(Ws&&Ei(Ws,Je(Oe),0,x,N),Xs&&Ei(Xs,0,Je(He),x,N));let P,O=S>B;Li=Pe,Ji=null;let X=C.ori==0?x:N,it=C.ori==1?x:N;if(Oe<0||Ke==0||O){P=gt.idx=null;for(let lt=0;lt<w.length;lt++){let pt=yn[lt];pt!=null&&Ei(pt,-10,-10,x,N)}Dn&&vi(null,js,!0,_==null&&qe.setSeries),yt.live&&(_t.fill(P),dt=!0)}else{let lt,pt,Tt;s==1&&(lt=C.ori==0?Oe:He,pt=xi(lt,D),P=gt.idx=di(pt,t[0],S,B),Tt=H(t[0][P],C,X,0));let At=-10,Ut=-10,te=0,ye=0,me=!0,ae="",jt="";for(let Ht=s==2?1:0;Ht<w.length;Ht++){let Be=w[Ht],Ge=_t[Ht],hn=Ge==null?null:s==1?t[Ht][Ge]:t[Ht][1][Ge],be=gt.dataIdx(n,Ht,P,pt),We=be==null?null:s==1?t[Ht][be]:t[Ht][1][be];if(dt=dt||We!=hn||be!=Ge,_t[Ht]=be,Ht>0&&Be.show){let kn=be==null?-10:be==P?Tt:H(s==1?t[0][be]:t[Ht][0][be],C,X,0),En=We==null?-10:$(We,s==1?M[Be.scale]:M[Be.facets[1].scale],it,0);if(Dn&&We!=null){let Zn=C.ori==1?Oe:He,ai=Qe(On.dist(n,Ht,be,En,Zn));if(ai<Li){let yi=On.bias;if(yi!=0){let Bn=xi(Zn,Be.scale),Jn=We>=0?1:-1,li=Bn>=0?1:-1;li==Jn&&(li==1?yi==1?We>=Bn:We<=Bn:yi==1?We<=Bn:We>=Bn)&&(Li=ai,Ji=Ht)}else Li=ai,Ji=Ht}}if(dt||gi){let Zn,ai;C.ori==0?(Zn=kn,ai=En):(Zn=En,ai=kn);let yi,Bn,Jn,li,Mi,wn,zn=!0,xs=Ce.bbox;if(xs!=null){zn=!1;let Tn=xs(n,Ht);Jn=Tn.left,li=Tn.top,yi=Tn.width,Bn=Tn.height}else Jn=Zn,li=ai,yi=Bn=Ce.size(n,Ht);if(wn=Ce.fill(n,Ht),Mi=Ce.stroke(n,Ht),gi)Ht==Ji&&Li<=On.prox&&(At=Jn,Ut=li,te=yi,ye=Bn,me=zn,ae=wn,jt=Mi);else{let Tn=yn[Ht];Tn!=null&&(Pi[Ht]=Jn,oi[Ht]=li,Zf(Tn,yi,Bn,zn),jf(Tn,wn,Mi),Ei(Tn,ei(Jn),ei(li),x,N))}}}}if(gi){let Ht=On.prox,Be=_s==null?Li<=Ht:Li>Ht||Ji!=_s;if(dt||Be){let Ge=yn[0];Ge!=null&&(Pi[0]=At,oi[0]=Ut,Zf(Ge,te,ye,me),jf(Ge,ae,jt),Ei(Ge,ei(At),ei(Ut),x,N))}}}if(ke.show&&Ki)if(_!=null){let[lt,pt]=qe.scales,[Tt,At]=qe.match,[Ut,te]=_.cursor.sync.scales,ye=_.cursor.drag;if(an=ye._x,ln=ye._y,an||ln){let{left:me,top:ae,width:jt,height:Ht}=_.select,Be=_.scales[Ut].ori,Ge=_.posToVal,hn,be,We,kn,En,Zn=lt!=null&&Tt(lt,Ut),ai=pt!=null&&At(pt,te);Zn&&an?(Be==0?(hn=me,be=jt):(hn=ae,be=Ht),We=M[lt],kn=H(Ge(hn,Ut),We,X,0),En=H(Ge(hn+be,Ut),We,X,0),Vr(mi(kn,En),Qe(En-kn))):Vr(0,X),ai&&ln?(Be==1?(hn=me,be=jt):(hn=ae,be=Ht),We=M[pt],kn=$(Ge(hn,te),We,it,0),En=$(Ge(hn+be,te),We,it,0),Gr(mi(kn,En),Qe(En-kn))):Gr(0,it)}else ol()}else{let lt=Qe(Wh-Vh),pt=Qe(Xh-Gh);if(C.ori==1){let te=lt;lt=pt,pt=te}an=dn.x&&lt>=dn.dist,ln=dn.y&&pt>=dn.dist;let Tt=dn.uni;Tt!=null?an&&ln&&(an=lt>=Tt,ln=pt>=Tt,!an&&!ln&&(pt>lt?ln=!0:an=!0)):dn.x&&dn.y&&(an||ln)&&(an=ln=!0);let At,Ut;an&&(C.ori==0?(At=Ys,Ut=Oe):(At=qs,Ut=He),Vr(mi(At,Ut),Qe(Ut-At)),ln||Gr(0,it)),ln&&(C.ori==1?(At=Ys,Ut=Oe):(At=qs,Ut=He),Gr(mi(At,Ut),Qe(Ut-At)),an||Vr(0,X)),!an&&!ln&&(Vr(0,0),Gr(0,0))}if(dn._x=an,dn._y=ln,_==null){if(A){if(su!=null){let[lt,pt]=qe.scales;qe.values[0]=lt!=null?xi(C.ori==0?Oe:He,lt):null,qe.values[1]=pt!=null?xi(C.ori==1?Oe:He,pt):null}Xr(Ql,n,Oe,He,x,N,P)}if(Dn){let lt=A&&qe.setSeries,pt=On.prox;_s==null?Li<=pt&&vi(Ji,js,!0,lt):Li>pt?vi(null,js,!0,lt):Ji!=_s&&vi(Ji,js,!0,lt)}}dt&&(yt.idx=P,il()),y!==!1&&cn("setCursor")}let Qi=null;Object.defineProperty(n,"rect",{get(){return Qi==null&&Wr(!1),Qi}});function Wr(_=!1){_?Qi=null:(Qi=g.getBoundingClientRect(),cn("syncRect",Qi))}function $h(_,y,A,P,O,X,it){gt._lock||Ki&&_!=null&&_.movementX==0&&_.movementY==0||(sl(_,y,A,P,O,X,it,!1,_!=null),_!=null?vs(null,!0,!0):vs(y,!0,!1))}function sl(_,y,A,P,O,X,it,lt,pt){if(Qi==null&&Wr(!1),fn(_),_!=null)A=_.clientX-Qi.left,P=_.clientY-Qi.top;else{if(A<0||P<0){Oe=-10,He=-10;return}let[Tt,At]=qe.scales,Ut=y.cursor.sync,[te,ye]=Ut.values,[me,ae]=Ut.scales,[jt,Ht]=qe.match,Be=y.axes[0].side%2==1,Ge=C.ori==0?x:N,hn=C.ori==1?x:N,be=Be?X:O,We=Be?O:X,kn=Be?P:A,En=Be?A:P;if(me!=null?A=jt(Tt,me)?a(te,M[Tt],Ge,0):-10:A=Ge*(kn/be),ae!=null?P=Ht(At,ae)?a(ye,M[At],hn,0):-10:P=hn*(En/We),C.ori==1){let Zn=A;A=P,P=Zn}}pt&&(y==null||y.cursor.event.type==Ql)&&((A<=1||A>=x-1)&&(A=As(A,x)),(P<=1||P>=N-1)&&(P=As(P,N))),lt?(Vh=A,Gh=P,[Ys,qs]=gt.move(n,A,P)):(Oe=A,He=P)}const rl={width:0,height:0,left:0,top:0};function ol(){Uo(rl,!1)}let jh,Kh,Zh,Jh;function Qh(_,y,A,P,O,X,it){Ki=!0,an=ln=dn._x=dn._y=!1,sl(_,y,A,P,O,X,it,!0,!1),_!=null&&(Vt(tc,Zc,tu,!1),Xr(Vf,n,Ys,qs,x,N,null));let{left:lt,top:pt,width:Tt,height:At}=ke;jh=lt,Kh=pt,Zh=Tt,Jh=At}function tu(_,y,A,P,O,X,it){Ki=dn._x=dn._y=!1,sl(_,y,A,P,O,X,it,!1,!0);let{left:lt,top:pt,width:Tt,height:At}=ke,Ut=Tt>0||At>0,te=jh!=lt||Kh!=pt||Zh!=Tt||Jh!=At;if(Ut&&te&&Uo(ke),dn.setScale&&Ut&&te){let ye=lt,me=Tt,ae=pt,jt=At;if(C.ori==1&&(ye=pt,me=At,ae=lt,jt=Tt),an&&Zi(D,xi(ye,D),xi(ye+me,D)),ln)for(let Ht in M){let Be=M[Ht];Ht!=D&&Be.from==null&&Be.min!=Pe&&Zi(Ht,xi(ae+jt,Ht),xi(ae,Ht))}ol()}else gt.lock&&(gt._lock=!gt._lock,vs(y,!0,_!=null));_!=null&&(Fe(tc,Zc),Xr(tc,n,Oe,He,x,N,null))}function Hm(_,y,A,P,O,X,it){if(gt._lock)return;fn(_);let lt=Ki;if(Ki){let pt=!0,Tt=!0,At=10,Ut,te;C.ori==0?(Ut=an,te=ln):(Ut=ln,te=an),Ut&&te&&(pt=Oe<=At||Oe>=x-At,Tt=He<=At||He>=N-At),Ut&&pt&&(Oe=Oe<Ys?0:x),te&&Tt&&(He=He<qs?0:N),vs(null,!0,!0),Ki=!1}Oe=-10,He=-10,_t.fill(null),vs(null,!0,!0),lt&&(Ki=lt)}function eu(_,y,A,P,O,X,it){gt._lock||(fn(_),Mt(),ol(),_!=null&&Xr(Xf,n,Oe,He,x,N,null))}function nu(){T.forEach(tb),Pt(n.width,n.height,!0)}Is(La,xr,nu);const Ks={};Ks.mousedown=Qh,Ks.mousemove=$h,Ks.mouseup=tu,Ks.dblclick=eu,Ks.setSeries=(_,y,A,P)=>{let O=qe.match[2];A=O(n,y,A),A!=-1&&vi(A,P,!0,!1)},Zt&&(Vt(Vf,g,Qh),Vt(Ql,g,$h),Vt(Gf,g,_=>{fn(_),Wr(!1)}),Vt(Wf,g,Hm),Vt(Xf,g,eu),rh.add(n),n.syncRect=Wr);const Io=n.hooks=i.hooks||{};function cn(_,y,A){Qa?Hr.push([_,y,A]):_ in Io&&Io[_].forEach(P=>{P.call(null,n,y,A)})}(i.plugins||[]).forEach(_=>{for(let y in _.hooks)Io[y]=(Io[y]||[]).concat(_.hooks[y])});const iu=(_,y,A)=>A,qe=je({key:null,setSeries:!1,filters:{pub:nd,sub:nd},scales:[D,w[1]?w[1].scale:null],match:[id,id,iu],values:[null,null]},gt.sync);qe.match.length==2&&qe.match.push(iu),gt.sync=qe;const su=qe.key,al=fm(su);function Xr(_,y,A,P,O,X,it){qe.filters.pub(_,y,A,P,O,X,it)&&al.pub(_,y,A,P,O,X,it)}al.sub(n);function Vm(_,y,A,P,O,X,it){qe.filters.sub(_,y,A,P,O,X,it)&&Ks[_](null,y,A,P,O,X,it)}n.pub=Vm;function Gm(){al.unsub(n),rh.delete(n),Ct.clear(),th(La,xr,nu),c.remove(),et?.remove(),cn("destroy")}n.destroy=Gm;function ll(){cn("init",i,t),ft(t||i.data,!1),W[D]?tl(D,W[D]):Mt(),ut=ke.show&&(ke.width>0||ke.height>0),F=dt=!0,Pt(i.width,i.height)}return w.forEach(ps),T.forEach(Za),e?e instanceof HTMLElement?(e.appendChild(c),ll()):e(n,ll):ll(),n}pn.assign=je;pn.fmtNum=Lh;pn.rangeNum=Ua;pn.rangeLog=Wa;pn.rangeAsinh=Ph;pn.orient=Hs;pn.pxRatio=Me;pn.join=Xw;pn.fmtDate=Ih,pn.tzDate=nT;pn.sync=fm;{pn.addGap=kT,pn.clipGaps=qa;let i=pn.paths={points:vm};i.linear=ym,i.stepped=HT,i.bars=VT,i.spline=WT}const Td="10.5px system-ui, sans-serif";function Na(i,t,e){return{label:i,labelSize:15,labelGap:0,labelFont:Td,font:Td,size:t,gap:3,stroke:()=>e().soft,grid:{stroke:()=>e().line,width:1},ticks:{stroke:()=>e().line,width:1,size:4}}}function wm(i){i.ctx.canvas.setAttribute("aria-hidden","true")}class eb{constructor(t){this.plot=t,this.line=ue("div",{class:"now"}),wm(t),t.over.append(this.line)}at(t){const e=this.plot.valToPos(t,"x"),n=Number.isFinite(e)&&e>=0&&e<=this.plot.over.clientWidth;this.line.hidden=!n,n&&(this.line.style.transform=`translateX(${e.toFixed(1)}px)`)}}function Tm(i,t){const[e,n]=[t.clientWidth,t.clientHeight];return e===0||n===0||i.width===e&&i.height===n?!1:(i.setSize({width:e,height:n}),!0)}function nb(i,t){i.over.addEventListener("click",e=>{t(i.posToVal(e.clientX-i.over.getBoundingClientRect().left,"x"))})}const ib=6e3,sb=$n["place.recognition"];class rb{constructor(t,e){this.painted=t,this.root=Gt("templates"),this.pace=new Ro(200),this.rows=null,this.drawn=-1;const n=o=>()=>this.painted[o],s=(o,a)=>({label:o,stroke:n(a),paths:()=>null,points:{show:!0,size:3.5,width:0,fill:n(a),stroke:n(a)}}),r=()=>this.painted;this.plot=new pn({width:300,height:150,legend:{show:!1},cursor:{drag:{x:!1,y:!1},points:{show:!1},y:!1},scales:{x:{time:!1,range:(o,a,l)=>[a,Math.max(l,a+1)]},y:{range:(o,a,l)=>[0,Math.max(4,(l??0)*1.04,a)]}},axes:[Na("data time, s",22,r),{...Na("template",38,r),incrs:[1,2,5,10,20,50,100,200,500,1e3,2e3,5e3,1e4]}],series:[{},s("familiar","vermilion"),s("novel","blue")]},[[],[],[]],this.root),this.now=new eb(this.plot),nb(this.plot,e)}update(t,e){const n=t.colours!==this.painted;this.painted=t.colours;const s=Tm(this.plot,this.root);n&&!s&&this.plot.redraw(!1);const{rows:r}=t;let o=!1;return(r!==this.rows||r.count!==this.drawn)&&(o=!this.pace.due(e),o||this.setData(r)),this.now.at(r.value(t.row,"frame.time")),o}setData(t){this.rows=t,this.drawn=t.count;const e=t.column("frame.time"),n=t.column("place.recognition"),s=t.column("place.template_id"),r=wg(t.count,ib),o=a=>r.map(l=>n[l]===sb.indexOf(a)?s[l]:null);this.plot.setData([r.map(a=>e[a]),o("familiar"),o("novel")])}}const ma=Ea.filter(i=>i.startsWith("duration.")),ob=300,rc=.001,bd={source:"grey",odometry:"orange",place:"purple",cells:"green",map:"blue"};class ab{constructor(){this.root=Gt("timing"),this.table=Gt("stages"),this.pace=new Ro(150),this.colours=null,this.plot=null,this.key="",this.rows=ma.map(t=>this.makeRow(Ad(t)))}update(t,e){const n=t.colours!==this.colours;this.colours=t.colours;const s=this.plot??=this.makePlot(),r=Tm(s,this.root);n&&!r&&s.redraw(!1);const o=`${t.row} ${t.rows.count}`;return o===this.key?!1:this.pace.due(e)?(this.key=o,this.show(t,s),!1):!0}show({rows:t,row:e},n){const s=Math.max(0,e+1-ob),r=ma.map(l=>t.column(l)),o=Array.from(t.column("frame.frame").subarray(s,e+1)),a=r.map(l=>Array.from(l.subarray(s,e+1),c=>c>=0?Math.max(c,rc):null));n.setData([o,...a]),r.forEach((l,c)=>{const u=this.rows[c];he(u.now,ri(l[e]??NaN)),he(u.median,ri(Tg(l,s,e+1)))})}makePlot(){const t=()=>this.colours,e=(s,r,o)=>[10**Math.floor(Math.log10(Math.max(r??1,rc))),10**Math.ceil(Math.log10(Math.max(o??1,10*rc)))],n=new pn({width:200,height:150,legend:{show:!1},cursor:{show:!1},scales:{x:{time:!1},y:{distr:3,log:10,range:e}},axes:[{...Na("frame",22,t),space:44},{...Na("ms",34,t),values:(s,r)=>r.map(o=>lb(o)?String(+o.toPrecision(3)):"")}],series:[{},...ma.map(s=>this.series(Ad(s)))]},[[],...ma.map(()=>[])],this.root);return wm(n),n}series(t){return{label:t,stroke:()=>this.colours?.[bd[t]??"sky"]??"#888",width:1.3,points:{show:!1}}}makeRow(t){const e=ue("tr"),n=ue("th",{scope:"row"}),s=`--swatch: var(--${bd[t]??"sky"})`;n.append(ue("i",{class:"swatch",style:s}),t);const r=ue("td",{"data-testid":`${t}-now`}),o=ue("td",{"data-testid":`${t}-median`});return e.append(n,r,o),this.table.append(e),{now:r,median:o}}}function Ad(i){return i.slice(9)}function lb(i){const t=Math.log10(i);return Math.abs(t-Math.round(t))<1e-9}const cb="M6 4.5h3v11H6zM11 4.5h3v11h-3z",hb="M6.5 4.2v11.6L16 10z",ub=$n["place.recognition"].indexOf("familiar"),fb=$n["decision.action"].indexOf("close_loop"),db=$n["motion.state"].indexOf("lost");class pb{constructor(t,e){this.scrub=Gt("scrub"),this.play=Gt("play"),this.live=Gt("live"),this.speed=Gt("speed"),this.surface=new Fa(Gt("strip")),this.texts={shape:Gt("play-shape"),frame:Gt("shown-frame"),of:Gt("of-frames"),time:Gt("shown-time")},this.pace=new Ro(300),this.key="",this.scrub.oninput=()=>t.seek(Number(this.scrub.value)),this.play.onclick=()=>t.toggle(),this.live.onclick=()=>t.follow(),this.speed.onclick=()=>{t.player.cycleSpeed(),e()}}update(t,e){const{rows:n,row:s,mode:r}=t;tn(this.scrub,"max",String(Math.max(0,n.count-1))),this.scrub.value!==String(Math.max(0,s))&&(this.scrub.value=String(Math.max(0,s))),tn(this.scrub,"aria-valuetext",`frame ${ni(t.frame)}`);const o=r==="paused"||r==="live"&&!t.live;tn(this.texts.shape,"d",o?hb:cb),tn(this.play,"aria-label",o?"Play (space)":"Pause (space)"),he(this.live,t.live?"Live":"Newest"),tn(this.live,"aria-pressed",String(r==="live")),he(this.speed,`${t.speed}×`),he(this.texts.frame,ni(t.frame));const a=t.live&&t.info&&t.info.source.frames>0?t.info.source.frames-1:n.frame(n.count-1);return he(this.texts.of,` / ${ni(a)}`),he(this.texts.time,Eg(n.value(s,"frame.time")-n.value(0,"frame.time"))),this.updateStrip(t,e)}updateStrip(t,e){const n=`${t.rows.count} ${t.info?.name} ${Object.values(t.colours).join()}`,s=this.surface.fit();return n===this.key&&!s?!1:!s&&!this.pace.due(e)?!0:(this.key=n,this.drawStrip(t),!1)}drawStrip({rows:t,colours:e}){const n=this.surface.clear(),{width:s,height:r}=this.surface,o=t.count;if(o<2)return;const a=t.column("motion.v"),l=t.column("place.recognition"),c=t.column("decision.action"),u=t.column("motion.state");let h=1e-6;for(let d=0;d<o;++d)h=Math.max(h,Math.abs(a[d])||0);const f=Math.max(1,Math.floor(s));for(let d=0;d<f;++d){const g=Math.floor(d*o/f),v=Math.max(g+1,Math.floor((d+1)*o/f));let[m,p,w,T]=[0,!1,!1,!1];for(let U=g;U<v;++U)m=Math.max(m,Math.abs(a[U])||0),p||=l[U]===ub,w||=c[U]===fb,T||=u[U]===db;const M=.55*r*m/h;n.fillStyle=T?e.purple:e.line,n.fillRect(d,r-5-M,1,M),n.fillStyle=p?e.faint:"transparent",n.fillRect(d,r-4,1,3),w&&(n.fillStyle=e.vermilion,n.fillRect(d,3,1.4,9))}}}const mb=100;class gb{constructor(){this.theme=new jm(()=>this.invalidate()),this.model=new Mg(`${location.protocol==="https:"?"wss":"ws"}://${location.host}/live`,()=>this.invalidate()),this.map=new tw(()=>this.invalidate()),this.cells=new KS(()=>this.invalidate()),this.drawn=new Cd(1),this.draws=0,this.waiting=!1,this.later=0,this.last=performance.now();const t=s=>this.model.seekFrame(s),e=new sw,n=s=>t(e.candidateAt=s);this.panels=[new rw(this.model),new sE,new Ag,e,this.map,this.cells,new rb(this.theme.colours,s=>this.seekTime(s)),new ab,new oE(t),new gE(n),new pb(this.model,()=>this.invalidate())],this.bindKeys(),Gt("theme").onclick=()=>this.theme.toggle(),Gt("help-open").onclick=()=>this.openHelp(),new ResizeObserver(()=>this.invalidate()).observe(document.documentElement),Wm(()=>this.model.state(this.theme.colours),this.map,()=>this.drawn.rate(performance.now()/1e3)),this.model.open()}invalidate(){this.waiting||(this.waiting=!0,requestAnimationFrame(t=>this.draw(t)))}draw(t){this.waiting=!1,this.model.tick((t-this.last)/1e3),this.last=t;const e=this.model.state(this.theme.colours);let n=!1;for(const s of this.panels)n=s.update(e,t)||n;this.drawn.note(++this.draws,t/1e3),e.mode==="playing"&&this.invalidate(),this.scheduleLater(n?mb:e.live?1e3:0)}scheduleLater(t){window.clearTimeout(this.later),t>0&&(this.later=window.setTimeout(()=>this.invalidate(),t))}seekTime(t){const{rows:e}=this.model.state(this.theme.colours);let s=e.column("frame.time").subarray(0,e.count).findIndex(r=>r>=t);s<0&&(s=e.count-1),this.model.seek(s)}step(t,e){this.model.seek(this.model.player.row+e*(t.shiftKey?10:1))}openHelp(){Gt("help").showModal()}bindKeys(){const{model:t,map:e}=this;Xm([{keys:[" "],shown:"space",meaning:"pause, or play what is recorded",act:()=>t.toggle()},{keys:["ArrowLeft"],shown:"←",meaning:"a frame back (with shift: ten)",act:n=>this.step(n,-1)},{keys:["ArrowRight"],shown:"→",meaning:"a frame on (with shift: ten)",act:n=>this.step(n,1)},{keys:["PageUp"],shown:"PgUp",meaning:"a hundred frames back",act:()=>t.seek(t.player.row-100)},{keys:["PageDown"],shown:"PgDn",meaning:"a hundred frames on",act:()=>t.seek(t.player.row+100)},{keys:["Home"],shown:"home",meaning:"first frame",act:()=>t.seek(0)},{keys:["End","l"],shown:"end l",meaning:"newest frame, and follow the run",act:()=>t.follow()},{keys:["s"],shown:"s",meaning:"speed of playing",act:()=>Gt("speed").click()},{keys:["+","="],shown:"+",meaning:"map nearer",act:()=>e.zoomBy(1.25)},{keys:["-"],shown:"-",meaning:"map farther",act:()=>e.zoomBy(.8)},{keys:["f"],shown:"f",meaning:"fit the whole map",act:()=>e.fit()},{keys:["c"],shown:"c",meaning:"keep the robot in the middle",act:()=>e.toggleCentre()},{keys:["2"],shown:"2",meaning:"map from above",act:()=>e.choose("2d")},{keys:["3"],shown:"3",meaning:"map in space",act:()=>e.choose("3d")},{keys:["g"],shown:"g",meaning:"grid cells as sheet or torus",act:()=>this.cells.toggleTorus()},{keys:["t"],shown:"t",meaning:"light or dark",act:()=>this.theme.toggle()},{keys:["?"],shown:"?",meaning:"this help",act:()=>this.openHelp()}])}}new gb;
