% The report page: what it shows, and how a browser takes it.

%!function list = numbersOf (html)
%!  list = regexp (html, ['<data value="([^"]*)" data-kind="([^"]*)" ', ...
%!                        'data-from="([^"]*)">(.*?)</data>'], 'tokens');
%!endfunction
%!function check (html, sources)
%!  % each number is that of the file, and what is read is that number
%!  for item = numbersOf (html)
%!    [value, kind, from, text] = item{1}{:};
%!    steps = strsplit (from, '/');
%!    isIndex = ~isnan (str2double (steps));
%!    steps(isIndex) = num2cell (str2double (steps(isIndex)));
%!    x = jsonAt (sources, steps)(1);
%!    assert (str2double (value), x);
%!    assert (strcmp (text, numberText (x, kind)), from);
%!    plain = regexprep (text, '&thinsp;.*', '');
%!    plain = strrep (strrep (plain, '&minus;', '-'), '&middot;10<sup>', 'e');
%!    shown = str2double (strrep (plain, '</sup>', ''));
%!    scale = 1 + 99 * strcmp (kind, 'percent');
%!    if any (strcmp (kind, {'plain', 'percent'}))
%!      assert (shown, scale * x, 5.01e-3 * abs (scale * x));
%!    end
%!  end
%!endfunction

%!shared first, second, pages
%! first = pageCase (tempname ());
%! second = pageGapCase (tempname ());
%! pages = {reportPage(first), reportPage(second)};

%!test
%! % whole, in one file, no request to a network, below 3 MB
%! for file = pages
%!   html = fileread (file{1});
%!   assert (isempty (regexp (html, 'https?:|@import|src=|url\(', 'once')));
%!   assert (isempty (strfind (html, 'could not be made')));
%!   assert (isempty (regexp (html, '(NaN|Inf)\W', 'once')));
%!   assert (numel (html) < 3e6);
%!   % each colour has its variable, for light and for dark, and each symbol
%!   % that a figure refers to is there
%!   for name = unique ([regexp(html, 'var\(--(\w+)\)', 'tokens'){:}])
%!     assert (numel (strfind (html, ['--', name{1}, ':'])), 2);
%!   end
%!   for name = unique ([regexp(html, 'href="#(p-\w+)"', 'tokens'){:}])
%!     assert (numel (strfind (html, ['id="', name{1}, '"'])), 1);
%!   end
%! end

%!test
%! % the numbers of a calibration
%! html = fileread (pages{1});
%! json = fullfile (first.folder, 'results', 'calibration.json');
%! c = jsondecode (fileread (json));
%! assert (numel (numbersOf (html)) > 30);
%! check (html, struct ('calibration', c));
%! assert (! isempty (strfind (html, c.reason(2:end))));
%! assert (! isempty (strfind (html, 'product &lt;b&gt; &amp; c')));
%! assert (! isempty (strfind (html, 'ERROR: &lt;grains&gt; lost')));
%! assert (! isempty (strfind (html, 'results/posterior.csv')));
%! for name = {'targets', 'parameters', 'plan', 'slices', 'leaveoneout', ...
%!             'sensitivity', 'methods', 'runs', 'settings'}
%!   assert (! isempty (strfind (html, ['id="section', name{1}, '"'])));
%! end

%!test
%! % the numbers of a diagnosis, and what to do
%! html = fileread (pages{2});
%! json = fullfile (second.folder, 'gap', 'gap.json');
%! sources = struct ('gap', jsondecode (fileread (json)));
%! assert (numel (numbersOf (html)) > 100);
%! check (html, sources);
%! for text = {'One of these causes: cohesion, liquid bridge', ...
%!             'measure Shear once more', 'cannot be seen by'}
%!   assert (! isempty (strfind (html, text{1})), text{1});
%! end

%!test
%! % a reason that begins with a character that means something in HTML
%! for k = 1:2
%!   file = {fullfile(first.folder, 'results', 'calibration.json'), ...
%!           fullfile(second.folder, 'gap', 'gap.json')}{k};
%!   old = fileread (file);
%!   writeAtomic (file, regexprep (old, '("reason":\s*")', '$1<i>&'));
%!   cases = {first, second};
%!   html = fileread (reportPage (cases{k}));
%!   writeAtomic (file, old);
%!   assert (~isempty (strfind (html, '&lt;i&gt;&amp;')));
%!   assert (isempty (strfind (html, '<i>')));
%! end

%!test
%! % files beside the page: each table as CSV, each figure as SVG with its colours
%! results = fullfile (first.folder, 'results');
%! [head, cells] = readCsvTable (fullfile (results, 'tables', 'targets.csv'));
%! assert (head{1}, 'result');
%! assert (rows (cells), 3);
%! svgs = glob (fullfile (results, 'figures', '*.svg'));
%! assert (numel (svgs) > 5);
%! for file = svgs'
%!   svg = fileread (file{1});
%!   assert (isempty (strfind (svg, 'var(--')), file{1});
%!   assert (! isempty (strfind (svg, 'xmlns="http://www.w3.org/2000/svg"')));
%! end
%! sample = dlmread (fullfile (results, 'posterior.csv'), ',', 1, 0);
%! assert (size (sample), [1000, 2]);
%! assert (all (all (sample >= 0 & sample <= 10)));
%! c = jsondecode (fileread (fullfile (results, 'calibration.json')));
%! head = headDefaults (fullfile (results, 'calibrated.head'));
%! step = 10^floor (log10 (min (diff (c.interval90.a) / 100, c.params.a / 1000)));
%! assert (head.a, c.params.a, 0.5 * step + 1e-12);
%! assert (numel (c.holdout), 1);
%! assert (numel (c.holdout.interval90), 2);
%! assert (c.limits.b', [0, 10]);
%! assert (numel (c.targets(1).interval90), 2);
%! assert (! isempty (c.date) && ! isempty (c.version));
%! assert (c.input.options.numOfSam, 8);

%!test
%! % under way: the old result is not shown as if it were today's
%! state = newState ([], [], struct ('params', [1, 2], 'probability', 0.5));
%! reportPage (first, @(text) [], state);
%! html = fileread (fullfile (first.folder, 'results', 'report.html'));
%! assert (! isempty (strfind (html, 'Not finished')));
%! assert (isempty (strfind (html, 'Calibrated</span>')));
%! unlink (fullfile (first.folder, 'results', 'progress.json'));
%! html = fileread (reportPage (first));
%! assert (isempty (strfind (html, 'Not finished')));

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'chromium'))
%! % in a browser: phone and desk, light and dark
%! for file = pages
%!   for width = [400, 1280]
%!     for isDark = [false, true]
%!       [found, log] = browserFindings (file{1}, width, isDark);
%!       assert (log, '');
%!       assert (strjoin (found.findings(:)', "\n"), '');
%!       grave = regexp (found.axe, '^(serious|critical) ', 'once');
%!       grave = found.axe(~cellfun (@isempty, grave));
%!       assert (strjoin (grave(:)', "\n"), '');
%!       assert (found.dark, isDark);
%!       assert (found.width, width);
%!       assert (found.figures > 3 * strcmp (file{1}, pages{1}));
%!     end
%!   end
%! end

%!testif ; ! isempty (file_in_path (getenv ('PATH'), 'chromium'))
%! % the browser test can fail: a page with faults of each kind
%! bad = [tempname(), '.html'];
%! html = fileread (pages{2});
%! html = strrep (html, '<h2 id="h-sectionwhich">', ...
%!                ['<p style="width:2000px;color:#ccc">x</p><h4>y</h4>', ...
%!                 '<button></button><h2>']);
%! writeAtomic (bad, strrep (html, '</body>', ...
%!                           '<script>nope ();</script></body>'));
%! [found, log] = browserFindings (bad, 400, false);
%! unlink (bad);
%! all = strjoin (found.findings(:)', "\n");
%! if ~isequal (found.axe, {'not installed'})
%!   rules = strjoin (found.axe(:)');
%!   assert (~isempty (strfind (rules, 'critical button-name')));
%! end
%! for rule = {'overflow', 'heading', 'contrast'}
%!   assert (! isempty (strfind (all, rule{1})), rule{1});
%! end
%! assert (! isempty (strfind (log, 'nope')));

%!test
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (first.folder, 's');
%! rmdir (second.folder, 's');

% SPDX-License-Identifier: GPL-3.0-only
