% WRITTENOUTSIDE  Places outside the run folder that a script writes to.
%
% CALL: PLACES = writtenOutside (TEXT, SCRIPT, ISSHELL, FOLDER, PLACE)
%
%   TEXT    of the script, its variables filled in (scriptWords);  SCRIPT  its path;
%           ISSHELL  logical: it is one of the shell
%   FOLDER  model folder, PLACE  run folder, see namedFiles (texts)
%   PLACES  1 x n cell of paths, as full ones: what redirections, tee, mkdir, touch,
%           the last word of cp, mv, ln, install and rsync, what dd, tar, sed -i and options
%           such as -o and --output, variables such as OUT that a command is given, folders
%           that a container has as its /out or /work, files that Python or Octave writes,
%           dumps, logs and restarts of an input script name; folders elsewhere that a shell
%           script changes to and writes in by relative names
%
% All runs share such a place, those that run at the same time, too. A name with a
% variable that is not known ($$, $(mktemp), the number of a job) may be one of
% each run, so it is none; of $SCRATCH and its like everybody knows.

function places = writtenOutside (text, script, isShell, folder, place)
  text = withScratch (text);
  [words, at] = opened (text);
  moves = struct ('to', {}, 'from', {}, 'until', {});
  if isInput (script)
    words = [words, ofInput(text)];
  else
    moves = movesOf (text, place);
  end
  if isShell && ~isInput (script)
    [found, where] = ofShell (text);
    [words, at] = deal ([words, found], [at, where]);
  end
  at(end + 1:numel (words)) = 0;
  words = regexprep (words, {'^["'']|["'']$', '^~(?=/)'}, {'', getenv('HOME')});
  words = throughLinks (words, text);
  bases = [{place}, besideScript(script, folder, place), foldersOf(text, place)];
  isOwn = @(p) isBelow (p, place) || isDevice (p);
  places = cell (1, 0);
  for k = find (cellfun (@isKnown, words))
    mine = bases;
    elsewhere = moves([moves.from] < at(k) & at(k) < [moves.until]);
    if ~isempty (elsewhere)
      mine = {elsewhere(end).to};
    end
    seen = cellfun (@(base) seenFrom (words{k}, base), mine, 'UniformOutput', false);
    places = [places, seen(1)(~any (cellfun (isOwn, seen)))];
  end
  places = unique (regexprep (places, '(?<=.)/$', ''))(:)';
end

% Of $SCRATCH and its like everybody knows, unless the script gives them a value.
function text = withScratch (text)
  for name = {'TMPDIR', 'TMP', 'TEMP', 'SCRATCH', 'SCRATCHDIR', 'WORKDIR', 'WORK'}
    if isempty (regexp (text, ['(?<![\w$])', name{1}, '=']))
      text = regexprep (text, ['\$\{?', name{1}, '(?!\w)\}?'], ['/', name{1}]);
    end
  end
end

function yes = isKnown (word)
  yes = ~isempty (word) && ~any (ismember ('$`(&', word)) && ...
        isempty (regexp (word, '^[\w.-]+:|^\d+$', 'once'));        % host:path, 2>&1
end

% LIGGGHTS may be started where a script of a subfolder lies.
function base = besideScript (script, folder, place)
  base = cell (1, 0);
  if isBelow (script, folder)
    base = {[place, fileparts(script)(numel (folder) + 1:end)]};
  end
end

function yes = isInput (script)
  [~, base, ending] = fileparts (script);
  yes = strncmp ([base, ending], 'in.', 3);
end

% What Python, Octave, gnuplot write: the name in open (..., 'w'), each full or upward
% path in the calls of those that write, of those that copy the last one.
function [words, at] = opened (text)
  quoted = '["'']([^"''\n]+)["'']';
  path = '["'']((?:/|~|\.\./)[^"''\n]*)["'']';
  writers = ['\<(?:savez?\w*|savetxt|savefig|imsave|imwrite|to_(?:csv|json|hdf|excel|' ...
             'pickle|parquet)|tofile|makedirs|mkdir|dlmwrite|csvwrite|writematrix|' ...
             'writetable|diary|print|write\.(?:csv2?|table)|writeLines|saveRDS)\s*\('];
  copiers = '\<(?:copy2?|copyfile|copytree|move|movefile|rename|replace)\s*\(';
  patterns = cell (1, 5);
  patterns{1} = ['open\s*\(\s*(?:file\s*=\s*)?', quoted, ...
                 '\s*,\s*(?:mode\s*=\s*)?["''][wax]'];
  patterns{2} = ['Path\s*\(\s*', quoted, '\s*\)\s*\.\s*' ...
                 '(?:write_|mkdir|touch|open\s*\(\s*["''][wax])'];
  patterns{3} = 'set\s+output\s+["'']([^"'']+)["'']';
  patterns{4} = [writers, '[^()\n]*?', path];
  patterns{5} = [copiers, '[^()\n]*', path, '\s*\)'];
  [words, at] = tokensOf (text, patterns);
end

% Words, and where in the text each begins, by all patterns.
function [words, at] = tokensOf (text, patterns)
  [words, at] = deal (cell (1, 0), zeros (1, 0));
  for pattern = patterns
    [found, where] = regexp (text, pattern{1}, 'tokens', 'start', 'lineanchors');
    words = [words, found{:}];
    at = [at, where];
  end
end

function [words, at] = ofShell (text)
  options = ['(?<=\s)(?:-o|-O|-d|-log|-l|-C|--(?:out|output|outfile|outdir|output-dir|' ...
             'log|directory|target-directory|prefix))(?:[ \t]+|=)'];
  patterns = cell (1, 7);
  given = '(?:\w+_)?(?i:out|res|log)\w*=["'']?(/[^\s"'';&|)]+)';
  patterns{5} = ['(?<=\s|^)', given, '["'']?(?=[ \t]+[^\s;&|#])'];
  patterns{6} = ['^[ \t]*export[ \t]+', given];
  patterns{7} = ['(?:-v|-B|--(?:volume|bind|mount))[ \t=]+["'']?(?:type=bind,)?' ...
                 '(?:source=|src=)?(/[^\s:,"'']+)(?::|,(?:target|destination|dst)=)' ...
                 '/(?:\w+/)*(?:out|res|log|work|run|scratch|tmp)\w*["'']?' ...
                 '(?=\s|:rw|:[zZ]|,rw|$)'];
  patterns{1} = ['(?<![0-9<=>-])[012&]?>{1,2}[|&]?[ \t]*' ...
                 '("[^"\n]+"|''[^''\n]+''|[^\s;&|)>}]+)'];
  patterns{2} = [options, '["'']?((?:/|~|\.\./)[^\s"'';&|)]+)'];
  patterns{3} = '(?<=\s)of=["'']?([^\s"'';&|)]+)';
  patterns{4} = '\<tee\s+(?:-\w+\s+)*["'']?([^\s"'';&|)}]+)';
  [words, at] = tokensOf (text, patterns);
  [parts, first] = regexp (text, '[^;&|()`{}\n]+', 'match', 'start');
  for k = 1:numel (parts)
    found = byCommand (parts{k});
    [words, at] = deal ([words, found], [at, repmat(first(k), 1, numel (found))]);
  end
end

% By the command that a part of a line begins with.
function words = byCommand (part)
  words = cell (1, 0);
  list = regexp (regexprep (part, '\d?>.*$', ''), '"[^"]*"|''[^'']*''|[^\s"'']+', 'match');
  list(ismember (list, {'then', 'do', 'else', 'if', '!', 'command', 'sudo', 'exec'})) = [];
  if isempty (list)
    return
  end
  rest = list(2:end);
  plain = rest(~strncmp (rest, '-', 1));
  are = @(pattern) ~cellfun (@isempty, regexp (rest, pattern, 'once'));
  switch list{1}
    case {'mkdir', 'touch'}
      words = plain;
    case {'cp', 'mv', 'ln', 'rsync', 'install'}
      target = find (strcmp (rest(1:end - 1), '-t'), 1) + 1;
      words = [rest(target), plain(max (end, 2):end)];
    case 'sed'
      if any (are ('^(-i|--in-place|-[nErsz]+i)'))
        words = plain(2:end);
      end
    case 'tar'
      words = rest([false, are('^-?\w*c\w*f$')(1:end - 1)]);
    case {'sqlite3', 'zip'}
      words = plain(1:min (end, 1));
  end
end

% Of an input script: lines that & continues are one, and its variables that hold a text
% are filled in; what it has a shell do, and folders that it changes to.
function words = ofInput (text)
  text = regexprep (text, '&[ \t]*\n', ' ');
  pairs = regexp (text, ['^[ \t]*variable[ \t]+(\w+)[ \t]+(string|index|world|getenv)' ...
                         '[ \t]+["'']?([^\s"'']+)'], 'tokens', 'lineanchors');
  for pair = fliplr ([cell(1, 0), pairs])
    [name, kind, value] = pair{1}{:};
    if strcmp (kind, 'getenv')
      value = withScratch (['$', value]);
    end
    text = regexprep (text, ['\$\{', name, '\}'], strrep (value, '$', '\$'));
  end
  lines = regexp (text, ['(?:^|then[ \t]+["''])[ \t]*(?:dump|restart|write_restart|write_data|' ...
                         'write_dump|log|print|fix[ \t]+\S+[ \t]+\S+[ \t]+' ...
                         '(?:print|ave/\w+|massflow/\w+))' ...
                         '[ \t]([^\n]*)'], 'tokens', 'lineanchors');
  lines = [cell(1, 0), lines{:}];
  words = regexp (strjoin (lines, ' '), '(?<=[\s"'']|^)(?:\.\./|/\w)[^\s"'']*', 'match');
  shells = regexp (text, '^[ \t]*shell[ \t]+["'']?([^\n]*)', 'tokens', 'lineanchors');
  shells = strjoin (regexprep ([cell(1, 0), shells{:}], '["''][ \t]*$', ''), "\n");
  words = [words, ofShell(shells), ...
           regexp(shells, '(?<=^cd[ \t])(?:\.\./|/\w)\S*', 'match', 'lineanchors')];
end

function folders = foldersOf (text, place)
  moves = regexp (text, '(?:^|[;&|(]|then|do)\s*(?:cd|pushd)\s+["'']?([^\s"'';&|)]+)', ...
                  'tokens', 'lineanchors');
  folders = cellfun (@(to) seenFrom (to, place), [cell(1, 0), moves{:}], ...
                     'UniformOutput', false);
end

% Changes to folders outside the run: where they begin, and where they end (the next
% change, or the end of the brackets in which they stand).
function moves = movesOf (text, place)
  moves = struct ('to', {}, 'from', {}, 'until', {});
  [to, from] = tokensOf (text, {['(?:^|[;&|(]|\<then\>|\<do\>)\s*(?:cd|pushd)\s+' ...
                                 '(?:--\s+)?["'']?([^\s"'';&|)]+)'], ...
                                'os\.chdir\s*\(\s*["'']([^"''\n]+)["'']'});
  [from, order] = sort (from);
  to = to(order);
  back = regexp (text, '(?:^|[;&|])\s*(?:popd|cd\s*(?:-|$|[;&|]))', 'lineanchors');
  back = [back, numel(text) + 1];
  for k = 1:numel (to)
    path = '';
    if isKnown (to{k})
      path = seenFrom (regexprep (to{k}, '^~(?=/)', getenv ('HOME')), place);
    end
    if ~isempty (path) && ~isBelow (path, place)
      ends = [from(k + 1:end), back(back > from(k)), bracketAfter(text, from(k))];
      moves(end + 1) = struct ('to', path, 'from', from(k), 'until', min (ends));
    end
  end
end

% Of a change in brackets: where these close.
function at = bracketAfter (text, from)
  at = [];
  depth = cumsum ((text == '(') - (text == ')'));
  before = depth(max (from - 1, 1));
  inside = max (before, depth(from));
  if inside > 0
    at = find (depth < inside & 1:numel (text) > from, 1);
  end
end

% post/out is in /data/x where post is a link to it.
function words = throughLinks (words, text)
  links = regexp (text, '\<ln\s+(?:-\w+\s+)+(\S+)[ \t]+([\w.-]+)[ \t]*(?:$|[;&|])', ...
                  'tokens', 'lineanchors');
  for link = [cell(1, 0), links]
    [to, name] = link{1}{:};
    words = regexprep (words, ['^(\./)?', regexptranslate('escape', name), '/'], ...
                       [strrep(to, '$', '\$'), '/']);
  end
end

function path = seenFrom (word, base)
  if word(1) ~= '/'
    word = [base, '/', word];
  end
  path = plainPath (word);
end

function yes = isBelow (path, folder)
  yes = strncmp ([path, '/'], [folder, '/'], numel (folder) + 1);
end

function yes = isDevice (path)
  yes = ~isempty (regexp (path, '^/(dev/(null|std|tty|fd|zero)|proc/)', 'once'));
end

%!function places = of (text, script)
%!  isShell = nargin < 2;
%!  if isShell
%!    script = '/c/DEMmodels/M/runscript';
%!  end
%!  places = writtenOutside (text, script, isShell, '/c/DEMmodels/M', ...
%!                           '/c/optim/M/0001');
%!endfunction
%!test
%! assert (of ("awk 1 data.head > /tmp/w/out.txt; cp /tmp/w/out.txt .\n"), ...
%!         {'/tmp/w/out.txt'});
%! for text = {"mkdir -p /tmp/w", "x=1; if mkdir /tmp/w; then", "echo 2>>'/tmp/w'", ...
%!             "a | tee -a /tmp/w", "cp -r post \"/tmp/w\"", "mv a b /tmp/w/ && b", ...
%!             "cd sub\ntouch ../../../../../tmp/w", ...
%!             "python3 -c \"f = open('/tmp/w', 'w')\"", "awk '{print > \"/tmp/w\"}' a"}
%!   assert (isequal (of (text{1}), {'/tmp/w'}), text{1});
%! end
%! for text = {"cd /tmp/w && python3 sim.py > res.txt", "(cd /tmp/w; ./sim > res.txt)", ...
%!             "cd \"/tmp/w\"\n./sim | tee res.txt", "ln -s /tmp/w post\n./sim > post/res.txt", ...
%!             "pushd /tmp/w\ntouch res.txt\npopd\necho 1 > out.txt"}
%!   assert (isequal (of (text{1}), {'/tmp/w/res.txt'}), text{1});
%! end
%! for text = {"dd if=a of=/tmp/w", "sed -i 's/a/b/' /tmp/w", "sed -i -e s/a/b/ /tmp/w", ...
%!             "install -m 644 a /tmp/w", "cp -t /tmp/w a", "a >& /tmp/w", "a >| /tmp/w", ...
%!             "a &> /tmp/w", "tar xf x.tgz -C /tmp/w", "unzip x -d /tmp/w", "code -o /tmp/w", ...
%!             "code --output=/tmp/w", "liggghts -in in.x -log /tmp/w", "sqlite3 /tmp/w 'a'", ...
%!             "python3 -c \"Path('/tmp/w').write_text('1')\"", ...
%!             "python3 -c \"np.savetxt('/tmp/w', a)\"", "b -e \"set output '/tmp/w'\"", ...
%!             "python3 -c \"d.to_csv('/tmp/w')\"", "octave --eval \"dlmwrite ('/tmp/w', 1)\"", ...
%!             "python3 -c \"shutil.copy('/a/b', '/tmp/w')\"", ...
%!             "octave --eval \"save ('-text', '/tmp/w', 'x')\""}
%!   assert (isequal (of (text{1}), {'/tmp/w'}), text{1});
%! end
%! for text = {"OUT=/tmp/w ./sim", "x=1 OUT_DIR=\"/tmp/w\" python3 sim.py\n", ...
%!             "export RESULTS=/tmp/w\n./sim", "env LOGFILE=/tmp/w ./sim", ...
%!             "docker run --rm -v /tmp/w:/out img sim", ...
%!             "podman run -v \"/tmp/w:/work:z\" img", ...
%!             "apptainer exec -B /tmp/w:/scratch a.sif", ...
%!             "docker run --mount type=bind,source=/tmp/w,target=/data/results img"}
%!   assert (isequal (of (text{1}), {'/tmp/w'}), text{1});
%! end
%! for text = {"DATA=/tmp/w ./sim", "docker run -v /tmp/w:/out:ro img", "OUT=out ./sim", ...
%!             "docker run -v /c/optim/M/0001:/work img", "docker run -v /data:/data img", ...
%!             "OUT=/tmp/w; diff $OUT out", "docker run -v /a:/opt/dem -w /work img"}
%!   assert (isempty (of (text{1})), text{1});
%! end
%! assert (of ("cd ..\n./run > out.txt"), {'/c/optim/M/out.txt'});
%! assert (of ("(cd /tmp/w; ./a)\necho 1 > out.txt"), cell (1, 0));
%! assert (of ("echo 1 > $SCRATCH/out"), {'/SCRATCH/out'});
%! assert (of ("echo 1 > ../last.txt"), {'/c/optim/M/last.txt'});
%!test
%! % of its own, of nobody, and of each run one
%! for text = {"a > log 2>&1", "a > /dev/null 2> /dev/stderr", "cp /data/x .", ...
%!             "awk '$1 > 3' /tmp/x", "a > /tmp/$$.txt", "cd post && a > ../out", ...
%!             "d=$(mktemp -d); a > $d/x", "a > /tmp/$SLURM_JOB_ID/x", "cp /a/x", ...
%!             "a > /c/optim/M/0001/x", "open ('/tmp/x', 'r')", "a -> /tmp/b", ...
%!             "set -o pipefail", "ssh -o a=b host", "scp out host:/data", "sed -n 1p /tmp/x", ...
%!             "tar xf /data/x.tgz", "cd /data && cat x", "cut -d / -f 2 x", "a 2>&1 | b", ...
%!             "cd /tmp/w; x=1; cd -; a > out", "grep -o abc x > y", "load ('/tmp/x')"}
%!   assert (isempty (of (text{1})), text{1});
%! end
%!test
%! text = ["dump d all custom 1 /tmp/d*.txt id\nlog \"/tmp/l\"\nprint \"1 > 2\" file ../p\n", ...
%!         "fix m all mesh file /data/a.stl\nfix p all print 10 \"${a}\" file /tmp/p\n", ...
%!         "write_restart end.restart\n"];
%! assert (of (text, '/c/DEMmodels/M/in.M'), {'/c/optim/M/p', '/tmp/d*.txt', '/tmp/l', '/tmp/p'});
%! for text = {"variable o string /tmp/w\ndump d all custom 100 ${o} id x", ...
%!             "fix a all ave/time 1 1 1 v_x &\n  file /tmp/w", "shell cp end.txt /tmp/w", ...
%!             "shell \"mkdir -p /tmp/w\"", "shell cd /tmp/w", ...
%!             "if \"${x} > 1\" then \"write_data /tmp/w\""}
%!   assert (isequal (of ([text{1}, "\n"], '/c/DEMmodels/M/in.M'), {'/tmp/w'}), text{1});
%! end
%! for text = {"read_data ../packing.data", "include /data/a.in", "log log.${runSeed}", ...
%!             "fix m all mesh/surface file /data/a.stl type 1", "shell cd post"}
%!   assert (isempty (of ([text{1}, "\n"], '/c/DEMmodels/M/in.M')), text{1});
%! end

% SPDX-License-Identifier: GPL-3.0-only
