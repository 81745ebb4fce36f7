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
        <source>at ({x}, {y}, {z})</source>
        <translation>位于 ({x}, {y}, {z})</translation>
    </message>
    <message>
        <source>The direction in which the part grows while it is printed</source>
        <translation>打印时零件生长的方向</translation>
    </message>
    <message>
        <source>Drain holes</source>
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
        <source>For printing (*.stl *.3mf)</source>
        <translation>用于打印 (*.stl *.3mf)</translation>
    </message>
    <message>
        <source>The longer a bar, the more of the area has this value (square roots)</source>
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
        <source>{volume} mL, thinnest wall {wall} mm</source>
        <translation>{volume} mL，最薄壁 {wall} mm</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <extracomment>degrees: what a patch ends at</extracomment>
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
        <extracomment>of the inputs that are shown; None while it is computed</extracomment>
        <translation>可打印性报告</translation>
    </message>
    <message>
        <source>Thinnest wall that prints</source>
        <translation>可打印的最薄壁</translation>
    </message>
    <message>
        <source>Save …</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Save the report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Page with pictures (*.html);;Data (*.json)</source>
        <translation>带图片的页面 (*.html);;数据 (*.json)</translation>
    </message>
    <message>
        <source>Ready to print</source>
        <translation>可以打印</translation>
    </message>
    <message>
        <source>Heed before printing</source>
        <translation>打印前请注意</translation>
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
        <source>Where the material lies; a click on the arrow in the view flips it</source>
        <translation>材料所在的一侧；单击视图中的箭头可翻转</translation>
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
        <source>Sweep</source>
        <translation>扫掠</translation>
    </message>
    <message>
        <source>Reconstruct</source>
        <translation>重建</translation>
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
        <source>Tolerance</source>
        <translation>公差</translation>
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
        <translation>文档没有三维视图。请打开一个：视图 ▸ 新建视图。</translation>
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
        <source>Drain Holes …</source>
        <translation>排液孔…</translation>
    </message>
    <message>
        <source>Let resin out of the cavities of a solid</source>
        <translation>让树脂从实体的空腔中流出</translation>
    </message>
    <message>
        <source>Select a solid. Holes are placed at the lowest points of each cavity for a print direction, or where you click.</source>
        <translation>选择一个实体。孔会放在每个空腔相对于打印方向的最低点，或放在单击处。</translation>
    </message>
</context>
<context>
    <name>Thicken_Export</name>
    <message>
        <source>Export for Printing …</source>
        <translation>导出用于打印…</translation>
    </message>
    <message>
        <source>Write a solid as STL or 3MF, read it again and judge it</source>
        <translation>将实体写为 STL 或 3MF，重新读取并判定</translation>
    </message>
    <message>
        <source>Select a solid. The file is written whole or not at all, in millimetres, and what is in it is proved valid.</source>
        <translation>选择一个实体。文件要么完整写入，要么完全不写，单位为毫米，其内容经过有效性证明。</translation>
    </message>
</context>
<context>
    <name>Thicken_Make</name>
    <message>
        <source>Thicken …</source>
        <extracomment>of a mesh: indices</extracomment>
        <translation>加厚…</translation>
    </message>
    <message>
        <source>Turn the selected open surfaces into printable solids</source>
        <translation>将所选的开放曲面变为可打印的实体</translation>
    </message>
    <message>
        <source>Select meshes, shapes or faces. A panel asks for the thickness and the side and previews the solid, which keeps every triangle of the surface and follows it afterwards.</source>
        <translation>选择网格、形状或面。面板会询问厚度和侧，并预览实体；该实体保留曲面的每个三角形，并随之更新。</translation>
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
        <source>Printability Report …</source>
        <translation>可打印性报告…</translation>
    </message>
    <message>
        <source>Volume, thinnest wall, trapped resin and overhangs of a solid</source>
        <translation>实体的体积、最薄壁、被困树脂和悬垂</translation>
    </message>
    <message>
        <source>Select a solid. The facts are shown, and can be saved as a page with pictures or as JSON.</source>
        <translation>选择一个实体。会显示各项数据，并可保存为带图片的页面或 JSON。</translation>
    </message>
</context>
</TS>
