// <wend-lab map="rooms" planner="astar">: a search for articles; see panels/embed.ts.
import './panels/embed';
