% PAGEVERDICT  The report in one sentence, and what to do now.
%
% CALL: V = pageVerdict (PAGE)
%
%   PAGE  see pageData
%   V     struct: word (text), sentence, gap (HTML; '': no diagnosis), todo
%         (cell of HTML), facts (HTML), class ('good', 'bad', 'open')
%
% See also: writePage, gapAdvice

function v = pageVerdict (page)
  c = page.sources.calibration;
  gap = page.sources.gap;
  v = struct ('word', 'No result yet', 'sentence', ...
              'Nothing of this case has been run.', 'gap', '', ...
              'todo', {{}}, 'facts', factsOf (page), 'class', 'open');
  if ~isempty (c)
    v = judged (v, c, page);
  elseif ~isempty (page.runs) || ~isempty (page.plan)
    v.word = 'Not finished';
    v.sentence = ['The calibration is under way, or it was broken off: ', ...
                  'what is shown is what its files hold.'];
    v.todo = {['Started again, it goes on where it stopped: ', ...
               '<code>DEcalioc.m</code> in the case folder.']};
  elseif isempty (gap)
    v.todo = {'Start <code>DEcalioc.m</code> in the case folder.'};
  end
  if ~isempty (gap)
    [word, v.gap, advice, class] = gapAdvice (page);
    if isempty (c)
      v.word = word;
      v.sentence = v.gap;
      v.gap = '';
      v.class = class;
      v.todo = {};
    else
      v.gap = ['Diagnosis: <strong>', htmlText(word), '</strong>. ', v.gap];
    end
    v.todo = [advice, v.todo];
  end
end

function v = judged (v, c, page)
  v.word = 'Not calibrated';
  v.class = 'bad';
  if c.converged
    v.word = 'Calibrated';
    v.class = 'good';
  end
  v.sentence = [htmlText([upper(c.reason(1)), c.reason(2:end)]), '.'];
  loose = cellstr (jsonAt (c, {'notIdentified'}));
  if c.converged
    v.todo{end + 1} = ['Use the set: <code>results/calibrated.head</code> ', ...
                       'holds the lines for a <code>data.head</code>.'];
  else
    v.todo{end + 1} = ['Do not use this set as if it met the targets. ', ...
                       notMet(c, page)];
  end
  loose = loose(~cellfun (@isempty, loose));
  if ~isempty (loose)
    v.todo{end + 1} = [htmlText(strjoin (loose, ', ')), ': ', ...
                       'not fixed by these targets. Other values fit as ', ...
                       'well, so do not use the set where ', ...
                       pick(numel (loose) == 1, 'it matters', ...
                            'they matter'), '. ', bestNext(c)];
  end
  limits = cellstr (jsonAt (c, {'atLimit'}));
  limits = limits(~cellfun (@isempty, limits));
  if ~isempty (limits)
    v.todo{end + 1} = ['At a limit of the box: ', ...
                       htmlText(strjoin (limits, ', ')), '. Widen the ', ...
                       'limits if the material allows, or ask what the ', ...
                       'model lacks (<code>diagnoseGap.m</code>).'];
  end
end

function text = notMet (c, page)
  if c.runs == 0
    text = ['No DEM run confirms it: allow runs ', ...
            '(<code>Input.maxNewRuns</code>).'];
  elseif strncmp (c.reason, 'no set of the box', 17)
    text = ['Widen the limits of the parameters, or list what the model ', ...
            'may lack in <code>loadEffects.m</code> and start ', ...
            '<code>diagnoseGap.m</code>.'];
  elseif isempty (page.sources.gap)
    text = ['Allow more runs (<code>optim.maxFunEvals</code>), check the ', ...
            'tolerances against the scatter of a run below, or start ', ...
            '<code>diagnoseGap.m</code> to learn what the model lacks.'];
  else
    text = 'See what the diagnosis says.';
  end
end

function text = bestNext (c)
  text = '';
  next = jsonAt (c, {'next', 1});
  if isstruct (next)
    text = sprintf ('What would help most: %s, %s.', htmlText (next.kind), ...
                    htmlText (next.name));
  end
end

function text = pick (yes, a, b)
  text = b;
  if yes
    text = a;
  end
end

function html = factsOf (page)
  c = page.sources.calibration;
  items = {};
  if ~isempty (c)
    used = c.targets;
    if iscell (used)
      used = [used{:}];
    end
    isUsed = strcmp ({used.role}, 'calibrate');
    items{end + 1} = fact ('targets met', metCount (used, isUsed, page.Case));
    items{end + 1} = fact ('chance that all are met', ...
                           pageNumber (page, 'probability', 'calibration', ...
                                       'probability'));
    items{end + 1} = fact ('DEM runs at the set', ...
                           pageNumber (page, 'count', 'calibration', 'runs'));
    items{end + 1} = fact ('core-hours', ...
                           pageNumber (page, 'hours', 'calibration', ...
                                       'coreSeconds'));
  end
  if ~isempty (page.runs)
    ended = ~strcmp ({page.runs.status}, 'not ended');
    items{end + 1} = fact ('runs in the store', sprintf ('%d', sum (ended)));
    failed = sum (ended & ~strcmp ({page.runs.status}, 'ok'));
    items{end + 1} = fact ('of them failed', sprintf ('%d', failed));
  end
  html = '';
  if ~isempty (items)
    html = ['<dl class="facts">', items{:}, "</dl>\n"];
  end
end

% A curve is one target.
function text = metCount (used, isUsed, Case)
  text = '&ndash;';
  if isfield (used, 'tol')
    residual = NaN (1, numel (used));
    residual(isUsed) = [used(isUsed).residual];
    curves = struct ('own', {}, 'share', {});
    if numel (used) == numel (Case.targets)
      curves = curveSummary (Case, residual);
    end
    isUsed([curves.own]) = false;
    met = sum (abs (residual(isUsed)) <= [used(isUsed).tol]) + ...
          sum ([curves.share] <= 1);
    text = sprintf ('%d of %d', met, sum (isUsed) + numel (curves));
  end
end

function html = fact (name, value)
  html = ['<div><dt>', name, '</dt><dd>', value, '</dd></div>'];
end
