% WRITEPAGE  Writes the report of a case: results/report.html, one file.
%
% CALL: FILE = writePage (PAGE)
%
%   PAGE  of pageData: a case that is finished, under way, or not begun
%   FILE  path of the page (text)
%
% The page needs no network and no other file. results/runTable.csv is written too,
% a row a run: model, folder, stage, status, cause, replicate, seed, seconds,
% started (s since 1970), the design variables, the effect variables, the
% targets (empty where the run has no such result), message.
%
% Each table is also results/tables/NAME.csv, each figure results/figures/*.svg.
%
% A part is a row of what section* returns: id, title, function handle
% HTML = f (PAGE), and where in PAGE
% (jsonAt) there must be something for it. One that cannot be drawn says so, and
% leaves the others alone.

function file = writePage (page)
  Case = page.Case;
  if isfield (page, 'best')
    file = costPage (Case, page.best);
    return
  end
  folder = fullfile (Case.folder, 'results');
  [~, ~] = mkdir (folder);
  writeRunTable (page);
  parameters = sectionParameters ();
  causes = sectionCauses ();
  list = [causes(2, :); parameters(1, :); causes(1, :); sectionTargets(); sectionParticles(); ...
          sectionWhere(); sectionCure(); ...
          sectionSurrogates(); parameters(2, :); sectionMethods(); sectionRuns()];
  [links, parts] = sectionsOf (page, list);
  [~, base, ending] = fileparts (Case.folder);
  name = ['Case ', base, ending];
  style = fullfile (fileparts (mfilename ('fullpath')), 'page.css');
  where = [strjoin({Case.models.name}, ', '), char([32, 194, 183, 32]), pageDate(page)];
  frame = struct ('window', [page.verdict.word, ': ', name], 'symbols', houseSymbols (), ...
                  'header', [measuredBy(Case.folder), verdictBox(page), facts(page)], ...
                  'nav', ['<nav aria-label="Contents"><ul>', links, "</ul></nav>\n"], ...
                  'foot', ['Page made on ', minuteOf(time ()), ...
                           ' from the files of the case folder.']);
  html = plainPage (Case.root, name, where, parts, frame);
  file = fullfile (folder, 'report.html');
  writeAtomic (file, html);
  writeExports (page.tables, html, fileread (style), folder);
end

function text = minuteOf (seconds)
  text = strftime ('%Y-%m-%d %H:%M', localtime (seconds));
end

function [links, parts] = sectionsOf (page, list)
  [links, parts] = deal ('');
  for section = list'
    [id, title, show, needed] = section{:};
    if iscell (title)                    % of a gap, of a change
      title = title{1 + page.isChange};
    end
    html = '';
    try
      if ~isempty (jsonAt (page, needed))
        html = show (page);
      end
    catch err
      html = ['<p class="off">This part could not be made: ', ...
              htmlText(err.message), '</p>'];
    end
    if ~isempty (html)
      links = [links, '<li><a href="#', id, '">', title, '</a></li>'];
      html = {['<h2 id="h-', id, '">', title, "</h2>\n"], html};
      if ~any (strcmp (id, {'sectionparameters', 'sectiontargets', 'sectionwhich', ...
                            'sectionchange'}))
        html = {'<details><summary>', html{1}, '</summary>', html{2}, ...
                '</details>'};
      end
      parts = [parts, '<section id="', id, '" aria-labelledby="h-', id, ...
               '">', html{:}, "</section>\n"];
    end
  end
end

% The first screen: first what has changed, of several conditions a line each. Nothing is
% decided here, see decideCase.
function html = verdictBox (page)
  v = page.verdict;
  items = {conditionTexts(page.sources.gap).line};
  isSaid = ~isempty (v.change) && numel (items) < 2;
  changed = uses ('What has changed since the reference', items(1:end * ~isSaid));
  gap = '';
  if ~isempty (v.gap) && numel (items) < 2
    gap = ['<p>', htmlText(v.gap), '</p>'];
  end
  action = eachOf (@actionHtml, v.actionParts);
  if isSaid
    changed = ['<p class="word">', htmlText(v.change), '</p>'];
  end
  if isSaid && ~isempty (gap)            % then by what, then the calibration
    changed = [changed, '<p><span class="word">', htmlText(v.cause.word), '</span>. ', ...
               htmlText(v.gap), '</p>'];
    gap = '';
  end
  html = ['<div class="verdict ', v.class, '">', changed, '<p><span class="word">', ...
          htmlText(v.word), '</span>. ', htmlText(v.sentence), '</p>', gap, ...
          uses('Use it for', v.usableFor), uses('Not for', v.notFor), ...
          '<h2>What to do now</h2><p>', action{:}, "</p></div>\n"];
end

function html = actionHtml (part)
  html = htmlText (part.text);
  if part.isCode
    html = ['<code>', html, '</code>'];
  end
end

% The numbers, and the pictures of the test that misses most: the grains under
% what was measured where the case has them.
function html = facts (page)
  numbers = page.verdict.numbers;
  html = '';
  if isempty (numbers)
    return
  end
  items = strcat ('<div><dt>', htmlText ({numbers.label}), '</dt><dd>', ...
                  htmlText ({numbers.text}), '</dd></div>');
  k = find (strcmp (page.verdict.worst, {page.Case.models.name}));
  grains = '';
  if ~isempty (k)
    grains = sectionParticles (page, k);
  end
  html = ['<div class="lead"><dl class="facts">', items{:}, "</dl>\n<div>", ...
          picture(page, 400 - 40 * ~isempty(grains)), '</div>'];
  if ~isempty (grains)
    html = [html, '<div>', grains, '</div>'];
  end
  html = [html, "</div>\n"];
end

function html = uses (title, texts)
  html = '';
  if isscalar (texts)
    html = ['<p><strong>', title, '</strong>: ', htmlText(texts{1}), '</p>'];
  elseif ~isempty (texts)
    items = strcat ('<li>', htmlText (texts), '</li>');
    html = ['<p><strong>', title, '</strong></p><ul>', items{:}, '</ul>'];
  end
end

% The bench that misses most.
function html = picture (page, width)
  html = '';
  [f, key] = benchFigure (page, page.verdict.worst);
  if ~isempty (f)
    lead = 'Most of the deviation: ';
    if ~isempty (jsonAt (page.verdict, {'cause', 'change'})) && isOfReference (page)
      lead = 'The reference, after the calibration: ';
    end
    f.title = [lead, f.title];
    f.size(1) = width;
    html = [htmlFigures(f, {}, 'one'), htmlKey(key)];
  end
end

% In tolerances stands what was calibrated, in its noise what has changed (benchFigure).
function yes = isOfReference (page)
  misses = page.verdict.misses;
  misses = misses(strcmp ({misses.model}, page.verdict.worst));
  yes = any ([misses.allowed] > 0);
end

function html = measuredBy (folder)
  html = '';
  [~, words] = measuredRemarks (folder);
  if ~isempty (words)
    html = ['<p class="where">Measured: ', strjoin(htmlText (words), ' &middot; '), "</p>\n"];
  end
end

% When the result is from.
function text = pageDate (page)
  s = page.sources;
  text = [char(jsonAt (s, {'calibration', 'date'})), ...
          char(jsonAt (s, {'progress', 'date'}))];
  if isempty (text) && isempty (s.gap)
    text = 'no result yet';
  elseif ~isempty (s.gap)
    if ~isempty (text)
      text = ['calibrated ', text, ', '];
    end
    file = fullfile (page.Case.folder, 'gap', 'gap.json');
    text = [text, 'diagnosed ', minuteOf(stat (file).mtime)];
  end
end

% The symbols of all figures (layerSvg), once a page.
function svg = houseSymbols ()
  svg = ['<svg width="0" height="0" class="symbols" aria-hidden="true"><defs>', ...
         '<circle id="p-ring" fill="none" stroke-width=".35" stroke="currentColor" r="1"/>', ...
         '<circle id="p-disc" fill="currentColor" r="1"/>', ...
         '<path id="p-triangle" fill="currentColor" d="M0-1.33-1.33.67 1.33.67z"/>', ...
         '<path id="p-diamond" fill="currentColor" d="M0-1.5 1.5 0 0 1.5-1.5 0z"/>', ...
         "</defs></svg>\n"];
end

% Figures for a paper: in the light colours of the page, which stand in its style.
% The disk is not waited for: decalioc report makes them again.
function writeExports (tables, html, style, folder)
  names = fieldnames (tables)';
  places = fullfile (folder, {'tables', 'figures'});
  [~, ~] = cellfun (@mkdir, places, 'UniformOutput', false);
  for name = names(~structfun (@(T) isempty (T) || isempty (T.cells), tables)')
    writeAtomic (fullfile (places{1}, [name{1}, '.csv']), tableCsv (tables.(name{1})), false);
  end
  symbols = regexp (houseSymbols (), '<defs>.*</defs>', 'match', 'once');
  colours = regexp (strtok (style, '@'), '--(\w+): (#\w+);', 'tokens');
  html = [strrep(html, '<header>', '<section id="sectionfirst">'), '<section id="'];
  parts = regexp (html, '<section id="section(\w+)"(.*?)(?=<section id=")', 'tokens');
  for k = 1:numel (parts)
    svgs = regexp (parts{k}{2}, '<svg viewBox="[^"]*" width[^>]* role="img".*?</svg>', 'match');
    for i = 1:numel (svgs)
      svg = strrep (svgs{i}, '<svg ', '<svg xmlns="http://www.w3.org/2000/svg" ');
      svg = regexprep (svg, '(<svg [^>]*>)', ['$1', symbols], 'once');
      for c = colours
        svg = strrep (svg, ['var(--', c{1}{1}, ')'], c{1}{2});
      end
      writeAtomic (fullfile (places{2}, sprintf ('%s-%d.svg', parts{k}{1}, i)), svg, false);
    end
  end
end

function writeRunTable (page)
  Case = page.Case;
  head = [{'model', 'folder', 'stage', 'status', 'cause', 'replicate', ...
           'seed', 'seconds', 'started'}, Case.names, Case.effectVars, ...
          {Case.targets.name}, {'message'}];
  lines = {csvLine(head)};
  for run = page.runs
    effects = NaN (1, numel (Case.effectVars));
    n = numel (run.effects);
    if n == numel (effects) || n == numel (plainCase (Case).effectVars)
      effects(1:n) = run.effects;
    end
    numbers = [run.replicate, run.seed, run.seconds, run.started, ...
               run.params, effects, resultsOf(run, Case)];
    lines{end + 1} = csvLine ([{run.model, run.name, run.stage, run.status, ...
                                run.cause}, num2cell(numbers), {oneLine(run.message)}]);
  end
  writeAtomic (fullfile (Case.folder, 'results', 'runTable.csv'), ...
               [strjoin(lines, "\n"), "\n"]);
end

function z = resultsOf (run, Case)
  z = NaN (1, numel (Case.targets));
  for t = find (strcmp ({Case.targets.modelName}, run.model))
    index = Case.targets(t).index;
    if strcmp (run.status, 'ok') && numel (run.results) >= index
      z(t) = run.results(index);
    end
  end
end

%!test
%! % before anything has been run; a text of the user that means something in
%! % HTML; commands are set as code
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'a <b> & c'}};
%! file = reportPage (newCase (raw));
%! html = fileread (file);
%! assert (! isempty (strfind (html, 'a &lt;b&gt; &amp; c')));
%! assert (isempty (strfind (html, '<b>')));
%! assert (! isempty (strfind (html, '<code>decalioc run</code>')));
%! assert (numel (strfind (html, ['content="default-src ''none''; ', ...
%!   'style-src ''unsafe-inline''; img-src data:"'])), 1);
%! assert (isempty (regexp (html, '<(script|link|img)', 'once')));
%! assert (isempty (strfind (html, 'could not be made')));
%!test
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum (N)', 'product'}};
%! Case = newCase (raw);
%! evaluateDEM ([1, 2; 3, 4], Case);
%! reportPage (Case);
%! [head, cells] = readCsvTable (fullfile (Case.folder, 'results', ...
%!                                         'runTable.csv'));
%! assert (rows (cells), 4);
%! first = find (strcmp (cells(:, 1), 'First'));
%! sums = str2double (cells(first, strcmp (head, 'sum (N)')));
%! assert (sort (sums), [3; 7], 1e-12);
%! second = find (strcmp (cells(:, 1), 'Second'));
%! assert (all (cellfun (@isempty, cells(second, strcmp (head, 'product')))));
%!test
%! % of a change: first what has changed, then by what, then the calibration
%! raw = standInCase (tempname ());
%! raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
%! s = verdictCase ()(strcmp ({verdictCase().name}, 'missed, several'));
%! one = struct ('name', {'wet', 'dry'}, 'verdict', s.gap.which.verdict, 'code', 'several', ...
%!               'kind', 'several', 'effects', {{'cohesion', 'drag'}}, ...
%!               'probability', [0.5, 0.4], 'text', {{'a', 'b'}}, 'change', 'Changed: x');
%! s.gap.reference = struct ('condition', 'wet', 'folder', 'gap', 'conditions', one(1), ...
%!   'targets', struct ('model', 'First', 'name', {'sum', 'product'}, 'reference', 7, ...
%!                      'measured', 6, 'sd', 0.25));
%! verdictCase (raw.folder, s);
%! html = fileread (reportPage (newCase (raw)));
%! at = @(text) strfind (html, text)(1);
%! assert (issorted ([at('class="word">'), at('sum 1 less (7 to 6)'), at('Too few numbers'), ...
%!                    at('Not calibrated</span>')]));
%! % several conditions: each once
%! s.gap.reference.conditions = one;
%! verdictCase (raw.folder, s);
%! html = regexp (fileread (reportPage (newCase (raw))), '<div class="verdict.*?</div>', ...
%!                'match', 'once');
%! assert (numel (strfind (html, 'wet: ')) <= 2, html);
%! assert (strfind (html, '<li>wet: ') < strfind (html, 'Not calibrated</span>'));

% SPDX-License-Identifier: GPL-3.0-only
