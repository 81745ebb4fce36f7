<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Thicken</name>
    <message>
        <source>Check Surface</source>
        <extracomment>None until they are known</extracomment>
        <translation>检查曲面</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>正在检查…</translation>
    </message>
    <message>
        <source>“{label}” can be thickened: it has no defect.</source>
        <translation>“{label}”可以加厚：没有缺陷。</translation>
    </message>
    <message>
        <source>“{label}” has {count} defects. Click one to go there.</source>
        <translation>“{label}”有 {count} 处缺陷。单击其中一处即可转到该处。</translation>
    </message>
    <message>
        <source>Edge</source>
        <extracomment>n × 3, what to look at</extracomment>
        <translation>边</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角形</translation>
    </message>
    <message>
        <source>The direction in which the part grows while it is printed</source>
        <translation>打印时零件生长的方向</translation>
    </message>
    <message>
        <source>Drain holes</source>
        <extracomment>the holes of the inputs that are shown; None while they are computed</extracomment>
        <translation>排液孔</translation>
    </message>
    <message>
        <source>Drain Holes</source>
        <translation>排液孔</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>直径</translation>
    </message>
    <message>
        <source>Printed towards</source>
        <translation>打印方向</translation>
    </message>
    <message>
        <source>Holes in each cavity</source>
        <translation>每个空腔的孔数</translation>
    </message>
    <message>
        <source>Make plugs for the holes</source>
        <translation>为孔生成塞子</translation>
    </message>
    <message>
        <source>Place automatically</source>
        <translation>自动放置</translation>
    </message>
    <message>
        <source>{count} places chosen by clicks.</source>
        <translation>已通过单击选择 {count} 处。</translation>
    </message>
    <message>
        <source>At the lowest points of each cavity. Click on the solid to choose the places yourself.</source>
        <translation>位于每个空腔的最低点。在实体上单击可自行选择位置。</translation>
    </message>
    <message>
        <source>A task is open</source>
        <translation>有任务尚未关闭</translation>
    </message>
    <message>
        <source>Close the open task panel first.</source>
        <translation>请先关闭打开的任务面板。</translation>
    </message>
    <message>
        <source>Thicken cannot start</source>
        <translation>无法开始加厚</translation>
    </message>
    <message>
        <source>No surface is chosen. Set Source in the property editor.</source>
        <translation>未选择曲面。请在属性编辑器中设置 Source。</translation>
    </message>
    <message>
        <source>Nothing was written</source>
        <translation>未写入任何内容</translation>
    </message>
    <message>
        <source>Export for Printing</source>
        <translation>导出用于打印</translation>
    </message>
    <message>
        <source>“{label}” was written to {path}, read again and proved valid: {triangles} triangles, {volume} mL.</source>
        <translation>“{label}”已写入 {path}，重新读取并证明有效：{triangles} 个三角形，{volume} mL。</translation>
    </message>
    <message>
        <source>The longer a bar, the more of the area has this value (square roots)</source>
        <extracomment>the label that tells why there is none</extracomment>
        <translation>条越长，具有该值的面积越大（平方根）</translation>
    </message>
    <message>
        <source>Thickness Map</source>
        <extracomment>the ThicknessMap that is shown</extracomment>
        <translation>厚度图</translation>
    </message>
    <message>
        <source>Wall thickness (mm)</source>
        <translation>壁厚 (mm)</translation>
    </message>
    <message>
        <source>Deviation of the shell from the thickness (mm)</source>
        <translation>壳相对于厚度的偏差 (mm)</translation>
    </message>
    <message>
        <source>Go to the least</source>
        <translation>转到最小值</translation>
    </message>
    <message>
        <source>Go to the largest</source>
        <translation>转到最大值</translation>
    </message>
    <message>
        <source>Measuring …</source>
        <translation>正在测量…</translation>
    </message>
    <message>
        <source>Least {least}, mean {mean}, largest {largest} mm. 98 % of the area: {low} to {high} mm.</source>
        <translation>最小 {least}，平均 {mean}，最大 {largest} mm。98 % 的面积：{low} 至 {high} mm。</translation>
    </message>
    <message>
        <source>There is not enough memory. Simplify the mesh, or choose a coarser quality.</source>
        <translation>内存不足。请简化网格，或选择较粗的质量。</translation>
    </message>
    <message>
        <source>Thicken cannot compute</source>
        <translation>Thicken 无法计算</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>修复曲面</translation>
    </message>
    <message>
        <source>Repair Surface</source>
        <translation>修复曲面</translation>
    </message>
    <message>
        <source>There was nothing to mend.</source>
        <translation>没有需要修复的地方。</translation>
    </message>
    <message>
        <source>Printability Report</source>
        <extracomment>what the report and its page are made from</extracomment>
        <translation>可打印性报告</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>可打印的最薄壁</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>可以打印</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>尺寸</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高度</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>零件数</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体积</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>表面积</translation>
    </message>
    <message>
        <source>Thinnest wall</source>
        <translation>最薄壁</translation>
    </message>
    <message>
        <source>Overhang beyond {angle}°</source>
        <translation>超过 {angle}° 的悬垂</translation>
    </message>
    <message>
        <source>On the plate</source>
        <translation>位于打印平台上</translation>
    </message>
    <message>
        <source>Trapped</source>
        <translation>被困</translation>
    </message>
    <message>
        <source>Thicken</source>
        <extracomment>until then nothing is called</extracomment>
        <translation>加厚</translation>
    </message>
    <message>
        <source>Pick a region</source>
        <translation>选取区域</translation>
    </message>
    <message>
        <source>Thicken a part of the mesh: each click in the view adds a smooth patch, or takes it away</source>
        <translation>加厚网格的一部分：在视图中每次单击会添加或移除一个光滑片</translation>
    </message>
    <message>
        <source>A patch ends where the surface turns by more than this</source>
        <translation>曲面转折超过此角度处即为片的边界</translation>
    </message>
    <message>
        <source>All of it</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>How thick the solid is: a length with a unit, a sum, or an expression (ƒx)</source>
        <translation>实体的厚度：带单位的长度、算式或表达式 (ƒx)</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>厚度</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>翻转</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Part solid</source>
        <translation>Part 实体</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Cell width</source>
        <translation>单元宽度</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>分辨率</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>质量</translation>
    </message>
    <message>
        <source>Rounds of shape optimisation of the new surface</source>
        <translation>新曲面形状优化的轮数</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>The farthest that the triangles of a shape may be from it</source>
        <translation>形状的三角形与形状之间允许的最大距离</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>挠度</translation>
    </message>
    <message>
        <source>Repair a defective surface first</source>
        <translation>先修复有缺陷的曲面</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Click on the mesh; click “Pick a region” again to see the preview.</source>
        <translation>在网格上单击；再次单击“选取区域”可查看预览。</translation>
    </message>
    <message>
        <source>{count} triangles</source>
        <translation>{count} 个三角形</translation>
    </message>
    <message>
        <source>Edit thickening</source>
        <translation>编辑加厚</translation>
    </message>
    <message>
        <source>OK will take about {seconds} and {memory} of memory.</source>
        <translation>“确定”大约需要 {seconds} 和 {memory} 内存。</translation>
    </message>
    <message>
        <source>Too many triangles for a preview.</source>
        <translation>三角形过多，无法预览。</translation>
    </message>
    <message>
        <source>Preview: computing …</source>
        <translation>预览：正在计算…</translation>
    </message>
    <message>
        <source>Set a deflection above 0 mm.</source>
        <translation>请将挠度设为大于 0 mm。</translation>
    </message>
    <message>
        <source>Set a thickness above 0 mm.</source>
        <translation>请将厚度设为大于 0 mm。</translation>
    </message>
    <message>
        <source>Preview: {numbers}.</source>
        <translation>预览：{numbers}。</translation>
    </message>
    <message>
        <source>Computing …</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>正在停止…</translation>
    </message>
    <message>
        <source>Stopped. The document is as it was.</source>
        <translation>已停止。文档保持原样。</translation>
    </message>
    <message>
        <source>The document has no 3D view. Open one: View ▸ Create new view.</source>
        <extracomment>in the coordinates of the object</extracomment>
        <translation>文档没有三维视图。请打开一个：视图 ▸ 新建视图。</translation>
    </message>
    <message>
        <source>The mesh is no valid solid: {defect}.</source>
        <extracomment>m: whether the facet bounds a cavity</extracomment>
        <translation>该网格不是有效的实体：{defect}。</translation>
    </message>
    <message>
        <source>{area} mm² of the walls ({share}) are thinner than {least} mm, the thinnest {mm} mm at {place}.</source>
        <translation>壁面中有 {area} mm²（{share}）薄于 {least} mm，最薄处 {mm} mm，位于 {place}。</translation>
    </message>
    <message>
        <source>A closed cavity traps {volume} mL; its lowest point is at {place}. Add drain holes.</source>
        <translation>封闭空腔困住 {volume} mL；其最低点位于 {place}。请添加排液孔。</translation>
    </message>
    <message>
        <source>{volume} mL of resin stay {depth} mm deep below the holes of a cavity, at {place}. Add a hole lower down.</source>
        <translation>空腔的孔下方残留 {volume} mL 树脂，深 {depth} mm，位于 {place}。请在更低处添加孔。</translation>
    </message>
    <message>
        <source>Corners moved onto a corner nearby</source>
        <extracomment>Of the properties. migrations[n] turns an object of schema n into one of n + 1.</extracomment>
        <translation>移到邻近角点上的角点</translation>
    </message>
    <message>
        <source>Triangles with a corner that is no number, removed</source>
        <translation>已删除的角点不是数字的三角形</translation>
    </message>
    <message>
        <source>Triangles without area, removed</source>
        <translation>已删除的无面积三角形</translation>
    </message>
    <message>
        <source>Repeated triangles, removed</source>
        <translation>已删除的重复三角形</translation>
    </message>
    <message>
        <source>Triangles divided at a corner on one of their edges</source>
        <translation>在其边上的角点处分割的三角形</translation>
    </message>
    <message>
        <source>Triangles turned over</source>
        <translation>翻转的三角形</translation>
    </message>
    <message>
        <source>Triangles removed where more than two met at an edge</source>
        <translation>在多于两个三角形共边处删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed to cut a one-sided part open</source>
        <translation>为剪开单侧部分而删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed that met others</source>
        <translation>与其他三角形相交而删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed where parts touched in a point only</source>
        <translation>在仅以一点接触处删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed in a fold or gap with no room for a wall</source>
        <translation>在没有壁厚空间的褶皱或缝隙中删除的三角形</translation>
    </message>
    <message>
        <source>{what}: {count}, the first at {place}.</source>
        <translation>{what}：{count}，第一处位于 {place}。</translation>
    </message>
    <message>
        <source>Nothing stands against printing it.</source>
        <translation>没有妨碍打印的问题。</translation>
    </message>
    <message>
        <source>Printability of {object}</source>
        <translation>{object} 的可打印性</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>图片</translation>
    </message>
    <message>
        <source>{height} mm, along {direction}</source>
        <translation>{height} mm，沿 {direction}</translation>
    </message>
    <message>
        <source>Height while printing</source>
        <translation>打印高度</translation>
    </message>
    <message>
        <source>yes, proved with exact predicates</source>
        <translation>是，已用精确谓词证明</translation>
    </message>
    <message>
        <source>no</source>
        <translation>否</translation>
    </message>
    <message>
        <source>Valid solid</source>
        <translation>有效实体</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材料</translation>
    </message>
    <message>
        <source>Overhangs beyond {angle}°</source>
        <translation>超过 {angle}° 的悬垂</translation>
    </message>
    <message>
        <source>{area} mm², {share} of the surface</source>
        <translation>{area} mm²，占表面的 {share}</translation>
    </message>
    <message>
        <source>{mm} mm at {place}</source>
        <translation>{mm} mm，位于 {place}</translation>
    </message>
    <message>
        <source>Walls below {least} mm</source>
        <translation>薄于 {least} mm 的壁</translation>
    </message>
    <message>
        <source>{share} of the area</source>
        <translation>面积的 {share}</translation>
    </message>
    <message>
        <source>{volume} mL, lowest at {place}</source>
        <translation>{volume} mL，最低处位于 {place}</translation>
    </message>
    <message>
        <source>Closed cavity {number}</source>
        <translation>封闭空腔 {number}</translation>
    </message>
    <message>
        <source>Closed cavities</source>
        <translation>封闭空腔</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Stays below holes</source>
        <translation>孔下残留</translation>
    </message>
    <message>
        <source>From above.</source>
        <translation>从上方看。</translation>
    </message>
    <message>
        <source>From below. {colour} needs support.</source>
        <translation>从下方看。{colour} 需要支撑。</translation>
    </message>
    <message>
        <source>Cut through the middle. {colour} closed cavities.</source>
        <translation>从中间剖开。{colour} 封闭空腔。</translation>
    </message>
    <message>
        <source>Walls: {thin} below {least} mm, {thick} {most} mm and more, {plain} not measured.</source>
        <translation>壁厚：{thin} 薄于 {least} mm，{thick} {most} mm 及以上，{plain} 未测量。</translation>
    </message>
    <message>
        <source>No triangles</source>
        <translation>没有三角形</translation>
    </message>
    <message>
        <source>Coordinates that are no numbers</source>
        <translation>不是数字的坐标</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>无面积的三角形</translation>
    </message>
    <message>
        <source>Edges or points where the surface branches</source>
        <translation>曲面分叉的边或点</translation>
    </message>
    <message>
        <source>Neighbours that face opposite ways</source>
        <translation>朝向相反的相邻三角形</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>相交的三角形</translation>
    </message>
    <message>
        <source>at {place}</source>
        <translation>位于 {place}</translation>
    </message>
    <message>
        <source>One place chosen by a click.</source>
        <translation>已点击选择一个位置。</translation>
    </message>
    <message>
        <source>Stereolithography (*.stl)</source>
        <translation>立体光刻 (*.stl)</translation>
    </message>
    <message>
        <source>3D Manufacturing Format (*.3mf)</source>
        <translation>3D 制造格式 (*.3mf)</translation>
    </message>
    <message>
        <source>“{label}” is a link. Select the object that it links to, “{linked}”, or make a copy of that where the link is.</source>
        <translation>“{label}” 是一个链接。请选择它所链接的对象 “{linked}”，或在链接处为其创建副本。</translation>
    </message>
    <message>
        <source>A link is selected</source>
        <translation>选中了一个链接</translation>
    </message>
    <message>
        <source>{volume} mL, {triangles} triangles, thinnest wall {wall} mm</source>
        <translation>{volume} mL，{triangles} 个三角形，最薄壁 {wall} mm</translation>
    </message>
    <message>
        <source>Weld corners of rims automatically</source>
        <translation>自动焊接边缘角点</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>保存...</translation>
    </message>
    <message>
        <source>Page with pictures (*.html)</source>
        <translation>带图片的网页 (*.html)</translation>
    </message>
    <message>
        <source>Data (*.json)</source>
        <translation>数据 (*.json)</translation>
    </message>
    <message>
        <source>Written: {path}</source>
        <translation>已写入：{path}</translation>
    </message>
    <message>
        <source>Written: {path}, and the same facts as data in {data}</source>
        <translation>已写入：{path}，同样的数据在 {data} 中</translation>
    </message>
    <message>
        <source>To mend before printing</source>
        <translation>打印前需处理</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>已停止。</translation>
    </message>
    <message>
        <source>Part Solid</source>
        <translation>Part 实体</translation>
    </message>
    <message>
        <source>Working</source>
        <translation>处理中</translation>
    </message>
    <message>
        <source>Checking the surface</source>
        <translation>检查曲面</translation>
    </message>
    <message>
        <source>Building the shell</source>
        <translation>生成壳</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>测量距离</translation>
    </message>
    <message>
        <source>Rebuilding parts of the shell</source>
        <translation>重建部分壳</translation>
    </message>
    <message>
        <source>Smoothing the shell</source>
        <translation>平滑壳</translation>
    </message>
    <message>
        <source>Joining the parts</source>
        <translation>连接各部分</translation>
    </message>
    <message>
        <source>Proving the solid</source>
        <translation>验证实体</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>测量</translation>
    </message>
    <message>
        <source>A Part solid is an object of its own: use the command “Part Solid”</source>
        <translation>Part 实体是单独的对象：请使用命令“Part 实体”</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>草稿</translation>
    </message>
    <message>
        <source>Standard</source>
        <translation>标准</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>精细</translation>
    </message>
    <message>
        <source>Within a tolerance</source>
        <translation>按公差</translation>
    </message>
    <message>
        <source>The farthest that the new shell may be from where it should be; what cannot be kept is refused</source>
        <translation>新壳偏离应有位置的最大距离；无法满足时将被拒绝</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>高级</translation>
    </message>
    <message>
        <source>Moved copy only</source>
        <translation>仅偏移副本</translation>
    </message>
    <message>
        <source>Rebuilt everywhere</source>
        <translation>全部重建</translation>
    </message>
    <message>
        <source>The shell is a moved copy of the surface, and rebuilt where that does not fit; or only one of the two</source>
        <translation>壳是曲面的偏移副本，在不合适处重建；或只用其中一种</translation>
    </message>
    <message>
        <source>By the quality</source>
        <translation>由质量决定</translation>
    </message>
    <message>
        <source>The grid in which parts of the shell are rebuilt</source>
        <translation>重建部分壳所用的网格</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>网格划分</translation>
    </message>
    <message>
        <source>Below half of the thickness: in larger cells both sides of the wall could meet</source>
        <translation>小于厚度的一半：在更大的单元中壁的两侧可能相遇</translation>
    </message>
    <message>
        <source>Cells along the longest side</source>
        <translation>沿最长边的单元数</translation>
    </message>
    <message>
        <source>“{label}” is {length} mm long. Is it in {unit}? Then scale it first: lengths here are mm.</source>
        <translation>“{label}” 长 {length} mm。它的单位是 {unit} 吗？如是请先缩放：此处长度单位为 mm。</translation>
    </message>
    <message>
        <source>“Check Surface” marks the places; “Repair a defective surface first” above mends them.</source>
        <translation>“检查曲面”会标出位置；上方的“先修复有缺陷的曲面”可修复它们。</translation>
    </message>
    <message>
        <source>Cavities that stay closed: {count}, of {volumes} mL.</source>
        <extracomment>what is known of the solid</extracomment>
        <translation>仍然封闭的空腔：{count} 个，{volumes} mL。</translation>
    </message>
    <message>
        <source>The solid has no cavity, so that nothing is trapped in it. Give places to drill it all the same.</source>
        <extracomment>threads and context of the library&apos;s functions</extracomment>
        <translation>该实体没有空腔，因此没有残留。若仍要钻孔，请指定位置。</translation>
    </message>
    <message>
        <source>A cavity of {volume} mL got {some} of {all} holes.</source>
        <translation>一个 {volume} mL 的空腔得到 {all} 个孔中的 {some} 个。</translation>
    </message>
    <message>
        <source>no hole could be drilled lower down</source>
        <translation>更低处无法钻孔</translation>
    </message>
    <message>
        <source>place a hole lower down</source>
        <translation>请在更低处放置孔</translation>
    </message>
    <message>
        <source>{depth} mm of resin, about {volume} mL, stay below the lowest hole of a cavity of {all} mL: {advice}.</source>
        <translation>在 {all} mL 空腔的最低孔下方残留深 {depth} mm、约 {volume} mL 的树脂：{advice}。</translation>
    </message>
    <message>
        <source>There is no room for a hole: choose a smaller diameter or fewer holes.</source>
        <translation>没有放置孔的空间：请选择更小的直径或更少的孔。</translation>
    </message>
    <message>
        <source>{triangles} triangles take about {needed} MiB, and the preferences allow {limit} MiB. Allow more there, or simplify the mesh.</source>
        <translation>{triangles} 个三角形约需 {needed} MiB，而首选项允许 {limit} MiB。请提高限额或简化网格。</translation>
    </message>
    <message>
        <source>in the document the first place is at {place}</source>
        <translation>在文档中第一处位于 {place}</translation>
    </message>
    <message>
        <source>No surface is chosen. Set Source to a mesh object or to a shape with faces.</source>
        <translation>未选择曲面。请将 Source 设为网格对象或带面的形状。</translation>
    </message>
    <message>
        <source>“{label}” is a link. Choose the object that it links to, “{linked}”, or a copy of that.</source>
        <translation>“{label}” 是一个链接。请选择它所链接的对象 “{linked}” 或其副本。</translation>
    </message>
    <message>
        <source>“{label}” is neither a mesh nor a shape with faces. Choose one that is.</source>
        <translation>“{label}” 既不是网格也不是带面的形状。请选择其中之一。</translation>
    </message>
    <message>
        <source>“{label}” has no triangles: there is nothing to thicken. Choose another mesh.</source>
        <translation>“{label}” 没有三角形：没有可加厚的内容。请选择另一个网格。</translation>
    </message>
    <message>
        <source>A Part solid of {faces} faces takes about {seconds} s to make, and a check or a cut of it {later} s. A mesh is enough for printing; choose a coarser quality, or merge coplanar facets, if a solid is needed.</source>
        <extracomment>a result: the path of its value in the report (docs/report.md)</extracomment>
        <translation>生成 {faces} 个面的 Part 实体约需 {seconds} s，对其检查或剪切约需 {later} s。打印只需网格；若需要实体，请选择更粗的质量或合并共面三角形。</translation>
    </message>
    <message>
        <source>OK makes this solid at once.</source>
        <translation>点击“确定”即可得到此实体。</translation>
    </message>
    <message>
        <source>“{label}”</source>
        <translation>“{label}”</translation>
    </message>
    <message>
        <source>“{label}” is a link that scales. Make a copy of “{linked}” in that size instead.</source>
        <translation>“{label}” 是带缩放的链接。请改为创建该尺寸的 “{linked}” 副本。</translation>
    </message>
    <message>
        <source>Triangles removed of a sheet that lay on a larger one</source>
        <translation>从位于较大片上的片中删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed of small parts that came off</source>
        <translation>从脱落的小部分中删除的三角形</translation>
    </message>
    <message>
        <source>Triangles removed to give a border straight runs</source>
        <translation>为使边界平直而删除的三角形</translation>
    </message>
    <message>
        <source>Triangles added in strips across gaps</source>
        <translation>在跨越间隙的条带中添加的三角形</translation>
    </message>
    <message>
        <source>Triangles added in holes</source>
        <translation>在孔中添加的三角形</translation>
    </message>
    <message>
        <source>Corners near another rim that could not be joined</source>
        <translation>靠近另一边缘但无法连接的角点</translation>
    </message>
    <message>
        <source>Holes that no patch fits into</source>
        <translation>无法放入补片的孔</translation>
    </message>
    <message>
        <source>removed</source>
        <translation>已删除</translation>
    </message>
    <message>
        <source>added</source>
        <translation>已添加</translation>
    </message>
    <message>
        <source>joined</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>left</source>
        <translation>保留</translation>
    </message>
    <message>
        <source>The farthest that rims may be apart to be joined</source>
        <translation>边缘可被连接的最大间距</translation>
    </message>
    <message>
        <source>The widest gap between rims to be closed by a strip of triangles; 0: none</source>
        <translation>用三角形条带闭合的边缘之间的最大间隙；0：无</translation>
    </message>
    <message>
        <source>Rims that are shorter than this are closed by a patch; 0: none</source>
        <translation>短于此长度的边缘用补片闭合；0：无</translation>
    </message>
    <message>
        <source>Join rims within</source>
        <translation>连接边缘，距离不超过</translation>
    </message>
    <message>
        <source>Bridge gaps up to</source>
        <translation>桥接间隙，不超过</translation>
    </message>
    <message>
        <source>Fill holes with a rim below</source>
        <translation>填充边缘短于此值的孔</translation>
    </message>
    <message>
        <source>Thicken cannot compute yet: its compiled part for {system} and Python {python} is missing ({file}). Install the add-on archive for this system, or put the file into the folder.</source>
        <translation>Thicken 尚无法计算：缺少适用于 {system} 和 Python {python} 的编译部分（{file}）。请安装适用于此系统的插件包，或将该文件放入文件夹。</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>打开文件夹</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>详细信息</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>关闭</translation>
    </message>
    <message>
        <source>Intersection</source>
        <translation>相交</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>圆弧</translation>
    </message>
    <message>
        <source>Outside of convex edges: sharp, as planes that meet, or rounded, which takes many more triangles</source>
        <translation>凸边外侧：尖锐（平面相交），或倒圆（需要多得多的三角形）</translation>
    </message>
    <message>
        <source>Join</source>
        <translation>连接</translation>
    </message>
    <message>
        <source>Trim Surface</source>
        <translation>修剪曲面</translation>
    </message>
    <message>
        <source>Where new triangles are merged into fewer, as far as the quality allows</source>
        <translation>在质量允许的范围内，在何处将新三角形合并为更少的三角形</translation>
    </message>
    <message>
        <source>Fewer triangles</source>
        <translation>减少三角形</translation>
    </message>
    <message>
        <source>How closely parts of the shell that have to be rebuilt follow the thickness; a moved copy of the surface is the same in all</source>
        <translation>需要重建的壳部分与厚度的吻合程度；曲面的偏移副本在各档中都相同</translation>
    </message>
    <message>
        <source>Negative (behind)</source>
        <translation>负侧（背后）</translation>
    </message>
    <message>
        <source>Positive (in front)</source>
        <translation>正侧（前方）</translation>
    </message>
    <message>
        <source>Both sides</source>
        <translation>两侧</translation>
    </message>
    <message>
        <source>Where the material lies; normals point to the front. A click on the arrow in the view flips it</source>
        <translation>材料所在的一侧；法线指向前方。单击视图中的箭头可翻转</translation>
    </message>
    <message>
        <source>Shell and walls</source>
        <translation>壳和壁</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
    <message>
        <source>Shell only</source>
        <translation>仅壳</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>间隙</translation>
    </message>
    <message>
        <source>A loop has three points at least. Click on the surface.</source>
        <translation>一条环线至少有三个点。请点击曲面。</translation>
    </message>
    <message>
        <source>The loop is closed</source>
        <translation>环线已闭合</translation>
    </message>
    <message>
        <source>Remove the point</source>
        <translation>删除该点</translation>
    </message>
    <message>
        <source>Keep the part inside</source>
        <translation>保留内侧部分</translation>
    </message>
    <message>
        <source>Rounds of smoothing</source>
        <translation>平滑次数</translation>
    </message>
    <message>
        <source>Click on the surface to set points, and on the first one to close the loop. Points can be dragged; a new one comes after the one that is chosen.</source>
        <translation>点击曲面以设置点，点击第一个点以闭合环线。点可以拖动；新点位于所选点之后。</translation>
    </message>
    <message>
        <source>The part inside of the loop stays. Click on the surface to keep that part.</source>
        <translation>环线内侧的部分保留。点击曲面可改为保留该处的部分。</translation>
    </message>
    <message>
        <source>The part that was clicked on stays.</source>
        <translation>保留被点击的部分。</translation>
    </message>
    <message>
        <source>The solid begins so far from the surface, and not at it; where there is no room it has a hole</source>
        <translation>实体从距曲面这么远处开始，而不是从曲面开始；空间不足处留有孔</translation>
    </message>
    <message>
        <source>Only {share} of thickness region {number} ({thickness} mm) is on the surface, which has changed.</source>
        <extracomment>of the area that was painted</extracomment>
        <translation>厚度区域 {number}（{thickness} mm）只有 {share} 在曲面上，曲面已更改。</translation>
    </message>
    <message>
        <source>Thickness Regions</source>
        <extracomment>the thickness at each vertex, once it is there</extracomment>
        <translation>厚度区域</translation>
    </message>
    <message>
        <source>“{label}”: {thickness} mm elsewhere</source>
        <translation>“{label}”：其余处 {thickness} mm</translation>
    </message>
    <message>
        <source>New region</source>
        <translation>新建区域</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>画笔半径</translation>
    </message>
    <message>
        <source>Transition</source>
        <translation>过渡宽度</translation>
    </message>
    <message>
        <source>The thickness changes linearly over this distance along the surface around the regions</source>
        <translation>厚度在区域周围沿曲面的这段距离内线性变化</translation>
    </message>
    <message>
        <source>{number}: {thickness} mm on {area} mm²</source>
        <translation>{number}：{thickness} mm，面积 {area} mm²</translation>
    </message>
    <message>
        <source>Drag over the surface to paint the region; with Shift to take away from it.</source>
        <translation>在曲面上拖动以涂绘区域；按住 Shift 拖动则从区域中去除。</translation>
    </message>
    <message>
        <source>Paint the region again, or remove it.</source>
        <extracomment>mm</extracomment>
        <translation>请重新涂绘该区域，或将其移除。</translation>
    </message>
    <message>
        <source>Rim thickness</source>
        <translation>边缘厚度</translation>
    </message>
    <message>
        <source>Rim width</source>
        <translation>边缘宽度</translation>
    </message>
    <message>
        <source>Rim radius</source>
        <translation>边缘圆角半径</translation>
    </message>
    <message>
        <source>How thick the solid is at the rim of the surface; 0: as elsewhere</source>
        <translation>实体在曲面边缘处的厚度；0：与其他处相同</translation>
    </message>
    <message>
        <source>How far from the rim the solid is as thick as elsewhere; together with the rim thickness</source>
        <translation>距边缘多远处实体达到其他处的厚度；与边缘厚度一起使用</translation>
    </message>
    <message>
        <source>The radius of the edge between shell and wall; 0: sharp. It is as fine as the triangles at the rim</source>
        <translation>壳与壁之间棱边的半径；0：尖锐。其精细程度取决于边缘处的三角形</translation>
    </message>
    <message>
        <source>The surface has changed since the panel was opened. Open it again.</source>
        <translation>打开面板后曲面已更改。请重新打开面板。</translation>
    </message>
</context>
<context>
    <name>ThickenPreferences</name>
    <message>
        <source>Thicken</source>
        <translation>加厚</translation>
    </message>
    <message>
        <source>New thickenings</source>
        <translation>新的加厚</translation>
    </message>
    <message>
        <source>Thickness, share of the diagonal</source>
        <translation>厚度占对角线的比例</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>Negative: behind the surface</source>
        <translation>负侧：曲面背后</translation>
    </message>
    <message>
        <source>Positive: where the normals point</source>
        <translation>正侧：法线所指一侧</translation>
    </message>
    <message>
        <source>Both: the surface is the middle</source>
        <translation>两侧：曲面居中</translation>
    </message>
    <message>
        <source>Output</source>
        <translation>输出</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>网格</translation>
    </message>
    <message>
        <source>Part solid</source>
        <translation>Part 实体</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>While the inputs are edited</source>
        <translation>编辑输入时显示</translation>
    </message>
    <message>
        <source>Largest surface to preview</source>
        <translation>可预览的最大曲面</translation>
    </message>
    <message>
        <source>Printing</source>
        <translation>打印</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>可打印的最薄壁</translation>
    </message>
    <message>
        <source>Diameter of drain holes</source>
        <translation>排液孔直径</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>颜色</translation>
    </message>
    <message>
        <source>Original surface</source>
        <translation>原始曲面</translation>
    </message>
    <message>
        <source>Shell</source>
        <translation>壳</translation>
    </message>
    <message>
        <source>Wall</source>
        <translation>壁</translation>
    </message>
    <message>
        <source>Defects</source>
        <translation>缺陷</translation>
    </message>
    <message>
        <source>This machine</source>
        <translation>本机</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>线程数</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Memory limit in MiB</source>
        <translation>内存上限 (MiB)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>无</translation>
    </message>
</context>
<context>
    <name>Thicken_Check</name>
    <message>
        <source>Check Surface</source>
        <translation>检查曲面</translation>
    </message>
    <message>
        <source>Find and mark everything that keeps a surface from being thickened</source>
        <translation>查找并标记一切妨碍曲面加厚的问题</translation>
    </message>
    <message>
        <source>Select a mesh or a shape. All defects are listed and marked in the view; a click on one goes there.</source>
        <translation>选择一个网格或形状。所有缺陷都会列出并在视图中标记；单击其中一处即可转到该处。</translation>
    </message>
</context>
<context>
    <name>Thicken_Drain</name>
    <message>
        <source>Let resin out of the cavities of a solid</source>
        <translation>让树脂从实体的空腔中流出</translation>
    </message>
    <message>
        <source>Select a solid. Holes are placed at the lowest points of each cavity for a print direction, or where you click.</source>
        <translation>选择一个实体。孔会放在每个空腔相对于打印方向的最低点，或放在单击处。</translation>
    </message>
    <message>
        <source>Drain Holes...</source>
        <translation>排液孔...</translation>
    </message>
</context>
<context>
    <name>Thicken_Export</name>
    <message>
        <source>Write a solid as STL or 3MF, read it again and judge it</source>
        <translation>将实体写为 STL 或 3MF，重新读取并判定</translation>
    </message>
    <message>
        <source>Select a solid. The file is written whole or not at all, in millimetres, and what is in it is proved valid.</source>
        <translation>选择一个实体。文件要么完整写入，要么完全不写，单位为毫米，其内容经过有效性证明。</translation>
    </message>
    <message>
        <source>Export for Printing...</source>
        <translation>导出打印...</translation>
    </message>
</context>
<context>
    <name>Thicken_Make</name>
    <message>
        <source>Turn the selected open surfaces into printable solids</source>
        <translation>将所选的开放曲面变为可打印的实体</translation>
    </message>
    <message>
        <source>Select meshes, shapes or faces. A panel asks for the thickness and the side and previews the solid, which keeps every triangle of the surface and follows it afterwards.</source>
        <translation>选择网格、形状或面。面板会询问厚度和侧，并预览实体；该实体保留曲面的每个三角形，并随之更新。</translation>
    </message>
    <message>
        <source>Thicken...</source>
        <extracomment>the module here and its class</extracomment>
        <translation>加厚...</translation>
    </message>
</context>
<context>
    <name>Thicken_Map</name>
    <message>
        <source>Thickness Map</source>
        <translation>厚度图</translation>
    </message>
    <message>
        <source>Colour a solid by the thickness of its wall or by its deviation</source>
        <translation>按壁厚或偏差为实体着色</translation>
    </message>
    <message>
        <source>Select a thickened or drained solid. A panel shows the scale, the least and the largest value and a histogram.</source>
        <translation>选择一个加厚或已开孔的实体。面板会显示色标、最小值、最大值和直方图。</translation>
    </message>
</context>
<context>
    <name>Thicken_Regions</name>
    <message>
        <source>Thickness Regions...</source>
        <translation>厚度区域...</translation>
    </message>
    <message>
        <source>Paint where a thickened solid is thicker or thinner</source>
        <translation>涂绘加厚实体更厚或更薄的位置</translation>
    </message>
    <message>
        <source>Select a thickened solid. A brush paints regions on its surface that have a thickness of their own; around them it changes gradually.</source>
        <translation>选择一个加厚实体。画笔在其曲面上涂绘具有各自厚度的区域；区域周围的厚度逐渐变化。</translation>
    </message>
</context>
<context>
    <name>Thicken_Repair</name>
    <message>
        <source>Repair Surface</source>
        <translation>修复曲面</translation>
    </message>
    <message>
        <source>Make a mended copy of the selected surfaces, and list every change</source>
        <translation>生成所选曲面的修复副本，并列出每处更改</translation>
    </message>
    <message>
        <source>Select a mesh or a shape. The new object follows it without its defects; its properties list what was changed.</source>
        <translation>选择一个网格或形状。新对象随之更新但没有其缺陷；其属性列出所做的更改。</translation>
    </message>
</context>
<context>
    <name>Thicken_Report</name>
    <message>
        <source>Volume, thinnest wall, trapped resin and overhangs of a solid</source>
        <translation>实体的体积、最薄壁、被困树脂和悬垂</translation>
    </message>
    <message>
        <source>Select a solid. The facts are shown, and can be saved as a page with pictures or as JSON.</source>
        <translation>选择一个实体。会显示各项数据，并可保存为带图片的页面或 JSON。</translation>
    </message>
    <message>
        <source>Printability Report...</source>
        <translation>可打印性报告...</translation>
    </message>
</context>
<context>
    <name>Thicken_Solid</name>
    <message>
        <source>Part Solid</source>
        <translation>Part 实体</translation>
    </message>
    <message>
        <source>Make a solid of Part from a closed mesh; it follows the mesh</source>
        <translation>由封闭网格生成 Part 实体；它随网格更新</translation>
    </message>
    <message>
        <source>Select thickened or drained solids, or other closed meshes. Each gets a solid with a planar face for each triangle.</source>
        <translation>选择加厚或打孔的实体，或其他封闭网格。每个都会得到一个每三角形一个平面的实体。</translation>
    </message>
</context>
<context>
    <name>Thicken_Stop</name>
    <message>
        <source>Stop Computing</source>
        <translation>停止计算</translation>
    </message>
    <message>
        <source>Stop whatever Thicken computes at the moment</source>
        <translation>停止 Thicken 当前的计算</translation>
    </message>
    <message>
        <source>A feature that was being recomputed is without a solid until the next recompute.</source>
        <translation>正在重新计算的对象在下次重新计算之前没有实体。</translation>
    </message>
</context>
<context>
    <name>Thicken_Trim</name>
    <message>
        <source>Trim Surface</source>
        <translation>修剪曲面</translation>
    </message>
    <message>
        <source>Cut a part out of a surface, along a loop that is clicked or closed wires</source>
        <translation>沿点击的环线或闭合线框从曲面中裁出一部分</translation>
    </message>
    <message>
        <source>Select a mesh or a shape, and click points of a loop on it. Or select sketches or wires near it, too. The new object follows them; its rim is where the loop is on the surface.</source>
        <translation>选择网格或形状，并在其上点击环线的点。或者同时选择其附近的草图或线框。新对象会随之更新；其边缘位于环线在曲面上的位置。</translation>
    </message>
</context>
</TS>
